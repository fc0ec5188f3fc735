#include "places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <vector>

// The shape that ARCHITECTURE.md describes, read from the sources themselves.

namespace {

namespace fs = std::filesystem;

const std::set<std::string> rooms{"casefile", "laws", "geometry",    "rheometry",
                                  "solvers",  "app",  "verification"};

/// Which rooms a room may include, besides itself.
const std::map<std::string, std::set<std::string>> may_include{
    {"casefile", {}},
    {"laws", {"casefile"}},
    {"geometry", {"casefile"}},
    {"rheometry", {"casefile", "laws", "geometry"}},
    {"solvers", {"casefile", "laws", "geometry", "rheometry"}},
    {"app", {"casefile", "laws", "geometry", "rheometry", "solvers", "verification"}},
    // References that tests, `bench` and `verify` hold the solvers to.
    {"verification", {"casefile", "laws", "geometry", "rheometry", "solvers"}},
};

/// Files that may include a third-party header, by the header's beginning. What is not named here
/// (the standard library, Boost.Math and Eigen inside solvers and laws) is free.
const std::map<std::string, std::set<std::string>> third_party{
    {"toml++", {"casefile/toml_text.cpp"}},
    {"udunits2", {"casefile/unit.cpp"}},
    {"freexl", {"rheometry/tables/spreadsheet.cpp"}},
    {"zip.h", {"rheometry/tables/open_workbook.cpp"}},
    {"pugixml", {"rheometry/tables/open_workbook.cpp"}},
    {"CLI/", {"app/grammar.hpp"}},
    {"hdf5", {"app/hdf5_module/module.cpp"}},
    {"gmsh.h", {"geometry/gmsh_module/module.cpp", "geometry/gmsh_module/filling.cpp"}},
    {"CGAL/", {"geometry/outline_check.cpp", "geometry/power_cells.cpp"}},
    {"nlohmann",
     {"app/fit_as_json.cpp", "app/mesh_table.cpp", "app/ends_as_json.cpp", "app/plan_as_json.cpp",
      "app/bench/bench_as_json.cpp", "app/verify/verify_as_json.cpp", "app/summary_json.cpp",
      "app/verb_schema.cpp", "rheometry/tables/trios_json.cpp"}},
    {"ceres", {"rheometry/fit/least_squares.cpp", "rheometry/fit/model.cpp"}},
    {"glog", {"rheometry/fit/least_squares.cpp"}},
};

struct Include {
    std::string file; ///< relative to the project's root
    int line{};
    std::string header; ///< as written, without quotes or brackets
    bool quoted{};      ///< "..." rather than <...>
};

std::vector<std::string> source_files() {
    std::vector<std::string> files;
    const fs::path root = SEARLE_SOURCE_DIR;
    for (const std::string& room : rooms)
        for (const auto& entry : fs::recursive_directory_iterator(root / room))
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".hpp")
                files.push_back(entry.path().lexically_relative(root).string());
    std::sort(files.begin(), files.end());
    return files;
}

std::vector<Include> includes_of(const std::string& file, std::istream& text) {
    static const std::regex include(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])");
    std::vector<Include> found;
    std::string line;
    for (int number = 1; std::getline(text, line); ++number)
        if (std::smatch match; std::regex_search(line, match, include))
            found.push_back({file, number, match[2], match[1] == "\""});
    return found;
}

std::vector<Include> all_includes() {
    std::vector<Include> all;
    for (const std::string& file : source_files()) {
        std::ifstream text(fs::path(SEARLE_SOURCE_DIR) / file);
        for (Include& include : includes_of(file, text))
            all.push_back(std::move(include));
    }
    return all;
}

std::string room_of(const std::string& path) { return path.substr(0, path.find('/')); }

/// What is wrong with an include; empty when nothing is.
std::string fault_of(const Include& include) {
    const std::string where = include.file + ":" + std::to_string(include.line) + ": ";
    const std::string from = room_of(include.file);
    const std::string to = room_of(include.header);
    if (include.quoted) {
        if (!rooms.contains(to))
            return where + '"' + include.header + "\" is not named from the project's root";
        if (to != from && !may_include.at(from).contains(to))
            return where + from + " must not include " + to;
        return "";
    }
    if (rooms.contains(to))
        return where + "a header of the project is included with quotes";
    for (const auto& [beginning, files] : third_party)
        if (include.header.starts_with(beginning) && !files.contains(include.file))
            return where + "<" + include.header + "> stays behind one file; see third_party";
    return "";
}

TEST(Shape, includes_follow_the_direction_of_dependencies) {
    const std::vector<Include> includes = all_includes();
    EXPECT_GT(includes.size(), 100U) << "the sources were not found";
    for (const Include& include : includes)
        EXPECT_EQ(fault_of(include), "");
}

TEST(Shape, a_breach_is_noticed) {
    EXPECT_NE(fault_of({"rheometry/rheogram.cpp", 1, "solvers/plan.hpp", true}), "");
    EXPECT_NE(fault_of({"laws/flow/newtonian.hpp", 1, "geometry/box.hpp", true}), "");
    EXPECT_NE(fault_of({"casefile/units.cpp", 1, "laws/flow/newtonian.hpp", true}), "");
    EXPECT_NE(fault_of({"geometry/box.cpp", 1, "box.hpp", true}), "");
    EXPECT_NE(fault_of({"geometry/box.cpp", 1, "geometry/box.hpp", false}), "");
    EXPECT_NE(fault_of({"solvers/plan.cpp", 1, "CLI/CLI.hpp", false}), "");
    EXPECT_EQ(fault_of({"app/main.cpp", 1, "solvers/plan.hpp", true}), "");
    EXPECT_EQ(fault_of({"solvers/plan.cpp", 1, "solvers/scene.hpp", true}), "");
    EXPECT_EQ(fault_of({"solvers/plan.cpp", 1, "vector", false}), "");
}

TEST(Shape, no_room_includes_itself_in_a_circle) {
    // Headers only: a .cpp is never included (checked by its ending below).
    std::map<std::string, std::vector<std::string>> uses;
    for (const Include& include : all_includes()) {
        EXPECT_FALSE(include.header.ends_with(".cpp")) << include.file;
        if (include.quoted && include.file.ends_with(".hpp"))
            uses[include.file].push_back(include.header);
    }
    std::map<std::string, int> state; // 1 being visited, 2 finished
    std::vector<std::string> circle;
    const auto visit = [&](const auto& self, const std::string& file) -> void {
        state[file] = 1;
        for (const std::string& used : uses[file]) {
            if (state[used] == 1)
                circle.push_back(file + " -> " + used);
            else if (state[used] == 0)
                self(self, used);
        }
        state[file] = 2;
    };
    std::vector<std::string> files;
    for (const auto& [file, used] : uses)
        files.push_back(file);
    for (const std::string& file : files)
        if (state[file] == 0)
            visit(visit, file);
    EXPECT_TRUE(circle.empty()) << (circle.empty() ? "" : circle.front());
}

TEST(Shape, no_source_file_holds_more_than_400_lines) {
    for (const std::string& file : source_files()) {
        std::ifstream text(fs::path(SEARLE_SOURCE_DIR) / file);
        const auto lines = std::count(std::istreambuf_iterator<char>(text), {}, '\n');
        EXPECT_LE(lines, 400) << file << " probably holds two subjects";
    }
}

TEST(Shape, every_room_says_what_is_in_it) {
    for (const std::string& room : rooms)
        EXPECT_TRUE(fs::exists(fs::path(SEARLE_SOURCE_DIR) / room / "README.md")) << room;
}

TEST(Shape, no_room_below_app_prints) {
    // Messages are the program's business: rooms return data and throw.
    static const std::regex printing(
        R"(std::(cout|cerr|clog)\b|\b(printf|puts|fprintf)\(|fmt::print\()");
    for (const std::string& file : source_files()) {
        if (room_of(file) == "app")
            continue;
        std::ifstream text(fs::path(SEARLE_SOURCE_DIR) / file);
        std::string line;
        for (int number = 1; std::getline(text, line); ++number)
            EXPECT_FALSE(std::regex_search(line, printing)) << file << ':' << number;
    }
}

} // namespace
