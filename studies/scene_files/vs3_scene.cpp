#include "core/support/excerpt.hpp"
#include "core/support/words.hpp"
#include "studies/scene_files/builder.hpp"
#include "studies/scene_files/formats.hpp"
#include "studies/scene_files/scene_with_materials.hpp"
#include "studies/scene_files/vs3_line.hpp"
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

char upper(char c) {
    return static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
}

class Vs3Reader {
  public:
    explicit Vs3Reader(std::string_view name) : builder_(name) {}

    void read_line(std::uint64_t number, std::string_view text) {
        const Vs3Line line(builder_, number, text);
        if (ended_ || line.empty() || line[0].front() == '/') return;
        if (pending_) return read_numbers(line);
        switch (upper(line[0].front())) {
            case 'V':
                return read_vertex(line);
            case 'S':
            case 'O':
            case 'M':
            case 'N':
                return read_surface(line);
            case 'C':
                return read_control(line);
            case 'F':
                return read_format(line);
            case 'E':
            case '*':
                ended_ = true;
                return;
            case 'T':
            case 'X':  // passed over by View3D too
                return;
            default:
                builder_.fail(line.place(),
                              "no line of a View3D file begins with '{}'. Begin it with T, C, F, V, S, O, M, N or E, "
                              "or with ! for a comment.",
                              excerpt(line[0]));
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
        if (closed_ && hole_)
            builder_.remark("null surface {} leaves a hole in surface {}, so that the scene is taken as open",
                            hole_->number, hole_->base);
        Scene scene = builder_.finish(closed_ && masks_.empty() && !hole_, &materials_);
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
    const Vs3Surface* hole_ = nullptr;                ///< the first null surface, if there is one
    std::vector<MaskedPart> masks_;
    std::vector<FaceMaterial> materials_;
    std::vector<FaceMaterial> materials_of_masks_;
    std::size_t moved_ = 0;  ///< number of parts that did not fit their bases because of rounding
    double most_moved_ = 0;
    bool closed_ = false;
    bool ended_ = false;

    void read_format(const Vs3Line& line) {
        places_shapes_ = line.size() > 1 && in_small_letters(line[1]) == "3a";
        if (places_shapes_ || (line.size() > 1 && line[1] == "3")) return;
        builder_.fail(line.place(),
                      "only three-dimensional geometry is read (F 3 or F 3a). Give surfaces in three dimensions.");
    }

    void read_vertex(const Vs3Line& line) {
        Vector3d place;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto coordinate = i + 2 < line.size() ? finite_number(line[i + 2]) : std::nullopt;
            if (!coordinate) builder_.fail(line.place(), "a vertex needs three finite coordinates. Write V 1 0 1 0.5.");
            place[static_cast<Eigen::Index>(i)] = *coordinate;
        }
        line.expect_no_number(5, "a vertex has three coordinates");
        const long index = line.whole(1);
        if (!vertices_.emplace(index, place).second)
            builder_.fail(line.place(),
                          "vertex {} is defined twice (surfaces could mean either). Give one another number.", index);
    }

    /// Fields 2 to 5 after the surface's number; a triangle has a 0 in the last.
    [[nodiscard]] std::vector<Vector3d> corners(const Vs3Line& line) const {
        std::vector<Vector3d> all;
        for (std::size_t i = 2; i < 6; ++i) {
            const long index = line.whole(i);
            if (i == 5 && index == 0) break;
            const auto found = vertices_.find(index);
            if (found == vertices_.end()) {
                builder_.fail(line.place(), "vertex {} is not defined (vertices come first). Correct the index.",
                              index);
            }
            all.push_back(found->second);
        }
        return all;
    }

    void read_surface(const Vs3Line& line) {
        Vs3Surface surface;
        surface.kind = upper(line[0].front());
        surface.line = line.place();
        surface.number = line.whole(1);
        std::size_t next = 6;
        if (places_shapes_) {
            next = 3;
            const char shape = line.size() > 2 ? upper(line[2].front()) : ' ';
            if (shape != 'R' && shape != 'T' && shape != 'Q')
                builder_.fail(line.place(),
                              "field 3 is {} (expected a shape). Write R for a rectangle, T for a triangle or Q for a "
                              "quadrilateral.",
                              line.word(2));
            pending_ = Vs3Shape{shape, {}};
        } else {
            surface.corners = corners(line);
        }
        if (surface.kind != 'O') {
            if (line.size() > next) surface.base = line.whole(next);
            if (line.size() > next + 1) surface.combined = line.whole(next + 1);
            if (line.size() > next + 2) surface.emissivity = line.emissivity(next + 2);
            if (line.size() > next + 3) surface.name = line.rest(next + 3);
        }
        if (surface.name.empty()) surface.name = std::to_string(surface.number);
        if (!by_number_.emplace(surface.number, surfaces_.size()).second)
            builder_.fail(line.place(),
                          "surface {} is defined twice (others could mean either). Give one another number.",
                          surface.number);
        if (surface.base != 0) parts_[surface.base].push_back(surfaces_.size());
        surfaces_.push_back(std::move(surface));
    }

    void read_numbers(const Vs3Line& line) {
        std::size_t used = 0;
        for (; used < line.size() && pending_->numbers.size() < pending_->wanted(); ++used) {
            const auto value = finite_number(line[used]);
            if (!value)
                builder_.fail(line.place(), "field {} is {} (expected number {} of {} of surface {}). Write it there.",
                              used + 1, line.word(used), pending_->numbers.size() + 1, pending_->wanted(),
                              surfaces_.back().number);
            pending_->numbers.push_back(*value);
        }
        if (pending_->numbers.size() < pending_->wanted()) return;
        line.expect_no_number(used,
                              fmt::format("surface {} has {} numbers", surfaces_.back().number, pending_->wanted()));
        surfaces_.back().corners = pending_->corners();
        pending_.reset();
    }

    /// Words and values with blanks, commas or = between them.
    void read_control(const Vs3Line& line) {
        constexpr std::array<std::string_view, 12> known{"eps",  "list", "out", "emit", "maxu", "maxo",
                                                         "mino", "row",  "col", "prjd", "maxv", "encl"};
        const std::string all = line.rest(1);
        const auto parts = split_words(all, " =,");
        for (std::size_t k = 0; k < parts.size(); k += 2) {
            const std::string_view word = parts[k];
            const auto value = k + 1 < parts.size() ? finite_number(parts[k + 1]) : std::nullopt;
            const bool is_set = value.value_or(0) != 0;
            const std::string small = in_small_letters(word);
            if (std::find(known.begin(), known.end(), small) == known.end()) {
                builder_.remark("control word '{}' (line {}) is unknown and is passed over", excerpt(word),
                                line.place());
            } else if (!value) {
                builder_.fail(line.place(), "control word '{}' has no number. Write {}=1.", excerpt(word),
                              excerpt(word));
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
        if (part.kind == 'N') {
            if (!hole_) hole_ = &part;
            return;
        }
        const auto base = faces_.find(part.base);
        if (base == faces_.end())
            builder_.fail(part.line, "surface {} masks surface {}, {}. Correct the base.", part.number, part.base,
                          is_wholly_covered(part.base) ? "nothing of which is left beside what lies on it"
                                                       : "which is no surface that radiates");
        materials_of_masks_.emplace_back();
        if (part.emissivity) materials_of_masks_.back().emissivities.push_back(*part.emissivity);
        masks_.push_back(
            {builder_.reserve_name(part.name), builder_.name_of(base->second), polygon_area(part.corners)});
    }

    /// Whether a surface radiates, but other surfaces take all of its area.
    [[nodiscard]] bool is_wholly_covered(long number) const {
        const auto found = by_number_.find(number);
        return found != by_number_.end() && surfaces_[found->second].kind == 'S';
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
    for_each_line(text, [&](std::uint64_t number, std::string_view line) { reader.read_line(number, line); });
    return reader.finish();
}

}  // namespace ff::studies
