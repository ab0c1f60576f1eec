#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// JSON on one line that is safe in a script element.
std::string json_in_html(const nlohmann::ordered_json& json);

/// The numbers of a picture, by named columns, in the form of Picture::values.
class PictureValues {
  public:
    explicit PictureValues(const std::vector<std::string>& columns);

    void add(nlohmann::ordered_json row) { json_["rows"].push_back(std::move(row)); }
    void set(const std::string& key, nlohmann::ordered_json value) { json_[key] = std::move(value); }
    [[nodiscard]] bool empty() const { return json_["rows"].empty(); }
    [[nodiscard]] std::string text() const { return json_in_html(json_); }

  private:
    nlohmann::ordered_json json_;
};

/// A number to draw, rounded to the digits that a picture shows; null for no value.
nlohmann::ordered_json drawn(std::optional<double> value, int digits = 6);

/// A part of a picture's id: characters other than letters and digits become -.
std::string slug(const std::string& text);

}  // namespace ff::reports
