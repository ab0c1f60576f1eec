#pragma once

#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {

/// How a method is drawn in every picture of a report.
struct MethodStyle {
    std::string method;
    std::string colour;
    std::string symbol;
    bool in_colour = true;  ///< otherwise grey
};

/// One for each method, in the order of the study. With more than seven, colours go to the ones that a publication
/// compares, the random reference, the user's own, those that the answer names and those that most captions name, as
/// long as there are colours.
std::vector<MethodStyle> method_styles(const studies::StudyResults& results, const MethodChoice& choice = {});

/// Error and efficiency against evaluations, over these methods, for each class of pairs.
std::vector<Picture> pictures_of_scene(const studies::StudyResults& results, std::size_t scene,
                                       const std::vector<MethodStyle>& styles, const MethodChoice& methods = {});

/// The scales "color" and "shape" of a picture, for Picture::values.
Json style_scales(const std::vector<MethodStyle>& styles);

enum class HeightAxis { linear, logarithmic };

/// The lines of methods: colours and symbols, names by which one can be shown alone, and labels at the right ends of
/// those in colour instead of a legend. The names of those in grey are on the buttons below a picture. Labels depend on
/// the range of the y axis.
class MethodLines {
  public:
    MethodLines(std::vector<MethodStyle> styles, HeightAxis axis) : styles_(std::move(styles)), axis_(axis) {}

    /// Extends the axis to a drawn value; one that is infinite has no place. @pre positive on a logarithmic axis
    void make_room(double value);
    /// Begins a line. @param label  stands beside its last point
    void begin(const std::string& method, const std::string& label);
    /// Adds a point to the line. Intervals that reach below zero do not extend the axis.
    void add(double value, const std::optional<stats::Interval>& interval = {});
    /// Sets the labels, moved apart until none overlap, and the scales with the range of the y axis.
    void set(PictureValues& values) const;

  private:
    struct Line {
        std::string method;
        std::string label;
        std::optional<double> end;  ///< height of the last point; empty without points
    };
    [[nodiscard]] double scaled(double value) const;
    [[nodiscard]] Json value_at(double height) const;
    /// Labels of lines in colour. The heights are those of the labels.
    [[nodiscard]] std::vector<Line> labels_apart(double low, double high) const;
    [[nodiscard]] bool is_in_colour(const std::string& method) const;

    std::vector<MethodStyle> styles_;
    HeightAxis axis_;
    std::vector<double> heights_;
    std::vector<Line> lines_;
};

}  // namespace ff::reports
