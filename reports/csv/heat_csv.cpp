#include "reports/csv/heat_csv.hpp"

#include "reports/csv/csv_field.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <string_view>

namespace ff::reports {

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
