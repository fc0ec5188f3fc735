#pragma once

#include "app/case_reader.hpp"

#include <gtest/gtest.h>
#include <string>
#include <string_view>
#include <vector>

namespace searle::app {

/// A case without faults; lines are counted by the tests: bob_radius stands on 3, to on 14.
inline constexpr std::string_view valid_case = R"([geometry]
type = "single-gap"
bob_radius = "14 mm"
cup_radius = "15 mm"
height = "42 mm"

[fluid]
model = "newtonian"
viscosity = "1.0016 mPa.s"
density = "998.2 kg/m^3"

[protocol]
type = "ramp"
to = "100 1/s"
duration = "35 s"
points = 100
)";

/// The case with its first `old_text` replaced.
inline std::string with(std::string_view old_text, std::string_view new_text,
                        std::string_view text = valid_case) {
    std::string result{text};
    const std::size_t at = result.find(old_text);
    EXPECT_NE(at, std::string::npos) << old_text;
    if (at != std::string::npos)
        result.replace(at, old_text.size(), new_text);
    return result;
}

inline std::string also(std::string_view more) {
    return std::string{valid_case} + std::string{more};
}

inline std::vector<casefile::Fault> faults_of(const std::string& text,
                                              const std::vector<std::string>& overrides = {}) {
    try {
        static_cast<void>(read_cases_text(text, "case.toml", overrides));
    } catch (const CaseError& error) {
        return error.faults();
    }
    return {};
}

/// The only fault of a text; an empty one when there are none or several.
inline casefile::Fault only_fault(const std::string& text,
                                  const std::vector<std::string>& overrides = {}) {
    const std::vector<casefile::Fault> faults = faults_of(text, overrides);
    EXPECT_EQ(faults.size(), 1U) << text;
    for (std::size_t at = 1; at < faults.size(); ++at)
        ADD_FAILURE() << faults[at].text();
    return faults.empty() ? casefile::Fault{} : faults.front();
}

inline Case read_text(const std::string& text, const std::vector<std::string>& overrides = {}) {
    return read_cases_text(text, "case.toml", overrides).at(0);
}

} // namespace searle::app
