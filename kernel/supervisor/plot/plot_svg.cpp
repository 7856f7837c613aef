#include "kernel/supervisor/plot/plot_svg.hpp"

#include <fmt/format.h>

#include <iterator>

namespace polyturn::supervisor {

std::string escaped(std::string_view words) {
    std::string out;
    for (const char c : words) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else if (c == '>')
            out += "&gt;";
        else if (c == '"')
            out += "&quot;";
        else if (static_cast<unsigned char>(c) >= 0x20)
            out += c;
    }
    return out;
}

Svg::Svg(double width, double height) {
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "viewBox=\"0 0 {0:.0f} {1:.0f}\" "
        "font-family=\"Inter, 'Source Sans 3', 'Helvetica Neue', Arial, sans-serif\" "
        "font-size=\"12\" fill=\"{2}\">\n"
        "<rect width=\"100%\" height=\"100%\" fill=\"{3}\"/>\n",
        width, height, look::kInk, look::kPaper);
}

void Svg::rect(double x, double y, double width, double height, std::string_view attributes,
               double radius) {
    fmt::format_to(std::back_inserter(out_),
                   "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\"", x, y,
                   width, height);
    if (radius > 0) fmt::format_to(std::back_inserter(out_), " rx=\"{:.2f}\"", radius);
    fmt::format_to(std::back_inserter(out_), " {}/>\n", attributes);
}

void Svg::line(Pixel a, Pixel b, std::string_view attributes) {
    fmt::format_to(std::back_inserter(out_),
                   "<line x1=\"{:.2f}\" y1=\"{:.2f}\" x2=\"{:.2f}\" y2=\"{:.2f}\" {}/>\n", a.x, a.y,
                   b.x, b.y, attributes);
}

void Svg::polyline(const std::vector<Pixel>& points, std::string_view attributes, bool closed) {
    if (points.size() < 2) return;
    out_ += closed ? "<polygon points=\"" : "<polyline points=\"";
    for (std::size_t i = 0; i < points.size(); ++i)
        fmt::format_to(std::back_inserter(out_), "{}{:.2f},{:.2f}", i ? " " : "", points[i].x,
                       points[i].y);
    fmt::format_to(std::back_inserter(out_), "\" {}/>\n", attributes);
}

void Svg::circle(Pixel centre, double radius, std::string_view attributes) {
    fmt::format_to(std::back_inserter(out_),
                   "<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\" {}/>\n", centre.x, centre.y,
                   radius, attributes);
}

void Svg::text(Pixel at, std::string_view words, std::string_view attributes) {
    fmt::format_to(std::back_inserter(out_), "<text x=\"{:.2f}\" y=\"{:.2f}\" {}>{}</text>\n", at.x,
                   at.y, attributes, escaped(words));
}

void Svg::open_group(std::string_view attributes) {
    fmt::format_to(std::back_inserter(out_), "<g {}>\n", attributes);
}

std::string Svg::finish() && {
    out_ += "</svg>\n";
    return std::move(out_);
}

namespace look {
const char* channel_colour(unsigned channel) {
    static constexpr const char* kColours[] = {"#0b6a94", "#c2521c", "#4f8a2b",
                                               "#7a4b9c", "#a3362f", "#2f7f78"};
    return kColours[(channel - 1) % std::size(kColours)];
}
const char* channel_tint(unsigned channel) {
    static constexpr const char* kTints[] = {"#b9d8e6", "#f2cdb9", "#cfe2c0",
                                             "#dccbe6", "#ecc6c3", "#c3dfdc"};
    return kTints[(channel - 1) % std::size(kTints)];
}
}  // namespace look

}  // namespace polyturn::supervisor
