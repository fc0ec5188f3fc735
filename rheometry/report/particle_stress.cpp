#include "rheometry/report/particle_stress.hpp"

#include "rheometry/report/number_text.hpp"
#include "rheometry/report/quantity.hpp"
#include "rheometry/report/rich_text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace searle::rheometry::report {

namespace {

struct Part {
    std::string_view name;
    double ParticleShares::*share;
};
constexpr std::array parts{
    Part{"spheres and films", &ParticleShares::hydrodynamic},
    Part{"contacts", &ParticleShares::contact}, Part{"colloid forces", &ParticleShares::dlvo},
    Part{"thermal motion", &ParticleShares::brownian}, Part{"inertia", &ParticleShares::inertia}};

/// "+11.7 %": a change with its sign, to a hundredth of a percent.
std::string change(double share) {
    if (!std::isfinite(share))
        return "\u2013";
    return (share < 0.0 ? "" : "+") + with_decimals(100.0 * share, 2) + "\u00a0%";
}

std::string size_of(double share) { return with_decimals(100.0 * share, 2) + "\u00a0%"; }

const RheogramPoint* fastest(const Rheogram& rheogram) {
    const auto found = std::ranges::max_element(
        rheogram.points, {}, [](const RheogramPoint& point) { return std::abs(point.shear_rate); });
    return found == rheogram.points.end() ? nullptr : &*found;
}

/// The point at this rate; null: there is none.
const RheogramPoint* point_at(const Rheogram& rheogram, double rate) {
    for (const RheogramPoint& point : rheogram.points)
        if (std::abs(point.shear_rate - rate) <= 1e-6 * std::abs(rate))
            return &point;
    return nullptr;
}

double error_share(const RheogramPoint& point) {
    return (std::abs(point.stress_error) + scatter_of(point)) / std::abs(point.shear_stress);
}

std::string made_of(const ParticleShares& shares) {
    std::string out;
    for (const Part& part : parts) {
        const double share = shares.*part.share;
        if (std::abs(share) < 5e-5)
            continue;
        out += (out.empty() ? "" : ", ") + std::string{part.name} + " " + change(share);
    }
    return out.empty() ? "no part is above 0.005\u00a0%" : out;
}

std::string einstein(const ParticlesNote& particles) {
    return "Drag alone carries no stress of rigid spheres: Einstein\u2019s 2.5 \u03c6, " +
           change(2.5 * particles.volume_fraction) +
           " of the fluid\u2019s stress and more as \u03c6 grows, is missing.";
}

/// "stress 0.2023 Pa ± 0.4 %, 1.122 times the fluid alone: ..."
std::string account(const RheogramPoint& point, const ParticleShares& shares) {
    return quantity_text(point.shear_stress, "Pa", 5) + " \u00b1 " + size_of(shares.whole_error) +
           ", " + significant(shares.whole, 5) + " times the fluid alone: " + made_of(shares);
}

std::string difference(const OverlayRun& one, const OverlayRun& base, double rate) {
    const RheogramPoint* here = point_at(one.rheogram, rate);
    const RheogramPoint* there = point_at(base.rheogram, rate);
    if (here == nullptr || there == nullptr)
        return "";
    const double ratio = here->shear_stress / there->shear_stress - 1.0;
    const double error = std::hypot(error_share(*here), error_share(*there));
    return one.name + " against " + base.name + " " + change(ratio) + " \u00b1 " + size_of(error) +
           (std::abs(ratio) <= 2.0 * error ? " (no difference that these runs can tell)" : "");
}

/// How the viscosity changes from half of the rate to the rate; empty where a run lacks a point.
std::string steepening(const OverlayRun& run, double rate) {
    const RheogramPoint* half = point_at(run.rheogram, 0.5 * rate);
    const RheogramPoint* full = point_at(run.rheogram, rate);
    if (half == nullptr || full == nullptr)
        return "";
    return run.name + " " + change(full->viscosity / half->viscosity - 1.0) + " \u00b1 " +
           size_of(std::hypot(error_share(*half), error_share(*full)));
}

std::string listed(const std::vector<std::string>& items) {
    std::string out;
    for (const std::string& item : items)
        if (!item.empty())
            out += (out.empty() ? "" : "; ") + item;
    return out;
}

std::string header(std::string_view first) {
    std::string out = "<thead><tr><th class=\"words\">" + std::string{first} +
                      "</th><th>stress<br><span class=\"unit\">Pa</span></th>"
                      "<th>error<br><span class=\"unit\">numerical, statistical</span></th>"
                      "<th>over the fluid alone</th>";
    for (const Part& part : parts)
        out += "<th>" + std::string{part.name} + "</th>";
    return out + "<th>independent<br>values</th></tr></thead><tbody>\n";
}

std::string row(const std::string& name_html, const RheogramPoint& point, const StressOfRate& law) {
    const ParticleShares shares = particle_shares(point, law);
    std::string out = "<tr><td class=\"words\">" + name_html + "</td>";
    const auto cell = [&out](const std::string& text) { out += "<td>" + text + "</td>"; };
    cell(significant_padded(point.shear_stress, 5));
    cell("\u00b1\u00a0" + size_of(shares.whole_error));
    cell(change(shares.whole - 1.0));
    for (const Part& part : parts)
        cell(change(shares.*part.share));
    cell(point.suspension ? significant(point.suspension->independent_values, 2) : "");
    return out + "</tr>\n";
}

std::string caption(int number, const std::string& what) {
    return "<p>Parts are those of the bulk, in percent of the stress of the fluid alone at that "
           "rate; "
           "inertia is what the wall shows beyond the bulk. Errors are one standard error, widened "
           "where the average is short.</p><div class=\"table scroll\"><table class=\"data\">"
           "<caption><b>Table " +
           std::to_string(number) + ".</b> " + what + "</caption>";
}

} // namespace

ParticleShares particle_shares(const RheogramPoint& point, const StressOfRate& law) {
    const double undefined = std::numeric_limits<double>::quiet_NaN();
    const double alone =
        law ? std::copysign(law(std::abs(point.shear_rate)), point.shear_rate) : 0.0;
    if (alone == 0.0)
        return {undefined, undefined, undefined, undefined, undefined, undefined, undefined};
    ParticleShares shares;
    shares.whole = point.shear_stress / alone;
    shares.whole_error = error_share(point);
    if (!point.suspension) {
        shares.inertia = (point.shear_stress - point.steady_stress) / alone;
        return shares;
    }
    const SuspensionStress& stress = *point.suspension;
    shares.hydrodynamic = stress.bulk_hydrodynamic / alone;
    shares.contact = stress.bulk_contact / alone;
    shares.dlvo = stress.bulk_dlvo / alone;
    shares.brownian = stress.bulk_brownian / alone;
    shares.inertia = (stress.total() - stress.bulk_total()) / alone;
    return shares;
}

std::vector<std::string> particle_remarks(const ParticlesNote& particles, const Rheogram& rheogram,
                                          const StressOfRate& law) {
    const RheogramPoint* point = fastest(rheogram);
    if (point == nullptr || point->shear_rate == 0.0)
        return {};
    std::string text = "At " + quantity_text(point->shear_rate, "1/s", 4) + " the stress is " +
                       account(*point, particle_shares(*point, law)) + ".";
    if (!particles.carries_stress)
        text += " " + einstein(particles);
    return {text};
}

std::vector<std::string> particle_remarks(const OverlayInput& input) {
    const OverlayRun* first_with_particles = nullptr;
    const OverlayRun* first_with_drag = nullptr;
    double rate = std::numeric_limits<double>::infinity();
    for (const OverlayRun& run : input.runs) {
        if (run.particles && first_with_particles == nullptr)
            first_with_particles = &run;
        if (run.particles && !run.particles->carries_stress && first_with_drag == nullptr)
            first_with_drag = &run;
        if (const RheogramPoint* point = fastest(run.rheogram))
            rate = std::min(rate, std::abs(point->shear_rate));
    }
    if (first_with_particles == nullptr)
        return {};
    std::vector<std::string> accounts;
    std::vector<std::string> differences;
    std::vector<std::string> steps;
    for (std::size_t k = 0; k < input.runs.size(); ++k) {
        const OverlayRun& run = input.runs[k];
        if (const RheogramPoint* point = point_at(run.rheogram, rate))
            accounts.push_back(run.name + " " +
                               account(*point, particle_shares(*point, run.fluid.true_stress)));
        if (k > 0)
            differences.push_back(difference(run, input.runs.front(), rate));
        if (k > 1)
            differences.push_back(difference(run, input.runs[k - 1], rate));
        steps.push_back(steepening(run, rate));
    }
    const std::string at = quantity_text(rate, "1/s", 4);
    std::vector<std::string> remarks;
    if (const std::string text = listed(accounts); !text.empty())
        remarks.push_back("Stress at " + at + ": " + text + ".");
    if (const std::string text = listed(differences); !text.empty())
        remarks.push_back("Where the runs differ at " + at + ": " + text + ".");
    if (const std::string text = listed(steps); !text.empty())
        remarks.push_back("How the curves steepen, viscosity from " +
                          quantity_text(0.5 * rate, "1/s", 4) + " to " + at + ": " + text + ".");
    if (first_with_drag != nullptr)
        remarks.push_back(einstein(*first_with_drag->particles));
    return remarks;
}

std::string particle_table(const ReportInput& input, int number) {
    std::string out = caption(number, "What the stress is made of.") + header("rate");
    for (const RheogramPoint& point : input.rheogram.points)
        out += row(quantity_text(point.shear_rate, "1/s", 4), point, input.fluid.true_stress);
    return out + "</tbody></table></div>\n";
}

std::string particle_table(const OverlayInput& input, int number) {
    std::string out =
        caption(number, "What the stress is made of, at the highest rate of each run.") +
        header("run");
    for (const OverlayRun& run : input.runs)
        if (const RheogramPoint* point = fastest(run.rheogram))
            out += row(escaped(run.name), *point, run.fluid.true_stress);
    return out + "</tbody></table></div>\n";
}

} // namespace searle::rheometry::report
