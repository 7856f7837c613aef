// Small choices out of a fuzzer's bytes; zero when they are used up.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>

namespace polyturn::channels::fuzz {

class Draw {
public:
    Draw(const std::uint8_t* data, std::size_t size) : data_(data), end_(data + size) {}
    bool empty() const { return data_ == end_; }
    unsigned byte() { return data_ == end_ ? 0u : *data_++; }
    unsigned below(unsigned n) { return byte() % n; }
    // -32.768 to 32.767 in steps of 0.001, with many round values.
    double length() {
        const auto raw = static_cast<std::int16_t>(byte() << 8 | byte());
        return below(4) == 0 ? raw / 4096 * 5.0 : raw * 0.001;
    }
    std::string number(double value) {
        std::string text = std::to_string(value);
        text.resize(text.size() - 3);  // three decimals
        return text;
    }
    std::string word(char letter) { return letter + number(length()); }

private:
    const std::uint8_t* data_;
    const std::uint8_t* end_;
};

}  // namespace polyturn::channels::fuzz
