#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace ff::reports {
namespace {

using studies::ErrorShape;

/// What all pictures of a cell's errors share.
struct Distribution {
    const studies::CellAnalysis& found;
    const Scene& scene;
    std::string label;
    nlohmann::ordered_json pairs;  ///< names, in the order of the shapes
};

std::string pair_name(const Distribution& d, const ErrorShape& shape) {
    return quantity_label(d.scene, shape.quantity);
}

nlohmann::ordered_json choice_of(const Distribution& d) {
    return {{"signal", "pair"}, {"label", "Pair"}, {"values", d.pairs}};
}

Picture box_plots(const Distribution& d) {
    PictureValues values({"pair", "min", "q05", "q25", "median", "q75", "q95", "max"});
    const studies::Summary* widest = nullptr;
    for (const ErrorShape& shape : d.found.shapes) {
        const studies::Summary& s = d.found.summary(shape.quantity);
        const auto error = [&](const std::optional<double>& value) { return drawn(*value - *s.reference); };
        values.add({pair_name(d, shape), error(s.min), error(s.q05), drawn(shape.q25), error(s.median),
                    drawn(shape.q75), error(s.q95), error(s.max)});
        if (widest == nullptr || *s.q95 - *s.q05 > *widest->q95 - *widest->q05) widest = &s;
    }
    Picture picture =
        begin_picture("errors", d.found.cell, d.label, fmt::format("Errors of single runs by pair, {}.", d.label));
    picture.finding = fmt::format("The widest spread is that of {}: 90 % of its runs err by {:+.2e} to {:+.2e}.",
                                  quantity_label(d.scene, widest->quantity), *widest->q05 - *widest->reference,
                                  *widest->q95 - *widest->reference);
    picture.description = fmt::format(
        "For each pair the range of all errors (thin), of the middle 90 % (thick) and of the "
        "middle half (box), with the median. {}",
        picture.finding);
    picture.values = values.text();
    return picture;
}

Picture histogram(const Distribution& d) {
    PictureValues values({"pair", "low", "high", "count", "normal"});
    const studies::Summary* least = nullptr;
    for (const ErrorShape& shape : d.found.shapes) {
        const std::string pair = pair_name(d, shape);
        for (const ErrorShape::Bin& bin : shape.bins) {
            values.add({pair, drawn(bin.low, 4), drawn(bin.high, 4), bin.runs, drawn(bin.normal, 3)});
        }
        const studies::Summary& s = d.found.summary(shape.quantity);
        if (s.normality_p && (least == nullptr || *s.normality_p < *least->normality_p)) least = &s;
    }
    values.set("choose", choice_of(d));
    Picture picture = begin_picture("histogram", d.found.cell, d.label,
                                    fmt::format("How the errors of single runs are distributed, {}.", d.label));
    picture.finding = least == nullptr
                          ? std::string("There are too few runs for a test of normality.")
                          : fmt::format("The least normal of {} pairs is {}: Anderson-Darling {} by itself, n = {}.",
                                        d.found.shapes.size(), quantity_label(d.scene, least->quantity),
                                        p_text(*least->normality_p), least->trials);
    picture.description = fmt::format(
        "A histogram of the errors of one pair at a time, with what a normal distribution of "
        "their mean and spread would give. {}",
        picture.finding);
    picture.values = values.text();
    return picture;
}

Picture quantile_plot(const Distribution& d) {
    PictureValues values({"pair", "normal", "runs"});
    const ErrorShape* farthest = nullptr;
    double distance = -1;
    for (const ErrorShape& shape : d.found.shapes) {
        for (const ErrorShape::QuantilePair& q : shape.quantiles) {
            values.add({pair_name(d, shape), drawn(q.normal, 3), drawn(q.runs, 3)});
            if (std::abs(q.runs - q.normal) <= distance) continue;
            distance = std::abs(q.runs - q.normal);
            farthest = &shape;
        }
    }
    values.set("choose", choice_of(d));
    Picture picture = begin_picture("qq", d.found.cell, d.label,
                                    fmt::format("Quantiles of the errors against normal ones, {}.", d.label));
    picture.finding = fmt::format("No quantile is farther from the line than {:.2g} standard deviations ({}).",
                                  distance, pair_name(d, *farthest));
    picture.description = fmt::format(
        "Quantiles of the errors of one pair at a time against those of a normal distribution, "
        "in standard deviations; on the line where both agree. {}",
        picture.finding);
    picture.values = values.text();
    return picture;
}

}  // namespace

std::vector<Picture> distribution_pictures(const studies::StudyResults& results, std::size_t cell) {
    const studies::StudyPlan& plan = results.findings.plan;
    const studies::CellAnalysis& found = results.findings.cells[cell];
    if (found.shapes.empty()) return {};
    const studies::Cell& planned = plan.cells[found.cell];
    Distribution d{found, plan.scenes[planned.scene], cell_label(plan, planned), nlohmann::ordered_json::array()};
    for (const ErrorShape& shape : found.shapes) d.pairs.push_back(pair_name(d, shape));
    return {box_plots(d), histogram(d), quantile_plot(d)};
}

}  // namespace ff::reports
