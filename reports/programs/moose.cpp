#include "core/support/error.hpp"
#include "reports/programs/writers.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace ff::reports {

// A user object with the factors as a list of rows. MOOSE wants rows that add up to 1 (to 0.05), and divides them by
// their sums. @see [moose]

void expect_moose(const Scene& scene) {
    expect_few_faces(scene, "moose");
    if (!scene.closed && !scene.empty_box)
        throw UserError(
            fmt::format("--format moose: scene '{}' is open (rows have to add up to 1 there). Close it by a "
                        "face that stands for its surroundings.",
                        scene.name));
    for (const std::string& face : scene.faces) {
        if (face.find_first_of(" '\"#=[]{};$") != std::string::npos)
            throw UserError(
                fmt::format("--format moose: face '{}' (a boundary is a single word there). Rename it.", face));
    }
}

void write_moose(std::ostream& out, const HandedOn& handed) {
    const auto& known = handed.emissivities;
    const bool has_emissivities =
        !known.empty() && std::all_of(known.begin(), known.end(), [](const auto& one) { return one.has_value(); });
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

}  // namespace ff::reports
