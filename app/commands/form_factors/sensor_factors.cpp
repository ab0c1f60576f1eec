#include "app/commands/form_factors/form_factor_run.hpp"

#include "app/folders/output_folder.hpp"
#include "app/terminal/output.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "reports/csv/csv_records.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/text_table.hpp"
#include "studies/form_factors/form_factors.hpp"
#include "studies/form_factors/point_factors.hpp"
#include "studies/readers/csv_reader.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/run/parallel.hpp"
#include "studies/scene_files/scene_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ff::app {
namespace {

using Eigen::Vector3d;
using studies::form_factors::PointFactor;

constexpr std::string_view before_point = "point:";
constexpr std::array<std::string_view, 6> columns_of_sensors{"x", "y", "z", "nx", "ny", "nz"};
constexpr std::size_t most_shown = 8;  // points; more are only in the file

using Sensor = std::array<double, 6>;  ///< a place and a normal

Vector3d normal_of(const Sensor& sensor) {
    return {sensor[3], sensor[4], sensor[5]};
}

/// @throws UserError where the normal has no direction
void expect_normal(const Sensor& sensor, std::string_view where) {
    if (normal_of(sensor).stableNorm() > 0) return;
    throw UserError("{}: its normal is 0 (it faces nowhere). Write a direction, such as 0,0,1.", where);
}

Sensor parse_sensor(const std::string& from) {
    Sensor sensor{};
    const auto parts = split_at(',', std::string_view(from).substr(before_point.size()));
    for (std::size_t k = 0; k < sensor.size(); ++k) {
        const auto value = parts.size() == sensor.size() ? finite_number(trimmed(parts[k])) : std::nullopt;
        if (!value)
            throw UserError(
                "--from {} (expected six numbers: a place and a normal). Write "
                "point:0.5,0.5,1,0,0,1.",
                from);
        sensor[k] = *value;
    }
    expect_normal(sensor, "--from " + from);
    return sensor;
}

/// The six columns among those of a table, wherever they stand; others are named in a note.
std::vector<Sensor> read_sensor_file(const std::string& from) {
    const std::string text = studies::read_bytes(from);
    studies::CsvReader reader(text, from);
    std::vector<studies::CsvField> record;
    if (!reader.next(record)) throw UserError("{}: no points. Write x,y,z,nx,ny,nz and a line each.", from);
    const auto columns = studies::find_columns(reader, record, columns_of_sensors, studies::OtherColumns::left_out);
    for (std::size_t k = 0; k < columns.size(); ++k) {
        if (!columns[k])
            throw UserError("{}: column {} is missing. Write x,y,z,nx,ny,nz and a line for each point.", from,
                            columns_of_sensors[k]);
    }
    if (record.size() > columns.size())
        say("note: {}: {} left out: only {} are read\n", from,
            reports::counted(record.size() - columns.size(), "other column"), fmt::join(columns_of_sensors, ", "));
    std::vector<Sensor> sensors;
    const std::size_t width = record.size();
    while (reader.next(record)) {
        if (record.size() != width)
            reader.fail(record.back(),
                        fmt::format("a line of {} for {} columns. Separate values by commas, and write 0.5 for 0,5.",
                                    reports::counted(record.size(), "value"), width));
        Sensor& sensor = sensors.emplace_back();
        for (std::size_t k = 0; k < sensor.size(); ++k) {
            const auto value =
                *columns[k] < record.size() ? finite_number(trimmed(record[*columns[k]].text)) : std::nullopt;
            if (!value)
                reader.fail(record[std::min(*columns[k], record.size() - 1)],
                            fmt::format("{} is no number. Write one.", columns_of_sensors[k]));
            sensor[k] = *value;
        }
        expect_normal(sensor, fmt::format("{}:{}", from, record.front().line));
    }
    if (sensors.empty()) throw UserError("{}: no points. Write a line for each.", from);
    return sensors;
}

std::vector<Sensor> read_sensors(const std::string& from) {
    if (from.starts_with(before_point)) return {parse_sensor(from)};
    return read_sensor_file(from);
}

/// Whether a factor is more than what rounding leaves of a face that cannot be seen.
bool is_seen(const PointFactor& factor) {
    constexpr double rounding = 1e-12;
    return factor.value > 0 || factor.high > rounding;
}

std::string half_of(const PointFactor& factor) {
    return reports::to_error(factor.value, std::max(factor.high - factor.value, factor.value - factor.low));
}

/// Tells of points in corners, and of those that face away from everything, which have no line of their own.
void say_what_sees_nothing(const std::vector<std::vector<PointFactor>>& factors) {
    std::size_t blind = 0;
    std::size_t first = 0;
    for (std::size_t point = factors.size(); point-- > 0;) {
        if (std::any_of(factors[point].begin(), factors[point].end(), is_seen)) continue;
        ++blind;
        first = point;
    }
    if (blind == 1) say("note: no face is seen from point {}\n", first + 1);
    if (blind > 1)
        say("note: no face is seen from {} of {} points (the first is point {})\n", blind, factors.size(), first + 1);
}

/// In a closed scene whatever a point sees adds up to 1. @return whether it does
bool adds_up(const Scene& scene, const std::vector<std::vector<PointFactor>>& factors) {
    if (!studies::form_factors::rows_add_up(scene)) return true;
    constexpr double rounding = 1e-6;
    for (std::size_t point = 0; point < factors.size(); ++point) {
        double most = 0;
        for (const PointFactor& factor : factors[point]) most += factor.high;
        if (most >= 1 - rounding) continue;
        say("warning: the factors from point {} add up to {} in a closed scene: it lies outside or within a body, or "
            "faces "
            "out of the scene\n",
            point + 1, most > rounding ? reports::brief(most, 3) : "0");
        return false;
    }
    return true;
}

void print_factors(const Scene& scene, const std::vector<std::vector<PointFactor>>& factors) {
    reports::Table table{"sensors", "", "", reports::columns({">point", "to face", ">factor"})};
    for (std::size_t point = 0; point < std::min(most_shown, factors.size()); ++point) {
        for (std::size_t face = 0; face < scene.faces.size(); ++face) {
            if (!is_seen(factors[point][face])) continue;
            table.rows.push_back({std::to_string(point + 1), scene.faces[face], half_of(factors[point][face])});
        }
    }
    print_folded(reports::text_table(table, style_of_stdout()));
    if (factors.size() > most_shown)
        print_folded("The first {} points, of {}; all are in points.csv of --out.\n", most_shown, factors.size());
}

void write_factors(std::ostream& out, const Scene& scene, const std::vector<Sensor>& sensors,
                   const std::vector<std::vector<PointFactor>>& factors) {
    out << "point,x,y,z,nx,ny,nz,to,factor,low,high\n";
    for (std::size_t point = 0; point < sensors.size(); ++point) {
        std::string place_and_normal;
        for (const double number : sensors[point]) place_and_normal += reports::exact(number) + ",";
        for (std::size_t face = 0; face < scene.faces.size(); ++face) {
            const PointFactor& factor = factors[point][face];
            if (!is_seen(factor)) continue;
            out << fmt::format("{},{}{},{},{},{}\n", point + 1, place_and_normal, reports::csv_field(scene.faces[face]),
                               reports::exact(factor.value), reports::exact(factor.low), reports::exact(factor.high));
        }
    }
}

}  // namespace

ExitCode sensor_factors(const FormFactorsCommand& command) {
    const auto kept = prepare_form_factors(command);
    studies::expect_no_masks(kept.scene);
    const std::vector<Sensor> sensors = read_sensors(command.from);
    const studies::form_factors::PointFactors finder(kept.scene);
    const studies::SceneDoubts doubts = studies::examine_scene(kept.scene);
    if (!command.quiet) {
        for (const std::string& note : doubts.notes) say("note: {}\n", note);
    }
    for (const std::string& fault : doubts.faults) say("warning: {}\n", fault);
    std::optional<OutputFolder> out;
    if (!command.out.empty()) out.emplace(command.out, "points", std::vector<std::string>{"points.csv"});
    std::vector<std::vector<PointFactor>> factors(sensors.size());
    studies::for_each_index(sensors.size(), kept.request.threads, [&](std::uint64_t point) {
        const Sensor& sensor = sensors[point];
        factors[point] = finder.from({sensor[0], sensor[1], sensor[2]}, normal_of(sensor));
    });
    const bool sound = adds_up(kept.scene, factors) && doubts.faults.empty();
    if (!command.quiet) {
        say_what_sees_nothing(factors);
        print_factors(kept.scene, factors);
    }
    if (out) out->write("points.csv", [&](std::ostream& file) { write_factors(file, kept.scene, sensors, factors); });
    return sound ? ExitCode::passed : ExitCode::inconclusive;
}

}  // namespace ff::app
