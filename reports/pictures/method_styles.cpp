#include "reports/pictures/method_styles.hpp"

#include "core/estimators/added.hpp"
#include "reports/words/findings/standing.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/sampler.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
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
constexpr std::size_t most_emphasised = 3;

/// Ranks of each method among slopes or, without any, among errors, added up over classes of pairs and scenes.
std::map<std::size_t, double> mean_ranks(const StudyResults& results) {
    const auto place = [](const Ranking& ranking) { return std::pair(ranking.scene, ranking.pair_class); };
    std::map<std::pair<std::size_t, PairClass>, Ranking> rankings;
    for (Ranking& each : rank_rates(results)) rankings.emplace(place(each), std::move(each));
    for (Ranking& each : rank_compared_errors(results)) rankings.emplace(place(each), std::move(each));
    std::map<std::size_t, std::pair<double, int>> sums;
    for (const auto& [at, ranking] : rankings) {
        for (std::size_t rank = 0; rank < ranking.methods.size(); ++rank) {
            auto& [sum, count] = sums[ranking.methods[rank].method];
            sum += static_cast<double>(rank);
            ++count;
        }
    }
    std::map<std::size_t, double> means;
    for (const auto& [method, sum] : sums) means[method] = sum.first / sum.second;
    return means;
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
    std::size_t most = most_emphasised;
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
    const auto ranks = mean_ranks(results);
    std::vector<std::size_t> order;
    for (const auto& [method, rank] : ranks) order.push_back(method);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return ranks.at(a) < ranks.at(b); });
    order.resize(std::min(order.size(), most_emphasised));
    for (const std::size_t method : order) add(method);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (is_of_user(methods[i])) add(i);
    }
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

}  // namespace ff::reports
