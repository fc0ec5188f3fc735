#include "app/grammar.hpp"

#include "app/versions.hpp"

namespace searle::app {

Grammar::Grammar() {
    program_.set_version_flag("--version", fmt::format("searle {}", program_version()),
                              "Print the version");
    program_.set_help_flag("-h,--help", "Print this text");
    program_.require_subcommand(1);
    program_.get_formatter()->column_width(34);
    program_.get_formatter()->label("SUBCOMMAND", "VERB");
    program_.footer("Example: searle run cases/single-gap-water.toml\n"
                    "`searle VERB --help` tells more about a verb.\n"
                    "Exit codes: 0 done, 1 fault, 2 wrong usage or case file, 3 accuracy not "
                    "reached,\n4 engine or model missing, 130 interrupted.");
    add_run();
    add_collect();
    add_compare();
    add_plan();
    add_check();
    add_convert();
    add_fit();
    add_ends();
    add_mesh();
    add_bench();
    add_verify();
    add_report();
    add_new();
    add_schema();
    add_doctor();
    add_stress();
}

} // namespace searle::app
