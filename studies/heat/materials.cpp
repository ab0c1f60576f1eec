#include "studies/heat/materials.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/toml_reader.hpp"
#include "studies/scene_files/scene_file.hpp"
#include "studies/scene_files/scene_with_materials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

namespace ff::studies::heat {
namespace {

constexpr double coldest_expected = 150;  // K: below that, degrees Celsius are likely
/// Beyond these, double precision holds no flow.
constexpr double hottest = 1e9;  // K; the coldest but 0 is its inverse
constexpr double least_emissivity = 1e-9;
constexpr double largest = 1e60;  // flux or emission; those below its inverse are 0 or nothing

bool is_held(const std::optional<double>& value, double most = largest) {
    return !value || *value == 0 || (std::abs(*value) <= most && std::abs(*value) >= 1 / most);
}

/// Whether the text is the pattern, in which * stands for any letters.
bool matches(std::string_view pattern, std::string_view text) {
    const auto star = pattern.find('*');
    if (star == std::string_view::npos) return pattern == text;
    if (!text.starts_with(pattern.substr(0, star))) return false;
    for (std::size_t at = star; at <= text.size(); ++at) {
        if (matches(pattern.substr(star + 1), text.substr(at))) return true;
    }
    return false;
}

bool is_emissivity(double value) {
    return value >= least_emissivity && value <= 1;
}

struct Entry {
    std::string name;
    Material material;
};

void expect(bool fine, const TomlReader& reader, std::string_view key, std::string_view problem) {
    if (!fine) reader.fail(key, problem);
}

/// @param may_be_said  emissivities may be given in the scene file
/// @param material  what holds where the table says nothing else
Material read_material(const TomlReader& reader, bool may_be_said, Material material = {}) {
    reader.expect_only({"emissivity", "temperature", "flux", "reflectance", "emission"});
    // A face has one of the two: one that is given replaces the other.
    if (reader.has("temperature") || reader.has("flux")) material.temperature = material.flux = std::nullopt;
    const auto set = [&](std::optional<double>& value, std::string_view key) {
        if (const auto given = reader.optional_number(key)) value = given;
    };
    set(material.emissivity, "emissivity");
    set(material.temperature, "temperature");
    set(material.flux, "flux");
    set(material.reflectance, "reflectance");
    set(material.emission, "emission");
    if (material.is_light()) {
        expect(!material.emissivity && !material.temperature && !material.flux, reader, "reflectance",
               "(light has reflectance and emission, heat emissivity with temperature or flux). Leave one kind out.");
        expect(*material.reflectance >= 0 && *material.reflectance < 1, reader, "reflectance",
               "(from 0 to below 1). Write it like 0.8.");
        expect(!material.emission || *material.emission >= 0, reader, "emission", "(below 0). Write 0 or more.");
        expect(is_held(material.emission), reader, "emission", "(0, or from 1e-60 to 1e60). Correct it.");
        return material;
    }
    expect(material.emissivity.has_value() || may_be_said, reader, "emissivity",
           "(missing; for light give reflectance). Write it like emissivity = 0.8.");
    expect(!material.emission, reader, "emission", "(that of heat follows from the temperature). Leave it out.");
    expect(!material.emissivity || is_emissivity(*material.emissivity), reader, "emissivity",
           material.emissivity.value_or(0) > 1 ? "(from 1e-9 to 1). Write it like 0.8."
                                               : "(from 1e-9 to 1). A mirror is no grey diffuse face; for one that "
                                                 "reflects nearly all write 1e-3.");
    expect(material.temperature.has_value() != material.flux.has_value(), reader, "temperature",
           material.temperature ? "(a face has a temperature or a flux, not both). Leave one out."
                                : "(neither temperature nor flux is given). Give one; flux = 0 is adiabatic.");
    expect(!material.temperature || *material.temperature >= 0, reader, "temperature",
           "(kelvin are never negative; add 273.15 to degrees Celsius). Write it like 293.15.");
    expect(is_held(material.temperature, hottest), reader, "temperature", "(0, or from 1e-9 to 1e9 K). Correct it.");
    expect(is_held(material.flux), reader, "flux", "(0, or from 1e-60 to 1e60 in size). Correct it.");
    return material;
}

void warn_of_cold(std::optional<double> kelvin, std::string_view what, std::vector<std::string>& warnings) {
    if (!kelvin || *kelvin >= coldest_expected || *kelvin == 0) return;
    warnings.push_back(fmt::format("{}: {:g} K is very cold (temperatures are in kelvin; {:g} °C would be {:g} K)",
                                   what, *kelvin, *kelvin, *kelvin + 273.15));
}

/// Reads `[materials]` of a file or a case.
/// @param entries  those of the file, which a case changes or adds to
std::vector<Entry> read_entries(const TomlReader& reader, bool may_be_said, std::vector<Entry> entries = {}) {
    const auto table = reader.optional_table("materials");
    if (!table) return entries;
    for (const std::string& name : table->keys()) {
        if (!table->find(name)->is_table())
            table->fail(name, "(expected the properties of a face). Write it like { emissivity = 0.8, flux = 0 }.");
        const auto changes = table->optional_table(name);
        const auto known = std::ranges::find(entries, name, &Entry::name);
        if (known == entries.end())
            entries.push_back({name, read_material(*changes, may_be_said)});
        else
            known->material = read_material(*changes, may_be_said, known->material);
    }
    return entries;
}

std::optional<double> read_surroundings(const TomlReader& reader, std::optional<double> otherwise = {}) {
    const auto surroundings = reader.optional_number("surroundings");
    if (surroundings && *surroundings < 0) reader.fail("surroundings", "(below 0). Write kelvin, like 293.15.");
    if (!is_held(surroundings)) reader.fail("surroundings", "(0, or from 1e-60 to 1e60). Correct it.");
    return surroundings ? surroundings : otherwise;
}

/// Reads `[groups]`: a pattern, or a list of patterns, for each name.
std::vector<FaceGroup> read_groups(const TomlReader& table, const std::vector<std::string>& faces) {
    const std::vector<std::string_view> known(faces.begin(), faces.end());
    std::vector<FaceGroup> groups;
    for (const std::string& name : table.keys()) {
        FaceGroup& group = groups.emplace_back(FaceGroup{name, {}});
        const std::vector<std::string> patterns = table.texts(name);
        for (const std::string& pattern : patterns) {
            if (std::ranges::none_of(faces, [&](const std::string& face) { return matches(pattern, face); }))
                table.fail(name,
                           fmt::format("(the scene has no face '{}'). {}See 'ffstudy explain SCENE' for its faces.",
                                       pattern, did_you_mean(pattern, known)));
        }
        for (std::size_t face = 0; face < faces.size(); ++face) {
            if (std::ranges::any_of(patterns, [&](const auto& pattern) { return matches(pattern, faces[face]); }))
                group.faces.push_back(face);
        }
    }
    return groups;
}

/// The only one of the entries that is wanted; null where there is none.
/// @throws UserError where there are two
template <class Wanted>
const Entry* only_entry(const std::vector<Entry>& entries, Wanted wanted, const std::string& face,
                        std::string_view origin) {
    const Entry* found = nullptr;
    for (const Entry& entry : entries) {
        if (!wanted(entry.name)) continue;
        if (found != nullptr)
            throw UserError("{}: face '{}' is both '{}' and '{}' (it is not said which). Name the face itself.", origin,
                            face, found->name, entry.name);
        found = &entry;
    }
    return found;
}

/// The entry of a face: that of its own name, otherwise that of its material, otherwise the pattern that either
/// matches.
const Entry* entry_of(std::size_t face, const NamedFaces& faces, const std::vector<Entry>& entries,
                      std::string_view origin) {
    const std::string& name = faces.names[face];
    const std::vector<std::string> materials =
        face < faces.said.size() ? faces.said[face].names : std::vector<std::string>();
    const auto is_material = [&](const auto& fits) { return std::any_of(materials.begin(), materials.end(), fits); };
    if (const Entry* own = only_entry(
            entries, [&](const auto& entry) { return entry == name; }, name, origin))
        return own;
    if (const Entry* by_material = only_entry(
            entries, [&](const auto& entry) { return is_material([&](const auto& one) { return entry == one; }); },
            name, origin)) {
        if (materials.size() == 1) return by_material;
        throw UserError(
            "{}: face '{}' has the materials '{}' (a face has one). Take --faces material, or "
            "name the face itself.",
            origin, name, fmt::join(materials, "', '"));
    }
    return only_entry(
        entries,
        [&](const auto& entry) {
            return matches(entry, name) || is_material([&](const auto& one) { return matches(entry, one); });
        },
        name, origin);
}

/// Fills in what the scene file says about a face. @throws UserError where it says nothing usable
void complete(Material& material, std::size_t face, const NamedFaces& faces, std::string_view origin) {
    if (material.is_light() || material.emissivity) return;
    const std::string& name = faces.names[face];
    material.emissivity = said_emissivity(faces.said, face);
    if (!material.emissivity)
        throw UserError(
            "{}: face '{}' has no emissivity (the scene file gives {}). Write it like "
            "emissivity = 0.8.",
            origin, name,
            face < faces.said.size() && !faces.said[face].emissivities.empty() ? "its surfaces different ones"
                                                                               : "none");
    if (!is_emissivity(*material.emissivity))
        throw UserError(
            "{}: face '{}' has the emissivity {} of the scene file (from 1e-9 to 1 is "
            "needed). Write it like emissivity = 0.8.",
            origin, name, *material.emissivity);
}

void expect_used(const std::vector<Entry>& entries, const NamedFaces& faces, std::string_view origin) {
    std::vector<std::string_view> known(faces.names.begin(), faces.names.end());
    for (const FaceMaterial& material : faces.said)
        known.insert(known.end(), material.names.begin(), material.names.end());
    for (const Entry& entry : entries) {
        if (std::any_of(known.begin(), known.end(), [&](std::string_view name) { return matches(entry.name, name); }))
            continue;
        throw UserError("{}: the scene has no face '{}'. {}See 'ffstudy explain SCENE' for its faces.", origin,
                        entry.name, did_you_mean(entry.name, known));
    }
}

}  // namespace

std::optional<double> said_emissivity(const std::vector<FaceMaterial>& said, std::size_t face) {
    if (face >= said.size() || said[face].emissivities.size() != 1) return std::nullopt;
    return said[face].emissivities.front();
}

std::vector<std::optional<double>> said_emissivities(const SceneSource& source, std::size_t faces) {
    const std::vector<FaceMaterial> said = make_scene_with_materials(source).materials;
    std::vector<std::optional<double>> all(faces);
    for (std::size_t face = 0; face < faces; ++face) all[face] = said_emissivity(said, face);
    return all;
}

namespace {

/// Gives each face its entry.
/// @param materials  without faces and groups
Materials settle(Materials materials, const std::vector<Entry>& entries, std::string_view origin,
                 const NamedFaces& faces) {
    expect_used(entries, faces, origin);
    for (std::size_t i = 0; i < faces.names.size(); ++i) {
        const std::string& face = faces.names[i];
        const Entry* entry = entry_of(i, faces, entries, origin);
        if (entry == nullptr)
            throw UserError("{}: face '{}' has no material. Add it, or a pattern like \"*\".", origin, face);
        complete(materials.faces.emplace_back(entry->material), i, faces, origin);
        if (entry->material.is_light() != materials.are_light())
            throw UserError(
                "{}: face '{}' is of light and '{}' of heat (one system has one kind). Give all "
                "faces the same.",
                origin, materials.are_light() ? faces.names.front() : face,
                materials.are_light() ? face : faces.names.front());
        auto group = std::ranges::find(materials.groups, entry->name, &FaceGroup::name);
        if (group == materials.groups.end()) group = materials.groups.insert(group, FaceGroup{entry->name, {}});
        group->faces.push_back(i);
    }
    if (!materials.are_light()) {
        for (const Entry& entry : entries) warn_of_cold(entry.material.temperature, entry.name, materials.warnings);
        warn_of_cold(materials.surroundings, "surroundings", materials.warnings);
    }
    return materials;
}

}  // namespace

std::vector<Materials> read_cases(std::string_view toml, std::string_view origin, const NamedFaces& faces) {
    const auto table = parse_toml(toml, origin, "docs/heat.md");
    const TomlReader file(table, origin);
    file.expect_only({"surroundings", "materials", "groups", "case"});
    if (!file.has("materials"))
        file.fail("materials", "(missing). Write [materials] and below it: wall = { emissivity = 0.8, flux = 0 }.");
    const bool may_be_said = std::any_of(faces.said.begin(), faces.said.end(),
                                         [](const FaceMaterial& said) { return !said.emissivities.empty(); });
    const std::vector<Entry> entries = read_entries(file, may_be_said);
    const std::optional<double> surroundings = read_surroundings(file);
    std::vector<Materials> cases;
    const auto add = [&](std::string name, std::optional<double> around, const std::vector<Entry>& materials) {
        Materials& made = cases.emplace_back();
        made.name = std::move(name);
        made.surroundings = around;
        made = settle(std::move(made), materials, origin, faces);
        if (const auto groups = file.optional_table("groups")) {
            made.groups = read_groups(*groups, faces.names);
            made.has_named_groups = true;
        }
    };
    for (const TomlReader& one : file.tables("case")) {
        one.expect_only({"name", "surroundings", "materials"});
        const std::string name = one.text("name");
        if (name.empty() || std::ranges::find(cases, name, &Materials::name) != cases.end())
            one.fail("name", name.empty() ? "(empty). Name the case." : "(two cases have this name). Rename one.");
        add(name, read_surroundings(one, surroundings), read_entries(one, may_be_said, entries));
    }
    if (cases.empty()) add("", surroundings, entries);
    return cases;
}

}  // namespace ff::studies::heat
