#include "python/module/module.hpp"

#include "python/module/interruptible.hpp"

#include "app/commands/context/run_context.hpp"
#include "app/folders/folder_lock.hpp"

#include "core/support/error.hpp"
#include "reports/csv/csv.hpp"
#include "reports/markdown/markdown.hpp"
#include "reports/pictures/answer_svg.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/words/answer.hpp"
#include "studies/outside/outside_code.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/results/results.hpp"
#include "studies/run/run.hpp"
#include "studies/spec/spec.hpp"

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace ff::python {
namespace {

struct StudyTables {
    std::string summary;  ///< as summary.csv
    std::string slopes;
    std::string trials;
    std::string report;  ///< as report.md
    std::string answer;
    std::string picture;  ///< SVG of what the answer ranks; empty where it ranks nothing
    std::vector<std::string> warnings;
    bool complete = false;
};

/// The content of a study file, with the changes that the caller requests.
/// @param origin  the file, for messages and for the folder of other files
studies::StudyPlan plan_of(const std::string& text, const std::string& origin,
                           const std::optional<std::uint64_t>& trials, const std::optional<std::uint64_t>& seed) {
    studies::StudySpec spec = studies::parse_study(text, origin);
    studies::read_named_files(spec, std::filesystem::path(origin).parent_path());
    if (trials) studies::set_trials(spec, *trials);
    if (seed) spec.seed = Seed{*seed};
    return studies::plan_study(std::move(spec));
}

template <class Write>
std::string text_of(Write write) {
    std::ostringstream out;
    write(out);
    return std::move(out).str();
}

StudyTables tables_of(const studies::Store& store, const std::atomic<bool>& stop) {
    const auto results = studies::evaluate(store, &stop);
    StudyTables tables;
    tables.summary = text_of([&](std::ostream& out) { reports::write_summary_csv(out, results.findings); });
    tables.slopes = text_of([&](std::ostream& out) { reports::write_slopes_csv(out, results); });
    tables.trials = text_of([&](std::ostream& out) { reports::write_trials_csv(out, store); });
    tables.report = reports::markdown_report(results);
    tables.answer = reports::answer(results).text;
    if (const auto lead = reports::answer_picture(results)) tables.picture = reports::answer_svg(*lead);
    tables.warnings = results.findings.plan.warnings;
    tables.complete = store.is_complete();
    return tables;
}

/// Notes who computed a finished study, once.
void note_context(studies::Store& store, unsigned threads, std::chrono::steady_clock::duration spent) {
    studies::Context context = store.context();
    if (context.contains("command")) return;
    studies::add_context(
        context, app::describe_run("ffstudy.Study.run()", threads, std::chrono::duration<double>(spent).count()));
    store.set_context(context);
}

StudyTables run(const std::string& text, const std::string& origin, const std::optional<std::uint64_t>& trials,
                const std::optional<std::uint64_t>& seed, const std::filesystem::path& folder, unsigned threads,
                const std::optional<py::function>& progress) {
    StudyTables tables;
    run_interruptibly([&](const std::atomic<bool>& stop) {
        const studies::StudyPlan plan = plan_of(text, origin, trials, seed);
        std::filesystem::create_directories(folder);
        const app::FolderLock lock(folder);
        studies::Store store = studies::Store::create_or_resume(folder / "results.sqlite", plan);
        studies::RunOptions options;
        options.threads = threads;
        options.stop = &stop;
        options.drop = &stop;
        if (progress) {
            options.report = [&](const studies::RunProgress& state) {
                const py::gil_scoped_acquire held;
                try {
                    (*progress)(state.units_done, state.units);
                } catch (const py::error_already_set& error) {
                    throw UserError("progress: raised {}", error.what());
                }
            };
        }
        const auto start = std::chrono::steady_clock::now();
        const bool complete = studies::run_study(store, options) == studies::RunOutcome::complete;
        if (complete) note_context(store, threads, std::chrono::steady_clock::now() - start);
        static_cast<void>(store.seal());
        if (complete) tables = tables_of(store, stop);
    });
    return tables;
}

/// The outside code that a study asks to run, each with its place.
std::vector<std::pair<std::string, std::string>> wants(const std::string& text, const std::string& origin) {
    std::vector<std::pair<std::string, std::string>> found;
    for (const auto& code : studies::outside_code(text, origin)) found.emplace_back(code.place, code.text);
    return found;
}

void admit(const std::string& text, const std::string& origin, double deadline) {
    for (const auto& code : studies::outside_code(text, origin))
        studies::admit(code, std::filesystem::path(origin).parent_path(), deadline);
}

}  // namespace

void bind_study(py::module_& module) {
    py::class_<StudyTables>(module, "StudyTables")
        .def_readonly("summary", &StudyTables::summary)
        .def_readonly("slopes", &StudyTables::slopes)
        .def_readonly("trials", &StudyTables::trials)
        .def_readonly("report", &StudyTables::report)
        .def_readonly("answer", &StudyTables::answer)
        .def_readonly("picture", &StudyTables::picture)
        .def_readonly("warnings", &StudyTables::warnings)
        .def_readonly("complete", &StudyTables::complete);
    module.def("run_study", &run, py::arg("text"), py::arg("origin"), py::arg("trials"), py::arg("seed"),
               py::arg("folder"), py::arg("threads"), py::arg("progress"));
    module.def(
        "read_study_file",
        [](const std::filesystem::path& file) { return studies::read_text_file(file, studies::FileKind::study); },
        py::arg("file"));
    module.def("wants", &wants, py::arg("text"), py::arg("origin"));
    module.def("admit", &admit, py::arg("text"), py::arg("origin"), py::arg("deadline"));
    module.def(
        "load_plugin",
        [](const std::filesystem::path& file) {
            std::vector<std::string> names;
            for (const auto* sampler : studies::load_plugin(file)) names.emplace_back(sampler->info.name);
            return names;
        },
        py::arg("file"));
}

}  // namespace ff::python
