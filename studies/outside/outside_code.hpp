#pragma once

#include "core/estimators/estimator.hpp"
#include "samplers/sampler.hpp"
#include "studies/outside/program.hpp"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ff::studies {

/// Code that a study file, or a bands file, asks to run: it was written by others.
struct OutsideCode {
    enum class Kind {
        plugin,     ///< `text` is the path of a library
        sampler,    ///< `text` is "command:…"
        estimator,  ///< the same
    };
    Kind kind = Kind::plugin;
    std::string text;
    std::string place;  ///< "file:line:column"
};

/// The code that a file's text asks to run, in order, each once. Nothing is run. @throws UserError where it is not TOML
std::vector<OutsideCode> outside_code(std::string_view text, std::string_view origin);

/// Loads a plug-in, or adds the sampler or estimator of a command, so that the file can be read: `parse_study` itself
/// runs nothing.
/// @param folder  of the file @param deadline of a command, seconds per run
/// @throws UserError, IoError
void admit(const OutsideCode& code, const std::filesystem::path& folder, double deadline = usual_deadline);

/// Loads a plug-in (include/ffstudy/plugin.h) for the rest of the process, and adds its samplers. Each is found by its
/// own name, and by NAME#HASH with a hash of the file, which studies store: a rebuilt plug-in is a different one.
///
/// Loading a library runs its start-up code: load only what is trusted.
/// @param folder  base of a relative `path`
/// @throws IoError where the file cannot be read; UserError where it is not a plug-in, is of another version of the
/// interface, has a name that is taken, or was changed since it was loaded
std::vector<const samplers::CatalogueEntry*> load_plugin(const std::filesystem::path& path,
                                                         const std::filesystem::path& folder = {});

/// Adds a sampler whose sets a program prints, "command:./mine --n {n} --d {d} --seed {seed}"; it runs when points are
/// requested. Its output is read like a file of points. An existing sampler of this name stays.
/// @throws UserError, IoError as Program does
const samplers::CatalogueEntry& load_command_sampler(std::string_view name, const std::filesystem::path& folder,
                                                     double deadline = usual_deadline);

/// Adds an estimator that is a program, "command:./mine {scene} {samples} {seed}". For every trial it receives the
/// scene as a file and prints lines from,to,estimate: a form factor for every two faces, by name. `{scene}` is OBJ
/// where all surfaces are polygons, else TOML; `{obj}`, `{toml}` and `{vs3}` have that format. Without `{samples}` it
/// has no sizes; without `{seed}` and `{trial}` one trial. An existing estimator of this name stays.
/// @throws UserError where the command does not name the scene, and as Program does; IoError
const EstimatorEntry& load_command_estimator(std::string_view name, const std::filesystem::path& folder,
                                             double deadline = usual_deadline);

/// A sampler that a user names: from the catalogue or a loaded plug-in, points of a file, or a command.
/// @throws UserError, IoError
const samplers::CatalogueEntry& sampler_of_user(std::string_view name, double deadline = usual_deadline);

}  // namespace ff::studies
