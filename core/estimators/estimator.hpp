#pragma once

#include "core/geometry/subdivision.hpp"
#include "core/patches/patch_order.hpp"
#include "core/points/points.hpp"
#include "core/tracing/tracer.hpp"
#include "core/visibility/pair_class.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ff {

/// The kind of data that a trial observes.
enum class Observes {
    hits,       ///< how many of the cosine-distributed rays from each face hit each other face
    estimates,  ///< a real number for each form factor
};

/// The part of the scene that one set of points is used for.
enum class PointsServe {
    nothing,  ///< no points are taken
    patches,  ///< one set for each patch of the source and all that it sees: `allocation` says whose the sequence is
    pairs,    ///< one set for each ordered pair of patches
    scene,    ///< one set for all of it
};

/// Whether form factors of single patches are kept, and how.
enum class PatchFactors { none, rays, kernels };

/// The kind of integrand, as theories of convergence distinguish them.
enum class Integrand {
    jumping,  ///< smooth except for jumps at curved boundaries parallel to no axis: the rays that hit, the kernel
              ///< of points that see each other
    smooth,
    rough,      ///< has a finite variance, but no theory of smooth or of jumping functions holds
    unbounded,  ///< has an infinite variance, with tail index 3/2
};

/// The integrand on adjacent faces and on others; empty where theory says nothing.
struct Integrands {
    std::optional<Integrand> apart;
    std::optional<Integrand> adjacent;
};

/// Whether something may stand between the faces of a pair.
enum class Hiding { none, possible };

/// How 4-D points are placed on a pair of patches.
enum class PointMap {
    uniform,  ///< evenly
    graded,   ///< denser towards an edge or a vertex that the patches share, with weights to match
};

/// The choices of a study besides the sampler, if the estimator has the option.
struct EstimatorOptions {
    Allocation allocation = Allocation::patch;
    TracerChoice tracer = TracerChoice::automatic;
    PointMap map = PointMap::uniform;
};

/// The declaration of an estimator; study files, plans, `ffstudy list`, `explain`, the contract tests and the
/// reports read it.
struct EstimatorInfo {
    std::string_view name;
    std::string_view summary;    ///< one line, shown by `ffstudy list estimators`
    std::string_view details;    ///< what it is, its limits; shown by `ffstudy explain`
    std::string_view reference;  ///< key of docs/references.md
    std::size_t dimension = 0;   ///< coordinates of a point; 0: it takes none
    PointsServe points = PointsServe::nothing;
    Observes observes = Observes::estimates;
    PatchFactors patch_factors = PatchFactors::none;
    bool own_points = false;        ///< makes its own: samples_per_patch counts them
    bool randomised = false;        ///< they differ from trial to trial
    bool whole_faces = false;       ///< faces are not divided into patches
    bool has_tracer = false;        ///< takes the option `tracer`
    bool has_map = false;           ///< takes the option `map`
    bool exact = false;             ///< no error except rounding: a reference, not a competitor
    bool sees_occluders = false;    ///< obstacles between two faces are noticed
    bool sees_reflections = false;  ///< light by way of mirrors is counted
    bool needs_polygons = false;    ///< faces have to be parallelograms and triangles
    /// Largest value of one evaluation, none being negative; infinite where none is known.
    double largest_value = std::numeric_limits<double>::infinity();
    std::string_view evaluations = "evaluations";  ///< what is counted as its work
    double nanoseconds = 0;      ///< what an evaluation takes, where that does not depend on the scene: EstimatorEntry
    Integrands integrands = {};  ///< where they depend on nothing else

    [[nodiscard]] constexpr bool takes_points() const { return dimension > 0; }
    [[nodiscard]] constexpr bool has_allocation() const { return points == PointsServe::patches; }
};

/// One trial of one cell.
struct EstimatorTask {
    Subdivision subdivision;
    const PointSource* points = nullptr;  ///< null where the estimator takes none
    std::uint64_t samples = 0;            ///< points for a patch, or for a pair of patches; 0 where there are none
    EstimatorOptions options;
    StreamKey key;
    std::uint32_t trial = 0;
};

/// Integer outcome of one trial that shoots rays.
struct RayTally {
    std::vector<std::uint64_t> hits;  ///< [from_face * faces + to_face]
    std::vector<std::uint64_t> rays;  ///< [from_face]
    std::vector<std::uint64_t> lost;  ///< [from_face]
    /// [from_face * faces + to_face], the hits of each surface times the area of a part of its grid, summed in the
    /// order of surfaces: faces of several surfaces are averages by area.
    std::vector<double> weighted;
};

/// The data that one trial observed.
struct Outcome {
    RayTally rays;              ///< counts of an estimator with `Observes::hits`; empty otherwise
    Eigen::MatrixXd estimates;  ///< between faces; of `Observes::hits`, shares by area
    Eigen::MatrixXd claims;     ///< claimed error of each estimate; empty where nothing is claimed
};

/// Sums over trials of patch-to-face hits and of their squares, [patch * faces + face]; exact integers.
struct PatchSums {
    std::vector<std::uint64_t> hits;
    std::vector<std::uint64_t> hits_squared;
};

/// Sums over trials of patch-to-face factors and of their squares, [patch * faces + face].
struct PatchFactorSums {
    std::vector<double> factors;
    std::vector<double> factors_squared;
};

/// Totals by patch: at most one of the two is filled.
struct PatchTotals {
    PatchSums hits;
    PatchFactorSums factors;
};

/// An estimator prepared for one scene, which has to outlive it. Safe to use from several threads at once.
class Estimator {
  public:
    virtual ~Estimator() = default;

    /// A pure function of scene and task, the same bits on every CPU. `outcome` is replaced, `totals` added to (empty,
    /// or from earlier trials of the same size).
    virtual void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& totals) const = 0;

  protected:
    Estimator() = default;
    Estimator(const Estimator&) = default;
    Estimator& operator=(const Estimator&) = default;
    Estimator(Estimator&&) = default;
    Estimator& operator=(Estimator&&) = default;
};

/// An estimator in the catalogue: what it declares, and how it is made ready for a scene.
struct EstimatorEntry {
    EstimatorInfo info;

    /// Why it cannot be used in a scene, and what to do: "the scene is not ... (why). Try ...". Empty where it can.
    std::function<std::string(const EstimatorOptions& options, const Scene& scene)> refusal;

    /// Why samples_per_patch cannot have this value, and which it can have: "(why). Try ...". Empty where it can. For
    /// estimators with points of their own.
    std::string (*size_problem)(std::uint64_t samples);

    /// The samples_per_patch of a resolution r, as pixels a side of what they are laid on; 0 where there is none. Null
    /// for estimators without a resolution.
    std::uint64_t (*samples_of_resolution)(std::uint64_t resolution) = nullptr;

    /// Processor time of one evaluation beside that of its point; only ratios matter, for units of about equal length.
    double (*nanoseconds)(const EstimatorOptions& options, const Scene& scene);

    /// How theory classifies the integrand on a pair of faces; empty where it says nothing.
    std::optional<Integrand> (*integrand)(const EstimatorOptions& options, PairClass pair_class, Hiding hiding);

    /// Whether random points have a variance between two faces, from 0.
    bool (*finite_variance)(const EstimatorOptions& options, const Scene& scene, int from, int to);

    /// How large the values between two faces, from 0, may be at places that so many evaluations may all miss: where a
    /// blocker begins, a ray just misses, little of one face is in front of the other, or a small surface is close to a
    /// large one. 0 where there are no such places or, for added estimators, where nothing is known of them; infinite
    /// where no bound is known.
    double (*largest_unmet)(const Scene& scene, int from, int to, double evaluations);

    std::function<std::unique_ptr<Estimator>(const Scene& scene, TracerChoice tracer)> make;
};

/// All estimators of the catalogue, in the order in which they are listed.
std::span<const EstimatorEntry> estimators();

/// An estimator of the catalogue, or an added one. @throws UserError with the nearest name
const EstimatorEntry& find_estimator(std::string_view name);

}  // namespace ff
