#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/scene_with_materials.hpp"
#include "studies/scene_files/vs3_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace ff::studies {
namespace {

using Eigen::Vector3d;
using LineWords = std::vector<std::string_view>;

char upper(char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

class Vs3Reader {
  public:
    explicit Vs3Reader(std::string_view name) : builder_(name) {}

    void read_line(std::uint64_t line, const LineWords& words) {
        if (ended_ || words.empty() || words[0].front() == '/') return;
        if (pending_) return read_numbers(line, words);
        switch (upper(words[0].front())) {
            case 'V':
                return read_vertex(line, words);
            case 'S':
            case 'O':
            case 'M':
            case 'N':
                return read_surface(line, words);
            case 'C':
                return read_control(line, words);
            case 'F':
                return read_format(line, words);
            case 'E':
            case '*':
                ended_ = true;
                return;
            case 'T':
            case 'X':  // passed over by View3D too
                return;
            default:
                builder_.fail(line,
                              "no line of a View3D file begins with '{}'. Begin it with T, C, F, V, S, O, M, N or E, "
                              "or with ! for a comment.",
                              excerpt(words[0]));
        }
    }

    SceneWithMaterials finish() {
        if (pending_)
            builder_.fail(surfaces_.back().line,
                          "numbers are missing: it has {} of {}. Write the rest on the next line.",
                          pending_->numbers.size(), pending_->wanted());
        std::vector<Vs3Surface*> sound;
        for (Vs3Surface& surface : surfaces_) {
            if (builder_.has_area(surface.corners, surface.line)) sound.push_back(&surface);
        }
        // Parts that lie on a surface are cut out of it, and get their final corners before that.
        for (Vs3Surface* const surface : sound) {
            if (surface->base != 0) fit(*surface);
        }
        for (const Vs3Surface* const surface : sound) add(*surface);
        if (moved_ > 0)
            builder_.remark("{} put into the plane and the outline of {} (off by at most {:.2g})",
                            moved_ == 1 ? "a surface is" : fmt::format("{} surfaces are", moved_),
                            moved_ == 1 ? "its base" : "their bases", most_moved_);
        if (closed_ && !masks_.empty())
            builder_.remark(
                "it has masks, whose backs receive what is counted for no face, so that it is taken as open");
        Scene scene = builder_.finish(closed_ && masks_.empty(), &materials_);
        scene.masks = std::move(masks_);
        materials_.resize(scene.faces.size());
        materials_.insert(materials_.end(), materials_of_masks_.begin(), materials_of_masks_.end());
        return {std::move(scene), std::move(materials_)};
    }

  private:
    SceneBuilder builder_;
    bool places_shapes_ = false;       ///< format 3a
    std::optional<Vs3Shape> pending_;  ///< shape that the numbers of the next lines belong to
    std::map<long, Vector3d> vertices_;
    std::vector<Vs3Surface> surfaces_;
    std::map<long, std::size_t> by_number_;           ///< place in `surfaces_`
    std::map<long, std::vector<std::size_t>> parts_;  ///< places in `surfaces_`, by the number of their base
    std::map<long, int> faces_;                       ///< faces by the number of a surface
    std::vector<MaskedPart> masks_;
    std::vector<FaceMaterial> materials_;
    std::vector<FaceMaterial> materials_of_masks_;
    std::size_t moved_ = 0;  ///< number of parts that did not fit their bases because of rounding
    double most_moved_ = 0;
    bool closed_ = false;
    bool ended_ = false;

    [[nodiscard]] std::string word_at(const LineWords& words, std::size_t at) const {
        return at < words.size() ? fmt::format("'{}'", excerpt(words[at])) : std::string("missing");
    }

    [[nodiscard]] long number(std::uint64_t line, const LineWords& words, std::size_t at) const {
        const auto value = at < words.size() ? parse_number<long>(words[at]) : std::nullopt;
        if (!value)
            builder_.fail(line, "field {} is {}{}. Write a whole number there.", at + 1, word_at(words, at),
                          at < words.size() ? ", not a whole number" : "");
        return *value;
    }

    void read_format(std::uint64_t line, const LineWords& words) {
        places_shapes_ = words.size() > 1 && in_small_letters(words[1]) == "3a";
        if (places_shapes_ || (words.size() > 1 && words[1] == "3")) return;
        builder_.fail(line,
                      "only three-dimensional geometry is read (F 3 or F 3a). Give surfaces in three dimensions.");
    }

    void read_vertex(std::uint64_t line, const LineWords& words) {
        Vector3d place;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto coordinate = i + 2 < words.size() ? finite_number(words[i + 2]) : std::nullopt;
            if (!coordinate) builder_.fail(line, "a vertex needs three finite coordinates. Write V 1 0 1 0.5.");
            place[static_cast<Eigen::Index>(i)] = *coordinate;
        }
        const long index = number(line, words, 1);
        if (!vertices_.emplace(index, place).second)
            builder_.fail(line, "vertex {} is defined twice (surfaces could mean either). Give one another number.",
                          index);
    }

    /// Fields 2 to 5 after the surface's number; a triangle has a 0 in the last.
    [[nodiscard]] std::vector<Vector3d> corners(std::uint64_t line, const LineWords& words) const {
        std::vector<Vector3d> all;
        for (std::size_t i = 2; i < 6; ++i) {
            const long index = number(line, words, i);
            if (i == 5 && index == 0) break;
            const auto found = vertices_.find(index);
            if (found == vertices_.end()) {
                builder_.fail(line, "vertex {} is not defined (vertices come first). Correct the index.", index);
            }
            all.push_back(found->second);
        }
        return all;
    }

    void read_surface(std::uint64_t line, const LineWords& words) {
        Vs3Surface surface;
        surface.kind = upper(words[0].front());
        surface.line = line;
        surface.number = number(line, words, 1);
        std::size_t next = 6;
        if (places_shapes_) {
            next = 3;
            const char shape = words.size() > 2 ? upper(words[2].front()) : ' ';
            if (shape != 'R' && shape != 'T' && shape != 'Q')
                builder_.fail(line,
                              "field 3 is {} (expected a shape). Write R for a rectangle, T for a triangle or Q for a "
                              "quadrilateral.",
                              word_at(words, 2));
            pending_ = Vs3Shape{shape, {}};
        } else {
            surface.corners = corners(line, words);
        }
        if (surface.kind != 'O') {
            if (words.size() > next) surface.base = number(line, words, next);
            if (words.size() > next + 1) surface.combined = number(line, words, next + 1);
            if (words.size() > next + 2) surface.emissivity = emissivity(line, words, next + 2);
            if (words.size() > next + 3)
                surface.name = fmt::format(
                    "{}", fmt::join(words.begin() + static_cast<std::ptrdiff_t>(next) + 3, words.end(), " "));
        }
        if (surface.name.empty()) surface.name = std::to_string(surface.number);
        if (!by_number_.emplace(surface.number, surfaces_.size()).second)
            builder_.fail(line, "surface {} is defined twice (others could mean either). Give one another number.",
                          surface.number);
        if (surface.base != 0) parts_[surface.base].push_back(surfaces_.size());
        surfaces_.push_back(std::move(surface));
    }

    double emissivity(std::uint64_t line, const LineWords& words, std::size_t at) const {
        const auto value = finite_number(words[at]);
        if (!value || *value < 0 || *value > 1)
            builder_.fail(line, "field {} is {} (expected an emissivity, from 0 to 1). Write it there.", at + 1,
                          word_at(words, at));
        return *value;
    }

    void read_numbers(std::uint64_t line, const LineWords& words) {
        for (std::size_t k = 0; k < words.size() && pending_->numbers.size() < pending_->wanted(); ++k) {
            const auto value = finite_number(words[k]);
            if (!value)
                builder_.fail(line, "field {} is {} (expected number {} of {} of surface {}). Write it there.", k + 1,
                              word_at(words, k), pending_->numbers.size() + 1, pending_->wanted(),
                              surfaces_.back().number);
            pending_->numbers.push_back(*value);
        }
        if (pending_->numbers.size() < pending_->wanted()) return;
        surfaces_.back().corners = pending_->corners();
        pending_.reset();
    }

    /// Words and values with blanks, commas or = between them.
    void read_control(std::uint64_t line, const LineWords& words) {
        constexpr std::array<std::string_view, 12> known{"eps",  "list", "out", "emit", "maxu", "maxo",
                                                         "mino", "row",  "col", "prjd", "maxv", "encl"};
        const std::string all = fmt::format("{}", fmt::join(words.begin() + 1, words.end(), " "));
        const auto parts = split_words(all, " =,");
        for (std::size_t k = 0; k < parts.size(); k += 2) {
            const std::string_view word = parts[k];
            const auto value = k + 1 < parts.size() ? finite_number(parts[k + 1]) : std::nullopt;
            const bool is_set = value.value_or(0) != 0;
            const std::string small = in_small_letters(word);
            if (std::find(known.begin(), known.end(), small) == known.end()) {
                builder_.remark("control word '{}' (line {}) is unknown and is passed over", excerpt(word), line);
            } else if (!value) {
                builder_.fail(line, "control word '{}' has no number. Write {}=1.", excerpt(word), excerpt(word));
            } else if (small == "encl") {
                closed_ = is_set;
            } else if (small == "emit" && is_set) {
                builder_.remark(
                    "control word 'emit' asks for factors with emissivities, which ffstudy heat --gebhart "
                    "gives; these are without");
            }
        }
    }

    /// The surface with that number. @throws UserError where it is not defined before
    [[nodiscard]] const Vs3Surface& earlier(const Vs3Surface& surface, long number, std::string_view what) const {
        const auto found = by_number_.find(number);
        if (found == by_number_.end() || found->second >= by_number_.at(surface.number))
            builder_.fail(surface.line, "surface {} {} surface {}, which does not come before it. Move it, or write 0.",
                          surface.number, what, number);
        return surfaces_[found->second];
    }

    void fit(Vs3Surface& part) {
        const Vs3Surface& base = earlier(part, part.base, "lies on");
        const FitOnBase found = fit_on_base(part, base, most_off_base * size_of(base.corners));
        if (!found.problem.empty())
            builder_.fail(part.line, "surface {} {} surface {}, its base{}. Correct it, or write 0.", part.number,
                          found.problem, base.number, found.reason);
        if (found.off > 0) ++moved_;
        most_moved_ = std::max(most_moved_, found.off);
    }

    void expect_apart(const Vs3Surface& part) const {
        const Vs3Surface& base = earlier(part, part.base, "lies on");
        for (const std::size_t other : parts_.at(base.number)) {
            if (surfaces_[other].number != part.number && part.kind != 'S' && overlap(base, part, surfaces_[other]))
                builder_.fail(part.line, "surface {} overlaps surface {}, both on surface {}. Divide them.",
                              part.number, surfaces_[other].number, base.number);
        }
    }

    /// A surface without what lies on it.
    [[nodiscard]] std::vector<ConvexPolygon> left_of(const Vs3Surface& surface) const {
        std::vector<const Vs3Surface*> parts;
        if (const auto found = parts_.find(surface.number); found != parts_.end()) {
            for (const std::size_t part : found->second) parts.push_back(&surfaces_[part]);
        }
        return left_of_base(surface, parts);
    }

    void add(const Vs3Surface& surface) {
        if (surface.kind == 'O') return builder_.add_polygon(surface.corners, no_face, surface.line);
        if (surface.base != 0) expect_apart(surface);
        if (surface.kind != 'S') return add_part(surface);
        const std::vector<ConvexPolygon> pieces = left_of(surface);
        if (pieces.empty())
            return builder_.remark("what lies on '{}' leaves nothing of it; it is no face", surface.name);
        int face = no_face;
        if (surface.combined == 0) {
            face = builder_.new_face(surface.name, surface.line);
        } else {
            const auto found = faces_.find(earlier(surface, surface.combined, "is to be combined with").number);
            if (found == faces_.end())
                builder_.fail(surface.line, "surface {} is to be combined with surface {}, which is no face. Write 0.",
                              surface.number, surface.combined);
            face = found->second;
        }
        faces_.emplace(surface.number, face);
        add_emissivity(static_cast<std::size_t>(face), surface.emissivity);
        for (const ConvexPolygon& piece : pieces) builder_.add_polygon(piece, face, surface.line);
    }

    /// A surface that faces its base, and takes a part of it out of sight.
    void add_part(const Vs3Surface& part) {
        if (part.base == 0)
            builder_.fail(
                part.line,
                "surface {} has no base (it lies on another surface and faces it). Write the number of that surface.",
                part.number);
        if (part.kind == 'N') return;
        const auto base = faces_.find(part.base);
        if (base == faces_.end())
            builder_.fail(part.line,
                          "surface {} masks surface {}, which is no surface that radiates. Correct the base.",
                          part.number, part.base);
        materials_of_masks_.emplace_back();
        if (part.emissivity) materials_of_masks_.back().emissivities.push_back(*part.emissivity);
        masks_.push_back(
            {builder_.reserve_name(part.name), builder_.name_of(base->second), polygon_area(part.corners)});
    }

    void add_emissivity(std::size_t face, std::optional<double> emissivity) {
        if (!emissivity) return;
        if (face >= materials_.size()) materials_.resize(face + 1);
        auto& known = materials_[face].emissivities;
        if (std::find(known.begin(), known.end(), *emissivity) == known.end()) known.push_back(*emissivity);
    }
};

}  // namespace

SceneWithMaterials read_vs3_scene(std::string_view name, std::string_view text) {
    Vs3Reader reader(name);
    for_each_line(text, [&](std::uint64_t number, std::string_view line) {
        reader.read_line(number, split_words(line.substr(0, line.find('!')), " \t\r,"));
    });
    return reader.finish();
}

}  // namespace ff::studies
