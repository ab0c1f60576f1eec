#include "reports/pictures/method_styles.hpp"

#include "core/estimators/added.hpp"
#include "core/support/contract.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/sizes.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/sampler.hpp"
#include "studies/comparison/ranking.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace ff::reports {
namespace {

using studies::StudyResults;

/// Okabe and Ito, without yellow and black; the rest of the palette contrasts better on both backgrounds.
constexpr std::array method_colours{"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#8a6d3b"};
constexpr std::array method_symbols{"circle",  "square",         "triangle-up",  "cross",
                                    "diamond", "triangle-right", "triangle-down"};
constexpr const char* grey = "#8b8f94";
constexpr std::size_t most_compared = 3;

/// The methods that captions of error against evaluations name, by how many of them do, the most first.
std::vector<std::size_t> named_by_captions(const StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    const double level = studies::level_of_each_class(results.findings);
    std::map<std::size_t, int> counts;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : pair_classes) {
            const auto all = size_series(results, scene, pair_class);
            for (const bool deterministic : {true, false}) {
                const auto cells = cells_of(plan, all, deterministic);
                for (const studies::Ranked& each : studies::rank_errors(results.findings, cells, pair_class, level))
                    counts[plan.cells[each.index].method] += each.group == 0 ? 1 : 0;
            }
        }
    }
    std::erase_if(counts, [](const auto& method) { return method.second == 0; });
    std::vector<std::size_t> methods;
    for (const auto& [method, count] : counts) methods.push_back(method);
    std::ranges::stable_sort(methods, std::ranges::greater(), [&](std::size_t method) { return counts.at(method); });
    return methods;
}

/// Whether it comes from a user: points of a file, a program, a plug-in, a Python function.
bool is_of_user(const studies::Method& method) {
    return samplers::find_added(method.sampler) != nullptr || find_added_estimator(method.estimator) != nullptr;
}

std::set<std::size_t> coloured(const StudyResults& results, const MethodChoice& choice) {
    const auto& methods = results.findings.plan.spec.methods;
    std::set<std::size_t> chosen;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (choice.has(methods[i].name)) chosen.insert(i);
    }
    if (chosen.size() <= method_colours.size()) return chosen;
    chosen.clear();
    std::size_t most = most_compared;
    const auto add = [&](std::size_t method) {
        if (chosen.size() < most) chosen.insert(method);
    };
    for (std::size_t scene = 0; results.published && scene < results.findings.plan.scenes.size(); ++scene) {
        for (const std::size_t cell : studies::compared_cells(results.findings, scene, results.published->comparisons))
            add(results.findings.plan.cells[cell].method);
    }
    most = method_colours.size();
    const auto random = std::find_if(methods.begin(), methods.end(), [](const studies::Method& method) {
        return method.sampler == samplers::yardstick().name;
    });
    if (random != methods.end()) add(static_cast<std::size_t>(random - methods.begin()));
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (is_of_user(methods[i])) add(i);
    }
    const MainFinding finding = answer(results).finding;
    for (const Ranking& ranking : finding.rankings) {
        for (const RankedMethod& row : ranking.methods) {
            if (std::ranges::find(ranking.leaders, row.label) != ranking.leaders.end()) add(row.method);
        }
    }
    if (finding.subject == Subject::configurations) {  // its picture names the method of each mark
        for (const Ranking& ranking : finding.rankings) {
            for (const RankedMethod& row : ranking.methods) add(row.method);
        }
    }
    for (const std::size_t method : named_by_captions(results)) add(method);
    return chosen;
}

}  // namespace

std::vector<MethodStyle> method_styles(const StudyResults& results, const MethodChoice& choice) {
    const auto& methods = results.findings.plan.spec.methods;
    const auto chosen = coloured(results, choice);
    std::vector<MethodStyle> styles;
    std::size_t next = 0;
    for (std::size_t i = 0; i < methods.size(); ++i) {
        const bool in_colour = chosen.contains(i);
        styles.push_back({methods[i].name, in_colour ? method_colours[next++] : grey,
                          method_symbols[i % method_symbols.size()], in_colour});
    }
    return styles;
}

Json style_scales(const std::vector<MethodStyle>& styles) {
    std::vector<std::string> methods, colours, symbols;
    for (const MethodStyle& style : styles) {
        methods.push_back(style.method);
        colours.push_back(style.colour);
        symbols.push_back(style.symbol);
    }
    return {{"color", {{"domain", methods}, {"range", colours}}}, {"shape", {{"domain", methods}, {"range", symbols}}}};
}

double MethodLines::scaled(double value) const {
    return axis_ == HeightAxis::logarithmic ? std::log(value) : value;
}

Json MethodLines::value_at(double height) const {
    return drawn(axis_ == HeightAxis::logarithmic ? std::exp(height) : height, 5);
}

void MethodLines::make_room(double value) {
    FF_EXPECT(axis_ == HeightAxis::linear || value > 0);
    if (std::isfinite(value)) heights_.push_back(scaled(value));
}

void MethodLines::begin(const std::string& method, const std::string& label) {
    lines_.push_back({method, label, std::nullopt});
}

void MethodLines::add(double value, const std::optional<stats::Interval>& interval) {
    make_room(value);
    if (interval && interval->low > 0) {
        make_room(interval->low);
        make_room(interval->high);
    }
    if (std::isfinite(value)) lines_.back().end = scaled(value);
}

bool MethodLines::is_in_colour(const std::string& method) const {
    return std::any_of(styles_.begin(), styles_.end(),
                       [&](const MethodStyle& each) { return each.method == method && each.in_colour; });
}

std::vector<MethodLines::Line> MethodLines::labels_apart(double low, double high) const {
    constexpr double rows = 20;  // rows of text in the height of a picture
    std::vector<Line> labels = lines_;
    std::erase_if(labels, [&](const Line& line) { return !line.end || !is_in_colour(line.method); });
    const double apart = (high - low) / std::max(rows, static_cast<double>(labels.size()));
    std::stable_sort(labels.begin(), labels.end(), [](const Line& a, const Line& b) { return a.end < b.end; });
    for (std::size_t i = 1; i < labels.size(); ++i)
        labels[i].end = std::max(*labels[i].end, *labels[i - 1].end + apart);
    double ceiling = high;
    for (std::size_t i = labels.size(); i-- > 0;) {
        labels[i].end = std::min(*labels[i].end, ceiling);
        ceiling = *labels[i].end - apart;
    }
    return labels;
}

void MethodLines::set(PictureValues& values) const {
    std::vector<std::string> methods;
    for (const Line& line : lines_) {
        if (line.end && std::find(methods.begin(), methods.end(), line.method) == methods.end())
            methods.push_back(line.method);
    }
    values.set("isolate", methods);
    Json scales = style_scales(styles_);
    if (!heights_.empty()) {
        const auto [least, largest] = std::minmax_element(heights_.begin(), heights_.end());
        const double extent = *largest - *least;
        const double room = extent > 0 ? 0.06 * extent : 0.05;
        const double low = *least - room;
        const double high = *largest + room;
        auto labels = Json::array();
        for (const Line& line : labels_apart(low, high))
            labels.push_back({{"method", line.method}, {"text", line.label}, {"height", value_at(*line.end)}});
        values.set("labels", std::move(labels));
        scales["y"] = {{"domain", {value_at(low), value_at(high)}}};
    }
    values.set("scales", std::move(scales));
}

}  // namespace ff::reports
