#include "studies/run/interruptible_points.hpp"

#include <utility>

namespace ff::studies {
namespace {

class InterruptiblePoints : public PointSource {
  public:
    InterruptiblePoints(std::unique_ptr<PointSource> points, const std::atomic<bool>& stop)
        : points_(std::move(points)), stop_(stop) {}

    [[nodiscard]] std::uint64_t points() const override { return points_->points(); }
    [[nodiscard]] bool randomised() const override { return points_->randomised(); }
    [[nodiscard]] bool equal_weights() const override { return points_->equal_weights(); }
    [[nodiscard]] bool exchangeable() const override { return points_->exchangeable(); }
    void checkpoint() const override {
        if (stop_.load(std::memory_order_relaxed)) throw Interrupted{};
    }
    void fill(const Stream& stream, PointIndex first, PointBlock& block) const override {
        checkpoint();
        points_->fill(stream, first, block);
    }
    void fill(const Stream& stream, PointIndex first, WeightedBlock& block) const override {
        checkpoint();
        points_->fill(stream, first, block);
    }

  private:
    std::unique_ptr<PointSource> points_;
    const std::atomic<bool>& stop_;
};

}  // namespace

std::unique_ptr<PointSource> interruptible(std::unique_ptr<PointSource> points, const std::atomic<bool>& stop) {
    return std::make_unique<InterruptiblePoints>(std::move(points), stop);
}

}  // namespace ff::studies
