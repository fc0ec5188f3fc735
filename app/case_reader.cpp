#include "app/case_reader.hpp"

#include "app/case_keys.hpp"
#include "casefile/document.hpp"
#include "casefile/reading.hpp"
#include "casefile/sweep.hpp"
#include "casefile/text_hash.hpp"
#include "casefile/writing.hpp"

#include <fmt/format.h>
#include <set>
#include <utility>

namespace searle::app {
namespace {

constexpr std::string_view resolved_heading =
    "# The case as resolved by searle: SI units, every default written out.\n\n";

/// The faults of all cases of a file, each said once.
class Complaints {
public:
    /// Whether so many faults were found, most of them again and again in the cases of a sweep,
    /// that looking at more cases only takes time.
    [[nodiscard]] bool are_enough() const { return found_ > 2000; }
    void add(std::vector<casefile::Fault> faults) {
        found_ += faults.size();
        for (casefile::Fault& fault : faults)
            if (said_.insert(identity(fault)).second)
                faults_.push_back(std::move(fault));
    }
    void raise_if_any() {
        if (!faults_.empty())
            throw CaseError{std::move(faults_)};
    }

private:
    static std::string identity(const casefile::Fault& fault) {
        std::string text = fmt::format("{}\n{}", fault.key, fault.problem);
        for (const casefile::Place& place : fault.places)
            text += fmt::format("\n{}:{}:{}", place.source->name, place.line, place.column);
        return text;
    }

    std::size_t found_ = 0;
    std::set<std::string> said_;
    std::vector<casefile::Fault> faults_;
};

Case finished(CaseAsWritten written, const casefile::Reading& reading, std::string name,
              const std::filesystem::path& file) {
    written.sweep.reset();
    resolve(written);
    Case result;
    result.scene = scene_of(written);
    result.name = std::move(name);
    result.file = file;
    result.resolved_toml =
        std::string{resolved_heading} +
        casefile::write_toml(*case_keys().set(), &written, casefile::WritingStyle::resolved);
    result.hash = casefile::text_hash(result.resolved_toml);
    for (const auto& [key, place] : reading.places)
        if (place.source->is_file)
            result.lines.emplace(key, place.line);
    result.written = reading.written;
    return result;
}

/// The section [sweep] of a file that has one.
std::optional<casefile::Sweep> read_sweep(const casefile::Node& root, casefile::Reading& reading) {
    const casefile::Entry* entry = root.find("sweep");
    if (!entry || entry->value.kind != casefile::Node::Kind::table)
        return std::nullopt;
    casefile::Sweep sweep;
    casefile::read_keys(*casefile::sweep_keys().set(), entry->value, "sweep", &sweep, reading);
    return sweep;
}

/// The assignments of --set; faults for texts that are none, and for a sweep from outside the file.
std::vector<casefile::Assignment> assignments_of(const std::vector<std::string>& overrides,
                                                 std::vector<casefile::Fault>& faults) {
    std::vector<casefile::Assignment> assignments;
    for (const std::string& text : overrides)
        casefile::parse_override(text, assignments, faults);
    std::erase_if(assignments, [&faults](const casefile::Assignment& assignment) {
        const bool sweeps = assignment.key == "sweep" || assignment.key.starts_with("sweep.");
        if (sweeps)
            faults.push_back({{assignment.key_place},
                              assignment.key,
                              "a sweep stands in the file",
                              "keys of the other sections",
                              ""});
        return sweeps;
    });
    return assignments;
}

/// The trees of the file's cases, overrides included; empty when the sweep itself has a fault.
std::vector<casefile::SweptCase> trees_of(const casefile::Document& document,
                                          const std::filesystem::path& file,
                                          const std::vector<std::string>& overrides,
                                          Complaints& complaints) {
    std::vector<casefile::Fault> faults;
    const std::vector<casefile::Assignment> assignments = assignments_of(overrides, faults);
    complaints.add(std::move(faults));
    faults.clear();

    const std::set<std::string> selectors = casefile::selector_keys(*case_keys().set());
    casefile::Reading sweep_reading;
    std::vector<casefile::SweptCase> trees;
    if (const auto sweep = read_sweep(document.root, sweep_reading)) {
        if (sweep_reading.faults.empty())
            trees = casefile::cases_of(document.root, *sweep, assignments, selectors, faults);
    } else {
        trees.push_back({file.stem().string(), document.root});
        for (const casefile::Assignment& assignment : assignments)
            casefile::assign(trees.back().root, assignment, selectors, faults);
    }
    complaints.add(std::move(sweep_reading.faults));
    complaints.add(std::move(faults));
    return trees;
}

std::vector<Case> cases_in(const casefile::Document& document, const std::filesystem::path& file,
                           const std::vector<std::string>& overrides) {
    Complaints complaints;
    complaints.add(document.syntax_faults);
    std::vector<Case> cases;
    for (casefile::SweptCase& one : trees_of(document, file, overrides, complaints)) {
        if (complaints.are_enough())
            break;
        casefile::Reading reading;
        reading.reports_missing_keys = document.syntax_faults.empty();
        reading.whole_file = case_keys().set().get();
        CaseAsWritten written;
        casefile::read_keys(*case_keys().set(), one.root, "", &written, reading);
        const bool is_valid = reading.faults.empty() && document.syntax_faults.empty();
        if (is_valid)
            cases.push_back(finished(std::move(written), reading, std::move(one.name), file));
        complaints.add(std::move(reading.faults));
    }
    complaints.raise_if_any();
    return cases;
}

[[noreturn]] void refuse_sweep(const casefile::Entry& sweep,
                               const std::vector<std::string>& names) {
    std::string shown;
    for (const std::string& name : names)
        if (shown.size() < 200)
            shown += fmt::format("{}{}", shown.empty() ? "" : "  ", name);
    throw CaseError{{{{sweep.key_place},
                      "sweep",
                      fmt::format("the file holds {} cases, where one is needed", names.size()),
                      fmt::format("a file without [sweep]; its cases are {}", shown),
                      ""}}};
}

} // namespace

std::vector<Case> read_cases_text(std::string_view text, std::string_view name,
                                  const std::vector<std::string>& overrides) {
    return cases_in(casefile::parse_document(text, std::string{name}), name, overrides);
}

std::vector<Case> read_cases(const std::filesystem::path& file,
                             const std::vector<std::string>& overrides) {
    const std::string text = casefile::read_case_text(file);
    return cases_in(casefile::parse_document(text, file.string()), file, overrides);
}

Case read_case(const std::filesystem::path& file, const std::vector<std::string>& overrides) {
    const std::string text = casefile::read_case_text(file);
    const casefile::Document document = casefile::parse_document(text, file.string());
    std::vector<Case> cases = cases_in(document, file, overrides);
    const casefile::Entry* sweep = document.root.find("sweep");
    if (!sweep)
        return std::move(cases.front());
    std::vector<std::string> names;
    for (const Case& one : cases)
        names.push_back(one.name);
    refuse_sweep(*sweep, names);
}

MeshCase read_mesh_case(const std::filesystem::path& file,
                        const std::vector<std::string>& overrides) {
    const casefile::Document document =
        casefile::parse_document(casefile::read_case_text(file), file.string());
    Complaints complaints;
    complaints.add(document.syntax_faults);
    const std::vector<casefile::SweptCase> trees = trees_of(document, file, overrides, complaints);
    CaseAsWritten written;
    std::vector<std::string> names;
    for (const casefile::SweptCase& one : trees) {
        if (complaints.are_enough())
            break;
        casefile::Reading reading;
        reading.reports_missing_keys = document.syntax_faults.empty();
        reading.whole_file = case_keys().set().get();
        casefile::read_keys(*mesh_case_keys().set(), one.root, "", &written, reading);
        complaints.add(std::move(reading.faults));
        names.push_back(one.name);
    }
    complaints.raise_if_any();
    if (const casefile::Entry* sweep = document.root.find("sweep"))
        refuse_sweep(*sweep, names);
    MeshCase result{written.title, file.stem().string(), geometry::instrument_of(written.geometry),
                    std::nullopt, written.mesh};
    if (const auto* profile = std::get_if<geometry::Profile>(&written.geometry.instrument))
        result.profile = *profile;
    return result;
}

} // namespace searle::app
