#include "reports/pictures/line_labels.hpp"

#include "core/support/contract.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ff::reports {

double LineLabels::scaled(double value) const {
    return axis_ == HeightAxis::logarithmic ? std::log(value) : value;
}

Json LineLabels::value_at(double height) const {
    return drawn(axis_ == HeightAxis::logarithmic ? std::exp(height) : height, 5);
}

void LineLabels::make_room(double value) {
    FF_EXPECT(axis_ == HeightAxis::linear || value > 0);
    heights_.push_back(scaled(value));
}

void LineLabels::add(std::string method, std::string text, double value) {
    labels_.push_back({std::move(method), std::move(text), scaled(value)});
}

void LineLabels::set(PictureValues& values, Json scales) const {
    if (heights_.empty()) return values.set("scales", std::move(scales));
    constexpr double rows = 20;  // of text, in the height of a picture
    const auto [least, largest] = std::minmax_element(heights_.begin(), heights_.end());
    const double extent = *largest - *least;
    const double room = extent > 0 ? 0.06 * extent : 0.05;
    const double low = *least - room;
    const double high = *largest + room;

    std::vector<Label> labels = labels_;
    const double apart = (high - low) / std::max(rows, static_cast<double>(labels.size()));
    std::stable_sort(labels.begin(), labels.end(), [](const Label& a, const Label& b) { return a.height < b.height; });
    for (std::size_t i = 1; i < labels.size(); ++i)
        labels[i].height = std::max(labels[i].height, labels[i - 1].height + apart);
    double ceiling = high;
    for (std::size_t i = labels.size(); i-- > 0;) {
        labels[i].height = std::min(labels[i].height, ceiling);
        ceiling = labels[i].height - apart;
    }
    auto rows_of_labels = Json::array();
    for (const Label& label : labels)
        rows_of_labels.push_back({{"method", label.method}, {"text", label.text}, {"height", value_at(label.height)}});
    values.set("labels", std::move(rows_of_labels));
    scales["y"] = {{"domain", {value_at(low), value_at(high)}}};
    values.set("scales", std::move(scales));
}

void MethodLines::make_room(const std::optional<stats::Interval>& interval) {
    if (!interval || interval->low <= 0) return;
    labels_.make_room(interval->low);
    labels_.make_room(interval->high);
}

void MethodLines::add(const std::string& method, const std::string& text, double last) {
    if (std::find(methods_.begin(), methods_.end(), method) == methods_.end()) methods_.push_back(method);
    const auto style =
        std::find_if(styles_.begin(), styles_.end(), [&](const MethodStyle& each) { return each.method == method; });
    if (style->in_colour) labels_.add(method, text, last);
}

void MethodLines::set(PictureValues& values) const {
    values.set("isolate", methods_);
    labels_.set(values, style_scales(styles_));
}

}  // namespace ff::reports
