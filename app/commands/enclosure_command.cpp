#include "app/commands/commands.hpp"

#include "app/command_line/common_options.hpp"
#include "app/command_line/program.hpp"
#include "app/commands/run_request.hpp"
#include "app/folders/output_folder.hpp"
#include "app/terminal/output.hpp"

#include "reports/files/array_files.hpp"
#include "reports/markdown/enclosure_text.hpp"
#include "studies/radiosity/enclosure_study.hpp"

#include <utility>

namespace ff::app {
namespace {

/// Options of `ffstudy enclosure`.
struct EnclosureCommand {
    studies::radiosity::EnclosureRequest request;  ///< without light and seed
    RadiosityOptions light;
    std::uint64_t seed = 1;
    std::filesystem::path out;
    bool quiet = false;
};

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

ExitCode enclosure(const EnclosureCommand& command) {
    studies::radiosity::EnclosureRequest request = command.request;
    set_light(request.light, command.light);
    request.seed = checked_seed(command.seed);
    const studies::radiosity::EnclosureResults results = studies::radiosity::study_enclosure(request);
    const std::string text = reports::enclosure_text(request, results);
    if (!command.out.empty()) write_enclosure_files(command.out, request, results, text);
    if (!command.quiet) print_folded(text);
    return ExitCode::passed;
}

}  // namespace

void add_enclosure(ProgramDefinition& program) {
    const auto [sub, command] = program.command<EnclosureCommand>(
        laboratory, "enclosure", "Light where surfaces see themselves: round rooms, mirrors", enclosure);
    auto& request = command.request;
    request.rays = 1000;
    sub.option("SHAPE", request.name, "cylinder:RxH, cap:RxH, cone:RxH, spheres:RxS, or cube, box:AxBxC",
               {.is_required = true});
    sub.option("--mirror", request.mirror, "The face of a box that is a perfect mirror", {.type = "FACE"});
    sub.option("--reflectance", command.light.reflectance,
               "Reflectances, each solved for separately (default: 0.1,0.5,0.9,0.99,0.999)", {.type = "LIST"});
    sub.option("--emission", command.light.emission,
               "Emitted exitance, one number or one for each surface (default: 1 on the last)", {.type = "LIST"});
    sub.option("--trials", request.trials, "Trials of rays drawn from the exact factors (default: 0)");
    sub.option("--rays", request.rays, "Rays from each surface in a trial", {.shows_default = true});
    sub.option("--seed", command.seed, "Seed of all random numbers", {.shows_default = true});
    sub.option("--out", command.out, "Folder for enclosure.md and the matrices (default: none is written)",
               {.type = "DIR"});
    add_verbosity(sub, command.quiet);
}

}  // namespace ff::app
