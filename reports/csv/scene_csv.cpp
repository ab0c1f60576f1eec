#include "reports/csv/scene_csv.hpp"

#include "reports/csv/csv_records.hpp"
#include "reports/text/numbers.hpp"
#include "studies/form_factors/form_factors.hpp"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>
#include <string_view>

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

void write_heat_csv(std::ostream& out, const HeatReport& report) {
    out << "face,area";
    const bool light = report.materials.are_light();
    for (const std::string_view column : {"radiosity", "irradiation", "net", "power", "temperature"}) {
        if (!light || column != "temperature") out << fmt::format(",{0}_low,{0}_high", column);
    }
    out << '\n';
    for (std::size_t i = 0; i < report.scene.faces.size(); ++i) {
        const studies::heat::FaceFlow& flow = report.flows.faces[i];
        out << fmt::format("{},{}", csv_field(report.scene.faces[i]), exact(flow.area));
        for (const studies::heat::Bounds* bounds :
             {&flow.radiosity, &flow.irradiation, &flow.net, &flow.power, &flow.temperature}) {
            if (!light || bounds != &flow.temperature)
                out << fmt::format(",{},{}", exact(bounds->low), exact(bounds->high));
        }
        out << '\n';
    }
}

void write_gebhart_csv(std::ostream& out, const Scene& scene,
                       const std::vector<studies::heat::GebhartFactor>& factors) {
    out << "from,to,gebhart_low,gebhart_high,script_f_low,script_f_high\n";
    for (const auto& [from, to, gebhart, script_f] : factors) {
        out << fmt::format("{},{},{},{},{},{}\n", csv_field(scene.faces[from]),
                           to < scene.faces.size() ? csv_field(scene.faces[to]) : "", exact(gebhart.low),
                           exact(gebhart.high), exact(script_f.low), exact(script_f.high));
    }
}

}  // namespace ff::reports
