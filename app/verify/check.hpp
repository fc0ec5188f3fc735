#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace searle::app::verify {

/// What a check found.
struct Found {
    double error{}; ///< the largest, as the check's `measure` says
    /// Observed order of convergence over the two finest of three resolutions; NaN: not of this
    /// check.
    double order = std::numeric_limits<double>::quiet_NaN();
};

/// One rung of the ladder: a part of the program against something that it does not rest on.
struct Check {
    std::string name;    ///< letters, digits, hyphens
    std::string subject; ///< the solver or law
    std::string against; ///< the closed form, or the independent value with its origin
    double tolerance{};
    std::string origin;   ///< where the tolerance comes from
    double least_order{}; ///< 0: no order
    std::string file;     ///< of the test that holds it, from the project's root
    std::string test;     ///< its name, Suite.test
    std::function<Found()> run;
};

struct CheckResult {
    const Check* check{};
    Found found;
    bool passed{};
    std::string fault; ///< an exception's text; empty: none
    double seconds{};  ///< CPU
};

[[nodiscard]] inline double relative(double value, double expected) {
    return std::abs(value / expected - 1.0);
}
/// Order from two errors, the second at half the size.
[[nodiscard]] inline double order_of(double coarse, double fine) {
    return std::log2(coarse / fine);
}

[[nodiscard]] std::vector<Check> flow_law_checks();
[[nodiscard]] std::vector<Check> gap_checks();
[[nodiscard]] std::vector<Check> onset_checks();
[[nodiscard]] std::vector<Check> bob_checks();
[[nodiscard]] std::vector<Check> reading_checks();
[[nodiscard]] std::vector<Check> particle_checks();

/// All of them, in the order of the ladder.
[[nodiscard]] const std::vector<Check>& all_checks();

[[nodiscard]] CheckResult done(const Check& check);

} // namespace searle::app::verify
