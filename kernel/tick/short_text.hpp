// Builds the text of an event in its own 160 bytes: no allocation and no printf in the cyclic
// thread. What does not fit is truncated.
#pragma once
#include <array>
#include <charconv>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace polyturn::kernel {

class ShortText {
public:
    static constexpr std::size_t kCapacity = 160;
    ShortText() = default;
    explicit ShortText(std::string_view text) { *this << text; }

    ShortText& operator<<(std::string_view text) noexcept {
        for (const char c : text)
            if (size_ + 1 < kCapacity) bytes_[size_++] = c;
        return *this;
    }
    ShortText& operator<<(std::int64_t number) noexcept {
        char digits[24];
        const auto end = std::to_chars(digits, digits + sizeof digits, number).ptr;
        return *this << std::string_view(digits, static_cast<std::size_t>(end - digits));
    }
    ShortText& operator<<(std::uint32_t number) noexcept {
        return *this << static_cast<std::int64_t>(number);
    }
    ShortText& operator<<(int number) noexcept {
        return *this << static_cast<std::int64_t>(number);
    }
    // At most three decimals, trailing zeros cut: what an operator reads.
    ShortText& operator<<(double value) noexcept {
        if (!(value > -1e15 && value < 1e15)) return *this << "-";
        const bool negative = value < 0;
        auto thousandths = static_cast<std::int64_t>((negative ? -value : value) * 1000.0 + 0.5);
        if (negative && thousandths) *this << "-";
        *this << thousandths / 1000;
        std::int64_t rest = thousandths % 1000;
        if (!rest) return *this;
        char decimals[4] = {'.', static_cast<char>('0' + rest / 100),
                            static_cast<char>('0' + rest / 10 % 10),
                            static_cast<char>('0' + rest % 10)};
        std::size_t length = 4;
        while (decimals[length - 1] == '0') --length;
        return *this << std::string_view(decimals, length);
    }
    // "L1, L3": the channels of a set (bit 0 is channel 1).
    ShortText& channels(std::uint32_t set) noexcept {
        bool first = true;
        for (std::uint32_t l = 0; l < 32; ++l)
            if (set >> l & 1u) {
                *this << (first ? "L" : ", L") << l + 1;
                first = false;
            }
        return *this;
    }
    std::string_view view() const noexcept { return {bytes_.data(), size_}; }

private:
    std::array<char, kCapacity> bytes_{};
    std::size_t size_ = 0;
};

}  // namespace polyturn::kernel
