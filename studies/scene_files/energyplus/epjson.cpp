#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "studies/readers/json_reader.hpp"
#include "studies/scene_files/energyplus/input_file.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::energyplus {
namespace {

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

std::uint64_t line_of(const JsonValue& value) {
    return static_cast<std::uint64_t>(value.position.line);
}

Field field_of(const JsonValue& value) {
    return {value.kind == JsonValue::Kind::number ? fmt::format("{}", value.number) : value.text, line_of(value)};
}

void expect_object(std::string_view file, const JsonValue& value, std::string_view what) {
    if (value.kind != JsonValue::Kind::object)
        throw UserError(fmt::format("{}:{}: '{}' is no object (names and values are wanted). Write {{}} around them.",
                                    file, line_of(value), excerpt(what)));
}

/// Vertices are a list, or have numbered fields where there are at most four.
std::vector<Vertex> vertices_of(std::string_view file, const JsonValue& fields) {
    std::vector<Vertex> vertices;
    const auto add = [&](const JsonValue& at, const std::string& prefix) {
        Vertex vertex;
        for (std::size_t axis = 0; axis < axes.size(); ++axis) {
            const JsonValue* const value = at.find(fmt::format("{}{}_coordinate", prefix, axes.at(axis)));
            vertex.at(axis) = value == nullptr ? Field{"", line_of(at)} : field_of(*value);
        }
        vertices.push_back(std::move(vertex));
    };
    if (const JsonValue* const list = fields.find("vertices")) {
        for (const JsonValue& vertex : list->items) {
            expect_object(file, vertex, "vertices");
            add(vertex, "vertex_");
        }
    }
    for (int number = 1; fields.find(fmt::format("vertex_{}_x_coordinate", number)) != nullptr; ++number)
        add(fields, fmt::format("vertex_{}_", number));
    return vertices;
}

}  // namespace

std::vector<Object> read_epjson(std::string_view file, std::string_view text) {
    const JsonValue root = parse_json(text, file);
    expect_object(file, root, file);
    std::vector<Object> objects;
    for (std::size_t k = 0; k < root.items.size(); ++k) {
        const Class* const kind = class_named(root.keys[k]);
        if (kind == nullptr) continue;
        const JsonValue& all = root.items[k];
        expect_object(file, all, root.keys[k]);
        for (std::size_t i = 0; i < all.items.size(); ++i) {
            const JsonValue& one = all.items[i];
            expect_object(file, one, all.keys[i]);
            Object object{kind, line_of(one), {}, {}};
            for (std::size_t field = 0; field < one.items.size(); ++field)
                object.fields.emplace(one.keys[field], field_of(one.items[field]));
            object.fields.emplace("name", Field{all.keys[i], object.line});
            if (kind->shape == Shape::polygon) object.vertices = vertices_of(file, one);
            objects.push_back(std::move(object));
        }
    }
    return objects;
}

}  // namespace ff::studies::energyplus
