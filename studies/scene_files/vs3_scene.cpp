#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using LineWords = std::vector<std::string_view>;

class Vs3Reader {
  public:
    explicit Vs3Reader(std::string_view name) : builder_(name) {}

    void read_line(std::uint64_t line, const LineWords& words) {
        if (ended_ || words.empty() || words[0].front() == '!' || words[0].front() == '/') return;
        switch (words[0].front()) {
            case 'V':
            case 'v':
                return read_vertex(line, words);
            case 'S':
            case 's':
                return read_surface(line, words);
            case 'O':
            case 'o':
                builder_.add_polygon(corners(line, words), no_face, line);
                return;
            case 'C':
            case 'c':
                return read_control(words);
            case 'F':
            case 'f':
                if (words.size() < 2 || words[1] != "3")
                    builder_.fail(line,
                                  "only three-dimensional geometry is read (F 3). Give surfaces in three dimensions.");
                return;
            case 'E':
            case 'e':
            case '*':
                ended_ = true;
                return;
            case 'T':
            case 't':
                return;
            default:
                builder_.fail(line, fmt::format("'{}' begins no line of a View3D file. Begin it with T, C, F, V, S, O "
                                                "or E, or with ! for a comment.",
                                                excerpt(words[0])));
        }
    }

    SceneWithMaterials finish() {
        Scene scene = builder_.finish(closed_, &materials_);
        materials_.resize(scene.faces.size());
        return {std::move(scene), std::move(materials_)};
    }

  private:
    [[nodiscard]] long number(std::uint64_t line, const LineWords& words, std::size_t at) const {
        const auto value = at < words.size() ? parse_number<long>(words[at]) : std::nullopt;
        if (!value)
            builder_.fail(line,
                          fmt::format("field {} is {}. Write a whole number there.", at + 1,
                                      at < words.size() ? fmt::format("'{}', not a whole number", excerpt(words[at]))
                                                        : std::string("missing")));
        return *value;
    }

    void read_vertex(std::uint64_t line, const LineWords& words) {
        Eigen::Vector3d place;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto coordinate = i + 2 < words.size() ? finite_number(words[i + 2]) : std::nullopt;
            if (!coordinate) builder_.fail(line, "a vertex needs three finite coordinates. Write V 1 0 1 0.5.");
            place[static_cast<Eigen::Index>(i)] = *coordinate;
        }
        const long index = number(line, words, 1);
        if (!vertices_.emplace(index, place).second)
            builder_.fail(
                line,
                fmt::format("vertex {} is there twice (surfaces could mean either). Give one another number.", index));
    }

    /// Fields 2 to 5 after the surface's number; a triangle has a 0 in the last.
    [[nodiscard]] std::vector<Eigen::Vector3d> corners(std::uint64_t line, const LineWords& words) const {
        std::vector<Eigen::Vector3d> all;
        for (std::size_t i = 2; i < 6; ++i) {
            const long index = number(line, words, i);
            if (i == 5 && index == 0) break;
            const auto found = vertices_.find(index);
            if (found == vertices_.end()) {
                builder_.fail(line,
                              fmt::format("vertex {} is not there (vertices come first). Mend the index.", index));
            }
            all.push_back(found->second);
        }
        return all;
    }

    void read_surface(std::uint64_t line, const LineWords& words) {
        const long index = number(line, words, 1);
        if (words.size() > 6 && number(line, words, 6) != 0) {
            builder_.fail(line, "a surface on another one (field 'base') is not read. Divide the wall around it.");
        }
        const long combined = words.size() > 7 ? number(line, words, 7) : 0;
        const std::string label = words.size() > 9 ? std::string(words[9]) : std::to_string(index);
        int face = 0;
        if (combined != 0) {
            const auto found = faces_.find(combined);
            if (found == faces_.end()) {
                builder_.fail(line, fmt::format("the surface is to be combined with surface {}, which does not come "
                                                "before it. Move it, or write 0.",
                                                combined));
            }
            face = found->second;
        } else {
            face = builder_.face(label, line);
        }
        if (!faces_.emplace(index, face).second)
            builder_.fail(
                line,
                fmt::format("surface {} is there twice (others could mean either). Give one another number.", index));
        builder_.add_polygon(corners(line, words), face, line);
        if (const auto emissivity = words.size() > 8 ? finite_number(words[8]) : std::nullopt)
            add_emissivity(static_cast<std::size_t>(face), *emissivity);
    }

    void add_emissivity(std::size_t face, double emissivity) {
        if (face >= materials_.size()) materials_.resize(face + 1);
        auto& known = materials_[face].emissivities;
        if (std::find(known.begin(), known.end(), emissivity) == known.end()) known.push_back(emissivity);
    }

    void read_control(const LineWords& words) {
        for (const std::string_view word : words) {
            if (word == "encl=1" || word == "encl=1,") closed_ = true;
        }
    }

    SceneBuilder builder_;
    std::map<long, Eigen::Vector3d> vertices_;
    std::map<long, int> faces_;  ///< by number of a surface
    std::vector<FaceMaterial> materials_;
    bool closed_ = false;
    bool ended_ = false;
};

}  // namespace

SceneWithMaterials read_vs3_scene(std::string_view name, std::string_view text) {
    Vs3Reader reader(name);
    for_each_line(text,
                  [&](std::uint64_t number, std::string_view line) { reader.read_line(number, split_words(line)); });
    return reader.finish();
}

}  // namespace ff::studies
