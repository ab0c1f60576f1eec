#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/commands/run_request.hpp"
#include "app/folders/output_folder.hpp"

#include "reports/files/matrix_files.hpp"
#include "reports/markdown/enclosure_text.hpp"
#include "studies/radiosity/enclosure_study.hpp"

#include <fmt/format.h>

#include <utility>

namespace ff::app {
namespace {

void write_enclosure_files(const std::filesystem::path& folder, const studies::radiosity::EnclosureRequest& request,
                           const studies::radiosity::EnclosureResults& results, const std::string& text) {
    OutputFolder out(folder, "enclosure");
    out.write("enclosure.md", text);
    for (const auto& [file, matrix] :
         {std::pair<std::string, Eigen::MatrixXd>{"form_factors", results.of.enclosure.factors},
          {"areas", results.of.enclosure.areas},
          {"emission", results.emission}}) {
        out.write(file + ".mtx", reports::matrix_market(matrix, request.name));
        out.write(file + ".npy", reports::npy(matrix));
    }
}

}  // namespace

ExitCode enclosure(const EnclosureCommand& command) {
    studies::radiosity::EnclosureRequest request;
    request.name = command.name;
    request.mirror = command.mirror;
    set_light(request.light, command.light);
    request.rays = command.rays;
    request.trials = command.trials;
    request.seed = checked_seed(command.seed);
    const studies::radiosity::EnclosureResults results = studies::radiosity::study_enclosure(request);
    const std::string text = reports::enclosure_text(request, results);
    if (!command.out.empty()) write_enclosure_files(command.out, request, results, text);
    if (!command.quiet) fmt::print("{}", text);
    return ExitCode::passed;
}

}  // namespace ff::app
