#pragma once

#include "app/command_line/command_definition.hpp"
#include "app/process/exit_code.hpp"

#include "core/geometry/fwd.hpp"
#include "studies/form_factors/request.hpp"
#include "studies/form_factors/store/store.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {

/// Options of `ffstudy form-factors`.
struct FormFactorsCommand {
    std::string scene;           ///< built-in name, or a file; empty: load a matrix
    std::filesystem::path load;  ///< folder or store of an earlier run; empty: none
    std::string faces;    ///< what a face of an OBJ file or a mesh is: "group", "object", "material" or "polygon"
    std::string zone;     ///< zone or space of an EnergyPlus file
    bool closed = false;  ///< treat an OBJ file or a mesh as closed
    std::optional<double> scale;             ///< what lengths of an OBJ file or a mesh are multiplied by
    std::string up;                          ///< its axis that points up: "x", "y" or "z"; empty: not said
    studies::form_factors::Request request;  ///< except seed, threads and the meaning of level
    std::uint64_t seed = 1;
    std::optional<unsigned> threads;
    std::optional<std::string> max_time;
    std::optional<std::string> max_memory;
    std::optional<std::string> shard;
    bool dry_run = false;
    bool whole_matrix = false;
    std::filesystem::path out;         ///< empty: nothing is written
    std::string from;                  ///< points, "point:x,y,z,nx,ny,nz" or a file: only their factors are computed
    bool text = false;                 ///< also text files of a large matrix
    std::vector<std::string> formats;  ///< formats of other programs, for files in `out`
    bool quiet = false;
};

/// File of a matrix in a folder of results.
inline constexpr const char* matrix_store_file = "form_factors.sqlite";

/// Settings that a scene file does not contain itself.
void add_options_of_scenes(CommandDefinition& sub, FormFactorsCommand& command);

/// Scale and orientation of an OBJ file or a mesh. Heat has a scale of its own, for every scene.
void add_options_of_places(CommandDefinition& sub, FormFactorsCommand& command);

/// All options so far, except --load and these others, exclude --load: a loaded matrix has settled them.
void settle_by_load(CommandDefinition& sub, std::initializer_list<std::string_view> others);

/// How an OBJ file or a mesh is to be read, according to the command line: options without their dashes. The file could
/// contain the same texts as comments.
std::vector<std::string> said_of_mesh(const FormFactorsCommand& command);

/// The scene that a command names, with its text. @throws UserError where it names none, or an option does not fit it
studies::SceneSource read_source(const FormFactorsCommand& command);

/// @throws UserError where faces of it are mirrors
Scene scene_without_mirrors(const studies::SceneSource& source);

/// All form factors between the faces of a scene, with intervals; inconclusive where one misses the tolerance.
ExitCode form_factors(const FormFactorsCommand& command);

/// Form factors from the points of --from to the faces of a scene.
ExitCode sensor_factors(const FormFactorsCommand& command);

/// Samples a few rows of a matrix and prints what all would take: time, samples, memory and room on the disk.
ExitCode predict_form_factors(const studies::form_factors::KeptMatrix& kept);

/// The request and the scene of a command, read and validated. @throws UserError, IoError
studies::form_factors::KeptMatrix prepare_form_factors(const FormFactorsCommand& command);

/// Prints a note on faces without a single emissivity. @param instead  "1 in view3d.txt"
void note_unknown_emissivities(const std::vector<std::optional<double>>& emissivities, std::string_view instead);

/// The matrix that --load names, with the faults of its scene. @throws UserError, IoError
studies::form_factors::KeptMatrix load_kept_form_factors(const FormFactorsCommand& command);

/// @throws UserError where pairs were dropped: `what` needs them all
void expect_nothing_dropped(const studies::form_factors::KeptMatrix& kept, std::string_view what);

/// Finds a matrix: studies::form_factors::find_matrix, or a function that calls it.
using FindFormFactors =
    std::function<studies::form_factors::Matrix(const Scene&, const studies::form_factors::Request&)>;

/// Fills in the matrix, with notes and progress on stderr. True where a signal has ended it early.
bool compute_form_factors(const FormFactorsCommand& command, studies::form_factors::KeptMatrix& kept,
                          const FindFormFactors& find = studies::form_factors::find_matrix);

/// Options of `ffstudy merge`.
struct MergeCommand {
    std::vector<std::filesystem::path> sources;  ///< folders or stores
    std::filesystem::path out;
    bool randomisations = false;  ///< see studies::form_factors::Request
    bool quiet = false;
};

/// Brings the rows of shards together and writes the matrix; inconclusive where rows are missing.
ExitCode merge_form_factors(const MergeCommand& command);

}  // namespace ff::app
