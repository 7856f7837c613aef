// The path ahead, as far as needed: stretches with a speed limit and other limits each, up to the
// next standstill.
#pragma once
#include <array>
#include <cstdint>
#include <limits>

#include "kernel/motion/limits.hpp"

namespace polyturn::kernel {

struct Stretch {
    double begin;        // mm from the present point
    double speed_limit;  // mm/s
    Limits limits;
};

class Road {
public:
    static constexpr std::uint32_t kStretches = 128;

    // Stretch i, complete; null: the road ends before it.
    [[nodiscard]] const Stretch* stretch(std::uint32_t i) noexcept {
        while (i + 1 >= count_ && !closed_) more();
        return i < count_ ? &stretches_[i] : nullptr;
    }
    // Where stretch i ends: the next begins, or the path must stop.
    [[nodiscard]] double end_of(std::uint32_t i) noexcept {
        while (i + 1 >= count_ && !closed_) more();
        return i + 1 < count_ ? stretches_[i + 1].begin : end_;
    }
    [[nodiscard]] bool closed() const noexcept { return closed_; }  // all of it is known
    // the path must stop there; infinity: not seen yet
    [[nodiscard]] double end() const noexcept { return end_; }

protected:
    ~Road() = default;
    void clear() noexcept {
        count_ = 0;
        closed_ = false;
        end_ = std::numeric_limits<double>::infinity();
    }
    // false: no room
    bool begin_stretch(double at, double speed_limit, const Limits& limits) noexcept {
        if (count_ == kStretches) return false;
        stretches_[count_++] = {at, speed_limit, limits};
        return true;
    }
    void close(double end) noexcept {
        closed_ = true;
        end_ = end;
    }
    // Begins another stretch (so that the one before is complete) or closes.
    virtual void more() noexcept = 0;

    std::uint32_t count_ = 0;
    std::array<Stretch, kStretches> stretches_;

private:
    bool closed_ = false;
    double end_ = std::numeric_limits<double>::infinity();
};

}  // namespace polyturn::kernel
