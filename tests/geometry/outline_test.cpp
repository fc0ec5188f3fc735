#include "geometry/mesh_error.hpp"
#include "geometry/mesh_subject.hpp"
#include "geometry/outline_check.hpp"
#include "geometry/profile_outline.hpp"

#include <gtest/gtest.h>

#include <string>

namespace searle::geometry {
namespace {

std::string refusal_of(const Outline& outline) {
    try {
        (void)check_outline(outline);
    } catch (const MeshError& error) {
        return error.what();
    }
    return "";
}

TEST(Outline, iso_bob_holds_8_1695_cubed_radii) {
    // DIN 53019 / ISO 3219 filling volume, R = 1 m.
    const MeshDomain domain = domain_of(DinBob{.bob_radius = 1.0, .cup_radius = 1.0847}, {});
    EXPECT_NEAR(measures_of(domain.outlines).volume, 8.1695, 5e-5);
}

TEST(Outline, volume_and_areas_of_a_gap_match_the_closed_forms) {
    const auto all = measures_of(domain_of(ConcentricCylinders{2.0, 3.0, 5.0}, {}).outlines);
    constexpr double pi = 3.14159265358979324;
    EXPECT_NEAR(all.volume, pi * (9.0 - 4.0) * 5.0, 1e-12);
    EXPECT_NEAR(all.patch_areas.at("bob"), 2 * pi * 2.0 * 5.0, 1e-12);
    EXPECT_NEAR(all.patch_areas.at("cup"), 2 * pi * 3.0 * 5.0, 1e-12);
    EXPECT_NEAR(all.patch_areas.at("slice_top"), pi * 5.0, 1e-12);
}

TEST(Outline, edges_that_cross_are_both_named) {
    const Outline bow{{{0, 0}, {2, 0}, {1, 2}, {3, 2}},
                      {{"floor", PatchKind::wall, ""},
                       {"cup", PatchKind::wall, ""},
                       {"top", PatchKind::wall, ""},
                       {"bob", PatchKind::wall, ""}}};
    const std::string refusal = refusal_of(bow);
    EXPECT_NE(refusal.find("cup from"), std::string::npos) << refusal;
    EXPECT_NE(refusal.find("bob from"), std::string::npos) << refusal;
}

TEST(Outline, an_edge_that_only_touches_another_is_refused) {
    // The corner (1, 0) lies on the floor, exactly.
    const Outline outline{{{0, 0}, {2, 0}, {2, 1}, {1, 0}, {0, 1}},
                          {{"floor", PatchKind::wall, ""},
                           {"cup", PatchKind::wall, ""},
                           {"b1", PatchKind::wall, ""},
                           {"b2", PatchKind::wall, ""},
                           {"axis", PatchKind::axis, ""}}};
    EXPECT_NE(refusal_of(outline).find("floor from"), std::string::npos);
}

TEST(Outline, a_clockwise_outline_is_refused) {
    const Outline outline{
        {{0, 0}, {0, 1}, {1, 1}},
        {{"a", PatchKind::wall, ""}, {"b", PatchKind::wall, ""}, {"c", PatchKind::wall, ""}}};
    EXPECT_NE(refusal_of(outline).find("clockwise"), std::string::npos);
}

TEST(Outline, clearance_of_the_iso_bob_is_its_gap) {
    const DinBob bob{.bob_radius = 0.014, .cup_radius = 0.0152};
    const MeshDomain domain = domain_of(bob, {});
    EXPECT_NEAR(check_outline(domain.outlines.front()).clearance, 0.0012, 1e-15);
}

TEST(Outline, a_profile_whose_ends_are_not_level_is_refused) {
    const Profile profile{{{0, -1}, {1, 0}, {1, 2}}, {{0, -2}, {2, -2}, {2, 3}}};
    EXPECT_THROW((void)outline_of(profile), MeshError);
}

TEST(Outline, a_profile_refers_stress_and_rate_to_its_widest_cylinder) {
    const Profile profile{{{0, -1}, {1, 0}, {1, 2}, {0.2, 2.5}, {0.2, 3}},
                          {{0, -2}, {1.5, -2}, {1.5, 3}}};
    const ConcentricCylinders cylinders = nominal_cylinders(profile);
    EXPECT_EQ(cylinders.bob_radius, 1.0);
    EXPECT_EQ(cylinders.cup_radius, 1.5);
    EXPECT_EQ(cylinders.height, 2.0);
}

} // namespace
} // namespace searle::geometry
