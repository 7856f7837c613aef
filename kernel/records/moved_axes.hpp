// A set of machine axes (from 0), visited without looking at those that are not in it.
#pragma once
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

#include "ipc/capacities.hpp"

namespace polyturn::kernel {

class MovedAxes {
public:
    void add(std::size_t axis) noexcept { words_[axis / 64] |= std::uint64_t{1} << axis % 64; }
    void add(const MovedAxes& others) noexcept {
        for (std::size_t w = 0; w < words_.size(); ++w) words_[w] |= others.words_[w];
    }
    bool any() const noexcept {
        for (const std::uint64_t word : words_)
            if (word != 0) return true;
        return false;
    }
    template <class Visit>
    void each(Visit visit) const {
        for (std::size_t w = 0; w < words_.size(); ++w)
            for (std::uint64_t left = words_[w]; left != 0; left &= left - 1)
                visit(w * 64 + static_cast<std::size_t>(std::countr_zero(left)));
    }

private:
    std::array<std::uint64_t, (kMaxAxes + 63) / 64> words_{};
};

}  // namespace polyturn::kernel
