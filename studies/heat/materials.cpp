#include "studies/heat/materials.hpp"

#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "studies/readers/text_file.hpp"
#include "studies/readers/toml_reader.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace ff::studies {
namespace {

constexpr double coldest_expected = 150;  // K: below that, degrees Celsius are likely
constexpr std::array<std::string_view, 5> keys{"emissivity", "temperature", "flux", "reflectance", "emission"};

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

struct Entry {
    std::string name;
    Material material;
};

void expect(bool fine, const TomlReader& reader, std::string_view key, std::string_view problem) {
    if (!fine) reader.fail(key, problem);
}

Material read_material(const TomlReader& reader) {
    reader.expect_only(keys);
    Material material{reader.optional_number("emissivity"), reader.optional_number("temperature"),
                      reader.optional_number("flux"), reader.optional_number("reflectance"),
                      reader.optional_number("emission")};
    if (material.is_light()) {
        expect(!material.emissivity && !material.temperature && !material.flux, reader, "reflectance",
               "(light has reflectance and emission, heat emissivity with temperature or flux). Leave one kind out.");
        expect(*material.reflectance >= 0 && *material.reflectance < 1, reader, "reflectance",
               "(from 0 to below 1). Write it like 0.8.");
        expect(!material.emission || *material.emission >= 0, reader, "emission", "(below 0). Write 0 or more.");
        return material;
    }
    expect(material.emissivity.has_value(), reader, "emissivity",
           "(missing; for light give reflectance). Write it like emissivity = 0.8.");
    expect(!material.emission, reader, "emission", "(that of heat follows from the temperature). Leave it out.");
    expect(*material.emissivity > 0 && *material.emissivity <= 1, reader, "emissivity",
           "(above 0, at most 1). A mirror is no grey diffuse face; for one that reflects nearly all write 1e-3.");
    expect(material.temperature.has_value() != material.flux.has_value(), reader, "temperature",
           material.temperature ? "(a face has a temperature or a flux, not both). Leave one out."
                                : "(neither temperature nor flux is given). Give one; flux = 0 is adiabatic.");
    expect(!material.temperature || *material.temperature >= 0, reader, "temperature",
           "(kelvin are never negative; add 273.15 to degrees Celsius). Write it like 293.15.");
    return material;
}

void warn_of_cold(std::optional<double> kelvin, std::string_view what, std::vector<std::string>& warnings) {
    if (!kelvin || *kelvin >= coldest_expected || *kelvin == 0) return;
    warnings.push_back(fmt::format("{}: {:g} K is very cold (temperatures are in kelvin; {:g} °C would be {:g} K)",
                                   what, *kelvin, *kelvin, *kelvin + 273.15));
}

std::vector<Entry> read_entries(const TomlReader& file) {
    const auto table = file.optional_table("materials");
    if (!table)
        file.fail("materials", "(missing). Write [materials] and below it: wall = { emissivity = 0.8, flux = 0 }.");
    std::vector<Entry> entries;
    for (const std::string& name : table->keys()) {
        const auto material = table->optional_table(name);
        entries.push_back({name, read_material(*material)});
    }
    return entries;
}

/// The entry of the face's name, or the only pattern that it matches.
const Entry* entry_of(const std::string& face, const std::vector<Entry>& entries, std::string_view origin) {
    const Entry* found = nullptr;
    for (const Entry& entry : entries) {
        if (entry.name == face) return &entry;
        if (!matches(entry.name, face)) continue;
        if (found != nullptr)
            throw UserError(
                fmt::format("{}: face '{}' is both '{}' and '{}' (it is not said which). Name the face itself.", origin,
                            face, found->name, entry.name));
        found = &entry;
    }
    return found;
}

void expect_used(const std::vector<Entry>& entries, const std::vector<std::string>& faces, std::string_view origin) {
    for (const Entry& entry : entries) {
        bool used = false;
        for (const std::string& face : faces) used = used || matches(entry.name, face);
        if (used) continue;
        const std::vector<std::string_view> known(faces.begin(), faces.end());
        throw UserError(fmt::format("{}: the scene has no face '{}'. {}See 'ffstudy explain SCENE' for its faces.",
                                    origin, entry.name, did_you_mean(entry.name, known)));
    }
}

}  // namespace

Materials read_materials(std::string_view toml, std::string_view origin, const std::vector<std::string>& faces) {
    const auto table = parse_toml(toml, origin);
    const TomlReader file(table, origin);
    constexpr std::array<std::string_view, 2> sections{"surroundings", "materials"};
    file.expect_only(sections);
    Materials materials;
    materials.surroundings = file.optional_number("surroundings");
    if (materials.surroundings && *materials.surroundings < 0)
        file.fail("surroundings", "(below 0). Write kelvin, like 293.15.");
    const auto entries = read_entries(file);
    expect_used(entries, faces, origin);
    for (const std::string& face : faces) {
        const Entry* entry = entry_of(face, entries, origin);
        if (entry == nullptr)
            throw UserError(
                fmt::format("{}: face '{}' has no material. Add it, or a pattern like \"*\".", origin, face));
        materials.faces.push_back(entry->material);
        if (entry->material.is_light() != materials.are_light())
            throw UserError(fmt::format(
                "{}: face '{}' is of light and '{}' of heat (one system has one kind). Give all "
                "faces the same.",
                origin, materials.are_light() ? faces.front() : face, materials.are_light() ? face : faces.front()));
    }
    if (!materials.are_light()) {
        for (const Entry& entry : entries) warn_of_cold(entry.material.temperature, entry.name, materials.warnings);
        warn_of_cold(materials.surroundings, "surroundings", materials.warnings);
    }
    return materials;
}

Materials load_materials(const std::filesystem::path& file, const std::vector<std::string>& faces) {
    return read_materials(read_text_file(file, FileKind::materials), file.string(), faces);
}

}  // namespace ff::studies
