// A file of estimates gives verdicts whose numbers are numbers, or is a UserError.

#include "studies/verdicts/reported/estimates_file.hpp"
#include "core/support/error.hpp"
#include "reports/csv/gates_csv.hpp"
#include "reports/json/gates_json.hpp"
#include "studies/verdicts/reported/estimate_gates.hpp"
#include "tests/fuzz/no_number.hpp"
#include "tests/fuzz/one_input.hpp"

#include <cstdint>
#include <cstdlib>
#include <sstream>
#include <string>
#include <string_view>

namespace {

using namespace ff::studies;

gates::Gate gate_on(const std::string& quantity, gates::GateKind kind) {
    gates::Gate gate;
    gate.name = quantity;
    gate.kind = kind;
    gate.quantity = quantity;
    gate.against = gates::Against::number;
    gate.reference = 0.2;
    gate.band = kind == gates::GateKind::bias ? gates::Band{-0.01, 0.01} : gates::Band{0.5, 2};
    return gate;
}

/// @throws UserError where the trials repeat
void judge_all(const gates::EstimatesFile& file) {
    gates::CheckResults check;
    for (const gates::EstimateSeries& series : file.series) {
        for (const gates::GateKind kind : {gates::GateKind::bias, gates::GateKind::std})
            check.results.push_back(gates::judge_estimates(check.spec, gate_on(series.quantity, kind), file));
    }
    std::ostringstream csv;
    ff::reports::write_verdicts_csv(csv, check);
    if (has_no_number(csv.str()) || has_no_number(ff::reports::verdicts_json(check))) std::abort();
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        judge_all(gates::parse_estimates({reinterpret_cast<const char*>(data), size}, "estimates.csv"));
    } catch (const ff::UserError&) {
    }
    return 0;
}
