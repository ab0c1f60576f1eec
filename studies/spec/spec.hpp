#pragma once

#include "core/estimators/estimator.hpp"
#include "core/points/stream.hpp"
#include "studies/readers/names.hpp"
#include "studies/scene_files/scene_source.hpp"
#include "studies/spec/sections.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// How the face-to-face matrix is filled from direct estimates.
enum class Completion {
    direct,      ///< every row from its own samples
    reciprocal,  ///< (j, i) with j > i follows from (i, j): A_j F_ji = A_i F_ij, as in the paper
};

template <>
inline constexpr auto names_of<Completion> = name_table(Named{Completion::direct, "direct"},
                                                        Named{Completion::reciprocal, "reciprocal"});
template <>
inline constexpr auto names_of<Allocation> = name_table(Named{Allocation::patch, "patch"},
                                                        Named{Allocation::face, "face"});
template <>
inline constexpr auto names_of<TracerChoice> = name_table(Named{TracerChoice::automatic, "automatic"},
                                                          Named{TracerChoice::box, "box"},
                                                          Named{TracerChoice::embree, "embree"},
                                                          Named{TracerChoice::leaky, "leaky", false});  // a control
template <>
inline constexpr auto names_of<PointMap> = name_table(Named{PointMap::uniform, "uniform"},
                                                      Named{PointMap::graded, "graded"});

/// Gauss-Legendre nodes per side on the source and on the target patch.
struct Nodes {
    std::uint32_t source = 0;
    std::uint32_t target = 0;  ///< 0 where points lie on the source alone
    auto operator<=>(const Nodes&) const = default;
};

/// One size at which a method is run.
struct Size {
    std::uint32_t patches_per_face = 1;              ///< a square m * m
    std::optional<std::uint64_t> samples_per_patch;  ///< empty for methods that take no samples
    std::optional<std::uint64_t> trials;             ///< where it differs from the study's
    auto operator<=>(const Size&) const = default;
};

/// A method: sampler x estimator, with its sizes.
struct Method {
    std::string name;
    std::string sampler;                     ///< empty where the estimator takes no points
    std::string estimator = "ray_shooting";  ///< name in the catalogue of estimators, core/estimators/estimator.hpp
    Completion completion = Completion::direct;
    Allocation allocation = Allocation::patch;
    TracerChoice tracer = TracerChoice::automatic;
    PointMap map = PointMap::uniform;
    std::optional<Nodes> nodes;
    std::optional<double> claimed_error;  ///< error of every factor that the method's author claims, > 0
    std::optional<double> claimed_level;  ///< share of errors that should be at most as claimed; empty: all
    std::vector<Size> sizes;
    auto operator<=>(const Method&) const = default;
};

/// The declaration of a method's estimator.
const EstimatorInfo& estimator_info(const Method& method);

/// Whether trials differ: by the sampler, or by the estimator's own points.
bool is_randomised(const Method& method);
/// The method's choice of the estimator's options.
EstimatorOptions estimator_options(const Method& method);

/// A tables file that a study is compared with; its text is kept with the results.
struct Published {
    std::string file;
    std::string text;
    auto operator<=>(const Published&) const = default;
};

/// The treatment of a method in a scene in which it cannot be used.
enum class Inapplicable {
    refuse,  ///< refuse the study
    skip,    ///< leave the method out there, with a warning
};
template <>
inline constexpr auto names_of<Inapplicable> = name_table(Named{Inapplicable::refuse, "refuse"},
                                                          Named{Inapplicable::skip, "skip"});

/// The content of a study file. Everything that results depend on is here.
struct StudySpec {
    std::string name;
    std::string title;
    std::vector<SceneSource> scenes;
    Inapplicable inapplicable = Inapplicable::refuse;
    std::uint64_t trials = 0;
    Seed seed;
    double level =
        0.95;  ///< coverage of every interval, and 1 - the family-wise error rate of the bias tests; in (0.5, 1)
    double power = 0.9;                        ///< power of minimum detectable biases, in [0.5, 1 - 1e-9]
    std::optional<double> equivalence_margin;  ///< |bias| is to be shown smaller than this, in units of the form factor
    std::vector<Method> methods;
    std::optional<StoppingRule> until;    ///< rule of an adaptive study, whose `trials` is an upper limit
    std::vector<std::uint64_t> coverage;  ///< numbers of trials for which to check intervals; may be empty
    std::optional<RadiosityRequest> radiosity;
    std::optional<Published> published;
    auto operator<=>(const StudySpec&) const = default;
};

class TomlReader;

/// Reads a [[method]] table, or one with more keys than a method has.
/// @throws UserError
Method read_method(const TomlReader& reader, std::span<const std::string_view> other_keys = {});

/// The scenes that `scene` names: one or a list without repetitions.
/// @throws UserError
std::vector<SceneSource> read_scenes(const TomlReader& reader);

/// Parses the text of a study file; `origin` names it in messages.
/// @throws UserError "origin:line:column: problem (why). Suggestion."
StudySpec parse_study(std::string_view text, std::string_view origin);

/// Reads the scenes and the tables file that a parsed study names, from its folder.
/// @throws IoError, UserError
void read_named_files(StudySpec& spec, const std::filesystem::path& folder);

/// Reads a study file and the files that it names.
/// @throws IoError, UserError
StudySpec load_study(const std::filesystem::path& file);

/// The spec as a study file in canonical form: `parse_study(to_toml(spec))` is `spec`, without the text of the tables.
std::string to_toml(const StudySpec& spec);

/// Why a cell cannot have that many trials: "(why). Suggestion."; empty where it can.
std::string problem_with_trials(std::uint64_t trials);

/// Sets the number of trials; sizes with a number of their own keep their share of it, at least 2.
/// @throws UserError  if there are fewer than 2, more than 2^32, or fewer than a pilot needs
void set_trials(StudySpec& spec, std::uint64_t trials);

}  // namespace ff::studies
