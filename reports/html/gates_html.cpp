#include "reports/html/gates_html.hpp"

#include "reports/terminal/gates_terminal.hpp"
#include "reports/text/numbers.hpp"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

namespace ff::reports {
namespace {

constexpr double band_width = 300;
constexpr double band_height = 24;

constexpr const char* page_style =
    "body{font:16px/1.4 sans-serif;margin:2em auto;max-width:75em;padding:0 1em;color:#1b1b1b;background:#fff}"
    "table{border-collapse:collapse}td,th{text-align:left;vertical-align:top;padding:.4em .8em;"
    "border-bottom:1px solid #ccc}svg{display:block}"
    "td.pass{color:#1a6b2b}td.fail{color:#a4161a;font-weight:bold}td.inconclusive{color:#7a5200;font-weight:bold}";

void set_attribute(pugi::xml_node node, const char* attribute, const std::string& value) {
    node.append_attribute(attribute).set_value(value.c_str());
}

/// A new last child with this text, which must not be empty.
pugi::xml_node add_element(pugi::xml_node parent, const char* element, const std::string& text) {
    pugi::xml_node node = parent.append_child(element);
    node.text().set(text.c_str());
    return node;
}

/// The root of a page without scripts, whose content is escaped on output.
pugi::xml_node begin_page(pugi::xml_document& document, const std::string& title) {
    pugi::xml_node html = document.append_child("html");
    set_attribute(html, "lang", "en");
    pugi::xml_node head = html.append_child("head");
    set_attribute(head.append_child("meta"), "charset", "utf-8");
    add_element(head, "title", title);
    add_element(head, "style", page_style);
    return html;
}

/// Maps values to places, so that everything finite is visible.
struct Scale {
    double low = 0;
    double high = 1;

    [[nodiscard]] double operator()(double value) const {
        return band_width * std::clamp((value - low) / (high - low), 0.0, 1.0);
    }
};

Scale scale_of(const studies::gates::Comparison& row) {
    const studies::gates::Measurement& m = *row.measurement;
    double low = m.value;
    double high = m.value;
    for (const double value :
         {row.band.low, row.band.high, m.passing.low, m.passing.high, m.failing.low, m.failing.high}) {
        if (!std::isfinite(value)) continue;
        low = std::min(low, value);
        high = std::max(high, value);
    }
    const double margin = high > low ? 0.05 * (high - low) : 1;
    return {low - margin, high + margin};
}

void add_bar(pugi::xml_node svg, double from, double to, double thickness, const char* colour) {
    pugi::xml_node bar = svg.append_child("rect");
    set_attribute(bar, "x", fmt::format("{:.1f}", from));
    set_attribute(bar, "y", fmt::format("{:.1f}", (band_height - thickness) / 2));
    set_attribute(bar, "width", fmt::format("{:.1f}", std::max(1.0, to - from)));
    set_attribute(bar, "height", fmt::format("{:g}", thickness));
    set_attribute(bar, "fill", colour);
}

/// The band in grey; on it the failing interval thin, the passing one thick, the value as a line.
void add_band_picture(pugi::xml_node cell, const studies::gates::Comparison& row) {
    if (!row.measurement) {
        cell.text().set("–");
        return;
    }
    const studies::gates::Measurement& m = *row.measurement;
    const Scale scale = scale_of(row);
    pugi::xml_node svg = cell.append_child("svg");
    set_attribute(svg, "width", fmt::format("{:g}", band_width));
    set_attribute(svg, "height", fmt::format("{:g}", band_height));
    set_attribute(svg, "role", "img");
    set_attribute(svg, "aria-label",
                  fmt::format("{}, interval {} to {}, {}", brief(m.value), brief(m.passing.low), brief(m.passing.high),
                              band_in_words(row.band)));
    add_bar(svg, scale(row.band.low), scale(row.band.high), band_height, "#d9e6f2");
    add_bar(svg, scale(m.failing.low), scale(m.failing.high), 2, "#555");
    add_bar(svg, scale(m.passing.low), scale(m.passing.high), 8, "#1f5a99");
    add_bar(svg, scale(m.value), scale(m.value), 16, "#000");
}

}  // namespace

std::string gates_html(const studies::gates::CheckResults& check) {
    using studies::gates::Verdict;
    const std::string title = "Gates of " + check.spec.name;
    pugi::xml_document document;
    pugi::xml_node html = begin_page(document, title);
    pugi::xml_node body = html.append_child("body");
    add_element(body, "h1", title);
    add_element(body, "p", gates_summary(check));
    add_element(
        body, "p",
        fmt::format("False alarm at most {} in all, power {}. Grey: the band. Thick: the interval that has to lie "
                    "inside. Thin: the one that must not lie wholly outside.",
                    brief(check.spec.alpha), brief(check.spec.power)));
    pugi::xml_node table = body.append_child("table");
    pugi::xml_node titles = table.append_child("tr");
    for (const char* text : {"verdict", "gate", "interval and band", "found"}) add_element(titles, "th", text);
    for (const Verdict verdict : {Verdict::fail, Verdict::inconclusive, Verdict::pass}) {
        for (const studies::gates::GateResult& result : check.results) {
            if (result.verdict != verdict) continue;
            pugi::xml_node row = table.append_child("tr");
            set_attribute(add_element(row, "td", std::string(name(verdict))), "class", std::string(name(verdict)));
            add_element(row, "td", result.gate);
            add_band_picture(row.append_child("td"), decisive(result.comparisons));
            add_element(row, "td", gate_in_words(result));
        }
    }
    std::ostringstream out;
    out << "<!doctype html>\n";
    html.print(out, "", pugi::format_raw | pugi::format_no_declaration);
    out << "\n";
    return out.str();
}

}  // namespace ff::reports
