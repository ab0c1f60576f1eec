#include "app/commands/gates/gate_commands.hpp"

#include "app/command_line/program.hpp"
#include "app/commands/context/program_context.hpp"
#include "app/process/signals.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/csv/gates_csv.hpp"
#include "reports/files/output_file.hpp"
#include "reports/html/gates_html.hpp"
#include "reports/json/context_json.hpp"
#include "reports/json/gates_json.hpp"
#include "reports/json/gates_junit.hpp"
#include "reports/markdown/gates_markdown.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "stats/basics/moments.hpp"
#include "studies/readers/digest.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/verdicts/bands_file.hpp"
#include "studies/verdicts/reported/estimates_file.hpp"
#include "studies/verdicts/reported/reported_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <utility>

namespace ff::app {
namespace {

using studies::gates::Verdict;
using Clock = std::chrono::steady_clock;

/// Reads the ledger, applies `change` and writes it, while no other process does so.
template <class Change>
auto change_ledger(const std::filesystem::path& file, const Change& change) {
    const OutputFolder lock(reports::folder_of(file), "ledger");
    studies::gates::Ledger ledger;
    if (std::filesystem::exists(file))
        ledger =
            studies::gates::parse_ledger(studies::read_text_file(file, studies::FileKind::estimates), file.string());
    const auto result = change(ledger);
    reports::write_file(file, studies::gates::ledger_csv(ledger));
    return result;
}

std::filesystem::path ledger_file(const CheckCommand& command) {
    if (!command.ledger.empty()) return command.ledger;
    return std::filesystem::path(command.bands).replace_extension("ledger.csv");
}

/// The effect of earlier looks on this one, which is recorded before it is made: a killed one counts. Nothing is
/// recorded where an earlier one failed, or judged the same data.
studies::gates::NextLook begin_look(const std::filesystem::path& file, const studies::gates::LedgerLook& look,
                                    const studies::gates::Spec& spec) {
    return change_ledger(file, [&](studies::gates::Ledger& ledger) {
        const auto next = next_look(ledger, look);
        if (next.failed || next.repeated) return next;
        static_cast<void>(studies::gates::at_look(spec, next.number));
        ledger.push_back(look);
        return next;
    });
}

/// Records the verdict; without one, that the look was not made.
void end_look(const std::filesystem::path& file, const studies::gates::LedgerLook& look,
              std::optional<studies::gates::Verdict> verdict) {
    change_ledger(file, [&](studies::gates::Ledger& ledger) {
        const auto ours = std::find_if(ledger.begin(), ledger.end(), [&](const studies::gates::LedgerLook& other) {
            return other.commit == look.commit && other.bands == look.bands && other.data == look.data;
        });
        if (ours == ledger.end()) return false;
        if (verdict) {
            ours->verdict = *verdict;
        } else {
            ledger.erase(ours);
        }
        return true;
    });
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

Verdict judge_once(const CheckSession& session) {
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
    return results.verdict();
}

/// One more look at a commit, with the part of alpha that earlier looks have left.
Verdict judge_again(CheckSession& session) {
    const auto look = describe_look(session.command, session.spec);
    const auto file = ledger_file(session.command);
    const auto next = begin_look(file, look, session.spec);
    if (next.failed) {
        session.print(fmt::format("{}: failed at an earlier look ({}); a rerun does not take that back.\n", look.commit,
                                  file.string()));
        return Verdict::fail;
    }
    if (next.repeated) {
        session.print(fmt::format("{}: the same data were judged before ({}): {}. Another look needs other data.\n",
                                  look.commit, file.string(), name(next.earlier)));
        return next.earlier;
    }
    if (next.changed)
        session.print(fmt::format("{} has changed since the last look; all looks at a commit share alpha.\n",
                                  session.command.bands.string()));
    const double alpha = session.spec.alpha;
    session.spec = studies::gates::at_look(session.spec, next.number);
    session.print(
        fmt::format("look {} at {}: alpha {:.3g} of {:.3g}\n", next.number, look.commit, session.spec.alpha, alpha));
    try {
        const Verdict verdict = judge_once(session);
        end_look(file, look, verdict);
        return verdict;
    } catch (const UserError&) {
        end_look(file, look, std::nullopt);  // nothing was judged
        throw;
    }
}

/// Judges a bands file with gates on files only.
ExitCode judge_files_only(const CheckCommand& command) {
    auto spec = studies::gates::load_bands(command.bands, nullptr);
    expect_estimates(command, spec);
    if (!command.save_baseline.empty()) {
        save_means(command);
        return ExitCode::passed;
    }
    if (command.dry_run) {
        print_folded(reports::estimates_plan(spec, plan_file(command, spec)));
        return ExitCode::passed;
    }
    auto context = describe_program(fmt::format("ffstudy check {}", command.bands.string()), 1, 0);
    return judge({command, std::move(spec), std::move(context), nullptr});
}

}  // namespace

studies::gates::LedgerLook describe_look(const CheckCommand& command, const studies::gates::Spec& spec) {
    const std::string_view allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._/-";
    if (command.again.size() > 100 || command.again.find_first_not_of(allowed) != std::string::npos)
        throw UserError("--again (letters, digits and ._/-, at most 100: the name of a commit). Give its hash.");
    if (command.seed_sweep > 0 || !command.save_baseline.empty() || command.dry_run)
        throw UserError(
            "--again (--seed-sweep, --save-baseline and --dry-run judge no commit). Leave one of them out.");
    studies::Digest data;
    if (command.estimates.empty()) data.add(spec.seed.value);
    for (const auto& file : {command.estimates, command.against}) {
        if (!file.empty()) data.add(studies::read_text_file(file, studies::FileKind::estimates));
    }
    if (!command.baseline.empty()) data.add(studies::read_text_file(command.baseline, studies::FileKind::baseline));
    for (const studies::gates::Gate& gate : spec.gates) {
        if (!gate.covariance.empty()) data.add(studies::read_text_file(gate.covariance, studies::FileKind::estimates));
    }
    studies::Digest bands;
    bands.add(studies::read_text_file(command.bands, studies::FileKind::bands));
    return {command.again, in_hexadecimal(bands), in_hexadecimal(data), studies::gates::Verdict::inconclusive};
}

std::filesystem::path CheckSession::out() const {
    return command.out.empty() ? std::filesystem::path("results") / spec.name : command.out;
}

void CheckSession::print(const std::string& text) const {
    if (command.quiet || command.json) return;
    print_folded(text);
    std::fflush(stdout);
}

OutputFolder open_folder(const std::filesystem::path& out, const std::vector<std::string>& files) {
    end_on_signals(fmt::format("\nstopped early; the gates that were done are in {}.\n", out.string()));
    return {out, "check", files};
}

ExitCode judge(CheckSession session) {
    const Verdict verdict = session.command.again.empty() ? judge_once(session) : judge_again(session);
    return verdict == Verdict::pass   ? ExitCode::passed
           : verdict == Verdict::fail ? ExitCode::failed
                                      : ExitCode::inconclusive;
}

void add_options_of_files(CommandDefinition& sub, CheckCommand& command) {
    sub.option("BANDS", command.bands, "Bands file (.toml)", {.is_required = true});
    sub.option(
        "--estimates", command.estimates,
        "CSV of another program: trial,quantity,estimate, or quantity,mean,standard_error, or quantity,bin,count",
        {.type = "FILE"});
    sub.option("--against", command.against, "Second CSV, to compare with", {.type = "FILE"});
    sub.option("--again", command.again, "Look at this commit, perhaps again: looks share alpha", {.type = "COMMIT"});
    sub.option("--ledger", command.ledger, "File of the looks at commits (default: <bands>.ledger.csv)",
               {.type = "FILE", .needs = {"--again"}});
    sub.option("--save-baseline", command.save_baseline, "Save what others are compared with; judge nothing",
               {.type = "FILE"});
    sub.option("--out", command.out, "Folder for the results (default: results/<bands>)", {.type = "DIR"});
    add_verbosity(sub, command.quiet);
    sub.option("--dry-run", command.dry_run, "Show trials and expected time of each gate; runs pilots only");
    sub.option("--json", command.json, "Print the verdicts as JSON, as in verdicts.json",
               {.excludes = {"--again", "--dry-run", "--save-baseline"}});
}

void add_check_of_files(ProgramDefinition& program) {
    const auto [sub, command] = program.command<CheckCommand>(checks, "check", check_summary, judge_files_only);
    add_options_of_files(sub, command);
}

void save_means(const CheckCommand& command) {
    const auto text = studies::read_text_file(command.estimates, studies::FileKind::estimates);
    const std::string origin = command.estimates.string();
    std::string means = text;
    if (studies::gates::reports_means(text)) {
        static_cast<void>(studies::gates::parse_reported(text, origin, studies::gates::StandardErrors::optional));
    } else {
        means = "quantity,mean,standard_error,n\n";
        const auto file = studies::gates::parse_estimates(text, origin);
        for (const studies::gates::EstimateSeries& series : file.series) {
            const double first = series.values.front();
            const auto moments = stats::moments_of(series.values, first);
            const double error = *moments.standard_error();
            if (error == 0)
                throw UserError(
                    "{}: all values of '{}' are equal (no spread is no evidence of precision). "
                    "Was every trial seeded alike?",
                    origin, series.quantity);
            means += fmt::format("{},{},{},{}\n", reports::csv_field(series.quantity), first + *moments.bias(), error,
                                 series.values.size());
        }
    }
    const OutputFolder lock(reports::folder_of(command.save_baseline), "baseline");
    reports::write_file(command.save_baseline, means);
    if (!command.quiet) print_folded("Baseline: {} (compare with it by --against)\n", command.save_baseline.string());
}

}  // namespace ff::app
