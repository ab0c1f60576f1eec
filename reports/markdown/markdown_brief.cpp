#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/in_brief.hpp"
#include "reports/words/published_summary.hpp"
#include "reports/words/radiosity_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace ff::reports {
namespace {

using studies::CellFindings;

/// What a cell is ranked by on a class of pairs: its RMSE, for a sampled method at one evaluation a face.
std::optional<double> rank(const studies::Findings& findings, const CellFindings& found, PairClass pair_class) {
    const auto rmse = found.class_rmse(pair_class);
    if (!rmse || findings.plan.cells[found.cell].deterministic) return rmse;
    return *rmse * std::sqrt(static_cast<double>(found.evaluations_per_face));
}

/// The most accurate deterministic method, or the most efficient sampled one, on a class of pairs; formulas left out.
const CellFindings* best(const studies::Findings& findings, std::size_t scene, PairClass pair_class,
                         bool deterministic) {
    const CellFindings* best = nullptr;
    for (const CellFindings& found : findings.cells) {
        const studies::Cell& cell = findings.plan.cells[found.cell];
        const auto value = rank(findings, found, pair_class);
        if (!value || cell.scene != scene || cell.deterministic != deterministic) continue;
        if (estimator_info(findings.plan.spec.methods[cell.method]).exact) continue;
        if (best == nullptr || *value < *rank(findings, *best, pair_class)) best = &found;
    }
    return best;
}

/// Names of the deterministic or the sampled methods whose error is rounding at some size.
std::string exact_methods(const studies::Findings& findings, std::size_t scene, PairClass pair_class,
                          bool deterministic) {
    std::vector<std::string> names;
    for (const CellFindings& found : findings.cells) {
        const studies::Cell& cell = findings.plan.cells[found.cell];
        const studies::Method& method = findings.plan.spec.methods[cell.method];
        const auto rmse = found.class_rmse(pair_class);
        const bool counts = cell.deterministic == deterministic && !estimator_info(method).exact;
        if (cell.scene != scene || !counts || !rmse || *rmse >= studies::rounding_error) continue;
        if (std::find(names.begin(), names.end(), method.name) == names.end()) names.push_back(method.name);
    }
    return fmt::format("{}", fmt::join(names, ", "));
}

std::string accuracy_line(const studies::Findings& findings, std::size_t scene, PairClass pair_class) {
    std::vector<std::string> parts;
    for (const bool deterministic : {true, false}) {
        const CellFindings* found = best(findings, scene, pair_class, deterministic);
        if (found == nullptr) continue;
        const double rmse = *found->class_rmse(pair_class);
        const std::string label = markdown_text(cell_label(findings.plan, findings.plan.cells[found->cell]));
        if (rmse < studies::rounding_error) {
            parts.push_back(fmt::format("{} methods are exact to rounding (**{}**)",
                                        deterministic ? "deterministic" : "sampled",
                                        markdown_text(exact_methods(findings, scene, pair_class, deterministic))));
        } else {
            parts.push_back(fmt::format(
                "{} **{}** (RMSE {})",
                deterministic ? "the best deterministic method is" : "sample for sample the best sampled method is",
                label, brief(rmse, 2)));
        }
    }
    if (parts.empty()) return {};
    const std::string where =
        findings.plan.scenes.size() == 1 ? "" : markdown_text(findings.plan.scenes[scene].name) + ": ";
    return fmt::format("- {}On {} pairs {}.\n", where, name(pair_class), fmt::join(parts, "; "));
}

std::string bias_line(const studies::Findings& findings) {
    std::size_t sampled = 0;
    std::size_t clean = 0;
    std::size_t shown = 0;
    std::uint64_t lost = 0;
    for (const CellFindings& found : findings.cells) {
        lost += found.lost_rays;
        if (!found.bias) continue;
        ++sampled;
        if (found.bias_finding == studies::BiasFinding::no_bias_found) ++clean;
        if (found.equivalence == studies::EquivalenceFinding::shown) ++shown;
    }
    if (sampled == 0) return {};
    std::string out = fmt::format("- Bias: none found in {} of {} sampled methods and sizes ({:g} % over all of them)",
                                  clean, sampled, 100 * (1 - findings.plan.spec.level));
    if (const auto margin = findings.plan.spec.equivalence_margin) {
        out += fmt::format("; a bias within ±{} is shown on every pair of {}", brief(*margin, 2), shown);
    }
    return out + fmt::format(". Lost rays: {}.\n", lost);
}

}  // namespace

std::string brief_section(const studies::StudyResults& results) {
    const Answer said = answer(results);
    std::string out = said.question.empty() ? std::string() : fmt::format("*{}*\n\n", markdown_text(said.question));
    out += fmt::format("**{}**\n\n", markdown_text(said.text));
    if (const auto lead = lead_picture(results); lead && lead->kind == "ranking")
        out += fmt::format("![{}](answer.svg)\n\n{}\n\n", markdown_text(lead->title), markdown_text(lead->finding));
    out += "## In brief\n\n";
    for (std::size_t scene = 0; scene < results.findings.plan.scenes.size(); ++scene) {
        for (const PairClass pair_class : {PairClass::parallel, PairClass::adjacent}) {
            out += accuracy_line(results.findings, scene, pair_class);
        }
    }
    out += bias_line(results.findings);
    if (const auto light = light_in_brief(results)) {
        std::string clause = markdown_text(light->clause);
        clause.front() = 'A';
        out += fmt::format("- {}; see [what the errors do to the light](#what-the-errors-do-to-the-light).\n", clause);
    }
    for (const std::string& line : results_in_brief(results)) out += fmt::format("- {}\n", markdown_text(line));
    if (results.published) {
        for (const std::string& line : published_in_brief(*results.published, 1 - results.findings.plan.spec.level))
            out += fmt::format("- {}\n", markdown_text(line));
        if (results.published->audit.figures > 0)
            out += fmt::format("- The {} printed figures contain {} contradictions; see [the audit](#the-audit).\n",
                               results.published->audit.figures, results.published->audit.contradictions());
    }
    return out + "\n";
}

}  // namespace ff::reports
