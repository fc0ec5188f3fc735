#include "app/stress/family_cases.hpp"

#include <fmt/format.h>

#include <cmath>

namespace searle::app {
namespace {

struct Range {
    double low;
    double high;
    [[nodiscard]] double log(Draw& draw) const { return draw.log_between(low, high); }
    [[nodiscard]] double even(Draw& draw) const { return draw.between(low, high); }
};

/// What scenes are drawn from.
struct SceneRanges {
    Range ratio;     ///< of the radii, less 1
    Range rate;      ///< 1/s
    Range viscosity; ///< Pa s
    Range index;     ///< flow index
    Range bingham;   ///< yield stress over viscous stress at the middle rate
    Range duration;  ///< of the times that the gap's inertia takes
    Range steady_accuracy;
    Range accuracy; ///< in time
};

/// What an instrument is used for.
constexpr SceneRanges usual{.ratio = {0.005, 2.0},
                            .rate = {0.01, 1e3},
                            .viscosity = {1e-3, 30.0},
                            .index = {0.2, 1.8},
                            .bingham = {1e-3, 1e4},
                            .duration = {1.0, 3000.0},
                            .steady_accuracy = {1e-10, 1e-1},
                            .accuracy = {1e-5, 1e-1}};

/// The same around a bob's ends.
constexpr SceneRanges usual_with_ends{.ratio = usual.ratio,
                                      .rate = {0.1, 50.0},
                                      .viscosity = usual.viscosity,
                                      .index = {0.4, 1.0},
                                      .bingham = {1e-2, 10.0},
                                      .duration = usual.duration,
                                      .steady_accuracy = {1e-3, 1e-1},
                                      .accuracy = {1e-3, 1e-1}};

/// Beyond what anybody would measure: the program has to know what it cannot do.
constexpr SceneRanges absurd{.ratio = {1e-3, 9.0},
                             .rate = {1e-6, 1e6},
                             .viscosity = {1e-5, 1e5},
                             .index = {0.1, 2.0},
                             .bingham = {1e-6, 1e6},
                             .duration = {1e-6, 1e8},
                             .steady_accuracy = {1e-10, 1e-1},
                             .accuracy = {1e-10, 1e-1}};

/// What OpenFOAM does within a minute: it has no yield surface, and steps where time is stiff.
constexpr SceneRanges coarse{.ratio = {0.01, 1.0},
                             .rate = {0.1, 100.0},
                             .viscosity = {1e-3, 10.0},
                             .index = {0.4, 1.3},
                             .bingham = {1e-2, 1.0},
                             .duration = {3.0, 1000.0},
                             .steady_accuracy = {1e-2, 1e-1},
                             .accuracy = {1e-2, 1e-1}};

/// The same around a bob's ends, where the secondary flow would take it minutes: thick fluids.
constexpr SceneRanges coarse_with_ends{.ratio = coarse.ratio,
                                       .rate = {0.1, 10.0},
                                       .viscosity = {1.0, 30.0},
                                       .index = {0.5, 1.0},
                                       .bingham = {1e-2, 1.0},
                                       .duration = coarse.duration,
                                       .steady_accuracy = {1e-2, 1e-1},
                                       .accuracy = {1e-2, 1e-1}};

struct Instrument {
    std::string name;
    std::string text;
    double gap{};            ///< m, the widest
    double rate_per_speed{}; ///< about, for times
};

Instrument draw_instrument(Draw& draw, const SceneRanges& ranges) {
    const double bob = draw.log_between(5e-3, 40e-3);
    const double ratio = 1.0 + ranges.ratio.log(draw);
    const double kind = draw.unit();
    if (kind < 0.5)
        return {
            "single-gap",
            fmt::format("type = \"single-gap\"\nbob_radius = \"{:.9g} m\"\ncup_radius = \"{:.9g} "
                        "m\"\nheight = \"{:.6g} m\"\n",
                        bob, bob * ratio, draw.between(1.0, 5.0) * bob),
            bob * (ratio - 1.0), 1.0 / (ratio - 1.0)};
    if (kind < 0.65) {
        const double inner = 1.0 + draw.log_between(0.005, 0.3);
        const double rotor = 1.0 + draw.log_between(0.02, 0.3);
        const double outer = 1.0 + draw.log_between(0.005, 0.3);
        const double radii[] = {bob, bob * inner, bob * inner * rotor, bob * inner * rotor * outer};
        return {"double-gap",
                fmt::format("type = \"double-gap\"\nradii = [\"{:.9g} m\", \"{:.9g} m\", \"{:.9g} "
                            "m\", \"{:.9g} m\"]\nheight = \"{:.6g} m\"\n",
                            radii[0], radii[1], radii[2], radii[3], 2.0 * bob),
                radii[3] - radii[2], 1.0 / (outer - 1.0)};
    }
    if (kind < 0.9) {
        const double gap = draw.log_between(50e-6, 5e-3);
        return {"box",
                fmt::format("type = \"box\"\ngap = \"{:.9g} m\"\nlength = \"{:.6g} m\"\nwidth = "
                            "\"{:.6g} m\"\n",
                            gap, 20.0 * gap, 10.0 * gap),
                gap, 1.0 / gap};
    }
    return {"din-bob",
            fmt::format("type = \"din-bob\"\nbob_radius = \"{:.9g} m\"\nradius_ratio = {:.6g}\n",
                        bob, 1.0 + draw.log_between(0.02, 0.5)),
            0.1 * bob, 10.0};
}

struct Fluid {
    std::string name;
    std::string text;
    double viscosity{}; ///< Pa s, about, at the middle rate
};

Fluid draw_fluid(Draw& draw, double rate, const SceneRanges& ranges) {
    const double viscosity = ranges.viscosity.log(draw);
    const double index = ranges.index.even(draw);
    const double consistency = viscosity * std::pow(rate, 1.0 - index);
    const double yield = ranges.bingham.log(draw) * viscosity * rate;
    const double density = draw.between(700.0, 2500.0);
    const auto with_density = [&](std::string name, const std::string& text) {
        return Fluid{
            name,
            fmt::format("model = \"{}\"\n{}density = \"{:.6g} kg/m^3\"\n", name, text, density),
            viscosity};
    };
    switch (draw.integer(0, 6)) {
    case 0:
        return with_density("newtonian", fmt::format("viscosity = \"{:.9g} Pa.s\"\n", viscosity));
    case 1:
        return with_density("bingham",
                            fmt::format("yield_stress = \"{:.9g} Pa\"\nplastic_viscosity "
                                        "= \"{:.9g} Pa.s\"\n",
                                        yield, viscosity));
    case 2:
        return with_density("power-law",
                            fmt::format("consistency = \"{:.9g} Pa.s^n\"\nflow_index = {:.6g}\n",
                                        consistency, index));
    case 3:
        return with_density("herschel-bulkley",
                            fmt::format("yield_stress = \"{:.9g} Pa\"\nconsistency = \"{:.9g} "
                                        "Pa.s^n\"\nflow_index = {:.6g}\n",
                                        draw.chance(0.1) ? 0.0 : yield, consistency, index));
    case 4:
        return with_density("casson",
                            fmt::format("yield_stress = \"{:.9g} Pa\"\nplastic_viscosity = "
                                        "\"{:.9g} Pa.s\"\n",
                                        yield, viscosity));
    case 5:
        return with_density(
            "carreau-yasuda",
            fmt::format("zero_viscosity = \"{:.9g} Pa.s\"\ninfinite_viscosity = \"{:.9g} "
                        "Pa.s\"\ntime_constant = \"{:.6g} s\"\nflow_index = {:.6g}\ntransition = "
                        "{:.6g}\n",
                        viscosity * draw.log_between(1.0, 1e3),
                        viscosity * draw.log_between(1e-3, 1.0),
                        draw.log_between(0.01, 100.0) / rate, draw.between(0.2, 0.95),
                        draw.between(0.5, 3.0)));
    default:
        return with_density(
            "cross", fmt::format("zero_viscosity = \"{:.9g} Pa.s\"\ninfinite_viscosity = \"{:.9g} "
                                 "Pa.s\"\ntime_constant = \"{:.6g} s\"\nflow_index = {:.6g}\n",
                                 viscosity * draw.log_between(1.0, 1e3),
                                 viscosity * draw.log_between(1e-3, 1.0),
                                 draw.log_between(0.01, 100.0) / rate, draw.between(0.1, 0.9)));
    }
}

/// @param lag  s, about the time that the gap's inertia takes
std::string draw_protocol(Draw& draw, double rate, double lag, const SceneRanges& ranges,
                          std::string& name) {
    const double time = lag * ranges.duration.log(draw);
    const double kind = draw.unit();
    if (kind < 0.5) {
        name = "steady";
        std::string rates;
        for (int at = draw.integer(1, 4); at > 0; --at)
            rates += fmt::format("{}\"{:.6g} 1/s\"", rates.empty() ? "" : ", ",
                                 rate * draw.log_between(0.01, 100.0));
        return fmt::format("type = \"steps\"\nshear_rates = [{}]\nhold = \"steady\"\n", rates);
    }
    if (kind < 0.75) {
        name = "ramp";
        const bool from_rest = draw.chance(0.8);
        return fmt::format(
            "type = \"ramp\"\nfrom = \"{:.6g} 1/s\"\nto = \"{:.6g} 1/s\"\nduration = "
            "\"{:.6g} s\"\npoints = {}\n",
            from_rest ? 0.0 : 0.3 * rate, rate, time, draw.integer(1, 30));
    }
    if (kind < 0.9) {
        name = "up-down";
        return fmt::format("type = \"segments\"\nsegments = [{{ to = \"{0:.6g} 1/s\", duration = "
                           "\"{1:.6g} s\", points = {2} }}, {{ to = \"{3:.6g} 1/s\", duration = "
                           "\"{1:.6g} s\", points = {2} }}]\n",
                           rate, time, draw.integer(1, 15),
                           draw.chance(0.6) ? 0.0 : rate * draw.between(-0.5, 0.5));
    }
    name = "jumps";
    return fmt::format("type = \"steps\"\nshear_rates = [\"{:.6g} 1/s\", \"{:.6g} 1/s\"]\nhold = "
                       "\"{:.6g} s\"\n",
                       rate, rate * draw.between(0.1, 2.0), time);
}

RandomCase draw_scene(Draw& draw, const SceneRanges& without_ends, const SceneRanges& with_ends) {
    const Instrument instrument = draw_instrument(draw, without_ends);
    const SceneRanges& ranges = instrument.name == "din-bob" ? with_ends : without_ends;
    const double rate = ranges.rate.log(draw);
    const Fluid fluid = draw_fluid(draw, rate, ranges);
    const double lag = 1e3 * instrument.gap * instrument.gap / fluid.viscosity / 3.0;
    std::string protocol_name;
    const std::string protocol =
        draw_protocol(draw, rate, std::max(lag, 1e-9), ranges, protocol_name);
    const double accuracy =
        (protocol_name == "steady" ? ranges.steady_accuracy : ranges.accuracy).log(draw);
    RandomCase result;
    result.kind = fmt::format("{} {} {}", instrument.name, fluid.name, protocol_name);
    result.text = fmt::format("[geometry]\n{}\n[fluid]\n{}\n[protocol]\n{}\n[solver]\naccuracy = "
                              "{:.4g}\n{}",
                              instrument.text, fluid.text, protocol, accuracy,
                              draw.chance(0.15) ? "model = \"radial\"\n" : "");
    return result;
}

} // namespace

RandomCase fluid_case(Draw& draw) { return draw_scene(draw, usual, usual_with_ends); }

RandomCase extreme_case(Draw& draw) { return draw_scene(draw, absurd, absurd); }

RandomCase openfoam_case(Draw& draw) {
    RandomCase result;
    do
        result = draw_scene(draw, coarse, coarse_with_ends);
    while (result.text.ends_with("model = \"radial\"\n"));
    result.text += "engine = \"openfoam\"\n";
    if (result.kind.starts_with("din-bob") || result.kind.ends_with("steady") || draw.chance(0.5))
        return result;
    result.kind += " forced";
    result.text += fmt::format("time_step = \"{:.3g} s\"\n\n[mesh]\ncells_across_gap = {}\n",
                               draw.log_between(1e-4, 10.0), draw.integer(2, 60));
    return result;
}

} // namespace searle::app
