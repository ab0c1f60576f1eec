#include "app/commands.hpp"

#include "reports/audit_markdown.hpp"
#include "reports/output_file.hpp"
#include "studies/audit.hpp"
#include "studies/published.hpp"

#include <fmt/format.h>

namespace ff::app {

ExitCode audit(const AuditCommand& command) {
    const auto tables = studies::read_published_tables(command.tables);
    const auto found = studies::audit(tables);
    if (!command.out.empty()) {
        std::filesystem::create_directories(command.out);
        reports::write_file(command.out / "audit.md", reports::audit_markdown(tables, found));
    }
    if (!command.quiet) fmt::print("{}", reports::audit_summary(tables, found));
    return found.contradictions() > 0 ? ExitCode::failed : ExitCode::passed;
}

}  // namespace ff::app
