#include "reports/markdown/audit_markdown.hpp"

#include "reports/markdown/markdown_text.hpp"
#include "reports/words/published_words.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

namespace ff::reports {
namespace {

using studies::PublishedTables;
using studies::audit::Finding;
using studies::audit::HitRange;
using studies::audit::Report;

using Out = std::back_insert_iterator<std::string>;

std::string hits_in_words(const std::optional<HitRange>& hits) {
    if (!hits) return "none";
    return hits->count() == 1 ? fmt::format("{}", hits->low) : fmt::format("{} to {}", hits->low, hits->high);
}

/// "table6, 1 - 2, PDM r.e. (%) and 11 more"
std::string blame_in_words(const PublishedTables& tables, const Finding& finding) {
    using studies::audit::Relation;
    if (finding.blamed.empty()) {
        const bool of_method = finding.relation == Relation::closure || finding.relation == Relation::reciprocity;
        return of_method ? "the method" : "the text";
    }
    std::string text = describe(tables, finding.blamed.front());
    if (finding.blamed.size() > 1) text += fmt::format(" and {} more", finding.blamed.size() - 1);
    return text;
}

template <typename Value>
std::string list_corrections(const Finding& finding, Value value) {
    std::vector<std::string> parts;
    for (const studies::audit::Correction& correction : finding.corrections) parts.push_back(value(correction));
    return fmt::format("{}", fmt::join(parts, ", "));
}

void write_overview(Out out, const PublishedTables& tables, const Report& report) {
    if (report.findings.empty()) return;
    fmt::format_to(out,
                   "| # | relation | blamed | printed | should be | off by, in last digits |\n"
                   "|--:|---|---|---|---|--:|\n");
    std::size_t number = 0;
    for (const Finding& f : report.findings) {
        fmt::format_to(
            out, "| {} | {} | {} | {} | {} | {} |\n", ++number, name(f.relation),
            markdown_cell(blame_in_words(tables, f)),
            list_corrections(f, [](const studies::audit::Correction& c) { return c.printed; }),
            list_corrections(f,
                             [](const studies::audit::Correction& c) {
                                 return c.certain ? c.meant : fmt::format("about {}", c.meant);
                             }),
            list_corrections(f, [](const studies::audit::Correction& c) { return fmt::format("{:.3g}", c.units); }));
    }
    fmt::format_to(out, "\n");
}

void write_findings(Out out, const PublishedTables& tables, const Report& report) {
    if (report.findings.empty()) return;
    fmt::format_to(out,
                   "## Findings\n\nBlamed are the fewest causes whose correction removes all contradictions; between "
                   "equally few, those nearest to a slip of the pen.\n\n");
    std::size_t number = 0;
    for (const Finding& f : report.findings) {
        fmt::format_to(out, "{}. **{}**\n", ++number, markdown_text(f.statement));
        for (const studies::audit::Evidence& e : f.evidence) {
            fmt::format_to(out, "   - {}: {}", name(e.relation), markdown_text(e.text));
            if (!e.figures.empty()) {
                std::vector<std::string> names;
                for (const std::size_t figure : e.figures) names.push_back(markdown_text(describe(tables, figure)));
                fmt::format_to(out, " It rests on: {}.", fmt::join(names, "; "));
            }
            fmt::format_to(out, "\n");
        }
        for (const std::string& alternative : f.alternatives)
            fmt::format_to(out, "   - {}\n", markdown_text(alternative));
    }
    fmt::format_to(out, "\n");
}

void write_formats(Out out, const Report& report) {
    fmt::format_to(out, "## How figures are printed\n\n");
    for (const studies::audit::InferredFormat& f : report.formats) {
        fmt::format_to(
            out, "- {}: {}{}\n", markdown_text(f.method), describe(f.format),
            f.evidence.empty() ? ", or the other way: its figures cannot tell rounding from truncation." : ".");
    }
    for (const studies::audit::InferredFormat& f : report.formats) {
        if (f.evidence.empty()) continue;
        fmt::format_to(
            out,
            "\nFigures of {} are hits divided by a known number of rays. Only a figure whose digits are finer "
            "than one hit can fail to be one.\n\n"
            "| printed | figures that can fail | whole hits | expected by chance | p of as many | "
            "log10 odds against the best |\n|---|--:|--:|--:|--:|--:|\n",
            markdown_text(f.method));
        for (const studies::audit::FormatEvidence& e : f.evidence) {
            fmt::format_to(out, "| {} | {} | {} | {:.1f} | {:.2g} | {:.1f} |\n", describe(e.format), e.figures, e.whole,
                           e.expected, e.chance,
                           (f.evidence.front().log_likelihood - e.log_likelihood) / std::log(10.0));
        }
    }
    const studies::audit::ReferenceInference& r = report.references;
    if (r.rows > 0) {
        fmt::format_to(out,
                       "\nRelative errors are {}: of {} different rows, rounding explains {} and truncation {}.\n\n"
                       "| table | pairs | stated reference | explains | reference used | explains | rows |\n"
                       "|---|---|---|--:|---|--:|--:|\n",
                       r.rounding == studies::audit::Rounding::rounded ? "rounded" : "truncated", r.rows,
                       r.explained_rounded, r.explained_truncated);
        for (const studies::audit::InferredReference& i : r.references) {
            fmt::format_to(out, "| {} | {} | {} | {} | {} | {} | {} |\n", markdown_cell(i.table), i.pair_class,
                           i.stated, i.explained_by_stated, i.text, i.explained, i.rows);
        }
    }
    fmt::format_to(out, "\n");
}

void write_readings(Out out, const Report& report) {
    if (report.readings.empty()) return;
    fmt::format_to(out,
                   "## What columns mean\n\n"
                   "| table | reading | stated in | rays per face | whole hits | expected | chi-squared (p as far, "
                   "p as close) by column | log10 odds | verdict |\n|---|---|---|---|--:|--:|---|--:|---|\n");
    for (const studies::audit::ReadingEvidence& r : report.readings) {
        std::vector<std::string> spreads;
        for (const auto& s : r.spread) {
            spreads.push_back(s ? fmt::format("{:.3g} on {} ({:.2g}, {:.2g})", s->chi_squared.statistic,
                                              s->chi_squared.freedom, s->too_far, s->too_close)
                                : "none");
        }
        fmt::format_to(out, "| {} | {} | {} | {} | {} of {} | {:.1f} | {} | {:.1f} | {} |\n", markdown_cell(r.table),
                       markdown_cell(r.statement), r.stated_in.empty() ? "nowhere" : markdown_cell(r.stated_in),
                       fmt::join(r.rays_per_face, ", "), r.hits.whole, r.hits.figures, r.hits.expected,
                       fmt::join(spreads, "; "), r.log_odds / std::log(10.0), r.refuted ? "refuted" : "possible");
    }
    fmt::format_to(out, "\n");
}

void write_spreads(Out out, const Report& report) {
    if (report.spreads.empty()) return;
    fmt::format_to(out,
                   "## Monte Carlo plausibility\n\nAgainst the exact covariance of the method, misprints corrected. A "
                   "single value counts as impossible from {:.2f} standard deviations on ({} quantities); with the "
                   "chi-squared tests below, correct tables raise a false alarm with probability {:.1g} at most.\n\n"
                   "| experiment | chi-squared | degrees of freedom | p as far | p as close |\n|---|--:|--:|--:|--:|\n",
                   report.z_limit, report.plausibility_tests, report.alpha);
    for (const studies::audit::ExperimentSpread& s : report.spreads) {
        fmt::format_to(out, "| {} | {:.3g} | {} | {:.2g} | {:.2g} |\n", markdown_cell(s.experiment),
                       s.spread.chi_squared.statistic, s.spread.chi_squared.freedom, s.spread.too_far,
                       s.spread.too_close);
    }
    fmt::format_to(out, "\n");
}

void write_hits(Out out, const PublishedTables& tables, const Report& report) {
    if (report.hits.empty()) return;
    fmt::format_to(out,
                   "## Recovered hits\n\n| figure | printed | rays | hits by the print alone | hits by all figures "
                   "|\n|---|---|--:|--:|--:|\n");
    for (const studies::audit::RecoveredHits& h : report.hits) {
        fmt::format_to(out, "| {} | {} | {} | {} | {} |\n", markdown_cell(describe(tables, h.figure)),
                       tables.figures[h.figure].printed, h.rays, hits_in_words(h.printed), hits_in_words(h.consistent));
    }
}

}  // namespace

std::string audit_markdown(const PublishedTables& tables, const Report& report) {
    std::string text;
    const Out out = std::back_inserter(text);
    fmt::format_to(out, "# Audit of published tables\n\n{}\n\n**{}**\n\n", markdown_text(report.source),
                   audit_verdict(report));
    write_overview(out, tables, report);
    write_findings(out, tables, report);
    write_formats(out, report);
    write_readings(out, report);
    write_spreads(out, report);
    write_hits(out, tables, report);
    return text;
}

}  // namespace ff::reports
