#include "core/support/error.hpp"
#include "reports/programs/writers.hpp"
#include "studies/scene_files/scene_source.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>

namespace ff::reports {
namespace {

// Fields of the object, in the names that its schema gives them. @see [energyplus]
constexpr std::string_view view_factors_object = "ZoneProperty:UserViewFactors:BySurfaceName";
constexpr std::string_view marks = ",;!";  // of the IDF format
constexpr std::size_t longest_name = 100;

/// That of the scene's file; else the zone has the scene's name, without a file's extension.
std::string zone_of(const Scene& scene) {
    std::string name = studies::scene_source(scene.name).zone;
    if (!name.empty()) return name;
    name = scene.name;
    if (!scene.empty_box) name = std::filesystem::path(name).stem().string();
    std::replace_if(
        name.begin(), name.end(), [](char c) { return marks.find(c) != std::string_view::npos; }, '_');
    return name.substr(0, longest_name);
}

std::string in_capitals(std::string name) {
    std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
    return name;
}

}  // namespace

void expect_energyplus(const Scene& scene) {
    expect_few_faces(scene, "energyplus");
    std::set<std::string> names;
    for (const std::string& face : scene.faces) {
        if (face.find_first_of(marks) != std::string::npos)
            throw UserError(
                fmt::format("--format energyplus: face '{}' (a name has none of , ; ! there). Rename it.", face));
        if (face.size() > longest_name)
            throw UserError(
                fmt::format("--format energyplus: face '{}' (a name has at most {} characters there). "
                            "Shorten it.",
                            face, longest_name));
        if (!names.insert(in_capitals(face)).second)
            throw UserError(
                fmt::format("--format energyplus: two faces are '{}' in capitals (names are compared so "
                            "there). Rename one.",
                            in_capitals(face)));
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

}  // namespace ff::reports
