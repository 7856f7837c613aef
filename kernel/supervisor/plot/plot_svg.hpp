// SVG elements as text. Coordinates in pixels of the sheet, rounded to 1/100.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace polyturn::supervisor {

struct Pixel {
    double x = 0.0, y = 0.0;
};

class Svg {
public:
    Svg(double width, double height);
    // attributes: as in the file, such as `fill="#fff"`.
    void rect(double x, double y, double width, double height, std::string_view attributes,
              double radius = 0.0);
    void line(Pixel a, Pixel b, std::string_view attributes);
    void polyline(const std::vector<Pixel>& points, std::string_view attributes,
                  bool closed = false);
    void circle(Pixel centre, double radius, std::string_view attributes);
    void text(Pixel at, std::string_view words, std::string_view attributes);
    void open_group(std::string_view attributes);
    void close_group() { out_ += "</g>\n"; }
    void raw(std::string_view words) { out_ += words; }
    std::string finish() &&;

private:
    std::string out_;
};

std::string escaped(std::string_view words);

// The look: one place for colours.
namespace look {
inline constexpr const char* kPaper = "#fcfcfa";
inline constexpr const char* kInk = "#22282e";
inline constexpr const char* kQuiet = "#7b858e";
inline constexpr const char* kGrid = "#e4e7e8";
inline constexpr const char* kStock = "#e9e4d8";
inline constexpr const char* kPart = "#cfd6da";
inline constexpr const char* kPartEdge = "#8b979f";
inline constexpr const char* kChuck = "#5d676f";
const char* channel_colour(unsigned channel);  // strong
const char* channel_tint(unsigned channel);    // the same, pale
}  // namespace look

}  // namespace polyturn::supervisor
