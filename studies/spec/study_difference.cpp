#include "studies/spec/study_difference.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace ff::studies {
namespace {

struct Entry {
    std::string section;  ///< section as written; of a method, with its name
    std::string key;
    std::string value;
};

/// The keys of a text, values of several lines as one.
std::vector<Entry> entries_of(std::string_view text) {
    std::vector<Entry> entries;
    std::string section;
    for_each_line(text, [&](std::uint64_t, std::string_view line) {
        const std::size_t equals = line.find(" = ");
        if (line.starts_with('[')) {
            section = line;
        } else if (!line.empty() && (line.starts_with(' ') || line == "]") && !entries.empty()) {
            entries.back().value += line.substr(line.find_first_not_of(' '));
        } else if (equals != std::string_view::npos) {
            const std::string_view value = line.substr(equals + 3);
            if (section == "[[method]]") section += fmt::format(" {}", value);  // its name comes first
            entries.push_back({section, std::string(line.substr(0, equals)), std::string(value)});
        }
    });
    return entries;
}

const Entry* find_entry(const std::vector<Entry>& entries, const Entry& wanted) {
    const auto found = std::ranges::find_if(
        entries, [&](const Entry& entry) { return entry.section == wanted.section && entry.key == wanted.key; });
    return found == entries.end() ? nullptr : &*found;
}

/// Calls visit(entry, other) for every key that differs; either is null where its text does not have the key.
template <class Visit>
void for_each_difference(std::string_view first, std::string_view second, const Visit& visit) {
    const std::vector<Entry> entries = entries_of(first);
    const std::vector<Entry> others = entries_of(second);
    for (const Entry& entry : entries) {
        const Entry* other = find_entry(others, entry);
        if (other == nullptr || other->value != entry.value) visit(&entry, other);
    }
    for (const Entry& other : others) {
        if (find_entry(entries, other) == nullptr) visit(nullptr, &other);
    }
}

/// "'seed = 1'"; for long values, the part around a place.
std::string shown(const Entry* entry, std::string_view key, std::size_t place) {
    constexpr std::size_t before = 40;
    constexpr std::size_t most = 100;
    if (entry == nullptr) return fmt::format("no '{}'", key);
    const std::string& value = entry->value;
    const std::size_t begin = value.size() <= most || place <= before ? 0 : place - before;
    return fmt::format("'{} = {}{}{}'", key, begin > 0 ? "..." : "", value.substr(begin, most),
                       begin + most < value.size() ? "..." : "");
}

std::string difference_in_words(const Entry* stored, const Entry* wanted) {
    const Entry& either = stored != nullptr ? *stored : *wanted;
    std::size_t place = 0;
    if (stored != nullptr && wanted != nullptr) {
        const std::size_t length = std::min(stored->value.size(), wanted->value.size());
        while (place < length && stored->value[place] == wanted->value[place]) ++place;
    }
    return fmt::format("{}: {} there, {} here", either.section, shown(stored, either.key, place),
                       shown(wanted, either.key, place));
}

void compare(const std::string& place, const StudySpec& first, const StudySpec& second,
             std::vector<SpecDifference>& out) {
    const auto value = [](const Entry* entry) { return entry == nullptr ? std::string() : entry->value; };
    for_each_difference(to_toml(first), to_toml(second), [&](const Entry* entry, const Entry* other) {
        out.push_back({place, (entry != nullptr ? entry : other)->key, value(entry), value(other)});
    });
}

/// A study of nothing but these methods, without their sizes.
StudySpec without_sizes(StudySpec study, std::vector<Method> methods) {
    for (Method& method : methods) method.sizes.clear();
    study.methods = std::move(methods);
    return study;
}

}  // namespace

std::vector<SpecDifference> differences_of(const StudySpec& first, const StudySpec& second) {
    std::vector<SpecDifference> out;
    compare("study", without_sizes(first, {}), without_sizes(second, {}), out);
    for (const Method& method : first.methods) {
        const auto other = std::ranges::find(second.methods, method.name, &Method::name);
        if (other != second.methods.end())
            compare(method.name, without_sizes({}, {method}), without_sizes({}, {*other}), out);
    }
    return out;
}

std::string first_difference(std::string_view stored, std::string_view wanted) {
    std::string first;
    std::size_t differing = 0;
    for_each_difference(stored, wanted, [&](const Entry* there, const Entry* here) {
        if (++differing == 1) first = difference_in_words(there, here);
    });
    if (differing > 1) first += fmt::format(", and in {} more key{}", differing - 1, differing == 2 ? "" : "s");
    if (differing == 0 && stored != wanted) first = "the order of its methods";
    return first;
}

std::string difference_of_faces(const Scene& a, const Scene& b) {
    if (a.faces.size() != b.faces.size())
        return fmt::format("{} in the first and {} in the second", a.faces.size(), b.faces.size());
    const auto names = std::mismatch(a.faces.begin(), a.faces.end(), b.faces.begin());
    if (names.first != a.faces.end())
        return fmt::format("number {} is '{}' in the first and '{}' in the second", names.first - a.faces.begin() + 1,
                           *names.first, *names.second);
    const auto faces_of = [](const Scene& scene) {
        std::vector<std::pair<int, Shape>> shapes;
        for (const Surface& surface : scene.surfaces) {
            if (surface.face >= 0) shapes.emplace_back(surface.face, surface.shape);
        }
        std::ranges::stable_sort(shapes, {}, &std::pair<int, Shape>::first);
        return shapes;
    };
    const auto in_a = faces_of(a);
    const auto in_b = faces_of(b);
    const auto shapes = std::mismatch(in_a.begin(), in_a.end(), in_b.begin(), in_b.end());
    if (shapes.first == in_a.end() && shapes.second == in_b.end()) return {};
    const int face = std::min(shapes.first == in_a.end() ? shapes.second->first : shapes.first->first,
                              shapes.second == in_b.end() ? shapes.first->first : shapes.second->first);
    return fmt::format("'{}' has another place or shape, or other surfaces", a.faces[static_cast<std::size_t>(face)]);
}

}  // namespace ff::studies
