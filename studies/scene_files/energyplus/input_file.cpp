#include "studies/scene_files/energyplus/input_file.hpp"

#include "core/support/excerpt.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "studies/readers/json_reader.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>

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

/// The class of that name, in upper or lower case; null for one that does not matter here.
const Class* class_named(std::string_view name) {
    const auto* const found =
        std::find_if(classes.begin(), classes.end(),
                     [small = in_small_letters(name)](const Class& one) { return one.name == small; });
    return found == classes.end() ? nullptr : found;
}

/// A class whose name is nearly that of one with geometry is meant to be that. (Pipe:Adiabatic is another.)
/// @throws UserError
void expect_no_misspelling(std::string_view file, std::uint64_t line, std::string_view name) {
    std::vector<std::string_view> names;
    for (const Class& one : classes) {
        if (one.shape != Shape::none && one.name.substr(0, 4) == in_small_letters(name.substr(0, 4)))
            names.push_back(one.name);
    }
    const std::string hint = did_you_mean(name, names);
    if (!hint.empty()) fail_at(file, line, "class '{}' is unknown. {}", excerpt(name), trimmed(hint));
}

/// The values of an object, its class first.
using Values = std::vector<Field>;

constexpr std::string_view macro_mark = "##";

/// Calls visit(values) for each object of a file.
template <class Visit>
void for_each_object(std::string_view file, std::string_view text, const Visit& visit) {
    Values values;
    std::string value;
    for_each_line(text, [&](std::uint64_t number, std::string_view line) {
        line = line.substr(0, line.find('!'));
        if (trimmed(line).starts_with(macro_mark))
            fail_at(file, number,
                    "'{}' is a directive of EP-Macro (macros are not read). Expand them by EP-Macro, and take the IDF "
                    "file that it writes.",
                    excerpt(split_words(line)[0]));
        for (std::size_t end = line.find_first_of(",;"); end != std::string_view::npos;
             end = line.find_first_of(",;")) {
            value += line.substr(0, end);
            values.push_back({std::string(trimmed(value)), number});
            value.clear();
            if (line[end] == ';') visit(std::exchange(values, {}));
            line.remove_prefix(end + 1);
        }
        if (!trimmed(line).empty()) value += std::string(line) + ' ';
    });
    if (!trimmed(value).empty()) values.push_back({std::string(trimmed(value)), values.empty() ? 1 : values[0].line});
    if (!values.empty())
        fail_at(file, values[0].line, "no semicolon ends the object '{}' (the file was cut off). Write it again.",
                excerpt(values[0].text));
}

/// Major and minor number, such as 906 for 9.6. @return empty where the text is not a version
std::optional<unsigned> version_number(std::string_view text) {
    const auto parts = split_at('.', text);
    const auto major = parse_number<unsigned>(parts[0]);
    const auto minor = parts.size() > 1 ? parse_number<unsigned>(parts[1]) : std::optional(0U);
    if (!major || !minor || *major > 999 || *minor > 99) return std::nullopt;
    return *major * 100 + *minor;
}

class IdfReader {
  public:
    IdfReader(std::string_view file, std::string_view text) : file_(file) {
        for_each_object(file, text, [&](const Values& values) {
            if (in_small_letters(values[0].text) == "version" && values.size() > 1) read_version(values[1]);
        });
        for_each_object(file, text, [&](const Values& values) { add(values); });
    }

    std::vector<Object> objects() && { return std::move(objects_); }

  private:
    std::string_view file_;
    static constexpr unsigned newest = 9999;
    unsigned version_ = newest;
    std::vector<Object> objects_;

    void read_version(const Field& field) {
        const auto version = version_number(field.text);
        if (!version)
            fail_at(file_, field.line, "version '{}' (numbers are wanted). Write Version,9.6;", excerpt(field.text));
        constexpr unsigned oldest = 300;
        if (*version < oldest)
            fail_at(
                file_, field.line,
                "version {} (classes had other names before 3.0). Convert it by the transition programs of EnergyPlus.",
                field.text);
        version_ = *version;
    }

    [[nodiscard]] bool has_field(std::string_view name) const {
        if (name == "space_name") return version_ >= 906;
        if (name == "shading_control_name") return version_ < 900;
        return true;
    }

    void add(const Values& values) {
        Object object{class_named(values[0].text), values[0].line, {}, {}};
        if (object.kind == nullptr) return expect_no_misspelling(file_, values[0].line, values[0].text);
        std::size_t at = 1;
        for (const std::string_view name : split_words(object.kind->fields)) {
            if (!has_field(name)) continue;
            if (at == values.size()) break;
            object.fields.emplace(name, values[at++]);
        }
        if (object.kind->shape == Shape::polygon)
            add_vertices(object, {values.begin() + static_cast<std::ptrdiff_t>(at), values.end()});
        objects_.push_back(std::move(object));
    }

    void add_vertices(Object& object, Values values) const {
        const auto is_blank = [](const Field& value) { return value.text.empty(); };
        while (values.size() % 3 == 0 && !values.empty() && std::all_of(values.end() - 3, values.end(), is_blank))
            values.resize(values.size() - 3);
        if (values.size() % 3 != 0)
            fail_at(file_, object.line,
                    "'{}' has {} coordinates ({}). Correct them, or the version: fields moved in 9.0 and 9.6.",
                    excerpt(object.text("name")), values.size(),
                    version_ == newest ? without_version : "a vertex has three");
        for (std::size_t k = 0; k < values.size(); k += 3)
            object.vertices.push_back({values[k], values[k + 1], values[k + 2]});
    }
};

constexpr std::array<std::string_view, 3> axes{"x", "y", "z"};

std::uint64_t line_of(const JsonValue& value) {
    return static_cast<std::uint64_t>(value.position.line);
}

Field field_of(const JsonValue& value) {
    return {value.kind == JsonValue::Kind::number ? fmt::format("{}", value.number) : value.text, line_of(value)};
}

void expect_object(std::string_view file, const JsonValue& value, std::string_view what) {
    if (value.kind != JsonValue::Kind::object)
        fail_at(file, line_of(value), "'{}' is no object (names and values are wanted). Write {{}} around them.",
                excerpt(what));
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

double number_of_field(std::string_view file, const Field& field, std::string_view what) {
    const auto value = finite_number(field.text);
    if (!value)
        fail_at(file, field.line, "{} is {}, not a finite number. Correct it.", what,
                field.text.empty() ? "blank" : fmt::format("'{}'", excerpt(field.text)));
    return *value;
}

std::string with_ascii_comments(std::string bytes) {
    bool is_comment = false;
    for (char& byte : bytes) {
        is_comment = byte != '\n' && (is_comment || byte == '!');
        if (is_comment && static_cast<unsigned char>(byte) > 0x7f) byte = '?';
    }
    return bytes;
}

std::vector<Object> read_idf(std::string_view file, std::string_view text) {
    return IdfReader(file, text).objects();
}

std::vector<Object> read_epjson(std::string_view file, std::string_view text) {
    const JsonValue root = parse_json(text, file);
    expect_object(file, root, file);
    std::vector<Object> objects;
    for (std::size_t k = 0; k < root.items.size(); ++k) {
        const Class* const kind = class_named(root.keys[k]);
        if (kind == nullptr) expect_no_misspelling(file, line_of(root.items[k]), root.keys[k]);
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
