#include "samplers/outside/outside_points.hpp"

#include "core/support/contract.hpp"
#include "core/support/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <utility>

namespace ff::samplers {
namespace {

class OutsidePoints final : public PointSource {
  public:
    OutsidePoints(std::uint64_t points, bool randomised, FillPart fill)
        : points_(points), randomised_(randomised), fill_(std::move(fill)) {}

    [[nodiscard]] std::uint64_t points() const override { return points_; }
    [[nodiscard]] bool randomised() const override { return randomised_; }
    [[nodiscard]] bool equal_weights() const override { return true; }

    using PointSource::fill;
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        FF_EXPECT(block.size <= block_capacity && first + block.size <= points_);
        fill_(request_of(stream, points_, block.dimension), first, block);
    }

  private:
    std::uint64_t points_;
    bool randomised_;
    FillPart fill_;
};

}  // namespace

SetRequest request_of(const Stream& stream, std::uint64_t points, std::size_t dimension) {
    const Words words = philox(stream, 0, Purpose::engine);
    return {points, dimension, std::uint64_t{words[0]} << 32 | words[1], stream.trial};
}

std::string in_words(const SetRequest& request) {
    return fmt::format("trial {}, seed {}, {} points of {} coordinates", request.trial, request.seed, request.points,
                       request.dimension);
}

void expect_whole(const std::string& origin, const SetRequest& request) {
    constexpr std::uint64_t most = std::uint64_t{1} << 28;  // 2 GiB of doubles
    if (request.points <= most / request.dimension) return;
    throw UserError("{}: {} points of {} coordinates (made at once, a set has at most {} numbers). Take fewer points.",
                    origin, request.points, request.dimension, most);
}

FillPart parts_of(MakeSet make) {
    static std::atomic<std::uint64_t> makers{0};
    return [make = std::move(make), maker = ++makers](const SetRequest& request, PointIndex first, PointBlock& block) {
        struct Kept {
            std::uint64_t maker = 0;
            SetRequest request;
            PointSet set;
        };
        thread_local Kept kept;
        if (kept.maker != maker || kept.request != request) {
            kept.maker = 0;  // in case `make` fails
            make(request, kept.set);
            FF_ENSURE(kept.set.points >= request.points && kept.set.dimension >= request.dimension);
            kept.request = request;
            kept.maker = maker;
        }
        for (std::size_t d = 0; d < block.dimension; ++d) {
            const auto from = kept.set.row(0, d).subspan(first, block.size);
            std::copy(from.begin(), from.end(), block.coordinate[d].begin());
        }
    };
}

std::unique_ptr<PointSource> outside_points(std::uint64_t points, bool randomised, FillPart fill) {
    return std::make_unique<OutsidePoints>(points, randomised, std::move(fill));
}

}  // namespace ff::samplers
