#include "rheometry/fit/fit_options.hpp"

#include <array>

namespace searle::rheometry::fit {
namespace {

constexpr std::array<std::string_view, 5> weighting_names{"relative", "fitted", "absolute", "log",
                                                          "custom"};
constexpr std::array<std::string_view, 3> loss_names{"none", "huber", "cauchy"};

template <class Kind, std::size_t Count>
std::optional<Kind> named(const std::array<std::string_view, Count>& names, std::string_view name) {
    for (std::size_t i = 0; i < Count; ++i)
        if (names[i] == name)
            return static_cast<Kind>(i);
    return std::nullopt;
}

} // namespace

std::string_view name_of(Weighting weighting) {
    return weighting_names.at(static_cast<std::size_t>(weighting));
}
std::optional<Weighting> weighting_named(std::string_view name) {
    return named<Weighting>(weighting_names, name);
}
std::string_view name_of(Loss loss) { return loss_names.at(static_cast<std::size_t>(loss)); }
std::optional<Loss> loss_named(std::string_view name) { return named<Loss>(loss_names, name); }

} // namespace searle::rheometry::fit
