#include "casefile/reading.hpp"
#include "rheometry/protocol_keys.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace searle::rheometry {
namespace {

casefile::Keys<SpeedRange> range_keys(const casefile::QuantityKind& kind, const std::string& from,
                                      const std::string& to) {
    casefile::Keys<SpeedRange> keys;
    keys.key("from", &SpeedRange::from)
        .measures(kind)
        .at_least("-1e9")
        .at_most("1e9")
        .required()
        .example(from)
        .says("First speed.");
    keys.key("to", &SpeedRange::to)
        .measures(kind)
        .at_least("-1e9")
        .at_most("1e9")
        .required()
        .example(to)
        .says("Last speed.");
    keys.key("count", &SpeedRange::count)
        .is_integer()
        .at_least("2")
        .at_most("1000000")
        .required()
        .example("30")
        .says("Number of speeds, both ends included.");
    keys.choice<Spacing SpeedRange::*, Spacing>("spacing", &SpeedRange::spacing,
                                                {{"log", Spacing::logarithmic, "equal ratios"},
                                                 {"linear", Spacing::linear, "equal differences"}})
        .example("log")
        .says("How the speeds are spread.");
    keys.check([](const SpeedRange& range, casefile::Findings& findings) {
        if (range.spacing == Spacing::logarithmic && !(range.from * range.to > 0.0))
            findings.contradiction({"from", "to", "spacing"},
                                   "equal ratios need two speeds of one sign, neither of them 0",
                                   "spacing = \"linear\", or other speeds");
    });
    return keys;
}

void add_series(casefile::Keys<StepsAsWritten>& keys, const char* name,
                SpeedSeries StepsAsWritten::*series, const casefile::QuantityKind& kind,
                const std::string& low, const std::string& high, const char* sentence) {
    casefile::Key& key =
        keys.key(
                name, [series](auto& steps) -> auto& { return (steps.*series).listed; })
            .measures(kind)
            .at_least("-1e9")
            .at_most("1e9")
            .is_list(1, static_cast<std::size_t>(most_rows))
            .example(fmt::format("[\"{}\", \"{}\"]", low, high))
            .defaults_to("none; one of the three lists is given")
            .says(sentence);
    keys.or_table(
        key, [series](auto& steps) -> auto& { return (steps.*series).range; },
        range_keys(kind, low, high));
}

/// Of a valid series: a range in equal ratios never holds a 0, and says so itself if it is asked
/// to.
bool holds_zero(const SpeedSeries& series) {
    if (!series.range)
        return std::find(series.listed.begin(), series.listed.end(), 0.0) != series.listed.end();
    if (series.range->spacing == Spacing::logarithmic || series.range->count < 2)
        return false;
    const std::vector<double> speeds = speeds_of(*series.range);
    return std::find(speeds.begin(), speeds.end(), 0.0) != speeds.end();
}

void check_steps(const StepsAsWritten& steps, casefile::Findings& findings) {
    const std::vector<std::string> names{"shear_rates", "angular_velocities", "wall_speeds"};
    std::vector<std::string> given;
    for (const std::string& name : names)
        if (findings.given(name))
            given.push_back(name);
    if (given.empty())
        findings.contradiction(names, "the speeds are missing",
                               "one of shear_rates, angular_velocities and wall_speeds");
    if (given.size() > 1)
        findings.contradiction(given, "the speeds are given more than once",
                               "one of shear_rates, angular_velocities and wall_speeds");
    const std::pair<const char*, const SpeedSeries*> all[] = {
        {"shear_rates", &steps.shear_rates},
        {"angular_velocities", &steps.angular_velocities},
        {"wall_speeds", &steps.wall_speeds}};
    for (const auto& [name, series] : all)
        if (!steps.hold && holds_zero(*series))
            findings.contradiction({name, "hold"}, "a steady flow at speed 0 has no row",
                                   "speeds other than 0, or a hold in seconds");
    if (findings.given("hold") && findings.given("hold_strain"))
        findings.contradiction({"hold_strain", "hold"}, "the hold is given twice",
                               "hold or hold_strain");
    if (findings.given("discard_strain") && !findings.given("hold_strain"))
        findings.contradiction({"discard_strain"}, "there is no hold_strain that it is a part of",
                               "discard_strain beside hold_strain");
    if (steps.hold_strain && steps.discard_strain && *steps.discard_strain >= *steps.hold_strain)
        findings.contradiction({"discard_strain", "hold_strain"},
                               "nothing is left of the hold once the start is discarded",
                               "discard_strain < hold_strain");
}

} // namespace

casefile::Keys<StepsAsWritten> steps_keys() {
    casefile::Keys<StepsAsWritten> keys;
    add_series(keys, "shear_rates", &StepsAsWritten::shear_rates, casefile::shear_rate, "1 1/s",
               "1000 1/s", "The speeds as shear rates: a list, or from, to, count and spacing.");
    add_series(keys, "angular_velocities", &StepsAsWritten::angular_velocities,
               casefile::angular_velocity, "1 rpm", "100 rpm",
               "The speeds as angular velocities, in place of shear_rates.");
    add_series(keys, "wall_speeds", &StepsAsWritten::wall_speeds, casefile::speed, "1 mm/s",
               "1 m/s", "The speeds of the box's moving wall, in place of shear_rates.");
    keys.custom(
            "hold",
            [](StepsAsWritten& steps, const casefile::Value& value) {
                casefile::Slot<std::optional<double>>::store(steps.hold, value);
            },
            [](const StepsAsWritten& steps) -> std::optional<casefile::Value> {
                if (steps.hold_strain)
                    return std::nullopt;
                return steps.hold ? casefile::Value{*steps.hold}
                                  : casefile::Value{std::string{"steady"}};
            })
        .measures(casefile::duration)
        .above("0 s")
        .at_most("1e9 s")
        .word("steady", "until the flow is steady")
        .example("10 s")
        .says("How long each speed is held; the first one starts from rest.");
    keys.key("hold_strain", &StepsAsWritten::hold_strain)
        .is_number()
        .above("0")
        .at_most("1e9")
        .example("5")
        .defaults_to("none")
        .says("Strain that each speed is held for, in place of hold; for suspensions.");
    keys.custom(
            "discard_strain",
            [](StepsAsWritten& steps, const casefile::Value& value) {
                casefile::Slot<std::optional<double>>::store(steps.discard_strain, value);
            },
            [](const StepsAsWritten& steps) -> std::optional<casefile::Value> {
                if (!steps.hold_strain)
                    return std::nullopt;
                return steps.discard_strain ? casefile::Value{*steps.discard_strain}
                                            : casefile::Value{std::string{"auto"}};
            })
        .is_number()
        .at_least("0")
        .at_most("1e9")
        .word("auto", "as long as the start is seen")
        .example("auto")
        .defaults_to("auto")
        .says("Strain at the start of each hold_strain that no average includes.");
    keys.check(check_steps);
    return keys;
}

} // namespace searle::rheometry
