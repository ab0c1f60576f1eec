#pragma once

#include "core/support/repeatable.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <pybind11/pybind11.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace ff::python {

/// Adds a sampler whose sets a Python function makes: fill(n, d, seed, trial) gives an array (n, d) of numbers in
/// [0, 1). It is found as `name` until another function takes the name, and as `name`#`hash`.
/// @param randomised  false where every seed gives the same points
/// @return the full name
std::string add_function(const std::string& name, const std::string& hash, pybind11::function fill,
                         std::size_t most_dimension, bool randomised);

/// Adds an estimator that is a Python function: estimate(scene, samples, seed, trial) gives an array (faces, faces) of
/// form factors. It is found as `name` until another function takes the name, and as `name`#`hash`.
/// @param has_sizes  false where it takes no samples  @param randomised  false where every seed gives the same
void add_estimator(const std::string& name, const std::string& hash, pybind11::function estimate, bool has_sizes,
                   bool randomised);

/// A scene: the name of a built-in one, or the name of a file with its text.
struct SceneText {
    std::string name;
    std::optional<std::string> text;

    [[nodiscard]] studies::SceneSource source() const {
        return text ? studies::source_of_file(name, *text) : studies::scene_source(name);
    }
};

/// What both form factors and heat ask of a matrix.
struct MatrixRequest {
    double tolerance = 0;
    double level = 0;
    std::uint64_t seed = 0;
    unsigned threads = 1;
    std::uint64_t max_samples = 0;

    /// @param stop  kept by reference
    [[nodiscard]] studies::form_factors::Request request(const std::atomic<bool>& stop) const;
};

/// @throws UserError also where the scene has mirrors
studies::form_factors::Matrix find_matrix_without_mirrors(const Scene& scene,
                                                          const studies::form_factors::Request& request);

/// How messages speak of Python functions whose results do not repeat.
inline constexpr OutsideWords words_of_functions{"returns", "seed", "give it the option \"randomised\": False"};

/// Adds `judge` and what it returns.
void bind_gates(pybind11::module_& module);

/// Adds `heat`, `face_names` and what they return.
void bind_heat(pybind11::module_& module);

/// Adds `admit`, `run_study` and what they return.
void bind_study(pybind11::module_& module);

}  // namespace ff::python
