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

    /// Writes a line. What is null, or within an object that is null, is empty.
    void add(const Json& record);

  private:
    std::ostream& out_;
    std::vector<std::vector<std::string>> columns_;  ///< keys from the record inwards
};

}  // namespace ff::reports
