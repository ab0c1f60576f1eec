#include "studies/scene_files/meshes/whole_file.hpp"

#include "core/support/error.hpp"
#include "core/support/words.hpp"
#include "studies/readers/text_file.hpp"

#include "studies/scene_files/meshes/mesh_kind.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

namespace ff::studies::meshes {
namespace {

using Words = std::vector<std::string_view>;

/// The numbers of vertices, polygons and so on that a header states.
std::vector<std::uint64_t> stated_counts(std::string_view beginning) {
    std::vector<std::uint64_t> counts;
    const bool is_ply = beginning.starts_with("ply");
    bool ended = !is_ply && !beginning.starts_with("OFF");
    for_each_line(beginning, [&](std::uint64_t, std::string_view line) {
        Words words = split_words(line.substr(0, line.find('#')));
        if (!is_ply && !words.empty() && words.front() == "OFF") words.erase(words.begin());
        if (ended || words.empty()) return;
        if (!is_ply) {  // the first numbers are those of vertices, polygons and edges
            for (const std::string_view word : words) counts.push_back(parse_number<std::uint64_t>(word).value_or(0));
            ended = true;
        } else if (words.front() == "element" && words.size() > 2) {
            counts.push_back(parse_number<std::uint64_t>(words[2]).value_or(0));
        } else {
            ended = words.front() == "end_header";
        }
    });
    return counts;
}

}  // namespace

void expect_whole(std::string_view file, std::string_view beginning, std::uint64_t size) {
    for (const std::uint64_t count : stated_counts(beginning)) {
        if (count <= size) continue;
        throw UserError(
            fmt::format("{}: its header counts {} elements (the file has {} bytes, too few for them). Write it again.",
                        file, count, size));
    }
    if (!is_text_stl(beginning)) return;
    const std::string text = read_bytes(file);
    const std::size_t end = text.rfind("endsolid");
    const std::size_t facet = text.rfind("endfacet");
    if (end == std::string::npos || (facet != std::string::npos && facet > end))
        throw UserError(fmt::format("{}: no 'endsolid' after its last facet (it was cut off). Write it again.", file));
}

}  // namespace ff::studies::meshes
