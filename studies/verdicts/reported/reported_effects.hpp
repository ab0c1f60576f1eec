#pragma once

#include "studies/verdicts/measurement.hpp"
#include "studies/verdicts/reported/reported_bins.hpp"
#include "studies/verdicts/reported/reported_quantity.hpp"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace ff::studies::gates {

/// Everything that the text of a verdict is made from.
struct BinComparison {
    const Gate& gate;
    Bins bins;
    BinEffects effects;
    std::size_t empty = 0;      ///< bins without any sample
    bool contradicted = false;  ///< runs do not scatter as a verdict would have to assume: there is none
    std::string note;

    /// Adds the ratio of a bin, whose band is the gate's.
    void add_ratio(std::size_t bin, double value, double freedom, double freedom_below) {
        effects.bins.push_back({.value = value,
                                .freedom = freedom,
                                .freedom_below = freedom_below,
                                .band = gate.band,
                                .name = static_cast<std::uint32_t>(bin)});
    }
};

/// Rate at which runs that satisfy an assumption are said to contradict it.
inline constexpr double false_alarm_of_scatter = 1e-3;

/// The mean of all runs of a bin with its standard error: by what the runs state, or by their spread where they are
/// many. The error is 0 where none is stated.
MeanReference mean_of(Rows runs);

/// Whether no sample fell into a bin of means: it has neither mean nor error, where errors are stated or many runs show
/// them. Values without errors are exact.
/// @throws UserError where many runs have one mean, not 0
bool is_empty(const Gate& gate, const Bins& bins, std::size_t bin);

/// The gate's band in one bin, whose reference scales it where it is relative.
Band band_beside(const BinComparison& comparing, std::size_t bin, double reference);

/// Appends to the note, after a semicolon if there is one already.
void add_note(std::string& note, std::string_view text);

/// The effect in each bin, with notes.
/// @param against  null where the reference is a number
/// @throws UserError where the file lacks what the kind needs
BinComparison effects_of(const Gate& gate, const Bins& bins, const Bins* against);

}  // namespace ff::studies::gates
