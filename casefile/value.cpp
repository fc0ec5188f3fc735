#include "casefile/value.hpp"

#include <algorithm>

namespace searle::casefile {

bool same_value(const Value& one, const Value& other) {
    if (one.is.index() != other.is.index())
        return false;
    if (const auto* quantity = std::get_if<Quantity>(&one.is)) {
        const auto& same = std::get<Quantity>(other.is);
        return quantity->value == same.value && quantity->kind == same.kind;
    }
    if (const auto* list = std::get_if<std::vector<Value>>(&one.is)) {
        const auto& same = std::get<std::vector<Value>>(other.is);
        return std::equal(list->begin(), list->end(), same.begin(), same.end(), same_value);
    }
    return std::visit(
        [&other](const auto& value) {
            using Type = std::remove_cvref_t<decltype(value)>;
            if constexpr (std::same_as<Type, Quantity> || std::same_as<Type, std::vector<Value>>)
                return false;
            else
                return value == std::get<Type>(other.is);
        },
        one.is);
}

} // namespace searle::casefile
