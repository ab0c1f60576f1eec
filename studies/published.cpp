#include "studies/published.hpp"

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "studies/json_document.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <sstream>

namespace ff::studies {
namespace {

using Kind = JsonValue::Kind;

/// Reads typed members of objects and complains with their position.
class Reader {
  public:
    explicit Reader(std::string_view origin) : origin_(origin) {}

    [[noreturn]] void fail(const JsonValue& at, const std::string& message) const {
        throw UserError(describe(origin_, at.position) + message);
    }

    void expect_object(const JsonValue& value, std::string_view what,
                       std::initializer_list<std::string_view> keys) const {
        if (value.kind != Kind::object) fail(value, fmt::format("{} must be an object {{...}}.", what));
        for (const auto& [key, member] : value.members) {
            if (std::find(keys.begin(), keys.end(), key) != keys.end()) continue;
            const std::vector<std::string_view> known(keys);
            const std::string nearest = nearest_name(key, known);
            fail(member, fmt::format("unknown key \"{}\" in {} (it would be ignored silently). {}", key, what,
                                     nearest.empty() ? fmt::format("Known keys: {}.", fmt::join(known, ", "))
                                                     : fmt::format("Did you mean \"{}\"?", nearest)));
        }
    }

    const JsonValue& member(const JsonValue& object, std::string_view key, std::string_view what) const {
        const JsonValue* found = object.find(key);
        if (found == nullptr) fail(object, fmt::format("{} has no \"{}\". Add it.", what, key));
        return *found;
    }

    const std::vector<JsonValue>& array(const JsonValue& value, std::string_view key) const {
        if (value.kind != Kind::array) fail(value, fmt::format("\"{}\" must be a list [...].", key));
        return value.items;
    }

    std::string text(const JsonValue& value, std::string_view key) const {
        if (value.kind != Kind::string) fail(value, fmt::format("\"{}\" must be a string in double quotes.", key));
        return value.text;
    }

    std::string optional_text(const JsonValue& object, std::string_view key) const {
        const JsonValue* found = object.find(key);
        return found == nullptr ? std::string{} : text(*found, key);
    }

    std::uint64_t count(const JsonValue& value, std::string_view key, double largest) const {
        if (value.kind != Kind::number || value.number < 1 || value.number > largest ||
            std::floor(value.number) != value.number) {
            fail(value, fmt::format("\"{}\" must be a whole number from 1 to {:.0f}.", key, largest));
        }
        return static_cast<std::uint64_t>(value.number);
    }
    std::uint32_t patches(const JsonValue& value) const {
        return static_cast<std::uint32_t>(count(value, "patches_per_face", 1e9));
    }
    std::uint64_t samples(const JsonValue& value, std::string_view key) const { return count(value, key, 9e15); }

    bool flag(const JsonValue& value, std::string_view key) const {
        if (value.kind != Kind::boolean) fail(value, fmt::format("\"{}\" must be true or false.", key));
        return value.number != 0;
    }

    /// One of a few words.
    std::size_t choice(const JsonValue& value, std::string_view key,
                       std::initializer_list<std::string_view> words) const {
        const std::string word = text(value, key);
        const auto* const found = std::find(words.begin(), words.end(), word);
        if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
        const std::vector<std::string_view> known(words);
        const std::string nearest = nearest_name(word, known);
        fail(value, fmt::format("\"{}\" is no {} (known: {}).{}", word, key, fmt::join(known, ", "),
                                nearest.empty() ? std::string{} : fmt::format(" Did you mean \"{}\"?", nearest)));
    }

    /// Digits with at most one point, as printed.
    std::string number_as_printed(const JsonValue& value, std::string_view key) const {
        if (value.kind != Kind::string) {
            fail(value, fmt::format("\"{}\" must be given as a string (a JSON number loses trailing zeros). "
                                    "Put the digits in double quotes, exactly as printed.",
                                    key));
        }
        const std::string& digits = value.text;
        const bool plain = digits.find_first_not_of("0123456789.") == std::string::npos &&
                           std::count(digits.begin(), digits.end(), '.') <= 1 && digits.size() <= 16 &&
                           digits.find_first_of("0123456789") != std::string::npos;
        if (!plain) {
            fail(value, fmt::format("\"{}\" is not a printed number (digits and at most one decimal point, 16 "
                                    "characters at most). Write null for a blank cell.",
                                    digits));
        }
        return digits;
    }

  private:
    std::string_view origin_;
};

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

Quantity read_quantity(const Reader& reader, const JsonValue& value) {
    const std::string text = reader.text(value, "quantity");
    if (text == "sum of relative errors") return {FigureKind::sum_relative_error, {}, {}};
    if (text.starts_with("sum ") && text.size() > 4) return {FigureKind::row_sum, text.substr(4), {}};
    const std::size_t dash = text.find('-');
    if (text.starts_with("F ") && dash != std::string::npos && dash > 2 && dash + 1 < text.size()) {
        return {FigureKind::form_factor, text.substr(2, dash - 2), text.substr(dash + 1)};
    }
    reader.fail(value, fmt::format("\"{}\" is no quantity. Write \"F 1-6\" (a pair of faces), \"sum 1\" (the sum of a "
                                   "face's form factors) or \"sum of relative errors\".",
                                   text));
}

Column read_column(const Reader& reader, const JsonValue& value, const PublishedTables& tables,
                   const std::vector<std::string_view>& methods) {
    reader.expect_object(value, "a column", {"title", "method", "patches_per_face", "samples_per_patch", "kind"});
    Column column;
    const JsonValue& method = reader.member(value, "method", "the column");
    column.method = reader.text(method, "method");
    if (std::find(methods.begin(), methods.end(), column.method) == methods.end()) {
        const std::string nearest = nearest_name(column.method, methods);
        reader.fail(method,
                    fmt::format("\"{}\" is not among the file's \"methods\".{}", column.method,
                                nearest.empty() ? std::string{} : fmt::format(" Did you mean \"{}\"?", nearest)));
    }
    column.patches_per_face = reader.patches(reader.member(value, "patches_per_face", "the column"));
    if (const JsonValue* samples = value.find("samples_per_patch")) {
        column.samples_per_patch = reader.samples(*samples, "samples_per_patch");
    }
    const auto& sampling = tables.sampling_methods;
    if (std::find(sampling.begin(), sampling.end(), column.method) != sampling.end() && !column.samples_per_patch) {
        reader.fail(value, fmt::format("a column of the sampling method \"{}\" has no \"samples_per_patch\" (its "
                                       "figures are hits over rays). Add it.",
                                       column.method));
    }
    if (const JsonValue* kind = value.find("kind")) {
        column.relative_error = reader.choice(*kind, "kind", {"value", "relative_error"}) == 1;
    }
    return column;
}

void read_row(const Reader& reader, const JsonValue& value, const std::vector<Column>& columns, PublishedTables& tables,
              PublishedTable& table) {
    reader.expect_object(value, "a row", {"title", "quantity", "printed"});
    const JsonValue& quantity_value = reader.member(value, "quantity", "the row");
    const Quantity quantity = read_quantity(reader, quantity_value);
    const JsonValue& printed = reader.member(value, "printed", "the row");
    const auto& cells = reader.array(printed, "printed");
    if (cells.size() != columns.size()) {
        reader.fail(printed,
                    fmt::format("the row has {} figures but the table {} columns. Write null for a blank cell.",
                                cells.size(), columns.size()));
    }
    const std::size_t row = table.row_titles.size();
    const std::string title = reader.optional_text(value, "title");
    table.row_titles.push_back(title.empty() ? quantity_value.text : title);
    for (std::size_t c = 0; c < cells.size(); ++c) {
        if (cells[c].kind == Kind::null) {
            table.figures.push_back(std::nullopt);
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
        table.figures.push_back(tables.figures.size());
        tables.figures.push_back(std::move(figure));
    }
}

void read_table(const Reader& reader, const JsonValue& value, const std::vector<std::string_view>& methods,
                PublishedTables& tables) {
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
        read_row(reader, row, columns, tables, table);
    }
    tables.tables.push_back(std::move(table));
}

void read_reading(const Reader& reader, const JsonValue& value, PublishedTables& tables) {
    reader.expect_object(value, "a reading", {"table", "statement", "stated_in", "rays_per_face"});
    Reading reading;
    const JsonValue& id = reader.member(value, "table", "the reading");
    reading.table = reader.text(id, "table");
    const auto table = std::find_if(tables.tables.begin(), tables.tables.end(),
                                    [&](const PublishedTable& other) { return other.id == reading.table; });
    if (table == tables.tables.end()) {
        reader.fail(id, fmt::format("there is no table \"{}\" to read differently.", reading.table));
    }
    reading.statement = reader.text(reader.member(value, "statement", "the reading"), "statement");
    reading.stated_in = reader.optional_text(value, "stated_in");
    const JsonValue& rays = reader.member(value, "rays_per_face", "the reading");
    for (const JsonValue& count : reader.array(rays, "rays_per_face")) {
        reading.rays_per_face.push_back(reader.samples(count, "rays_per_face"));
    }
    if (reading.rays_per_face.size() != table->column_titles.size()) {
        reader.fail(rays, fmt::format("\"rays_per_face\" has {} entries but table \"{}\" {} columns.",
                                      reading.rays_per_face.size(), table->id, table->column_titles.size()));
    }
    tables.readings.push_back(std::move(reading));
}

PublishedClaim read_claim(const Reader& reader, const JsonValue& value) {
    reader.expect_object(value, "a claim",
                         {"id", "section", "statement", "kind", "methods", "pair_class", "patches_per_face",
                          "samples_per_patch", "number"});
    PublishedClaim claim;
    claim.id = reader.text(reader.member(value, "id", "the claim"), "id");
    claim.section = reader.optional_text(value, "section");
    claim.statement = reader.text(reader.member(value, "statement", "the claim"), "statement");
    claim.kind = reader.text(reader.member(value, "kind", "the claim"), "kind");
    if (const JsonValue* methods = value.find("methods")) {
        for (const JsonValue& method : reader.array(*methods, "methods")) {
            claim.methods.push_back(reader.text(method, "methods"));
        }
    }
    if (const JsonValue* pair_class = value.find("pair_class")) {
        reader.choice(*pair_class, "pair_class", {"parallel", "adjacent", "all"});
        claim.pair_class = pair_class->text;
    }
    if (const JsonValue* sizes = value.find("patches_per_face")) {
        for (const JsonValue& size : reader.array(*sizes, "patches_per_face")) {
            claim.patches_per_face.push_back(reader.patches(size));
        }
    }
    if (const JsonValue* sizes = value.find("samples_per_patch")) {
        for (const JsonValue& size : reader.array(*sizes, "samples_per_patch")) {
            claim.samples_per_patch.push_back(reader.samples(size, "samples_per_patch"));
        }
    }
    if (const JsonValue* number = value.find("number")) {
        if (number->kind != Kind::number) reader.fail(*number, "\"number\" must be a number.");
        claim.number = number->number;
    }
    return claim;
}

std::vector<std::string_view> read_methods(const Reader& reader, const JsonValue& value, PublishedTables& tables) {
    std::vector<std::string_view> names;
    for (const JsonValue& method : reader.array(value, "methods")) {
        reader.expect_object(method, "a method", {"name", "samples", "completion"});
        const JsonValue& name = reader.member(method, "name", "the method");
        reader.text(name, "name");
        if (std::find(names.begin(), names.end(), name.text) != names.end()) {
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

void read_printing(const Reader& reader, const JsonValue& value, PublishedTables& tables) {
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
    const JsonValue root = parse_json(text, origin);
    const Reader reader(origin);
    reader.expect_object(root, "a tables file",
                         {"source", "scene", "printing", "references", "methods", "tables", "readings", "claims"});
    PublishedTables tables;
    tables.source = reader.text(reader.member(root, "source", "the file"), "source");
    tables.scene = reader.text(reader.member(root, "scene", "the file"), "scene");
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
        read_table(reader, table, methods, tables);
    }
    if (const JsonValue* readings = root.find("readings")) {
        for (const JsonValue& reading : reader.array(*readings, "readings")) read_reading(reader, reading, tables);
    }
    if (const JsonValue* claims = root.find("claims")) {
        for (const JsonValue& claim : reader.array(*claims, "claims"))
            tables.claims.push_back(read_claim(reader, claim));
    }
    return tables;
}

PublishedTables read_published_tables(const std::filesystem::path& file) {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    if (!stream || !(text << stream.rdbuf())) {
        throw IoError(fmt::format("{}: cannot be read. Check the name and the permissions.", file.string()));
    }
    return parse_published_tables(text.str(), file.string());
}

std::string describe(const PublishedTables& tables, std::size_t figure) {
    const Figure& f = tables.figures[figure];
    const auto table = std::find_if(tables.tables.begin(), tables.tables.end(),
                                    [&](const PublishedTable& other) { return other.id == f.table; });
    return fmt::format("{}, {}, {}", f.table, table->row_titles[f.row], table->column_titles[f.column]);
}

}  // namespace ff::studies
