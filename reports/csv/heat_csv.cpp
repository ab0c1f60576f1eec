#include "reports/csv/heat_csv.hpp"

#include "core/geometry/scene.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/json/heat_json.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <string>
#include <string_view>

namespace ff::reports {
namespace {

/// Columns of the two ends of these quantities.
std::string ends_of(std::initializer_list<std::string_view> quantities) {
    std::string columns;
    for (const std::string_view quantity : quantities)
        columns += fmt::format(",{0}_low={0}/low,{0}_high={0}/high", quantity);
    return columns;
}

}  // namespace

void write_heat_csv(std::ostream& out, const HeatReport& report) {
    CsvRecords csv(out, (report.has_cases() ? "case,face,area" : "face,area") +
                            ends_of({"radiosity", "irradiation", "net", "power"}) +
                            (report.is_light() ? std::string() : ends_of({"temperature"})));
    for (const studies::heat::SolvedCase& solved : report.cases) {
        for (std::size_t face = 0; face < report.scene.faces.size(); ++face)
            csv.add(flow_json(report.scene.faces[face], solved, face));
    }
}

void write_groups_csv(std::ostream& out, const HeatReport& report) {
    CsvRecords csv(out, "case,group,faces,area" + ends_of({"net", "power", "share"}));
    for (const studies::heat::SolvedCase& solved : report.cases) {
        for (const studies::heat::GroupFlow& group : solved.flows.groups) {
            Json record = group_json(group);
            record["case"] = solved.materials.name;
            csv.add(record);
        }
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
