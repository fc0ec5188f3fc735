#include "app/verify/check.hpp"

#include "app/bench/apart.hpp"

#include <exception>

namespace searle::app::verify {

const std::vector<Check>& all_checks() {
    static const std::vector<Check> checks = [] {
        std::vector<Check> all;
        for (const auto& part : {flow_law_checks(), gap_checks(), onset_checks(), bob_checks(),
                                 reading_checks(), particle_checks()})
            all.insert(all.end(), part.begin(), part.end());
        return all;
    }();
    return checks;
}

CheckResult done(const Check& check) {
    CheckResult result;
    result.check = &check;
    const double start = bench::process_seconds();
    try {
        result.found = check.run();
    } catch (const std::exception& error) {
        result.fault = error.what();
        result.found.error = std::numeric_limits<double>::quiet_NaN();
    }
    result.seconds = bench::process_seconds() - start;
    // Written so that a NaN fails.
    result.passed = result.fault.empty() && result.found.error <= check.tolerance &&
                    (check.least_order == 0.0 || result.found.order >= check.least_order);
    return result;
}

} // namespace searle::app::verify
