#include "samplers/nets/sobol.hpp"
#include "samplers/random/random.hpp"
#include "samplers/support/entry.hpp"
#include "samplers/support/owen_hash.hpp"

#include <algorithm>
#include <array>

namespace ff::samplers {
namespace {

/// Control: `random` with every origin in the middle of its patch.
class PatchCentres {
  public:
    static constexpr SamplerInfo info{
        .name = "patch_centres",
        .summary = "random, but every ray starts in the middle of its patch: biased",
        .details =
            "Coordinates 0 and 1 are one half, the others those of `random`: directions are right, the average over "
            "the source patch is replaced by its middle. A shortcut that is easily taken, since it looks right and is "
            "no noisier than the truth. Its bias is that of a midpoint rule and falls with the size of the patches as "
            "their area; on 13 x 13 patches of a cube's face it is far below the noise of one run.\n"
            "Caught by: a bias gate.",
        .reference = "",
        .sizes = Sizes::any,
        .control = true,
        .unbroken_name = "random",
    };

    explicit PatchCentres(const PointSetSpec& spec) : random_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        random_.fill(stream, first, block);
        for (std::size_t d = 0; d < 2; ++d) std::fill_n(block.coordinate[d].begin(), block.size, 0x80000000u);
    }

  private:
    Random random_;
};

/// Control: `random` with the same seed in every trial.
class SameSeed {
  public:
    static constexpr SamplerInfo info{
        .name = "same_seed",
        .summary = "random, but every trial is seeded alike: replicates that replicate nothing",
        .details =
            "The number of the trial does not enter the stream, so all trials give the same estimate, bit for bit. "
            "Each trial alone is right; together they have no spread, and an interval made of it would be one of width "
            "zero around a wrong value.\n"
            "Caught by: the check for repeated trials that goes before every gate.",
        .reference = "",
        .sizes = Sizes::any,
        .control = true,
        .unbroken_name = "random",
    };

    explicit SameSeed(const PointSetSpec& spec) : random_(spec) {}
    void fill(Stream stream, PointIndex first, PointBlock& block) const {
        stream.trial = 0;
        random_.fill(stream, first, block);
    }

  private:
    Random random_;
};

/// Control: `sobol` without its first point. @see [owen2022]
class SobolFirstDropped {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_first_dropped",
        .summary = "sobol without its first point: no net, noisier on smooth integrands",
        .details =
            "Points 1 .. N of the scrambled sequence instead of 0 .. N - 1, as libraries do that take the first point, "
            "the origin, for a nuisance. Every point is still uniform, so nothing is biased; but 2^m points that do "
            "not begin at a multiple of 2^m are not a net, and one point in the wrong place costs 1/N where the error "
            "of the net falls faster than that (Owen 2022). Tallies of rays hardly notice.\n"
            "Caught by: a gate on the standard deviation, or on the slope, of a smooth estimate.",
        .reference = "owen2022",
        .sizes = Sizes::powers,
        .control = true,
        .unbroken_name = "sobol",
    };

    explicit SobolFirstDropped(const PointSetSpec& spec) : sobol_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        sobol_.fill(stream, first + 1, block);
    }

  private:
    Sobol sobol_;
};

/// Control: `sobol` without its last bit reversal. @see [laine2011]
class SobolDigitsReversed {
  public:
    static constexpr SamplerInfo info{
        .name = "sobol_digits_reversed",
        .summary = "sobol with its base-2 digits left in reverse order: as noisy as random",
        .details =
            "Hash-based scrambling works on reversed digits (Laine and Karras 2011) and has to reverse them twice; "
            "here the second time is forgotten. What was arranged in the high digits of the points lies in the low "
            "ones, where no integrand sees it. Every point is still uniform, so nothing is biased, but the net is "
            "gone and with it the gain over `random`.\n"
            "Caught by: a gate on the standard deviation, or on the slope.",
        .reference = "laine2011",
        .sizes = Sizes::powers,
        .control = true,
        .unbroken_name = "sobol",
    };

    explicit SobolDigitsReversed(const PointSetSpec& spec) : sobol_(spec) {}
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const {
        sobol_.fill(stream, first, block);
        for (std::size_t d = 0; d < block.dimension; ++d) {
            for (std::size_t i = 0; i < block.size; ++i) block.coordinate[d][i] = reverse_bits(block.coordinate[d][i]);
        }
    }

  private:
    Sobol sobol_;
};

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
