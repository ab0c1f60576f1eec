#pragma once

#include "reports/pictures/picture_values.hpp"

#include <string>
#include <vector>

namespace ff::reports {

enum class HeightAxis { linear, logarithmic };

/// Labels at the right ends of lines, instead of a legend. They depend on the range of the y axis.
class LineLabels {
  public:
    explicit LineLabels(HeightAxis axis) : axis_(axis) {}

    /// Extends the axis to a drawn value. @pre positive on a logarithmic axis
    void make_room(double value);
    /// @param method  gives the label's colour and symbol
    void add(std::string method, std::string text, double value);

    /// Sets the labels, moved apart until none overlap, and the range of the y axis.
    /// @param scales  the picture's other scales
    void set(PictureValues& values, nlohmann::ordered_json scales) const;

  private:
    struct Label {
        std::string method;
        std::string text;
        double height;
    };
    [[nodiscard]] double scaled(double value) const;
    [[nodiscard]] nlohmann::ordered_json value_at(double height) const;

    HeightAxis axis_;
    std::vector<double> heights_;
    std::vector<Label> labels_;
};

}  // namespace ff::reports
