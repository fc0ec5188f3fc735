#include "casefile/writing.hpp"

#include "casefile/reading.hpp"
#include "casefile/toml_text.hpp"

#include <fmt/format.h>

namespace searle::casefile {
namespace {

bool is_measured(const Key& key) { return !key.takes.quantities.empty() && !key.takes.number; }

std::optional<Value> loaded(const Key& key, const void* target) {
    if (!key.binding.load)
        return std::nullopt;
    std::optional<Value> value = key.binding.load(target);
    if (!value && !key.word_for_absent.empty())
        value = Value{key.word_for_absent};
    return value;
}

class Writer {
public:
    explicit Writer(WritingStyle style) : annotated_{style == WritingStyle::annotated} {}

    void write_section(const KeySet& keys, const void* target, const std::string& path) {
        const Selector::Alternative* chosen = nullptr;
        if (keys.selector) {
            chosen = chosen_alternative(*keys.selector, target);
            write_selector(*keys.selector, *chosen);
            write_values(*chosen->keys, chosen->look(target));
        }
        write_values(keys, target);
        if (chosen)
            write_tables(*chosen->keys, chosen->look(target), path);
        write_tables(keys, target, path);
    }

    [[nodiscard]] const std::string& text() const { return text_; }

private:
    static const Selector::Alternative* chosen_alternative(const Selector& selector,
                                                           const void* target) {
        for (const Selector::Alternative& alternative : selector.alternatives)
            if (alternative.look(target))
                return &alternative;
        return &selector.alternatives.front();
    }

    void line(const std::string& assignment, const std::string& comment) {
        constexpr std::size_t comment_column = 36;
        text_ += assignment;
        if (annotated_ && !comment.empty()) {
            text_.append(
                assignment.size() < comment_column ? comment_column - assignment.size() : 1, ' ');
            text_ += "# " + comment;
        }
        text_ += '\n';
    }

    void write_selector(const Selector& selector, const Selector::Alternative& chosen) {
        std::string names;
        for (const Selector::Alternative& alternative : selector.alternatives)
            names += (names.empty() ? "" : " | ") + alternative.name;
        line(fmt::format("{} = {}", selector.name, quoted(chosen.name)), names);
    }

    void write_values(const KeySet& keys, const void* target) {
        for (const Key& key : keys.keys) {
            if (annotated_ && !key.is_in_new)
                continue;
            if (const std::optional<Value> value = loaded(key, target))
                line(fmt::format("{} = {}", key.name,
                                 annotated_ ? usual_text(key, *value) : value_as_toml(key, *value)),
                     comment_of(key));
            else if (key.binding.store && key.takes.table && key.binding.look(target))
                line(fmt::format("{} = {}", key.name,
                                 inline_table(*key.table, key.binding.look(target))),
                     comment_of(key));
            else if (annotated_ && key.is_offered_in_new)
                line(fmt::format("# {} = {}", key.name, example_as_toml(key)), comment_of(key));
        }
    }

    static std::string comment_of(const Key& key) {
        std::string names;
        if (key.takes.quantities.empty() && !key.takes.boolean && !key.takes.number)
            for (const Word& word : key.takes.words)
                names += (names.empty() ? "" : " | ") + word.name;
        return names.empty() ? key.sentence : fmt::format("{}: {}", names, key.sentence);
    }

    void write_tables(const KeySet& keys, const void* target, const std::string& path) {
        for (const Key& key : keys.keys) {
            if (annotated_ && !key.is_in_new)
                continue;
            const std::string key_path = path.empty() ? key.name : path + "." + key.name;
            if (key.takes.table && !key.binding.store) {
                if (const void* nested = key.binding.look(target)) {
                    header(fmt::format("[{}]", key_path), path.empty() ? key.sentence : "");
                    write_section(*key.table, nested, key_path);
                }
            } else if (key.takes.table_list) {
                for (std::size_t at = 0; at < key.binding.count(target); ++at) {
                    header(fmt::format("[[{}]]", key_path), "");
                    write_section(*key.table, key.binding.item(target, at), key_path);
                }
            }
        }
    }

    void header(const std::string& brackets, const std::string& comment) {
        if (!text_.empty())
            text_ += '\n';
        line(brackets, comment);
    }

    static std::string inline_table(const KeySet& keys, const void* target) {
        std::string text;
        for (const Key& key : keys.keys)
            if (const std::optional<Value> value = loaded(key, target))
                text += fmt::format("{}{} = {}", text.empty() ? " " : ", ", key.name,
                                    value_as_toml(key, *value));
        return "{" + text + " }";
    }

    bool annotated_;
    std::string text_;
};

} // namespace

std::string usual_text(const Key& key, const Value& value) {
    const std::string example = example_as_toml(key);
    const auto source = Source::of_override(example);
    if (const auto node = example.empty() ? std::nullopt : parse_toml_value(example, source, 1)) {
        Reading reading;
        const std::optional<Value> read = read_value(key, *node, key.name, reading);
        if (read && same_value(*read, value))
            return example;
    }
    return value_as_toml(key, value);
}

std::string quoted(const std::string& text) {
    std::string result = "\"";
    for (const char sign : text) {
        const auto code = static_cast<unsigned char>(sign);
        if (sign == '"' || sign == '\\')
            result += fmt::format("\\{}", sign);
        else if (code < 0x20U || code == 0x7fU)
            result += fmt::format("\\u{:04X}", code);
        else
            result += sign;
    }
    return result + "\"";
}

std::string value_as_toml(const Key& key, const Value& value) {
    if (const auto* list = std::get_if<std::vector<Value>>(&value.is)) {
        std::string text = "[";
        for (const Value& item : *list)
            text += (text.size() > 1 ? ", " : "") + value_as_toml(key, item);
        return text + "]";
    }
    if (const auto* truth = std::get_if<bool>(&value.is))
        return *truth ? "true" : "false";
    if (const auto* whole = std::get_if<std::int64_t>(&value.is))
        return fmt::format("{}", *whole);
    if (const auto* text = std::get_if<std::string>(&value.is))
        return quoted(*text);
    if (const auto* quantity = std::get_if<Quantity>(&value.is))
        return quoted(si_text(quantity->value, key.takes.quantities.at(quantity->kind)));
    const double number = std::get<double>(value.is);
    return is_measured(key) ? quoted(si_text(number, key.takes.quantities.front()))
                            : shortest(number);
}

std::string write_toml(const KeySet& keys, const void* target, WritingStyle style) {
    Writer writer{style};
    writer.write_section(keys, target, "");
    return writer.text();
}

} // namespace searle::casefile
