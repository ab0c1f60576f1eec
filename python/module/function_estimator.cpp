#include "core/geometry/scene.hpp"
#include "python/module/module.hpp"

#include "core/estimators/added.hpp"
#include "core/geometry/convex_polygon.hpp"
#include "core/support/error.hpp"
#include "python/module/python_lock.hpp"
#include "samplers/outside/outside_points.hpp"
#include "studies/scene_files/scene_writer.hpp"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace ff::python {
namespace {

using Numbers = py::array_t<double, py::array::c_style | py::array::forcecast>;

/// ffstudy.Scene of a scene. @pre the interpreter's lock is held
py::object described(const Scene& scene) {
    py::object polygons = py::none();
    if (studies::is_of_polygons(scene)) {
        py::list all;
        for (const Surface& surface : scene.surfaces) {
            const auto corners = outline(surface);
            Numbers rows({corners.size(), std::size_t{3}});
            auto at = rows.mutable_unchecked<2>();
            for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
                for (py::ssize_t j = 0; j < 3; ++j) at(i, j) = corners[static_cast<std::size_t>(i)][j];
            }
            all.append(py::make_tuple(rows, surface.face));
        }
        polygons = all;
    }
    return py::module_::import("ffstudy.study")
        .attr("Scene")(scene.name, scene.faces, scene.closed, polygons, studies::toml_scene_text(scene));
}

class FunctionEstimator final : public Estimator {
  public:
    FunctionEstimator(PyObject* function, std::string name, std::shared_ptr<Repeatable> repeatable, const Scene& scene)
        : function_(function),
          name_(std::move(name)),
          repeatable_(std::move(repeatable)),
          faces_(static_cast<py::ssize_t>(scene.faces.size())) {
        const PythonLock held;
        scene_ = described(scene).release().ptr();
    }
    FunctionEstimator(const FunctionEstimator&) = delete;
    FunctionEstimator& operator=(const FunctionEstimator&) = delete;
    ~FunctionEstimator() override {
        const PythonLock held;
        py::handle(scene_).dec_ref();
    }

    void observe(const EstimatorTask& task, Outcome& outcome, PatchTotals& /*totals*/) const override {
        const WithoutPythonLock free;
        const auto factors_of = [&](std::uint32_t trial) {
            const auto request = samplers::request_of({task.key, trial, 0, 0}, task.samples, 0);
            return call({request.seed, request.trial}, task.samples);
        };
        repeatable_->expect(name_, "estimates", factors_of, std::mem_fn(&OutsideFactors::is_telling));
        OutsideFactors factors = factors_of(task.trial);
        outcome = {};
        outcome.estimates = std::move(factors.estimates);
        outcome.claims = std::move(factors.errors);
    }

  private:
    [[nodiscard]] Eigen::MatrixXd matrix(const py::handle& made, const std::string& origin) const {
        const Numbers rows = Numbers::ensure(made);
        if (!rows || rows.ndim() != 2 || rows.shape(0) != faces_ || rows.shape(1) != faces_)
            throw UserError("{}: returned no array of shape ({}, {}). Return a row for each face.", origin, faces_,
                            faces_);
        auto numbers = rows.cast<Eigen::MatrixXd>();
        if (!numbers.allFinite())
            throw UserError("{}: returned a number that is not finite. Correct the function.", origin);
        return numbers;
    }

    /// The function returns estimates, or a tuple of estimates and their errors.
    [[nodiscard]] OutsideFactors call(OutsideSeed seed, std::uint64_t samples) const {
        const std::string origin =
            fmt::format("{} (trial {}, seed {}, {} samples)", name_, seed.trial, seed.seed, samples);
        const PythonLock held;
        try {
            const py::object made = py::handle(function_)(py::handle(scene_), samples, seed.seed, seed.trial);
            if (!py::isinstance<py::tuple>(made) || py::len(made) != 2) return {matrix(made, origin), {}};
            const auto both = py::reinterpret_borrow<py::tuple>(made);
            OutsideFactors factors{matrix(both[0], origin), matrix(both[1], origin)};
            if (factors.errors.minCoeff() < 0)
                throw UserError("{}: returned an error below 0. Return its size.", origin);
            return factors;
        } catch (const py::error_already_set& error) {
            throw UserError("{}: raised {}", origin, error.what());
        }
    }

    PyObject* function_;
    std::string name_;
    std::shared_ptr<Repeatable> repeatable_;
    py::ssize_t faces_;
    PyObject* scene_ = nullptr;
};

}  // namespace

void add_estimator(const std::string& name, const std::string& hash, py::function estimate, bool has_sizes,
                   bool randomised) {
    // Kept for ever, as estimators are: no lock of the interpreter would be there to give it back at the end.
    PyObject* const function = estimate.release().ptr();
    const auto repeatable = std::make_shared<Repeatable>(randomised, words_of_functions);
    add(std::make_unique<AddedEstimator>(
            AddedEstimator::Texts{fmt::format("{}#{}", name, hash), "form factors that a Python function finds",
                                  "A function of the Python session. What it promises is its author's affair."},
            program_traits(has_sizes, randomised), nullptr,
            [function, name, repeatable](const Scene& scene) {
                return std::make_unique<FunctionEstimator>(function, name, repeatable, scene);
            }),
        name);
}

}  // namespace ff::python
