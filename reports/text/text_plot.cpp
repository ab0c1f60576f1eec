#include "reports/text/text_plot.hpp"

#include "core/support/contract.hpp"
#include "reports/text/folding.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace ff::reports {
namespace {

/// A logarithmic axis divided into cells.
struct Axis {
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    std::size_t cells = 0;

    void include(double value) {
        low = std::min(low, value);
        high = std::max(high, value);
    }
    [[nodiscard]] std::size_t cell(double value) const {
        const double share = std::log(value / low) / std::log(high / low);
        return static_cast<std::size_t>(std::lround(share * static_cast<double>(cells - 1)));
    }
};

/// Labels of the rows, the highest first: powers of ten, and the ends where none is near.
std::vector<std::string> row_labels(const Axis& y) {
    std::vector<std::string> labels(y.cells);
    const auto row = [&](double value) { return y.cells - 1 - y.cell(value); };
    const auto first = static_cast<int>(std::ceil(std::log10(y.low)));
    const auto last = static_cast<int>(std::floor(std::log10(y.high)));
    for (int power = first; power <= last; ++power)
        labels[row(std::pow(10.0, power))] = brief(std::pow(10.0, power), 2);
    const auto label_end = [&](std::size_t end, std::size_t neighbour, double value) {
        if (labels[end].empty() && labels[neighbour].empty()) labels[end] = brief(value, 2);
    };
    label_end(0, 1, y.high);
    label_end(y.cells - 1, y.cells - 2, y.low);
    return labels;
}

}  // namespace

std::string text_plot(const std::vector<PlottedSeries>& all, std::size_t width, std::size_t height) {
    FF_EXPECT(all.size() <= 26);
    Axis x;
    Axis y;
    x.cells = width;
    y.cells = height;
    for (const PlottedSeries& series : all) {
        for (const auto& [at, value] : series.points) {
            x.include(at);
            y.include(value);
        }
    }
    if (!(x.low < x.high) || !(y.low < y.high)) return {};

    std::vector<std::string> rows(height, std::string(width, ' '));
    std::string names;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const char letter = static_cast<char>('a' + i);
        for (const auto& [at, value] : all[i].points) {
            char& place = rows[height - 1 - y.cell(value)][x.cell(at)];
            place = place == ' ' || place == letter ? letter : '*';
        }
        names += fmt::format("{}{} {}", i == 0 ? "" : "   ", letter, all[i].name);
    }

    const auto labels = row_labels(y);
    std::size_t margin = 0;
    for (const std::string& label : labels) margin = std::max(margin, visible_length(label));
    std::string out;
    for (std::size_t i = 0; i < height; ++i) {
        rows[i].erase(rows[i].find_last_not_of(' ') + 1);
        out += fmt::format("{:>{}} {}{}\n", labels[i], margin, labels[i].empty() ? "│" : "┤", rows[i]);
    }
    std::string line;
    for (std::size_t i = 0; i < width; ++i) line += "─";
    const std::string first = fmt::format("{:g}", x.low);
    out += fmt::format("{:>{}} └{}\n", "", margin, line);
    out += fmt::format("{:>{}}  {}{:>{}}\n", "", margin, first, fmt::format("{:g}", x.high), width - first.size());
    return out + fmt::format("{:>{}}  {}\n", "", margin, names);
}

}  // namespace ff::reports
