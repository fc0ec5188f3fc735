#include "solvers/fit_instrument/end_factors.hpp"

#include "solvers/axisymmetric/creeping_swirl.hpp"
#include "solvers/fit_instrument/side_by_side.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace searle::solvers::fit_instrument {
namespace {

using rheometry::fit::Model;
using rheometry::fit::Transform;

// Flow indices of the backbone; beyond them c_L hardly changes.
constexpr double lowest_index = 0.04;
constexpr double highest_index = 1.2;
constexpr int index_degree = 6;
/// Rate at the ends over that at the bob's wall: with it the backbone is nearest to c_L for
/// Herschel-Bulkley, Bingham, Casson and Carreau fluids alike.
constexpr double end_rate_share = 0.28;

/// The estimated error is small enough after two levels nearly always. Of laws whose stress levels
/// off, the energies' gap stays open however fine the level: it is not waited for.
constexpr int most_levels = 3;

constexpr int first_degree = 2;
constexpr int last_degree = 16;
/// Twice the points lower the error by this at least.
constexpr double gain_of_doubling = 4.0;
/// A range of speeds narrower than this, in ln(speed), is widened to it.
constexpr double narrowest_range = 0.5;
/// Step of the derivatives, of logarithms and pure numbers; of stresses, over the lowest one.
constexpr double step_size = 1e-4;

/// ln(speed) of both ends of the range to solve in.
struct LogRange {
    double low{};
    double high{};
};

LogRange range_of(std::span<const double> speeds) {
    const auto [slowest, fastest] = std::ranges::minmax(speeds);
    const double widened = std::max(0.0, 0.5 * (narrowest_range - std::log(fastest / slowest)));
    return {std::log(slowest) - widened, std::log(fastest) + widened};
}

} // namespace

BobEnds::BobEnds(const geometry::DinBob& bob, std::span<const double> speeds, double accuracy,
                 ProgressSink progress)
    : bob_(bob), accuracy_(accuracy), progress_(std::move(progress)),
      gap_({bob.bob_radius, bob.cup_radius}, {speeds.begin(), speeds.end()}) {
    std::vector<Task> tasks;
    for (const double index : chebyshev_points(lowest_index, highest_index, index_degree))
        tasks.push_back({laws::flow::PowerLaw{1.0, index}, 1.0});
    power_laws_.emplace(lowest_index, highest_index, solved(tasks));
    relative_error_ = std::numeric_limits<double>::infinity();
}

std::vector<double> BobEnds::solved(const std::vector<Task>& tasks) {
    std::vector<axisymmetric::CreepingTorque> found(tasks.size());
    double done = 0.0;
    side_by_side(
        tasks.size(),
        [&](std::size_t k) {
            found[k] =
                axisymmetric::creeping_torque(bob_, tasks[k].law, tasks[k].speed,
                                              {.accuracy = accuracy_, .most_levels = most_levels});
        },
        [&] {
            if (progress_)
                progress_(std::min(0.95, ++done / double(tasks.size())), "ends of the bob");
        });
    std::vector<double> logarithms;
    relative_error_ = 0.0;
    for (const axisymmetric::CreepingTorque& torque : found) {
        logarithms.push_back(std::log(torque.end_factor));
        relative_error_ = std::max(relative_error_, torque.error / torque.torque);
        reached_ = reached_ && torque.error <= accuracy_ * torque.torque;
        ++solutions_;
    }
    return logarithms;
}

std::vector<double> BobEnds::backbone(const Model& law, std::span<const double> search,
                                      const GapCurve& gap) const {
    const std::vector<double> values = law.values(search);
    std::vector<double> logarithms;
    for (std::size_t k = 0; k < gap.speeds().size(); ++k) {
        const GapResponse flow = gap.at(k, law, search, 0.0, false);
        const double index = flow.inner_rate > 0.0
                                 ? law.log_slope(values, end_rate_share * flow.inner_rate)
                                 : lowest_index;
        logarithms.push_back(power_laws_->at(std::clamp(index, lowest_index, highest_index)));
    }
    return logarithms;
}

std::vector<double> BobEnds::rest_at(const Model& law, std::span<const double> search,
                                     const std::vector<double>& points) {
    const auto here = law.for_solvers(law.values(search));
    if (!here)
        throw std::invalid_argument("BobEnds: the solvers do not know this law");
    std::vector<Task> tasks;
    std::vector<double> speeds;
    for (const double log_speed : points) {
        speeds.push_back(std::exp(log_speed));
        tasks.push_back({*here, speeds.back()});
    }
    std::vector<double> rest = solved(tasks);
    const GapCurve gap({bob_.bob_radius, bob_.cup_radius}, speeds);
    const std::vector<double> guess = backbone(law, search, gap);
    for (std::size_t k = 0; k < rest.size(); ++k)
        rest[k] -= guess[k];
    return rest;
}

void BobEnds::solve(const Model& law, std::span<const double> search) {
    const auto [low, high] = range_of(gap_.speeds());
    ChebyshevCurve curve(low, high,
                         rest_at(law, search, chebyshev_points(low, high, first_degree)));
    double own_error = relative_error_;
    double between = 0.0;
    for (int degree = 2 * first_degree; degree <= last_degree; degree *= 2) {
        const std::vector<double> points = chebyshev_points(low, high, degree);
        std::vector<double> added;
        for (std::size_t k = 1; k < points.size(); k += 2)
            added.push_back(points[k]);
        const std::vector<double> rest = rest_at(law, search, added);
        own_error = std::max(own_error, relative_error_);
        double miss = 0.0;
        std::vector<double> values;
        for (std::size_t k = 0; k < points.size(); ++k) {
            values.push_back(k % 2 == 0 ? curve.values()[k / 2] : rest[k / 2]);
            miss = std::max(miss, std::abs(curve.at(points[k]) - values.back()));
        }
        curve = {low, high, std::move(values)};
        between = miss / gain_of_doubling;
        if (between <= accuracy_)
            break;
    }
    rest_ = std::move(curve);
    relative_error_ = own_error + between;
    solved_backbone_ = backbone(law, search, gap_);
}

double BobEnds::change_since_solution(const Model& law, std::span<const double> search) const {
    if (!rest_)
        return std::numeric_limits<double>::infinity();
    const std::vector<double> now = backbone(law, search, gap_);
    double largest = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k)
        largest = std::max(largest, std::abs(now[k] - solved_backbone_[k]));
    return largest;
}

EndFactors BobEnds::at(const Model& law, std::span<const double> search) const {
    EndFactors result;
    result.search.assign(search.begin(), search.end());
    const std::vector<double> here = backbone(law, search, gap_);
    const std::span<const double> speeds = gap_.speeds();
    for (std::size_t k = 0; k < speeds.size(); ++k)
        result.values.push_back(std::exp(here[k] + (rest_ ? rest_->at(std::log(speeds[k])) : 0.0)));
    result.slopes.resize(speeds.size() * law.size());
    const std::vector<double> values = law.values(search);
    const double lowest_stress = law.stress(values, *std::ranges::min_element(speeds));
    for (std::size_t i = 0; i < law.size(); ++i) {
        const bool is_stress =
            law.parameters[i].unit == "Pa" && law.parameters[i].transform == Transform::identity;
        // Forwards: a stress may be 0, and no index is at the upper end of its range but 1.
        double step = step_size * (is_stress ? lowest_stress : 1.0);
        if (law.parameters[i].key == "flow_index" && search[i] > 0.5)
            step = -step;
        std::vector<double> there(search.begin(), search.end());
        there[i] += step;
        const std::vector<double> moved = backbone(law, there, gap_);
        for (std::size_t k = 0; k < speeds.size(); ++k)
            result.slopes[k * law.size() + i] = (moved[k] - here[k]) / step;
    }
    return result;
}

} // namespace searle::solvers::fit_instrument
