#include "studies/verdicts/reported/reported_spreads.hpp"

#include "studies/verdicts/at_gate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace ff::studies::gates {
namespace {

/// Degrees of freedom of a variance of n samples: its own variance is that of normal ones plus what their kurtosis adds
/// [box1953]. A mean with its error does not show the kurtosis: 0 where none is declared.
double freedom_of_variance(const Gate& gate, double n) {
    return gate.kurtosis ? 2 / ((*gate.kurtosis - 3) / n + 2 / (n - 1)) : 0;
}

std::string about_samples(const Gate& gate) {
    if (gate.kurtosis)
        return fmt::format("takes the n samples behind each error for independent, of kurtosis {:g} at most",
                           *gate.kurtosis);
    return "how far a standard deviation may be off depends on the kurtosis of the samples, which no mean with its "
           "error shows: add kurtosis = 3 where they are about normal, as batches are, or the largest that they may "
           "have, or give trials";
}

}  // namespace

void compare_spreads(BinComparison& comparing) {
    if (!comparing.bins.file->has_n)
        refuse_gate(comparing.gate,
                    fmt::format("kind = \"std\" needs the column 'n' of {} (the error of a mean of how many "
                                "values?). Add it.",
                                comparing.bins.file->origin));
    comparing.effects.scale = EffectScale::ratio_of_deviations;
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        double squares = 0;
        double weights = 0;
        double freedom = 0;
        for (const ReportedRow& run : comparing.bins.runs_of(bin)) {
            squares += run.standard_error * run.standard_error * run.n * (run.n - 1);
            weights += run.n - 1;
            freedom += freedom_of_variance(comparing.gate, run.n);
        }
        if (squares == 0) {
            ++comparing.empty;
            continue;
        }
        comparing.add_ratio(bin, std::sqrt(squares / weights) / *comparing.gate.reference, freedom,
                            std::numeric_limits<double>::infinity());
    }
    add_note(comparing.note, about_samples(comparing.gate));
}

void compare_efficiencies(BinComparison& comparing, const Bins& against) {
    for (const Bins* bins : {&std::as_const(comparing).bins, &against}) {
        if (!bins->file->has_n || bins->runs != 1)
            refuse_gate(comparing.gate,
                        fmt::format("kind = \"efficiency\" needs one run with the column 'n' in {} (an error of "
                                    "how many values?). Add it.",
                                    bins->file->origin));
    }
    const bool by_cost = comparing.bins.file->has_cost && against.file->has_cost;
    comparing.effects.scale = EffectScale::ratio_of_variances;
    const auto inverse = [&](const ReportedRow& row) {
        return row.standard_error * row.standard_error * (by_cost ? row.cost : row.n);
    };
    for (std::size_t bin = 0; bin < comparing.bins.count(); ++bin) {
        const ReportedRow& own = comparing.bins.rows[bin];
        const ReportedRow& other = against.rows[bin];
        if (own.standard_error == 0 || other.standard_error == 0) {
            ++comparing.empty;
            continue;
        }
        comparing.add_ratio(bin, inverse(other) / inverse(own), freedom_of_variance(comparing.gate, other.n),
                            freedom_of_variance(comparing.gate, own.n));
    }
    add_note(comparing.note, by_cost ? "1 / (error² × cost), of the file over --against; seconds depend on the machine"
                                     : "1 / (error² × n), of the file over --against");
    add_note(comparing.note, about_samples(comparing.gate));
}

}  // namespace ff::studies::gates
