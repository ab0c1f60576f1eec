#include "reports/csv/csv_records.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace ff::reports {
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
    std::istringstream list{std::string(columns)};
    for (std::string column; std::getline(list, column, ',');) {
        const std::string name = column.substr(0, column.find('='));
        out_ << (columns_.empty() ? "" : ",") << name;
        columns_.emplace_back('/' + (name == column ? name : column.substr(name.size() + 1)));
    }
    out_ << '\n';
}

void CsvRecords::add(const Json& record) {
    std::vector<std::string> fields;
    for (const auto& column : columns_) fields.push_back(record.contains(column) ? field(record.at(column)) : "");
    out_ << fmt::format("{}\n", fmt::join(fields, ","));
}

}  // namespace ff::reports
