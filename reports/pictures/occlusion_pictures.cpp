#include "reports/pictures/line_labels.hpp"
#include "reports/pictures/method_styles.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/words/findings/occlusion_words.hpp"

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
    LineLabels labels(HeightAxis::logarithmic);
    const auto styles = method_styles(results, methods);
    for (std::size_t method = 0; method < plan.spec.methods.size(); ++method) {
        if (!methods.has(plan.spec.methods[method].name)) continue;
        std::optional<double> last;
        for (const studies::HiddenPair& scene : series.scenes) {
            const auto& found = scene.methods[method];
            if (!found || found->size() < studies::rounding_error) continue;
            const bool infinite = found->error.status == studies::VarianceStatus::infinite;
            const stats::Interval* interval = infinite || !found->error.interval ? nullptr : &*found->error.interval;
            values.add({plan.spec.methods[method].name, plan.scenes[scene.scene].name, drawn(scene.hidden, 4),
                        size_label(plan, plan.cells[found->cell]), drawn(found->size()),
                        end_of(interval, &stats::Interval::low), end_of(interval, &stats::Interval::high)});
            last = found->size();
            labels.make_room(*last);
            if (interval == nullptr || interval->low <= 0) continue;
            labels.make_room(interval->low);
            labels.make_room(interval->high);
        }
        if (!last) continue;
        names.push_back(plan.spec.methods[method].name);
        if (styles[method].in_colour) labels.add(styles[method].method, styles[method].method, *last);
    }
    values.set("isolate", std::move(names));
    labels.set(values, style_scales(styles));
    const std::string pair = quantity_label(plan.scenes[series.scenes.front().scene], series.pair);
    Picture picture;
    picture.id = slug(fmt::format("occlusion-{}-{}", series.family, pair));
    picture.kind = "occlusion";
    picture.title = fmt::format("Error against the occluded fraction: {}, {}.", series.family, pair);
    picture.finding = series_in_words(results, series);
    picture.description = fmt::format(
        "RMSE of a run (logarithmic) on {} against the occluded fraction of its form factor, in {} scenes with "
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
