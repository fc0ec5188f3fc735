#include "app/case_keys.hpp"
#include "casefile/document.hpp"
#include "casefile/reading.hpp"
#include "casefile/reference.hpp"
#include "casefile/toml_text.hpp"

#include "places.hpp"
#include <algorithm>
#include <cstdio>
#include <fstream>

#include <gtest/gtest.h>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

using namespace searle;

namespace {

std::string output_of(const std::string& arguments) {
    const std::string command = std::string{SEARLE_PROGRAM} + " " + arguments;
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe{popen(command.c_str(), "r"), pclose};
    std::string text;
    char buffer[4096];
    while (pipe) {
        const std::size_t count = std::fread(buffer, 1, sizeof buffer, pipe.get());
        text.append(buffer, count);
        if (count == 0)
            break;
    }
    return text;
}

const casefile::KeySet& keys() { return *app::case_keys().set(); }

/// Calls back with every key, nested ones included.
template <class Visit>
void for_each_key(const casefile::KeySet& set, const Visit& visit) {
    for (const casefile::Key& key : set.keys) {
        visit(key, set);
        if (key.table)
            for_each_key(*key.table, visit);
    }
    if (set.selector)
        for (const auto& alternative : set.selector->alternatives)
            for_each_key(*alternative.keys, visit);
}

} // namespace

TEST(verb_schema, reference_page_is_up_to_date) {
    std::ifstream file{std::string{SEARLE_SOURCE_DIR} + "/docs/case-file.md"};
    const std::string page{std::istreambuf_iterator<char>{file}, {}};
    EXPECT_EQ(page, output_of("schema --markdown"))
        << "make it again: searle schema --markdown > docs/case-file.md";
}

TEST(verb_schema, json_names_every_key_once_per_condition) {
    const auto json = nlohmann::json::parse(output_of("schema --json"));
    std::set<std::pair<std::string, std::string>> names;
    for (const auto& key : json.at("keys")) {
        const std::string condition =
            key.at("condition").is_null() ? "" : key.at("condition").get<std::string>();
        EXPECT_TRUE(names.emplace(key.at("key").get<std::string>(), condition).second)
            << key.dump();
        EXPECT_FALSE(key.at("meaning").get<std::string>().empty()) << key.dump();
        EXPECT_FALSE(key.at("type").get<std::string>().empty()) << key.dump();
        EXPECT_EQ(key.at("required").get<bool>(), key.at("default").is_null()) << key.dump();
    }
    // Names of the contract.
    for (const char* name : {"title",
                             "geometry.type",
                             "geometry.bob_radius",
                             "geometry.radii",
                             "geometry.radius_ratio",
                             "geometry.gap",
                             "fluid.model",
                             "fluid.consistency",
                             "fluid.transition",
                             "fluid.density",
                             "protocol.shear_rates",
                             "protocol.hold",
                             "protocol.segments",
                             "protocol.hold_strain",
                             "conversion.definition",
                             "conversion.end_factor",
                             "solver.engine",
                             "solver.model",
                             "solver.accuracy",
                             "solver.secondary_flow",
                             "output.fields",
                             "mesh.order",
                             "particles.diameter",
                             "particles.contact.stiffness",
                             "particles.contact.rolling_friction",
                             "particles.dlvo.ionic_strength",
                             "particles.gravity",
                             "particles.time_step",
                             "coupling.cells",
                             "sweep.vary"})
        EXPECT_TRUE(std::any_of(names.begin(), names.end(), [name](const auto& one) {
            return one.first == name;
        })) << name;
}

TEST(verb_schema, every_example_is_a_value_that_its_key_takes) {
    int examples = 0;
    for_each_key(keys(), [&examples](const casefile::Key& key, const casefile::KeySet&) {
        const std::string example = casefile::example_as_toml(key);
        if (example.empty() || !key.binding.store)
            return;
        const auto node =
            casefile::parse_toml_value(example, casefile::Source::of_override(example), 1);
        ASSERT_TRUE(node.has_value()) << key.name << " = " << example;
        casefile::Reading reading;
        EXPECT_TRUE(casefile::read_value(key, *node, key.name, reading).has_value())
            << key.name << " = " << example;
        ++examples;
    });
    EXPECT_GT(examples, 60);
}

TEST(verb_schema, every_default_is_a_value_that_its_key_takes) {
    const auto rows = casefile::reference_rows(keys());
    int defaults = 0;
    for_each_key(keys(), [&defaults](const casefile::Key& key, const casefile::KeySet& set) {
        if (key.is_required || !key.binding.load)
            return;
        const auto value = key.binding.load(set.defaults().get());
        if (!value)
            return;
        const auto* number = std::get_if<double>(&value->is);
        if (!number)
            return;
        if (key.takes.lower) {
            EXPECT_TRUE(*number > key.takes.lower->value ||
                        (key.takes.lower->included && *number == key.takes.lower->value))
                << key.name;
        }
        if (key.takes.upper) {
            EXPECT_TRUE(*number < key.takes.upper->value ||
                        (key.takes.upper->included && *number == key.takes.upper->value))
                << key.name;
        }
        ++defaults;
    });
    EXPECT_GT(defaults, 8);
    EXPECT_GT(rows.size(), 100U);
}

TEST(verb_schema, every_key_has_a_sentence) {
    for_each_key(keys(), [](const casefile::Key& key, const casefile::KeySet&) {
        EXPECT_TRUE(key.sentence.ends_with('.') || key.sentence.ends_with(',')) << key.name;
        EXPECT_LT(key.sentence.size(), 100U) << key.name;
    });
}
