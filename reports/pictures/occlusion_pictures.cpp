#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/occlusion_words.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

nlohmann::ordered_json end_of(const stats::Interval* interval, double stats::Interval::*end) {
    return interval ? drawn(interval->*end) : nlohmann::ordered_json();
}

Picture picture_of(const studies::StudyResults& results, const studies::OcclusionSeries& series,
                   const MethodChoice& methods) {
    const studies::StudyPlan& plan = results.findings.plan;
    PictureValues values({"method", "scene", "hidden", "size", "error", "low", "high"});
    auto names = nlohmann::ordered_json::array();
    for (std::size_t method = 0; method < plan.spec.methods.size(); ++method) {
        if (!methods.has(plan.spec.methods[method].name)) continue;
        bool any = false;
        for (const studies::HiddenPair& scene : series.scenes) {
            const auto& found = scene.methods[method];
            if (!found || found->size() < studies::rounding_error) continue;
            const bool infinite = found->error.status == studies::VarianceStatus::infinite;
            const stats::Interval* interval = infinite || !found->error.interval ? nullptr : &*found->error.interval;
            values.add({plan.spec.methods[method].name, plan.scenes[scene.scene].name, drawn(scene.hidden, 4),
                        size_label(plan, plan.cells[found->cell]), drawn(found->size()),
                        end_of(interval, &stats::Interval::low), end_of(interval, &stats::Interval::high)});
            any = true;
        }
        if (any) names.push_back(plan.spec.methods[method].name);
    }
    values.set("isolate", std::move(names));
    values.set("scales", style_scales(method_styles(results, methods)));
    const std::string pair = quantity_label(plan.scenes[series.scenes.front().scene], series.pair);
    Picture picture;
    picture.id = slug(fmt::format("occlusion-{}-{}", series.family, pair));
    picture.kind = "occlusion";
    picture.title = fmt::format("Error against the occluded share: {}, {}.", series.family, pair);
    picture.finding = series_in_words(results, series);
    picture.description = fmt::format(
        "RMSE of a run (logarithmic) on {} against the share of its open form factor that is hidden, in {} scenes with "
        "another {}, a line for each method, with {:g} % intervals. {}",
        pair, series.scenes.size(), series.measure, 100 * plan.spec.level, picture.finding);
    picture.values = values.text();
    return picture;
}

}  // namespace

std::vector<Picture> occlusion_pictures(const studies::StudyResults& results, const MethodChoice& methods) {
    std::vector<Picture> pictures;
    for (const studies::OcclusionSeries& series : results.occlusion)
        pictures.push_back(picture_of(results, series, methods));
    return pictures;
}

}  // namespace ff::reports
