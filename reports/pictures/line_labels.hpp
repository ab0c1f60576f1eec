#pragma once

#include "reports/pictures/method_styles.hpp"
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
    void set(PictureValues& values, Json scales) const;

  private:
    struct Label {
        std::string method;
        std::string text;
        double height;
    };
    [[nodiscard]] double scaled(double value) const;
    [[nodiscard]] Json value_at(double height) const;

    HeightAxis axis_;
    std::vector<double> heights_;
    std::vector<Label> labels_;
};

/// The lines of methods: colours and symbols, names by which one can be shown alone, and labels of those in colour. The
/// names of those in grey are on the buttons below a picture.
class MethodLines {
  public:
    MethodLines(std::vector<MethodStyle> styles, HeightAxis axis) : styles_(std::move(styles)), labels_(axis) {}

    void make_room(double value) { labels_.make_room(value); }
    /// For an interval that a logarithmic axis can show.
    void make_room(const std::optional<stats::Interval>& interval);
    /// Ends a line at the height `last`. @param text  its label
    void add(const std::string& method, const std::string& text, double last);
    void set(PictureValues& values) const;

  private:
    std::vector<MethodStyle> styles_;
    LineLabels labels_;
    std::vector<std::string> methods_;
};

}  // namespace ff::reports
