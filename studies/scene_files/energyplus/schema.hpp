#pragma once

#include <array>
#include <string_view>

namespace ff::studies::energyplus {

/// What follows the fields of a class: rectangles have an origin and sizes instead of vertices, and are refused.
enum class Shape { none, polygon, rectangle };

/// A class of objects, with the names of its fields in the order of the IDF format.
struct Class {
    std::string_view name;
    std::string_view fields;
    Shape shape = Shape::none;
};

inline constexpr std::string_view fields_of_walls =
    "name construction_name zone_name space_name outside_boundary_condition outside_boundary_condition_object "
    "sun_exposure wind_exposure view_factor_to_ground number_of_vertices";

/// Every class that matters for the geometry of zones, in small letters.
inline constexpr std::array classes{
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

}  // namespace ff::studies::energyplus
