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
        const studies::FaceFlow& flow = report.flows.faces[i];
        out << fmt::format("{},{}", csv_field(report.scene.faces[i]), exact(flow.area));
        for (const studies::Bounds* bounds :
             {&flow.radiosity, &flow.irradiation, &flow.net, &flow.power, &flow.temperature}) {
            if (!light || bounds != &flow.temperature)
                out << fmt::format(",{},{}", exact(bounds->low), exact(bounds->high));
        }
        out << '\n';
    }
}

}  // namespace ff::reports
