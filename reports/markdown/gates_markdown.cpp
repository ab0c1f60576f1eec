#include "reports/markdown/gates_markdown.hpp"

#include "reports/markdown/markdown_text.hpp"
#include "reports/terminal/gates_terminal.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

namespace ff::reports {

std::string gates_markdown(const studies::gates::CheckResults& check) {
    using studies::gates::Verdict;
    const std::size_t missing = check.spec.gates.size() - check.results.size();
    std::string text =
        fmt::format("### Gates of {}: {} passed, {} failed, {} inconclusive{}\n\n", markdown_text(check.spec.name),
                    check.count(Verdict::pass), check.count(Verdict::fail), check.count(Verdict::inconclusive),
                    missing > 0 ? fmt::format(", {} not run", missing) : "");
    text += fmt::format("False alarm at most {} in all, power {}. Inconclusive is not a pass.\n\n",
                        brief(check.spec.alpha), brief(check.spec.power));
    text += "| verdict | gate | kind | found |\n|---|---|---|---|\n";
    for (const Verdict verdict : {Verdict::fail, Verdict::inconclusive, Verdict::pass}) {
        for (const studies::gates::GateResult& result : check.results) {
            if (result.verdict != verdict) continue;
            const std::string shown(name(verdict));
            text += fmt::format("| {} | {} | {} | {} |\n", verdict == Verdict::pass ? shown : "**" + shown + "**",
                                markdown_cell(result.gate), name(result.kind), markdown_cell(gate_in_words(result)));
        }
    }
    return text;
}

}  // namespace ff::reports
