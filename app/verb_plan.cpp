#include "app/verb_plan.hpp"

#include "app/case_reader.hpp"
#include "app/exit_code.hpp"
#include "app/plan_as_json.hpp"
#include "app/plan_as_text.hpp"

#include <cstdio>
#include <string>

namespace searle::app {

int plan(const PlanOptions& options) {
    std::vector<CasePlan> plans;
    for (Case& source : read_cases(options.case_file, options.overrides)) {
        solvers::Plan made = solvers::make_plan(source.scene);
        plans.push_back({std::move(source), std::move(made)});
    }
    std::string text;
    if (options.json) {
        text = plans_as_json(plans);
    } else {
        for (const CasePlan& planned : plans) {
            text += (text.empty() ? "" : "\n\n") + plan_as_text(planned);
        }
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
    return ExitCode::done;
}

} // namespace searle::app
