#pragma once

#include "reports/text/json_values.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ff::reports {

/// A value's place along an axis of an SVG drawing, in its units.
class SvgAxis {
  public:
    /// @param from  where the least value is drawn, but for some room; @param to  where the largest is
    SvgAxis(bool log, double low, double high, double from, double to);
    [[nodiscard]] double at(double value) const;
    /// Four to about ten round numbers.
    [[nodiscard]] std::vector<double> ticks() const;

  private:
    [[nodiscard]] double scaled(double value) const;
    bool log_;
    double low_;
    double high_;
    double from_;
    double to_;
};

/// The drawing on a white ground. @param description  its text alternative
std::string svg_drawing(double width, double height, std::string_view description, std::string_view content);

/// Words at a place. @param attributes  " text-anchor=\"end\""; may be empty
std::string svg_text(double x, double y, std::string_view attributes, std::string_view words);

std::string svg_line(double x1, double x2, double y1, double y2, std::string_view attributes);

/// One row of a picture's values, column by name.
class PictureRow {
  public:
    PictureRow(const std::map<std::string, std::size_t>& columns, const Json& values)
        : columns_(columns), values_(values) {}
    [[nodiscard]] const Json& operator[](const std::string& column) const { return values_.at(columns_.at(column)); }
    [[nodiscard]] bool has(const std::string& column) const { return (*this)[column].is_number(); }
    [[nodiscard]] double number(const std::string& column) const { return (*this)[column].get<double>(); }
    [[nodiscard]] std::string words(const std::string& column) const { return (*this)[column].get<std::string>(); }

  private:
    const std::map<std::string, std::size_t>& columns_;
    const Json& values_;
};

/// The places of the columns in the rows of a picture's values.
std::map<std::string, std::size_t> picture_columns(const Json& values);

/// The colour of each method.
std::map<std::string, std::string> picture_colours(const Json& values);

}  // namespace ff::reports
