#include "reports/csv/csv_records.hpp"

#include "core/support/words.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace ff::reports {

std::string csv_field(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + "\"";
}

namespace {

std::string field(const Json& value) {
    if (value.is_null()) return {};
    if (value.is_string()) return csv_field(value.get_ref<const std::string&>());
    if (value.is_number_float()) return exact(value.get<double>());
    if (value.is_array()) return fmt::format("{}", fmt::join(value.get<std::vector<double>>(), ";"));
    return value.dump();
}

}  // namespace

CsvRecords::CsvRecords(std::ostream& out, std::string_view columns) : out_(out) {
    for (const std::string_view column : split_at(',', columns)) {
        const auto parts = split_at('=', column);
        out_ << (columns_.empty() ? "" : ",") << parts.front();
        const auto keys = split_at('/', parts.back());
        columns_.emplace_back(keys.begin(), keys.end());
    }
    out_ << '\n';
}

void CsvRecords::add(const Json& record) {
    std::vector<std::string> fields;
    for (const auto& keys : columns_) {
        const Json* value = &record;
        for (const std::string& key : keys) {
            if (!value->is_null()) value = &value->at(key);
        }
        fields.push_back(field(*value));
    }
    out_ << fmt::format("{}\n", fmt::join(fields, ","));
}

}  // namespace ff::reports
