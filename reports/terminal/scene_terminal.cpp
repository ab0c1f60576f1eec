#include "reports/terminal/scene_terminal.hpp"

#include "core/geometry/scene.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::reports {
namespace {

using studies::form_factors::FaceExchange;

/// The matrix of a scene with more faces is only in the files.
constexpr std::size_t most_faces_of_matrix = 8;
constexpr std::size_t most_listed = 10;

/// The longer half of the interval of a sum.
double half_width(const auto& sum) {
    return std::max(sum.high - sum.value, sum.value - sum.low);
}

struct MethodRow {
    std::size_t pairs = 0;
    double worst = 0;
};

std::string methods(const FormFactorReport& report, const TextStyle& style) {
    std::map<std::pair<std::string_view, std::string_view>, MethodRow> rows;
    for (const FaceExchange& exchange : report.matrix.exchanges) {
        MethodRow& row = rows[{method_of(exchange), reason_of(exchange)}];
        ++row.pairs;
        row.worst = std::max(row.worst, worst_half_width(report.matrix, exchange));
    }
    const std::size_t listed = report.matrix.exchanges.size() + report.matrix.dropped;
    if (const std::size_t unseen = report.matrix.pairs() - listed; unseen > 0) {
        const FaceExchange nothing = studies::form_factors::no_exchange(0, 0);
        rows[{method_of(nothing), reason_of(nothing)}].pairs = unseen;
    }
    Table table{"methods", "", "", columns({"method", ">pairs", ">worst ±", "why"})};
    for (const auto& [key, row] : rows) {
        table.rows.push_back(
            {key.first, std::to_string(row.pairs), key.first == "none" ? "" : brief(row.worst, 2), key.second});
    }
    if (report.matrix.dropped > 0)
        table.rows.push_back({"dropped", std::to_string(report.matrix.dropped), "",
                              fmt::format("both factors are below {}", brief(report.request.drop))});
    return text_table(table, style);
}

/// The row of which most was dropped.
std::string dropped_text(const FormFactorReport& report) {
    if (report.matrix.dropped == 0) return "";
    const auto& rows = report.matrix.rows;
    const auto most = std::max_element(rows.begin(), rows.end(),
                                       [](const auto& a, const auto& b) { return a.dropped.value < b.dropped.value; });
    const studies::form_factors::DroppedExchange& sum = most->dropped;
    return fmt::format("Dropped of a row is at most {} (face {}, {})\n",
                       to_error_with_ends(sum.value, sum.low, sum.high, half_width(sum)),
                       report.scene.faces[static_cast<std::size_t>(most - rows.begin())], counted(sum.pairs, "pair"));
}

std::string factors(const FormFactorReport& report, const TextStyle& style) {
    const Eigen::MatrixXd values = report.matrix.factors();
    const Eigen::MatrixXd widths = report.matrix.half_widths();
    const auto n = static_cast<Eigen::Index>(report.scene.faces.size());
    Table table{"factors", "", "", columns({"F from"})};
    for (const std::string& face : report.scene.faces) table.columns.push_back({"to " + face, true});
    table.columns.push_back({"sum", true});
    table.columns.push_back({"interval of the sum"});
    for (Eigen::Index i = 0; i < n; ++i) {
        const studies::form_factors::RowSum& sum = report.matrix.rows[static_cast<std::size_t>(i)];
        std::vector<TableCell> row{report.scene.faces[static_cast<std::size_t>(i)]};
        for (Eigen::Index j = 0; j < n; ++j) {
            row.push_back(values(i, j) == 0 && widths(i, j) == 0 ? "0" : to_error(values(i, j), widths(i, j)));
        }
        const double width = half_width(sum);
        row.push_back(to_error(sum.value, width));
        row.push_back(fmt::format("[{}, {}]", to_error(sum.low, width), to_error(sum.high, width)));
        table.rows.push_back(std::move(row));
    }
    return text_table(table, style);
}

std::string many_row_sums(const FormFactorReport& report) {
    const auto& rows = report.matrix.rows;
    const auto [least, most] =
        std::minmax_element(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
    const auto words = [&](auto row) {
        return fmt::format("{} (face {})", to_error_with_ends(row->value, row->low, row->high, half_width(*row)),
                           report.scene.faces[static_cast<std::size_t>(row - rows.begin())]);
    };
    return fmt::format("Row sums from {} to {}\n", words(least), words(most));
}

std::string tolerance_of(const studies::form_factors::Request& request) {
    const std::string absolute = brief(request.tolerance);
    return request.relative > 0 ? fmt::format("{} or {} % of the factor", absolute, brief(100 * request.relative))
                                : absolute;
}

std::string repair_text(const FormFactorReport& report) {
    const auto& repaired = report.matrix.repaired;
    if (!repaired) return "";
    if (!repaired->possible) return "\nNo closed reciprocal matrix is near: nothing is repaired.\n";
    return fmt::format("\nRepaired: row sums off 1 by up to {} before, {} after; largest change {} (F {}-{}); {}.\n",
                       brief(repaired->closure_before, 2), brief(repaired->closure_after, 2),
                       brief(repaired->largest_change, 2), report.scene.faces[repaired->from],
                       report.scene.faces[repaired->to],
                       repaired->outside == 1 ? "1 entry leaves its interval"
                                              : fmt::format("{} entries leave their intervals", repaired->outside));
}

}  // namespace

std::string form_factors_verdict(const FormFactorReport& report) {
    const studies::form_factors::Matrix& matrix = report.matrix;
    const std::size_t missed = matrix.missed();
    const std::size_t all = matrix.pairs() - matrix.dropped;
    const std::string tolerance = tolerance_of(report.request);
    const std::string pairs = counted(all, "pair") + " of faces" + (matrix.dropped > 0 ? " that are kept" : "");
    std::string text;
    if (missed > 0) {
        text = fmt::format("{} of {} {} NOT within {}:", missed, pairs, missed == 1 ? "is" : "are", tolerance);
    } else if (!studies::form_factors::is_trusted(report.scene, matrix, report.request.tolerance)) {
        text = fmt::format("NOT to be trusted (see the warnings), though as the scene is read {} {} within {}.", pairs,
                           all == 1 ? "is" : "are", tolerance);
    } else {
        text = all == 1 ? fmt::format("The only factor is within {}.", tolerance)
                        : fmt::format("All {} are within {}.", pairs, tolerance);
    }
    if (missed > 0) {
        std::size_t listed = 0;
        for (const FaceExchange& pair : matrix.exchanges) {
            if (pair.within || listed == most_listed) continue;
            text += fmt::format("{} {}-{} (±{})", listed++ == 0 ? "" : ",", report.scene.faces[pair.from],
                                report.scene.faces[pair.to], brief(worst_half_width(matrix, pair), 2));
        }
        text += missed > most_listed ? " and others." : ".";
    }
    if (matrix.samples > 0) text += fmt::format(" {} samples.", thousands_apart(matrix.samples));
    return text;
}

std::string form_factors_text(const FormFactorReport& report, const TextStyle& style) {
    const auto& [scene, request, matrix] = report;
    const std::string joined =
        matrix.surfaces < scene.surfaces.size() ? fmt::format(", joined to {}", matrix.surfaces) : "";
    std::string text = fmt::format(
        "{}: {} of {}{}\ntolerance {}, level {} {}, seed {}\n\n", scene.name, counted(scene.faces.size(), "face"),
        counted(scene.surfaces.size(), "surface"), joined, tolerance_of(request), brief(request.level, 10),
        request.level_of == studies::form_factors::LevelOf::entry ? "of each entry" : "of the whole matrix",
        request.seed.value);
    text += methods(report, style) + "\n";
    text += scene.faces.size() <= most_faces_of_matrix ? factors(report, style) : many_row_sums(report);
    text += dropped_text(report) + "\n" + form_factors_verdict(report) + "\n";
    if (matrix.interrupted) text += "Stopped before the sampling was done; pairs by `bounds` have none.\n";
    return text + repair_text(report);
}

}  // namespace ff::reports
