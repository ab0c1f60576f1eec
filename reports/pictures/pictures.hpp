#pragma once

#include "reports/pictures/method_choice.hpp"
#include "studies/results/results.hpp"

#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// A picture of a report: what it shows in words and in numbers. How it is drawn is a file of reports/pictures/.
struct Picture {
    std::string id;    ///< letters, digits and -; unique in a report, and the name of its file
    std::string kind;  ///< the specification that draws it, e.g. "bias_map"
    std::string title;
    std::string finding;      ///< one sentence, computed from the results
    std::string description;  ///< for those who cannot see it: what is drawn, and the finding
    /// JSON: `columns`, `rows`; optionally `isolate` (series that can be shown alone), `choose` (`signal`, `label`,
    /// `values`: what can be chosen, the first at the start), `signals` (values of others), `aspect` (height / width),
    /// `log` (x axis), `labels` (rows that are drawn and are no data), `titles` (of axes, by scale), `scales` (domain
    /// and range, by scale).
    std::string values;
};

/// Pictures that belong together.
struct PictureGroup {
    std::string title;
    bool open = false;  ///< whether they are shown at once
    std::vector<Picture> pictures;
};

/// The one beside the answer; empty where there is nothing to compare. It may be one of the others too.
std::optional<Picture> lead_picture(const studies::StudyResults& results, const MethodChoice& methods = {});

/// Error and efficiency against evaluations, over these methods, for each class of pairs.
std::vector<Picture> pictures_of_scene(const studies::StudyResults& results, std::size_t scene,
                                       const MethodChoice& methods = {});

/// Those of all scenes; in a study of occlusion error against the occluded share instead.
std::vector<Picture> pictures_by_size(const studies::StudyResults& results, const MethodChoice& methods = {});

/// Of one cell: the unfolded faces, estimates, bias, and the distribution of errors, as far as it has them.
std::vector<Picture> pictures_of_cell(const studies::StudyResults& results, std::size_t cell);

/// Error against the occluded share at the common number of evaluations, for each family of scenes.
std::vector<Picture> occlusion_pictures(const studies::StudyResults& results, const MethodChoice& methods = {});

/// All groups of a report; that of the methods which the verdict compares are open.
std::vector<PictureGroup> picture_groups(const studies::StudyResults& results);

/// Errors of the light, spectral radius, residuals, exitance; empty where the study has no [radiosity].
std::optional<PictureGroup> radiosity_pictures(const studies::StudyResults& results);

/// The unfolded box in radiant exitance, with exact factors and as methods give it, and where that errs.
std::vector<Picture> exitance_pictures(const studies::StudyResults& results, std::size_t scene);

std::optional<Picture> unfolded_picture(const studies::StudyResults& results, std::size_t index);
std::optional<Picture> estimates_picture(const studies::StudyResults& results, std::size_t cell);
std::optional<Picture> bias_picture(const studies::StudyResults& results, std::size_t cell);
/// Box plots, histogram, quantiles.
std::vector<Picture> distribution_pictures(const studies::StudyResults& results, std::size_t cell);

}  // namespace ff::reports
