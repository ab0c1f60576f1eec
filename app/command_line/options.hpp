#pragma once

#include "app/command_line/check_options.hpp"
#include "app/command_line/outside_options.hpp"

#include "studies/form_factors/form_factors.hpp"
#include "studies/spec/convergence_study.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace ff::app {

/// Settings of `ffstudy radiosity` that override those of the study file; empty texts override nothing.
struct RadiosityOptions {
    std::string reflectance;  ///< "0.5,0.9"
    std::string emission;     ///< "0,0,0,0,0,1"
    std::optional<std::uint64_t> patch_trials;
};

/// Options of commands that run a study.
struct RunCommand {
    std::string study;  ///< built-in name, or a file
    std::optional<std::uint64_t> trials;
    std::optional<std::uint64_t> seed;
    std::optional<unsigned> threads;
    std::optional<std::string> shard;       ///< "i/n"
    std::optional<std::string> max_time;    ///< "90", "15m"
    std::optional<std::string> max_memory;  ///< "500M"
    std::filesystem::path out;              ///< empty: results/<study>
    std::filesystem::path templates;        ///< folder of custom templates; empty: none
    bool quiet = false;
    bool replace = false;  ///< replace another study in the folder
    bool dry_run = false;
    std::optional<studies::ConvergenceRequest> convergence;  ///< instead of `study`
    std::optional<RadiosityOptions> radiosity;
    std::optional<std::string> until;  ///< "rmse=1e-5" or "ci=1e-5"
    std::optional<double> level;
    OutsideOptions outside;
    std::filesystem::path study_file;  ///< to write the study to; empty: nowhere
};

/// Options of `ffstudy enclosure`.
struct EnclosureCommand {
    std::string name;
    std::optional<std::string> mirror;
    RadiosityOptions light;
    std::uint64_t rays = 1000;
    std::uint64_t trials = 0;
    std::uint64_t seed = 1;
    std::filesystem::path out;
    bool quiet = false;
};

/// Options of `ffstudy form_factors`.
struct FormFactorsCommand {
    std::string scene;           ///< built-in name, or a file; empty: load a matrix
    std::filesystem::path load;  ///< folder or store of an earlier run; empty: none
    std::string faces;    ///< what a face of an OBJ file or a mesh is: "group", "object", "material" or "polygon"
    std::string zone;     ///< of an EnergyPlus file, or a space
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
    std::string from;                  ///< points, "point:x,y,z,nx,ny,nz" or a file, to whose factors all is reduced
    bool text = false;                 ///< also text files of a large matrix
    std::vector<std::string> formats;  ///< formats of other programs, for files in `out`
    bool quiet = false;
};

/// Options of `ffstudy convert`.
struct ConvertCommand {
    FormFactorsCommand scene;  ///< the scene and how it is read
    std::filesystem::path out;
    std::optional<std::size_t> facets;  ///< polygons around a curved surface; empty: it stays as it is
};

/// Options of `ffstudy heat`.
struct HeatCommand {
    FormFactorsCommand factors;  ///< their level holds for all factors at once
    std::filesystem::path materials;
    double scale = 1;                           ///< metres of a unit of length of the scene
    std::optional<std::string> tolerance;       ///< largest error of form factors, or of powers, as typed
    std::string tolerance_of = "factor";        ///< or "flux"
    std::optional<std::string> flow_tolerance;  ///< largest error of powers, where `tolerance` is that of form factors
    bool gebhart = false;                       ///< Gebhart factors as well
};

struct ReportCommand {
    std::filesystem::path results;  ///< folder or store
    std::filesystem::path out;      ///< empty: the folder of the store
    std::vector<std::string> formats;
    std::vector<std::string> pictures;  ///< pictures to draw as files: names or their beginnings; empty: all
    std::filesystem::path templates;    ///< folder of custom templates; empty: none
    bool quiet = false;
};

struct MergeCommand {
    std::vector<std::filesystem::path> sources;  ///< folders or stores
    std::filesystem::path out;
    bool quiet = false;
};

struct CompareCommand {
    std::filesystem::path first;  ///< folder or store, optionally with a method: "results/a:sobol"
    std::filesystem::path second;
    std::filesystem::path out;        ///< empty: nothing is written
    std::filesystem::path templates;  ///< folder of custom templates; empty: none
    bool json = false;                ///< instead of text
    bool quiet = false;
};

struct AuditCommand {
    std::filesystem::path tables;
    std::filesystem::path out;  ///< empty: nothing is written
    bool quiet = false;
};

/// Options of `ffstudy list` and `ffstudy explain`.
struct ListCommand {
    std::string name;  ///< kind, or what to explain; empty: an overview
    OutsideOptions outside;
    bool json = false;
};

}  // namespace ff::app
