#include "reports/json/gates_junit.hpp"

#include "core/support/contract.hpp"
#include "reports/terminal/gates_terminal.hpp"

#include <fmt/format.h>
#include <pugixml.hpp>

#include <algorithm>
#include <numeric>
#include <sstream>

namespace ff::reports {
namespace {

void set(pugi::xml_node node, const char* attribute, const std::string& value) {
    node.append_attribute(attribute).set_value(value.c_str());
}

/// A failure or an error, with what was measured as its message.
void add_problem(pugi::xml_node test, const char* element, const char* type, const std::string& message) {
    pugi::xml_node problem = test.append_child(element);
    set(problem, "message", message);
    set(problem, "type", type);
}

}  // namespace

std::string junit_xml(const studies::gates::CheckResults& check, const JunitContext& context) {
    FF_EXPECT(context.seconds.size() == check.results.size() && context.notes.size() == check.results.size());
    const std::size_t missing = check.spec.gates.size() - check.results.size();
    const double total = std::accumulate(context.seconds.begin(), context.seconds.end(), 0.0);
    pugi::xml_document document;
    pugi::xml_node declaration = document.append_child(pugi::node_declaration);
    set(declaration, "version", "1.0");
    set(declaration, "encoding", "UTF-8");
    pugi::xml_node suite = document.append_child("testsuites").append_child("testsuite");
    set(suite, "id", "0");
    set(suite, "name", check.spec.name);
    set(suite, "package", "ffstudy");
    set(suite, "timestamp", context.timestamp);
    set(suite, "hostname", context.hostname);
    set(suite, "tests", std::to_string(check.spec.gates.size()));
    set(suite, "failures", std::to_string(check.count(studies::gates::Verdict::fail)));
    set(suite, "errors", std::to_string(check.count(studies::gates::Verdict::inconclusive) + missing));
    set(suite, "time", fmt::format("{:.3f}", total));
    pugi::xml_node properties = suite.append_child("properties");
    for (const auto& [key, value] : {std::pair("seed", fmt::format("{}", check.spec.seed.value)),
                                     std::pair("alpha", fmt::format("{}", check.spec.alpha)),
                                     std::pair("power", fmt::format("{}", check.spec.power))}) {
        pugi::xml_node property = properties.append_child("property");
        set(property, "name", key);
        set(property, "value", value);
    }
    std::string console;  // output of the whole suite: Ant's schema lets no test case have its own
    for (const studies::gates::Gate& gate : check.spec.gates) {
        const auto found =
            std::find_if(check.results.begin(), check.results.end(),
                         [&](const studies::gates::GateResult& result) { return result.gate == gate.name; });
        const bool done = found != check.results.end();
        const auto index = static_cast<std::size_t>(found - check.results.begin());
        pugi::xml_node test = suite.append_child("testcase");
        set(test, "name", gate.name);
        set(test, "classname", fmt::format("{}.{}", check.spec.name, name(gate.kind)));
        set(test, "time", fmt::format("{:.3f}", done ? context.seconds[index] : 0.0));
        if (!done) {
            add_problem(test, "error", "not run", "not run yet, or stopped before");
            continue;
        }
        if (found->verdict == studies::gates::Verdict::fail)
            add_problem(test, "failure", "fail", gate_in_words(*found));
        if (found->verdict == studies::gates::Verdict::inconclusive)
            add_problem(test, "error", "inconclusive", gate_in_words(*found));
        console += gate_line(*found, Colour::none);
        if (!context.notes[index].empty()) console += fmt::format("{:<12}  {}\n", "", context.notes[index]);
    }
    suite.append_child("system-out").text().set(console.c_str());
    suite.append_child("system-err");
    std::ostringstream out;
    document.save(out, " ", pugi::format_default, pugi::encoding_utf8);
    return out.str();
}

}  // namespace ff::reports
