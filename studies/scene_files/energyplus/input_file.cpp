#include "studies/scene_files/energyplus/input_file.hpp"

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

namespace ff::studies::energyplus {
namespace {

constexpr std::string_view fields_of_walls =
    "name construction_name zone_name space_name outside_boundary_condition outside_boundary_condition_object "
    "sun_exposure wind_exposure view_factor_to_ground number_of_vertices";

/// Every class that matters for the geometry of zones, in lower case.
constexpr std::array classes{
    Class{"version", "version_identifier"},
    Class{"globalgeometryrules", "starting_vertex_position vertex_entry_direction coordinate_system"},
    Class{"geometrytransform", "plane_of_transform current_aspect_ratio new_aspect_ratio"},
    Class{"zone", "name direction_of_relative_north x_origin y_origin z_origin"},
    Class{"space", "name zone_name"},
    Class{"construction:airboundary", "name"},
    Class{"internalmass", "name construction_name zone_or_zonelist_name"},
    Class{"buildingsurface:detailed",
          "name surface_type construction_name zone_name space_name outside_boundary_condition "
          "outside_boundary_condition_object sun_exposure wind_exposure view_factor_to_ground number_of_vertices",
          Shape::polygon},
    Class{"wall:detailed", fields_of_walls, Shape::polygon},
    Class{"roofceiling:detailed", fields_of_walls, Shape::polygon},
    Class{"floor:detailed", fields_of_walls, Shape::polygon},
    Class{"fenestrationsurface:detailed",
          "name surface_type construction_name building_surface_name outside_boundary_condition_object "
          "view_factor_to_ground shading_control_name frame_and_divider_name multiplier number_of_vertices",
          Shape::polygon},
    Class{"wall:exterior", "name", Shape::rectangle},
    Class{"wall:adiabatic", "name", Shape::rectangle},
    Class{"wall:underground", "name", Shape::rectangle},
    Class{"wall:interzone", "name", Shape::rectangle},
    Class{"roof", "name", Shape::rectangle},
    Class{"ceiling:adiabatic", "name", Shape::rectangle},
    Class{"ceiling:interzone", "name", Shape::rectangle},
    Class{"floor:groundcontact", "name", Shape::rectangle},
    Class{"floor:adiabatic", "name", Shape::rectangle},
    Class{"floor:interzone", "name", Shape::rectangle},
    Class{"window", "name", Shape::rectangle},
    Class{"door", "name", Shape::rectangle},
    Class{"glazeddoor", "name", Shape::rectangle},
    Class{"window:interzone", "name", Shape::rectangle},
    Class{"door:interzone", "name", Shape::rectangle},
    Class{"glazeddoor:interzone", "name", Shape::rectangle},
};

}  // namespace

const std::string& Object::text(std::string_view field) const {
    static const std::string none;
    const auto found = fields.find(field);
    return found == fields.end() ? none : found->second.text;
}

std::uint64_t Object::line_of(std::string_view field) const {
    const auto found = fields.find(field);
    return found == fields.end() ? line : found->second.line;
}

std::string Object::small_text(std::string_view field) const {
    return in_small_letters(text(field));
}

void fail_at(std::string_view file, std::uint64_t line, std::string_view problem) {
    throw UserError(fmt::format("{}:{}: {}", file, line, problem));
}

double number_of_field(std::string_view file, const Field& field, std::string_view what) {
    const auto value = finite_number(field.text);
    if (!value)
        fail_at(file, field.line,
                fmt::format("{} is {}, not a finite number. Correct it.", what,
                            field.text.empty() ? "blank" : fmt::format("'{}'", excerpt(field.text))));
    return *value;
}

const Class* class_named(std::string_view name) {
    const auto* const found =
        std::find_if(classes.begin(), classes.end(),
                     [small = in_small_letters(name)](const Class& one) { return one.name == small; });
    return found == classes.end() ? nullptr : found;
}

}  // namespace ff::studies::energyplus
