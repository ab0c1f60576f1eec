#include "reports/markdown/markdown.hpp"

#include "reports/markdown/markdown_sections.hpp"
#include "reports/markdown/markdown_table.hpp"
#include "reports/markdown/markdown_text.hpp"
#include "reports/tables/tables.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string markdown_report(const studies::StudyResults& results) {
    std::string out = fmt::format("# {}\n\n", markdown_text(results.findings.plan.spec.title));
    if (!results.findings.complete)
        out += "> **Partial result:** the study was stopped early; run it again to resume.\n\n";
    out += brief_section(results);
    out += markdown_section(methods_table(results));
    out += markdown_section(occlusion_table(results));
    out += markdown_section(configurations_table(results));
    out += slopes_section(results);
    out += markdown_section(decisions_table(results, false));
    out += markdown_section(contests_table(results, false));
    out += markdown_section(reductions_table(results));
    out += markdown_section(evenness_table(results));
    out += markdown_section(coverage_table(results));
    out += markdown_section(claimed_errors_table(results, Claims::all));
    out += radiosity_section(results);
    out += published_tables_section(results);
    out += claims_section(results);
    out += markdown_section(error_law_table(results));
    out += audit_section(results);
    out += bias_section(results);
    out += markdown_section(spreads_table(results));
    out += reproduction_section(results);
    return out;
}

}  // namespace ff::reports
