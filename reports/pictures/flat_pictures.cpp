#include "core/exact/exact.hpp"
#include "core/geometry/scene.hpp"
#include "core/patches/unfold.hpp"
#include "reports/pictures/picture_values.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "studies/radiosity/systems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>
#include <utility>

namespace ff::reports {

namespace {

using studies::StudyPlan;
using studies::radiosity::Consequences;

/// A quantity of every patch, for a reader to choose among others.
struct Choice {
    std::string label;
    std::vector<double> values;
};

/// The face that a surface belongs to.
const std::string& face_of(const Scene& scene, std::size_t surface) {
    return scene.faces[static_cast<std::size_t>(scene.surfaces[surface].face)];
}

/// Labels of the faces. A patch has its corner only; its size is that of all patches of its face, in the row that
/// labels it.
/// @param beside  what stands between the name of a patch's face and its place
void add_faces(const Scene& scene, Subdivision subdivision, const UnfoldedBox& box, const std::vector<Json>& beside,
               PictureValues& values) {
    for (std::size_t surface = 0; surface < box.surfaces.size(); ++surface) {
        const FlatRectangle& at = box.surfaces[surface];
        std::vector<Json> row{nullptr};
        row.insert(row.end(), beside.begin(), beside.end());
        row.insert(row.end(),
                   {drawn((at.left + at.right) / 2), drawn((at.bottom + at.top) / 2), nullptr, face_of(scene, surface),
                    drawn((at.right - at.left) / subdivision.m), drawn((at.top - at.bottom) / subdivision.m)});
        values.add(std::move(row));
    }
    values.set("aspect", drawn((box.extent.top - box.extent.bottom) / (box.extent.right - box.extent.left)));
}

/// The faces laid flat, every patch with the values of all choices.
class FlatPicture {
  public:
    FlatPicture(const Scene& scene, Subdivision subdivision, UnfoldedBox box)
        : scene_(&scene),
          subdivision_(subdivision),
          box_(std::move(box)),
          values_({"face", "shown", "left", "bottom", "exitance", "label", "width", "height"}) {}

    void add(const Choice& choice) {
        shown_.push_back(choice.label);
        for (std::size_t patch = 0; patch < choice.values.size(); ++patch) {
            const FlatRectangle& at = box_.patches[patch];
            values_.add({face_of(*scene_, patch / subdivision_.per_part()), choice.label, drawn(at.left, 4),
                         drawn(at.bottom, 4), drawn(choice.values[patch], 4)});
        }
    }

    /// @param place  the scene, where there are several
    Picture finish(std::string_view kind, const std::string& place, std::string_view title, std::string finding,
                   std::string_view shown) {
        values_.set("choose", {{"signal", "shown"}, {"label", "Shown"}, {"values", std::move(shown_)}});
        add_faces(*scene_, subdivision_, box_, {nullptr}, values_);
        return picture_of(values_, kind, fmt::format("{}{}", kind, place), fmt::format("{}{}.", title, place),
                          std::move(finding), shown);
    }

  private:
    const Scene* scene_;
    Subdivision subdivision_;
    UnfoldedBox box_;
    PictureValues values_;
    Json shown_ = Json::array();
};

/// Each patch gathers from the faces, whose exitance is that of the system between faces.
std::vector<double> gather(const studies::radiosity::Lighting& lighting, const studies::radiosity::ExactSystem& solved,
                           const Eigen::MatrixXd& to_faces, const Scene& scene, Subdivision subdivision) {
    const Eigen::VectorXd irradiance = to_faces * solved.exitance;
    std::vector<double> exitance;
    for (Eigen::Index patch = 0; patch < irradiance.size(); ++patch) {
        const int face = scene.surfaces[static_cast<std::size_t>(patch) / subdivision.per_part()].face;
        exitance.push_back(lighting.emission[face] + lighting.reflectance[solved.setting][face] * irradiance[patch]);
    }
    return exitance;
}

void scale(std::vector<double>& values, double by) {
    for (double& value : values) value *= by;
}

std::string range_finding(const Choice& choice) {
    const auto [least, largest] = std::minmax_element(choice.values.begin(), choice.values.end());
    return fmt::format("{}: the exitance of patches is {} to {} times the emission.", choice.label, brief(*least),
                       brief(*largest));
}

/// Pictures without systems between patches: the results of exact factors.
std::optional<Picture> gathered_picture(const studies::StudyResults& results, std::size_t scene_index) {
    constexpr Subdivision subdivision{13};
    const StudyPlan& plan = results.findings.plan;
    const Scene& scene = plan.scenes[scene_index];
    auto box = unfold_box(scene, subdivision);
    if (!box) return std::nullopt;
    const auto to_faces = exact_patch_to_face(scene, subdivision);
    if (!to_faces) return std::nullopt;
    FlatPicture flat(scene, subdivision, std::move(*box));
    const studies::radiosity::Lighting lighting = studies::radiosity::light_faces(plan, scene_index);
    std::string finding;
    for (const studies::radiosity::ExactSystem& solved : results.radiosity->exact) {
        if (solved.scene != scene_index || solved.m != 0) continue;
        Choice choice{fmt::format("exact factors, reflectance {}", setting_text(plan, solved.setting)),
                      gather(lighting, solved, *to_faces, scene, subdivision)};
        scale(choice.values, 1 / lighting.emission.maxCoeff());
        if (finding.empty()) finding = range_finding(choice);
        flat.add(choice);
    }
    return flat.finish("exitance", of_scene(plan, scene_index), "The light with exact factors", finding,
                       "The faces laid flat, each patch coloured by its exitance: what it emits, and reflects of the "
                       "light that it gathers from the faces.");
}

/// One treatment of one cell between patches, at a setting that has the quantity to show.
using Visit = std::function<void(const std::string& label, const studies::radiosity::SettingStatistics&)>;

void for_each_lit(const StudyPlan& plan, const studies::radiosity::Results& radiosity,
                  const std::vector<std::size_t>& cells, const Visit& visit) {
    for (std::size_t setting = 0; setting < plan.spec.radiosity->reflectance.size(); ++setting) {
        for (const std::size_t cell : cells) {
            const auto own = studies::radiosity::treatment_of(plan.spec.methods[plan.cells[cell].method].completion);
            for (const studies::radiosity::Treatment treatment : {own, studies::radiosity::Treatment::balanced}) {
                const Consequences* found = radiosity.find(cell, treatment, studies::radiosity::Between::patches);
                if (found == nullptr || found->settings.empty()) continue;
                const studies::radiosity::SettingStatistics& at = found->settings[setting];
                if (!at.light_error) continue;
                visit(fmt::format("{}, {}, {}, reflectance {}", plan.spec.methods[plan.cells[cell].method].name,
                                  size_label(plan, plan.cells[cell]), studies::radiosity::name(treatment),
                                  setting_text(plan, setting)),
                      at);
            }
        }
    }
}

std::vector<Picture> patch_pictures(const studies::StudyResults& results, std::size_t scene_index,
                                    const std::vector<std::size_t>& cells) {
    const StudyPlan& plan = results.findings.plan;
    const Scene& scene = plan.scenes[scene_index];
    const Subdivision subdivision = plan.cells[cells.front()].subdivision;
    const auto box = unfold_box(scene, subdivision);
    if (!box) return {};
    const double unit = 1 / studies::radiosity::light_faces(plan, scene_index).emission.maxCoeff();
    FlatPicture light(scene, subdivision, *box);
    FlatPicture errors(scene, subdivision, *box);
    std::string finding;
    for (const studies::radiosity::ExactSystem& solved : results.radiosity->exact) {
        if (solved.scene != scene_index || solved.m != subdivision.m) continue;
        Choice choice{fmt::format("exact factors, reflectance {}", setting_text(plan, solved.setting)),
                      {solved.exitance.begin(), solved.exitance.end()}};
        scale(choice.values, unit);
        if (finding.empty()) finding = range_finding(choice);
        light.add(choice);
    }
    double largest = 0;
    std::string worst;
    for_each_lit(plan, *results.radiosity, cells, [&](const std::string& label, const auto& at) {
        Choice means{label, {}};
        Choice misses{label, {}};
        for (std::size_t i = 1; i < at.exitance.size(); ++i) {
            const studies::radiosity::ExitanceStatistics& patch = at.exitance[i];
            means.values.push_back(*patch.mean * unit);
            misses.values.push_back(relative_error(patch));
        }
        light.add(means);
        errors.add(misses);
        if (const double most = *std::max_element(misses.values.begin(), misses.values.end()); most > largest) {
            largest = most;
            worst = label;
        }
    });
    std::vector<Picture> pictures{
        light.finish("exitance", of_scene(plan, scene_index), "The light on the patches", finding,
                     "The faces laid flat, each patch coloured by its exitance: with exact factors, and the mean over "
                     "trials of a method.")};
    if (worst.empty()) return pictures;
    pictures.push_back(errors.finish(
        "exitance_errors", of_scene(plan, scene_index), "Where the exitance is wrong",
        fmt::format("The patch with the largest error is off by {} of its own exitance: {}.", percent(largest), worst),
        "The faces laid flat, each patch coloured by the RMSE of its exitance over trials, relative to the exact "
        "one."));
    return pictures;
}

}  // namespace

std::vector<Picture> exitance_pictures(const studies::StudyResults& results, std::size_t scene) {
    const StudyPlan& plan = results.findings.plan;
    std::vector<std::size_t> cells;
    for (const std::size_t cell : lit_cells(plan, scene)) {
        const bool has = results.radiosity->find(cell, studies::radiosity::Treatment::direct,
                                                 studies::radiosity::Between::patches) != nullptr;
        if (has && (cells.empty() || plan.cells[cell].subdivision.m == plan.cells[cells.front()].subdivision.m))
            cells.push_back(cell);
    }
    if (!cells.empty()) return patch_pictures(results, scene, cells);
    const auto gathered = gathered_picture(results, scene);
    return gathered ? std::vector<Picture>{*gathered} : std::vector<Picture>{};
}

std::optional<Picture> unfolded_picture(const studies::StudyResults& results, std::size_t index) {
    const StudyPlan& plan = results.findings.plan;
    const studies::CellAnalysis& found = results.findings.cells[index];
    if (!found.patch_errors) return std::nullopt;
    const studies::PatchErrors& errors = *found.patch_errors;
    const studies::Cell& cell = plan.cells[found.cell];
    const Scene& scene = plan.scenes[cell.scene];
    const auto box = unfold_box(scene, cell.subdivision);
    if (!box) return std::nullopt;

    PictureValues values({"face", "left", "bottom", "rmse", "label", "width", "height"});
    const auto face = [&](std::size_t patch) { return face_of(scene, patch / cell.subdivision.per_part()); };
    for (std::size_t patch = 0; patch < box->patches.size(); ++patch) {
        const FlatRectangle& at = box->patches[patch];
        values.add({face(patch), drawn(at.left, 4), drawn(at.bottom, 4), drawn(errors.rmse[patch], 3)});
    }
    add_faces(scene, cell.subdivision, *box, {}, values);

    std::string finding = fmt::format("The factors of a patch err most on face {} (RMSE {})", face(errors.worst),
                                      brief(errors.rmse[errors.worst]));
    finding += cell.subdivision.m < 3 ? "."  // all patches are along edges
                                      : fmt::format("; along the edges by {}, elsewhere by {}.", brief(errors.at_edges),
                                                    brief(errors.inside));
    return picture_of_cell(
        values, "cube", found.cell, cell_label(plan, cell), "Where the errors are", finding,
        "The faces laid flat, each patch coloured by the RMSE of its factors to the other faces in a "
        "run.");
}

}  // namespace ff::reports
