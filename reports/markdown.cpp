#include "reports/markdown.hpp"

#include "reports/markdown_sections.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string markdown_report(const studies::StudyResults& results) {
    std::string out = fmt::format("# {}\n\n", results.findings.plan.spec.title);
    if (!results.findings.complete)
        out += "> **Partial result:** the study was stopped early; run it again to go on.\n\n";
    out += brief_section(results);
    out += methods_section(results);
    out += slopes_section(results);
    out += reductions_section(results);
    out += coverage_section(results);
    out += published_tables_section(results);
    out += claims_section(results);
    out += error_law_section(results);
    out += audit_section(results);
    out += bias_section(results);
    out += variance_section(results);
    out += reproduction_section(results);
    return out;
}

}  // namespace ff::reports
