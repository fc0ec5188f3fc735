#pragma once

#include "tests/app/case_texts.hpp"

#include <gtest/gtest.h>
#include <string>

namespace searle::app {

inline bool holds(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

inline const std::string ramp =
    "type = \"ramp\"\nto = \"100 1/s\"\nduration = \"35 s\"\npoints = 100";
inline const std::string single_gap =
    "type = \"single-gap\"\nbob_radius = \"14 mm\"\ncup_radius = \"15 mm\"\nheight = \"42 mm\"";
inline const std::string newtonian = "model = \"newtonian\"\nviscosity = \"1.0016 mPa.s\"";
inline const std::string din_bob = "type = \"din-bob\"\nbob_radius = \"14 mm\"\n";
inline const std::string box =
    "type = \"box\"\ngap = \"1 mm\"\nlength = \"88 mm\"\nwidth = \"42 mm\"";
inline const std::string double_gap =
    "type = \"double-gap\"\nradii = [\"20 mm\", \"20.38 mm\", \"21.96 "
    "mm\", \"22.38 mm\"]\nheight = \"55 mm\"";

/// What the only fault of a case text is to say.
struct Expected {
    std::string text;
    std::string key;
    int line;
    std::string problem;
    std::string allowed;
    std::string suggestion;
};

inline void expect(const Expected& expected) {
    const casefile::Fault fault = only_fault(expected.text);
    EXPECT_EQ(fault.key, expected.key);
    ASSERT_FALSE(fault.places.empty()) << fault.text();
    EXPECT_EQ(fault.places.front().line, expected.line) << fault.text();
    EXPECT_TRUE(holds(fault.problem, expected.problem)) << fault.text();
    EXPECT_TRUE(holds(fault.allowed, expected.allowed)) << fault.text();
    EXPECT_EQ(fault.suggestion, expected.suggestion) << fault.text();
}

} // namespace searle::app
