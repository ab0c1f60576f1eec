#include "reports/programs/hand_over.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "reports/csv/csv_field.hpp"
#include "reports/programs/writers.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ff::reports {
namespace {

void expect_nothing(const Scene& scene) {
    static_cast<void>(scene);
}

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
            throw UserError(fmt::format("--format {} is unknown. {}Known: {}.", format, did_you_mean(format, names),
                                        program_formats_in_words()));
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

void expect_few_faces(const Scene& scene, std::string_view format) {
    if (scene.faces.size() <= studies::form_factors::most_dense_faces) return;
    throw UserError(
        fmt::format("--format {}: scene '{}' has {} faces (the format takes all zeros of the matrix; at "
                    "most {} are written). Put surfaces into groups.",
                    format, scene.name, scene.faces.size(), studies::form_factors::most_dense_faces));
}

Eigen::VectorXd whole_row(const HandedOn& handed, Eigen::Index row) {
    return Eigen::VectorXd(handed.factors.row(row).transpose());
}

}  // namespace ff::reports
