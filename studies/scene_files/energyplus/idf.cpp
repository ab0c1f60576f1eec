#include "core/support/error.hpp"
#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/energyplus/input_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies::energyplus {
namespace {

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
                    fmt::format("'{}' is a directive of EP-Macro (macros are not read). Expand them by EP-Macro, and "
                                "take the IDF file that it writes.",
                                excerpt(split_words(line)[0])));
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
        fail_at(file, values[0].line,
                fmt::format("no semicolon ends the object '{}' (the file was cut off). Write it again.",
                            excerpt(values[0].text)));
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
            fail_at(file_, field.line,
                    fmt::format("version '{}' (numbers are wanted). Write Version,9.6;", excerpt(field.text)));
        constexpr unsigned oldest = 300;
        if (*version < oldest)
            fail_at(file_, field.line,
                    fmt::format("version {} (classes had other names before 3.0). Convert it by the transition "
                                "programs of EnergyPlus.",
                                field.text));
        version_ = *version;
    }

    [[nodiscard]] bool has_field(std::string_view name) const {
        if (name == "space_name") return version_ >= 906;
        if (name == "shading_control_name") return version_ < 900;
        return true;
    }

    void add(const Values& values) {
        Object object{class_named(values[0].text), values[0].line, {}, {}};
        if (object.kind == nullptr) return;
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
                    fmt::format("'{}' has {} coordinates ({}). Correct them, or the version: fields moved in 9.0 and "
                                "9.6.",
                                excerpt(object.text("name")), values.size(),
                                version_ == newest ? without_version : "a vertex has three"));
        for (std::size_t k = 0; k < values.size(); k += 3)
            object.vertices.push_back({values[k], values[k + 1], values[k + 2]});
    }
};

}  // namespace

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

}  // namespace ff::studies::energyplus
