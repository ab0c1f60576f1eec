#pragma once

#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/readers/printable.hpp"
#include "studies/scene_files/energyplus/input_file.hpp"
#include "studies/scene_files/vs3_surface.hpp"

#include <fmt/format.h>
#include <Eigen/Core>

#include <algorithm>
#include <initializer_list>
#include <map>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace ff::studies {

/// The rules of a file for all geometry, its zones and spaces, and which one is read.
class EnergyPlusZones {
    using Object = energyplus::Object;
    using Vector3d = Eigen::Vector3d;

  public:
    /// @param wanted  name of a zone or space; empty where there is only one zone
    /// @throws UserError where rules are missing, a transformation changes the geometry, or no zone can be chosen
    EnergyPlusZones(std::string_view file, const std::vector<Object>& objects, const std::string& wanted)
        : file_(file) {
        for (const Object& object : objects) {
            if (object.kind->name == "globalgeometryrules") read_rules(object);
            if (object.kind->name == "geometrytransform") expect_no_change(object);
            if (object.kind->name == "zone") read_zone(object);
            if (object.kind->name == "space")
                spaces_.emplace(object.small_text("name"),
                                std::pair(object.text("name"), object.small_text("zone_name")));
        }
        if (zones_.empty()) throw UserError("{}: no zone (nothing would be computed). Add one.", file);
        if (!rules_are_read_)
            throw UserError(
                "{}: no GlobalGeometryRules (it says which side of a surface faces the zone). Add the object.", file);
        choose(wanted, objects);
    }

    /// The zone or space that is read, as the file calls it.
    [[nodiscard]] const std::string& chosen() const { return chosen_; }
    /// The zone that is read, or the zone of the space, in lower case.
    [[nodiscard]] const std::string& zone() const { return zone_; }

    [[nodiscard]] bool is_defined(const std::string& zone) const { return zones_.contains(zone); }
    /// Whether an object of this zone and space is part of what is read. Names are in lower case here and below.
    [[nodiscard]] bool is_chosen(const std::string& zone, const std::string& space) const {
        return space_.empty() ? zone == zone_ : space == space_;
    }
    /// Empty where there is no such space.
    [[nodiscard]] const std::string& zone_of_space(const std::string& space) const {
        static const std::string none;
        const auto found = spaces_.find(space);
        return found == spaces_.end() ? none : found->second.second;
    }

    /// Whether corners are in clockwise order as seen from outside.
    [[nodiscard]] bool is_clockwise() const { return is_clockwise_; }
    /// A place in the coordinates of the zone that is read: only these keep right angles exact.
    /// @param from  zone whose coordinates it is in
    [[nodiscard]] Vector3d moved(const Vector3d& place, const std::string& from) const {
        if (!is_relative_ || from == zone_) return place;
        const Place& own = zones_.at(zone_);
        const Place& other = zones_.at(from);
        return turned_clockwise(place, other.north - own.north) +
               turned_clockwise(other.origin - own.origin, -own.north);
    }

  private:
    /// The position of a zone, where coordinates are relative to it.
    struct Place {
        std::string name;
        Eigen::Vector3d origin = Eigen::Vector3d::Zero();
        double north = 0;  ///< degrees that it is turned by, clockwise from above
    };

    std::string_view file_;
    bool rules_are_read_ = false;
    bool is_clockwise_ = false;
    bool is_relative_ = false;
    std::map<std::string, Place> zones_;                                 ///< zones by name in lower case
    std::map<std::string, std::pair<std::string, std::string>> spaces_;  ///< name, and zone in small letters
    std::string chosen_;
    std::string zone_;
    std::string space_;  ///< empty: the whole zone

    [[nodiscard]] double number_or(double none, const Object& object, std::string_view field) const {
        if (object.text(field).empty()) return none;
        return energyplus::number_of_field(file_, object.fields.find(field)->second, field);
    }

    /// EnergyPlus also accepts these by their first letters.
    void read_rules(const Object& object) {
        rules_are_read_ = true;
        const auto says = [&](std::string_view field, std::initializer_list<std::string_view> beginnings) {
            return std::any_of(
                beginnings.begin(), beginnings.end(),
                [text = object.small_text(field)](std::string_view begin) { return text.starts_with(begin); });
        };
        constexpr std::string_view direction = "vertex_entry_direction", system = "coordinate_system";
        is_clockwise_ = says(direction, {"cl", "cw"});
        if (!is_clockwise_ && !says(direction, {"co", "cc"}))
            energyplus::fail_at(file_, object.line_of(direction),
                                "vertex entry direction '{}' is unknown. Write Counterclockwise or Clockwise.",
                                excerpt(object.text(direction)));
        is_relative_ = says(system, {"r"});
        if (!is_relative_ && !says(system, {"w", "a"}))
            energyplus::fail_at(file_, object.line_of(system),
                                "coordinate system '{}' is unknown. Write World or Relative.",
                                excerpt(object.text(system)));
    }

    void expect_no_change(const Object& transform) const {
        const double now = number_or(1, transform, "current_aspect_ratio");
        const double wanted = number_or(1, transform, "new_aspect_ratio");
        if (now == wanted) return;
        energyplus::fail_at(
            file_, transform.line,
            "GeometryTransform changes the aspect ratio from {} to {} (vertices are taken as they are in the file). "
            "Write the transformed vertices, and remove the object.",
            now, wanted);
    }

    void read_zone(const Object& object) {
        const Place place{
            object.text("name"),
            {number_or(0, object, "x_origin"), number_or(0, object, "y_origin"), number_or(0, object, "z_origin")},
            number_or(0, object, "direction_of_relative_north")};
        if (!zones_.emplace(object.small_text("name"), place).second)
            energyplus::fail_at(file_, object.line,
                                "zone '{}' is defined twice (surfaces could be of either). Rename one.",
                                excerpt(place.name));
    }

    void choose(const std::string& wanted, const std::vector<Object>& objects) {
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
            for (const Object& object : objects) {
                if (object.kind->name == "zone") names.push_back(fmt::format("'{}'", excerpt(object.text("name"))));
            }
            const std::string list = first_names(std::move(names), most_listed);
            throw UserError(wanted.empty() ? fmt::format("{}: {} zones (an enclosure is one of them): {}. Choose by "
                                                         "--zone, or in a study by scene = \"{} zone:{}\".",
                                                         file_, zones_.size(), list, file_, zones_.begin()->second.name)
                                           : fmt::format("{}: no zone or space is called '{}'. Zones are {}.", file_,
                                                         excerpt(wanted), list));
        }
    }

    static Vector3d turned_clockwise(const Vector3d& place, double degrees) {
        const double c = cosine(degrees), s = sine(degrees);
        return {c * place.x() + s * place.y(), c * place.y() - s * place.x(), place.z()};
    }
};

}  // namespace ff::studies
