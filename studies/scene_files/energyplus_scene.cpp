#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/energyplus/input_file.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/vs3_surface.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;
using energyplus::in_small_letters;
using energyplus::Object;

constexpr std::string_view windows_class = "fenestrationsurface:detailed";
/// EnergyPlus names the side in the other zone so, where a file describes a wall between zones once.
constexpr std::string_view prefix_of_other_side = "iz-";

/// Where a zone lies where coordinates are relative to it.
struct ZonePlace {
    std::string name;
    Vector3d origin = Vector3d::Zero();
    double north = 0;  ///< degrees that it is turned by, clockwise from above
};

/// A wall, floor or roof of the zone that is read.
struct ZoneWall {
    const Object* object = nullptr;
    Vs3Surface surface;
    bool is_other_side = false;  ///< described as a surface of the zone behind it
    std::vector<Vs3Surface> windows;
};

Vector3d turned_clockwise(const Vector3d& place, double degrees) {
    const double c = cosine(degrees), s = sine(degrees);
    return {c * place.x() + s * place.y(), c * place.y() - s * place.x(), place.z()};
}

class ZoneReader {
  public:
    ZoneReader(std::string_view name, const std::vector<Object>& objects) : builder_(name), objects_(objects) {
        for (const Object& object : objects) {
            if (object.kind->name == "globalgeometryrules") read_rules(object);
            if (object.kind->name == "zone") read_zone(object);
            if (object.kind->name == "space")
                spaces_.emplace(small(object, "name"), std::pair(object.text("name"), small(object, "zone_name")));
            if (object.kind->name == "construction:airboundary") air_boundaries_.insert(small(object, "name"));
        }
        if (!rules_are_read_)
            throw UserError(
                fmt::format("{}: no GlobalGeometryRules (it says which side of a surface faces the zone). "
                            "Add the object.",
                            name));
        if (zones_.empty()) throw UserError(fmt::format("{}: no zone (nothing would be computed). Add one.", name));
        name_ = name;
    }

    ZoneScene read(const std::string& wanted) {
        choose(wanted);
        for (const Object& object : objects_) read_object(object);
        for (const Object& object : objects_) {
            if (object.kind->name == windows_class) read_window(object);
        }
        for (const ZoneWall& wall : walls_) add(wall);
        remark_on(masses_, "an internal mass has no geometry and is left out",
                  "internal masses have no geometry and are left out");
        remark_on(frames_, "a frame of a window counts as a part of its wall",
                  "frames of windows count as parts of their walls");
        remark_on(openings_,
                  "a surface is an air boundary, which is opaque here; EnergyPlus joins the zones on both sides",
                  "surfaces are air boundaries, which are opaque here; EnergyPlus joins the zones on both sides");
        if (walls_.empty())
            throw UserError(
                fmt::format("{}: zone '{}' has no surface that is read (nothing would be computed). Choose "
                            "another one.",
                            name_, excerpt(chosen_)));
        Scene scene = builder_.finish(true);
        return {std::move(scene), chosen_};
    }

  private:
    std::string name_;
    SceneBuilder builder_;
    const std::vector<Object>& objects_;
    bool rules_are_read_ = false;
    bool is_clockwise_ = false;
    bool is_relative_ = false;
    std::map<std::string, ZonePlace> zones_;                             ///< these and others by name in small letters
    std::map<std::string, std::pair<std::string, std::string>> spaces_;  ///< name, and zone in small letters
    std::set<std::string> air_boundaries_;
    std::string chosen_;  ///< name of the zone or space that is read
    std::string zone_;    ///< it, or that of the space
    std::string space_;   ///< empty: the whole zone
    std::map<std::string, const Object*> surfaces_;
    std::vector<ZoneWall> walls_;
    std::vector<std::uint64_t> masses_, frames_, openings_;  ///< lines

    static std::string small(const Object& object, std::string_view field) {
        return in_small_letters(object.text(field));
    }

    void remark_on(const std::vector<std::uint64_t>& lines, std::string_view one, std::string_view several) {
        if (lines.size() == 1) builder_.remark(fmt::format("{} (line {})", one, lines[0]));
        if (lines.size() > 1)
            builder_.remark(fmt::format("{} {} (the first in line {})", lines.size(), several, lines[0]));
    }

    [[nodiscard]] double number(const energyplus::Field& field, std::string_view what) const {
        const auto value = finite_number(field.text);
        if (!value)
            builder_.fail(field.line,
                          fmt::format("{} is {}, not a finite number. Correct it.", what,
                                      field.text.empty() ? "blank" : fmt::format("'{}'", excerpt(field.text))));
        return *value;
    }

    [[nodiscard]] double number_or_0(const Object& object, std::string_view field) const {
        if (object.text(field).empty()) return 0;
        return number(object.fields.find(field)->second, field);
    }

    /// EnergyPlus knows these by their first letters as well.
    void read_rules(const Object& object) {
        rules_are_read_ = true;
        const auto says = [&](std::string_view field, std::initializer_list<std::string_view> beginnings) {
            return std::any_of(
                beginnings.begin(), beginnings.end(),
                [text = small(object, field)](std::string_view begin) { return text.starts_with(begin); });
        };
        constexpr std::string_view direction = "vertex_entry_direction", system = "coordinate_system";
        is_clockwise_ = says(direction, {"cl", "cw"});
        if (!is_clockwise_ && !says(direction, {"co", "cc"}))
            builder_.fail(object.line_of(direction),
                          fmt::format("vertex entry direction '{}' is unknown. Write Counterclockwise or Clockwise.",
                                      excerpt(object.text(direction))));
        is_relative_ = says(system, {"r"});
        if (!is_relative_ && !says(system, {"w", "a"}))
            builder_.fail(object.line_of(system),
                          fmt::format("coordinate system '{}' is unknown. Write World or Relative.",
                                      excerpt(object.text(system))));
    }

    void read_zone(const Object& object) {
        const ZonePlace place{
            object.text("name"),
            {number_or_0(object, "x_origin"), number_or_0(object, "y_origin"), number_or_0(object, "z_origin")},
            number_or_0(object, "direction_of_relative_north")};
        if (!zones_.emplace(small(object, "name"), place).second)
            builder_.fail(object.line,
                          fmt::format("zone '{}' is defined twice (surfaces could be of either). Rename one.",
                                      excerpt(place.name)));
    }

    void choose(const std::string& wanted) {
        const std::string key = in_small_letters(wanted);
        if (const auto zone = zones_.find(key); zone != zones_.end()) {
            zone_ = key;
            chosen_ = zone->second.name;
        } else if (const auto space = spaces_.find(key);
                   space != spaces_.end() && zones_.contains(space->second.second)) {
            space_ = key;
            std::tie(chosen_, zone_) = space->second;
        } else if (wanted.empty() && zones_.size() == 1) {
            zone_ = zones_.begin()->first;
            chosen_ = zones_.begin()->second.name;
        } else {
            constexpr std::size_t most_listed = 20;
            std::vector<std::string> names;
            for (const Object& object : objects_) {
                if (object.kind->name == "zone") names.push_back(fmt::format("'{}'", excerpt(object.text("name"))));
            }
            const std::size_t zones = names.size();
            names.resize(std::min(zones, most_listed));
            std::string list = fmt::format("{}", fmt::join(names, ", "));
            if (zones > most_listed) list += fmt::format(" and {} more", zones - most_listed);
            throw UserError(
                wanted.empty()
                    ? fmt::format("{}: {} zones (an enclosure is one of them): {}. Choose by --zone, or in a study by "
                                  "scene = \"{} zone:{}\".",
                                  name_, zones, list, name_, zones_.begin()->second.name)
                    : fmt::format("{}: no zone or space is called '{}'. Zones are {}.", name_, excerpt(wanted), list));
        }
    }

    [[nodiscard]] const std::string& zone_of_space(const std::string& space) const {
        static const std::string none;
        const auto found = spaces_.find(space);
        return found == spaces_.end() ? none : found->second.second;
    }

    [[nodiscard]] bool is_chosen(const std::string& zone, const std::string& space) const {
        return space_.empty() ? zone == zone_ : space == space_;
    }

    /// Corners as seen from the inside, in the coordinates of the zone that is read: only these keep right angles
    /// exact.
    /// @param from  zone whose coordinates they are in
    [[nodiscard]] ConvexPolygon corners_of(const Object& object, const std::string& from, bool is_other_side) const {
        const std::string& count = object.text("number_of_vertices");
        const auto announced = finite_number(count);
        const bool is_open = count.empty() || in_small_letters(count).starts_with("auto");
        const std::size_t given = object.vertices.size();
        if (!is_open && (!announced || *announced != static_cast<double>(given)))
            builder_.fail(
                object.line_of("number_of_vertices"),
                fmt::format("'{}' has {} vertices, and '{}' are announced. Correct the number, or the version: "
                            "fields moved in 9.0 and 9.6.",
                            excerpt(object.text("name")), given, excerpt(count)));
        if (given < 3)
            builder_.fail(object.line, fmt::format("'{}' has {} vertices (a surface has three or more). Correct it.",
                                                   excerpt(object.text("name")), given));
        ConvexPolygon corners;
        for (const energyplus::Vertex& vertex : object.vertices) {
            Vector3d place;
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[static_cast<Eigen::Index>(axis)] = number(vertex.at(axis), "a coordinate");
            corners.push_back(place);
        }
        if (is_relative_ && from != zone_) {
            const ZonePlace& own = zones_.at(zone_);
            const ZonePlace& other = zones_.at(from);
            const Vector3d between = turned_clockwise(other.origin - own.origin, -own.north);
            for (Vector3d& corner : corners) corner = turned_clockwise(corner, other.north - own.north) + between;
        }
        if (is_clockwise_ == is_other_side) std::reverse(corners.begin(), corners.end());
        return corners;
    }

    void read_object(const Object& object) {
        const std::string& name = object.text("name");
        if (object.kind->shape == energyplus::Shape::rectangle)
            builder_.fail(object.line,
                          fmt::format("'{}' is of the class {} (only surfaces with vertices are read). Write "
                                      "it as BuildingSurface:Detailed or FenestrationSurface:Detailed.",
                                      excerpt(name), object.kind->name));
        if (object.kind->name == "internalmass" && small(object, "zone_or_zonelist_name") == zone_)
            masses_.push_back(object.line);
        if (object.kind->shape != energyplus::Shape::polygon) return;
        const auto [first, is_new] = surfaces_.emplace(small(object, "name"), &object);
        if (!is_new)
            builder_.fail(
                object.line,
                fmt::format("surface '{}' is defined twice (others could mean either). Rename one.", excerpt(name)));
        if (object.kind->name != windows_class) read_wall(object);
    }

    void read_wall(const Object& object) {
        const std::string zone = small(object, "zone_name");
        if (!zones_.contains(zone))
            builder_.fail(object.line_of("zone_name"),
                          fmt::format("zone '{}' is not defined (a surface belongs to one). "
                                      "Correct the name, or the version: fields moved in 9.6.",
                                      excerpt(object.text("zone_name"))));
        const std::string boundary = small(object, "outside_boundary_condition");
        const std::string behind = small(object, "outside_boundary_condition_object");
        const bool is_own = is_chosen(zone, small(object, "space_name"));
        const bool is_other_side = (boundary == "zone" && is_chosen(behind, {})) ||
                                   (boundary == "space" && is_chosen(zone_of_space(behind), behind));
        if (!is_own && !is_other_side) return;
        if (air_boundaries_.contains(small(object, "construction_name"))) openings_.push_back(object.line);
        const auto put = [&](bool other) {
            Vs3Surface surface;
            surface.line = object.line;
            surface.name = fmt::format("{}{}", other ? prefix_of_other_side : "", object.text("name"));
            surface.corners = corners_of(object, zone, other);
            walls_.push_back({&object, std::move(surface), other, {}});
        };
        if (is_own) put(false);
        if (is_other_side) put(true);
    }

    void read_window(const Object& object) {
        const std::string& name = object.text("name");
        constexpr std::string_view base_field = "building_surface_name", multiplier = "multiplier";
        const auto base = surfaces_.find(small(object, base_field));
        if (base == surfaces_.end() || base->second->kind->name == windows_class)
            builder_.fail(
                object.line_of(base_field),
                fmt::format("'{}' lies on '{}', which is not a wall, floor or roof of this file. Correct the name.",
                            excerpt(name), excerpt(object.text(base_field))));
        for (ZoneWall& wall : walls_) {
            if (wall.object != base->second) continue;
            if (!object.text(multiplier).empty() && number(object.fields.find(multiplier)->second, multiplier) != 1)
                builder_.fail(
                    object.line_of(multiplier),
                    fmt::format("'{}' stands for {} windows (form factors need each at its place). Write them "
                                "one by one.",
                                excerpt(name), excerpt(object.text(multiplier))));
            if (!object.text("frame_and_divider_name").empty()) frames_.push_back(object.line);
            Vs3Surface window;
            window.line = object.line;
            window.name = fmt::format("{}{}", wall.is_other_side ? prefix_of_other_side : "", name);
            window.corners = corners_of(object, small(*wall.object, "zone_name"), wall.is_other_side);
            turn_around(window.corners, wall.surface.normal());
            if (const std::string problem = problem_on_base(window, wall.surface); !problem.empty())
                builder_.fail(object.line, fmt::format("'{}' {} '{}', its base. Correct it.", excerpt(name), problem,
                                                       excerpt(wall.object->text("name"))));
            wall.windows.push_back(std::move(window));
        }
    }

    /// A wall without its windows, and then these, as EnergyPlus orders them.
    void add(const ZoneWall& wall) {
        const Vs3Surface& surface = wall.surface;
        if (!builder_.has_area(surface.corners, surface.line)) return;
        std::vector<const Vs3Surface*> parts;
        for (const Vs3Surface& window : wall.windows) parts.push_back(&window);
        if (parts.empty()) {
            builder_.add_polygon(surface.corners, builder_.new_face(surface.name, surface.line), surface.line);
        } else if (const auto pieces = left_of_base(surface, parts); pieces.empty()) {
            builder_.remark(fmt::format("what lies on '{}' leaves nothing of it; it is no face", surface.name));
        } else {
            const int face = builder_.new_face(surface.name, surface.line);
            for (const ConvexPolygon& piece : pieces) builder_.add_polygon(piece, face, surface.line);
        }
        for (const Vs3Surface& window : wall.windows) {
            if (builder_.has_area(window.corners, window.line))
                builder_.add_polygon(window.corners, builder_.new_face(window.name, window.line), window.line);
        }
    }
};

}  // namespace

ZoneScene read_energyplus_scene(std::string_view name, std::string_view text, const std::string& zone) {
    const auto objects =
        has_extension(name, ".idf") ? energyplus::read_idf(name, text) : energyplus::read_epjson(name, text);
    return ZoneReader(name, objects).read(zone);
}

}  // namespace ff::studies
