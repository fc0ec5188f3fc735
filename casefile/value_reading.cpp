#include "casefile/nearest_name.hpp"
#include "casefile/reading.hpp"

#include <cmath>
#include <fmt/format.h>
#include <optional>

namespace searle::casefile {
namespace {

/// Why a value is not taken.
struct Refusal {
    std::string problem;
    std::string suggestion;
};
using Outcome = std::variant<Value, Refusal>;

std::vector<std::string> names_of(const std::vector<Word>& words) {
    std::vector<std::string> names;
    for (const Word& word : words)
        names.push_back(word.name);
    return names;
}

bool takes_only_words(const Takes& takes) {
    return takes.quantities.empty() && !takes.number && !takes.integer && !takes.boolean &&
           !takes.text;
}

std::optional<Refusal> out_of_bounds(const Takes& takes, double value, const Node& node) {
    const auto outside = [&](const Bound& bound, bool is_inside) -> std::optional<Refusal> {
        if (is_inside || (bound.included && value == bound.value))
            return std::nullopt;
        return Refusal{fmt::format("{} is not {}", node.described(), bounds_text(takes)), ""};
    };
    if (takes.lower)
        if (auto refusal = outside(*takes.lower, value > takes.lower->value))
            return refusal;
    if (takes.upper)
        if (auto refusal = outside(*takes.upper, value < takes.upper->value))
            return refusal;
    return std::nullopt;
}

Outcome bounded(const Takes& takes, double value, const Node& node, Value result) {
    if (auto refusal = out_of_bounds(takes, value, node))
        return *refusal;
    return result;
}

Outcome from_text(const Takes& takes, const Node& node) {
    if (takes.text)
        return Value{node.text};
    for (const Word& word : takes.words)
        if (word.name == node.text)
            return Value{node.text};
    const std::vector<std::string> words = names_of(takes.words);
    std::string nearest;
    if (const auto name = nearest_name(node.text, words))
        nearest = fmt::format("\"{}\"", *name);
    const bool starts_like_number = !node.text.empty() && node.text.find_first_of("0123456789") < 3;
    if (!takes.quantities.empty() && (takes.words.empty() || starts_like_number)) {
        const auto parsed = parse_quantity(node.text, takes.quantities);
        if (const auto* quantity = std::get_if<Quantity>(&parsed))
            return bounded(takes, quantity->value, node,
                           takes.quantities.size() == 1 ? Value{quantity->value}
                                                        : Value{*quantity});
        const auto& fault = std::get<QuantityFault>(parsed);
        if (takes.number && fault.problem == "has no unit")
            return Refusal{fmt::format("{} is a text, not a number", node.described()),
                           fmt::format("{} without quotes", node.text)};
        return Refusal{fmt::format("{} {}", node.described(), fault.problem),
                       fault.suggestion.empty() ? nearest
                                                : fmt::format("\"{}\"", fault.suggestion)};
    }
    if (takes_only_words(takes))
        return Refusal{fmt::format("{} is not one of the names", node.described()), nearest};
    if (takes.number || takes.integer || takes.boolean)
        return Refusal{fmt::format("{} is a text", node.described()),
                       nearest.empty() && starts_like_number
                           ? fmt::format("{} without quotes", node.text)
                           : nearest};
    return Refusal{fmt::format("{} is neither a quantity nor one of the names", node.described()),
                   nearest};
}

Outcome from_number(const Takes& takes, double value, const Node& node) {
    if (!std::isfinite(value))
        return Refusal{fmt::format("{} is not a finite number", node.described()), ""};
    if (takes.integer && !takes.number) {
        if (value != std::floor(value))
            return Refusal{fmt::format("{} is not a whole number", node.described()), ""};
        if (std::abs(value) >= 9.2e18)
            return Refusal{fmt::format("{} is too large", node.described()), ""};
        return bounded(takes, value, node, Value{static_cast<std::int64_t>(value)});
    }
    if (takes.number)
        return bounded(takes, value, node, Value{value});
    if (!takes.quantities.empty())
        return Refusal{fmt::format("{} has no unit", node.described()), ""};
    return Refusal{fmt::format("{} is a number", node.described()), ""};
}

Outcome from_scalar(const Takes& takes, const Node& node) {
    switch (node.kind) {
    case Node::Kind::text:
        return from_text(takes, node);
    case Node::Kind::integer:
        if (takes.integer && !takes.number)
            return bounded(takes, static_cast<double>(node.integer), node, Value{node.integer});
        return from_number(takes, static_cast<double>(node.integer), node);
    case Node::Kind::number:
        return from_number(takes, node.number, node);
    case Node::Kind::boolean:
        if (takes.boolean)
            return Value{node.boolean};
        break;
    default:
        break;
    }
    return Refusal{fmt::format("{} is {}", node.described(), node.kind_name()), ""};
}

} // namespace

std::optional<Value> read_value(const Key& key, const Node& node, const std::string& path,
                                Reading& reading) {
    const auto refuse = [&](const Node& at, Refusal refusal) {
        reading.faults.push_back({{at.place},
                                  path,
                                  std::move(refusal.problem),
                                  allowed_by(key),
                                  std::move(refusal.suggestion)});
    };
    const Takes& takes = key.takes;
    if (!takes.list) {
        Outcome outcome = from_scalar(takes, node);
        if (auto* value = std::get_if<Value>(&outcome))
            return std::move(*value);
        refuse(node, std::get<Refusal>(std::move(outcome)));
        return std::nullopt;
    }
    if (node.kind != Node::Kind::list) {
        refuse(node, {fmt::format("{} is not a list", node.described()), ""});
        return std::nullopt;
    }
    if (node.items.size() < takes.fewest_items || node.items.size() > takes.most_items) {
        refuse(node, {fmt::format("the list has {} item{}", node.items.size(),
                                  node.items.size() == 1 ? "" : "s"),
                      ""});
        return std::nullopt;
    }
    std::vector<Value> values;
    values.reserve(node.items.size());
    for (const Node& item : node.items) {
        Outcome outcome = from_scalar(takes, item);
        if (auto* value = std::get_if<Value>(&outcome))
            values.push_back(std::move(*value));
        else
            refuse(item, std::get<Refusal>(std::move(outcome)));
    }
    if (values.size() != node.items.size())
        return std::nullopt;
    return Value{std::move(values)};
}

} // namespace searle::casefile
