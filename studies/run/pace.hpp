#pragma once

#include "studies/plan/plan.hpp"

#include <vector>

namespace ff::studies {

/// How far a run is, in processor time. The prices of the plan are guesses, above all those of a user's programs: what
/// the trials of a method have taken corrects them. A method that has not begun is taken to be off by as much as all
/// others together.
class Pace {
  public:
    explicit Pace(const StudyPlan& plan) : plan_(plan), methods_(plan.spec.methods.size()) {}

    /// Forgets which units there are, and keeps what was learnt about prices.
    void begin_round();
    /// Counts a unit of this round. @param done  it has results  @param before  it had them before the run began
    void count(const WorkUnit& unit, bool done, bool before);
    /// One of the counted units is done now. @param processor_seconds  that it took; 0 where nobody measured
    void finish(const WorkUnit& unit, double processor_seconds);

    /// Of all counted units, of those that are done, and of those that were done before the run began.
    struct Seconds {
        double all = 0;
        double done = 0;
        double before = 0;
    };
    [[nodiscard]] Seconds seconds() const;

  private:
    struct OfMethod {
        Seconds price;
        double price_of_measured = 0;
        double measured = 0;
    };
    [[nodiscard]] double price(const WorkUnit& unit) const;
    [[nodiscard]] OfMethod& method_of(const WorkUnit& unit) { return methods_[plan_.cells[unit.cell].method]; }

    const StudyPlan& plan_;
    std::vector<OfMethod> methods_;
};

}  // namespace ff::studies
