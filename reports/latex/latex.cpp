#include "reports/latex/latex.hpp"

#include "reports/pictures/picture_values.hpp"
#include "reports/tables/tables.hpp"
#include "reports/templates/mustache.hpp"
#include "reports/text/folding.hpp"
#include "reports/text/json_values.hpp"
#include "reports/text/labels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>

namespace ff::reports {
namespace {

struct Sign {
    std::string_view text;
    std::string_view latex;
};

/// ASCII, with braces where a command would swallow what follows, or where [ and * would be arguments of the row
/// before; then the characters beyond ASCII that reports themselves write.
constexpr std::array signs{
    Sign{"\\", "\\textbackslash{}"},
    Sign{"{", "\\{"},
    Sign{"}", "\\}"},
    Sign{"$", "\\$"},
    Sign{"&", "\\&"},
    Sign{"#", "\\#"},
    Sign{"%", "\\%"},
    Sign{"_", "\\_"},
    Sign{"^", "\\^{}"},
    Sign{"~", "\\~{}"},
    Sign{"<", "\\textless{}"},
    Sign{">", "\\textgreater{}"},
    Sign{"|", "\\textbar{}"},
    Sign{"\"", "\\char34{}"},
    Sign{"[", "{[}"},
    Sign{"*", "{*}"},
    Sign{"−", "\\ensuremath{-}"},
    Sign{"×", "\\ensuremath{\\times}"},
    Sign{"±", "\\ensuremath{\\pm}"},
    Sign{"·", "\\ensuremath{\\cdot}"},
    Sign{"≤", "\\ensuremath{\\leq}"},
    Sign{"≥", "\\ensuremath{\\geq}"},
    Sign{"Δ", "\\ensuremath{\\Delta}"},
    Sign{"Σ", "\\ensuremath{\\Sigma}"},
    Sign{"σ", "\\ensuremath{\\sigma}"},
    Sign{"χ", "\\ensuremath{\\chi}"},
    Sign{"ψ", "\\ensuremath{\\psi}"},
    Sign{"₁", "\\textsubscript{1}"},
    Sign{"²", "\\textsuperscript{2}"},
    Sign{"³", "\\textsuperscript{3}"},
    Sign{"√", "\\ensuremath{\\surd}"},
    Sign{"∞", "\\ensuremath{\\infty}"},
    Sign{"…", "\\dots{}"},
    Sign{"–", "--"},
    Sign{"→", "\\ensuremath{\\to}"},
    Sign{"″", "\\ensuremath{''}"},
};

/// Characters of which two in a row may become one.
constexpr std::string_view ligatures = "-'`,!?";

bool is_control(char c) {
    return static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
}

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

bool is_alphanumeric(char c) {
    return is_digit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

std::string_view digits_of(std::string_view text) {
    return text.substr(0, text.find_first_not_of("0123456789"));
}

/// A decimal number as it stands in a text.
struct Number {
    std::string_view sign;  ///< may be empty
    std::string_view digits;
    bool negative_exponent = false;
    std::string_view exponent;  ///< without leading zeros; empty where there is none
    std::size_t length = 0;
};

/// The number that the text starts with.
std::optional<Number> number_at(std::string_view text) {
    Number number;
    if (text.starts_with('-') || text.starts_with('+')) number.sign = text.substr(0, 1);
    std::string_view rest = text.substr(number.sign.size());
    std::size_t size = digits_of(rest).size();
    if (size == 0) return std::nullopt;
    if (rest.substr(size).starts_with('.')) {
        const std::size_t decimals = digits_of(rest.substr(size + 1)).size();
        if (decimals > 0) size += 1 + decimals;
    }
    number.digits = rest.substr(0, size);
    number.length = number.sign.size() + size;
    rest = rest.substr(size);
    if (!rest.starts_with('e')) return number;
    const bool is_signed = rest.substr(1).starts_with('-') || rest.substr(1).starts_with('+');
    const std::string_view exponent = digits_of(rest.substr(is_signed ? 2 : 1));
    if (exponent.empty()) return number;
    number.negative_exponent = rest[1] == '-';
    number.exponent = exponent.substr(std::min(exponent.find_first_not_of('0'), exponent.size() - 1));
    number.length += (is_signed ? 2 : 1) + exponent.size();
    return number;
}

constexpr std::size_t most_rows_of_a_page = 40;
constexpr std::size_t longest_line = 26;  // a longer text is broken

std::string set_cell(const TableCell& cell) {
    const std::string text = latex_with_numbers(cell.text);
    if (cell.mark == Mark::misprint) return text + "\\ensuremath{^\\dagger}";
    return cell.mark == Mark::surprising || cell.mark == Mark::bad ? fmt::format("\\textbf{{{}}}", text) : text;
}

std::string set_row(const std::vector<TableCell>& row) {
    std::string out = escape_latex(row.front().text);  // a name, not a number
    for (std::size_t i = 1; i < row.size(); ++i) out += " & " + set_cell(row[i]);
    return out + " \\\\";
}

/// Columns of the first group where the others repeat its titles; 0 where they do not.
std::size_t repeated_columns(const Table& table) {
    const auto& columns = table.columns;
    std::size_t size = 0;
    while (1 + size < columns.size() && !columns[1].group.empty() && columns[1 + size].group == columns[1].group)
        ++size;
    if (size == 0 || (columns.size() - 1) % size != 0) return 0;
    for (std::size_t i = 1; i < columns.size(); ++i) {
        const TableColumn& first = columns[1 + (i - 1) / size * size];
        if (columns[i].title != columns[1 + (i - 1) % size].title || columns[i].group != first.group) return 0;
    }
    return size;
}

/// Groups of columns below each other; a row of one cell is a heading.
Table stacked(const Table& table, std::size_t size) {
    Table out = table;
    out.columns.resize(1 + size);
    out.rows.clear();
    for (std::size_t first = 1; first < table.columns.size(); first += size) {
        out.rows.push_back({table.columns[first].group});
        for (const auto& row : table.rows) {
            const auto begin = row.begin() + static_cast<std::ptrdiff_t>(first);
            const auto end = begin + static_cast<std::ptrdiff_t>(size);
            if (std::all_of(begin, end, [](const TableCell& cell) { return cell.text.empty(); })) continue;
            auto& placed = out.rows.emplace_back(begin, end);
            placed.insert(placed.begin(), row.front());
        }
    }
    for (TableColumn& column : out.columns) column.group.clear();
    return out;
}

std::string layout(const Table& table) {
    std::string out;
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
        std::size_t longest = 0;
        for (const auto& row : table.rows) {
            if (row.size() > 1) longest = std::max(longest, visible_length(row[i].text));
        }
        if (table.columns[i].number) {
            out += "r";
        } else if (longest <= longest_line) {
            out += "l";
        } else {
            out += fmt::format(">{{\\raggedright\\arraybackslash}}p{{{}em}}",
                               std::clamp<std::size_t>(longest / 4, 12, 30));
        }
    }
    return out;
}

std::string set_header(const Table& table) {
    std::string groups;
    std::string rules;
    for (std::size_t i = 0; i < table.columns.size();) {
        std::size_t end = i + 1;
        const std::string& title = table.columns[i].group;
        while (end < table.columns.size() && table.columns[end].group == title) ++end;
        groups += fmt::format("{}\\multicolumn{{{}}}{{c}}{{{}}}", i == 0 ? "" : " & ", end - i, escape_latex(title));
        if (!title.empty()) rules += fmt::format("\\cmidrule(lr){{{}-{}}}", i + 1, end);
        i = end;
    }
    std::string titles;
    for (const TableColumn& column : table.columns) {
        titles += fmt::format("{}\\multicolumn{{1}}{{{}}}{{{}}}", titles.empty() ? "" : " & ",
                              column.number ? "r" : "l", escape_latex(column.title));
    }
    return rules.empty() ? titles + " \\\\" : fmt::format("{} \\\\\n{}\n{} \\\\", groups, rules, titles);
}

bool has(const Table& table, Mark mark) {
    return std::any_of(table.rows.begin(), table.rows.end(), [&](const auto& row) {
        return std::any_of(row.begin(), row.end(), [&](const TableCell& cell) { return cell.mark == mark; });
    });
}

Json lines(const std::vector<std::string>& texts) {
    Json list = Json::array();
    for (const std::string& text : texts) list.push_back({{"line", text}});
    return list;
}

Json notes_of(const Table& table) {
    std::vector<std::string> notes;
    if (!table.note.empty()) notes.push_back(latex_with_numbers(table.note));
    if (has(table, Mark::misprint))
        notes.emplace_back("\\ensuremath{\\dagger} contradicts other figures of the publication.");
    if (has(table, Mark::surprising)) notes.emplace_back("Bold: not what a run as described gives.");
    for (const std::string& remark : table.remarks) notes.push_back(latex_with_numbers(remark));
    return lines(notes);
}

std::vector<Table> tables_of(const studies::StudyResults& results) {
    std::vector<Table> tables{methods_table(results)};
    if (!results.slopes.empty()) tables.push_back(slopes_table(results));
    if (results.published) {
        const studies::PublishedResults& published = *results.published;
        for (std::size_t i = 0; i < published.tables.tables.size(); ++i)
            tables.push_back(published_table(published, i, 1 - results.findings.plan.spec.level));
        if (!published.claims.empty()) tables.push_back(claims_table(published));
    }
    const studies::StudyPlan& plan = results.findings.plan;
    for (std::size_t i = 0; i < results.findings.cells.size(); ++i) {
        tables.push_back(pairs_table(results, i));
        const studies::Cell& cell = plan.cells[results.findings.cells[i].cell];
        tables.back().id += fmt::format("-{}", cell_label(plan, cell));  // for the name of the file
    }
    return tables;
}

}  // namespace

std::string escape_latex(const std::string& text) {
    std::string out;
    const std::string_view all = text;
    for (std::size_t i = 0; i < all.size();) {
        const std::string_view rest = all.substr(i);
        const auto sign = std::ranges::find_if(signs, [&](const Sign& s) { return rest.starts_with(s.text); });
        if (sign != signs.end()) {
            out += sign->latex;
            i += sign->text.size();
            continue;
        }
        out += is_control(rest.front()) ? ' ' : rest.front();
        const bool joins = rest.size() > 1 && ligatures.find(rest[0]) != std::string_view::npos &&
                           ligatures.find(rest[1]) != std::string_view::npos;
        if (joins) out += "{}";
        ++i;
    }
    return out;
}

std::string latex_with_numbers(const std::string& text) {
    std::string out;
    const std::string_view all = text;
    std::size_t written = 0;
    for (std::size_t at = 0; at < all.size();) {
        const auto number = number_at(all.substr(at));
        if (!number) {
            ++at;
            continue;
        }
        // A sign belongs to a number unless something stands before it, as in "F 1-6"; an exponent ends it.
        const bool inside = at > 0 && (is_alphanumeric(all[at - 1]) || all[at - 1] == '.');
        if (!inside && (!number->sign.empty() || !number->exponent.empty())) {
            out += escape_latex(text.substr(written, at - written));
            out += fmt::format("${}{}", number->sign, number->digits);
            if (!number->exponent.empty())
                out += fmt::format("\\times10^{{{}{}}}", number->negative_exponent ? "-" : "", number->exponent);
            out += '$';
            written = at + number->length;
        }
        at += number->length;
    }
    return out + escape_latex(text.substr(written));
}

std::string latex_table(const Table& table, const Templates& templates) {
    const std::size_t repeated = repeated_columns(table);
    const Table shown = repeated > 0 ? stacked(table, repeated) : table;
    std::vector<std::string> rows;
    for (const auto& row : shown.rows) {
        const bool heading = row.size() == 1 && shown.columns.size() > 1;
        if (heading && !rows.empty()) rows.emplace_back("\\addlinespace");
        rows.push_back(heading ? fmt::format(R"(\multicolumn{{{}}}{{l}}{{\textit{{{}}}}} \\)", shown.columns.size(),
                                             escape_latex(row.front().text))
                               : set_row(row));
    }
    return fill_template(templates, "latex_table",
                         {{"name", table.id},
                          {"title", table.title},
                          {"long", rows.size() > most_rows_of_a_page},
                          {"layout", layout(shown)},
                          {"header", set_header(shown)},
                          {"rows", lines(rows)},
                          {"notes", notes_of(table)}},
                         escape_latex);
}

std::vector<NamedText> latex_report(const studies::StudyResults& results, const Templates& templates) {
    std::vector<NamedText> files(1);
    Json names = Json::array();
    std::set<std::string> taken;
    for (Table table : tables_of(results)) {
        const std::string id = slug(table.id);  // the id of a published table may be any text
        table.id = id;
        for (int number = 2; table.id.empty() || !taken.insert(table.id).second; ++number)
            table.id = fmt::format("{}-{}", id.empty() ? "table" : id, number);
        names.push_back({{"name", table.id}});
        files.push_back({fmt::format("tables/{}.tex", table.id), latex_table(table, templates)});
    }
    files.front() = {"tables.tex", fill_template(templates, "latex",
                                                 {{"title", results.findings.plan.spec.title},
                                                  {"partial", !results.findings.complete},
                                                  {"tables", std::move(names)}},
                                                 escape_latex)};
    return files;
}

}  // namespace ff::reports
