#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/pictures/pictures.hpp"
#include "reports/text/numbers.hpp"
#include "reports/words/answer.hpp"
#include "reports/words/findings/radiosity_words.hpp"
#include "reports/words/findings/verdicts.hpp"
#include "reports/words/in_brief.hpp"
#include "reports/words/published_summary.hpp"

#include <fmt/format.h>

namespace ff::reports {
namespace {

std::string bias_line(const studies::Analysis& findings) {
    BiasTally tally = tally_of(findings);
    if (tally.sampled == 0) return {};
    const auto biased = tally.found[studies::BiasFinding::biased];
    const std::string lost = tally.lost_rays ? fmt::format(" Lost rays: {}.", *tally.lost_rays) : std::string();
    if (tally.found[studies::BiasFinding::untestable] == tally.sampled)
        return fmt::format("- Bias: not tested in any of {} sampled methods and sizes.{}\n", tally.sampled, lost);
    std::string out = fmt::format(
        "- Bias: {}none found in {} of {} sampled methods and sizes{} ({:g} % over all of them)",
        biased > 0 ? fmt::format("found in {}, ", biased) : "", tally.found[studies::BiasFinding::no_bias_found],
        tally.sampled, tally.partly > 0 ? fmt::format(", in {} of them on a part of the pairs", tally.partly) : "",
        100 * (1 - findings.plan.spec.level));
    if (const auto margin = findings.plan.spec.equivalence_margin) {
        out += fmt::format("; a bias within ±{} is shown on every pair of {}", brief(*margin, 2), tally.shown);
    }
    return out + fmt::format(".{}\n", lost);
}

}  // namespace

std::string brief_section(const studies::StudyResults& results) {
    const Answer said = answer(results);
    std::string out = said.question.empty() ? std::string() : fmt::format("*{}*\n\n", markdown_text(said.question));
    out += fmt::format("**{}**\n\n", markdown_text(said.text));
    if (const auto lead = lead_picture(results); lead && lead->kind == "ranking")
        out += fmt::format("![{}](answer.svg)\n\n{}\n\n", markdown_text(lead->title), markdown_text(lead->finding));
    out += "## In brief\n\n";
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
