#include "app/summary_json.hpp"
#include "tests/fuzz/readers.hpp"

#include <stdexcept>

namespace searle::fuzz {

void read_summary(std::string_view bytes) {
    static_cast<void>(app::kind_of_summary(bytes));
    static_cast<void>(app::files_listed(bytes));
    try {
        static_cast<void>(app::summary_json(app::read_run_summary(bytes)));
    } catch (const std::runtime_error&) {
    }
    try {
        static_cast<void>(app::summary_json(app::read_sweep_summary(bytes)));
    } catch (const std::runtime_error&) {
    }
}

} // namespace searle::fuzz
