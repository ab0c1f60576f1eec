#include "reports/programs/hand_over.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/text/numbers.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>
#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <utility>

namespace ff::reports {
namespace {

void expect_few_faces(const Scene& scene, std::string_view format) {
    if (scene.faces.size() <= studies::form_factors::most_dense_faces) return;
    throw UserError(
        "--format {}: scene '{}' has {} faces (the format takes all zeros of the matrix; at "
        "most {} are written). Put surfaces into groups.",
        format, scene.name, scene.faces.size(), studies::form_factors::most_dense_faces);
}

/// A row including zeros.
Eigen::VectorXd whole_row(const HandedOn& handed, Eigen::Index row) {
    return handed.factors.row(row).transpose();
}

// A line that View3D begins its text files with (its name, a version, out encl emit N), areas, rows, emissivities.
// @see [view3d]

void expect_view3d(const Scene& scene) {
    expect_few_faces(scene, "view3d");
}

void write_view3d(std::ostream& out, const HandedOn& handed) {
    constexpr double black = 1;
    const auto n = handed.factors.rows();
    const std::string header =
        fmt::format("View3D by-ffstudy 0 {} 0 {}", studies::form_factors::rows_add_up(handed.scene) ? 1 : 0, n);
    constexpr int width = 30;  // least width that its reader expects
    out << fmt::format("{:<{}}\n{}\n", header, width, fmt::join(handed.matrix.areas, " "));
    for (Eigen::Index row = 0; row < n; ++row) out << fmt::format("{}\n", fmt::join(whole_row(handed, row), " "));
    std::vector<double> emissivities(handed.matrix.faces(), black);
    for (std::size_t face = 0; face < handed.emissivities.size(); ++face)
        emissivities[face] = handed.emissivities[face].value_or(black);
    out << fmt::format("{}\n", fmt::join(emissivities, " "));
}

// Fields of the object, in the names that its schema gives them. @see [energyplus]
constexpr std::string_view view_factors_object = "ZoneProperty:UserViewFactors:BySurfaceName";
constexpr std::string_view marks = ",;!";  // punctuation of the IDF format
constexpr std::size_t longest_name = 100;

/// The name of the zone in the scene's file; otherwise the scene's name without the extension of a file.
std::string zone_of(const Scene& scene) {
    std::string name = studies::scene_source(scene.name).zone;
    if (!name.empty()) return name;
    name = scene.name;
    if (!scene.empty_box) name = std::filesystem::path(name).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return marks.find(c) != std::string_view::npos; }, '_');
    return name.substr(0, longest_name);
}

void expect_energyplus(const Scene& scene) {
    expect_few_faces(scene, "energyplus");
    std::set<std::string> names;
    for (const std::string& face : scene.faces) {
        if (face.find_first_of(marks) != std::string::npos)
            throw UserError("--format energyplus: face '{}' (a name has none of , ; ! there). Rename it.", face);
        if (face.size() > longest_name)
            throw UserError(
                "--format energyplus: face '{}' (a name has at most {} characters there). "
                "Shorten it.",
                face, longest_name);
        if (!names.insert(in_capitals(face)).second)
            throw UserError(
                "--format energyplus: two faces are '{}' in capitals (names are compared so "
                "there). Rename one.",
                in_capitals(face));
    }
}

void write_idf(std::ostream& out, const HandedOn& handed) {
    const auto& faces = handed.scene.faces;
    out << fmt::format("! Form factors of {}, by ffstudy\n{},\n  {},  !- Zone or ZoneList or Space or SpaceList Name\n",
                       handed.scene.name, view_factors_object, zone_of(handed.scene));
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Eigen::VectorXd row = whole_row(handed, static_cast<Eigen::Index>(i));
        for (std::size_t j = 0; j < faces.size(); ++j) {
            const bool last = i + 1 == faces.size() && j + 1 == faces.size();
            out << fmt::format("  {}, {}, {}{}\n", faces[i], faces[j], row[static_cast<Eigen::Index>(j)],
                               last ? ';' : ',');
        }
    }
}

void write_epjson(std::ostream& out, const HandedOn& handed) {
    const auto& faces = handed.scene.faces;
    nlohmann::ordered_json factors = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < faces.size(); ++i) {
        const Eigen::VectorXd row = whole_row(handed, static_cast<Eigen::Index>(i));
        for (std::size_t j = 0; j < faces.size(); ++j)
            factors.push_back({{"from_surface", faces[i]},
                               {"to_surface", faces[j]},
                               {"view_factor", row[static_cast<Eigen::Index>(j)]}});
    }
    const nlohmann::ordered_json file = {
        {view_factors_object,
         {{fmt::format("{} 1", view_factors_object),
           {{"zone_or_zonelist_or_space_or_spacelist_name", zone_of(handed.scene)}, {"view_factors", factors}}}}}};
    out << file.dump(1) << '\n';
}

// A user object with the factors as a list of rows. MOOSE wants rows that add up to 1 (to 0.05), and divides them by
// their sums. @see [moose]

void expect_moose(const Scene& scene) {
    expect_few_faces(scene, "moose");
    if (scene.closed && !studies::form_factors::rows_add_up(scene))
        throw UserError(
            "--format moose: scene '{}' has surfaces that belong to no face (rows have to add up to 1 there). Give "
            "them "
            "a face.",
            scene.name);
    if (!scene.closed)
        throw UserError(
            "--format moose: scene '{}' is open (rows have to add up to 1 there). Add "
            "--surroundings NAME, a face that receives the rest.",
            scene.name);
    for (const std::string& face : scene.faces) {
        if (face.find_first_of(" '\"#=[]{};$") != std::string::npos)
            throw UserError("--format moose: face '{}' (a boundary is a single word there). Rename it.", face);
    }
}

void write_moose(std::ostream& out, const HandedOn& handed) {
    const auto& known = handed.emissivities;
    const bool has_emissivities =
        std::all_of(known.begin(), known.end(), [](const auto& one) { return one.has_value(); });
    out << fmt::format(
        "# Form factors of {}, by ffstudy. The temperature{} to be added.\n"
        "[UserObjects]\n"
        "  [form_factors]\n"
        "    type = ConstantViewFactorSurfaceRadiation\n"
        "    boundary = '{}'\n",
        handed.scene.name, has_emissivities ? " is" : " and the emissivities are", fmt::join(handed.scene.faces, " "));
    if (has_emissivities) {
        std::vector<double> emissivities;
        for (const auto& one : known) emissivities.push_back(*one);
        out << fmt::format("    emissivity = '{}'\n", fmt::join(emissivities, " "));
    }
    out << "    view_factors = '";
    for (Eigen::Index row = 0; row < handed.factors.rows(); ++row)
        out << fmt::format("{}{}", row == 0 ? "" : ";\n                    ", fmt::join(whole_row(handed, row), " "));
    out << "'\n  []\n[]\n";
}

// Per face, the factors to the faces that it sees (F), and their numbers from 0 (globalFaceFaces). @see [openfoam]

using Row = studies::form_factors::Matrix::Sparse::InnerIterator;

template <class Entry>
void write_lists(std::ostream& out, const HandedOn& handed, std::string_view type, std::string_view object,
                 Entry entry_of) {
    out << fmt::format(
        "FoamFile\n{{\n    version     2.0;\n    format      ascii;\n    class       {};\n"
        "    location    \"constant\";\n    object      {};\n}}\n\n{}\n(\n",
        type, object, handed.factors.rows());
    for (Eigen::Index i = 0; i < handed.factors.rows(); ++i) {
        std::vector<decltype(entry_of(Row(handed.factors, i)))> list;
        for (Row entry(handed.factors, i); entry; ++entry) list.push_back(entry_of(entry));
        out << fmt::format("{}({})\n", list.size(), fmt::join(list, " "));
    }
    out << ")\n";
}

void write_openfoam_factors(std::ostream& out, const HandedOn& handed) {
    write_lists(out, handed, "scalarListList", "F", [](const Row& entry) { return entry.value(); });
}

void write_openfoam_faces(std::ostream& out, const HandedOn& handed) {
    write_lists(out, handed, "labelListList", "globalFaceFaces", [](const Row& entry) { return entry.col(); });
}

// For each boundary element how many factors follow, then on a line each: row, column (from 1), factor. @see [elmer]
void write_elmer(std::ostream& out, const HandedOn& handed) {
    for (Eigen::Index i = 0; i < handed.factors.rows(); ++i) {
        std::vector<std::string> lines;
        for (Row entry(handed.factors, i); entry; ++entry)
            lines.push_back(fmt::format("{} {} {}\n", entry.row() + 1, entry.col() + 1, entry.value()));
        out << fmt::format("{}\n{}", lines.size(), fmt::join(lines, ""));
    }
}

void expect_nothing(const Scene& /*scene*/) {}

constexpr std::array known_files{
    ProgramFile{"view3d", "view3d.txt", expect_view3d, write_view3d},
    ProgramFile{"energyplus", "energyplus.idf", expect_energyplus, write_idf},
    ProgramFile{"energyplus", "energyplus.epJSON", expect_energyplus, write_epjson},
    ProgramFile{"moose", "moose.i", expect_moose, write_moose},
    ProgramFile{"openfoam", "openfoam/F", expect_nothing, write_openfoam_factors},
    ProgramFile{"openfoam", "openfoam/globalFaceFaces", expect_nothing, write_openfoam_faces},
    ProgramFile{"elmer", "ViewFactors.dat", expect_nothing, write_elmer},
};

std::vector<std::string_view> names_of_formats() {
    std::vector<std::string_view> names;
    for (const ProgramFile& file : known_files) {
        if (names.empty() || names.back() != file.format) names.push_back(file.format);
    }
    return names;
}

}  // namespace

HandedOn hand_on(const Scene& scene, const studies::form_factors::Matrix& matrix,
                 std::vector<std::optional<double>> emissivities) {
    const bool repaired = matrix.repaired && matrix.repaired->possible;
    return {scene, matrix, repaired ? matrix.repaired->factors : matrix.factors(), std::move(emissivities)};
}

std::string program_formats_in_words() {
    return fmt::format("{}", fmt::join(names_of_formats(), ", "));
}

std::vector<ProgramFile> files_of_formats(const std::vector<std::string>& formats, const Scene& scene) {
    const auto names = names_of_formats();
    for (const std::string& format : formats) {
        if (std::find(names.begin(), names.end(), format) == names.end())
            throw UserError("--format {} is unknown. {}Known: {}.", format, did_you_mean(format, names),
                            program_formats_in_words());
    }
    std::vector<ProgramFile> files;
    for (const ProgramFile& file : known_files) {
        if (std::find(formats.begin(), formats.end(), file.format) == formats.end()) continue;
        file.expect(scene);
        files.push_back(file);
    }
    return files;
}

void write_intervals(std::ostream& out, const HandedOn& handed) {
    out << "row,column,from,to,factor,low,high\n";
    const auto& [scene, matrix, factors, emissivities] = handed;
    const auto rows = studies::form_factors::by_face(matrix.exchanges, matrix.faces());
    for (std::size_t from = 0; from < rows.size(); ++from) {
        for (const std::uint32_t index : rows[from]) {
            const studies::form_factors::FaceExchange& exchange = matrix.exchanges[index];
            if (exchange.high <= 0) continue;
            const std::size_t to = exchange.from == from ? exchange.to : exchange.from;
            const double factor = factors.coeff(static_cast<Eigen::Index>(from), static_cast<Eigen::Index>(to));
            out << fmt::format("{},{},{},{},{},{},{}\n", from + 1, to + 1, csv_field(scene.faces[from]),
                               csv_field(scene.faces[to]), exact(factor), exact(exchange.low / matrix.areas[from]),
                               exact(exchange.high / matrix.areas[from]));
        }
    }
}

}  // namespace ff::reports
