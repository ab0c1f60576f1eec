#include "studies/audit/experiment.hpp"

#include "studies/audit/scene_facts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace ff::studies::audit {
namespace {

bool contains(const std::vector<std::string>& list, const std::string& item) {
    return std::ranges::find(list, item) != list.end();
}

}  // namespace

bool is_sampling(const PublishedTables& tables, const std::string& method) {
    return contains(tables.sampling_methods, method);
}

Completion completion_of(const PublishedTables& tables, const std::string& method) {
    return contains(tables.reciprocal_methods, method) ? Completion::reciprocal : Completion::direct;
}

bool has_readings(const PublishedTables& tables, const std::string& table) {
    return std::ranges::find(tables.readings, table, &Reading::table) != tables.readings.end();
}

std::vector<Experiment> collect_experiments(const PublishedTables& tables) {
    std::vector<Experiment> experiments;
    for (std::size_t f = 0; f < tables.figures.size(); ++f) {
        const Figure& figure = tables.figures[f];
        const auto same = std::ranges::find_if(experiments, [&](const Experiment& e) {
            return e.method == figure.method && e.patches_per_face == figure.patches_per_face &&
                   e.samples_per_patch == figure.samples_per_patch;
        });
        if (same != experiments.end()) {
            same->figures.push_back(f);
            continue;
        }
        Experiment experiment{.method = figure.method,
                              .patches_per_face = figure.patches_per_face,
                              .samples_per_patch = figure.samples_per_patch,
                              .rays_per_face = std::nullopt,
                              .completion = completion_of(tables, figure.method),
                              .figures = {f}};
        if (is_sampling(tables, figure.method) && figure.samples_per_patch)
            experiment.rays_per_face = *figure.samples_per_patch * figure.patches_per_face;
        experiments.push_back(std::move(experiment));
    }
    return experiments;
}

std::string describe(const Experiment& experiment) {
    std::string text = fmt::format("{}, {} {} per face", experiment.method, experiment.patches_per_face,
                                   experiment.patches_per_face == 1 ? "patch" : "patches");
    if (experiment.samples_per_patch) text += fmt::format(", {} rays per patch", *experiment.samples_per_patch);
    return text;
}

NumberFormat format_of(const Figure& figure, const Interpretation& interpretation) {
    if (is_value(figure)) return interpretation.values;
    const auto number = parse_printed(figure.printed);
    return {interpretation.errors, Layout::fixed_decimals, number ? number->decimals : 0};
}

std::optional<Expectation> expectation(const SceneFacts& facts, const SrDistribution& distribution,
                                       const Figure& figure) {
    if (figure.kind == FigureKind::form_factor) {
        const int from = static_cast<int>(*facts.face(figure.from));
        const int to = static_cast<int>(*facts.face(figure.to));
        return Expectation{distribution.mean(from, to), distribution.pair_sigma(from, to)};
    }
    if (figure.kind == FigureKind::row_sum) {
        const int face = static_cast<int>(*facts.face(figure.from));
        return Expectation{distribution.mean.row(face).sum(), distribution.sum_sigma(face)};
    }
    return std::nullopt;
}

}  // namespace ff::studies::audit
