// How often the 95 % intervals of a fit hold the truth: synthetic flow curves of the contract's
// seven laws with relative normal noise.
//   bench_fit_coverage [DATA_SETS] [SEED] [relative|fitted|log]
// A parameter of a data set counts as identifiable when the standard error that the truth itself
// promises (from the information matrix at the truth, before any noise is drawn) is below 20 % of
// the parameter; intervals of all others are counted too, in a column of their own.

#include "rheometry/fit/fit.hpp"
#include "rheometry/fit/least_squares.hpp"
#include "rheometry/fit/prediction.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace {

namespace fit = searle::rheometry::fit;

class Draw {
public:
    explicit Draw(unsigned long seed) : engine_(seed) {}
    double uniform(double low, double high) {
        return low + (high - low) * std::uniform_real_distribution<double>()(engine_);
    }
    double logarithmic(double low, double high) {
        return std::exp(uniform(std::log(low), std::log(high)));
    }
    double normal() { return std::normal_distribution<double>()(engine_); }

private:
    std::mt19937_64 engine_;
};

std::vector<double> random_parameters(const fit::Model& law, double low, double high, Draw& draw) {
    const double middle = std::sqrt(low * high);
    const double size = draw.logarithmic(0.1, 100.0); // stress in the middle, Pa
    const double share = draw.uniform(0.1, 0.8);      // of it that is yield stress
    const double index = draw.uniform(0.2, 1.0);
    if (law.name == "newtonian")
        return {size / middle};
    if (law.name == "power-law")
        return {size / std::pow(middle, index), index};
    if (law.name == "bingham")
        return {share * size, (1.0 - share) * size / middle};
    if (law.name == "casson") {
        const double root = 1.0 - std::sqrt(share);
        return {share * size, root * root * size / middle};
    }
    if (law.name == "herschel-bulkley")
        return {share * size, (1.0 - share) * size / std::pow(middle, index), index};
    const double zero = size / middle;
    const double infinite = zero * draw.logarithmic(1e-4, 1e-1);
    const double time = 1.0 / draw.logarithmic(low * 2.0, high / 2.0);
    const double slope = draw.uniform(0.1, 0.8);
    if (law.name == "cross")
        return {zero, infinite, time, slope};
    return {zero, infinite, time, slope, draw.uniform(0.6, 3.0)};
}

/// Relative standard error of each parameter that the truth promises; infinite where it is
/// singular.
std::vector<double> promised_errors(const fit::Model& law, const std::vector<double>& truth,
                                    const std::vector<double>& rates, double noise) {
    const std::vector<double> search = law.search(truth);
    const std::size_t count = truth.size();
    std::vector<double> stresses(rates.size());
    std::vector<double> jacobian(rates.size() * count);
    law.stresses(search, rates, stresses, jacobian);
    for (std::size_t k = 0; k < rates.size(); ++k)
        for (std::size_t i = 0; i < count; ++i)
            jacobian[k * count + i] /= noise * stresses[k];
    const auto covariance =
        fit::inverse_normal_matrix(jacobian, count, std::vector<bool>(count, true));
    std::vector<double> errors(count, 1e300);
    for (std::size_t i = 0; i < count && covariance; ++i)
        errors[i] = std::sqrt((*covariance)[i * count + i]) *
                    fit::search_slope(law.parameters[i].transform, search[i]) / truth[i];
    return errors;
}

struct Count {
    int all = 0;
    int all_covered = 0;
    int identifiable = 0;
    int covered = 0;
    int below = 0; ///< identifiable, truth below the interval
};

} // namespace

int main(int count, char** words) {
    const int sets = count > 1 ? std::atoi(words[1]) : 2000;
    Draw draw(count > 2 ? std::strtoul(words[2], nullptr, 10) : 20240601UL);
    fit::FitOptions options;
    options.weighting =
        fit::weighting_named(count > 3 ? words[3] : "relative").value_or(fit::Weighting::relative);
    const std::vector<std::string> names{"newtonian",        "bingham", "power-law",     "casson",
                                         "herschel-bulkley", "cross",   "carreau-yasuda"};
    std::map<std::string, std::vector<Count>> counts;
    std::map<std::string, std::vector<double>> times;
    int not_converged = 0;
    for (int set = 0; set < sets; ++set) {
        const fit::Model& law =
            *fit::model_named(names[static_cast<std::size_t>(set) % names.size()]);
        const double decades = draw.uniform(1.0, 6.0);
        const double low = draw.logarithmic(1e-3, 1.0);
        const auto points = static_cast<std::size_t>(draw.uniform(10.0, 61.0));
        const double noise = draw.logarithmic(0.005, 0.05);
        fit::FlowData data;
        data.rates = fit::spread_rates(low, low * std::pow(10.0, decades), points);
        data.lines.assign(points, 0);
        const std::vector<double> truth = random_parameters(law, low, data.rates.back(), draw);
        for (const double rate : data.rates)
            data.stresses.push_back(law.stress(truth, rate) * (1.0 + noise * draw.normal()));
        const std::vector<double> promised = promised_errors(law, truth, data.rates, noise);

        const std::clock_t start = std::clock();
        const fit::FitResult result = fit::fit_flow_curve(law, data, options);
        times[std::string(law.name)].push_back(1e3 * double(std::clock() - start) / CLOCKS_PER_SEC);
        if (!result.converged)
            ++not_converged;
        auto& own = counts[std::string(law.name)];
        own.resize(truth.size());
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const fit::Estimate& estimate = result.estimates[i];
            const bool covered = truth[i] >= estimate.low && truth[i] <= estimate.high;
            ++own[i].all;
            own[i].all_covered += covered ? 1 : 0;
            if (promised[i] < 0.2) {
                ++own[i].identifiable;
                own[i].covered += covered ? 1 : 0;
                own[i].below += truth[i] < estimate.low ? 1 : 0;
            }
        }
    }
    std::printf("%d data sets, weights %s, not converged: %d\n", sets,
                std::string(fit::name_of(options.weighting)).c_str(), not_converged);
    std::printf("%-17s %-20s %6s %8s %9s %7s %6s %6s %9s\n", "law", "parameter", "sets", "covered",
                "deviation", "(sigma)", "below", "above", "all sets");
    for (const std::string& name : names) {
        const fit::Model& law = *fit::model_named(name);
        for (std::size_t i = 0; i < counts[name].size(); ++i) {
            const Count& each = counts[name][i];
            const double share = double(each.covered) / std::max(1, each.identifiable);
            const double sigma = std::sqrt(0.95 * 0.05 / std::max(1, each.identifiable));
            std::printf("%-17s %-20s %6d %7.2f%% %8.2f%% %7.2f %6d %6d %8.2f%%\n", name.c_str(),
                        law.parameters[i].key.c_str(), each.identifiable, 100.0 * share,
                        100.0 * (share - 0.95), (share - 0.95) / sigma, each.below,
                        each.identifiable - each.covered - each.below,
                        100.0 * double(each.all_covered) / std::max(1, each.all));
        }
        std::vector<double>& own = times[name];
        std::sort(own.begin(), own.end());
        if (!own.empty())
            std::printf(
                "%-17s processor time per fit: median %.2f ms, 99 %% %.2f ms, longest %.2f ms\n",
                name.c_str(), own[own.size() / 2], own[own.size() * 99 / 100], own.back());
    }
    return 0;
}
