#include "reports/json/json.hpp"

#include "reports/json/json_records.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/labels.hpp"

#include <fmt/format.h>

#include <array>

namespace ff::reports {
namespace {

std::string_view name(studies::BiasFinding finding) {
    constexpr std::array<std::string_view, 4> names{"no_bias_found", "biased", "inconclusive", "untestable"};
    return names.at(static_cast<std::size_t>(finding));
}

std::string_view name(studies::EquivalenceFinding finding) {
    constexpr std::array<std::string_view, 4> names{"shown", "refuted", "inconclusive", "not_asked"};
    return names.at(static_cast<std::size_t>(finding));
}

std::string_view name(studies::VarianceStatus status) {
    constexpr std::array<std::string_view, 5> names{"finite", "infinite", "none", "sparse", "undefined"};
    return names.at(static_cast<std::size_t>(status));
}

Json bias_json(const studies::StudyPlan& plan, const studies::CellAnalysis& found) {
    if (!found.bias) return nullptr;
    const studies::BiasFamily& family = *found.bias;
    const std::optional<stats::UnseenValue>& beyond = family.unseen_beyond_margin;
    const Scene& scene = plan.scenes[plan.cells[found.cell].scene];
    return {{"finding", name(found.bias_finding)},
            {"pairs", family.pairs},
            {"untestable", family.untestable},
            {"infinite_variance", family.infinite_variance},
            {"no_exact_value", family.no_exact_value},
            {"too_few_hits", family.too_few_hits},
            {"too_skewed", family.too_skewed},
            {"not_finite", family.not_finite},
            {"constant_and_wrong", family.constant_and_wrong},
            {"largest_t", family.largest_t},
            {"largest_pair", family.largest_t > 0 ? Json(quantity_label(scene, family.largest_pair)) : Json(nullptr)},
            {"adjusted_p", family.adjusted_p},
            {"student_p", family.student_p},
            {"heavy_tails", family.heavy_tails},
            {"may_be_unmet", family.may_be_unmet},
            {"others_explain", family.others_explain},
            {"constant", family.constant},
            {"unseen_value", family.unseen ? Json(family.unseen->value) : Json(nullptr)},
            {"unseen_once_in", family.unseen ? Json(family.unseen->one_in) : Json(nullptr)},
            {"multiplicity", "holm over pairs, sidak over cells"},
            {"alpha", 1.0 - plan.spec.level},
            {"power", plan.spec.power},
            {"few_trials", family.few_trials},
            {"minimum_detectable_bias", optional_json(family.minimum_detectable_bias)},
            {"equivalence",
             {{"finding", name(found.equivalence)},
              {"margin", optional_json(family.margin)},
              {"shown_below", std::isfinite(family.shown_below) ? Json(family.shown_below) : Json(nullptr)},
              {"planned_margin", family.planned_margin},
              {"unseen_value", beyond ? Json(beyond->value) : Json(nullptr)},
              {"unseen_once_in", beyond ? Json(beyond->one_in) : Json(nullptr)}}}};
}

Json nodes_json(const studies::Method& method) {
    if (!method.nodes) return nullptr;
    const auto [source, target] = *method.nodes;
    return target == 0 ? Json::array({source}) : Json::array({source, target});
}

Json table_comparison_json(const studies::PublishedResults& published, const studies::TableComparison& table) {
    Json figures = Json::array();
    for (const studies::FigureComparison& c : table.figures) {
        figures.push_back({{"figure", studies::describe(published.tables, c.figure)},
                           {"printed", published.tables.figures[c.figure].printed},
                           {"ours", optional_json(c.ours)},
                           {"single_run_low", c.single_run ? Json(c.single_run->low) : Json(nullptr)},
                           {"single_run_high", c.single_run ? Json(c.single_run->high) : Json(nullptr)},
                           {"z", optional_json(c.z)},
                           {"percentile", c.rank ? Json(100 * c.rank->percentile) : Json(nullptr)},
                           {"adjusted_p", optional_json(c.adjusted_p)}});
    }
    Json chi_squared = Json::array();
    for (const studies::ColumnChiSquared& column : table.chi_squared) {
        chi_squared.push_back({{"column", column.column},
                               {"statistic", column.form.chi_squared.statistic},
                               {"freedom", column.form.chi_squared.freedom},
                               {"p", column.form.chi_squared.p}});
    }
    const Json together = table.together ? Json{{"statistic", table.together->statistic},
                                                {"freedom", table.together->freedom},
                                                {"p", table.together->p}}
                                         : Json(nullptr);
    return {{"table", table.table},
            {"figures", std::move(figures)},
            {"chi_squared", std::move(chi_squared)},
            {"chi_squared_together", together}};
}

Json published_json(const studies::PublishedResults& published) {
    Json tables = Json::array();
    for (const studies::TableComparison& table : published.comparisons)
        tables.push_back(table_comparison_json(published, table));
    Json claims = Json::array();
    for (const studies::JudgedClaim& claim : published.claims) {
        claims.push_back({{"id", claim.claim.id},
                          {"section", claim.claim.section},
                          {"statement", claim.claim.statement},
                          {"tested_as", claim.claim.tested_as},
                          {"verdict", studies::name(claim.verdict)},
                          {"as_printed_only", claim.as_printed_only},
                          {"evidence", claim.evidence}});
    }
    Json findings = Json::array();
    for (const studies::audit::Finding& finding : published.audit.findings) {
        Json figures = Json::array();
        for (const std::size_t figure : finding.blamed) figures.push_back(studies::describe(published.tables, figure));
        findings.push_back({{"id", finding.id},
                            {"severity", "contradiction"},
                            {"relation", studies::audit::name(finding.relation)},
                            {"statement", finding.statement},
                            {"blamed", std::move(figures)}});
    }
    return {{"source", published.tables.source},
            {"tables", std::move(tables)},
            {"claims", std::move(claims)},
            {"audit", std::move(findings)}};
}

}  // namespace

Json summary_json(const Scene& scene, const studies::Summary& s) {
    return {{"from_face", from_label(scene, s.quantity)},
            {"to_face", to_label(scene, s.quantity)},
            {"pair_class", s.pair_class ? Json(ff::name(*s.pair_class)) : Json(nullptr)},
            {"variance", name(s.variance)},
            {"not_finite", s.not_finite},
            {"reference", optional_json(s.reference)},
            {"mean", optional_json(s.mean)},
            {"bias", optional_json(s.bias)},
            {"bias_se", optional_json(s.bias_se)},
            {"bias_interval", interval_json(s.bias_interval)},
            {"minimum_detectable_bias", optional_json(s.minimum_detectable_bias)},
            {"std", optional_json(s.std)},
            {"std_interval", interval_json(s.std_interval)},
            {"rmse", optional_json(s.rmse)},
            {"median_abs_error", optional_json(s.median_abs_error)},
            {"relative_error_percent", optional_json(s.relative_error_percent)},
            {"skewness", optional_json(s.skewness)},
            {"excess_kurtosis", optional_json(s.excess_kurtosis)},
            {"quantiles",
             {{"min", optional_json(s.min)},
              {"q025", optional_json(s.q025)},
              {"q05", optional_json(s.q05)},
              {"median", optional_json(s.median)},
              {"q95", optional_json(s.q95)},
              {"q975", optional_json(s.q975)},
              {"max", optional_json(s.max)}}},
            {"normality_p", optional_json(s.normality_p)},
            {"vov", optional_json(s.vov)},
            {"tail_index", optional_json(s.tail_index)},
            {"efficiency_samples", optional_json(s.efficiency_samples)}};
}

Json samples_json(const studies::Cell& cell) {
    return cell.samples_per_patch == 0 ? Json(nullptr) : Json(cell.samples_per_patch);
}

Json cell_json(const studies::StudyPlan& plan, const studies::CellAnalysis& found) {
    const studies::Cell& cell = plan.cells[found.cell];
    const studies::Method& method = plan.spec.methods[cell.method];
    const EstimatorInfo& estimator = estimator_info(method);
    return {{"scene", plan.scenes.name(cell.scene)},
            {"method", method.name},
            {"sampler", method.sampler.empty() ? Json(nullptr) : Json(method.sampler)},
            {"estimator", method.estimator},
            {"completion", studies::name(method.completion)},
            {"allocation", estimator.has_allocation() ? Json(studies::name(method.allocation)) : Json(nullptr)},
            {"tracer", estimator.has_tracer ? Json(studies::name(method.tracer)) : Json(nullptr)},
            {"map", estimator.has_map ? Json(studies::name(method.map)) : Json(nullptr)},
            {"nodes", nodes_json(method)},
            {"patches_per_face", cell.subdivision.per_part()},
            {"samples_per_patch", samples_json(cell)},
            {"deterministic", cell.deterministic},
            {"trials", found.trials},
            {"trials_planned", found.trials_planned},
            {"lost_rays", found.lost_rays},
            {"evaluations_per_face", found.evaluations_per_face}};
}

Json in_cell(const studies::StudyPlan& plan, std::size_t cell, const Json& record) {
    const studies::Cell& of = plan.cells[cell];
    Json all{{"study", plan.spec.name},
             {"scene", plan.scenes.name(of.scene)},
             {"method", plan.spec.methods[of.method].name},
             {"patches_per_face", of.subdivision.per_part()},
             {"samples_per_patch", samples_json(of)},
             {"level", plan.spec.level}};
    all.update(record);
    return all;
}

std::string results_json(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    Json json{{"schema", fmt::format("ffstudy.results/{}", results_json_version)},
              {"study", plan.spec.name},
              {"title", plan.spec.title},
              {"complete", results.findings.complete},
              {"seed", plan.spec.seed.value},
              {"level", plan.spec.level},
              {"power", plan.spec.power},
              {"equivalence_margin", optional_json(plan.spec.equivalence_margin)},
              {"warnings", plan.warnings}};
    Json& cells = json["cells"] = Json::array();
    for (const studies::CellAnalysis& found : results.findings.cells) {
        Json& cell = cells.emplace_back(cell_json(plan, found));
        cell["bias_test"] = bias_json(plan, found);
        Json& summaries = cell["summaries"] = Json::array();
        for (const studies::Summary& summary : found.summaries)
            summaries.push_back(summary_json(plan.scenes[plan.cells[found.cell].scene], summary));
    }
    json["slopes"] = slopes_json(results);
    json["heavy_tails"] = heavy_tails_json(results);
    json["variance_reductions"] = reductions_json(results);
    json["contests"] = contests_json(results, Timed::no);
    json["claimed_errors"] = claimed_errors_json(results);
    json["coverage"] = coverage_json(results);
    json["until"] = until_json(results);
    Json& checks = json["variance_checks"] = Json::array();
    for (const studies::VarianceCheck& check : results.variance_checks) {
        checks.push_back({{"cell", cell_label(plan, plan.cells[check.cell])},
                          {"quantities", check.quantities.size()},
                          {"smallest_ratio", check.smallest_ratio},
                          {"largest_ratio", check.largest_ratio},
                          {"adjusted_p", check.adjusted_p}});
    }
    Json& laws = json["error_laws"] = Json::array();
    for (const studies::ErrorLaw& law : results.error_laws) {
        laws.push_back({{"method", law.method},
                        {"published", law.published},
                        {"m", law.m},
                        {"closure_errors", law.closure_errors},
                        {"c", law.first_order.coefficient},
                        {"largest_residual", law.first_order.largest_residual},
                        {"free_exponent", law.free ? Json(law.free->exponent) : Json(nullptr)}});
    }
    json["radiosity"] = radiosity_json(results);
    json["published"] = results.published ? published_json(*results.published) : Json(nullptr);
    return json.dump(2) + "\n";
}

}  // namespace ff::reports
