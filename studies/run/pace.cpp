#include "studies/run/pace.hpp"

namespace ff::studies {

double Pace::price(const WorkUnit& unit) const {
    return static_cast<double>(unit.trials) * expected_seconds_per_trial(plan_, plan_.cells[unit.cell]);
}

void Pace::begin_round() {
    for (OfMethod& method : methods_) method.price = {};
}

void Pace::count(const WorkUnit& unit, bool done, bool before) {
    const double seconds = price(unit);
    Seconds& sums = method_of(unit).price;
    sums.all += seconds;
    if (done) sums.done += seconds;
    if (before) sums.before += seconds;
}

void Pace::finish(const WorkUnit& unit, double processor_seconds) {
    const double seconds = price(unit);
    OfMethod& method = method_of(unit);
    method.price.done += seconds;
    if (processor_seconds <= 0) return;
    method.price_of_measured += seconds;
    method.measured += processor_seconds;
}

Pace::Seconds Pace::seconds() const {
    double measured = 0;
    double price_of_measured = 0;
    for (const OfMethod& method : methods_) {
        measured += method.measured;
        price_of_measured += method.price_of_measured;
    }
    Seconds sums;
    for (const OfMethod& method : methods_) {
        const double correction = method.measured > 0 ? method.measured / method.price_of_measured
                                  : measured > 0      ? measured / price_of_measured
                                                      : 1.0;
        sums.all += correction * method.price.all;
        sums.done += correction * method.price.done;
        sums.before += correction * method.price.before;
    }
    return sums;
}

}  // namespace ff::studies
