#include "toolmgmt/presetter/shadow_image.hpp"

#include <cctype>
#include <cstdio>
#include <cstring>
#include <iostream>

#include "ipc/model/files/regular_file.hpp"

namespace polyturn::presetter {

namespace {
// bytes; a camera of 100 megapixels in grey has 100 MB
constexpr std::size_t kLargestPicture = std::size_t{256} << 20;
}  // namespace
namespace {

Diagnosis bad(std::string why) { return Diagnosis{Alarm::PresetterImage, {}, {}, std::move(why)}; }

std::uint32_t little(const std::string& bytes, std::size_t at, std::size_t count) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < count; ++i)
        value |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
    return value;
}

bool good_size(long width, long height) {
    return width >= kLeastSide && height >= kLeastSide && width <= kMostSide && height <= kMostSide;
}
std::string size_text(long width, long height) {
    return std::to_string(width) + " x " + std::to_string(height) + " pixels: at least " +
           std::to_string(kLeastSide) + ", at most " + std::to_string(kMostSide) + " each way";
}

Result<ShadowImage> parse_pgm(const std::string& bytes) {
    std::size_t at = 2;
    const auto number = [&](long& out) {
        while (at < bytes.size() &&
               (std::isspace(static_cast<unsigned char>(bytes[at])) || bytes[at] == '#')) {
            if (bytes[at] == '#')
                while (at < bytes.size() && bytes[at] != '\n') ++at;
            else
                ++at;
        }
        out = 0;
        const std::size_t begin = at;
        while (at < bytes.size() && std::isdigit(static_cast<unsigned char>(bytes[at])) &&
               at - begin < 9)
            out = out * 10 + (bytes[at++] - '0');
        return at > begin;
    };
    long width = 0, height = 0, most = 0;
    if (!number(width) || !number(height) || !number(most) || most < 1 || most > 65535)
        return bad("the head of the PGM cannot be read");
    ++at;  // one white space
    if (!good_size(width, height)) return bad(size_text(width, height));
    const std::size_t count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                      each = most > 255 ? 2 : 1;
    if (bytes.size() < at + count * each) return bad("the file ends within the picture");
    ShadowImage out{static_cast<int>(width), static_cast<int>(height), std::vector<float>(count)};
    const float scale = 255.0F / static_cast<float>(most);
    for (std::size_t i = 0; i < count; ++i) {
        const auto high = static_cast<unsigned char>(bytes[at + i * each]);
        const unsigned value =
            each == 2 ? high * 256u + static_cast<unsigned char>(bytes[at + i * 2 + 1]) : high;
        out.grey[i] = static_cast<float>(value) * scale;
    }
    return out;
}

Result<ShadowImage> parse_bmp(const std::string& bytes) {
    if (bytes.size() < 54) return bad("the file ends within its head");
    const std::size_t pixels = little(bytes, 10, 4), head = little(bytes, 14, 4);
    const auto width = static_cast<std::int32_t>(little(bytes, 18, 4)),
               signed_height = static_cast<std::int32_t>(little(bytes, 22, 4));
    const unsigned bits = little(bytes, 28, 2), packed = little(bytes, 30, 4);
    const long height = signed_height < 0 ? -static_cast<long>(signed_height) : signed_height;
    if (packed != 0 || (bits != 8 && bits != 24 && bits != 32))
        return bad("a BMP must have 8, 24 or 32 bits and not be packed");
    if (!good_size(width, height)) return bad(size_text(width, height));
    const std::size_t stride = (static_cast<std::size_t>(width) * bits + 31) / 32 * 4;
    const std::size_t palette = 14 + head;
    if (bytes.size() < pixels + stride * static_cast<std::size_t>(height) ||
        (bits == 8 && bytes.size() < palette + 1024))
        return bad("the file ends within the picture");
    ShadowImage out{
        width, static_cast<int>(height),
        std::vector<float>(static_cast<std::size_t>(width) * static_cast<std::size_t>(height))};
    const auto grey_of = [&](std::size_t i) {  // blue, green, red
        return 0.114F * static_cast<float>(static_cast<unsigned char>(bytes[i])) +
               0.587F * static_cast<float>(static_cast<unsigned char>(bytes[i + 1])) +
               0.299F * static_cast<float>(static_cast<unsigned char>(bytes[i + 2]));
    };
    for (long y = 0; y < height; ++y) {
        const std::size_t row =
            pixels + stride * static_cast<std::size_t>(signed_height < 0 ? y : height - 1 - y);
        for (long x = 0; x < width; ++x) {
            const std::size_t i = row + static_cast<std::size_t>(x) * bits / 8;
            out.grey[static_cast<std::size_t>(y * width + x)] =
                bits == 8 ? grey_of(palette + 4 * static_cast<unsigned char>(bytes[i]))
                          : grey_of(i);
        }
    }
    return out;
}

}  // namespace

Result<ShadowImage> parse_image(const std::string& bytes) {
    if (bytes.size() > 2 && bytes[0] == 'P' && bytes[1] == '5') return parse_pgm(bytes);
    if (bytes.size() > 2 && bytes[0] == 'B' && bytes[1] == 'M') return parse_bmp(bytes);
    return bad("neither PGM (P5) nor BMP");
}

Result<ShadowImage> read_image(const std::string& path) {
    if (path == "-") {
        std::string bytes;
        for (int c = std::cin.get(); c != std::istream::traits_type::eof(); c = std::cin.get()) {
            if (bytes.size() == kLargestPicture)
                return Diagnosis{Alarm::FileTooLarge, {path, 0, 0, 0}, {}, path};
            bytes.push_back(static_cast<char>(c));
        }
        return parse_image(bytes);
    }
    const auto file = text::RegularFile::open(path, kLargestPicture);
    if (!file) return file.diagnosis();
    const auto bytes = file->read_all();
    return bytes ? parse_image(*bytes) : Result<ShadowImage>(bytes.diagnosis());
}

}  // namespace polyturn::presetter
