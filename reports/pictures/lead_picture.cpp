#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/coverage_words.hpp"
#include "studies/analysis/configuration_estimates.hpp"
#include "studies/comparison/ranking.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace ff::reports {
namespace {

using Json = nlohmann::ordered_json;
using studies::Ranked;
using studies::StudyResults;

constexpr std::size_t most_blocks = 4;

/// Rows of a ranking, in blocks with a heading each.
class Rows {
  public:
    explicit Rows(const MethodChoice& methods) : chosen_(methods) {}

    struct Row {
        std::string label;
        std::string method;
        std::string size;
        std::optional<double> value;
        std::optional<stats::Interval> interval;
        std::optional<double> expected;
        std::string group;
    };

    void heading(const std::string& text) {
        ++blocks_;
        block_ = text;
        begun_ = false;
    }
    void add(const Row& row) {
        if (!chosen_.has(row.method)) return;
        if (!std::exchange(begun_, true)) order_.push_back(block_);
        ++rows_;
        if (!row.method.empty()) methods_.insert(row.method);
        order_.push_back(fmt::format("{}|{}", block_, row.label));
        values_.add({order_.back(), row.method, row.size, drawn(row.value),
                     row.interval ? drawn(row.interval->low) : Json(),
                     row.interval ? drawn(row.interval->high) : Json(),
                     row.interval ? drawn(row.interval->high) : drawn(row.value), drawn(row.expected), row.group});
    }
    [[nodiscard]] std::size_t rows() const { return rows_; }
    [[nodiscard]] bool full() const { return blocks_ >= most_blocks; }
    PictureValues& values() { return values_; }
    [[nodiscard]] const Json& order() const { return order_; }
    [[nodiscard]] const std::set<std::string>& methods() const { return methods_; }

  private:
    const MethodChoice& chosen_;
    bool begun_ = false;  ///< whether the heading of this block stands
    PictureValues values_{{"row", "method", "size", "value", "low", "high", "end", "expected", "group"}};
    std::string block_;
    Json order_ = Json::array();
    std::size_t blocks_ = 0;
    std::size_t rows_ = 0;
    std::set<std::string> methods_;
};

/// Letters of groups: a for the best; none where all are in one.
std::string letter(const std::vector<Ranked>& ranked, const Ranked& one) {
    const bool groups = std::any_of(ranked.begin(), ranked.end(), [](const Ranked& each) { return each.group > 0; });
    return groups ? std::string(1, static_cast<char>('a' + std::min<std::size_t>(one.group, 25))) : std::string();
}

std::string heading_of(const studies::StudyPlan& plan, std::size_t scene, PairClass pair_class) {
    const std::string where = fmt::format("{} pairs", name(pair_class));
    return plan.scenes.size() == 1 ? where : fmt::format("{}: {}", plan.scenes[scene].name, where);
}

constexpr std::array all_classes{PairClass::parallel, PairClass::adjacent, PairClass::other};

/// For each class of pairs of each scene.
template <class Add>
void for_each_class(const StudyResults& results, Rows& rows, const Add& add) {
    for (std::size_t scene = 0; scene < results.findings.plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : all_classes) {
            if (!rows.full()) add(scene, pair_class);
        }
    }
}

void add_slopes(const StudyResults& results, Rows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    for_each_class(results, rows, [&](std::size_t scene, PairClass pair_class) {
        const auto ranked = studies::rank_slopes(results.slopes, scene, pair_class, plan.spec.level);
        if (ranked.slopes.empty()) return;
        rows.heading(heading_of(plan, scene, pair_class) + (ranked.of_median ? " (median error)" : ""));
        for (const Ranked& each : ranked.slopes) {
            const studies::LadderSlopes& ladder = results.slopes[each.index];
            const auto found = std::find_if(ladder.classes.begin(), ladder.classes.end(),
                                            [&](const auto& of) { return of.pair_class == pair_class; });
            const studies::Slope& slope = ranked.of_median ? found->median : found->rmse;
            rows.add({ladder.ladder.label, plan.spec.methods[ladder.ladder.method].name, "", each.value, each.interval,
                      slope.expected ? std::optional(slope.slowest_expected) : std::nullopt,
                      letter(ranked.slopes, each)});
        }
    });
}

void add_errors(const StudyResults& results, Rows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto tables = results.published ? results.published->comparisons : std::vector<studies::TableComparison>();
    for_each_class(results, rows, [&](std::size_t scene, PairClass pair_class) {
        const auto ranked = studies::rank_errors(results.findings,
                                                 studies::compared_cells(results.findings, scene, tables), pair_class);
        if (ranked.empty()) return;
        rows.heading(heading_of(plan, scene, pair_class));
        for (const Ranked& each : ranked) {
            const studies::Cell& cell = plan.cells[each.index];
            const std::string& method = plan.spec.methods[cell.method].name;
            const bool exact = each.value < studies::rounding_error;
            rows.add({method, method, size_label(plan, cell), exact ? std::nullopt : std::optional(each.value),
                      each.interval, std::nullopt, letter(ranked, each)});
        }
    });
}

void add_variances(const StudyResults& results, Rows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    std::set<std::pair<std::size_t, PairClass>> seen;
    for (const studies::VarianceReduction& first : results.reductions) {
        if (!seen.emplace(first.random_cell, first.pair_class).second || rows.full()) continue;
        const studies::Cell& random = plan.cells[first.random_cell];
        rows.heading(fmt::format("{}, {}", heading_of(plan, random.scene, first.pair_class), size_label(plan, random)));
        const auto ranked =
            studies::rank_reductions(results.findings, results.reductions, first.random_cell, first.pair_class);
        for (const Ranked& each : ranked) {
            const std::string& method = plan.spec.methods[plan.cells[each.index].method].name;
            rows.add({method, method, size_label(plan, plan.cells[each.index]), each.value, each.interval, 1.0,
                      letter(ranked, each)});
        }
    }
}

/// The least and the most of each rule and number of replicates, over rows whose variance is finite.
void add_coverage(const StudyResults& results, Rows& rows) {
    std::set<studies::IntervalRule> seen;
    for (const studies::Coverage& first : results.coverage) {
        if (!seen.insert(first.rule).second) continue;
        rows.heading(std::string(rule_in_words(first.rule)));
        for (const std::uint64_t replicates : results.findings.plan.spec.coverage) {
            const studies::Coverage* least = nullptr;
            for (const studies::Coverage& row : results.coverage) {
                const bool finite = !results.findings.cells[row.cell].has_infinite_variance(row.pair_class);
                if (row.rule != first.rule || row.replicates != replicates || !finite) continue;
                if (least == nullptr || row.share() < least->share()) least = &row;
            }
            if (least == nullptr) continue;
            const studies::StudyPlan& plan = results.findings.plan;
            rows.add({fmt::format("R = {}", replicates), plan.spec.methods[plan.cells[least->cell].method].name,
                      size_label(plan, plan.cells[least->cell]), least->share(), least->actual, plan.spec.level,
                      least->short_of_nominal ? "short" : ""});
        }
    }
}

/// The estimate furthest off in each configuration.
void add_configurations(const StudyResults& results, Rows& rows) {
    const studies::StudyPlan& plan = results.findings.plan;
    const auto estimates = studies::configuration_estimates(results.findings);
    std::set<std::string_view> seen;
    for (const auto& first : estimates) {
        if (!seen.insert(first.configuration->name).second) continue;
        const studies::ConfigurationEstimate* worst = nullptr;
        for (const auto& row : estimates) {
            if (row.configuration != first.configuration || !row.standard_errors || !row.interval) continue;
            if (worst == nullptr || std::abs(*row.standard_errors) > std::abs(*worst->standard_errors)) worst = &row;
        }
        if (worst == nullptr) continue;
        const studies::Cell& cell = plan.cells[worst->found->cell];
        if (rows.rows() == 0) rows.heading("furthest estimate of each");
        const bool biased = worst->found->bias_finding == studies::BiasFinding::biased;
        rows.add({std::string(first.configuration->name), plan.spec.methods[cell.method].name, size_label(plan, cell),
                  worst->standard_errors, std::nullopt, 0.0, biased ? "biased" : ""});
    }
}

/// What is told about each kind of ranking.
struct Told {
    std::string title;
    std::string axis;
    std::string finding;
    bool log = false;
};

Told told(Subject subject, double level) {
    const std::string bars = fmt::format("Bars: {:g} % intervals.", 100 * level);
    const std::string groups = fmt::format(
        " Methods with the same letter cannot be told apart from the first of them ({:g} % over all pairs of "
        "methods in a block).",
        100 * (1 - level));
    switch (subject) {
        case Subject::rates:
            return {"Convergence rates, steepest first.", "slope of ln(error) on ln(evaluations)",
                    bars + " Grey ticks: what theory expects at least." + groups, false};
        case Subject::variances:
            return {"Variance reduction, largest first.", "variance of random points / variance",
                    bars + " Grey ticks: no reduction." + groups, true};
        case Subject::coverage:
            return {"Least coverage of each rule with R replicates.", "share of intervals that contain the exact value",
                    bars + " Grey ticks: what the intervals promise.", false};
        case Subject::configurations:
            return {"The estimate furthest from its exact value.", "deviation in standard errors",
                    "Grey ticks: the exact value. Of several methods the largest of all deviations is shown.", false};
        case Subject::light:
        case Subject::occlusion:
        case Subject::publication:
        case Subject::errors:
            break;
    }
    return {"Error of each method, smallest first.", "RMSE of a run", bars + groups, true};
}

Picture ranking_picture(const StudyResults& results, Subject subject, const MethodChoice& methods, Rows& rows) {
    const Told text = told(subject, results.findings.plan.spec.level);
    const auto styles = method_styles(results, methods);
    auto names = Json::array();
    for (const MethodStyle& style : styles) {
        if (rows.methods().contains(style.method)) names.push_back(style.method);
    }
    if (names.size() > 1 && subject != Subject::coverage) rows.values().set("isolate", std::move(names));
    Json scales = style_scales(styles);
    scales["y"] = {{"domain", rows.order()}};
    rows.values().set("scales", std::move(scales));
    rows.values().set("titles", {{"x", text.axis}});
    if (text.log) rows.values().set("log", true);
    Picture picture;
    picture.id = "answer";
    picture.kind = "ranking";
    picture.title = text.title;
    picture.finding = text.finding;
    picture.description =
        fmt::format("A row for each method: {}, with its interval. {}", text.axis, answer(results).text);
    picture.values = rows.values().text();
    return picture;
}

}  // namespace

std::optional<Picture> lead_picture(const StudyResults& results, const MethodChoice& methods) {
    const Subject subject = subject_of(results);
    Rows rows(methods);
    switch (subject) {
        case Subject::light:
            if (const auto group = radiosity_pictures(results); group && !group->pictures.empty())
                return group->pictures.front();
            return std::nullopt;
        case Subject::occlusion:
            return occlusion_pictures(results, methods).front();
        case Subject::coverage:
        case Subject::configurations:
            if (!methods.names.empty()) return std::nullopt;  // its rows are about all of them
            subject == Subject::coverage ? add_coverage(results, rows) : add_configurations(results, rows);
            break;
        case Subject::rates:
            add_slopes(results, rows);
            break;
        case Subject::variances:
            add_variances(results, rows);
            break;
        case Subject::publication:
        case Subject::errors:
            add_errors(results, rows);
            break;
    }
    if (rows.rows() < 2) return std::nullopt;  // one number needs no picture
    return ranking_picture(results, subject, methods, rows);
}

}  // namespace ff::reports
