#pragma once

#include "core/points/stream.hpp"
#include "core/radiosity/enclosures.hpp"
#include "studies/radiosity/consequences.hpp"
#include "studies/spec/sections.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies::radiosity {

/// An enclosure with self-viewing surfaces, given by its exact factors.
struct NamedEnclosure {
    std::string description;
    std::vector<std::string> surfaces;  ///< labels, in the order of the matrix
    Enclosure enclosure;
};

/// "cylinder:RxH", "cap:RxH" (a spherical cap of height H and the disk that closes it), "cone:RxH", "spheres:RxS" (S
/// inside R), or a box with a mirror. @param mirror label of the face, of boxes only @throws UserError
NamedEnclosure find_enclosure(std::string_view name, const std::optional<std::string>& mirror);

/// A request to `ffstudy enclosure`.
struct EnclosureRequest {
    std::string name;
    std::optional<std::string> mirror;
    RadiosityRequest light;    ///< one reflectance for all surfaces in each setting
    std::uint64_t rays = 0;    ///< rays from each surface in a trial, at most 2^32
    std::uint64_t trials = 0;  ///< 0: exact factors only
    Seed seed;
};

struct EnclosureResults {
    NamedEnclosure of;
    Eigen::VectorXd emission;
    std::vector<ExactSystem> exact;          ///< one for each setting
    std::vector<Consequences> consequences;  ///< one for each treatment; `cell` is meaningless
};

/// Solves with exact factors, and with those of trials. Rays of a trial are not traced: since the target of a diffuse
/// ray has the exact factors as its probabilities, mirrors and self-views included, independent rays are drawn from
/// these. @throws UserError
EnclosureResults study_enclosure(const EnclosureRequest& request);

}  // namespace ff::studies::radiosity
