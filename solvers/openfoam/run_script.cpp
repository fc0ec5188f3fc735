#include "solvers/openfoam/run_script.hpp"

#include <fmt/format.h>

namespace searle::solvers::openfoam {
namespace {

/// A shell function that tells the solver to write and end once a row's torque stands still.
std::string watch_function(const CaseFacts& facts) {
    const bool is_box = std::holds_alternative<geometry::Box>(facts.scene.instrument);
    // A line of the function object: time (x y z) of the total, then of its parts.
    return fmt::format(R"(
# A residual may hang although nothing moves any more: a row whose torque has stayed within {share:.0e} of
# itself over {still} iterations is told to end.
watch_row() {{
    while sleep 1 && kill -0 $$ 2>/dev/null; do
        tail -n {still} "postProcessing/torque_bob/$1/{file}" 2>/dev/null | awk -F '[ \t()]+' '
            /^[^#]/ {{ v = ${column}; if (!n++) low = high = v; if (v < low) low = v; if (v > high) high = v }}
            END {{ size = high < 0 ? -high : high; exit !(n == {still} && high - low < {share:.0e} * size) }}
        ' || continue
        sed -i "s/^stopAt .*/stopAt          writeNow;/" system/controlDict
        return
    done
}}
)",
                       fmt::arg("share", settled_share), fmt::arg("still", settled_iterations),
                       fmt::arg("file", is_box ? "force.dat" : "moment.dat"),
                       fmt::arg("column", is_box ? 2 : 4));
}

/// A shell function that starts a row from the flow that the level before found for it.
std::string map_function(const CaseFacts& facts) {
    const bool parallel = facts.scene.solver.processors > 1;
    return fmt::format(
        R"sh(
# A row starts from what the level before found for it, where that was solved.
map_start() {{
    mapped=$((before + 1))
    latest=$(ls {first_place} | grep -E '^[0-9]+$' | sort -n | tail -n 1)
    [ -f ../{coarser}/$end/U ] || return 0
    [ "$latest" = $before ] || [ "$latest" = $mapped ] || return 0
    [ ! -f {first_place}/$mapped/phi ] || return 0
    for time in $(ls . | grep -E '^[0-9]+$'); do
        if [ $time -gt $before ]; then rm -rf $time; fi
    done
    mkdir -p $mapped
    cp 0/U 0/p $mapped
    {{ mapFields ../{coarser} -consistent -sourceTime $end{distribution}; }} >>log.mapFields 2>&1 || clear_start
}}
clear_start() {{
    for place in . {places}; do rm -rf "$place/$((before + 1))"; done
}}
)sh",
        fmt::arg("coarser", facts.coarser), fmt::arg("first_place", parallel ? "processor0" : "."),
        fmt::arg("places", parallel ? "processor*" : ""),
        fmt::arg("distribution", parallel ? " && decomposePar -fields -time $mapped" : ""));
}

std::string rows_text(const CaseFacts& facts, const std::string& run) {
    const bool has_coarser = !facts.coarser.empty();
    const bool parallel = facts.scene.solver.processors > 1;
    return (has_coarser ? map_function(facts) : std::string{}) +
           fmt::format(R"(
end=0
for row in $(seq 1 {rows}); do
    before=$end
    end=$((row * {iterations}))
    [ -d {first_place}$end ] && continue
{map}    prepare_start
    sed -i -e "s/^endTime .*/endTime         $end;/" -e "s/^stopAt .*/stopAt          endTime;/" \
        -e "s/^writeInterval .*/writeInterval   $((end - start));/" system/controlDict
    watch_row $start &
    watch=$!
    code=0
    {run} >>log.{application} 2>&1 || code=$?
    kill $watch 2>/dev/null || true
    wait $watch 2>/dev/null || true
    [ $code = 0 ] || exit $code
    # a row that ended early stands where the next one starts
    for place in {places}; do
        last=$(ls "$place" | grep -E '^[0-9]+$' | sort -n | tail -n 1)
        [ -f "$place/$last/phi" ] || {{ echo "$place/$last: not what {application} wrote" >&2; exit 1; }}
        [ "$last" = "$end" ] || mv "$place/$last" "$place/$end"
    done
{clear}done
)",
                       fmt::arg("map", has_coarser ? "    map_start\n" : ""),
                       fmt::arg("clear", has_coarser ? "    clear_start\n" : ""),
                       fmt::arg("rows", facts.plan.speeds.speeds.size()),
                       fmt::arg("iterations", facts.plan.iterations),
                       fmt::arg("first_place", parallel ? "processor0/" : ""), fmt::arg("run", run),
                       fmt::arg("application", name_of(facts.plan.application)),
                       fmt::arg("places", parallel ? "processor*" : "."));
}

/// A shell function that finds where the solver starts from, and removes what an earlier one wrote
/// from there before it was killed.
std::string start_function(bool parallel) {
    return fmt::format(R"(
prepare_start() {{
    start=$(ls {} | grep -E '^[0-9][0-9.e+-]*$' | sort -g | tail -n 1)
    rm -rf postProcessing/torque_bob/$start postProcessing/torque_cup/$start
}}
)",
                       parallel ? "processor0" : ".");
}

/// All of it in one run, on from where it stands.
std::string one_run_text(const CaseFacts& facts, const std::string& run) {
    return fmt::format(R"(
prepare_start
interval=$(awk "BEGIN {{ if ($start > 0 && $start < {end:.17g}) printf \"%.15g\", ({end:.17g} - $start) / {writes} }}")
[ -z "$interval" ] || sed -i "s/^writeInterval .*/writeInterval   $interval;/" system/controlDict
sed -i "s/^stopAt .*/stopAt          endTime;/" system/controlDict
{run} >>log.{application} 2>&1
)",
                       fmt::arg("end", end_time(facts)), fmt::arg("writes", writes_in_a_run),
                       fmt::arg("run", run),
                       fmt::arg("application", name_of(facts.plan.application)));
}

} // namespace

std::string run_script(const CaseFacts& facts) {
    const std::string_view application = name_of(facts.plan.application);
    const int count = facts.scene.solver.processors;
    const bool parallel = count > 1;
    const std::string run = parallel ? fmt::format("mpirun -np {} {} -parallel", count, application)
                                     : std::string(application);
    std::string text =
        "#!/bin/sh\n# Runs this case to its end, or on from where it stands; searle collect reads "
        "the result.\nset -eu\ncd \"$(dirname \"$0\")\"\n"
        ": \"${WM_PROJECT_DIR:?set it to the folder that holds etc/controlDict of OpenFOAM}\"\n";
    if (parallel)
        text += "[ -d processor0 ] || decomposePar >log.decomposePar 2>&1\n";
    text += start_function(parallel);
    text += runs_row_by_row(facts.plan) ? watch_function(facts) + rows_text(facts, run)
                                        : one_run_text(facts, run);
    if (parallel)
        text += fmt::format("reconstructPar{} >log.reconstructPar 2>&1\n",
                            runs_row_by_row(facts.plan) ? "" : " -latestTime");
    return text;
}

} // namespace searle::solvers::openfoam
