#include "app/commands/commands.hpp"

#include "app/command_line/program.hpp"
#include "app/folders/output_folder.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/markdown/audit_markdown.hpp"
#include "reports/words/published_words.hpp"
#include "studies/audit/audit.hpp"
#include "studies/published/published.hpp"

namespace ff::app {
namespace {

struct AuditCommand {
    std::filesystem::path tables;
    std::filesystem::path out;  ///< empty: nothing is written
    bool quiet = false;
};

ExitCode audit(const AuditCommand& command) {
    const auto tables = studies::read_published_tables(command.tables);
    const auto found = [&] {
        try {
            return studies::audit::examine(tables);
        } catch (const UserError& error) {
            throw UserError("{}: {}", command.tables.string(), error.what());
        }
    }();
    if (!command.out.empty())
        OutputFolder(command.out, "audit").write("audit.md", reports::audit_markdown(tables, found));
    if (!command.quiet) print_folded(reports::audit_summary(tables, found));
    return found.contradictions() > 0 ? ExitCode::failed : ExitCode::passed;
}

}  // namespace

void add_audit(ProgramDefinition& program) {
    const auto [sub, command] =
        program.command<AuditCommand>(laboratory, "audit", "Find contradictions in published tables", audit);
    sub.option("TABLES", command.tables, "Tables file (.json)", {.is_required = true});
    sub.option("--out", command.out, "Folder for audit.md (default: none is written)", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
}

}  // namespace ff::app
