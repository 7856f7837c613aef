// A picture from the presetter's camera: grey values, row by row from the top. Read from PGM (P5, 8
// or 16 bits) or BMP (8, 24 or 32 bits, not packed), which every camera program can write; "-" is
// standard input.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::presetter {

struct ShadowImage {
    int width = 0, height = 0;
    std::vector<float> grey;  // 0 black to 255 white
    float at(int x, int y) const {
        return grey[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                    static_cast<std::size_t>(x)];
    }
};

inline constexpr int kLeastSide = 64, kMostSide = 16384;

Result<ShadowImage> read_image(const std::string& path);
Result<ShadowImage> parse_image(const std::string& bytes);

}  // namespace polyturn::presetter
