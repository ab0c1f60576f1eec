#include "python/module/module.hpp"

#include "app/commands/gates/check_estimates.hpp"

#include "reports/csv/gates_csv.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/bands_file.hpp"
#include "studies/verdicts/gate_result.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace ff::python {
namespace {

struct Verdicts {
    std::string verdict;
    std::vector<std::tuple<std::string, std::string, std::string, std::string>> gates;  ///< name, kind, verdict, words
    std::string comparisons;                                                            ///< as verdicts.csv
};

/// @param bands  text of a bands file, which `origin` names in messages
Verdicts judge(const std::string& bands, const std::string& origin, const std::filesystem::path& estimates,
               const std::filesystem::path& against) {
    const auto spec = studies::gates::parse_bands(bands, origin, nullptr);
    app::CheckCommand command;
    command.estimates = estimates;
    command.against = against;
    const studies::gates::CheckResults check{spec, app::judge_file(command, spec)};
    Verdicts found;
    found.verdict = name(check.verdict());
    for (const studies::gates::GateResult& result : check.results) {
        std::string words = result.comparisons.empty() ? result.note : reports::gate_in_words(result);
        found.gates.emplace_back(result.gate, name(result.kind), name(result.verdict), std::move(words));
    }
    std::ostringstream rows;
    reports::write_verdicts_csv(rows, check);
    found.comparisons = std::move(rows).str();
    return found;
}

}  // namespace

void bind_gates(py::module_& module) {
    py::class_<Verdicts>(module, "Verdicts")
        .def_readonly("verdict", &Verdicts::verdict)
        .def_readonly("gates", &Verdicts::gates)
        .def_readonly("comparisons", &Verdicts::comparisons);
    module.def("judge", &judge, py::arg("bands"), py::arg("origin"), py::arg("estimates"), py::arg("against"),
               py::call_guard<py::gil_scoped_release>());
    module.def(
        "read_bands_file",
        [](const std::filesystem::path& file) { return studies::read_text_file(file, studies::FileKind::bands); },
        py::arg("file"));
}

}  // namespace ff::python
