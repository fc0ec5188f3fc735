#include "rheometry/tables/csv_scanner.hpp"

#include <stdexcept>

namespace searle::rheometry {

bool CsvScanner::at_line_end() const {
    return position_ == text_.size() || text_[position_] == '\n' || text_[position_] == '\r';
}

void CsvScanner::pass_line_end() {
    if (position_ == text_.size())
        return;
    const bool carriage_return = text_[position_++] == '\r';
    if (carriage_return && position_ < text_.size() && text_[position_] == '\n')
        ++position_;
    ++line_;
}

void CsvScanner::skip_lines_without_data() {
    while (position_ < text_.size()) {
        const std::size_t start = position_;
        const std::size_t data = text_.find_first_not_of(delimiter_ == '\t' ? " " : " \t", start);
        position_ = data == std::string_view::npos ? text_.size() : data;
        const bool comment = position_ < text_.size() && text_[position_] == '#';
        if (!comment && !at_line_end()) {
            position_ = start;
            return;
        }
        const std::size_t line_end = text_.find_first_of("\r\n", position_);
        position_ = line_end == std::string_view::npos ? text_.size() : line_end;
        pass_line_end();
    }
}

std::string_view CsvScanner::quoted_field() {
    const std::size_t opening_line = line_;
    const std::size_t start = ++position_;
    bool doubled = false;
    while (true) {
        const std::size_t found = text_.find_first_of("\"\r\n", position_);
        if (found == std::string_view::npos) {
            line_ = opening_line;
            throw std::invalid_argument("a quote opens here and is never closed");
        }
        position_ = found;
        if (text_[found] != '"') {
            pass_line_end();
            continue;
        }
        ++position_;
        if (position_ == text_.size() || text_[position_] != '"')
            break;
        doubled = true;
        ++position_;
    }
    const std::string_view inside = text_.substr(start, position_ - 1 - start);
    while (position_ < text_.size() && text_[position_] == ' ')
        ++position_;
    if (!at_line_end() && text_[position_] != delimiter_)
        throw std::invalid_argument("text follows a closing quote; allowed there: the delimiter or "
                                    "the end of the line (a quote inside quotes is written twice)");
    if (!doubled)
        return inside;
    std::string& field = unescaped_.emplace_back();
    for (std::size_t i = 0; i < inside.size(); ++i) {
        field += inside[i];
        if (inside[i] == '"')
            ++i;
    }
    return field;
}

std::string_view CsvScanner::plain_field() {
    const std::size_t start = position_;
    while (!at_line_end() && text_[position_] != delimiter_) {
        if (text_[position_] == '"')
            throw std::invalid_argument(
                "a quote inside a field; a field that holds one is quoted as a whole");
        ++position_;
    }
    return text_.substr(start, position_ - start);
}

bool CsvScanner::next(CsvRecord& record) {
    skip_lines_without_data();
    if (position_ == text_.size())
        return false;
    record.fields.clear();
    record.line = line_;
    while (true) {
        const std::size_t quote = text_.find_first_not_of(' ', position_);
        if (quote != std::string_view::npos && text_[quote] == '"') {
            position_ = quote;
            record.fields.push_back(quoted_field());
        } else {
            record.fields.push_back(plain_field());
        }
        if (at_line_end())
            break;
        ++position_;
    }
    pass_line_end();
    return true;
}

namespace {

std::string_view from_first_line_of_data(std::string_view text) {
    while (!text.empty()) {
        const std::size_t line_end = text.find_first_of("\r\n");
        const std::size_t data = text.find_first_not_of(" \t");
        if (data < line_end && text[data] != '#')
            return text;
        text.remove_prefix(line_end == std::string_view::npos ? text.size() : line_end + 1);
    }
    return text;
}

} // namespace

char delimiter_of(std::string_view text) {
    bool quoted = false;
    bool semicolon = false;
    for (const char character : from_first_line_of_data(text)) {
        if (character == '"')
            quoted = !quoted;
        if (quoted)
            continue;
        if (character == '\t')
            return '\t';
        if (character == '\n' || character == '\r')
            break;
        semicolon = semicolon || character == ';';
    }
    return semicolon ? ';' : ',';
}

} // namespace searle::rheometry
