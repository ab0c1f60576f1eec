#include "reports/html/html_view.hpp"

#include "core/support/contract.hpp"
#include "reports/text/labels.hpp"
#include "reports/text/numbers.hpp"
#include "reports/text/study_text.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <utility>

namespace ff::reports {
namespace {

/// 'sha256-...' in base 64, as policies write it.
std::string source(std::string_view text) {
    std::array<unsigned char, 32> digest{};
    const int done = EVP_Digest(text.data(), text.size(), digest.data(), nullptr, EVP_sha256(), nullptr);
    FF_ENSURE(done == 1);
    std::array<unsigned char, 45> base64{};  // 4 letters for 3 bytes, and an end
    EVP_EncodeBlock(base64.data(), digest.data(), static_cast<int>(digest.size()));
    return fmt::format(" 'sha256-{}'", std::string(base64.begin(), base64.end() - 1));
}

std::string sources(std::string_view directive, std::span<const std::string_view> texts) {
    std::string out(directive);
    for (const std::string_view text : texts) out += source(text);
    return texts.empty() ? out + " 'none'" : out;
}

}  // namespace

std::string security_policy(std::span<const std::string_view> styles, std::span<const std::string_view> scripts) {
    return fmt::format("default-src 'none'; {}; {}; base-uri 'none'; form-action 'none'", sources("style-src", styles),
                       sources("script-src", scripts));
}

namespace {

/// The mark as a class of the style, and in words for those who do not see it.
struct MarkView {
    std::string_view style;
    std::string_view says;
};

MarkView view(Mark mark) {
    switch (mark) {
        case Mark::misprint:
            return {"misprint", "contradicts other figures"};
        case Mark::surprising:
            return {"surprising", "not what a run as described gives"};
        case Mark::good:
            return {"good", ""};
        case Mark::bad:
            return {"bad", ""};
        case Mark::open:
            return {"open", ""};
        case Mark::none:
            break;
    }
    return {};
}

std::size_t count_minor(const Table& table, std::size_t begin, std::size_t end) {
    std::size_t count = 0;
    for (std::size_t i = begin; i < end; ++i) {
        if (table.columns[i].minor) ++count;
    }
    return count;
}

std::string style_of(const TableColumn& column) {
    if (column.number && column.minor) return "number minor";
    return column.number ? "number" : column.minor ? "minor" : "";
}

/// Column titles of the upper row, with how many columns each covers; empty where no column has one.
Json groups_of(const Table& table) {
    Json groups = Json::array();
    bool any = false;
    for (std::size_t i = 0; i < table.columns.size();) {
        std::size_t end = i + 1;
        const std::string& title = table.columns[i].group;
        while (end < table.columns.size() && table.columns[end].group == title) ++end;
        any |= !title.empty();
        const std::size_t minor = count_minor(table, i, end);
        if (minor < end - i)
            groups.push_back({{"title", title}, {"span", std::to_string(end - i - minor)}, {"named", !title.empty()}});
        if (minor > 0) {
            const bool named = minor == end - i && !title.empty();
            groups.push_back({{"title", title}, {"span", std::to_string(minor)}, {"named", named}, {"minor", true}});
        }
        i = end;
    }
    return any ? groups : Json::array();
}

}  // namespace

Json texts_view(const std::vector<std::string>& lines) {
    Json list = Json::array();
    for (const std::string& line : lines) list.push_back({{"text", line}});
    return list;
}

Json headline_view(const Headline& headline) {
    Json numbers = Json::array();
    for (const KeyNumber& number : headline.numbers)
        numbers.push_back({{"value", number.value}, {"label", number.label}, {"detail", number.detail}});
    return {{"question", headline.question}, {"verdict", headline.verdict}, {"numbers", std::move(numbers)}};
}

namespace {

/// What is in the tables of these names, and in those whose names go on with -.
constexpr std::array<std::pair<std::string_view, std::string_view>, 20> contents_of_tables{{
    {"methods", "error, bias and closure of every method and size"},
    {"convergence", "slopes, their intervals, and the rates that theory expects"},
    {"side-by-side", "ratios of errors at equal cost, and of evaluations at equal error"},
    {"best-of-scenes", "the best methods on each scene, and the next"},
    {"decisions", "the best methods on each kind of pairs"},
    {"configurations", "every estimate beside its exact value"},
    {"agreement", "how many estimates of each method agree"},
    {"occlusion", "the error of each method by occluded fraction"},
    {"error-law", "the constant and the exponent of each law"},
    {"reductions", "how many times less variance than random points"},
    {"coverage", "the share of intervals that contain the exact value"},
    {"least-coverage", "the worst share of each rule"},
    {"spreads", "the spread of trials beside that of independent rays"},
    {"evenness", "how measures of evenness correlate with errors"},
    {"claimed-errors", "the share of runs whose error stays within what is stated"},
    {"claims", "verdict on each claim, with its evidence"},
    {"radiosity-matrices", "row sums, reciprocity and signs of the matrices"},
    {"radiosity-exitance", "errors, energy lost and condition, by reflectance"},
    {"radiosity-solvers", "iterations of each solver, by reflectance"},
    {"radiosity-bias", "how the bias falls with the size"},
}};

/// What a folded table holds: "35 rows: how many times less variance than random points". Of other tables, such as
/// those of a publication, the titles of the first columns.
std::string inside(const Table& table) {
    constexpr std::size_t most_titles = 4;
    const std::string rows = counted(table.rows.size(), "row");
    for (const auto& [id, contents] : contents_of_tables) {
        if (table.id == id || table.id.starts_with(std::string(id) + "-")) return fmt::format("{}: {}", rows, contents);
    }
    std::vector<std::string> titles;
    for (std::size_t i = 1; i < table.columns.size() && titles.size() < most_titles; ++i) {
        if (!table.columns[i].title.empty()) titles.push_back(table.columns[i].title);
    }
    return fmt::format("{}: {}", rows, fmt::join(titles, ", "));
}

}  // namespace

Json table_view(const Table& table) {
    Json columns = Json::array();
    for (const TableColumn& column : table.columns)
        columns.push_back({{"title", column.title}, {"number", column.number}, {"style", style_of(column)}});
    Json rows = Json::array();
    for (const auto& row : table.rows) {
        Json cells = Json::array();
        for (std::size_t i = 1; i < row.size(); ++i) {
            const MarkView mark = view(row[i].mark);
            cells.push_back({{"text", row[i].text},
                             {"number", table.columns[i].number},
                             {"style", style_of(table.columns[i])},
                             {"mark", std::string(mark.style)},
                             {"says", std::string(mark.says)}});
        }
        rows.push_back({{"name", row.front().text}, {"cells", std::move(cells)}});
    }
    Json groups = groups_of(table);
    const bool grouped = !groups.empty();
    return {{"id", table.id},
            {"title", table.title},
            {"note", table.note},
            {"inside", inside(table)},
            {"grouped", grouped},
            {"has_minor", count_minor(table, 0, table.columns.size()) > 0},
            {"groups", std::move(groups)},
            {"columns", std::move(columns)},
            {"rows", std::move(rows)},
            {"remarks", texts_view(table.remarks)}};
}

Json reproduction_view(const studies::StudyResults& results) {
    const studies::StudySpec& spec = results.findings.plan.spec;
    const StudyText study = study_text(spec);
    return {{"file", spec.name + ".toml"}, {"tables_file", spec.published ? spec.published->file : std::string()},
            {"study_file", study.text},    {"whole", study.whole},
            {"kept", whole_study_is_kept}, {"program", program_label(results.context)}};
}

}  // namespace ff::reports
