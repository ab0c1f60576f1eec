#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace ff::reports {

/// Points (x, y), both positive, that share a name.
struct PlottedSeries {
    std::string name;
    std::vector<std::pair<double, double>> points;
};

/// A plot made of letters for a terminal, without colours and with logarithmic axes: the first series is drawn as a,
/// the next as b and so on, coinciding points as *. The ends of the x axis and the powers of ten of the y axis are
/// labelled; names follow below. Empty where all points share an x or a y.
/// @param width, height  of the drawing area, in characters
/// @pre at most 26 series
std::string text_plot(const std::vector<PlottedSeries>& all, std::size_t width = 56, std::size_t height = 12);

}  // namespace ff::reports
