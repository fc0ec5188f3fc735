#include "app/command_line.hpp"

#include "app/exit_code.hpp"
#include "app/failures.hpp"
#include "app/verb_bench.hpp"
#include "app/verb_check.hpp"
#include "app/verb_collect.hpp"
#include "app/verb_compare.hpp"
#include "app/verb_convert.hpp"
#include "app/verb_doctor.hpp"
#include "app/verb_ends.hpp"
#include "app/verb_fit.hpp"
#include "app/verb_mesh.hpp"
#include "app/verb_new.hpp"
#include "app/verb_plan.hpp"
#include "app/verb_report.hpp"
#include "app/verb_run.hpp"
#include "app/verb_schema.hpp"
#include "app/verb_stress.hpp"
#include "app/verb_verify.hpp"
#include "app/versions.hpp"
#include "casefile/nearest_name.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace searle::app {
namespace {

using Verb = std::function<int()>;

/// The command line's grammar, and the verb that it chose.
class Grammar {
public:
    Grammar() {
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

    CLI::App& program() { return program_; }
    [[nodiscard]] const Verb& chosen() const { return chosen_; }
    [[nodiscard]] std::vector<std::string> verb_names() const {
        std::vector<std::string> names;
        for (const CLI::App* verb : program_.get_subcommands({}))
            names.push_back(verb->get_name());
        return names;
    }

private:
    template <class Options>
    CLI::App* add(const char* name, const char* purpose, const char* example,
                  std::shared_ptr<Options> options, int (*verb)(const Options&)) {
        CLI::App* app = program_.add_subcommand(name, purpose);
        app->group("Verbs");
        app->footer(fmt::format("Example: searle {} {}", name, example));
        app->callback([this, options, verb] { chosen_ = [=] { return verb(*options); }; });
        return app;
    }
    static void add_overrides(CLI::App* app, std::vector<std::string>& overrides) {
        app->add_option("--set", overrides,
                        "Set a key of the case instead of the file, e.g. solver.accuracy=1e-4; may "
                        "be repeated")
            ->type_name("KEY=VALUE")
            ->allow_extra_args(false);
    }
    template <class Path>
    static CLI::Option* add_path(CLI::App* app, const char* name, Path& path, const char* meaning,
                                 const char* type = "FILE") {
        return app
            ->add_option_function<std::string>(
                name, [&path](const std::string& text) { path = text; }, meaning)
            ->type_name(type);
    }

    static CLI::Option* add_paths(CLI::App* app, const char* name,
                                  std::vector<std::filesystem::path>& paths, const char* meaning) {
        return app
            ->add_option_function<std::vector<std::string>>(
                name,
                [&paths](const std::vector<std::string>& texts) {
                    paths.assign(texts.begin(), texts.end());
                },
                meaning)
            ->type_name("FILE");
    }
    static void add_repeated(CLI::App* app, const char* name, std::vector<std::string>& words,
                             const char* meaning, const char* shape) {
        app->add_option(name, words, fmt::format("{}; may be repeated", meaning))
            ->type_name(shape)
            ->allow_extra_args(false);
    }

    void add_run() {
        auto options = std::make_shared<RunOptions>();
        CLI::App* app =
            add("run", "Solve a case: rheogram with error bars, and a report",
                "cases/single-gap-water.toml -o water --set solver.accuracy=1e-4", options, run);
        add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
        add_path(app, "-o,--output", options->folder,
                 "Folder for the results; default results/<name of the case file>", "DIR");
        add_overrides(app, options->overrides);
        app->add_flag("--quiet", options->quiet, "Print nothing but errors");
        app->add_flag("--force", options->replace, "Replace results that are there already");
        app->add_flag("--write-only", options->write_only,
                      "Write OpenFOAM's cases without running them");
    }
    void add_collect() {
        auto options = std::make_shared<CollectOptions>();
        CLI::App* app =
            add("collect", "Read OpenFOAM cases that were run elsewhere: rheogram, report",
                "results/din-bob.openfoam -o din-bob", options, collect);
        add_path(app, "DIR", options->engine_folder, "Folder that run --write-only wrote", "DIR")
            ->required();
        add_path(app, "-o,--output", options->folder,
                 "Folder for the results; default DIR without .openfoam", "DIR");
        app->add_flag("--quiet", options->quiet, "Print nothing but errors");
        app->add_flag("--force", options->replace, "Replace results that are there already");
    }
    void add_compare() {
        auto options = std::make_shared<CompareOptions>();
        CLI::App* app =
            add("compare", "Solve a case on several engines, side by side",
                "cases/single-gap-water.toml --engines native,openfoam", options, compare);
        add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
        app->add_option("--engines", options->engines, "Engines, with commas")
            ->capture_default_str()
            ->type_name("NAMES");
        add_path(app, "-o,--output", options->folder,
                 "Folder for the results; default results/<name of the case file>.compare", "DIR");
        add_overrides(app, options->overrides);
        app->add_flag("--quiet", options->quiet, "Print the table alone");
        app->add_flag("--force", options->replace, "Replace results that are there already");
    }
    void add_plan() {
        auto options = std::make_shared<PlanOptions>();
        CLI::App* app = add("plan", "Say what would be solved and what skipped, and why",
                            "cases/figure-3.toml", options, plan);
        add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
        add_overrides(app, options->overrides);
        app->add_flag("--json", options->json, "Print JSON");
    }
    void add_check() {
        auto options = std::make_shared<CheckOptions>();
        CLI::App* app =
            add("check", "Read and validate a case only", "my-case.toml", options, check);
        add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
        add_overrides(app, options->overrides);
    }
    void add_convert() {
        auto options = std::make_shared<ConvertOptions>();
        CLI::App* app =
            add("convert", "Turn measured torque and speed into stress and rate",
                "lab.csv --case cases/din-bob-water.toml -o rheogram.csv", options, convert);
        add_path(app, "DATA", options->data_file,
                 "Measured data: delimited text, a workbook (.xls, .xlsx), or JSON of TRIOS")
            ->required();
        add_path(app, "--case", options->case_file, "Case file with the instrument")->required();
        add_path(app, "-o,--output", options->output, "Table to write; default standard output");
        app->add_option_function<std::string>(
               "--step", [options](const std::string& text) { options->step = text; },
               "Only this step of an export: its name, or the number that ends the name (3 for "
               "\"Flow sweep - 3\")")
            ->type_name("STEP");
        add_overrides(app, options->overrides);
        app->add_flag("--quiet", options->quiet, "Print no remarks");
    }
    void add_fit() {
        auto options = std::make_shared<FitVerbOptions>();
        CLI::App* app = add("fit", "Fit flow laws to rheograms, or through the instrument",
                            "flow-curve.csv --model all -o fit.html", options, fit_laws);
        add_paths(
            app, "DATA", options->data_files,
            "Rheograms (CSV, exports of lab software, .xls, .xlsx and JSON of TRIOS, blocks); "
            "with --case torques and speeds")
            ->required();
        add_paths(app, "--case", options->case_files,
                  "Case of the instrument: fit the raw torques through it; once for all files or "
                  "once per file")
            ->allow_extra_args(false);
        add_overrides(app, options->overrides);
        app->add_option("--model", options->model,
                        "Law, several with commas, or all; default herschel-bulkley")
            ->type_name("NAME");
        app->add_option("--weights", options->weights,
                        "relative (default), fitted, absolute, log, or a column of standard "
                        "deviations")
            ->type_name("HOW");
        app->add_option("--loss", options->loss, "Robust loss: none (default), huber or cauchy")
            ->type_name("NAME");
        app->add_option("--range", options->range, "Only shear rates in this range, 1/s")
            ->type_name("LOW:HIGH");
        add_repeated(app, "--bounds", options->bounds, "Bounds of a parameter, SI units",
                     "NAME=LOW:HIGH");
        add_repeated(app, "--fix", options->held, "Hold a parameter at a value, SI units",
                     "NAME=VALUE");
        app->add_option("--curve", options->curve, "Only curves whose name holds this text")
            ->type_name("TEXT");
        app->add_flag("--joint", options->joint, "One set of parameters for all curves");
        app->add_flag("--slip", options->slip,
                      "With --case: fit a wall slip too (needs two gaps and --joint)");
        app->add_flag("--fixed-ends", options->fixed_ends,
                      "With --case of a DIN bob: take c_L from the case; else it is computed");
        app->add_flag("--model-free", options->model_free,
                      "With --case: print every row of the model-free inversion");
        app->add_flag("--keep-all", options->keep_all,
                      "Keep points with lag, vortices or end flow");
        app->add_option("--predict", options->predict,
                        "Stresses with bands at these rates, 1/s: A,B,... or LOW:HIGH:COUNT")
            ->type_name("RATES");
        app->add_option("--design", options->design,
                        "Suggest so many further points that would shrink the intervals most, for "
                        "each of the four "
                        "geometries")
            ->type_name("COUNT")
            ->check(CLI::Range(1, 1000));
        auto* json = app->add_flag("--json", options->json, "Print JSON");
        app->add_flag("--csv", options->csv, "Print CSV")->excludes(json);
        add_paths(app, "-o,--output", options->outputs,
                  "Also write fit.html, fit.json or fit.csv, by the ending; may be repeated")
            ->allow_extra_args(false);
    }
    void add_ends() {
        auto options = std::make_shared<EndsOptions>();
        CLI::App* app = add("ends", "Tabulate the end factor c_L of a bob and fluid over the speed",
                            "cases/din-bob-slurry.toml --rates 0.01:100:9", options, ends);
        add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
        app->add_option_function<std::string>(
               "--rates", [options](const std::string& text) { options->rates = text; },
               "Shear rates, 1/s: A,B,... or LOW:HIGH:COUNT; default those of the case's rows")
            ->type_name("RATES");
        add_overrides(app, options->overrides);
        auto* json = app->add_flag("--json", options->json, "Print JSON");
        app->add_flag("--csv", options->csv, "Print CSV")->excludes(json);
        add_path(app, "-o,--output", options->output, "File to write; default standard output");
        app->add_flag("--quiet", options->quiet, "Show no progress");
    }
    void add_mesh() {
        auto options = std::make_shared<MeshOptions>();
        CLI::App* app =
            add("mesh", "Write the mesh by itself, and check it",
                "cases/din-bob-water.toml -o bob.msh --set mesh.extent=sector", options, mesh);
        add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
        add_path(app, "-o,--output", options->output,
                 "File for the mesh; its ending is the format (.msh .vtu .vtk .stl .xdmf .inp .su2 "
                 "...), a path that ends in / gets OpenFOAM's constant/polyMesh")
            ->required();
        add_overrides(app, options->overrides);
        app->add_option("--format", options->format, "msh41 (default) or msh22 for a .msh file");
        add_path(app, "--preview", options->preview,
                 "Picture of section and patches, .svg or .png");
        add_path(app, "--drawing", options->drawing, "Dimensioned drawing, .svg or .png");
        app->add_flag("--json", options->json, "Print the checks as JSON");
        app->add_flag("--quiet", options->quiet, "Print nothing but faults");
    }
    void add_bench() {
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
    void add_verify() {
        auto options = std::make_shared<VerifyOptions>();
        CLI::App* app =
            add("verify", "Check this installation against closed forms and known values",
                "--json > verification.json", options, verify_installation);
        app->add_option("NAME", options->names, "Beginnings of the checks' names; default all");
        app->add_flag("--list", options->list, "List the checks");
        auto* json = app->add_flag("--json", options->json, "Print JSON");
        app->add_flag("--markdown", options->markdown, "Print the page docs/verification.md")
            ->excludes(json);
    }
    void add_report() {
        auto options = std::make_shared<ReportOptions>();
        CLI::App* app = add("report", "Make report.html again from a result folder",
                            "results/single-gap-water", options, report);
        add_path(app, "DIR", options->folder, "Result folder", "DIR")->required();
    }
    void add_new() {
        auto options = std::make_shared<NewOptions>();
        CLI::App* app = add("new", "Print a commented case file to start from",
                            "single-gap > my-case.toml", options, new_case);
        app->add_option("GEOMETRY", options->geometry,
                        "single-gap, double-gap, din-bob, box or profile")
            ->required();
    }
    void add_schema() {
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
    void add_doctor() {
        CLI::App* app = program_.add_subcommand(
            "doctor", "Say which engines and libraries are there, and what is missing");
        app->group("Verbs");
        app->footer("Example: searle doctor");
        app->callback([this] { chosen_ = doctor; });
    }
    void add_stress() {
        auto options = std::make_shared<StressOptions>();
        CLI::App* app = add("stress", "Hold random scenes to the truth: what can break it",
                            "fluid --scenes 500 --seed 7 -o sweep", options, stress);
        app->add_option("NAME", options->families,
                        "fluid, extreme, particles, input (default: these), openfoam");
        app->add_option("--scenes", options->scenes, "Scenes of each family")
            ->capture_default_str();
        app->add_option("--seed", options->seed, "What they are drawn from")->capture_default_str();
        app->add_option("--minutes", options->minutes, "Stop after that time; 0: do not");
        app->add_option("--scene-seconds", options->scene_seconds,
                        "A scene that takes longer hangs")
            ->capture_default_str();
        add_path(app, "-o,--output", options->folder, "Folder for stress.csv and failures/", "DIR");
        app->add_flag("--json", options->json, "Print JSON");
        app->add_flag("--quiet", options->quiet, "Show no progress");
    }

    CLI::App program_{"A virtual rheometer: a case file in, a rheogram with error bars out",
                      "searle"};
    Verb chosen_;
};

int refuse(const std::string& message) {
    std::fputs(fmt::format("searle: {}\n", message).c_str(), stderr);
    return ExitCode::wrong_usage;
}

} // namespace

int run_command_line(int count, const char* const* words) {
    Grammar grammar;
    if (count < 2) {
        std::fputs(grammar.program().help().c_str(), stderr);
        return ExitCode::wrong_usage;
    }
    const std::string first = words[1];
    const std::vector<std::string> verbs = grammar.verb_names();
    if (!first.starts_with('-') && std::find(verbs.begin(), verbs.end(), first) == verbs.end()) {
        const auto meant = casefile::nearest_name(first, verbs);
        return refuse(fmt::format("there is no verb '{}'{}; `searle --help` lists them", first,
                                  meant ? fmt::format(" (did you mean '{}'?)", *meant) : ""));
    }
    try {
        grammar.program().parse(count, words);
    } catch (const CLI::Success& asked) { // --help and --version
        return grammar.program().exit(asked);
    } catch (const CLI::Error& error) {
        return refuse(fmt::format("{}; `searle {} --help` shows the usage", error.what(), first));
    }
    return with_failures_told(grammar.chosen());
}

} // namespace searle::app
