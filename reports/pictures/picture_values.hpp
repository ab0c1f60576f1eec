#pragma once

#include "reports/pictures/pictures.hpp"
#include "reports/text/json_values.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// JSON on one line that is safe in a script element.
std::string json_in_html(const Json& json);

/// The numbers of a picture, by named columns, in the form of Picture::values.
class PictureValues {
  public:
    explicit PictureValues(const std::vector<std::string>& columns);

    void add(Json row) { json_["rows"].push_back(std::move(row)); }
    void set(const std::string& key, Json value) { json_[key] = std::move(value); }
    [[nodiscard]] bool empty() const { return json_["rows"].empty(); }
    [[nodiscard]] std::string text() const { return json_in_html(json_); }

  private:
    Json json_;
};

/// A number to draw, rounded to the digits that a picture shows; null for no value.
Json drawn(std::optional<double> value, int digits = 6);

/// The same of an end of an interval.
Json drawn_low(const std::optional<stats::Interval>& interval);
Json drawn_high(const std::optional<stats::Interval>& interval);

/// A picture of these numbers. @param id  any text; `slug` makes the id of it
/// @param shown  what is drawn, in sentences, which the description gives before the finding
Picture picture_of(const PictureValues& values, std::string_view kind, const std::string& id, std::string title,
                   std::string finding, std::string_view shown);

/// The same for a cell with this label. @param title  ends with the label
Picture picture_of_cell(const PictureValues& values, std::string_view kind, std::size_t cell, const std::string& label,
                        std::string_view title, std::string finding, std::string_view shown);

/// A part of a picture's id: characters other than letters and digits become -.
std::string slug(const std::string& text);

}  // namespace ff::reports
