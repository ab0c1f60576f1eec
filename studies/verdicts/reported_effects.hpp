#pragma once

#include "studies/verdicts/reported_bins.hpp"
#include "studies/verdicts/reported_quantity.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::studies {

/// Everything that the words of a verdict are made from.
struct Comparing {
    const Gate& gate;
    Bins bins;
    BinEffects effects;
    std::size_t empty = 0;      ///< bins that no sample fell into
    bool contradicted = false;  ///< runs scatter more than errors say that a verdict would trust: there is none
    std::string note;
};

/// After a semicolon, where there is a note already.
void add_note(std::string& note, std::string_view text);

/// The effect in each bin, with what has to be said about it.
/// @param against  null where the reference is a number
/// @throws UserError where the file has not what the kind needs
Comparing effects_of(const Gate& gate, const Bins& bins, const Bins* against);

}  // namespace ff::studies
