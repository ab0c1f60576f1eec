#include "studies/readers/csv_reader.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::studies {

CsvReader::CsvReader(std::string_view text, std::string_view origin) : text_(text), origin_(origin) {
    if (text_.starts_with("\xef\xbb\xbf")) text_.remove_prefix(3);
    if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff"))
        throw UserError("{}:1:1: the file is in UTF-16 (UTF-8 is read). Save it as UTF-8.", origin);
}

bool CsvReader::at_line_end() const {
    return text_[place_] == '\n' || (text_[place_] == '\r' && place_ + 1 < text_.size() && text_[place_ + 1] == '\n');
}

void CsvReader::step() {
    const bool new_line = text_[place_++] == '\n';
    line_ += new_line ? 1 : 0;
    column_ = new_line ? 1 : column_ + 1;
}

void CsvReader::end_line() {
    while (text_[place_] != '\n') step();
    step();
}

bool CsvReader::next(std::vector<CsvField>& record) {
    while (!at_end() && at_line_end()) end_line();
    if (at_end()) return false;
    // Fields are filled again rather than made anew: files of millions of records are common.
    std::size_t fields = 0;
    const auto read_field = [&] {
        if (record.size() == fields) record.emplace_back();
        read(record[fields++]);
    };
    read_field();
    while (!at_end() && text_[place_] == ',') {
        step();
        read_field();
    }
    record.resize(fields);
    if (!at_end()) end_line();
    return true;
}

/// Ends before a comma, a line end or the end of the text.
void CsvReader::read(CsvField& field) {
    field.line = line_;
    field.column = column_;
    field.text.clear();
    if (!at_end() && text_[place_] == '"') return quoted(field);
    const std::size_t begin = place_;
    while (!at_end() && text_[place_] != ',' && !at_line_end()) ++place_;
    field.text.assign(text_.substr(begin, place_ - begin));
    column_ += place_ - begin;
}

void CsvReader::quoted(CsvField& field) {
    step();
    for (;;) {
        if (at_end())
            fail(field, "a quote is opened and never closed (the rest of the file would be one cell). Add \".");
        const bool quote = text_[place_] == '"';
        const bool doubled = quote && text_.substr(place_).starts_with("\"\"");
        if (quote && !doubled) break;
        if (doubled) step();
        field.text += text_[place_];
        step();
    }
    step();
    if (!at_end() && text_[place_] != ',' && !at_line_end())
        fail(field, "text follows a closing quote (a quote within quotes is written twice). Write \"\".");
}

void CsvReader::fail(const CsvField& field, std::string_view problem) const {
    throw UserError("{}:{}:{}: {}", origin_, field.line, field.column, problem);
}

std::string_view CsvReader::filled(const CsvField& field, std::string_view name) const {
    const std::string_view text = trimmed(field.text);
    if (text.empty()) fail(field, fmt::format("no {} (an empty cell). Fill it, or leave the line out.", name));
    return text;
}

std::vector<std::optional<std::size_t>> find_columns(const CsvReader& reader, const std::vector<CsvField>& header,
                                                     std::span<const std::string_view> names, OtherColumns others) {
    std::vector<std::optional<std::size_t>> places(names.size());
    for (std::size_t i = 0; i < header.size(); ++i) {
        const std::string_view text = trimmed(header[i].text);
        const auto known = std::find(names.begin(), names.end(), in_small_letters(text));
        if (known == names.end()) {
            if (others == OtherColumns::left_out && header.size() > 1) continue;
            reader.fail(header[i], fmt::format("column '{}' is unknown. {}The columns are {}, between commas.",
                                               excerpt(text), did_you_mean(text, names), fmt::join(names, ", ")));
        }
        auto& place = places[static_cast<std::size_t>(known - names.begin())];
        if (place) reader.fail(header[i], fmt::format("column '{}' stands twice. Keep one.", text));
        place = i;
    }
    return places;
}

}  // namespace ff::studies
