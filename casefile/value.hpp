#pragma once

#include "casefile/quantity.hpp"

#include <array>
#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace searle::casefile {

/// The value of a key as read: numbers and quantities in SI. A quantity of a key that takes a
/// single kind is a plain double; where several kinds are possible it says which one it is.
struct Value {
    std::variant<bool, std::int64_t, double, Quantity, std::string, std::vector<Value>> is;
};

[[nodiscard]] bool same_value(const Value& one, const Value& other);

/// How a member of a struct takes a value and gives it back.
template <class Member>
struct Slot;

template <>
struct Slot<double> {
    static void store(double& member, const Value& value) {
        if (const auto* whole = std::get_if<std::int64_t>(&value.is))
            member = static_cast<double>(*whole);
        else
            member = std::get<double>(value.is);
    }
    static std::optional<Value> load(double member) { return Value{member}; }
};

template <class Integer>
requires(std::integral<Integer> && !std::same_as<Integer, bool>) struct Slot<Integer> {
    static void store(Integer& member, const Value& value) {
        member = static_cast<Integer>(std::get<std::int64_t>(value.is));
    }
    static std::optional<Value> load(Integer member) {
        return Value{static_cast<std::int64_t>(member)};
    }
};

template <class Plain>
requires(std::same_as<Plain, bool> || std::same_as<Plain, std::string> ||
         std::same_as<Plain, Quantity>) struct Slot<Plain> {
    static void store(Plain& member, const Value& value) { member = std::get<Plain>(value.is); }
    static std::optional<Value> load(const Plain& member) { return Value{member}; }
};

/// Empty means that the key is absent, or has its word for that ("auto").
template <class Member>
struct Slot<std::optional<Member>> {
    static void store(std::optional<Member>& member, const Value& value) {
        if (std::holds_alternative<std::string>(value.is))
            member.reset();
        else
            Slot<Member>::store(member.emplace(), value);
    }
    static std::optional<Value> load(const std::optional<Member>& member) {
        return member ? Slot<Member>::load(*member) : std::nullopt;
    }
};

/// An empty list means that the key is absent.
template <class Item>
struct Slot<std::vector<Item>> {
    static void store(std::vector<Item>& member, const Value& value) {
        const auto& items = std::get<std::vector<Value>>(value.is);
        member.resize(items.size());
        for (std::size_t at = 0; at < items.size(); ++at)
            Slot<Item>::store(member[at], items[at]);
    }
    static std::optional<Value> load(const std::vector<Item>& member) {
        std::vector<Value> items;
        for (const Item& item : member)
            items.push_back(*Slot<Item>::load(item));
        return items.empty() ? std::nullopt : std::optional{Value{std::move(items)}};
    }
};

template <class Item, std::size_t Count>
struct Slot<std::array<Item, Count>> {
    static void store(std::array<Item, Count>& member, const Value& value) {
        const auto& items = std::get<std::vector<Value>>(value.is);
        for (std::size_t at = 0; at < Count; ++at)
            Slot<Item>::store(member[at], items.at(at));
    }
    static std::optional<Value> load(const std::array<Item, Count>& member) {
        std::vector<Value> items;
        for (const Item& item : member)
            items.push_back(*Slot<Item>::load(item));
        return Value{std::move(items)};
    }
};

} // namespace searle::casefile
