#include "rheometry/report/number_text.hpp"
#include "rheometry/report/property_rows.hpp"
#include "rheometry/report/prose.hpp"
#include "rheometry/report/quantity.hpp"
#include "rheometry/report/rich_text.hpp"

#include <cmath>

namespace searle::rheometry::report {

std::vector<PropertyRow> solution_rows(const ReportInput& input) {
    std::vector<PropertyRow> rows;
    const Provenance& from = input.provenance;
    const auto add_text = [&](std::string name, const std::string& text,
                              std::string_view key = {}) {
        if (text.empty()) {
            return;
        }
        rows.push_back({std::move(name), "", prose_html(text) + source_note(input, key)});
    };
    add_text("Engine", from.engine, "solver.engine");
    add_text("Model", from.model, "solver.model");
    add_text("Why this model", from.model_reason);
    if (input.accuracy > 0.0) {
        rows.push_back({"Relative accuracy asked for", "",
                        relative_text(input.accuracy, 3) + source_note(input, "solver.accuracy")});
    }
    double largest = -1.0;
    std::size_t missed = 0;
    for (const RheogramPoint& point : input.rheogram.points) {
        const double error = relative_error(point);
        if (!std::isfinite(error)) {
            continue;
        }
        largest = std::max(largest, error);
        if (input.accuracy > 0.0 && error > input.accuracy) {
            ++missed;
        }
    }
    if (largest >= 0.0) {
        std::string text = relative_text(largest, 3);
        if (missed > 0) {
            text += "; above what was asked at " + std::to_string(missed) + " points";
        }
        rows.push_back({"Largest relative error estimated", "", text});
    }
    for (const StageTime& stage : input.timings) {
        std::string text = quantity_text(stage.wall_seconds, "s", 3);
        if (stage.cpu_seconds >= 0.0) {
            text += " (processor " + quantity_text(stage.cpu_seconds, "s", 3) + ")";
        }
        rows.push_back({"Time, " + escaped(stage.stage), "", text});
    }
    for (const Fact& fact : input.solver_facts) {
        add_text(escaped(fact.name), fact.value);
    }
    return rows;
}

} // namespace searle::rheometry::report
