#pragma once

#include "samplers/sampler.hpp"

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace ff::samplers {

/// Point sets made elsewhere, in fixed point: coordinate * 2^-32.
struct PointSet {
    std::uint64_t points = 0;               ///< number of points in each set
    std::size_t dimension = 0;              ///< 1 to max_dimension
    std::uint64_t sets = 0;                 ///< trial t takes set t modulo this
    std::vector<std::uint32_t> coordinate;  ///< [set][dimension][point]

    [[nodiscard]] std::span<const std::uint32_t> row(std::uint64_t set, std::size_t d) const {
        return std::span(coordinate).subspan((set * dimension + d) * points, points);
    }
};

/// Randomisations that turn a set into unbiased trials; each makes every single point uniform.
enum class Randomisation {
    none,
    shift,          ///< modulo 1, by one random vector [cranley1976]: keeps lattices
    digital_shift,  ///< exclusive or with one random vector: keeps nets in base 2
    lms,            ///< random linear map of the digits and a digital shift [matousek1998]: keeps nets in base 2
    owen,           ///< hash-based nested scrambling, as in `sobol` [burley2020]: keeps nets in base 2
};

inline constexpr std::array<std::string_view, 5> randomisation_names{"none", "shift", "digital_shift", "lms", "owen"};

std::optional<Randomisation> find_randomisation(std::string_view name);

/// Randomises one coordinate of some points in place.
void randomise(Randomisation how, const Stream& stream, std::size_t d, std::span<std::uint32_t> row);

/// The first `points` points of each set. @pre points <= sets->points
std::unique_ptr<PointSource> points_of_set(std::shared_ptr<const PointSet> set, std::uint64_t points,
                                           Randomisation how);

}  // namespace ff::samplers
