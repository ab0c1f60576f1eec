#include "core/patches/unfold.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::optional<Picture> unfolded_picture(const studies::StudyResults& results, std::size_t index) {
    const studies::StudyPlan& plan = results.findings.plan;
    const studies::CellAnalysis& found = results.findings.cells[index];
    if (!found.patch_errors) return std::nullopt;
    const studies::PatchErrors& errors = *found.patch_errors;
    const studies::Cell& cell = plan.cells[found.cell];
    const Scene& scene = plan.scenes[cell.scene];
    const auto box = unfold_box(scene, cell.subdivision);
    if (!box) return std::nullopt;

    // A patch has its corner only; its size is that of all patches of its face, in the row that labels it.
    PictureValues values({"face", "left", "bottom", "rmse", "label", "width", "height"});
    const auto face_of = [&](std::size_t patch) {
        return scene.faces[static_cast<std::size_t>(scene.surfaces[patch / cell.subdivision.per_part()].face)];
    };
    for (std::size_t patch = 0; patch < box->patches.size(); ++patch) {
        const FlatRectangle& at = box->patches[patch];
        values.add({face_of(patch), drawn(at.left, 4), drawn(at.bottom, 4), drawn(errors.rmse[patch], 3)});
    }
    for (std::size_t surface = 0; surface < box->surfaces.size(); ++surface) {
        const FlatRectangle& at = box->surfaces[surface];
        values.add({nullptr, drawn((at.left + at.right) / 2), drawn((at.bottom + at.top) / 2), nullptr,
                    scene.faces[static_cast<std::size_t>(scene.surfaces[surface].face)],
                    drawn((at.right - at.left) / cell.subdivision.m),
                    drawn((at.top - at.bottom) / cell.subdivision.m)});
    }
    values.set("aspect", drawn((box->extent.top - box->extent.bottom) / (box->extent.right - box->extent.left)));

    const std::string label = cell_label(plan, cell);
    Picture picture = begin_picture("cube", found.cell, label, fmt::format("Where the errors are, {}.", label));
    picture.finding = fmt::format("The factors of a patch err most on face {} (RMSE {})", face_of(errors.worst),
                                  brief(errors.rmse[errors.worst]));
    picture.finding += cell.subdivision.m < 3 ? "."  // all patches are along edges
                                              : fmt::format("; along the edges by {}, elsewhere by {}.",
                                                            brief(errors.at_edges), brief(errors.inside));
    picture.description = fmt::format(
        "The faces laid flat, each patch coloured by the RMSE of its factors to the other faces "
        "in a run. {}",
        picture.finding);
    picture.values = values.text();
    return picture;
}

}  // namespace ff::reports
