#pragma once

#include "laws/contact/hertz.hpp"
#include "laws/contact/hooke.hpp"

#include <variant>

namespace searle::laws::contact {

/// The law of all contacts of a run.
using AnyContact = std::variant<Hooke, Hertz>;

[[nodiscard]] inline double friction_of(const AnyContact& contact) {
    return std::visit([](const auto& law) { return double{law.friction}; }, contact);
}

} // namespace searle::laws::contact
