#pragma once

#include "casefile/keys.hpp"
#include "rheometry/conversion/conversion.hpp"

namespace searle::rheometry {

/// The section [conversion]. What an instrument does not allow is checked where it is known.
[[nodiscard]] casefile::Keys<ConversionSettings> conversion_keys();

} // namespace searle::rheometry
