#include "app/grammar.hpp"
#include "app/verb_check.hpp"
#include "app/verb_collect.hpp"
#include "app/verb_compare.hpp"
#include "app/verb_convert.hpp"
#include "app/verb_ends.hpp"
#include "app/verb_fit.hpp"
#include "app/verb_mesh.hpp"
#include "app/verb_new.hpp"
#include "app/verb_plan.hpp"
#include "app/verb_report.hpp"
#include "app/verb_run.hpp"

namespace searle::app {

void Grammar::add_run() {
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

void Grammar::add_collect() {
    auto options = std::make_shared<CollectOptions>();
    CLI::App* app = add("collect", "Read OpenFOAM cases that were run elsewhere: rheogram, report",
                        "results/din-bob.openfoam -o din-bob", options, collect);
    add_path(app, "DIR", options->engine_folder, "Folder that run --write-only wrote", "DIR")
        ->required();
    add_path(app, "-o,--output", options->folder,
             "Folder for the results; default DIR without .openfoam", "DIR");
    app->add_flag("--quiet", options->quiet, "Print nothing but errors");
    app->add_flag("--force", options->replace, "Replace results that are there already");
}

void Grammar::add_compare() {
    auto options = std::make_shared<CompareOptions>();
    CLI::App* app = add("compare", "Solve a case on several engines, side by side",
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

void Grammar::add_plan() {
    auto options = std::make_shared<PlanOptions>();
    CLI::App* app = add("plan", "Say what would be solved and what skipped, and why",
                        "cases/figure-3.toml", options, plan);
    add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
    add_overrides(app, options->overrides);
    app->add_flag("--json", options->json, "Print JSON");
}

void Grammar::add_check() {
    auto options = std::make_shared<CheckOptions>();
    CLI::App* app = add("check", "Read and validate a case only", "my-case.toml", options, check);
    add_path(app, "CASE", options->case_file, "Case file (TOML)")->required();
    add_overrides(app, options->overrides);
}

void Grammar::add_convert() {
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

void Grammar::add_fit() {
    auto options = std::make_shared<FitVerbOptions>();
    CLI::App* app = add("fit", "Fit flow laws to rheograms, or through the instrument",
                        "flow-curve.csv --model all -o fit.html", options, fit_laws);
    add_paths(app, "DATA", options->data_files,
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
    app->add_flag("--keep-all", options->keep_all, "Keep points with lag, vortices or end flow");
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

void Grammar::add_ends() {
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

void Grammar::add_mesh() {
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
    add_path(app, "--preview", options->preview, "Picture of section and patches, .svg or .png");
    add_path(app, "--drawing", options->drawing, "Dimensioned drawing, .svg or .png");
    app->add_flag("--json", options->json, "Print the checks as JSON");
    app->add_flag("--quiet", options->quiet, "Print nothing but faults");
}

void Grammar::add_report() {
    auto options = std::make_shared<ReportOptions>();
    CLI::App* app = add("report", "Make report.html again from a result folder",
                        "results/single-gap-water", options, report);
    add_path(app, "DIR", options->folder, "Result folder", "DIR")->required();
}

void Grammar::add_new() {
    auto options = std::make_shared<NewOptions>();
    CLI::App* app = add("new", "Print a commented case file to start from",
                        "single-gap > my-case.toml", options, new_case);
    app->add_option("GEOMETRY", options->geometry,
                    "single-gap, double-gap, din-bob, box or profile")
        ->required();
}

} // namespace searle::app
