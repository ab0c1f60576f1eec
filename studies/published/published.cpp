#include "studies/published/published.hpp"

#include "core/geometry/scene.hpp"
#include "core/support/error.hpp"
#include "core/support/nearest_name.hpp"
#include "core/support/words.hpp"
#include "core/visibility/facing.hpp"
#include "studies/published/scene_of_tables.hpp"
#include "studies/readers/json_reader.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

namespace ff::studies {
namespace {

using Kind = JsonValue::Kind;

constexpr double most_patches = 1e6;
constexpr double most_samples = 1e9;  // their product stays exact in 64 bits

std::uint32_t read_patches(const JsonReader& reader, const JsonValue& value) {
    return static_cast<std::uint32_t>(reader.count(value, "patches_per_face", most_patches));
}

/// The elements of an array; none where the object has no such member.
const std::vector<JsonValue>& optional_array(const JsonReader& reader, const JsonValue& object, std::string_view key) {
    static const std::vector<JsonValue> none;
    const JsonValue* const found = object.find(key);
    return found == nullptr ? none : reader.array(*found, key);
}

struct Column {
    std::string method;
    std::uint32_t patches_per_face = 1;
    std::optional<std::uint64_t> samples_per_patch;
    bool relative_error = false;
};

struct Quantity {
    FigureKind kind = FigureKind::form_factor;
    std::string from;
    std::string to;
};

/// The two faces of "1-6". Names may have dashes themselves; empty where no dash stands between names of faces.
/// @throws UserError where several do
std::optional<std::pair<std::string, std::string>> split_pair(std::string_view text,
                                                              const std::vector<std::string>& faces) {
    const auto is_face = [&](std::string_view name) { return std::ranges::find(faces, name) != faces.end(); };
    std::optional<std::pair<std::string, std::string>> pair;
    for (std::size_t dash = text.find('-'); dash != std::string_view::npos; dash = text.find('-', dash + 1)) {
        const std::string_view from = text.substr(0, dash);
        const std::string_view to = text.substr(dash + 1);
        if (!is_face(from) || !is_face(to)) continue;
        if (pair) throw UserError("\"{}\" may be several pairs of faces. Rename a face of the scene.", text);
        pair.emplace(from, to);
    }
    return pair;
}

Quantity parse_quantity(const JsonReader& reader, const JsonValue& value, const Scene& scene) {
    const std::string text = reader.text(value, "quantity");
    if (text == "sum of relative errors") return {FigureKind::sum_relative_error, {}, {}};
    if (text.starts_with("sum ") && text.size() > 4) return {FigureKind::row_sum, text.substr(4), {}};
    if (text.starts_with("F ")) {
        try {
            if (const auto pair = split_pair(std::string_view(text).substr(2), scene.faces))
                return {FigureKind::form_factor, pair->first, pair->second};
        } catch (const UserError& error) {
            reader.fail(value, error.what());
        }
    }
    const std::size_t dash = text.find('-');
    if (text.starts_with("F ") && dash != std::string::npos && dash > 2 && dash + 1 < text.size()) {
        return {FigureKind::form_factor, text.substr(2, dash - 2), text.substr(dash + 1)};
    }
    reader.fail(value,
                fmt::format("\"{}\" is not a quantity. Write \"F 1-6\" (a pair of faces), \"sum 1\" (the sum of a "
                            "face's form factors) or \"sum of relative errors\".",
                            text));
}

Quantity read_quantity(const JsonReader& reader, const JsonValue& value, const Scene& scene) {
    Quantity quantity = parse_quantity(reader, value, scene);
    for (const std::string& label : {quantity.from, quantity.to}) {
        if (label.empty() || std::ranges::find(scene.faces, label) != scene.faces.end()) continue;
        reader.fail(value, fmt::format("face \"{}\" is not in the scene \"{}\" (its faces are {}). Correct the "
                                       "row's quantity.",
                                       label, scene.name, fmt::join(scene.faces, ", ")));
    }
    return quantity;
}

/// Whether it is the factor of a flat face to itself.
bool is_zero(const Quantity& quantity, const Scene& scene) {
    const auto from = std::ranges::find(scene.faces, quantity.from) - scene.faces.begin();
    return !quantity.to.empty() && quantity.from == quantity.to && !sees_itself(scene, static_cast<int>(from));
}

Column read_column(const JsonReader& reader, const JsonValue& value, const PublishedTables& tables,
                   const std::vector<std::string_view>& methods) {
    reader.expect_object(value, "a column", {"title", "method", "patches_per_face", "samples_per_patch", "kind"});
    Column column;
    const JsonValue& method = reader.member(value, "method", "the column");
    column.method = reader.text(method, "method");
    if (std::ranges::find(methods, column.method) == methods.end()) {
        const std::string nearest = nearest_name(column.method, methods);
        reader.fail(method,
                    fmt::format(R"("{}" is not among the file's "methods".{})", column.method,
                                nearest.empty() ? std::string{} : fmt::format(" Did you mean \"{}\"?", nearest)));
    }
    column.patches_per_face = read_patches(reader, reader.member(value, "patches_per_face", "the column"));
    if (const JsonValue* samples = value.find("samples_per_patch")) {
        column.samples_per_patch = reader.count(*samples, "samples_per_patch", most_samples);
    }
    const auto& sampling = tables.sampling_methods;
    if (std::ranges::find(sampling, column.method) != sampling.end() && !column.samples_per_patch) {
        reader.fail(value, fmt::format("a column of the sampling method \"{}\" has no \"samples_per_patch\" (its "
                                       "figures are hits over rays). Add it.",
                                       column.method));
    }
    if (const JsonValue* kind = value.find("kind")) {
        column.relative_error = reader.choice(*kind, "kind", {"value", "relative_error"}) == 1;
    }
    return column;
}

void read_row(const JsonReader& reader, const JsonValue& value, const Scene& scene, const std::vector<Column>& columns,
              PublishedTables& tables, PublishedTable& table) {
    reader.expect_object(value, "a row", {"title", "quantity", "printed"});
    const JsonValue& quantity_value = reader.member(value, "quantity", "the row");
    const Quantity quantity = read_quantity(reader, quantity_value, scene);
    const JsonValue& printed = reader.member(value, "printed", "the row");
    const auto& cells = reader.array(printed, "printed");
    if (cells.size() != columns.size()) {
        reader.fail(printed,
                    fmt::format("figures in the row: {}; columns of the table: {}. Write null for a blank cell.",
                                cells.size(), columns.size()));
    }
    const std::size_t row = table.row_titles.size();
    const std::string title = reader.optional_text(value, "title");
    table.row_titles.push_back(title.empty() ? quantity_value.text : title);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const bool is_blank = cells[c].kind == Kind::null;
        if (!is_blank && is_zero(quantity, scene) &&
            finite_number(reader.number_as_printed(cells[c], "printed")).value_or(0) != 0)
            reader.fail(quantity_value,
                        fmt::format("a form factor of face \"{}\" to itself (it is flat and does not see itself). "
                                    "Correct the row's quantity.",
                                    quantity.from));
        if (is_blank || is_zero(quantity, scene)) {
            table.figures.emplace_back(std::nullopt);
            continue;
        }
        Figure figure;
        figure.table = table.id;
        figure.row = row;
        figure.column = c;
        figure.method = columns[c].method;
        figure.patches_per_face = columns[c].patches_per_face;
        figure.samples_per_patch = columns[c].samples_per_patch;
        figure.kind = quantity.kind;
        if (columns[c].relative_error) {
            if (quantity.kind != FigureKind::form_factor) {
                reader.fail(cells[c],
                            "a column of relative errors has figures only in rows of form factors \"F i-j\". "
                            "Write null here.");
            }
            figure.kind = FigureKind::relative_error;
        }
        figure.from = quantity.from;
        figure.to = quantity.to;
        figure.printed = reader.number_as_printed(cells[c], "printed");
        figure.line = cells[c].position.line;
        figure.character = cells[c].position.column;
        table.figures.emplace_back(tables.figures.size());
        tables.figures.push_back(std::move(figure));
    }
}

void read_table(const JsonReader& reader, const JsonValue& value, const Scene& scene,
                const std::vector<std::string_view>& methods, PublishedTables& tables) {
    reader.expect_object(value, "a table", {"id", "title", "note", "columns", "rows"});
    PublishedTable table;
    const JsonValue& id = reader.member(value, "id", "the table");
    table.id = reader.text(id, "id");
    for (const PublishedTable& other : tables.tables) {
        if (other.id == table.id) reader.fail(id, fmt::format("two tables are called \"{}\". Rename one.", table.id));
    }
    table.title = reader.optional_text(value, "title");
    table.note = reader.optional_text(value, "note");
    std::vector<Column> columns;
    for (const JsonValue& column : reader.array(reader.member(value, "columns", "the table"), "columns")) {
        columns.push_back(read_column(reader, column, tables, methods));
        const std::string title = reader.optional_text(column, "title");
        table.column_titles.push_back(title.empty() ? columns.back().method : title);
    }
    if (columns.empty()) reader.fail(value, fmt::format("table \"{}\" has no columns. Add one.", table.id));
    for (const JsonValue& row : reader.array(reader.member(value, "rows", "the table"), "rows")) {
        read_row(reader, row, scene, columns, tables, table);
    }
    tables.tables.push_back(std::move(table));
}

void read_reading(const JsonReader& reader, const JsonValue& value, PublishedTables& tables) {
    reader.expect_object(value, "a reading", {"table", "statement", "stated_in", "rays_per_face"});
    Reading reading;
    const JsonValue& id = reader.member(value, "table", "the reading");
    reading.table = reader.text(id, "table");
    const auto table = std::ranges::find(tables.tables, reading.table, &PublishedTable::id);
    if (table == tables.tables.end()) {
        reader.fail(id, fmt::format("there is no table \"{}\" to read differently.", reading.table));
    }
    reading.statement = reader.text(reader.member(value, "statement", "the reading"), "statement");
    reading.stated_in = reader.optional_text(value, "stated_in");
    const JsonValue& rays = reader.member(value, "rays_per_face", "the reading");
    for (const JsonValue& count : reader.array(rays, "rays_per_face")) {
        reading.rays_per_face.push_back(reader.count(count, "rays_per_face", 1e15));
    }
    if (reading.rays_per_face.size() != table->column_titles.size()) {
        reader.fail(rays, fmt::format(R"("rays_per_face" has {} entries but table "{}" {} columns.)",
                                      reading.rays_per_face.size(), table->id, table->column_titles.size()));
    }
    tables.readings.push_back(std::move(reading));
}

PublishedClaim read_claim(const JsonReader& reader, const JsonValue& value) {
    reader.expect_object(value, "a claim",
                         {"id", "section", "statement", "tested_as", "kind", "methods", "pair_class",
                          "patches_per_face", "samples_per_patch", "number"});
    PublishedClaim claim;
    claim.id = reader.text(reader.member(value, "id", "the claim"), "id");
    claim.section = reader.optional_text(value, "section");
    claim.statement = reader.text(reader.member(value, "statement", "the claim"), "statement");
    claim.tested_as = reader.optional_text(value, "tested_as");
    claim.kind = reader.text(reader.member(value, "kind", "the claim"), "kind");
    for (const JsonValue& method : optional_array(reader, value, "methods")) {
        claim.methods.push_back(reader.text(method, "methods"));
    }
    if (const JsonValue* pair_class = value.find("pair_class")) {
        reader.choice(*pair_class, "pair_class", {"parallel", "adjacent", "all"});
        claim.pair_class = pair_class->text;
    }
    for (const JsonValue& size : optional_array(reader, value, "patches_per_face")) {
        claim.patches_per_face.push_back(read_patches(reader, size));
    }
    for (const JsonValue& size : optional_array(reader, value, "samples_per_patch")) {
        claim.samples_per_patch.push_back(reader.count(size, "samples_per_patch", most_samples));
    }
    if (const JsonValue* number = value.find("number")) {
        if (number->kind != Kind::number)
            reader.fail(*number, "\"number\" is not a number. Write it like 0.2, without quotes.");
        claim.number = number->number;
    }
    return claim;
}

std::vector<std::string_view> read_methods(const JsonReader& reader, const JsonValue& value, PublishedTables& tables) {
    std::vector<std::string_view> names;
    for (const JsonValue& method : reader.array(value, "methods")) {
        reader.expect_object(method, "a method", {"name", "samples", "completion"});
        const JsonValue& name = reader.member(method, "name", "the method");
        reader.text(name, "name");
        if (std::ranges::find(names, name.text) != names.end()) {
            reader.fail(name, fmt::format("two methods are called \"{}\". Rename one.", name.text));
        }
        names.emplace_back(name.text);
        if (reader.flag(reader.member(method, "samples", "the method"), "samples")) {
            tables.sampling_methods.push_back(name.text);
        }
        const JsonValue& completion = reader.member(method, "completion", "the method");
        if (reader.choice(completion, "completion", {"direct", "reciprocal"}) == 1) {
            tables.reciprocal_methods.push_back(name.text);
        }
    }
    return names;
}

void read_printing(const JsonReader& reader, const JsonValue& value, PublishedTables& tables) {
    reader.expect_object(value, "\"printing\"", {"rule", "decimals"});
    constexpr std::array rules{PrintingRule::unstated, PrintingRule::rounded, PrintingRule::truncated};
    tables.rule = rules[reader.choice(reader.member(value, "rule", "\"printing\""), "rule",
                                      {"unstated", "rounded", "truncated"})];
    if (const JsonValue* decimals = value.find("decimals")) {
        tables.decimals = static_cast<int>(reader.count(*decimals, "decimals", 12));
    }
}

}  // namespace

PublishedTables parse_published_tables(std::string_view text, std::string_view origin) {
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) {
        throw UserError("{}: is empty (a tables file is an object of JSON). See docs/published-tables.md.", origin);
    }
    const JsonValue root = parse_json(text, origin);
    const JsonReader reader(origin);
    reader.expect_object(root, "a tables file",
                         {"source", "scene", "printing", "references", "methods", "tables", "readings", "claims"});
    PublishedTables tables;
    tables.source = reader.text(reader.member(root, "source", "the file"), "source");
    const Scene scene = read_scene_of_tables(reader, reader.member(root, "scene", "the file"), tables.scene);
    if (const JsonValue* printing = root.find("printing")) read_printing(reader, *printing, tables);
    if (const JsonValue* references = root.find("references")) {
        reader.expect_object(*references, "\"references\"", {"parallel", "adjacent"});
        if (const JsonValue* parallel = references->find("parallel")) {
            tables.reference_parallel = reader.number_as_printed(*parallel, "parallel");
        }
        if (const JsonValue* adjacent = references->find("adjacent")) {
            tables.reference_adjacent = reader.number_as_printed(*adjacent, "adjacent");
        }
    }
    const auto methods = read_methods(reader, reader.member(root, "methods", "the file"), tables);
    for (const JsonValue& table : reader.array(reader.member(root, "tables", "the file"), "tables")) {
        read_table(reader, table, scene, methods, tables);
    }
    for (const JsonValue& reading : optional_array(reader, root, "readings")) read_reading(reader, reading, tables);
    for (const JsonValue& claim : optional_array(reader, root, "claims")) {
        tables.claims.push_back(read_claim(reader, claim));
    }
    return tables;
}

PublishedTables read_published_tables(const std::filesystem::path& file) {
    return parse_published_tables(read_tables_text(file), file.string());
}

std::string describe(const PublishedTables& tables, std::size_t figure) {
    const Figure& f = tables.figures[figure];
    const auto table = std::ranges::find(tables.tables, f.table, &PublishedTable::id);
    return fmt::format("{}, {}, {}", f.table, table->row_titles[f.row], table->column_titles[f.column]);
}

}  // namespace ff::studies
