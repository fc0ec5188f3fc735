#include "rheometry/fit/profile.hpp"

#include "rheometry/fit/nearby_search.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace searle::rheometry::fit {
namespace {

constexpr double relative_tolerance = 5e-3; ///< of the distance to the optimum
/// A lower sum of squares than this much below the minimum is a better optimum, not rounding.
constexpr double better_by = 1e-6;
/// The rise counts to a few parts in 1000, and a neighbour's optimum is a good start; where the
/// other parameters hardly matter, a search to the last digit would crawl for ever.
constexpr SearchEffort effort{.most_iterations = 25, .relative_decrease = 1e-6};

/// One point of the profile: parameter held, all others at their best.
struct ProfilePoint {
    double value{};
    double distance{}; ///< in standard deviations: sqrt of the rise over the variance
    std::vector<double> parameters;
};

class ProfileWalk {
public:
    ProfileWalk(const LeastSquaresProblem& problem, const Minimum& minimum, std::size_t index,
                double variance, std::span<const double> covariance)
        : problem_(problem), held_(problem), minimum_(minimum), index_(index), variance_(variance),
          covariance_(covariance) {}

    struct End {
        double value{};
        bool reached = true;
        std::vector<double> parameters;
    };

    End walk(double direction, double quantile) {
        const double optimum = minimum_.parameters[index_];
        const double bound = direction > 0.0 ? problem_.high[index_] : problem_.low[index_];
        ProfilePoint inside{optimum, 0.0, minimum_.parameters};
        if (bound == optimum)
            return {bound, false, minimum_.parameters};
        double step = first_step(quantile);
        ProfilePoint outside;
        // Outwards until the rise is large enough.
        for (int tries = 0;; ++tries) {
            double value = optimum + direction * step;
            const bool at_bound = direction * (value - bound) >= 0.0;
            if (at_bound)
                value = bound;
            outside = at(value, inside);
            if (better_ || outside.distance >= quantile)
                break;
            if (at_bound || tries > 60)
                return {bound, false, outside.parameters};
            const double growth = quantile / std::max(outside.distance, 0.2 * quantile);
            inside = outside;
            // Where a few strides do not help, most often nothing does up to the bound.
            const double most_growth = tries < 2 ? 5.0 : 50.0;
            step = std::abs(value - optimum) * std::clamp(1.02 * growth, 1.02, most_growth) *
                   (tries < 2 ? 1.0 : 10.0);
        }
        // Between the last two, the distance being close to linear in the value.
        double inside_miss = inside.distance - quantile;
        double outside_miss = outside.distance - quantile;
        for (int tries = 0; tries < 40 && !better_; ++tries) {
            const double share = inside_miss / (inside_miss - outside_miss);
            double value = inside.value + share * (outside.value - inside.value);
            if (std::abs(outside.distance - quantile) <= relative_tolerance * quantile &&
                outside_miss == outside.distance - quantile)
                return {value, true, outside.parameters};
            if (!(std::isfinite(value)))
                value = 0.5 * (inside.value + outside.value);
            if (std::abs(outside.value - inside.value) <=
                1e-12 * std::max(std::abs(optimum), std::abs(value)))
                return {value, true, outside.parameters};
            const ProfilePoint point = at(value, inside);
            const double miss = point.distance - quantile;
            if (std::abs(miss) <= relative_tolerance * quantile) {
                // The rest of the way along the chord.
                const ProfilePoint& other = miss < 0.0 ? outside : inside;
                const double other_miss = other.distance - quantile;
                return {point.value + miss / (miss - other_miss) * (other.value - point.value),
                        true, point.parameters};
            }
            if (miss < 0.0) {
                inside = point;
                inside_miss = miss;
                outside_miss *= 0.5; // Illinois: else one end may stay for ever
            } else {
                outside = point;
                outside_miss = miss;
                inside_miss *= 0.5;
            }
        }
        return {0.5 * (inside.value + outside.value), true, outside.parameters};
    }

    [[nodiscard]] const std::optional<Minimum>& better() const { return better_; }

private:
    [[nodiscard]] double first_step(double quantile) const {
        const std::size_t count = minimum_.parameters.size();
        const double optimum = std::abs(minimum_.parameters[index_]);
        if (!covariance_.empty()) {
            const double deviation = std::sqrt(covariance_[index_ * count + index_]);
            if (deviation > 0.0 && std::isfinite(deviation))
                return std::max(quantile * deviation, 1e-12 * optimum);
        }
        const double width = problem_.high[index_] - problem_.low[index_];
        return std::min(1e-3 * width, std::max(0.01 * optimum, 1e-6 * width));
    }

    /// The best other parameters, searched from where the neighbour's lead.
    ProfilePoint at(double value, const ProfilePoint& neighbour) {
        const std::size_t count = minimum_.parameters.size();
        std::vector<double> start = neighbour.parameters;
        const double optimum = minimum_.parameters[index_];
        if (neighbour.value != optimum) {
            // Along the straight line from the optimum through the neighbour.
            const double ratio = (value - optimum) / (neighbour.value - optimum);
            for (std::size_t i = 0; i < count; ++i)
                start[i] = minimum_.parameters[i] +
                           ratio * (neighbour.parameters[i] - minimum_.parameters[i]);
        } else if (!covariance_.empty() && covariance_[index_ * count + index_] > 0.0) {
            for (std::size_t i = 0; i < count; ++i)
                start[i] += covariance_[i * count + index_] / covariance_[index_ * count + index_] *
                            (value - optimum);
        }
        held_.low[index_] = value;
        held_.high[index_] = value;
        start[index_] = value;
        Minimum best = minimise_nearby(held_, start, effort);
        if (!std::isfinite(best.sum_of_squares)) {
            std::vector<double> from_optimum = minimum_.parameters;
            from_optimum[index_] = value;
            Minimum again = minimise_nearby(held_, from_optimum, effort);
            if (again.sum_of_squares < best.sum_of_squares)
                best = std::move(again);
        }
        held_.low[index_] = problem_.low[index_];
        held_.high[index_] = problem_.high[index_];
        const double rise = best.sum_of_squares - minimum_.sum_of_squares;
        if (rise < -better_by * minimum_.sum_of_squares)
            better_ = best;
        return {value, std::sqrt(std::max(0.0, rise) / variance_), std::move(best.parameters)};
    }

    const LeastSquaresProblem& problem_;
    LeastSquaresProblem held_;
    const Minimum& minimum_;
    std::size_t index_;
    double variance_;
    std::span<const double> covariance_;
    std::optional<Minimum> better_;
};

} // namespace

ProfileInterval profile_interval(const LeastSquaresProblem& problem, const Minimum& minimum,
                                 std::size_t index, double variance, double quantile,
                                 std::span<const double> covariance) {
    ProfileWalk walk(problem, minimum, index, variance, covariance);
    ProfileInterval interval;
    ProfileWalk::End low = walk.walk(-1.0, quantile);
    interval.low = low.value;
    interval.low_reached = low.reached;
    interval.at_low = std::move(low.parameters);
    if (!walk.better()) {
        ProfileWalk::End high = walk.walk(1.0, quantile);
        interval.high = high.value;
        interval.high_reached = high.reached;
        interval.at_high = std::move(high.parameters);
    }
    interval.better = walk.better();
    return interval;
}

} // namespace searle::rheometry::fit
