#include "reports/csv/form_factors_csv.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/text/numbers.hpp"
#include "studies/form_factors/words.hpp"

#include <fmt/format.h>

namespace ff::reports {

using studies::FaceExchange;

namespace {

void write_row(std::ostream& out, const FormFactorReport& report, std::size_t from, std::size_t to) {
    const studies::FormFactorMatrix& matrix = report.matrix;
    const FaceExchange& exchange = matrix.exchange(from, to);
    const double area = matrix.areas[from];
    out << fmt::format(
        "{},{},{},{},{},{},{},{},{},{},{}\n", csv_field(report.scene.faces[from]), csv_field(report.scene.faces[to]),
        exact(exchange.value / area), exact(exchange.low / area), exact(exchange.high / area),
        exact(std::max(exchange.high - exchange.value, exchange.value - exchange.low) / area), method_of(exchange),
        csv_field(reason_of(exchange)), exchange.samples, exchange.clipped ? 1 : 0, exchange.within ? 1 : 0);
}

}  // namespace

void write_form_factors_csv(std::ostream& out, const FormFactorReport& report) {
    out << "from,to,factor,low,high,half_width,method,reason,samples,clipped,within\n";
    const std::size_t n = report.scene.faces.size();
    for (std::size_t from = 0; from < n; ++from) {
        for (std::size_t to = 0; to < n; ++to) {
            const FaceExchange& exchange = report.matrix.exchange(from, to);
            if (exchange.high > 0) write_row(out, report, from, to);
        }
    }
}

}  // namespace ff::reports
