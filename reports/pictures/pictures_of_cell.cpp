#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/cells_in_between.hpp"
#include "reports/words/findings/verdicts.hpp"

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
using studies::Quantity;
using studies::QuantityKind;
using studies::Summary;

struct CellView {
    const CellAnalysis& found;
    const studies::Cell& cell;
    const studies::Method& method;
    const Scene& scene;
    std::string label;
};

CellView view(const studies::StudyResults& results, std::size_t index) {
    const studies::StudyPlan& plan = results.findings.plan;
    const CellAnalysis& found = results.findings.cells[index];
    const studies::Cell& cell = plan.cells[found.cell];
    return {found, cell, plan.spec.methods[cell.method], plan.scenes[cell.scene], cell_label(plan, cell)};
}

/// Form factors whose estimates are free: half of them follow under reciprocal completion.
std::vector<const Summary*> distinct(const CellView& v) {
    std::vector<const Summary*> pairs;
    if (v.found.summaries.empty()) return pairs;  // no trial yet
    for (const Quantity pair : studies::distinct_pairs(v.scene.faces.size(), v.method.completion))
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

}  // namespace

Picture begin_picture(std::string_view kind, std::size_t cell, const std::string& label, std::string title) {
    Picture picture;
    picture.kind = kind;
    picture.id = slug(fmt::format("{}-{}-{}", kind, cell, label));
    picture.title = std::move(title);
    return picture;
}

std::optional<Picture> estimates_picture(const studies::StudyResults& results, std::size_t cell) {
    const CellView v = view(results, cell);
    const auto printed = printed_figures(results, cell);
    PictureValues values({"pair", "exact", "mean", "low", "high", "run_low", "run_high", "published", "printed"});
    std::size_t intervals = 0;
    std::size_t missed = 0;
    for (const Summary* s : distinct(v)) {
        if (!s->mean || !s->reference) continue;
        const bool sampled = s->trials > 1;
        if (s->bias_interval) {
            ++intervals;
            if (!s->bias_interval->contains(0)) ++missed;
        }
        const auto figure = printed.find(s->quantity);
        const bool shown = figure != printed.end();
        const auto around = [&](double end) { return drawn(*s->reference + end); };
        values.add({quantity_label(v.scene, s->quantity), drawn(s->reference), drawn(s->mean),
                    s->bias_interval ? around(s->bias_interval->low) : nullptr,
                    s->bias_interval ? around(s->bias_interval->high) : nullptr, sampled ? drawn(s->q025) : nullptr,
                    sampled ? drawn(s->q975) : nullptr, shown ? drawn(std::stod(figure->second)) : nullptr,
                    shown ? figure->second : ""});
    }
    if (values.empty()) return std::nullopt;
    auto shown = nlohmann::ordered_json::array({"exact", "ours"});
    if (v.found.trials > 1) shown.push_back("95 % of single runs");
    if (!printed.empty()) shown.push_back("published");
    const nlohmann::ordered_json labels{{"ours", intervals > 0 ? "mean, its interval" : "computed"}};
    values.set("signals", {{"shown", std::move(shown)}, {"labels", labels}});
    Picture picture = begin_picture("estimates", v.found.cell, v.label,
                                    fmt::format("Estimates against the exact values, {}.", v.label));
    if (intervals > 0) {
        picture.finding = fmt::format(
            "Intervals that miss the exact value ({:g} %, {} trials): {} of {}, where "
            "chance alone makes {:.2g}.",
            100 * results.findings.plan.spec.level, v.found.trials, missed, intervals,
            static_cast<double>(intervals) * (1 - results.findings.plan.spec.level));
    } else {
        const auto worst = distinct(v);
        const auto* largest = *std::max_element(worst.begin(), worst.end(), [](const Summary* a, const Summary* b) {
            return std::abs(a->bias.value_or(0)) < std::abs(b->bias.value_or(0));
        });
        picture.finding = fmt::format("The largest error is {:+.2e}, on {}.", largest->bias.value_or(0),
                                      quantity_label(v.scene, largest->quantity));
    }
    if (!printed.empty()) picture.finding += fmt::format(" {} published values are marked.", printed.size());
    picture.description = fmt::format(
        "For each pair the exact form factor, the mean of the runs with its interval, and the "
        "range of 95 % of single runs. {}",
        picture.finding);
    picture.values = values.text();
    return picture;
}

std::optional<Picture> bias_picture(const studies::StudyResults& results, std::size_t cell) {
    const CellView v = view(results, cell);
    PictureValues values({"pair", "from", "to", "z", "bias", "error"});
    const Summary* largest = nullptr;
    for (const Summary& s : v.found.summaries) {
        if (s.quantity.kind != QuantityKind::form_factor || !s.bias_se || *s.bias_se == 0) continue;
        if (largest == nullptr || std::abs(*s.bias / *s.bias_se) > std::abs(*largest->bias / *largest->bias_se))
            largest = &s;
        values.add({quantity_label(v.scene, s.quantity), from_label(v.scene, s.quantity), to_label(v.scene, s.quantity),
                    drawn(*s.bias / *s.bias_se), drawn(s.bias), drawn(s.bias_se)});
    }
    if (largest == nullptr) return std::nullopt;
    Picture picture = begin_picture("bias_map", v.found.cell, v.label,
                                    fmt::format("Bias in units of its standard error, {}.", v.label));
    picture.finding =
        fmt::format("The largest is {:+.1f}, on {}; all pairs together: {}.", *largest->bias / *largest->bias_se,
                    quantity_label(v.scene, largest->quantity), bias_in_words(v.found));
    picture.description =
        fmt::format("A square for each ordered pair of faces, coloured by bias / standard error. {}", picture.finding);
    picture.values = values.text();
    return picture;
}

std::vector<Picture> pictures_of_cell(const studies::StudyResults& results, std::size_t cell) {
    std::vector<Picture> pictures;
    for (auto* draw : {unfolded_picture, estimates_picture, bias_picture}) {
        if (auto picture = draw(results, cell)) pictures.push_back(std::move(*picture));
    }
    for (Picture& picture : distribution_pictures(results, cell)) pictures.push_back(std::move(picture));
    return pictures;
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
        PictureGroup group{view(results, cell).label, rivals.contains(cell), pictures_of_cell(results, cell)};
        if (!group.pictures.empty()) groups.push_back(std::move(group));
    }
    for (std::size_t scene = 0; !results.occlusion.empty() && scene < results.findings.plan.scenes.size(); ++scene) {
        PictureGroup group{fmt::format("Error against evaluations: {}", results.findings.plan.scenes[scene].name),
                           false, pictures_of_scene(results, scene)};
        if (!group.pictures.empty()) groups.push_back(std::move(group));
    }
    std::stable_partition(groups.begin(), groups.end(), [](const PictureGroup& group) { return group.open; });
    if (auto light = radiosity_pictures(results)) groups.insert(groups.begin(), std::move(*light));
    if (auto claims = claims_picture(results)) groups.push_back({"Claimed errors", false, {std::move(*claims)}});
    return groups;
}

}  // namespace ff::reports
