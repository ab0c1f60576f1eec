#pragma once

#include "studies/results/results.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

/// The methods that a picture shows: the named ones, or all.
struct MethodChoice {
    std::vector<std::string> names;  ///< empty: all
    [[nodiscard]] bool has(const std::string& method) const {
        return names.empty() || std::find(names.begin(), names.end(), method) != names.end();
    }
};

/// A picture of a report: its content in words and numbers. A file of reports/pictures/ tells how to draw it.
struct Picture {
    std::string id;    ///< letters, digits and -; unique in a report, and the name of its file
    std::string kind;  ///< the specification that draws it, e.g. "bias_map"
    std::string title;
    std::string finding;      ///< one sentence, computed from the results
    std::string description;  ///< text alternative: what is drawn, and the finding
    /// JSON: `columns`, `rows`; optionally `isolate` (series that can be shown alone), `choose` (`signal`, `label`,
    /// `values` to choose from, the first at the start), `signals` (values of others), `aspect` (height / width), `log`
    /// and `tall` (x axis logarithmic, on top), `labels` (at the ends of lines), `titles` (of axes, by scale), `scales`
    /// (domain and range, by scale).
    std::string values;
    std::string name = {};                   ///< its name among the alternatives
    std::vector<Picture> alternatives = {};  ///< pictures of the same kind to choose instead
};

/// Pictures that belong together.
struct PictureGroup {
    std::string title;
    bool compared = false;  ///< whether the answer compares the method: such groups come first
    std::vector<Picture> pictures;
};

/// The picture beside the answer; empty where there is nothing to compare. It may also be one of the others.
std::optional<Picture> lead_picture(const studies::StudyResults& results, const MethodChoice& methods = {});

/// The numbers that the answer compares, a row for each method; empty where it compares none. It is the picture beside
/// the answer where no other shows more.
std::optional<Picture> answer_ranking(const studies::StudyResults& results, const MethodChoice& methods = {});

/// Error against evaluations of the methods that a publication compares, at all sizes, with the errors of its figures;
/// empty where no kind of pairs has two such methods. @pre results.published
std::optional<Picture> publication_picture(const studies::StudyResults& results, const MethodChoice& methods = {});

/// Errors of all methods at about the same number of evaluations, smallest first; for each number that several have.
std::vector<Picture> errors_at_sizes(const studies::StudyResults& results, const MethodChoice& methods = {});

/// Error and efficiency against evaluations of all scenes; in a study of occlusion, error against the occluded fraction
/// at the common number of samples of a pair instead, for each family of scenes.
std::vector<Picture> pictures_by_size(const studies::StudyResults& results, const MethodChoice& methods = {});

/// How often errors are within the claimed ones; empty where no error is claimed but that of rays taken as random, and
/// that holds.
std::optional<Picture> claims_picture(const studies::StudyResults& results);

/// All groups of a report; those of the methods that the verdict compares come first.
std::vector<PictureGroup> picture_groups(const studies::StudyResults& results);

/// Exitance errors, spectral radius, residuals, exitance; empty where the study has no [radiosity].
std::optional<PictureGroup> radiosity_pictures(const studies::StudyResults& results);

/// The radiant exitance on the unfolded box, exact and by each method, and its errors.
std::vector<Picture> exitance_pictures(const studies::StudyResults& results, std::size_t scene);

/// Pictures of one cell, by its index in the analysis; empty where it has nothing to draw.
std::optional<Picture> unfolded_picture(const studies::StudyResults& results, std::size_t index);
std::optional<Picture> estimates_picture(const studies::StudyResults& results, std::size_t cell);

}  // namespace ff::reports
