#pragma once

#include "studies/plan/plan.hpp"
#include "studies/run/run.hpp"

#include <cstdint>
#include <map>
#include <string>

namespace ff::studies {

/// Processor time that a run measures of methods whose cost no table knows: programs and functions of a user.
class MeasuredCosts {
  public:
    explicit MeasuredCosts(const StudyPlan& plan) : plan_(plan) {}

    void add(const Progress& progress);

    /// "mine at 64: 0.0312 s, mine at 256: 0.124 s" by method and size, over all scenes and patches; empty where
    /// nothing was measured.
    [[nodiscard]] std::string in_words() const;

  private:
    struct Sum {
        std::uint64_t trials = 0;
        double seconds = 0;
    };
    const StudyPlan& plan_;
    std::map<std::pair<std::size_t, std::uint64_t>, Sum> sums_;  ///< by method and size
};

}  // namespace ff::studies
