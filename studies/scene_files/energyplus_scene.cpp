#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/energyplus/input_file.hpp"
#include "studies/scene_files/energyplus_zones.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/vs3_surface.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;
using energyplus::Object;

constexpr std::string_view windows_class = "fenestrationsurface:detailed";
/// EnergyPlus gives the side in the other zone this name, where a file describes a wall between zones only once.
constexpr std::string_view prefix_of_other_side = "iz-";
/// A window that is farther from its wall than this, however large the wall is, may be meant to be there. Files are in
/// metres.
constexpr double most_metres_off = 0.01;

/// A wall, floor or roof of the zone that is read.
struct ZoneWall {
    const Object* object = nullptr;
    Vs3Surface surface;
    bool is_other_side = false;  ///< described as a surface of the zone behind it
    std::vector<Vs3Surface> windows;
};

class ZoneReader {
  public:
    ZoneReader(std::string_view name, const std::vector<Object>& objects, const std::string& wanted)
        : name_(name),
          builder_(name),
          objects_(objects),
          zones_(name, objects, wanted),
          lacks_version_(has_extension(name, ".idf")) {
        for (const Object& object : objects) {
            if (object.kind->name == "construction:airboundary") air_boundaries_.insert(object.small_text("name"));
            if (object.kind->name == "version") lacks_version_ = false;
        }
    }

    ZoneScene read() {
        for (const Object& object : objects_) read_object(object);
        for (const Object& object : objects_) {
            if (object.kind->name == windows_class) read_window(object);
        }
        for (const ZoneWall& wall : walls_) add(wall);
        remark_on_what_differs();
        if (walls_.empty())
            throw UserError(
                "{}: zone '{}' has no surface that is read (nothing would be computed). Choose another one.", name_,
                excerpt(zones_.chosen()));
        Scene scene = builder_.finish(true);
        return {std::move(scene), zones_.chosen()};
    }

  private:
    std::string name_;
    SceneBuilder builder_;
    const std::vector<Object>& objects_;
    EnergyPlusZones zones_;
    bool lacks_version_ = false;  ///< fields of an IDF file depend on it
    std::set<std::string> air_boundaries_;
    std::map<std::string, const Object*> surfaces_;
    std::vector<ZoneWall> walls_;
    std::vector<std::uint64_t> masses_, frames_, openings_, fitted_;  ///< lines
    double most_fitted_ = 0;                                          ///< how far off its wall a window was at most

    void remark_on(const std::vector<std::uint64_t>& lines, std::string_view one, std::string_view several) {
        if (lines.size() == 1) builder_.remark("{} (line {})", one, lines[0]);
        if (lines.size() > 1) builder_.remark("{} {} (the first in line {})", lines.size(), several, lines[0]);
    }

    void remark_on_what_differs() {
        if (lacks_version_) builder_.remark(std::string(energyplus::without_version));
        remark_on(masses_, "an internal mass has no geometry and is left out",
                  "internal masses have no geometry and are left out");
        remark_on(frames_, "a frame of a window counts as a part of its wall",
                  "frames of windows count as parts of their walls");
        remark_on(openings_,
                  "a surface is an air boundary, which is opaque here; EnergyPlus joins the zones on both sides",
                  "surfaces are air boundaries, which are opaque here; EnergyPlus joins the zones on both sides");
        remark_on(
            fitted_,
            fmt::format("a window or door is {:.2g} off its wall, and is put into its plane and outline", most_fitted_),
            fmt::format(
                "windows and doors are up to {:.2g} off their walls, and are put into their planes and outlines",
                most_fitted_));
    }

    /// Corners as seen from the inside, in the coordinates of the zone that is read.
    /// @param from  zone whose coordinates they are in
    [[nodiscard]] ConvexPolygon corners_of(const Object& object, const std::string& from, bool is_other_side) const {
        const std::string& count = object.text("number_of_vertices");
        const auto announced = finite_number(count);
        const bool is_open = count.empty() || in_small_letters(count).starts_with("auto");
        const std::size_t given = object.vertices.size();
        if (!is_open && (!announced || *announced != static_cast<double>(given)))
            builder_.fail(object.line_of("number_of_vertices"),
                          "'{}' has {} vertices, and '{}' are announced{}. Correct the number, or the version: fields "
                          "moved in 9.0 and 9.6.",
                          excerpt(object.text("name")), given, excerpt(count), version_in_brackets());
        if (given < 3)
            builder_.fail(object.line, "'{}' has {} vertices (a surface has three or more). Correct it.",
                          excerpt(object.text("name")), given);
        ConvexPolygon corners;
        for (const energyplus::Vertex& vertex : object.vertices) {
            Vector3d place;
            for (std::size_t axis = 0; axis < 3; ++axis)
                place[static_cast<Eigen::Index>(axis)] =
                    energyplus::number_of_field(name_, vertex.at(axis), "a coordinate");
            corners.push_back(zones_.moved(place, from));
        }
        if (zones_.is_clockwise() == is_other_side) std::reverse(corners.begin(), corners.end());
        return corners;
    }

    /// @param from  zone whose coordinates its corners are in
    [[nodiscard]] Vs3Surface surface_of(const Object& object, const std::string& from, bool is_other_side) const {
        Vs3Surface surface;
        surface.line = object.line;
        surface.name = fmt::format("{}{}", is_other_side ? prefix_of_other_side : "", object.text("name"));
        surface.corners = corners_of(object, from, is_other_side);
        return surface;
    }

    /// An addition to a message for the case that fields were misinterpreted.
    [[nodiscard]] std::string version_in_brackets() const {
        return lacks_version_ ? fmt::format(" ({})", energyplus::without_version) : std::string();
    }

    void read_object(const Object& object) {
        const std::string& name = object.text("name");
        if (object.kind->shape == energyplus::Shape::rectangle)
            builder_.fail(object.line,
                          "'{}' is of the class {} (only surfaces with vertices are read). Write it as "
                          "BuildingSurface:Detailed or FenestrationSurface:Detailed.",
                          excerpt(name), object.kind->name);
        if (object.kind->name == "internalmass" && object.small_text("zone_or_zonelist_name") == zones_.zone())
            masses_.push_back(object.line);
        if (object.kind->shape != energyplus::Shape::polygon) return;
        const auto [first, is_new] = surfaces_.emplace(object.small_text("name"), &object);
        if (!is_new)
            builder_.fail(object.line, "surface '{}' is defined twice (others could mean either). Rename one.",
                          excerpt(name));
        if (object.kind->name != windows_class) read_wall(object);
    }

    void read_wall(const Object& object) {
        const std::string zone = object.small_text("zone_name");
        if (!zones_.is_defined(zone))
            builder_.fail(object.line_of("zone_name"),
                          "zone '{}' is not defined{}. Correct the name, or the version: fields moved in 9.6.",
                          excerpt(object.text("zone_name")), version_in_brackets());
        const std::string boundary = object.small_text("outside_boundary_condition");
        const std::string behind = object.small_text("outside_boundary_condition_object");
        const bool is_own = zones_.is_chosen(zone, object.small_text("space_name"));
        const bool is_other_side = (boundary == "zone" && zones_.is_chosen(behind, {})) ||
                                   (boundary == "space" && zones_.is_chosen(zones_.zone_of_space(behind), behind));
        if (!is_own && !is_other_side) return;
        if (air_boundaries_.contains(object.small_text("construction_name"))) openings_.push_back(object.line);
        if (is_own) walls_.push_back({&object, surface_of(object, zone, false), false, {}});
        if (is_other_side) walls_.push_back({&object, surface_of(object, zone, true), true, {}});
    }

    void read_window(const Object& object) {
        const std::string& name = object.text("name");
        constexpr std::string_view base_field = "building_surface_name", multiplier = "multiplier";
        const auto base = surfaces_.find(object.small_text(base_field));
        if (base == surfaces_.end() || base->second->kind->name == windows_class)
            builder_.fail(object.line_of(base_field),
                          "'{}' lies on '{}', which is not a wall, floor or roof of this file. Correct the name.",
                          excerpt(name), excerpt(object.text(base_field)));
        for (ZoneWall& wall : walls_) {
            if (wall.object != base->second) continue;
            if (!object.text(multiplier).empty() &&
                energyplus::number_of_field(name_, object.fields.find(multiplier)->second, multiplier) != 1)
                builder_.fail(
                    object.line_of(multiplier),
                    "'{}' stands for {} windows (form factors need each at its place). Write them one by one.",
                    excerpt(name), excerpt(object.text(multiplier)));
            if (!object.text("frame_and_divider_name").empty()) frames_.push_back(object.line);
            Vs3Surface window = surface_of(object, wall.object->small_text("zone_name"), wall.is_other_side);
            turn_around(window.corners, wall.surface.normal());
            const double most_off = std::min(most_off_base * size_of(wall.surface.corners), most_metres_off);
            const FitOnBase fit = fit_on_base(window, wall.surface, most_off);
            if (!fit.problem.empty())
                builder_.fail(object.line, "'{}' {} '{}', its base{}. Correct it.", excerpt(name), fit.problem,
                              excerpt(wall.object->text("name")), fit.reason);
            if (fit.off > 0) fitted_.push_back(object.line);
            most_fitted_ = std::max(most_fitted_, fit.off);
            wall.windows.push_back(std::move(window));
        }
    }

    /// Adds a wall without its windows, and then these, in the order of EnergyPlus.
    void add(const ZoneWall& wall) {
        const Vs3Surface& surface = wall.surface;
        if (!builder_.has_area(surface.corners, surface.line)) return;
        std::vector<const Vs3Surface*> parts;
        for (const Vs3Surface& window : wall.windows) parts.push_back(&window);
        if (const auto pieces = left_of_base(surface, parts); pieces.empty()) {
            builder_.remark("what lies on '{}' leaves nothing of it; it is no face", surface.name);
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
    return ZoneReader(name, objects, zone).read();
}

}  // namespace ff::studies
