#pragma once

#include "../app/running.hpp"
#include "rheometry/rheogram_csv.hpp"
#include "solvers/openfoam/installation.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace searle::app::testing {

inline rheometry::Rheogram rheogram_in(const std::filesystem::path& folder) {
    return rheometry::read_rheogram_csv(folder / "rheogram.csv").rheogram;
}

/// Runs with the installed OpenFOAM; skipped where it is not here.
class OpenFoamRuns : public ::testing::Test {
protected:
    void SetUp() override {
        if (!solvers::openfoam::find_installation())
            GTEST_SKIP() << "OpenFOAM is not installed (package openfoam)";
    }

    /// The words of `searle run` for a case of cases/ with settings, results in `out`.
    static std::vector<std::string> words_for(const std::string& name, const std::string& out,
                                              const std::vector<std::string>& settings) {
        std::vector<std::string> words{"run", std::string(SEARLE_SOURCE_DIR) + "/cases/" + name,
                                       "-o", out, "--quiet"};
        for (const std::string& setting : settings) {
            words.emplace_back("--set");
            words.push_back(setting);
        }
        return words;
    }

    /// Runs a case of cases/ with settings, in `folder`.
    Outcome run_case(const std::string& name, const std::string& out,
                     const std::vector<std::string>& settings) {
        return run({.arguments = words_for(name, out, settings), .directory = folder.path()});
    }

    TemporaryFolder folder;
};

} // namespace searle::app::testing
