#include "casefile/nearest_name.hpp"

#include <gtest/gtest.h>
#include <vector>

using namespace searle::casefile;

TEST(nearest_name, distance_counts_single_slips) {
    EXPECT_EQ(spelling_distance("height", "height"), 0);
    EXPECT_EQ(spelling_distance("heigth", "height"), 1); // two letters swapped
    EXPECT_EQ(spelling_distance("hight", "height"), 1);
    EXPECT_EQ(spelling_distance("heights", "height"), 1);
    EXPECT_EQ(spelling_distance("kitten", "sitting"), 3); // the textbook example of Levenshtein
    EXPECT_EQ(spelling_distance("", "abc"), 3);
}

TEST(nearest_name, case_and_separators_do_not_count) {
    EXPECT_EQ(spelling_distance("Single_Gap", "single-gap"), 0);
    EXPECT_EQ(spelling_distance("bob radius", "bob_radius"), 0);
}

TEST(nearest_name, far_names_are_not_suggested) {
    const std::vector<std::string> names{"bob_radius", "cup_radius", "height"};
    EXPECT_EQ(nearest_name("bob_raduis", names), "bob_radius");
    EXPECT_EQ(nearest_name("cup_radiu", names), "cup_radius");
    EXPECT_EQ(nearest_name("viscosity", names), std::nullopt);
    EXPECT_EQ(nearest_name("", names), std::nullopt);
    EXPECT_EQ(nearest_name(std::string(100000, 'x'), names), std::nullopt);
}
