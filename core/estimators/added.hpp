#pragma once

#include "core/estimators/estimator.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace ff {

/// An estimator from outside the catalogue, e.g. a program that prints form factors. Once added, `find_estimator` finds
/// it by name like any other.
class AddedEstimator {
  public:
    struct Texts {
        std::string name;
        std::string summary;
        std::string details;
    };
    using Refusal = std::function<std::string(const Scene&)>;
    using Make = std::function<std::unique_ptr<Estimator>(const Scene&)>;

    /// @param traits EstimatorInfo without its texts
    /// @param refusal why it cannot be used in a scene, beyond what follows from `traits`; null: it always can
    /// @param make null where only the description is known, as when stored results are read
    AddedEstimator(Texts texts, EstimatorInfo traits, Refusal refusal, Make make);
    AddedEstimator(const AddedEstimator&) = delete;
    AddedEstimator& operator=(const AddedEstimator&) = delete;
    ~AddedEstimator() = default;

    [[nodiscard]] const EstimatorEntry& entry() const { return entry_; }

    /// From now on this makes estimators as `other` does, unless it has made one already.
    void learn_from(AddedEstimator& other);

  private:
    Texts texts_;
    mutable std::mutex mutex_;
    Refusal refusal_;
    Make make_;
    EstimatorEntry entry_;
};

/// Results of outside code in a trial: form factors between faces and, if it claims them, bounds of their errors.
struct OutsideFactors {
    Eigen::MatrixXd estimates;
    Eigen::MatrixXd errors;  ///< empty, or as large as the estimates

    [[nodiscard]] bool operator==(const OutsideFactors& other) const {
        return errors.size() == other.errors.size() && estimates == other.estimates && errors == other.errors;
    }
    /// Whether some estimate is neither 0 nor 1. Where rays seldom hit, or seldom miss, trials without such an estimate
    /// are often equal.
    [[nodiscard]] bool is_telling() const { return ((estimates.array() != 0) && (estimates.array() != 1)).any(); }
};

/// Traits of a program that receives the scene as a file and prints form factors between whole faces.
/// @param has_sizes  it takes samples_per_patch
/// @param nanoseconds  EstimatorInfo::nanoseconds, here of a whole trial: nobody knows what a program does in it. By
/// default long enough for each trial to be a unit of work, saved when it is done and a thread's own
EstimatorInfo program_traits(bool has_sizes, bool randomised, double nanoseconds = 2e8);

/// Adds an estimator for the rest of the process; one that already has its name stays. Safe from any thread.
/// @param short_name another name for it; empty: none
/// @throws UserError where a name is taken by the catalogue
const EstimatorEntry& add(std::unique_ptr<AddedEstimator> estimator, const std::string& short_name = {});

/// The estimator with this name or short name; null where there is none.
const AddedEstimator* find_added_estimator(std::string_view name);

}  // namespace ff
