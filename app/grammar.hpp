#pragma once

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace searle::app {

using Verb = std::function<int()>;

/// The command line's grammar, and the verb that it chose.
class Grammar {
public:
    Grammar();

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

    // verbs of cases and results
    void add_run();
    void add_collect();
    void add_compare();
    void add_plan();
    void add_check();
    void add_convert();
    void add_fit();
    void add_ends();
    void add_mesh();
    void add_report();
    void add_new();
    // verbs of the program itself
    void add_bench();
    void add_verify();
    void add_schema();
    void add_doctor();
    void add_stress();

    CLI::App program_{"A virtual rheometer: a case file in, a rheogram with error bars out",
                      "searle"};
    Verb chosen_;
};

} // namespace searle::app
