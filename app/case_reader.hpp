#pragma once

#include "casefile/fault.hpp"
#include "solvers/scene.hpp"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace searle::app {

using casefile::CaseError;

/// A case file that was read and found valid.
struct Case {
    solvers::Scene scene;
    /// The file's stem; for a case of a sweep its name in the sweep, usable as a folder's name.
    std::string name;
    std::filesystem::path file; ///< as given
    /// The case with every default written out, SI units. Reading it gives the same scene, bit for
    /// bit, and the same resolved text. A case of a sweep is written alone, without the sweep.
    std::string resolved_toml;
    std::string hash; ///< of resolved_toml: FNV-1a, 64 bits, 16 hexadecimal digits
    /// Line of the file where a value stands, by dotted key ("geometry.bob_radius", from 1).
    /// Absent: a default, or given by --set.
    std::map<std::string, int> lines;
    /// The value as the user wrote it ("14 mm"), by dotted key; absent for a default.
    std::map<std::string, std::string> written;
};

/// Reads a case file that holds one case. `overrides` are "key=value" texts of --set: a dotted key,
/// and a value in TOML or a bare text ("geometry.cup_radius=16 mm").
/// Throws CaseError with every fault of the file and of the overrides; a file that cannot be read,
/// or that holds a sweep, is one fault.
[[nodiscard]] Case read_case(const std::filesystem::path& file,
                             const std::vector<std::string>& overrides = {});

/// What `searle mesh` needs of a case file.
struct MeshCase {
    std::string title;
    std::string name; ///< the file's stem
    geometry::Instrument instrument;
    std::optional<geometry::Profile> profile; ///< see solvers::Scene
    geometry::MeshSettings mesh;
};

/// Reads a case file that holds one case, whose sections [fluid] and [protocol] may be left out.
/// Throws as read_case does.
[[nodiscard]] MeshCase read_mesh_case(const std::filesystem::path& file,
                                      const std::vector<std::string>& overrides = {});

/// The same for a file that may hold a sweep: its cases in order, or the one case.
[[nodiscard]] std::vector<Case> read_cases(const std::filesystem::path& file,
                                           const std::vector<std::string>& overrides = {});

/// As read_cases, for a text; `name` stands for the file in messages and in Case::file.
[[nodiscard]] std::vector<Case> read_cases_text(std::string_view text, std::string_view name,
                                                const std::vector<std::string>& overrides = {});

} // namespace searle::app
