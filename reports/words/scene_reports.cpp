#include "reports/words/scene_reports.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace ff::reports {

using studies::form_factors::FaceExchange;

namespace {

bool is_sampled(const FormFactorReport& report, std::size_t face) {
    const auto& exchanges = report.matrix.exchanges;
    return std::any_of(exchanges.begin(), exchanges.end(), [&](const FaceExchange& exchange) {
        return (exchange.from == face || exchange.to == face) && exchange.is_sampled();
    });
}

/// Rows of a closed scene that cannot add up to 1, with what may be the cause.
std::string row_warning(const FormFactorReport& report, const std::vector<std::size_t>& rows) {
    std::string cause = "a hole, or surfaces that cross each other or face the wrong way";
    if (!report.matrix.faults.empty()) {
        cause = "for the reason given above";
    } else if (report.matrix.lost_rays == 0 &&
               std::any_of(rows.begin(), rows.end(), [&](std::size_t row) { return is_sampled(report, row); })) {
        cause =
            "no ray was lost: corners may be rounded so that surfaces do not meet; a body that stands on the face may "
            "cover part of it, which then belongs to no face; surfaces may cross each other; or the samples missed "
            "something small, and another --seed may tell";
    }
    const auto value = [&](std::size_t row) { return report.matrix.rows[row].value; };
    const auto [least, most] =
        std::minmax_element(rows.begin(), rows.end(), [&](auto a, auto b) { return value(a) < value(b); });
    const auto& faces = report.scene.faces;
    const std::string sums =
        rows.size() == 1 ? fmt::format("the row of face '{}' adds up to {}", faces[*least], brief(value(*least), 8))
                         : fmt::format("the rows of {} faces add up to {} (face '{}') to {} (face '{}')", rows.size(),
                                       brief(value(*least), 8), faces[*least], brief(value(*most), 8), faces[*most]);
    return fmt::format("scene '{}' is said to be closed, but {} ({})", report.scene.name, sums, cause);
}

/// The row of a closed scene that seems to miss 1 by more than the tolerance, where none is shown to.
std::optional<std::size_t> row_in_doubt(const FormFactorReport& report) {
    const studies::form_factors::Matrix& matrix = report.matrix;
    if (matrix.leak > 0 || matrix.left_out > 0 || !studies::form_factors::rows_add_up(report.scene)) return {};
    const auto miss = [](const studies::form_factors::RowSum& row) {
        return row.excludes_one ? 0 : std::max(1 - row.high, row.low - 1);
    };
    const auto most = std::ranges::max_element(matrix.rows, {}, miss);
    if (most == matrix.rows.end() || miss(*most) <= report.request.tolerance) return {};
    return static_cast<std::size_t>(most - matrix.rows.begin());
}

}  // namespace

std::vector<std::string> form_factor_warnings(const FormFactorReport& report) {
    const studies::form_factors::Matrix& matrix = report.matrix;
    std::vector<std::string> warnings = matrix.faults;
    const bool closed = report.scene.closed;
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; closed && i < matrix.rows.size(); ++i) {
        if (matrix.rows[i].excludes_one) rows.push_back(i);
    }
    if (!rows.empty()) warnings.push_back(row_warning(report, rows));
    if (matrix.leak > 0)
        warnings.push_back(fmt::format(
            "scene '{}' is said to be closed, but rows differ from 1 by up to {} (gaps or overlaps, as rounded corners "
            "leave them); intervals of entries allow for what their rows miss",
            report.scene.name, brief(matrix.leak, 2)));
    if (const auto row = row_in_doubt(report); row && rows.empty())
        warnings.push_back(fmt::format(
            "scene '{}' is said to be closed, but the row of face '{}' may not add up to 1: {} [{}, {}] (a gap or an "
            "overlap, or chance). A smaller --tolerance tells.",
            report.scene.name, report.scene.faces[*row], brief(matrix.rows[*row].value, 6),
            brief(matrix.rows[*row].low, 6), brief(matrix.rows[*row].high, 6)));
    if (closed && matrix.lost_rays > 0) {
        warnings.push_back(fmt::format("scene '{}' is said to be closed, but {} of {} met nothing", report.scene.name,
                                       matrix.lost_rays, counted(matrix.rays, "ray")));
    }
    for (const FaceExchange& pair : matrix.exchanges) {
        if (!pair.contradicted) continue;
        warnings.push_back(
            fmt::format("F {}-{}: an independent randomisation contradicts the estimate; the interval "
                        "holds both",
                        report.scene.faces[pair.from], report.scene.faces[pair.to]));
    }
    return warnings;
}

}  // namespace ff::reports
