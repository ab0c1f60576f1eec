#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "samplers/directions/antithetic_directions.hpp"
#include "samplers/directions/isocell.hpp"
#include "samplers/directions/local_directions.hpp"
#include "samplers/grids/gauss_legendre.hpp"
#include "samplers/grids/latin_hypercube.hpp"
#include "samplers/grids/stratified.hpp"
#include "samplers/nets/boost_sequences.hpp"
#include "samplers/nets/faure.hpp"
#include "samplers/nets/faure_in_base.hpp"
#include "samplers/nets/padded.hpp"
#include "samplers/nets/sobol.hpp"
#include "samplers/nets/sobol_lms.hpp"
#include "samplers/nets/sobol_nus.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/random/antithetic.hpp"
#include "samplers/random/random.hpp"
#include "samplers/random/random_mt.hpp"
#include "samplers/sequences/halton.hpp"
#include "samplers/sequences/hammersley.hpp"
#include "samplers/sequences/lattice.hpp"
#include "samplers/sequences/r_sequence.hpp"
#include "samplers/support/entry.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace ff::samplers {
namespace {

/// The only list of samplers.
constexpr std::array all_samplers{
    entry<Random>(),                       //
    entry<RandomMt>(),                     //
    entry<Antithetic<Random>>(),           //
    entry<Antithetic<Sobol>>(),            //
    entry<AntitheticDirections>(),         //
    entry<Stratified>(),                   //
    entry<LatinHypercube>(),               //
    entry<Isocell>(),                      //
    entry<LocalDirections<Isocell>>(),     //
    entry<Halton>(),                       //
    entry<Hammersley>(),                   //
    entry<LocalDirections<Hammersley>>(),  //
    entry<Sobol>(),                        //
    entry<SobolLms>(),                     //
    entry<SobolNus>(),                     //
    entry<SobolRaw>(),                     //
    entry<Niederreiter>(),                 //
    entry<Faure>(),                        //
    entry<FaureInBase<7>>(),               //
    entry<FaureInBase<11>>(),              //
    entry<FaureInBase<13>>(),              //
    entry<Padded>(),                       //
    entry<Lattice>(),                      //
    entry<RSequence>(),                    //
    entry<GaussLegendre>(),                //
};

constexpr auto all_names = [] {
    std::array<std::string_view, all_samplers.size()> names;
    std::transform(all_samplers.begin(), all_samplers.end(), names.begin(),
                   [](const CatalogueEntry& sampler) { return sampler.info.name; });
    return names;
}();

}  // namespace

const SamplerInfo& yardstick() {
    return Random::info;
}

const CatalogueEntry& house_sampler() {
    return find(Sobol::info.name);
}

std::span<const CatalogueEntry> catalogue() {
    return all_samplers;
}

const CatalogueEntry& find(std::string_view name) {
    for (const auto samplers : {catalogue(), controls()}) {
        for (const CatalogueEntry& sampler : samplers) {
            if (sampler.info.name == name) return sampler;
        }
    }
    if (const AddedSampler* added = find_added(name)) return added->entry();
    throw UserError("sampler \"{}\" (there is none of this name). {}Known samplers: {}.", excerpt(name),
                    did_you_mean(name, all_names, '"'), fmt::join(all_names, ", "));
}

}  // namespace ff::samplers
