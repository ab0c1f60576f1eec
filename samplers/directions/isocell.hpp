#pragma once

#include "samplers/sampler.hpp"

namespace ff::samplers {

/// One point in each of 3 k^2 cells of a disc that have the same area and nearly the same shape. @see [jacques2015]
class Isocell {
  public:
    static constexpr SamplerInfo info{
        .name = "isocell",
        .summary = "one direction in each of 3 k^2 isocells of the disc, each from a random origin",
        .details =
            "The disc that cosine-distributed directions project to is cut into k rings of equal width, ring j into "
            "3 (2 j - 1) cells: all 3 k^2 have the same area and are about as long as wide (Masset, Bruels and "
            "Kerschen). The last two coordinates of point i, squared sine and azimuth, lie in cell i + a random "
            "offset, uniformly; the first two, the origin, are independent and uniform: one ray for each surface "
            "point, what Jacques, Masset and Kerschen call global isocell, with random places in the cells where they "
            "take the middles, so that it is unbiased.\n"
            "Sizes: 3 k^2, as 48, 108, 192, 300, 432, 588, 768; of any other number those beyond the largest are "
            "random. Only what depends on the direction gains: with rays that start anywhere the error falls as "
            "N^-1/2.",
        .reference = "jacques2015",
        .sizes = Sizes::any,
        .spread = Spread::other,
        .nanoseconds = 12,
    };

    explicit Isocell(const PointSetSpec& spec);
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const;

  private:
    std::uint64_t points_;
    std::uint64_t rings_;
};

}  // namespace ff::samplers
