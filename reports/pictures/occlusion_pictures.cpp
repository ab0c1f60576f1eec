#include "reports/pictures/line_labels.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/findings/occlusion_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

Picture picture_of_series(const studies::StudyResults& results, const studies::OcclusionSeries& series,
                          const MethodChoice& methods) {
    const studies::StudyPlan& plan = results.findings.plan;
    PictureValues values({"method", "scene", "hidden", "size", "error", "low", "high"});
    MethodLines lines(method_styles(results, methods), HeightAxis::logarithmic);
    for (std::size_t method = 0; method < plan.spec.methods.size(); ++method) {
        const std::string& name = plan.spec.methods[method].name;
        if (!methods.has(name)) continue;
        std::optional<double> last;
        for (const studies::HiddenPair& scene : series.scenes) {
            const auto& found = scene.methods[method];
            if (!found || found->size() < studies::rounding_error) continue;
            const bool infinite = found->error.status == studies::VarianceStatus::infinite;
            const auto interval = infinite ? std::nullopt : found->error.interval;
            values.add({name, plan.scenes[scene.scene].name, drawn(scene.hidden, 4),
                        size_label(plan, plan.cells[found->cell]), drawn(found->size()), drawn_low(interval),
                        drawn_high(interval)});
            last = found->size();
            lines.make_room(*last);
            lines.make_room(interval);
        }
        if (last) lines.add(name, name, *last);
    }
    lines.set(values);
    const std::string pair = quantity_label(plan.scenes[series.scenes.front().scene], series.pair);
    return picture_of(values, "occlusion", fmt::format("occlusion-{}-{}", series.family, pair),
                      fmt::format("Error against the occluded fraction: {}, {}.", series.family, pair),
                      series_in_words(results, series),
                      fmt::format("RMSE of a run (logarithmic) on {} against the occluded fraction of its form factor, "
                                  "in {} scenes with another {}, a line for each method, with {:g} % intervals.",
                                  pair, series.scenes.size(), series.measure, 100 * plan.spec.level));
}

}  // namespace

std::vector<Picture> occlusion_pictures(const studies::StudyResults& results, const MethodChoice& methods) {
    std::vector<Picture> pictures;
    for (const studies::OcclusionSeries& series : results.occlusion)
        pictures.push_back(picture_of_series(results, series, methods));
    return pictures;
}

}  // namespace ff::reports
