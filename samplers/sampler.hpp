#pragma once

#include "core/points/points.hpp"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace ff::samplers {

/// Most points in one set: an index has 32 bits.
inline constexpr std::uint64_t max_points = std::uint64_t{1} << 32;

/// Sizes that a sampler is made for.
enum class Sizes {
    any,           ///< every number of points
    powers,        ///< multiple * base^m keeps the net property; others are allowed with a warning
    fourth_power,  ///< k^dimension (k^4 in 4-D), one point per cell; others are impossible
    nodes,         ///< n nodes a side, n^4 points in 4-D
};

/// How points are spread, as theories of convergence tell samplers apart.
enum class Spread {
    other,        ///< no theory is known
    independent,  ///< independent draws, so binomial intervals hold within one set
    mirrored,     ///< independent draws, each with its mirror image
    grid,         ///< one in each cell of a regular grid
    latin,        ///< one in each slice of every coordinate
    net,          ///< a scrambled (t, m, d)-net
    padded_nets,  ///< a net in each pair of coordinates
    halton,
    lattice,
};

/// What a sampler declares about itself; `ffstudy list`, `explain`, the contract tests and the reports read it.
struct SamplerInfo {
    std::string_view name;
    std::string_view summary;    ///< one line, shown by `ffstudy list samplers`
    std::string_view details;    ///< a paragraph or two: what it is, its limits; shown by `ffstudy explain`
    std::string_view reference;  ///< key of docs/references.md
    Sizes sizes = Sizes::any;
    std::uint32_t base = 2;      ///< for Sizes::powers
    std::uint32_t multiple = 1;  ///< for Sizes::powers; points that share an interval
    bool randomised = true;      ///< trials differ
    bool equal_weights = true;   ///< points can be tallied as hits
    Spread spread = Spread::other;
    double nanoseconds = 1.5;                     ///< of processor time for a point in 4-D, roughly; only ratios matter
    bool control = false;                         ///< broken on purpose, so that checks can be checked
    std::string_view unbroken_name = {};          ///< of a control: what it would be if it were not broken
    std::span<const std::uint64_t> at_hand = {};  ///< sizes of the sets that there are; empty: as `sizes` says
    std::size_t most_dimension = max_dimension;   ///< coordinates of a point
    std::uint64_t most_trials = 0;                ///< different trials that there are; 0: any number

    [[nodiscard]] constexpr bool independent() const { return spread == Spread::independent; }
};

/// What a point set is made from.
struct PointSetSpec {
    std::uint64_t points = 0;  ///< size of the set; for Sizes::nodes it follows from the nodes
    std::size_t dimension = max_dimension;
    std::uint32_t source_nodes = 0;  ///< nodes a side on the source patch (coordinates 0 and 1), Sizes::nodes only
    std::uint32_t target_nodes = 0;  ///< nodes a side on the target patch (coordinates 2 and 3)
};

class AddedSampler;

/// A sampler in the catalogue: its declaration and how to make a point set of it.
struct CatalogueEntry {
    SamplerInfo info;
    std::unique_ptr<PointSource> (*maker)(const CatalogueEntry& self, const PointSetSpec& spec);
    const AddedSampler* added = nullptr;  ///< of samplers that are not built in, see samplers/added.hpp

    /// @throws UserError where the size cannot be done
    [[nodiscard]] std::unique_ptr<PointSource> make(const PointSetSpec& spec) const { return maker(*this, spec); }
};

/// All samplers, in the order in which they are listed.
std::span<const CatalogueEntry> catalogue();

/// Samplers that are broken on purpose, each in one way that has been seen elsewhere. They can be named like others, so
/// that checks can be shown to catch them, and are not in the catalogue.
std::span<const CatalogueEntry> controls();

/// A sampler of the catalogue, a control, or an added one. @throws UserError with the nearest name of the catalogue
const CatalogueEntry& find(std::string_view name);

/// Independent random points, the yardstick for all others.
const SamplerInfo& yardstick();

/// What the program itself integrates with.
const CatalogueEntry& house_sampler();

/// The sizes that a sampler is made for: "powers of 5".
std::string sizes_in_words(const SamplerInfo& info);

/// Why `points` is not a size the sampler is made for, and what is near: empty where it is fine. `fatal` tells whether
/// the sampler cannot do it at all or only loses its net property.
struct SizeProblem {
    std::string message;
    bool fatal = false;
};
SizeProblem check_size(const SamplerInfo& info, std::uint64_t points, std::size_t dimension = max_dimension);

}  // namespace ff::samplers
