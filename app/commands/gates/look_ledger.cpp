#include "app/commands/gates/look_ledger.hpp"

#include "app/folders/output_folder.hpp"

#include "core/support/error.hpp"
#include "reports/files/output_file.hpp"
#include "studies/readers/digest.hpp"
#include "studies/readers/text_file.hpp"

#include <algorithm>
#include <string>

namespace ff::app {
namespace {

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

}  // namespace

studies::gates::LedgerLook describe_look(const CheckCommand& command, std::uint64_t seed) {
    const std::string_view allowed = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789._/-";
    if (command.again.size() > 100 || command.again.find_first_not_of(allowed) != std::string::npos)
        throw UserError("--again (letters, digits and ._/-, at most 100: the name of a commit). Give its hash.");
    if (command.seed_sweep > 0 || !command.save_baseline.empty() || command.dry_run)
        throw UserError(
            "--again (--seed-sweep, --save-baseline and --dry-run judge no commit). Leave one of them out.");
    studies::Digest data;
    if (command.estimates.empty()) data.add(seed);
    for (const auto& file : {command.estimates, command.against}) {
        if (!file.empty()) data.add(studies::read_text_file(file, studies::FileKind::estimates));
    }
    studies::Digest bands;
    bands.add(studies::read_text_file(command.bands, studies::FileKind::bands));
    return {command.again, in_hexadecimal(bands), in_hexadecimal(data), studies::gates::Verdict::inconclusive};
}

std::filesystem::path ledger_file(const CheckCommand& command) {
    if (!command.ledger.empty()) return command.ledger;
    return std::filesystem::path(command.bands).replace_extension("ledger.csv");
}

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

}  // namespace ff::app
