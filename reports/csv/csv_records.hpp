#pragma once

#include "reports/json/json_values.hpp"

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// A table of the records that results.json has too: their keys are its columns, so that each value is named once.
class CsvRecords {
  public:
    /// Writes the header.
    /// @param columns  separated by commas: KEY, or NAME=KEY/KEY for a value within an object or by another name
    CsvRecords(std::ostream& out, std::string_view columns);

    /// Writes a line. What is null, or not in the record, is empty.
    void add(const Json& record);

  private:
    std::ostream& out_;
    std::vector<Json::json_pointer> columns_;
};

}  // namespace ff::reports
