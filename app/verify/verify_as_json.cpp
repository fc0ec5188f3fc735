#include "app/verify/verify_text.hpp"
#include "app/versions.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace searle::app::verify {

std::string checks_json(const std::vector<CheckResult>& results) {
    using Json = nlohmann::ordered_json;
    const auto number = [](double value) {
        return std::isfinite(value) ? Json(value) : Json(nullptr);
    };
    Json rows = Json::array();
    for (const CheckResult& result : results) {
        const Check& check = *result.check;
        rows.push_back(
            {{"name", check.name},
             {"subject", check.subject},
             {"against", check.against},
             {"error", number(result.found.error)},
             {"tolerance", check.tolerance},
             {"tolerance_origin", check.origin},
             {"order", number(result.found.order)},
             {"least_order", check.least_order > 0.0 ? Json(check.least_order) : Json(nullptr)},
             {"passed", result.passed},
             {"fault", result.fault},
             {"cpu_s", result.seconds},
             {"test", check.test},
             {"file", check.file}});
    }
    const Json json = {{"version", program_version()},
                       {"passed", std::ranges::all_of(results, &CheckResult::passed)},
                       {"checks", std::move(rows)}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace searle::app::verify
