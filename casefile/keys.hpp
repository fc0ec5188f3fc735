#pragma once

#include "casefile/key.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace searle::casefile {

/// A name in case files, and the enumerator it stands for.
template <class Enum>
struct Named {
    std::string name;
    Enum value;
    std::string meaning;
};

/// The keys that configure a `Target`, each bound to a member: a pointer to it, or a callable that
/// gives a reference to it from a reference to the target, const or not.
template <class Target>
class Keys {
public:
    /// @param initial  the target before any key is read; holds the defaults
    explicit Keys(Target initial = {})
        : initial_{std::move(initial)}, set_{std::make_shared<KeySet>()} {
        set_->defaults = [initial = initial_] { return std::make_shared<const Target>(initial); };
    }

    template <class Access>
    Key& key(std::string name, Access access) {
        using Member = std::remove_cvref_t<std::invoke_result_t<Access, Target&>>;
        return custom(
            std::move(name),
            [access](Target& target, const Value& value) {
                Slot<Member>::store(std::invoke(access, target), value);
            },
            [access](const Target& target) {
                return Slot<Member>::load(std::invoke(access, target));
            });
    }

    /// A key that takes one of several names; the member is an enumeration or an optional one.
    template <class Access, class Enum>
    Key& choice(std::string name, Access access, std::vector<Named<Enum>> names) {
        Key& key = custom(
            std::move(name),
            [access, names](Target& target, const Value& value) {
                for (const Named<Enum>& named : names)
                    if (named.name == std::get<std::string>(value.is))
                        std::invoke(access, target) = named.value;
            },
            [access, names](const Target& target) -> std::optional<Value> {
                for (const Named<Enum>& named : names)
                    if (std::invoke(access, target) == named.value)
                        return Value{named.name};
                return std::nullopt;
            });
        for (const Named<Enum>& named : names)
            key.takes.words.push_back({named.name, named.meaning});
        return key;
    }

    /// A key with its own way of storing and loading.
    Key& custom(std::string name, std::function<void(Target&, const Value&)> store,
                std::function<std::optional<Value>(const Target&)> load) {
        Key& key = declare(std::move(name));
        key.binding.store = [store = std::move(store)](void* target, const Value& value) {
            store(*static_cast<Target*>(target), value);
        };
        key.binding.load = [load = std::move(load)](const void* target) {
            return load(*static_cast<const Target*>(target));
        };
        return key;
    }

    /// A table of its own; the member is the struct that `keys` configure, or an optional one.
    template <class Access, class Nested>
    Key& table(std::string name, Access access, const Keys<Nested>& keys) {
        return or_table(declare(std::move(name)), access, keys);
    }

    /// Lets a key be a table as well, bound to another member.
    template <class Access, class Nested>
    Key& or_table(Key& key, Access access, const Keys<Nested>& keys) {
        using Member = std::remove_cvref_t<std::invoke_result_t<Access, Target&>>;
        key.takes.table = true;
        key.table = keys.set();
        if constexpr (std::same_as<Member, std::optional<Nested>>) {
            key.binding.open = [access, initial = keys.initial()](void* target) -> void* {
                return &std::invoke(access, *static_cast<Target*>(target)).emplace(initial);
            };
            key.binding.look = [access](const void* target) -> const void* {
                const auto& member = std::invoke(access, *static_cast<const Target*>(target));
                return member ? &*member : nullptr;
            };
        } else {
            key.binding.open = [access](void* target) -> void* {
                return &std::invoke(access, *static_cast<Target*>(target));
            };
            key.binding.look = [access](const void* target) -> const void* {
                return &std::invoke(access, *static_cast<const Target*>(target));
            };
        }
        return key;
    }

    /// A list of tables; the member is a vector of the struct that `keys` configure.
    template <class Access, class Nested>
    Key& tables(std::string name, Access access, const Keys<Nested>& keys) {
        Key& key = declare(std::move(name));
        key.takes.table_list = true;
        key.table = keys.set();
        key.binding.append = [access, initial = keys.initial()](void* target) -> void* {
            return &std::invoke(access, *static_cast<Target*>(target)).emplace_back(initial);
        };
        key.binding.count = [access](const void* target) -> std::size_t {
            return std::invoke(access, *static_cast<const Target*>(target)).size();
        };
        key.binding.item = [access](const void* target, std::size_t at) -> const void* {
            return &std::invoke(access, *static_cast<const Target*>(target))[at];
        };
        return key;
    }

    /// A table of any content; the member is an optional Node.
    template <class Access>
    Key& free_table(std::string name, Access access) {
        Key& key = declare(std::move(name));
        key.takes.free_table = true;
        key.binding.keep = [access](void* target, const Node& node) {
            std::invoke(access, *static_cast<Target*>(target)) = node;
        };
        return key;
    }

    /// The key that chooses among alternatives; say each with alternative().
    Keys& selector(std::string name, std::string sentence) {
        set_->selector.emplace(Selector{std::move(name), std::move(sentence), {}});
        return *this;
    }

    /// One value of the selector; the member is a variant that can hold an `Alternative`.
    template <class Alternative, class Access>
    Keys& alternative(std::string name, std::string meaning, Access access,
                      const Keys<Alternative>& keys) {
        set_->selector->alternatives.push_back(
            {std::move(name), std::move(meaning), keys.set(),
             [access, initial = keys.initial()](void* target) -> void* {
                 return &std::invoke(access, *static_cast<Target*>(target))
                             .template emplace<Alternative>(initial);
             },
             [access](const void* target) -> const void* {
                 return std::get_if<Alternative>(
                     &std::invoke(access, *static_cast<const Target*>(target)));
             }});
        return *this;
    }

    /// A relation between keys, looked at after all of them were read.
    Keys& check(std::function<void(const Target&, Findings&)> look) {
        set_->checks.push_back([look = std::move(look)](const void* target, Findings& findings) {
            look(*static_cast<const Target*>(target), findings);
        });
        return *this;
    }

    [[nodiscard]] std::shared_ptr<const KeySet> set() const { return set_; }
    [[nodiscard]] const Target& initial() const { return initial_; }

private:
    Key& declare(std::string name) {
        set_->keys.emplace_back().name = std::move(name);
        return set_->keys.back();
    }

    Target initial_;
    std::shared_ptr<KeySet> set_;
};

} // namespace searle::casefile
