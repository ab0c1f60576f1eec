#pragma once

#include "core/geometry/subdivision.hpp"
#include "core/points/stream.hpp"
#include "studies/spec/spec.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace ff::studies {

/// One (scene, method, size) of a study, for which a set of trials is run.
struct Cell {
    std::size_t scene = 0;   ///< index into StudyPlan::scenes
    std::size_t method = 0;  ///< index into StudySpec::methods
    Subdivision subdivision;
    std::uint64_t samples_per_patch =
        0;                     ///< rays or points per patch, or points per ordered patch pair; 0 for closed_form
    std::uint64_t trials = 0;  ///< 1 for a deterministic method
    bool deterministic = false;
    std::string canonical;  ///< identifies scene, sampler, estimator and size, never their order or the completion
    StreamKey key;          ///< key of its random numbers, from `canonical` and the seed
};

/// Consecutive trials of one cell: the unit of work, of saving and of distribution.
struct WorkUnit {
    std::size_t index = 0;
    std::size_t cell = 0;
    std::uint64_t first_trial = 0;
    std::uint64_t trials = 0;
};

/// The scenes of a study, in its order. Copies share them.
class Scenes {
  public:
    Scenes() = default;
    explicit Scenes(std::vector<Scene> scenes);

    [[nodiscard]] std::size_t size() const;
    [[nodiscard]] const Scene& operator[](std::size_t index) const;
    [[nodiscard]] const Scene& front() const { return (*this)[0]; }
    [[nodiscard]] const Scene* begin() const;
    [[nodiscard]] const Scene* end() const;
    [[nodiscard]] const std::string& name(std::size_t index) const;
    [[nodiscard]] const std::vector<std::string>& faces(std::size_t index) const;  ///< their labels
    [[nodiscard]] bool is_closed(std::size_t index) const;

  private:
    std::shared_ptr<const std::vector<Scene>> scenes_;
};

/// A validated study with every seed and work unit fixed; identical on every machine.
struct StudyPlan {
    StudySpec spec;
    Scenes scenes;
    std::vector<Cell> cells;
    std::vector<WorkUnit> units;
    std::vector<std::string> warnings;  ///< notes on sizes at which a sampler is not at its best
};

/// @throws UserError where scene, sampler and estimator do not fit
StudyPlan plan_study(StudySpec spec);

/// Appends the work units for consecutive trials of one cell, all of about equal length; their index is their place in
/// `units`.
void add_units(const StudyPlan& plan, std::size_t cell, std::uint64_t first_trial, std::uint64_t end_trial,
               std::vector<WorkUnit>& units);

/// Points of one sequence of a cell: those of one patch, or of all patches of a part of a surface's grid that share a
/// sequence.
std::uint64_t points_per_sequence(const Method& method, Subdivision subdivision, std::uint64_t samples);

/// Evaluations (rays, kernel values, or points that see all faces) of one trial of a cell.
std::uint64_t evaluations_per_trial(const StudyPlan& plan, const Cell& cell);

/// Expected seconds of one trial on one core, from a table of costs; never measured, so that plans are repeatable.
double expected_seconds_per_trial(const StudyPlan& plan, const Cell& cell);

/// Most patches of a scene between which systems are solved: 800 MB per matrix, of which several are needed at a time.
/// Sums of kernels are kept for every pair meanwhile.
inline constexpr std::uint32_t most_traced_patches = 10'000;
inline constexpr std::uint32_t most_kernel_patches = 3000;

/// Whether a trial of the cell gives factors between patches: rays and kernels do, where faces are divided.
bool tells_patches_apart(const StudyPlan& plan, std::size_t index);

/// Whether the study asks for systems between the patches of this cell.
bool has_patch_systems(const StudyPlan& plan, std::size_t index);

/// How many of the cell's trials enter them.
std::uint64_t patch_trials(const StudyPlan& plan, std::size_t index);

/// @throws UserError where a cell has more patches than the limit above, or lacks exact factors
/// @pre tells_patches_apart
void expect_few_patches(const StudyPlan& plan, std::size_t index);

/// Checks that a method can be used in a scene.
/// @throws UserError with the reason that its estimator gives
void expect_applicable(const Method& method, const Scene& scene);

}  // namespace ff::studies
