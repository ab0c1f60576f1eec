#pragma once

#include "core/estimators/estimator.hpp"

#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace ff {

/// An estimator from outside the catalogue, as a program that prints form factors. Where it has been added,
/// `find_estimator` finds it by its name like any other.
class AddedEstimator {
  public:
    struct Texts {
        std::string name;
        std::string summary;
        std::string details;
    };
    using Refusal = std::function<std::string(const Scene&)>;
    using Make = std::function<std::unique_ptr<Estimator>(const Scene&)>;

    /// @param traits  all of EstimatorInfo but its texts
    /// @param refusal  beyond what follows from `traits`: why it cannot be used in a scene; null: it always can
    /// @param make  null where only the description is known, as to those who read results
    AddedEstimator(Texts texts, EstimatorInfo traits, Refusal refusal, Make make);
    AddedEstimator(const AddedEstimator&) = delete;
    AddedEstimator& operator=(const AddedEstimator&) = delete;
    ~AddedEstimator() = default;

    [[nodiscard]] const EstimatorEntry& entry() const { return entry_; }

    /// Is made as `other` is from now on, where nothing has made it so far.
    void learn_from(AddedEstimator& other);

  private:
    Texts texts_;
    mutable std::mutex mutex_;
    Refusal refusal_;
    Make make_;
    EstimatorEntry entry_;
};

/// Of a program that gets the scene as a file and prints form factors between whole faces.
/// @param has_sizes  it takes samples_per_patch
EstimatorInfo program_traits(bool has_sizes, bool randomised);

/// Adds an estimator for the rest of the process; one of its name that is there already stays. Safe from any thread.
/// @param short_name  by which it is found as well from now on; empty: none
/// @throws UserError where a name is one of the catalogue
const EstimatorEntry& add(std::unique_ptr<AddedEstimator> estimator, const std::string& short_name = {});

/// By name or short name. Null where there is none.
const AddedEstimator* find_added_estimator(std::string_view name);

}  // namespace ff
