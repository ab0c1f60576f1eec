#include "reports/csv/scene_csv.hpp"

#include "core/geometry/scene.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/text/numbers.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

namespace ff::reports {

using studies::form_factors::FaceExchange;

namespace {

void write_row(std::ostream& out, const FormFactorReport& report, std::size_t from, const FaceExchange& exchange) {
    const std::size_t to = exchange.from == from ? exchange.to : exchange.from;
    const double area = report.matrix.areas[from];
    out << fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(report.scene.faces[from]),
                       csv_field(report.scene.faces[to]), exact(exchange.value / area), exact(exchange.low / area),
                       exact(exchange.high / area), exact(half_width(exchange) / area), method_of(exchange),
                       csv_field(reason_of(exchange)), exchange.samples, exchange.clipped ? 1 : 0,
                       exchange.within ? 1 : 0);
}

}  // namespace

void write_form_factors_csv(std::ostream& out, const FormFactorReport& report) {
    out << "from,to,factor,low,high,half_width,method,reason,samples,clipped,within\n";
    const auto rows = studies::form_factors::by_face(report.matrix.exchanges, report.matrix.faces());
    for (std::size_t from = 0; from < rows.size(); ++from) {
        for (const std::uint32_t index : rows[from]) {
            const FaceExchange& exchange = report.matrix.exchanges[index];
            if (exchange.high > 0) write_row(out, report, from, exchange);
        }
    }
}

}  // namespace ff::reports
