#include "app/fit_options.hpp"

#include "app/usage_error.hpp"
#include "casefile/nearest_name.hpp"
#include "rheometry/fit/prediction.hpp"
#include "rheometry/tables/number_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace searle::app {
namespace {

namespace fit = rheometry::fit;

std::vector<std::string_view> parts_of(std::string_view text, char delimiter) {
    std::vector<std::string_view> parts;
    while (true) {
        const std::size_t end = text.find(delimiter);
        parts.push_back(rheometry::trimmed(text.substr(0, end)));
        if (end == std::string_view::npos)
            return parts;
        text.remove_prefix(end + 1);
    }
}

double number_of(std::string_view word, std::string_view option) {
    const rheometry::NumberText number = rheometry::read_number(word);
    if (number.outcome != rheometry::NumberText::Outcome::number)
        throw UsageError(fmt::format("{}: \"{}\" is not a number", option, word));
    return number.value;
}

fit::Range range_of(std::string_view words, std::string_view option) {
    const auto ends = parts_of(words, ':');
    if (ends.size() != 2)
        throw UsageError(fmt::format("{} takes LOW:HIGH, not \"{}\"", option, words));
    const fit::Range range{number_of(ends[0], option), number_of(ends[1], option)};
    if (!(range.low <= range.high))
        throw UsageError(fmt::format("{}: {} is above {}", option, range.low, range.high));
    return range;
}

std::pair<std::string, std::string_view> assignment(std::string_view words, std::string_view option,
                                                    std::string_view shape) {
    const std::size_t sign = words.find('=');
    if (sign == std::string_view::npos)
        throw UsageError(fmt::format("{} takes {}, not \"{}\"", option, shape, words));
    return {std::string(rheometry::trimmed(words.substr(0, sign))), words.substr(sign + 1)};
}

} // namespace

fit::FitOptions fit_options_of(const FitVerbOptions& options) {
    fit::FitOptions result;
    result.weighting = fit::weighting_named(options.weights).value_or(fit::Weighting::custom);
    if (options.weights == "custom")
        throw UsageError("--weights takes relative, fitted, absolute, log, or the name of a column "
                         "with standard deviations");
    const auto loss = fit::loss_named(options.loss);
    if (!loss)
        throw UsageError(
            fmt::format("--loss takes none, huber or cauchy, not \"{}\"", options.loss));
    result.loss = *loss;
    for (const std::string& words : options.bounds) {
        const auto [name, range] = assignment(words, "--bounds", "NAME=LOW:HIGH");
        result.bounds[name] = range_of(range, "--bounds");
    }
    for (const std::string& words : options.held) {
        const auto [name, value] = assignment(words, "--fix", "NAME=VALUE");
        const double number = number_of(value, "--fix");
        result.bounds[name] = {number, number};
    }
    return result;
}

std::vector<fit::Model> laws_of(std::string_view names) {
    if (names == "all")
        return {fit::models().begin(), fit::models().end()};
    std::vector<fit::Model> laws;
    for (const std::string_view name : parts_of(names, ',')) {
        const fit::Model* law = fit::model_named(name);
        if (law == nullptr) {
            std::vector<std::string> known{"all"};
            std::string list;
            for (const fit::Model& each : fit::models()) {
                known.emplace_back(each.name);
                list += fmt::format("{}, ", each.name);
            }
            const auto meant = casefile::nearest_name(std::string(name), known);
            throw UsageError(
                fmt::format("--model: there is no law \"{}\"{}; allowed: {}all", name,
                            meant ? fmt::format(" (did you mean \"{}\"?)", *meant) : "", list));
        }
        laws.push_back(*law);
    }
    return laws;
}

fit::Selection selection_of(const FitVerbOptions& options) {
    fit::Selection selection;
    if (options.range)
        selection.rates = range_of(*options.range, "--range");
    selection.keep_disturbed = options.keep_all;
    return selection;
}

std::optional<std::string> deviation_column_of(const FitVerbOptions& options) {
    if (fit::weighting_named(options.weights))
        return std::nullopt;
    return options.weights;
}

std::vector<double> rates_of(std::string_view words, std::string_view option) {
    const auto parts = parts_of(words, ':');
    std::vector<double> rates;
    if (parts.size() == 3) {
        const double low = number_of(parts[0], option);
        const double high = number_of(parts[1], option);
        const double count = number_of(parts[2], option);
        if (!(low > 0.0 && high > low && count >= 2.0 && count <= 100000.0 &&
              count == std::floor(count)))
            throw UsageError(fmt::format(
                "{} LOW:HIGH:COUNT needs 0 < LOW < HIGH and 2 to 100000 rates", option));
        return fit::spread_rates(low, high, static_cast<std::size_t>(count));
    }
    if (parts.size() > 1)
        throw UsageError(
            fmt::format("{} takes LOW:HIGH:COUNT or R1,R2,..., not \"{}\"", option, words));
    for (const std::string_view word : parts_of(words, ',')) {
        rates.push_back(number_of(word, option));
        if (!(rates.back() > 0.0))
            throw UsageError(fmt::format("{}: {} is not a shear rate above 0", option, word));
    }
    return rates;
}

} // namespace searle::app
