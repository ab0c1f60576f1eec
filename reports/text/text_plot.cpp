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

/// The end of an axis of counts: whole where that is short.
std::string count_text(double value) {
    return value < 1e6 ? fmt::format("{:g}", value) : fmt::format("{:.3g}", value);
}

/// What the letters mean, in lines of at most this width beside their indent.
std::string key(const std::vector<std::string>& entries, std::size_t indent, std::size_t width) {
    std::string out;
    std::size_t column = width;
    for (const std::string& entry : entries) {
        const bool fits = column + 3 + visible_length(entry) <= width;
        if (fits) {
            out += "   ";
            column += 3;
        } else {
            out += fmt::format("{}{:>{}}", out.empty() ? "" : "\n", "", indent);
            column = 0;
        }
        out += entry;
        column += visible_length(entry);
    }
    return out + "\n";
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
    std::vector<std::string> names;
    bool shared = false;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const char letter = static_cast<char>('a' + i);
        for (const auto& [at, value] : all[i].points) {
            char& place = rows[height - 1 - y.cell(value)][x.cell(at)];
            const bool is_free = place == ' ' || place == letter;
            shared = shared || !is_free;
            place = is_free ? letter : '*';
        }
        names.push_back(fmt::format("{} {}", letter, all[i].name));
    }
    if (shared) names.emplace_back("* several");

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
    const std::string first = count_text(x.low);
    out += fmt::format("{:>{}} └{}\n", "", margin, line);
    out += fmt::format("{:>{}}  {}{:>{}}\n", "", margin, first, count_text(x.high), width - first.size());
    return out + key(names, margin + 2, width);
}

}  // namespace ff::reports
