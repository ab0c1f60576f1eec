#include "app/commands/gates/check_session.hpp"

#include "app/commands/gates/check_estimates.hpp"
#include "app/commands/gates/look_ledger.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/csv/gates_csv.hpp"
#include "reports/html/gates_html.hpp"
#include "reports/json/context_json.hpp"
#include "reports/json/gates_json.hpp"
#include "reports/json/gates_junit.hpp"
#include "reports/markdown/gates_markdown.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "studies/verdicts/gate_result.hpp"
#include "studies/verdicts/ledger.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>

namespace ff::app {
namespace {

using Clock = std::chrono::steady_clock;

ExitCode exit_code(studies::gates::Verdict verdict) {
    return verdict == studies::gates::Verdict::pass   ? ExitCode::passed
           : verdict == studies::gates::Verdict::fail ? ExitCode::failed
                                                      : ExitCode::inconclusive;
}

/// Writes each file completely or not at all. @throws IoError
void write_verdicts(OutputFolder& folder, const studies::gates::CheckResults& check,
                    const reports::JunitContext& context) {
    folder.write("verdicts.csv", [&](std::ostream& out) { reports::write_verdicts_csv(out, check); });
    folder.write("verdicts.json", reports::verdicts_json(check));
    folder.write("junit.xml", reports::junit_xml(check, context));
    folder.write("summary.md", reports::gates_markdown(check));
    folder.write("summary.html", reports::gates_html(check));
}

ExitCode judge_once(const CheckSession& session) {
    const RunGates run_others = session.prepare ? session.prepare(session.spec) : RunGates();
    auto judged = judge_file(session.command, session.spec);
    const auto start = Clock::now();
    const auto out = session.out();
    OutputFolder folder =
        open_folder(out, {"verdicts.csv", "verdicts.json", "junit.xml", "summary.md", "summary.html", "context.json"});
    auto context = session.context;
    reports::JunitContext junit{context["date_utc"].substr(0, 19), context["host"], {}, {}};
    studies::gates::CheckResults results{session.spec, {}};
    write_verdicts(folder, results, junit);
    session.print(reports::gates_heading(session.spec));
    const auto add = [&](studies::gates::GateResult result, double seconds, const std::string& note) {
        results.results.push_back(std::move(result));
        junit.seconds.push_back(seconds);
        junit.notes.push_back(note);
        session.print(reports::gate_line(results.results.back(), style_of_stdout().colour));
        if (!note.empty()) session.print(fmt::format("{:<12}  {}\n", "", note));
    };
    for (studies::gates::GateResult& result : judged) add(std::move(result), 0, {});
    if (!judged.empty()) write_verdicts(folder, results, junit);
    if (run_others) {
        run_others([&](studies::gates::GateResult result, double seconds, const std::string& note) {
            add(std::move(result), seconds, note);
            write_verdicts(folder, results, junit);
        });
    }
    context["seconds"] = fmt::format("{:.2f}", std::chrono::duration<double>(Clock::now() - start).count());
    folder.write("context.json", reports::context_json(context));
    session.print(reports::gates_summary(results));
    session.print(fmt::format("Results: {}\n", out.string()));
    if (session.command.json) print_verbatim(reports::verdicts_json(results));
    return exit_code(results.verdict());
}

studies::gates::Verdict verdict_of(ExitCode code) {
    return code == ExitCode::passed   ? studies::gates::Verdict::pass
           : code == ExitCode::failed ? studies::gates::Verdict::fail
                                      : studies::gates::Verdict::inconclusive;
}

/// One more look at a commit, with the part of alpha that earlier looks have left.
ExitCode judge_again(CheckSession& session) {
    const auto look = describe_look(session.command, session.spec.seed.value);
    const auto file = ledger_file(session.command);
    const auto next = begin_look(file, look, session.spec);
    if (next.failed) {
        session.print(fmt::format("{}: failed at an earlier look ({}); a rerun does not take that back.\n", look.commit,
                                  file.string()));
        return ExitCode::failed;
    }
    if (next.repeated) {
        session.print(fmt::format("{}: the same data were judged before ({}): {}. Another look needs other data.\n",
                                  look.commit, file.string(), name(next.earlier)));
        return exit_code(next.earlier);
    }
    const double alpha = session.spec.alpha;
    session.spec = studies::gates::at_look(session.spec, next.number);
    session.print(
        fmt::format("look {} at {}: alpha {:.3g} of {:.3g}\n", next.number, look.commit, session.spec.alpha, alpha));
    try {
        const ExitCode code = judge_once(session);
        end_look(file, look, verdict_of(code));
        return code;
    } catch (const UserError&) {
        end_look(file, look, std::nullopt);  // nothing was judged
        throw;
    }
}

}  // namespace

std::filesystem::path CheckSession::out() const {
    return command.out.empty() ? std::filesystem::path("results") / spec.name : command.out;
}

void CheckSession::print(const std::string& text) const {
    if (command.quiet || command.json) return;
    print_folded(text);
    std::fflush(stdout);
}

/// The folder for these files, after checking that they may be written.
OutputFolder open_folder(const std::filesystem::path& out, const std::vector<std::string>& files) {
    end_on_signals(fmt::format("\nstopped early; the gates that were done are in {}.\n", out.string()));
    return {out, "check", files};
}

ExitCode judge(CheckSession session) {
    return session.command.again.empty() ? judge_once(session) : judge_again(session);
}

}  // namespace ff::app
