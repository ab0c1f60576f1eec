#include "python/module/module.hpp"

#include "core/support/error.hpp"
#include "python/module/python_lock.hpp"
#include "samplers/outside/added.hpp"
#include "samplers/outside/outside_points.hpp"
#include "samplers/point_sets/set_of_rows.hpp"

#include <fmt/format.h>
#include <pybind11/numpy.h>

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace ff::python {
namespace {

using Rows = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// Calls the function with the interpreter's lock; what it raises becomes an error of ours. The lock is held until its
/// numbers are copied: it may return the same array every time.
void call(PyObject* fill, const std::string& name, const samplers::SetRequest& request, samplers::PointSet& set) {
    const std::string origin = fmt::format("{} ({})", name, in_words(request));
    samplers::expect_whole(origin, request);
    const PythonLock held;
    try {
        const py::object made = py::handle(fill)(request.points, request.dimension, request.seed, request.trial);
        const Rows rows = Rows::ensure(made);
        if (!rows) throw UserError("{}: returned no array of numbers (n, d). Return numpy.ndarray.", origin);
        if (rows.ndim() != 2 || static_cast<std::uint64_t>(rows.shape(0)) != request.points ||
            static_cast<std::size_t>(rows.shape(1)) != request.dimension)
            throw UserError("{}: returned an array of shape {} (expected ({}, {})). Return one row per point.", origin,
                            py::str(rows.attr("shape")).cast<std::string>(), request.points, request.dimension);
        samplers::set_of_rows(std::span(rows.data(), static_cast<std::size_t>(rows.size())), request.points,
                              request.dimension, origin, set);
    } catch (const py::error_already_set& error) {
        throw UserError("{}: raised {}", origin, error.what());
    }
}

}  // namespace

std::string add_function(const std::string& name, const std::string& hash, py::function fill,
                         std::size_t most_dimension, bool randomised) {
    samplers::SamplerInfo traits;
    traits.randomised = randomised;
    traits.most_dimension = most_dimension;
    traits.nanoseconds = 200;
    // Kept for ever, as samplers are: no lock of the interpreter would be there to give it back at the end.
    PyObject* const function = fill.release().ptr();
    const auto part =
        samplers::parts_of([function, name](const samplers::SetRequest& request, samplers::PointSet& set) {
            call(function, name, request, set);
        });
    const auto repeatable = std::make_shared<Repeatable>(randomised, words_of_functions);
    const auto& entry = samplers::add(
        std::make_unique<samplers::AddedSampler>(
            samplers::AddedSampler::Texts{fmt::format("{}#{}", name, hash), "points that a Python function makes",
                                          "A function of the Python session. What it promises is its author's affair."},
            traits, std::vector<std::uint64_t>{},
            [part, randomised, repeatable, function, name](const samplers::PointSetSpec& spec) {
                const WithoutPythonLock free;
                const auto points_of = [&](std::uint32_t trial) {
                    samplers::PointSet set;
                    call(function, name, samplers::request_of({spec.key, trial, 0, 0}, spec.points, spec.dimension),
                         set);
                    return set.coordinate;
                };
                repeatable->expect(name, "points", points_of, always_telling);
                return samplers::outside_points(spec.points, randomised, part);
            }),
        name, samplers::ShortName::moves);
    return std::string(entry.info.name);
}

}  // namespace ff::python
