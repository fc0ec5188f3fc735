#include "casefile/reading.hpp"

#include "casefile/nearest_name.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace searle::casefile {
namespace {

std::string path_to(const std::string& path, const std::string& name) {
    return path.empty() ? name : path + "." + name;
}

std::string listed(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

bool has_key(const KeySet& keys, const std::string& name) {
    if (keys.find(name))
        return true;
    return keys.selector &&
           std::any_of(keys.selector->alternatives.begin(), keys.selector->alternatives.end(),
                       [&name](const auto& one) { return one.keys->find(name) != nullptr; });
}

/// "fluid.density" for a density that stands elsewhere; empty when no section has such a key.
std::string section_with(const KeySet& whole_file, const std::string& name) {
    for (const Key& section : whole_file.keys)
        if (section.takes.table && has_key(*section.table, name))
            return fmt::format("{}.{}", section.name, name);
    return {};
}

/// Reads one table; knows which keys it may hold.
class TableReader {
public:
    TableReader(const KeySet& keys, const Node& table, std::string path, void* target,
                Reading& reading)
        : keys_{keys}, table_{table}, path_{std::move(path)}, target_{target}, reading_{reading} {}

    void read() {
        choose_alternative();
        if (chosen_)
            chosen_target_ = chosen_->open(target_);
        for (const Entry& entry : table_.entries)
            read_entry(entry);
        report_missing(keys_);
        if (chosen_)
            report_missing(*chosen_->keys);
        if (chosen_)
            run_checks(*chosen_->keys, chosen_target_);
        run_checks(keys_, target_);
    }

private:
    void fault(const Place& place, const std::string& key, std::string problem, std::string allowed,
               std::string suggestion = "") {
        reading_.faulty.insert(key);
        reading_.faults.push_back(
            {{place}, key, std::move(problem), std::move(allowed), std::move(suggestion)});
    }

    void note(const std::string& key, const Node& value) {
        reading_.places[key] = value.place;
        if (value.kind != Node::Kind::table && value.kind != Node::Kind::list)
            reading_.written[key] = value.kind == Node::Kind::text ? value.text : value.described();
    }

    void choose_alternative() {
        if (!keys_.selector)
            return;
        const Selector& selector = *keys_.selector;
        const std::string path = path_to(path_, selector.name);
        std::vector<std::string> names;
        for (const Selector::Alternative& alternative : selector.alternatives)
            names.push_back(alternative.name);
        const Entry* entry = table_.find(selector.name);
        if (!entry) {
            reading_.faulty.insert(path);
            if (reading_.reports_missing_keys)
                fault(table_.place, path, "is missing", listed(names));
            return;
        }
        note(path, entry->value);
        const std::string& name = entry->value.text;
        if (entry->value.kind == Node::Kind::text)
            for (const Selector::Alternative& alternative : selector.alternatives)
                if (alternative.name == name)
                    chosen_ = &alternative;
        if (chosen_)
            return;
        const auto nearest = nearest_name(name, names);
        fault(entry->value.place, path,
              fmt::format("{} is not one of the names", entry->value.described()), listed(names),
              nearest ? fmt::format("\"{}\"", *nearest) : "");
    }

    [[nodiscard]] std::vector<std::string> valid_names() const {
        std::vector<std::string> names;
        const auto add = [&names](const KeySet& keys) {
            for (const Key& key : keys.keys)
                if (std::find(names.begin(), names.end(), key.name) == names.end())
                    names.push_back(key.name);
        };
        if (keys_.selector) {
            names.push_back(keys_.selector->name);
            for (const Selector::Alternative& alternative : keys_.selector->alternatives)
                if (!chosen_ || chosen_ == &alternative)
                    add(*alternative.keys);
        }
        add(keys_);
        return names;
    }

    void read_entry(const Entry& entry) {
        if (keys_.selector && entry.key == keys_.selector->name)
            return;
        if (const Key* key = chosen_ ? chosen_->keys->find(entry.key) : nullptr)
            return read_key(*key, entry, chosen_target_);
        if (const Key* key = keys_.find(entry.key))
            return read_key(*key, entry, target_);
        const std::string path = path_to(path_, entry.key);
        if (has_key(keys_, entry.key)) {
            if (chosen_)
                fault(entry.key_place, path,
                      fmt::format("is not used with {} = \"{}\"", keys_.selector->name,
                                  chosen_->name),
                      listed(valid_names()));
            return;
        }
        const std::vector<std::string> names = valid_names();
        const std::string_view kind = path_.empty() ? "section" : "key";
        const bool is_section = path_.empty() && entry.value.kind == Node::Kind::table;
        std::string meant = nearest_name(entry.key, names).value_or("");
        if (meant.empty() && reading_.whole_file)
            meant = section_with(*reading_.whole_file, entry.key);
        fault(entry.key_place, path, fmt::format("there is no such {}", is_section ? kind : "key"),
              listed(names), std::move(meant));
    }

    void read_key(const Key& key, const Entry& entry, void* target) {
        const std::string path = path_to(path_, key.name);
        const Node& value = entry.value;
        note(path, value);
        const Takes& takes = key.takes;
        if (takes.free_table && value.kind == Node::Kind::table)
            return key.binding.keep(target, value);
        if (takes.table && value.kind == Node::Kind::table)
            return read_keys(*key.table, value, path, key.binding.open(target), reading_);
        if (takes.table_list && value.kind == Node::Kind::list)
            return read_tables(key, value, path, target);
        if (!key.binding.store) {
            fault(value.place, path, fmt::format("{} is {}", value.described(), value.kind_name()),
                  takes.table ? fmt::format("a section [{}]", path) : allowed_by(key));
            return;
        }
        if (const std::optional<Value> read = read_value(key, value, path, reading_))
            key.binding.store(target, *read);
        else
            reading_.faulty.insert(path);
    }

    void read_tables(const Key& key, const Node& list, const std::string& path, void* target) {
        if (list.items.size() < key.takes.fewest_items ||
            list.items.size() > key.takes.most_items) {
            fault(list.place, path, fmt::format("the list has {} items", list.items.size()),
                  fmt::format("{} to {} tables", key.takes.fewest_items, key.takes.most_items));
            return;
        }
        for (std::size_t at = 0; at < list.items.size(); ++at) {
            const Node& item = list.items[at];
            const std::string item_path = fmt::format("{}.{}", path, at + 1);
            if (item.kind == Node::Kind::table)
                read_keys(*key.table, item, item_path, key.binding.append(target), reading_);
            else
                fault(item.place, item_path,
                      fmt::format("{} is {}", item.described(), item.kind_name()), "a table");
        }
    }

    void report_missing(const KeySet& keys) {
        for (const Key& key : keys.keys) {
            if (!key.is_required || table_.find(key.name))
                continue;
            const std::string path = path_to(path_, key.name);
            reading_.faulty.insert(path);
            if (reading_.reports_missing_keys)
                fault(table_.place, path, path_.empty() ? "this section is missing" : "is missing",
                      path_.empty() && key.takes.table ? fmt::format("a section [{}]", key.name)
                                                       : allowed_by(key));
        }
    }

    void run_checks(const KeySet& keys, const void* target) {
        Findings findings{reading_, path_};
        for (const auto& check : keys.checks)
            check(target, findings);
    }

    const KeySet& keys_;
    const Node& table_;
    std::string path_;
    void* target_;
    Reading& reading_;
    const Selector::Alternative* chosen_ = nullptr;
    void* chosen_target_ = nullptr;
};

bool lies_within(const std::string& key, const std::string& outer) {
    return key.size() > outer.size() && key.starts_with(outer) && key[outer.size()] == '.';
}

} // namespace

bool Findings::is_faulty(const std::string& full_key) const {
    return std::any_of(reading_.faulty.begin(), reading_.faulty.end(),
                       [&](const std::string& faulty) {
                           return faulty == full_key || lies_within(full_key, faulty) ||
                                  lies_within(faulty, full_key);
                       });
}

bool Findings::given(const std::string& key) const {
    return reading_.places.contains(path_to(path_, key));
}

void Findings::contradiction(const std::vector<std::string>& keys, std::string problem,
                             std::string allowed) {
    Fault fault{{}, "", std::move(problem), std::move(allowed), ""};
    for (const std::string& key : keys) {
        const std::string full_key = path_to(path_, key);
        if (is_faulty(full_key))
            return;
        const auto place = reading_.places.find(full_key);
        if (place == reading_.places.end())
            continue;
        if (fault.key.empty())
            fault.key = full_key;
        fault.places.push_back(place->second);
    }
    if (fault.key.empty())
        fault.key = keys.empty() ? path_ : path_to(path_, keys.front());
    if (fault.places.empty() && reading_.places.contains(path_))
        fault.places.push_back(reading_.places.at(path_));
    reading_.faults.push_back(std::move(fault));
}

void read_keys(const KeySet& keys, const Node& table, const std::string& path, void* target,
               Reading& reading) {
    TableReader{keys, table, path, target, reading}.read();
}

} // namespace searle::casefile
