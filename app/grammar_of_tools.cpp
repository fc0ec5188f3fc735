#include "app/grammar.hpp"
#include "app/verb_bench.hpp"
#include "app/verb_doctor.hpp"
#include "app/verb_schema.hpp"
#include "app/verb_stress.hpp"
#include "app/verb_verify.hpp"

namespace searle::app {

void Grammar::add_bench() {
    auto options = std::make_shared<BenchOptions>();
    CLI::App* app = add("bench", "Measure run time against error, beside the peers installed",
                        "single-gap-ramp -o bench-results", options, bench_scenes_verb);
    app->add_option("NAME", options->names,
                    "Scenes, or the beginnings of their names; default all (--list)");
    app->add_flag("--quick", options->quick, "Fewer points and cheap peers: a minute in all");
    add_path(app, "-o,--output", options->folder,
             "Folder for bench.html, .csv, .json and .md, and the README's table; default "
             "bench-results",
             "DIR");
    app->add_flag("--no-peers", options->no_peers, "Searle alone");
    app->add_flag("--list", options->list, "List the scenes");
    auto* json = app->add_flag("--json", options->json, "Print JSON");
    app->add_flag("--readme", options->readme, "Print the README's table")->excludes(json);
    app->add_flag("--quiet", options->quiet, "Show no progress");
    app->add_flag("--force", options->replace, "Replace results that are there already");
}

void Grammar::add_verify() {
    auto options = std::make_shared<VerifyOptions>();
    CLI::App* app = add("verify", "Check this installation against closed forms and known values",
                        "--json > verification.json", options, verify_installation);
    app->add_option("NAME", options->names, "Beginnings of the checks' names; default all");
    app->add_flag("--list", options->list, "List the checks");
    auto* json = app->add_flag("--json", options->json, "Print JSON");
    app->add_flag("--markdown", options->markdown, "Print the page docs/verification.md")
        ->excludes(json);
}

void Grammar::add_schema() {
    auto options = std::make_shared<SchemaOptions>();
    CLI::App* app = add("schema", "Print every key of a case file: type, unit, default, bounds",
                        "--json", options, schema);
    auto* json = app->add_flag_callback(
        "--json", [options] { options->format = SchemaFormat::json; }, "Print JSON");
    app->add_flag_callback(
           "--markdown", [options] { options->format = SchemaFormat::markdown; },
           "Print the reference page")
        ->excludes(json);
}

void Grammar::add_doctor() {
    CLI::App* app = program_.add_subcommand(
        "doctor", "Say which engines and libraries are there, and what is missing");
    app->group("Verbs");
    app->footer("Example: searle doctor");
    app->callback([this] { chosen_ = doctor; });
}

void Grammar::add_stress() {
    auto options = std::make_shared<StressOptions>();
    CLI::App* app = add("stress", "Hold random scenes to the truth: what can break it",
                        "fluid --scenes 500 --seed 7 -o sweep", options, stress);
    app->add_option("NAME", options->families,
                    "fluid, extreme, particles, input (default: these), openfoam");
    app->add_option("--scenes", options->scenes, "Scenes of each family")->capture_default_str();
    app->add_option("--first", options->first, "Number of the first scene")->capture_default_str();
    app->add_option("--seed", options->seed, "What they are drawn from")->capture_default_str();
    app->add_option("--minutes", options->minutes, "Stop after that time; 0: do not");
    app->add_option("--scene-seconds", options->scene_seconds, "A scene that takes longer hangs")
        ->capture_default_str();
    add_path(app, "-o,--output", options->folder, "Folder for stress.csv and failures/", "DIR");
    app->add_flag("--json", options->json, "Print JSON");
    app->add_flag("--quiet", options->quiet, "Show no progress");
}

} // namespace searle::app
