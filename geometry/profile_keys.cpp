#include "geometry/instrument_keys.hpp"

#include "casefile/reading.hpp"
#include "geometry/mesh_error.hpp"
#include "geometry/outline_check.hpp"
#include "geometry/profile_outline.hpp"

#include <cctype>

namespace searle::geometry {
namespace {

casefile::Keys<ProfilePoint> point_keys() {
    casefile::Keys<ProfilePoint> keys;
    keys.key("r", &ProfilePoint::r)
        .measures(casefile::length)
        .at_least("0 m")
        .at_most("1000 m")
        .required()
        .example("14 mm")
        .says("Distance from the axis.");
    keys.key("z", &ProfilePoint::z)
        .measures(casefile::length)
        .at_least("-1000 m")
        .at_most("1000 m")
        .required()
        .example("42 mm")
        .says("Height.");
    keys.key("patch", &ProfilePoint::patch)
        .is_text()
        .example("bob_cone")
        .defaults_to("bob of the rotor, cup of the cup")
        .says("Name of the wall from here to the next point; the rotor's start with bob or shaft.");
    return keys;
}

bool is_name(const std::string& text) {
    for (const char letter : text)
        if (!std::isalnum(static_cast<unsigned char>(letter)) && letter != '_')
            return false;
    return true;
}

void check_names(const Profile& profile, casefile::Findings& findings) {
    const auto look = [&](const std::vector<ProfilePoint>& points, const char* key, bool is_rotor) {
        for (const ProfilePoint& point : points) {
            if (point.patch.empty())
                continue;
            if (!is_name(point.patch))
                findings.contradiction({key}, "\"" + point.patch + "\" is no name of a patch",
                                       "letters, digits and _");
            else if (is_rotor_patch(point.patch) != is_rotor)
                findings.contradiction(
                    {key}, "the patch \"" + point.patch + "\" belongs to the other wall",
                    "names of the rotor start with bob, rotor or shaft, names of the cup do not");
        }
    };
    look(profile.rotor, "rotor", true);
    look(profile.cup, "cup", false);
}

} // namespace

casefile::Keys<Profile> profile_keys() {
    casefile::Keys<Profile> keys;
    keys.tables("rotor", &Profile::rotor, point_keys())
        .required()
        .example(R"([{ r = "0 mm", z = "-3 mm", patch = "bob_cone" }, )"
                 R"({ r = "10 mm", z = "0 mm", patch = "bob" }, )"
                 R"({ r = "10 mm", z = "20 mm", patch = "bob_top" }, )"
                 R"({ r = "3 mm", z = "22 mm", patch = "shaft" }, { r = "3 mm", z = "30 mm" }])")
        .says("Corners of the rotor, from its lowest point to the liquid's surface.");
    keys.tables("cup", &Profile::cup, point_keys())
        .required()
        .example(R"([{ r = "0 mm", z = "-8 mm", patch = "cup_floor" }, )"
                 R"({ r = "12 mm", z = "-8 mm" }, { r = "12 mm", z = "30 mm" }])")
        .says("Corners of the cup, from its lowest point to the liquid's surface.");
    keys.check([](const Profile& profile, casefile::Findings& findings) {
        check_names(profile, findings);
        try {
            (void)check_outline(outline_of(profile));
        } catch (const MeshError& error) {
            findings.contradiction({"rotor", "cup"}, error.what());
        }
    });
    return keys;
}

} // namespace searle::geometry
