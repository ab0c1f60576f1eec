#include "reports/words/audit_summary.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace ff::reports {

using studies::PublishedTables;
using studies::audit::Finding;
using studies::audit::Report;

std::string audit_verdict(const Report& report) {
    const std::size_t n = report.contradictions();
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

}  // namespace ff::reports
