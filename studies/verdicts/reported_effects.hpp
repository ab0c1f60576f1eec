#pragma once

#include "studies/verdicts/reported_bins.hpp"
#include "studies/verdicts/reported_quantity.hpp"

#include <cstddef>
#include <string>
#include <string_view>

namespace ff::studies {

/// Everything that the text of a verdict is made from.
struct Comparing {
    const Gate& gate;
    Bins bins;
    BinEffects effects;
    std::size_t empty = 0;      ///< bins without any sample
    bool contradicted = false;  ///< runs scatter more than their trusted errors allow: there is no verdict
    std::string note;
};

/// Appends to the note, after a semicolon if there is one already.
void add_note(std::string& note, std::string_view text);

/// The effect in each bin, with notes.
/// @param against  null where the reference is a number
/// @throws UserError where the file lacks what the kind needs
Comparing effects_of(const Gate& gate, const Bins& bins, const Bins* against);

}  // namespace ff::studies
