#include "studies/claims/comparison.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "stats/basics/distributions.hpp"
#include "stats/basics/moments.hpp"
#include "stats/error_rates/multiplicity.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>

namespace ff::studies {
namespace {

/// Number from 1 of the face with this label; 0 for an empty label.
int face_number(const Scene& scene, const std::string& label) {
    if (label.empty()) return 0;
    const auto found = std::ranges::find(scene.faces, label);
    if (found == scene.faces.end()) {
        throw UserError("published tables: face '{}' (scene '{}' has no such face). Use its face labels.", label,
                        scene.name);
    }
    return static_cast<int>(found - scene.faces.begin()) + 1;
}

Quantity quantity_of(const Scene& scene, const Figure& figure) {
    switch (figure.kind) {
        case FigureKind::row_sum:
            return {QuantityKind::row_sum, face_number(scene, figure.from), 0};
        case FigureKind::sum_relative_error:
            return {QuantityKind::sum_relative_error, 0, 0};
        case FigureKind::form_factor:
        case FigureKind::relative_error:
            break;
    }
    return {QuantityKind::form_factor, face_number(scene, figure.from), face_number(scene, figure.to)};
}

/// Values of the printed quantity in every trial: the estimates, or their relative errors in percent.
std::vector<double> printed_values(const CellEstimates& estimates, const Figure& figure, Quantity quantity,
                                   std::optional<double> reference) {
    std::vector<double> values = estimates.values(quantity);
    if (figure.kind != FigureKind::relative_error) return values;
    if (!reference) return {};
    for (double& value : values) value = 100.0 * std::abs(value - *reference) / *reference;
    return values;
}

void compare(const CellEstimates& estimates, const CellAnalysis& findings, const Figure& figure, double level,
             FigureComparison& comparison) {
    const Summary& summary = findings.summary(comparison.quantity);
    const auto values = printed_values(estimates, figure, comparison.quantity, summary.reference);
    if (values.empty()) return;
    const auto moments = stats::moments_of(values, values.front());
    comparison.ours = moments.mean();
    if (comparison.deterministic) return;
    comparison.single_run = stats::central_range(values, level);
    comparison.rank = stats::rank_among(values, comparison.printed, level, half_printed_unit(figure.printed));
    const auto sigma = moments.standard_deviation();
    // Under infinite variance the sample's deviation measures nothing; ranks still hold.
    const bool finite = summary.variance != VarianceStatus::infinite;
    if (is_value(figure) && finite && sigma && *sigma > 0)
        comparison.z = (comparison.printed - *comparison.ours) / *sigma;
}

/// The p-value of one figure: for estimates, which are sums of many hits, Student's of one more observation beside the
/// `trials` that mean and deviation come from; by rank for errors.
double p_value(const FigureComparison& comparison, const std::string& printed) {
    if (comparison.z) {
        const auto trials = static_cast<double>(comparison.rank->n);
        return stats::student_two_sided_p(*comparison.z / std::sqrt(1.0 + 1.0 / trials), trials - 1.0);
    }
    const bool constant = comparison.single_run->low == comparison.single_run->high;
    if (!constant) return comparison.rank->p;
    return std::abs(comparison.printed - *comparison.ours) <= half_printed_unit(printed) ? 1.0 : 0.0;
}

void adjust_for_multiplicity(const PublishedTables& tables, TableComparison& table) {
    std::vector<double> p;
    std::vector<FigureComparison*> tested;
    for (FigureComparison& comparison : table.figures) {
        if (!comparison.rank) continue;
        p.push_back(p_value(comparison, tables.figures[comparison.figure].printed));
        tested.push_back(&comparison);
    }
    if (p.empty()) return;
    const auto adjusted = stats::holm(p);
    for (std::size_t i = 0; i < tested.size(); ++i) tested[i]->adjusted_p = adjusted[i];
}

Eigen::MatrixXd covariance(const std::vector<const std::vector<double>*>& samples) {
    const auto k = static_cast<Eigen::Index>(samples.size());
    const auto n = static_cast<Eigen::Index>(samples.front()->size());
    Eigen::MatrixXd data(n, k);
    for (Eigen::Index j = 0; j < k; ++j) {
        data.col(j) = Eigen::Map<const Eigen::VectorXd>(samples[static_cast<std::size_t>(j)]->data(), n);
    }
    const Eigen::RowVectorXd first = data.row(0);
    data.rowwise() -= first;  // keeps a tiny spread beside a large mean
    const Eigen::RowVectorXd mean = data.colwise().mean();
    data.rowwise() -= mean;
    return data.transpose() * data / static_cast<double>(n - 1);
}

/// Hotelling's T^2 of one more run beside the `trials` that mean and covariance come from, as a p-value.
double hotelling_p(const stats::ChiSquared& form, std::size_t trials) {
    const auto n = static_cast<double>(trials);
    const auto k = static_cast<double>(form.freedom);
    return stats::fisher_tail(form.statistic / (1.0 + 1.0 / n) * (n - k) / (k * (n - 1.0)), k, n - k);
}

/// Fisher's combination of the columns, which are independent runs.
stats::ChiSquared combine(const std::vector<ColumnChiSquared>& columns) {
    stats::ChiSquared combined;
    for (const ColumnChiSquared& column : columns) {
        combined.statistic -= 2.0 * std::log(std::max(column.form.chi_squared.p, std::numeric_limits<double>::min()));
        combined.freedom += 2;
    }
    combined.p = stats::chi_squared_tail(combined.statistic, static_cast<double>(combined.freedom));
    return combined;
}

void add_chi_squared(const PublishedTables& tables, const Analysis& findings,
                     const std::map<std::size_t, std::shared_ptr<const CellEstimates>>& estimates,
                     TableComparison& table) {
    std::map<std::size_t, std::vector<const FigureComparison*>> columns;
    for (const FigureComparison& comparison : table.figures) {
        const Figure& figure = tables.figures[comparison.figure];
        if (is_value(figure) && comparison.rank) columns[figure.column].push_back(&comparison);
    }
    for (const auto& [column, figures] : columns) {
        std::vector<double> deviations;
        std::vector<const std::vector<double>*> samples;
        for (const FigureComparison* figure : figures) {
            deviations.push_back(figure->printed - *figure->ours);
            samples.push_back(&estimates.at(*figure->cell)->values(figure->quantity));
        }
        if (samples.front()->size() < 2 * samples.size()) continue;  // too few trials for a covariance
        if (std::ranges::any_of(figures, [&](const FigureComparison* figure) {
                return findings.cells[*figure->cell].summary(figure->quantity).variance == VarianceStatus::infinite;
            }))
            continue;
        if (auto form = stats::combine_deviations(deviations, covariance(samples))) {
            form->chi_squared.p = hotelling_p(form->chi_squared, samples.front()->size());
            table.chi_squared.push_back({column, figures.size(), *form});
        }
    }
    if (table.chi_squared.size() > 1) table.together = combine(table.chi_squared);
}

}  // namespace

double half_printed_unit(const std::string& printed) {
    const auto point = printed.find('.');
    const auto decimals = point == std::string::npos ? 0 : printed.size() - point - 1;
    return 0.5 * std::pow(10.0, -static_cast<double>(decimals));
}

std::optional<std::size_t> find_scene(const StudyPlan& plan, const PublishedTables& tables) {
    const std::string canonical = make_scene(tables.scene).canonical;
    const auto found = std::ranges::find(plan.scenes, canonical, &Scene::canonical);
    return found == plan.scenes.end() ? std::nullopt
                                      : std::optional(static_cast<std::size_t>(found - plan.scenes.begin()));
}

std::optional<std::size_t> find_cell(const StudyPlan& plan, std::size_t scene, std::string_view method,
                                     std::uint32_t patches_per_face, std::optional<std::uint64_t> samples_per_patch) {
    for (std::size_t i = 0; i < plan.cells.size(); ++i) {
        const Cell& cell = plan.cells[i];
        if (cell.scene != scene) continue;
        if (plan.spec.methods[cell.method].name != method || cell.subdivision.per_part() != patches_per_face) continue;
        if (!samples_per_patch || cell.samples_per_patch == *samples_per_patch) return i;
    }
    return std::nullopt;
}

std::vector<TableComparison> compare_with_published(const CellReader& cells, const Analysis& findings,
                                                    const PublishedTables& tables) {
    std::map<std::size_t, std::shared_ptr<const CellEstimates>> estimates;
    const auto scene = find_scene(findings.plan, tables);
    std::vector<TableComparison> comparisons;
    for (const PublishedTable& published : tables.tables) {
        TableComparison table;
        table.table = published.id;
        for (const auto& index : published.figures) {
            if (!index) continue;
            const Figure& figure = tables.figures[*index];
            FigureComparison comparison;
            comparison.figure = *index;
            comparison.printed = std::strtod(figure.printed.c_str(), nullptr);
            if (scene)
                comparison.cell =
                    find_cell(findings.plan, *scene, figure.method, figure.patches_per_face, figure.samples_per_patch);
            if (comparison.cell && findings.cells[*comparison.cell].trials > 0) {
                const Cell& cell = findings.plan.cells[*comparison.cell];
                comparison.deterministic = cell.deterministic;
                comparison.quantity = quantity_of(findings.plan.scenes[cell.scene], figure);
                const auto& loaded = estimates[*comparison.cell] = cells.load(*comparison.cell);
                compare(*loaded, findings.cells[*comparison.cell], figure, findings.plan.spec.level, comparison);
            }
            table.figures.push_back(comparison);
        }
        adjust_for_multiplicity(tables, table);
        add_chi_squared(tables, findings, estimates, table);
        comparisons.push_back(std::move(table));
    }
    return comparisons;
}

}  // namespace ff::studies
