#include "reports/programs/writers.hpp"

#include <fmt/format.h>

namespace ff::reports {

// A line that View3D begins its text files with (its name, a version, out encl emit N), areas, rows, emissivities.
// @see [view3d]

void expect_view3d(const Scene& scene) {
    expect_few_faces(scene, "view3d");
}

void write_view3d(std::ostream& out, const HandedOn& handed) {
    constexpr double black = 1;
    const auto n = handed.factors.rows();
    const std::string header =
        fmt::format("View3D by-ffstudy 0 {} 0 {}", handed.scene.closed || handed.scene.empty_box ? 1 : 0, n);
    constexpr int width = 30;  // that its reader expects at least
    out << fmt::format("{:<{}}\n{}\n", header, width, fmt::join(handed.matrix.areas, " "));
    for (Eigen::Index row = 0; row < n; ++row) out << fmt::format("{}\n", fmt::join(whole_row(handed, row), " "));
    std::vector<double> emissivities(handed.matrix.faces(), black);
    for (std::size_t face = 0; face < handed.emissivities.size(); ++face)
        emissivities[face] = handed.emissivities[face].value_or(black);
    out << fmt::format("{}\n", fmt::join(emissivities, " "));
}

}  // namespace ff::reports
