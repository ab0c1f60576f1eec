#pragma once

#include "core/points/points.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ff::samplers {

/// Upper limit of points in one set: an index has 32 bits.
inline constexpr std::uint64_t max_points = std::uint64_t{1} << 32;

/// Sizes that a sampler is designed for.
enum class Sizes {
    any,           ///< every number of points
    powers,        ///< multiple * base^m keeps the net property; others are allowed with a warning
    fourth_power,  ///< k^dimension (k^4 in 4-D), one point per cell; others are impossible
    nodes,         ///< n nodes per side, n^4 points in 4-D
};

/// How points are distributed, as theories of convergence distinguish samplers.
enum class Spread {
    other,        ///< no theory is known
    independent,  ///< independent draws: binomial intervals hold within one set
    mirrored,     ///< independent draws, each with its mirror image
    grid,         ///< one in each cell of a regular grid
    latin,        ///< one in each slice of every coordinate
    net,          ///< a scrambled (t, m, d)-net
    padded_nets,  ///< a net in each pair of coordinates
    halton,
    lattice,
};

/// The declaration of a sampler; `ffstudy list`, `explain`, the contract tests and the reports read it.
struct SamplerInfo {
    std::string_view name;
    std::string_view summary;    ///< one line, shown by `ffstudy list samplers`
    std::string_view details;    ///< a paragraph or two: what it is, its limits; shown by `ffstudy explain`
    std::string_view reference;  ///< key of docs/references.md
    Sizes sizes = Sizes::any;
    std::uint32_t base = 2;      ///< base of Sizes::powers
    std::uint32_t multiple = 1;  ///< points that share an interval under Sizes::powers
    bool randomised = true;      ///< trials differ
    bool equal_weights = true;   ///< points can be tallied as hits
    Spread spread = Spread::other;
    double nanoseconds = 1.5;                     ///< rough processor time of a point in 4-D; only ratios matter
    bool control = false;                         ///< broken on purpose, to test checks with
    std::string_view unbroken_name = {};          ///< for a control: the sound sampler that it breaks
    std::span<const std::uint64_t> at_hand = {};  ///< sizes of the available sets; empty: as `sizes` says
    std::size_t most_dimension = max_dimension;   ///< coordinates of a point
    std::uint64_t most_trials = 0;                ///< number of different trials; 0: any number

    [[nodiscard]] constexpr bool independent() const { return spread == Spread::independent; }
};

/// Parameters of a point set.
struct PointSetSpec {
    std::uint64_t points = 0;  ///< size of the set; for Sizes::nodes it follows from the nodes
    std::size_t dimension = max_dimension;
    std::uint32_t source_nodes = 0;  ///< nodes per side on the source patch (coordinates 0 and 1), Sizes::nodes only
    std::uint32_t target_nodes = 0;  ///< nodes per side on the target patch (coordinates 2 and 3)
    StreamKey key = {};  ///< key of the streams that will be used: outside code is tried with the seeds of their trials
};

class AddedSampler;

/// A sampler in the catalogue: its declaration and how to make a point set of it.
struct CatalogueEntry {
    SamplerInfo info;
    std::unique_ptr<PointSource> (*maker)(const CatalogueEntry& self, const PointSetSpec& spec);
    const AddedSampler* added =
        nullptr;  ///< the user's sampler behind the entry, see samplers/outside/added.hpp; null for built-in ones

    /// @throws UserError where the size is impossible
    [[nodiscard]] std::unique_ptr<PointSource> make(const PointSetSpec& spec) const { return maker(*this, spec); }
};

/// All samplers, in the order in which they are listed.
std::span<const CatalogueEntry> catalogue();

/// Samplers that are broken on purpose, each by a mistake that has been seen elsewhere. They are not in the catalogue,
/// but can be named like others, to show that checks catch them.
std::span<const CatalogueEntry> controls();

/// A sampler of the catalogue, a control, or an added one. @throws UserError with the nearest name of the catalogue
const CatalogueEntry& find(std::string_view name);

/// Independent random points, the yardstick for all others.
const SamplerInfo& yardstick();

/// The sampler that the program itself integrates with.
const CatalogueEntry& house_sampler();

/// The sizes that a sampler is designed for, in words: "powers of 5".
std::string sizes_in_words(const SamplerInfo& info);

/// Why the sampler is not designed for this number of points, and which are near; empty where it is. `fatal` tells
/// whether the size is impossible, or the net property is merely lost.
struct SizeProblem {
    std::string message;
    bool fatal = false;
};
SizeProblem check_size(const SamplerInfo& info, std::uint64_t points, std::size_t dimension = max_dimension);

}  // namespace ff::samplers
