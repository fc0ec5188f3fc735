#pragma once

#include "casefile/key.hpp"

#include <string>

namespace searle::casefile {

enum class WritingStyle {
    resolved, ///< every value in SI, in digits that read back to the same bits
    annotated ///< for people to start from: usual units where the value is the key's example, with
              ///< what each key means
};

/// The target's values as the text of a case file; `target` is the struct `keys` were declared for.
/// Absent optional values are left out, in the annotated style put behind '#' where they are
/// offered.
[[nodiscard]] std::string write_toml(const KeySet& keys, const void* target, WritingStyle style);

/// One value as it stands right of the '='.
[[nodiscard]] std::string value_as_toml(const Key& key, const Value& value);

/// The same in the unit that people use, where the value is the key's example; else as above.
[[nodiscard]] std::string usual_text(const Key& key, const Value& value);

/// A text in quotes, with what TOML wants escaped.
[[nodiscard]] std::string quoted(const std::string& text);

} // namespace searle::casefile
