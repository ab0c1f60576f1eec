#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/meshes/formats.hpp"
#include "studies/scene_files/meshes/mesh_input.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

// The format: https://paulbourke.net/dataformats/ply/

namespace ff::studies::meshes {
namespace {

using PlyEncoding = std::pair<std::string_view, Encoding>;
constexpr std::array ply_encodings{PlyEncoding{"ascii", Encoding::text},
                                   PlyEncoding{"binary_little_endian", Encoding::little_endian},
                                   PlyEncoding{"binary_big_endian", Encoding::big_endian}};

struct Property {
    std::string name;
    NumberType type;
    std::optional<NumberType> count_type;  ///< type of the length of a list; empty: a single number

    [[nodiscard]] bool holds_corners() const {
        return count_type && (name == "vertex_indices" || name == "vertex_index");
    }
};

struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;

    [[nodiscard]] bool is_strips() const { return name == "tristrips"; }
    [[nodiscard]] bool has_polygons() const { return name == "face" || is_strips(); }
};

class PlyReader {
  public:
    PlyReader(std::string_view file, std::string_view bytes) : in_(file, bytes), mesh_(file) {}

    SurfaceMesh read() && {
        read_header();
        for (const Element& element : elements_) read_element(element);
        in_.set_section("");
        if (!in_.at_end())
            in_.fail("more follows than its header announces (a number in the header is wrong). Write it again.");
        std::size_t begin = 0;
        for (std::size_t i = 0; i < ends_.size(); begin = ends_[i++])
            mesh_.add_polygon(unnamed_group, std::span(corners_).subspan(begin, ends_[i] - begin),
                              fmt::format("polygon {}", i));
        return std::move(mesh_);
    }

  private:
    MeshInput in_;
    SurfaceMesh mesh_;
    std::vector<Element> elements_;
    std::uint64_t vertices_ = 0;
    // Polygons wait here for points that may follow them.
    std::vector<std::int64_t> corners_;
    std::vector<std::size_t> ends_;  ///< where each polygon ends in `corners_`

    void read_header() {
        in_.set_section("header");
        if (const auto mark = in_.word(); mark != "ply")
            in_.fail("'{}' stands where 'ply' is expected. Write it again.", excerpt(mark));
        const Encoding* encoding = nullptr;
        for (std::string_view keyword = in_.word(); keyword != "end_header"; keyword = in_.word()) {
            if (keyword == "format") {
                const std::string_view name = in_.word();
                const auto* const known = std::ranges::find(ply_encodings, name, &PlyEncoding::first);
                if (known == ply_encodings.end())
                    in_.fail("format '{}' is not known. Write it as ascii.", excerpt(name));
                encoding = &known->second;
            } else if (keyword == "element") {
                Element& element = elements_.emplace_back();
                element.name = in_.word();
                element.count = in_.count();
                if (element.name == "vertex") vertices_ += element.count;
            } else if (keyword == "property" && !elements_.empty()) {
                elements_.back().properties.push_back(announced_property());
            } else if (keyword != "comment" && keyword != "obj_info") {
                in_.fail("'{}' is no line of a header. Write it again.", excerpt(keyword));
            }
            in_.line();
        }
        if (encoding == nullptr) in_.fail("no line tells the format. Write 'format ascii 1.0'.");
        in_.line();
        in_.set_encoding(*encoding);
    }

    Property announced_property() {
        Property property;
        std::string_view first = in_.word();
        if (first == "list") {
            property.count_type = type(in_.word());
            first = in_.word();
        }
        property.type = type(first);
        property.name = in_.word();
        return property;
    }

    NumberType type(std::string_view name) const {
        const auto known = number_type_named(name, &NumberTypeNames::ply);
        if (!known) in_.fail("numbers of type '{}' are not known. Write it again.", excerpt(name));
        return *known;
    }

    void read_element(const Element& element) {
        in_.set_section("element " + element.name);
        if (element.count == 0) return;
        expect_properties(element);
        std::size_t bytes = 0;
        for (const Property& property : element.properties) bytes += property.count_type.value_or(property.type).bytes;
        // Elements without properties take no bytes, however many there are.
        if (bytes == 0) return;
        in_.expect_room(element.count, in_.encoding() == Encoding::text ? element.properties.size() : 1, bytes);
        for (std::uint64_t i = 0; i < element.count; ++i) {
            Eigen::Vector3d point = Eigen::Vector3d::Zero();
            for (const Property& property : element.properties) read_property(element, property, point);
            if (element.name == "vertex") mesh_.add_point(point);
        }
    }

    void expect_properties(const Element& element) const {
        const auto& all = element.properties;
        for (const char axis : std::string_view(element.name == "vertex" ? "xyz" : "")) {
            if (std::none_of(all.begin(), all.end(), [&](const auto& property) { return is_axis(property, axis); }))
                in_.fail("no property {} is announced. Write vertices with x, y and z.", axis);
        }
        if (element.has_polygons() &&
            std::none_of(all.begin(), all.end(), [](const auto& property) { return property.holds_corners(); }))
            in_.fail("no list 'vertex_indices' is announced. Write polygons with it.");
    }

    static bool is_axis(const Property& property, char axis) {
        return !property.count_type && property.name == std::string_view(&axis, 1);
    }

    void read_property(const Element& element, const Property& property, Eigen::Vector3d& point) {
        if (property.count_type) {
            const std::int64_t count = in_.whole(*property.count_type);
            if (count < 0) in_.fail("a list has {} numbers. Correct it.", count);
            const auto size = static_cast<std::uint64_t>(count);
            if (!element.has_polygons() || !property.holds_corners()) return in_.skip(property.type, size, 1);
            const auto corners = in_.wholes(property.type, size, 1);
            return element.is_strips() ? add_strips(corners) : add_polygon(corners);
        }
        for (Eigen::Index axis = 0; axis < 3 && element.name == "vertex"; ++axis) {
            if (!is_axis(property, "xyz"[axis])) continue;
            point[axis] = in_.coordinate(property.type);
            return;
        }
        in_.skip(property.type, 1, 1);
    }

    /// Points and lines are polygons of one and two corners, and are left out.
    void add_polygon(std::span<const std::int64_t> corners) {
        for (const std::int64_t corner : corners) in_.expect_index(corner, vertices_);
        if (corners.size() < 3) return;
        corners_.insert(corners_.end(), corners.begin(), corners.end());
        ends_.push_back(corners_.size());
    }

    /// Strips end at -1. Every second triangle of a strip has its corners the other way round.
    void add_strips(std::span<const std::int64_t> points) {
        std::size_t begin = 0;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (points[i] == -1) {
                begin = i + 1;
                continue;
            }
            in_.expect_index(points[i], vertices_);
            if (i < begin + 2) continue;
            const std::size_t odd = (i - begin) % 2;
            add_polygon(std::array{points[i - 2], points[i - 1 + odd], points[i - odd]});
        }
    }
};

}  // namespace

SurfaceMesh read_ply(std::string_view file, std::string_view bytes) {
    return PlyReader(file, bytes).read();
}

}  // namespace ff::studies::meshes
