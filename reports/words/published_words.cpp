#include "reports/words/published_words.hpp"

#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/findings/printed_errors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace ff::reports {

using studies::PublishedTables;
using studies::audit::Finding;
using studies::audit::Report;

std::string audit_verdict(const Report& report) {
    const std::size_t n = report.contradictions();
    if (report.figures == 0) return "No figure is printed.";
    if (n == 0) return fmt::format("The {} printed figures contain no contradiction.", report.figures);
    return fmt::format("The {} printed figures contain {} contradiction{}.", report.figures, n, n == 1 ? "" : "s");
}

std::string audit_summary(const PublishedTables& tables, const Report& report) {
    std::string text = audit_verdict(report) + "\n";
    std::size_t number = 0;
    for (const Finding& f : report.findings) {
        const std::string line =
            f.blamed.empty() ? std::string{} : fmt::format(" (line {})", tables.figures[f.blamed.front()].line);
        text += fmt::format("{:3}. {}{}\n", ++number, f.statement, line);
    }
    return text;
}

using studies::FigureComparison;

namespace {

std::string percentile_text(const stats::Rank& rank) {
    const double percentile = 100 * rank.percentile;
    const double step = 100.0 / static_cast<double>(rank.n);
    if (percentile < step) return fmt::format("below {:.2g} %", step);
    if (percentile > 100 - step) return fmt::format("above {:.4g} %", 100 - step);
    return fmt::format("{:.3g} %", percentile);
}

std::string surprising_figures(const studies::PublishedResults& published, double alpha) {
    std::size_t sampled = 0;
    std::vector<std::string> surprising;
    for (const studies::TableComparison& table : published.comparisons) {
        for (const studies::FigureComparison& c : table.figures) {
            if (!c.adjusted_p) continue;
            ++sampled;
            if (*c.adjusted_p >= alpha) continue;
            const std::string place = c.z ? fmt::format("z = {:+.1f}", *c.z) : std::string("no run gives it");
            surprising.push_back(fmt::format("{} = {} ({})", studies::describe(published.tables, c.figure),
                                             published.tables.figures[c.figure].printed, place));
        }
    }
    std::string text = fmt::format(
        "Of {} printed figures of sampled methods, {} {} outside what a run as described gives ({:g} % a table, Holm)",
        sampled, surprising.size(), surprising.size() == 1 ? "lies" : "lie", 100 * alpha);
    return surprising.empty() ? text : fmt::format("{}: {}", text, fmt::join(surprising, "; "));
}

/// The verdict on each claim, for a publication that has claims in words only.
std::vector<std::string> claims_in_brief(const studies::PublishedResults& published) {
    std::vector<std::string> lines;
    for (const studies::JudgedClaim& judged : published.claims)
        lines.push_back(fmt::format("{}: “{}”{} {}", studies::name(judged.verdict), judged.claim.statement,
                                    tested_as(judged.claim), judged.evidence));
    return lines;
}

/// "536 million kernel values", in a run
std::string cost(const studies::Analysis& findings, std::size_t index) {
    const studies::Cell& cell = findings.plan.cells[findings.cells[index].cell];
    const studies::Method& method = findings.plan.spec.methods[cell.method];
    const auto evaluations = static_cast<double>(studies::evaluations_per_trial(findings.plan, cell));
    return fmt::format("{:.3g} million {}", evaluations / 1e6, estimator_info(method).evaluations);
}

std::string in_words(const studies::StudyResults& results, const PrintedErrors& errors,
                     const std::vector<std::size_t>& cells) {
    const studies::Analysis& findings = results.findings;
    const studies::StudyPlan& plan = findings.plan;
    const auto method = [&](std::size_t cell) { return plan.spec.methods[plan.cells[cell].method].name; };
    const std::string where = on_pairs(plan, plan.cells[errors.cell].scene, name(errors.pair_class));
    std::string text = fmt::format(
        "{} as described does not give the figures printed for it: {} its mean error is {:.3g} % here and {:.3g} % in "
        "print.",
        method(errors.cell), where, 100 * errors.ours, 100 * errors.printed);
    const studies::ClassError& own = *findings.cells[errors.cell].class_error(errors.pair_class);
    for (const std::size_t cell : cells) {
        const studies::ClassError* other = findings.cells[cell].class_error(errors.pair_class);
        if (cell == errors.cell || other == nullptr || !other->interval) continue;
        const auto is_answer = [&](const studies::Rivalry& rivalry) {
            return rivalry.better == cell && rivalry.worse == errors.cell && rivalry.pair_class == errors.pair_class;
        };
        const auto answer = std::find_if(results.rivals.begin(), results.rivals.end(), is_answer);
        const auto ratio = answer != results.rivals.end() && answer->interval
                               ? answer->interval
                               : studies::ratio_interval(*log_rmse(*other), *log_rmse(own, true), plan.spec.level);
        text += fmt::format(
            " The RMSE of {} ({}) is {} to {} times that of {} ({}) by these figures, and {} times by the "
            "printed ones.",
            method(errors.cell), cost(findings, errors.cell), brief(ratio->low), brief(ratio->high), method(cell),
            cost(findings, cell), brief(errors.printed_rms / other->rmse, 2));
    }
    return text;
}

/// The cell of a method that a claim is about; null where it names none of the study's sizes, or several.
const studies::CellAnalysis* cell_of(const studies::Analysis& findings, const studies::PublishedClaim& claim,
                                     const std::string& method) {
    const studies::CellAnalysis* only = nullptr;
    const auto is_meant = [](const auto& wanted, auto value) {
        return wanted.empty() || std::ranges::find(wanted, value) != wanted.end();
    };
    for (const studies::CellAnalysis& found : findings.cells) {
        const studies::Cell& cell = findings.plan.cells[found.cell];
        if (findings.plan.spec.methods[cell.method].name != method ||
            !is_meant(claim.patches_per_face, cell.subdivision.per_part()) ||
            !is_meant(claim.samples_per_patch, cell.samples_per_patch))
            continue;
        if (only != nullptr) return nullptr;
        only = &found;
    }
    return only;
}

/// "a errs 1.3 to 1.4 times less than b": the hull of the intervals of all classes of pairs, which hold together; empty
/// where there is none.
std::string error_ratio(const studies::Analysis& findings, const studies::PublishedClaim& claim) {
    const studies::CellAnalysis* const better = cell_of(findings, claim, claim.methods[0]);
    const studies::CellAnalysis* const worse = cell_of(findings, claim, claim.methods[1]);
    if (better == nullptr || worse == nullptr) return {};
    const double level = studies::level_of_each(findings.plan.spec.level, better->class_errors.size());
    double low = std::numeric_limits<double>::infinity();
    double high = 0;
    for (const studies::ClassError& error : better->class_errors) {
        const studies::ClassError* const other = worse->class_error(error.pair_class);
        if (other == nullptr || !error.mean_square || !other->mean_square) return {};
        const auto interval = studies::ratio_interval(*studies::log_rmse(error), *studies::log_rmse(*other), level);
        if (!interval || !interval->is_finite()) return {};
        low = std::min(low, interval->low);
        high = std::max(high, interval->high);
    }
    return low > 1 ? fmt::format("{} errs {} to {} times less than {}", listed({claim.methods[0]}), brief(low),
                                 brief(high), listed({claim.methods[1]}))
                   : std::string();
}

}  // namespace

std::string tested_as(const studies::PublishedClaim& claim) {
    return claim.tested_as.empty() ? std::string() : fmt::format(" (tested: {})", claim.tested_as);
}

std::string ours_text(const FigureComparison& c, const std::string& printed) {
    if (!c.ours) return "–";
    const double unit = studies::half_printed_unit(printed);
    if (c.deterministic || !c.single_run) return to_error(*c.ours, 20 * unit);
    const double spread = c.single_run->high - c.single_run->low;
    if (spread == 0) return fmt::format("{:g} always", *c.ours);
    return fmt::format("{} [{}, {}]", to_error(*c.ours, spread / 20), to_error(c.single_run->low, spread / 5),
                       to_error(c.single_run->high, spread / 5));
}

std::string place_text(const FigureComparison& c, const std::string& printed) {
    if (!c.ours) return "–";
    if (c.deterministic) {
        const double difference = c.printed - *c.ours;
        return std::abs(difference) <= 2 * studies::half_printed_unit(printed)
                   ? "equal"
                   : fmt::format("off by {:+.3g}", difference);
    }
    if (c.single_run->low == c.single_run->high) return *c.adjusted_p > 0 ? "equal" : "impossible";
    return c.z ? fmt::format("z {:+.2f}, {}", *c.z, percentile_text(*c.rank)) : percentile_text(*c.rank);
}

bool is_surprising(const FigureComparison& c, double alpha) {
    return c.ours && c.adjusted_p && *c.adjusted_p < alpha;
}

std::set<std::size_t> blamed_figures(const studies::audit::Report& audit) {
    std::set<std::size_t> blamed;
    for (const studies::audit::Finding& finding : audit.findings) {
        blamed.insert(finding.blamed.begin(), finding.blamed.end());
    }
    return blamed;
}

std::string claims_with_ratio(const studies::StudyResults& results) {
    std::string sentence = claims_sentence(*results.published);
    const auto& claims = results.published->claims;
    const auto first = std::ranges::find_if(claims, [](const studies::JudgedClaim& judged) {
        return judged.claim.kind == "smaller_error" && judged.verdict == studies::ClaimVerdict::supported &&
               judged.claim.methods.size() == 2;
    });
    if (first == claims.end()) return sentence;
    const std::string ratio = error_ratio(results.findings, first->claim);
    if (ratio.empty()) return sentence;
    sentence.pop_back();
    return fmt::format("{}: {}.", sentence, ratio);
}

std::string claims_sentence(const studies::PublishedResults& published) {
    const auto count = [&](studies::ClaimVerdict verdict) {
        return std::count_if(published.claims.begin(), published.claims.end(),
                             [&](const auto& claim) { return claim.verdict == verdict; });
    };
    if (published.claims.size() == 1)
        return fmt::format("The publication's claim is {}.", studies::name(published.claims.front().verdict));
    const auto all = static_cast<std::ptrdiff_t>(published.claims.size());
    std::vector<std::string> parts;
    for (const auto& [verdict, words] : {std::pair{studies::ClaimVerdict::supported, "supported"},
                                         std::pair{studies::ClaimVerdict::as_printed_only,
                                                   "only by printed figures that the methods as described do not give"},
                                         std::pair{studies::ClaimVerdict::refuted, "refuted"},
                                         std::pair{studies::ClaimVerdict::inconclusive, "inconclusive"}}) {
        const auto number = count(verdict);
        if (number == all) return fmt::format("The publication's {} claims are {}.", all, words);
        if (number > 0 && parts.empty()) {
            parts.push_back(fmt::format("{} {} {}", number, number == 1 ? "is" : "are", words));
        } else if (number > 0) {
            parts.push_back(fmt::format("{} {}", number, words));
        }
    }
    return fmt::format("Of the publication's {} claims {}.", all, fmt::join(parts, ", "));
}

std::vector<std::string> published_in_brief(const studies::PublishedResults& published, double alpha) {
    if (published.tables.figures.empty()) return claims_in_brief(published);
    std::vector<std::string> lines{surprising_figures(published, alpha)};
    if (!published.claims.empty()) lines.push_back(claims_sentence(published));
    return lines;
}

std::string premise(const studies::StudyResults& results) {
    const studies::StudyPlan& plan = results.findings.plan;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const auto cells = studies::compared_cells(results.findings, scene, results.published->comparisons);
        PrintedErrors worst;  // where print and computation differ most
        for (const std::size_t cell : cells) {
            if (!plan.cells[cell].deterministic) continue;
            for (const PairClass pair_class : pair_classes) {
                const PrintedErrors errors = printed_errors(results, cell, pair_class);
                if (errors.differs && std::abs(errors.printed - errors.ours) > std::abs(worst.printed - worst.ours))
                    worst = errors;
            }
        }
        if (worst.differs) return in_words(results, worst, cells);
    }
    return {};
}

}  // namespace ff::reports
