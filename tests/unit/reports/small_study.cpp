#include "tests/unit/reports/small_study.hpp"

#include "tests/support/studies.hpp"

#include <array>
#include <filesystem>
#include <sstream>

namespace ff::test {

const studies::Store& small_store() {
    static const studies::Store made = run(plan_of(R"([study]
name = "small, with a comma"
title = "Small"
scene = ["cube", "box:2x1x0.5"]
trials = 8
seed = 1
equivalence_margin = 0.5

[[method]]
name = "SR \"quoted\""
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
patches_per_face = [1, 4]
samples_per_patch = 81

[[method]]
name = "direct"
sampler = "sobol"
estimator = "ray_shooting"
allocation = "face"
patches_per_face = 4
samples_per_patch = 100

[[method]]
name = "kernel"
sampler = "random"
estimator = "area_kernel"
samples_per_patch = 50

[[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = [2, 3]
estimator = "area_kernel"
patches_per_face = [1, 4]

[[method]]
name = "exact"
estimator = "closed_form"
)"));
    return made;
}

const studies::StudyResults& small_results() {
    static const studies::StudyResults made = studies::evaluate(small_store());
    return made;
}

const studies::StudyResults& published_results() {
    static const studies::StudyResults made = [] {
        studies::StudySpec spec = studies::parse_study(R"([study]
name = "published"
scene = "cube"
trials = 20
seed = 1

[[method]]
name = "SR"
sampler = "random"
estimator = "ray_shooting"
completion = "reciprocal"
sizes = [ { patches_per_face = 4, samples_per_patch = 100 } ]

[[method]]
name = "PDM"
sampler = "gauss_legendre"
nodes = 2
estimator = "area_kernel"
patches_per_face = [4, 9]
)",
                                                       "study.toml");
        spec.published = studies::Published{"tables.json", R"({
          "source": "A small publication", "scene": "cube",
          "printing": {"rule": "rounded", "decimals": 6},
          "methods": [{"name": "PDM", "samples": false, "completion": "direct"},
                      {"name": "SR", "samples": true, "completion": "reciprocal"}],
          "tables": [{"id": "table1", "title": "Pairs", "note": "Printed once.",
            "columns": [{"title": "PDM", "method": "PDM", "patches_per_face": 4},
                        {"title": "SR", "method": "SR", "patches_per_face": 4, "samples_per_patch": 100}],
            "rows": [{"title": "1 - 6", "quantity": "F 1-6", "printed": ["0.200000", "0.205000"]},
                     {"title": "2 - 3", "quantity": "F 2-3", "printed": ["0.200000", "0.200000"]},
                     {"title": "4 - 5", "quantity": "F 4-5", "printed": ["0.200000", "0.200000"]},
                     {"title": "1 - 2", "quantity": "F 1-2", "printed": ["0.300000", "0.900000"]},
                     {"title": "sum 1", "quantity": "sum 1", "printed": [null, "1.0"]},
                     {"title": "sum 6", "quantity": "sum 6", "printed": [null, "5.0"]}]}],
          "claims": [{"id": "c", "section": "1", "statement": "PDM is better.", "kind": "smaller_error",
                      "methods": ["PDM", "SR"], "pair_class": "parallel"}]})"};
        return studies::evaluate(run(studies::plan_study(spec)));
    }();
    return made;
}

const reports::Templates& shipped_templates() {
    static const std::array<std::filesystem::path, 2> folders{FF_TEMPLATES, FF_PICTURES};
    static const auto templates = reports::Templates::read(folders);
    return templates;
}

std::vector<std::string> csv_fields(std::string_view line) {
    std::vector<std::string> fields(1);
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '"' && quoted && i + 1 < line.size() && line[i + 1] == '"') {
            fields.back() += line[i++];
        } else if (line[i] == '"') {
            quoted = !quoted;
        } else if (line[i] == ',' && !quoted) {
            fields.emplace_back();
        } else {
            fields.back() += line[i];
        }
    }
    return fields;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace ff::test
