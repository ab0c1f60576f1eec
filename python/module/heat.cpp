#include "python/module/interruptible.hpp"
#include "python/module/module.hpp"

#include "core/support/error.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/heat/heat.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <atomic>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace ff::python {
namespace {

using studies::heat::Bounds;
using studies::heat::SolvedCase;

struct Heat {
    std::vector<std::string> names;
    std::vector<SolvedCase> cases;
    bool trusted = false;
    std::vector<std::string> warnings;
};

Heat heat(const SceneText& source, const std::string& materials, const std::string& origin, double scale,
          bool statistical, const MatrixRequest& asked) {
    Heat found;
    run_interruptibly([&](const std::atomic<bool>& stop) {
        const auto [scene, said, lengths] = studies::make_scene_with_materials(source.source());
        if (lengths != 1 && scale != 1)
            throw UserError("scale = {}: the file says 'scale {}' itself, and was read so. Leave it out.", scale,
                            lengths);
        studies::expect_no_masks(scene);
        found.names = scene.faces;
        auto cases = studies::heat::read_cases(materials, origin, {scene.faces, said});
        studies::form_factors::Request request = asked.request(stop);
        request.level_of = studies::form_factors::LevelOf::matrix;
        request.randomisations = statistical;
        auto doubts = studies::examine_scene(scene);
        auto matrix = find_matrix_without_mirrors(scene, request);
        matrix.faults = doubts.faults;
        found.trusted = studies::form_factors::is_trusted(scene, matrix, request.tolerance);
        found.warnings = std::move(doubts.faults);
        for (const auto& one : cases)
            found.warnings.insert(found.warnings.end(), one.warnings.begin(), one.warnings.end());
        found.cases = studies::heat::solve_cases(scene, matrix, std::move(cases), scale, {statistical, asked.level});
    });
    return found;
}

/// An array (cases, rows, 2) of both ends of a quantity. @param rows  of a case @param at  gives the bounds of one
template <class At>
py::array_t<double> ends(const Heat& found, std::size_t rows, At at) {
    py::array_t<double> array({found.cases.size(), rows, std::size_t{2}});
    double* place = array.mutable_data();
    for (const SolvedCase& solved : found.cases) {
        for (std::size_t row = 0; row < rows; ++row) {
            const Bounds bounds = at(solved.flows, row);
            *place++ = bounds.low;
            *place++ = bounds.high;
        }
    }
    return array;
}

auto of_faces(Bounds studies::heat::FaceFlow::*quantity) {
    return [quantity](const Heat& found) {
        return ends(found, found.names.size(),
                    [&](const auto& flows, std::size_t face) { return flows.faces[face].*quantity; });
    };
}

/// For each case: group names with both ends of their powers.
std::vector<std::vector<std::pair<std::string, std::pair<double, double>>>> groups(const Heat& found) {
    std::vector<std::vector<std::pair<std::string, std::pair<double, double>>>> all;
    for (const SolvedCase& solved : found.cases) {
        auto& of_case = all.emplace_back();
        for (const auto& group : solved.flows.groups)
            of_case.push_back({group.name, {group.power.low, group.power.high}});
    }
    return all;
}

}  // namespace

void bind_heat(py::module_& module) {
    using py::arg;
    using studies::heat::FaceFlow;
    py::class_<Heat>(module, "Heat")
        .def_readonly("names", &Heat::names)
        .def_readonly("trusted", &Heat::trusted)
        .def_readonly("warnings", &Heat::warnings)
        .def_property_readonly("cases",
                               [](const Heat& found) {
                                   std::vector<std::string> names;
                                   for (const auto& solved : found.cases) names.push_back(solved.materials.name);
                                   return names;
                               })
        .def_property_readonly("areas",
                               [](const Heat& found) {
                                   std::vector<double> areas;
                                   for (const FaceFlow& face : found.cases.front().flows.faces)
                                       areas.push_back(face.area);
                                   return areas;
                               })
        .def_property_readonly("radiosity", of_faces(&FaceFlow::radiosity))
        .def_property_readonly("irradiation", of_faces(&FaceFlow::irradiation))
        .def_property_readonly("net", of_faces(&FaceFlow::net))
        .def_property_readonly("power", of_faces(&FaceFlow::power))
        .def_property_readonly("temperature", of_faces(&FaceFlow::temperature))
        .def_property_readonly("balance",
                               [](const Heat& found) {
                                   return ends(found, 1, [](const auto& flows, std::size_t) { return flows.balance; });
                               })
        .def_property_readonly("groups", &groups);
    module.def(
        "heat",
        [](const std::string& name, const std::optional<std::string>& text, const std::string& materials,
           const std::string& origin, double scale, bool statistical, double tolerance, double level,
           std::uint64_t seed, unsigned threads, std::uint64_t max_samples) {
            return heat({name, text}, materials, origin, scale, statistical,
                        {tolerance, level, seed, threads, max_samples});
        },
        arg("name"), arg("text"), arg("materials"), arg("origin"), arg("scale"), arg("statistical"), arg("tolerance"),
        arg("level"), arg("seed"), arg("threads"), arg("max_samples"));
    module.def(
        "read_materials_file",
        [](const std::string& file) { return studies::read_text_file(file, studies::FileKind::materials); },
        arg("file"));
    module.def("face_names", [](const std::string& name, const std::optional<std::string>& text) {
        return studies::make_scene(SceneText{name, text}.source()).faces;
    });
}

}  // namespace ff::python
