#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/sizes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

using studies::CellAnalysis;
using studies::ErrorShape;
using studies::Quantity;
using studies::QuantityKind;
using studies::Summary;

struct CellView {
    const CellAnalysis& found;
    const Scene& scene;
    std::string label;

    [[nodiscard]] std::string pair(const Quantity& quantity) const { return quantity_label(scene, quantity); }
};

CellView view(const studies::StudyResults& results, std::size_t index) {
    const studies::StudyPlan& plan = results.findings.plan;
    const CellAnalysis& found = results.findings.cells[index];
    const studies::Cell& cell = plan.cells[found.cell];
    return {found, plan.scenes[cell.scene], cell_label(plan, cell)};
}

/// A choice among the pairs whose errors have a shape.
Json choice_of_pair(const CellView& v) {
    auto pairs = Json::array();
    for (const ErrorShape& shape : v.found.shapes) pairs.push_back(v.pair(shape.quantity));
    return {{"signal", "pair"}, {"label", "Pair"}, {"values", std::move(pairs)}};
}

Picture box_plots(const CellView& v) {
    PictureValues values({"pair", "min", "q05", "q25", "median", "q75", "q95", "max"});
    const Summary* widest = nullptr;
    for (const ErrorShape& shape : v.found.shapes) {
        const Summary& s = v.found.summary(shape.quantity);
        const auto error = [&](const std::optional<double>& value) { return drawn(*value - *s.reference); };
        values.add({v.pair(shape.quantity), error(s.min), error(s.q05), drawn(shape.q25), error(s.median),
                    drawn(shape.q75), error(s.q95), error(s.max)});
        if (widest == nullptr || *s.q95 - *s.q05 > *widest->q95 - *widest->q05) widest = &s;
    }
    return picture_of_cell(
        values, "errors", v.found.cell, v.label, "Errors of single runs by pair",
        fmt::format("The widest spread is that of {}: 90 % of its runs err by {:+.2e} to {:+.2e}.",
                    v.pair(widest->quantity), *widest->q05 - *widest->reference, *widest->q95 - *widest->reference),
        "For each pair the range of all errors (thin), of the middle 90 % (thick) and of the middle "
        "half (box), with the median.");
}

Picture histogram(const CellView& v) {
    PictureValues values({"pair", "low", "high", "count", "normal"});
    const Summary* least = nullptr;
    for (const ErrorShape& shape : v.found.shapes) {
        const std::string pair = v.pair(shape.quantity);
        for (const ErrorShape::Bin& bin : shape.bins) {
            values.add({pair, drawn(bin.low, 4), drawn(bin.high, 4), bin.runs, drawn(bin.normal, 3)});
        }
        const Summary& s = v.found.summary(shape.quantity);
        if (s.normality_p && (least == nullptr || *s.normality_p < *least->normality_p)) least = &s;
    }
    values.set("choose", choice_of_pair(v));
    const std::string finding =
        least == nullptr
            ? "There are too few runs for a test of normality."
            : fmt::format("The least normal of {} pairs is {}: Anderson-Darling {} by itself, n = {}.",
                          v.found.shapes.size(), v.pair(least->quantity), p_text(*least->normality_p), least->trials);
    return picture_of_cell(values, "histogram", v.found.cell, v.label, "How the errors of single runs are distributed",
                           finding,
                           "A histogram of the errors of one pair at a time, with what a normal distribution of their "
                           "mean and spread would give.");
}

Picture quantile_plot(const CellView& v) {
    PictureValues values({"pair", "normal", "runs"});
    const ErrorShape* farthest = nullptr;
    double distance = -1;
    for (const ErrorShape& shape : v.found.shapes) {
        for (const ErrorShape::QuantilePair& q : shape.quantiles) {
            values.add({v.pair(shape.quantity), drawn(q.normal, 3), drawn(q.runs, 3)});
            if (std::abs(q.runs - q.normal) <= distance) continue;
            distance = std::abs(q.runs - q.normal);
            farthest = &shape;
        }
    }
    values.set("choose", choice_of_pair(v));
    return picture_of_cell(
        values, "qq", v.found.cell, v.label, "Quantiles of the errors against normal ones",
        fmt::format("No quantile is farther from the line than {:.2g} standard deviations ({}).", distance,
                    v.pair(farthest->quantity)),
        "Quantiles of the errors of one pair at a time against those of a normal distribution, in standard deviations; "
        "on the line where both agree.");
}

/// Form factors whose estimates are free: half of them follow under reciprocal completion.
std::vector<const Summary*> distinct(const studies::StudyPlan& plan, const CellView& v) {
    std::vector<const Summary*> pairs;
    if (v.found.summaries.empty()) return pairs;  // no trial yet
    const studies::Cell& cell = plan.cells[v.found.cell];
    const studies::Method& method = plan.spec.methods[cell.method];
    for (const Quantity pair : studies::distinct_pairs(plan.scenes.faces(cell.scene).size(), method.completion))
        pairs.push_back(&v.found.summary(pair));
    return pairs;
}

/// Printed figures that show a quantity of this cell, the last table's where several do.
std::map<Quantity, std::string> printed_figures(const studies::StudyResults& results, std::size_t cell) {
    std::map<Quantity, std::string> printed;
    if (!results.published) return printed;
    for (const studies::TableComparison& table : results.published->comparisons) {
        for (const studies::FigureComparison& c : table.figures) {
            const studies::Figure& figure = results.published->tables.figures[c.figure];
            if (c.cell == cell && figure.kind == studies::FigureKind::form_factor)
                printed.insert_or_assign(c.quantity, figure.printed);
        }
    }
    return printed;
}

std::optional<Picture> bias_picture(const studies::StudyResults& results, std::size_t cell) {
    const CellView v = view(results, cell);
    PictureValues values({"pair", "from", "to", "z", "bias", "error"});
    const Summary* largest = nullptr;
    for (const Summary& s : v.found.summaries) {
        if (s.quantity.kind != QuantityKind::form_factor || !s.bias_se || *s.bias_se == 0) continue;
        if (largest == nullptr || std::abs(*s.bias / *s.bias_se) > std::abs(*largest->bias / *largest->bias_se))
            largest = &s;
        values.add({v.pair(s.quantity), from_label(v.scene, s.quantity), to_label(v.scene, s.quantity),
                    drawn(*s.bias / *s.bias_se), drawn(s.bias), drawn(s.bias_se)});
    }
    if (largest == nullptr) return std::nullopt;
    return picture_of_cell(
        values, "bias_map", v.found.cell, v.label, "Bias in units of its standard error",
        fmt::format("The largest is {:+.1f}, on {}; all pairs together: {}.", *largest->bias / *largest->bias_se,
                    v.pair(largest->quantity), bias_in_words(v.found)),
        "A square for each ordered pair of faces, coloured by bias / standard error.");
}

}  // namespace

std::optional<Picture> estimates_picture(const studies::StudyResults& results, std::size_t cell) {
    const CellView v = view(results, cell);
    const auto pairs = distinct(results.findings.plan, v);
    const auto printed = printed_figures(results, cell);
    PictureValues values({"pair", "exact", "mean", "low", "high", "run_low", "run_high", "published", "printed"});
    std::size_t intervals = 0;
    std::size_t missed = 0;
    for (const Summary* s : pairs) {
        if (!s->mean || !s->reference) continue;
        const bool sampled = s->trials > 1;
        if (s->bias_interval) {
            ++intervals;
            if (!s->bias_interval->contains(0)) ++missed;
        }
        const auto figure = printed.find(s->quantity);
        const bool shown = figure != printed.end();
        const auto around = [&](double end) { return drawn(*s->reference + end); };
        values.add({v.pair(s->quantity), drawn(s->reference), drawn(s->mean),
                    s->bias_interval ? around(s->bias_interval->low) : nullptr,
                    s->bias_interval ? around(s->bias_interval->high) : nullptr, sampled ? drawn(s->q025) : nullptr,
                    sampled ? drawn(s->q975) : nullptr, shown ? drawn(std::stod(figure->second)) : nullptr,
                    shown ? figure->second : ""});
    }
    if (values.empty()) return std::nullopt;
    auto shown = Json::array({"exact", "ours"});
    if (v.found.trials > 1) shown.push_back("95 % of single runs");
    if (!printed.empty()) shown.push_back("published");
    const Json labels{{"ours", intervals > 0 ? "mean, its interval" : "computed"}};
    values.set("signals", {{"shown", std::move(shown)}, {"labels", labels}});
    std::string finding;
    if (intervals > 0) {
        finding = fmt::format(
            "Intervals that miss the exact value ({:g} %, {} trials): {} of {}, where chance alone makes {:.2g}.",
            100 * results.findings.plan.spec.level, v.found.trials, missed, intervals,
            static_cast<double>(intervals) * (1 - results.findings.plan.spec.level));
    } else {
        const auto* largest = *std::max_element(pairs.begin(), pairs.end(), [](const Summary* a, const Summary* b) {
            return std::abs(a->bias.value_or(0)) < std::abs(b->bias.value_or(0));
        });
        finding =
            fmt::format("The largest error is {:+.2e}, on {}.", largest->bias.value_or(0), v.pair(largest->quantity));
    }
    if (!printed.empty()) finding += fmt::format(" {} published values are marked.", printed.size());
    return picture_of_cell(values, "estimates", v.found.cell, v.label, "Estimates against the exact values", finding,
                           "For each pair the exact form factor, the mean of the runs with its interval, and the range "
                           "of 95 % of single runs.");
}

std::vector<PictureGroup> picture_groups(const studies::StudyResults& results) {
    std::set<std::size_t> rivals;
    for (const studies::Rivalry& rivalry : results.rivals) {
        rivals.insert(rivalry.better);
        if (rivalry.worse) rivals.insert(*rivalry.worse);
    }
    std::vector<PictureGroup> groups;
    const auto hidden = cells_in_between(results);
    for (std::size_t cell = 0; cell < results.findings.cells.size(); ++cell) {
        if (hidden.contains(results.findings.cells[cell].cell)) continue;
        const CellView v = view(results, cell);
        PictureGroup group{v.label, rivals.contains(cell), {}};
        for (auto* draw : {unfolded_picture, estimates_picture, bias_picture}) {
            if (auto picture = draw(results, cell)) group.pictures.push_back(std::move(*picture));
        }
        if (!v.found.shapes.empty()) {
            for (auto* draw : {box_plots, histogram, quantile_plot}) group.pictures.push_back(draw(v));
        }
        if (!group.pictures.empty()) groups.push_back(std::move(group));
    }
    const auto styles = method_styles(results);
    for (std::size_t scene = 0; !results.occlusion.empty() && scene < results.findings.plan.scenes.size(); ++scene) {
        PictureGroup group{fmt::format("Error against evaluations: {}", results.findings.plan.scenes.name(scene)),
                           false, pictures_of_scene(results, scene, styles)};
        if (!group.pictures.empty()) groups.push_back(std::move(group));
    }
    std::stable_partition(groups.begin(), groups.end(), [](const PictureGroup& group) { return group.compared; });
    if (auto light = radiosity_pictures(results)) groups.insert(groups.begin(), std::move(*light));
    if (auto claims = claims_picture(results)) groups.push_back({"Claimed errors", false, {std::move(*claims)}});
    return groups;
}

}  // namespace ff::reports
