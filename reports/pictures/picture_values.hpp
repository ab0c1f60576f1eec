#pragma once

#include <nlohmann/json.hpp>

#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// The numbers of a picture, column by column named, as Picture::values wants them.
class PictureValues {
  public:
    explicit PictureValues(const std::vector<std::string>& columns);

    void add(nlohmann::ordered_json row) { json_["rows"].push_back(std::move(row)); }
    void set(const std::string& key, nlohmann::ordered_json value) { json_[key] = std::move(value); }
    [[nodiscard]] bool empty() const { return json_["rows"].empty(); }
    /// One line that may stand in a script element.
    [[nodiscard]] std::string text() const;

  private:
    nlohmann::ordered_json json_;
};

/// A number to draw, with no more significant digits than a picture shows; null for no value.
nlohmann::ordered_json drawn(std::optional<double> value, int digits = 6);

/// A part of a picture's id: what is neither letter nor digit becomes -.
std::string slug(const std::string& text);

}  // namespace ff::reports
