#pragma once

#include "studies/scene_files/energyplus/input_file.hpp"

#include <Eigen/Core>

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ff::studies {

/// The rules of a file for all geometry, its zones and spaces, and which one is read.
class EnergyPlusZones {
  public:
    /// @param wanted  name of a zone or space; empty where there is only one zone
    /// @throws UserError where rules are missing, a transformation changes the geometry, or no zone can be chosen
    EnergyPlusZones(std::string_view file, const std::vector<energyplus::Object>& objects, const std::string& wanted);

    /// The zone or space that is read, as the file calls it.
    [[nodiscard]] const std::string& chosen() const { return chosen_; }
    /// The zone that is read, or the zone of the space, in lower case.
    [[nodiscard]] const std::string& zone() const { return zone_; }

    [[nodiscard]] bool is_defined(const std::string& zone) const { return zones_.contains(zone); }
    /// Whether an object of this zone and space is part of what is read. Names are in lower case here and below.
    [[nodiscard]] bool is_chosen(const std::string& zone, const std::string& space) const;
    /// Empty where there is no such space.
    [[nodiscard]] const std::string& zone_of_space(const std::string& space) const;

    /// Whether corners are in clockwise order as seen from outside.
    [[nodiscard]] bool is_clockwise() const { return is_clockwise_; }
    /// A place in the coordinates of the zone that is read: only these keep right angles exact.
    /// @param from  zone whose coordinates it is in
    [[nodiscard]] Eigen::Vector3d moved(const Eigen::Vector3d& place, const std::string& from) const;

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

    void read_rules(const energyplus::Object& object);
    void read_zone(const energyplus::Object& object);
    void expect_no_change(const energyplus::Object& transform) const;
    void choose(const std::string& wanted, const std::vector<energyplus::Object>& objects);
    [[nodiscard]] double number_or(double none, const energyplus::Object& object, std::string_view field) const;
};

}  // namespace ff::studies
