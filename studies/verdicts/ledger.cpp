#include "studies/verdicts/ledger.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"
#include "stats/basics/distributions.hpp"
#include "studies/readers/csv_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace ff::studies::gates {
namespace {

constexpr std::string_view ledger_header = "commit,bands,data,verdict";

Verdict verdict_named(const CsvReader& reader, const CsvField& field) {
    for (const Verdict verdict : {Verdict::pass, Verdict::fail, Verdict::inconclusive}) {
        if (name(verdict) == field.text) return verdict;
    }
    reader.fail(field, "not a verdict (pass, fail or inconclusive). Restore the ledger, or begin a new one.");
}

}  // namespace

Ledger parse_ledger(std::string_view text, std::string_view origin) {
    CsvReader reader(text, origin);
    std::vector<CsvField> record;
    Ledger ledger;
    constexpr std::size_t columns = 4;
    while (reader.next(record)) {
        if (record.size() != columns)
            reader.fail(record.front(),
                        fmt::format("not a line of a ledger (it has the columns {}). Restore it, or begin "
                                    "a new one.",
                                    ledger_header));
        if (record.front().line == 1) continue;
        ledger.push_back({record[0].text, record[1].text, record[2].text, verdict_named(reader, record[3])});
    }
    return ledger;
}

std::string ledger_csv(const Ledger& ledger) {
    std::string text = fmt::format("{}\n", ledger_header);
    for (const LedgerLook& look : ledger)
        text += fmt::format("{},{},{},{}\n", look.commit, look.bands, look.data, name(look.verdict));
    return text;
}

NextLook next_look(const Ledger& ledger, const LedgerLook& look) {
    NextLook next;
    for (const LedgerLook& earlier : ledger) {
        if (earlier.commit != look.commit) continue;
        ++next.number;
        next.failed = next.failed || earlier.verdict == Verdict::fail;
        next.changed = earlier.bands != look.bands;
        if (next.changed || earlier.data != look.data) continue;
        next.repeated = true;
        next.earlier = earlier.verdict;
    }
    return next;
}

double share_of_look(const Spec& spec, std::size_t number) {
    FF_EXPECT(number >= 1 && (spec.spending == Spending::halving || number <= spec.looks));
    constexpr double rounding = 1e-6;
    const auto spent = [&](std::size_t looks) {
        const double t = static_cast<double>(looks) / static_cast<double>(spec.looks);
        if (t == 0) return 0.0;
        if (spec.spending == Spending::pocock) return std::log1p((std::numbers::e - 1) * t);
        // The first looks would have less than is computed.
        const double least = static_cast<double>(looks) * smallest_alpha * (1 + rounding);
        const double tail = 2 * stats::normal_tail(stats::normal_critical(spec.alpha / 2) / std::sqrt(t));
        return std::max(least, tail) / spec.alpha;
    };
    constexpr std::size_t most = 1000;  // powers of two that a double has
    if (spec.spending == Spending::halving) return std::ldexp(1.0, -static_cast<int>(std::min(number, most)));
    return spent(number) - spent(number - 1);
}

Spec at_look(Spec spec, std::size_t number) {
    if (spec.spending != Spending::halving && number > spec.looks)
        throw UserError(
            "--again (look {} of {}: all of alpha is spent). The commit stays undecided; look at another "
            "one with more trials.",
            number, spec.looks);
    const double share = share_of_look(spec, number);
    if (spec.alpha * share < smallest_alpha)
        throw UserError(
            "--again (look {} would have a share of {:.1g} of alpha = {:g}; below {:g} nothing is "
            "computed). Run more trials at once, or widen the band.",
            number, share, spec.alpha, smallest_alpha);
    spec.alpha *= share;
    spec.pass_alpha *= share;
    return spec;
}

}  // namespace ff::studies::gates
