#pragma once

#include "app/verify/check.hpp"

#include <string>
#include <vector>

namespace searle::app::verify {

/// A check that only the test suite makes: it needs resolutions or statistics that take longer.
struct SuiteOnly {
    std::string subject;
    std::string against;
    std::string file;
    std::string test;
};
[[nodiscard]] const std::vector<SuiteOnly>& suite_only();

/// One line a check, for the terminal.
[[nodiscard]] std::string check_line(const CheckResult& result);
/// `searle verify --json`.
[[nodiscard]] std::string checks_json(const std::vector<CheckResult>& results);
/// docs/verification.md.
[[nodiscard]] std::string verification_page(const std::vector<CheckResult>& results);

} // namespace searle::app::verify
