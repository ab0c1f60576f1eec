#pragma once

#include <nlohmann/json_fwd.hpp>

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// A cell of a CSV file; quoted where it has to be (RFC 4180).
std::string csv_field(std::string_view text);

/// A table of the records that results.json has too: their keys are its columns, so that each value is named once.
class CsvRecords {
  public:
    /// Writes the header.
    /// @param columns  separated by commas: KEY, or NAME=KEY/KEY for a value within an object or by another name
    CsvRecords(std::ostream& out, std::string_view columns);

    /// Writes a line. What is null, or within an object that is null, is empty.
    void add(const nlohmann::ordered_json& record);

  private:
    std::ostream& out_;
    std::vector<std::vector<std::string>> columns_;  ///< keys from the record inwards
};

}  // namespace ff::reports
