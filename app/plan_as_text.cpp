#include "app/plan_as_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <string_view>

namespace searle::app {
namespace {

constexpr std::size_t line_length = 100;
constexpr std::size_t label_width = 18;

/// `text` broken at spaces behind a label column; further lines are indented to the column.
std::string labelled(std::string_view label, std::string_view text,
                     std::size_t column = label_width) {
    std::string result;
    std::string line = fmt::format("  {:<{}}", label, column - 2);
    bool line_has_words = false;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line_has_words && line.size() + 1 + word.size() > line_length) {
            result += line + '\n';
            line.assign(column, ' ');
            line_has_words = false;
        }
        line += line_has_words ? " " : "";
        line += word;
        line_has_words = true;
    }
    return result + line + '\n';
}

std::string duration(double seconds) {
    if (seconds < 1e-3) {
        return "less than 1 ms";
    }
    if (seconds < 1.0) {
        return fmt::format("about {:.0f} ms", 1e3 * seconds);
    }
    return seconds < 120.0 ? fmt::format("about {:.0f} s", seconds)
                           : fmt::format("about {:.0f} min", seconds / 60.0);
}

std::string expectation(const CasePlan& planned) {
    const solvers::Plan& plan = planned.plan;
    const std::string rows =
        fmt::format("{} row{}", plan.rows.size(), plan.rows.size() == 1 ? "" : "s");
    return plan.can_be_solved ? fmt::format("{}, {} on one core, {} unknowns", rows,
                                            duration(plan.expected_seconds), plan.expected_unknowns)
                              : rows;
}

/// Neighbouring rows of one regime.
struct Stretch {
    std::size_t first{};
    std::size_t last{};
    double largest_ratio{};
    double largest_lag{};
};

std::vector<Stretch> stretches_of(const std::vector<solvers::RowForecast>& rows) {
    std::vector<Stretch> stretches;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (stretches.empty() || rows[stretches.back().first].regime != rows[i].regime) {
            stretches.push_back({i, i, 0.0, 0.0});
        }
        Stretch& stretch = stretches.back();
        stretch.last = i;
        stretch.largest_ratio = std::max(stretch.largest_ratio, rows[i].taylor_ratio);
        stretch.largest_lag = std::max(stretch.largest_lag, rows[i].lag_share);
    }
    return stretches;
}

std::string range(double first, double last) {
    return first == last ? fmt::format("{:.3g}", first)
                         : fmt::format("{:.3g} to {:.3g}", first, last);
}

std::string share(double value) {
    if (value == 0.0) {
        return "0";
    }
    return value < 1e-6 ? "< 1e-4 %" : fmt::format("{:.2g} %", 100.0 * value);
}

std::string regime_table(const CasePlan& planned) {
    constexpr std::size_t most_lines = 16;
    const std::vector<solvers::RowForecast>& rows = planned.plan.rows;
    const std::vector<Stretch> stretches = stretches_of(rows);
    constexpr const char* columns = "  {:<13} {:<20} {:<18} {:>8} {:>8}  {}\n";
    std::string table =
        fmt::format(columns, "row", "time, s", "shear rate, 1/s", "Re/Re_c", "inertia", "regime");
    for (std::size_t i = 0; i < std::min(most_lines, stretches.size()); ++i) {
        const Stretch& stretch = stretches[i];
        const solvers::RowForecast& first = rows[stretch.first];
        const solvers::RowForecast& last = rows[stretch.last];
        const std::string numbers =
            stretch.first == stretch.last
                ? fmt::format("{}", stretch.first + 1)
                : fmt::format("{} to {}", stretch.first + 1, stretch.last + 1);
        table +=
            fmt::format(columns, numbers, range(first.time, last.time),
                        range(first.shear_rate, last.shear_rate),
                        planned.plan.taylor ? fmt::format("{:.3g}", stretch.largest_ratio) : "-",
                        share(stretch.largest_lag), first.regime);
    }
    if (stretches.size() > most_lines) {
        table += fmt::format("  ... {} more changes of regime; --json has every row\n",
                             stretches.size() - most_lines);
    }
    return table;
}

} // namespace

std::string plan_as_text(const CasePlan& planned) {
    const Case& source = planned.source;
    const solvers::Plan& plan = planned.plan;
    const std::string& title = source.scene.title;
    std::string text =
        title.empty() ? source.name + '\n' : fmt::format("{} ({})\n", title, source.name);
    text +=
        labelled("model", plan.can_be_solved ? plan.model
                                             : plan.model + ": cannot be solved by this version");
    text += labelled("why", plan.model_reason);
    if (plan.items.empty())
        return text;
    text += labelled("cost", expectation(planned));
    for (const bool solved : {true, false}) {
        text += solved ? "\nsolved\n" : "\nskipped\n";
        bool any = false;
        for (const solvers::PlanItem& item : plan.items) {
            if (item.solved == solved) {
                text += labelled(item.what, item.reason);
                any = true;
            }
        }
        text += any ? "" : "  steady laminar flow alone\n";
    }
    if (plan.taylor) {
        text += '\n' + labelled("Taylor onset", plan.taylor->onset_shear_rate
                                                    ? fmt::format("at {:.4g} 1/s. {}",
                                                                  *plan.taylor->onset_shear_rate,
                                                                  plan.taylor->basis)
                                                    : "above every row. " + plan.taylor->basis);
    }
    text += "\nregimes (inertia and Re/Re_c: the largest of the rows)\n" + regime_table(planned);
    if (!plan.warnings.empty()) {
        text += "\nwarnings\n";
        for (const std::string& warning : plan.warnings) {
            text += labelled("-", warning, 4);
        }
    }
    return text;
}

} // namespace searle::app
