#include "python/module/module.hpp"

#include "python/module/interruptible.hpp"

#include "core/exact/known_factors.hpp"
#include "core/support/error.hpp"
#include "core/visibility/mirrors.hpp"
#include "samplers/point_sets/draw_set.hpp"
#include "studies/form_factors/amendments.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

// The compiled half of the Python package ffstudy: plain functions over plain values. Names, checks of arguments and
// documentation are those of python/ffstudy/__init__.py.

namespace py = pybind11;

namespace ff::python {
namespace {

/// Matrices of more faces are sparse in Python: most pairs of large scenes do not see each other.
constexpr Eigen::Index most_dense = 2048;

using Sparse = studies::form_factors::Matrix::Sparse;

/// NumPy's array, or SciPy's CSR where the matrix is large.
py::object as_array(const Sparse& matrix) {
    return matrix.rows() > most_dense ? py::cast(matrix) : py::cast(Eigen::MatrixXd(matrix));
}

struct Factors {
    Sparse factors;
    Sparse half_widths;
    std::vector<double> areas;
    std::vector<std::string> names;
    std::size_t missed = 0;
    bool trusted = false;
    std::uint64_t samples = 0;
    std::vector<std::string> faults;
    std::vector<std::string> notes;
};

Factors form_factors(const SceneText& source, const MatrixRequest& asked, bool simultaneous) {
    Factors found;
    run_interruptibly([&](const std::atomic<bool>& stop) {
        const Scene scene = studies::make_scene(source.source());
        studies::form_factors::Request request = asked.request(stop);
        if (simultaneous) request.level_of = studies::form_factors::LevelOf::matrix;
        auto doubts = studies::examine_scene(scene);
        auto matrix = find_matrix_without_mirrors(scene, request);
        matrix.faults = doubts.faults;
        found.factors = matrix.factors();
        found.half_widths = matrix.half_widths();
        found.areas = matrix.areas;
        found.names = studies::form_factors::with_added_faces(scene, "").faces;
        found.missed = matrix.missed();
        found.trusted = studies::form_factors::is_trusted(scene, matrix, request.tolerance);
        found.samples = matrix.samples;
        found.faults = std::move(doubts.faults);
        found.notes = std::move(doubts.notes);
    });
    return found;
}

std::optional<double> exact(const std::string& name, const std::optional<std::string>& text, int from, int to) {
    const Scene scene = studies::make_scene(SceneText{name, text}.source());
    const auto faces = static_cast<int>(scene.faces.size());
    for (const int face : {from, to}) {
        if (face < 1 || face > faces)
            throw UserError("face {} (scene '{}' has faces 1 to {}). Count from 1.", face, name, faces);
    }
    return known_factors(scene).at(from - 1, to - 1);
}

py::array_t<double> points(const std::string& name, const samplers::DrawnSet& request, double deadline) {
    samplers::PointSet set;
    run_interruptibly([&](const std::atomic<bool>& /*stop*/) {
        set = samplers::draw_set(studies::sampler_of_user(name, deadline), request);
    });
    py::array_t<double> rows({set.points, std::uint64_t{set.dimension}});
    auto at = rows.mutable_unchecked<2>();
    for (std::size_t d = 0; d < set.dimension; ++d) {
        const auto row = set.row(0, d);
        for (std::uint64_t i = 0; i < set.points; ++i)
            at(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(d)) = row[i] * 0x1p-32;
    }
    return rows;
}

/// Our exceptions become exceptions of the package, which defines them.
void translate(std::exception_ptr failure) {
    const auto raise = [](const char* type, const char* text) {
        const py::object error = py::module_::import("ffstudy.errors").attr(type);
        PyErr_SetString(error.ptr(), text);
    };
    try {
        if (failure) std::rethrow_exception(failure);
    } catch (const UserError& error) {
        raise("InputError", error.what());
    } catch (const IoError& error) {
        raise("FileError", error.what());
    } catch (const std::filesystem::filesystem_error& error) {
        raise("FileError", error.what());
    }
}

}  // namespace

studies::form_factors::Request MatrixRequest::request(const std::atomic<bool>& stop) const {
    studies::form_factors::Request request;
    request.tolerance = tolerance;
    request.level = level;
    request.seed = Seed{seed};
    request.threads = threads;
    request.max_samples = max_samples;
    request.stop = &stop;
    return request;
}

studies::form_factors::Matrix find_matrix_without_mirrors(const Scene& scene,
                                                          const studies::form_factors::Request& request) {
    if (!mirrors(scene).empty())
        throw UserError("scene '{}': mirrors (pairs are computed one by one). Leave them out.", scene.name);
    return studies::form_factors::find_matrix(scene, request);
}

}  // namespace ff::python

PYBIND11_MODULE(_core, module) {
    using namespace ff::python;
    using py::arg;
    py::register_exception_translator(translate);
    py::class_<Factors>(module, "Factors")
        .def_property_readonly("factors", [](const Factors& found) { return as_array(found.factors); })
        .def_property_readonly("half_widths", [](const Factors& found) { return as_array(found.half_widths); })
        .def_readonly("areas", &Factors::areas)
        .def_readonly("names", &Factors::names)
        .def_readonly("missed", &Factors::missed)
        .def_readonly("trusted", &Factors::trusted)
        .def_readonly("samples", &Factors::samples)
        .def_readonly("faults", &Factors::faults)
        .def_readonly("notes", &Factors::notes);
    module.def(
        "form_factors",
        [](const std::string& name, const std::optional<std::string>& text, double tolerance, double level,
           bool simultaneous, std::uint64_t seed, unsigned threads, std::uint64_t max_samples) {
            return form_factors({name, text}, {tolerance, level, seed, threads, max_samples}, simultaneous);
        },
        arg("name"), arg("text"), arg("tolerance"), arg("level"), arg("simultaneous"), arg("seed"), arg("threads"),
        arg("max_samples"));
    module.def("exact", &exact, arg("name"), arg("text"), arg("i"), arg("j"));
    module.def(
        "points",
        [](const std::string& name, std::uint64_t n, std::size_t d, std::uint64_t seed, std::uint32_t trial,
           double deadline) {
            return points(name, {n, d, seed, trial}, deadline);
        },
        arg("name"), arg("n"), arg("d"), arg("seed"), arg("trial"), arg("deadline"));
    module.def("read_scene_file", &ff::studies::read_scene_file, arg("file"));
    module.def(
        "with_faces_of_polygons",
        [](const std::string& text) { return ff::studies::with_obj_comment(text, "faces polygon"); }, arg("text"));
    module.def("add_function", &add_function, arg("name"), arg("hash"), arg("fill"), arg("most_dimension"),
               arg("randomised"));
    module.def("add_estimator", &add_estimator, arg("name"), arg("hash"), arg("estimate"), arg("has_sizes"),
               arg("randomised"));
    module.def(
        "is_scene_file", [](const std::string& name) { return ff::studies::scene_source(name).is_file(); },
        arg("name"));
    bind_gates(module);
    bind_heat(module);
    bind_study(module);
}
