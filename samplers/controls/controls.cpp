#include "samplers/controls/patch_centres.hpp"
#include "samplers/controls/same_seed.hpp"
#include "samplers/controls/sobol_digits_reversed.hpp"
#include "samplers/controls/sobol_first_dropped.hpp"
#include "samplers/support/entry.hpp"

#include <array>

namespace ff::samplers {
namespace {

constexpr std::array all_controls{
    entry<PatchCentres>(),         //
    entry<SameSeed>(),             //
    entry<SobolFirstDropped>(),    //
    entry<SobolDigitsReversed>(),  //
};

}  // namespace

std::span<const CatalogueEntry> controls() {
    return all_controls;
}

}  // namespace ff::samplers
