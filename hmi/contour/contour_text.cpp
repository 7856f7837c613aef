#include "hmi/contour/contour_text.hpp"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace polyturn::contour {
namespace {

using Language = Writing::Language;

constexpr double kMostSweep = 170;  // degrees of one arc block

std::string comment(const std::string& text, const Writing& writing) {
    return writing.language == Language::Family ? "(" + text + ")" : ";" + text;
}

// What stands in a comment that is the whole line; nothing: it is no such line.
std::optional<std::string> comment_of(std::string line) {
    while (!line.empty() && (line.back() == ' ' || line.back() == '\r' || line.back() == '\t'))
        line.pop_back();
    std::size_t from = 0;
    while (from < line.size() && (line[from] == ' ' || line[from] == '\t')) ++from;
    line.erase(0, from);
    if (line.size() >= 2 && line.front() == '(' && line.back() == ')')
        return line.substr(1, line.size() - 2);
    if (!line.empty() && line.front() == ';') return line.substr(1);
    return std::nullopt;
}

std::string number(double value, int decimals, bool point) {
    char buffer[64];
    std::snprintf(buffer, sizeof buffer, "%.*f", decimals, value);
    std::string out = buffer;
    if (out.find('.') != std::string::npos) {
        while (out.back() == '0') out.pop_back();
        if (out.back() == '.' && !point) out.pop_back();
    } else if (point) {
        out += '.';
    }
    if (out == "-0" || out == "-0.") out.erase(0, 1);
    return out;
}

struct Token {
    std::string name;
    std::optional<double> value;
};
std::optional<Token> token_of(const std::string& word) {
    std::size_t n = 0;
    while (n < word.size() && ((word[n] >= 'A' && word[n] <= 'Z'))) ++n;
    Token out{word.substr(0, n), std::nullopt};
    if (n == word.size()) return out;
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data() + n, word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || n == 0) return std::nullopt;
    out.value = value;
    return out;
}

// The data of an element with their names in a description; X data are doubled where X is a
// diameter.
struct Datum {
    const char* name;
    std::optional<double> Element::*value;
    bool x;
};
constexpr Datum kData[] = {{"Z", &Element::z, false},        {"X", &Element::x, true},
                           {"DZ", &Element::dz, false},      {"DX", &Element::dx, false},
                           {"L", &Element::length, false},   {"A", &Element::angle, false},
                           {"R", &Element::radius, false},   {"CZ", &Element::centre_z, false},
                           {"CX", &Element::centre_x, true}, {"E", &Element::end_angle, false},
                           {"S", &Element::sweep, false}};

std::string shortest(double value) {
    char buffer[40];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    std::string out(buffer, end);
    // no sign but digits, point, minus
    return out.find('e') == std::string::npos ? out : number(value, 9, false);
}

bool read_element(const std::string& text, Element& out, bool diameter) {
    std::istringstream words(text);
    std::string word;
    words >> word;
    if (word == "LINE")
        out.kind = Kind::Line;
    else if (word == "CW")
        out.kind = Kind::ArcCw;
    else if (word == "CCW")
        out.kind = Kind::ArcCcw;
    else
        return false;
    while (words >> word) {
        const auto token = token_of(word);
        if (!token) return false;
        if (token->name == "T" && !token->value) {
            out.tangent = true;
            continue;
        }
        if (!token->value) return false;
        bool known = false;
        for (const Datum& datum : kData)
            if (token->name == datum.name) {
                out.*datum.value = *token->value * (datum.x && diameter ? 0.5 : 1.0);
                known = true;
            }
        if (token->name == "CH") {
            out.chamfer = *token->value;
            known = true;
        }
        if (token->name == "RD") {
            out.round = *token->value;
            known = true;
        }
        if (token->name == "SOL") {
            out.solution = static_cast<int>(*token->value);
            known = true;
        }
        if (!known) return false;
    }
    return true;
}

}  // namespace

Place find_contour(const std::vector<std::string>& lines, int line) {
    const int count = static_cast<int>(lines.size());
    const auto text = [&](int at) { return comment_of(lines[static_cast<std::size_t>(at)]); };
    const auto begins = [&](int at) {
        const auto one = text(at);
        return one && one->rfind("CONTOUR ", 0) == 0 && *one != "CONTOUR END";
    };
    Place place;
    int from = line;
    for (; from >= 0; --from) {
        if (from >= count) continue;
        if (begins(from)) break;
        if (from != line && text(from) == "CONTOUR END") return place;
    }
    if (from < 0) return place;
    place.from = from;
    for (int to = from + 1; to < count; ++to) {
        if (text(to) == "CONTOUR END") {
            place.to = to;
            place.complete = true;
            return place;
        }
        if (begins(to)) break;
    }
    // Without its end only the description belongs to it.
    place.to = from;
    while (place.to + 1 < count && text(place.to + 1)) ++place.to;
    return line <= place.to ? place : Place{};
}

std::optional<Description> read_contour(const std::vector<std::string>& lines, const Place& place,
                                        const Writing& writing, int* fault_line) {
    Description out;
    bool diameter = writing.diameter;
    const auto fail = [&](int line) {
        if (fault_line) *fault_line = line;
        return std::nullopt;
    };
    for (int at = place.from; at <= place.to; ++at) {
        const auto text = comment_of(lines[static_cast<std::size_t>(at)]);
        if (!text) return at == place.from ? fail(at) : std::optional<Description>(out);
        if (*text == "BLOCKS" || *text == "CONTOUR END") return out;
        if (at > place.from) {
            Element element;
            if (!read_element(*text, element, diameter)) return fail(at);
            out.contour.elements.push_back(element);
            continue;
        }
        std::istringstream words(*text);
        std::string word;
        words >> word;
        diameter = text->find(" DIA") != std::string::npos;
        out.approach = 0;
        while (words >> word) {
            const auto token = token_of(word);
            if (!token) return fail(at);
            const double value = token->value.value_or(0.0);
            if (token->name == "Z")
                out.contour.start.z = value;
            else if (token->name == "X")
                out.contour.start.x = value * (diameter ? 0.5 : 1.0);
            else if (token->name == "G")
                out.approach = value == 0 ? 2 : 1;
            else if (token->name == "FIRST")
                out.first = static_cast<long>(value);
            else if (token->name == "LAST")
                out.last = static_cast<long>(value);
            else if (token->name != "DIA")
                return fail(at);
        }
    }
    return out;
}

std::vector<std::string> blocks_of(const Description& description, const Solved& solved,
                                   const Writing& w) {
    std::vector<std::string> out;
    const bool family = w.language == Language::Family;
    const auto n = [&](double value) { return number(value, w.decimals, family); };
    const auto x_of = [&](double radius) { return n(w.diameter ? 2 * radius : radius); };
    const auto round = [&](double value) {
        return std::round(value * std::pow(10.0, w.decimals)) / std::pow(10.0, w.decimals);
    };
    int motion = -1;
    Point at{std::nan(""), std::nan("")};
    const auto block = [&](int code, Point to, const std::string& more) {
        std::string line;
        const auto add = [&](const std::string& text) { line += (line.empty() ? "" : " ") + text; };
        if (out.empty() && w.says_absolute) add("G90");
        if (code != motion || code >= 2) add("G" + std::to_string(code));
        if (!(round(to.x) == round(at.x))) add("X" + x_of(to.x));
        if (!(round(to.z) == round(at.z))) add("Z" + n(to.z));
        if (!more.empty()) add(more);
        motion = code;
        at = to;
        out.push_back(line);
    };
    if (description.approach)
        block(description.approach == 2 ? 0 : 1, description.contour.start, {});
    else
        at = description.contour.start;
    for (const Piece& p : solved.pieces) {
        if (p.kind == Kind::Line) {
            // shorter than what can be written
            if (round(p.to.x) == round(at.x) && round(p.to.z) == round(at.z)) continue;
            block(1, p.to, {});
            continue;
        }
        // A radius fits whatever the rounding of the points, but near the half circle: larger arcs
        // are cut in equal ones.
        const int parts = std::max(1, static_cast<int>(std::ceil(p.sweep / kMostSweep)));
        const double from = std::atan2(p.from.x - p.centre.x, p.from.z - p.centre.z),
                     turn = (p.kind == Kind::ArcCcw ? 1 : -1) * p.sweep * M_PI / 180 / parts;
        for (int k = 1; k <= parts; ++k) {
            const Point to = k == parts ? p.to
                                        : Point{p.centre.z + p.radius * std::cos(from + k * turn),
                                                p.centre.x + p.radius * std::sin(from + k * turn)};
            block(p.kind == Kind::ArcCw ? 2 : 3, to,
                  (w.language == Language::Sinumerik ? "CR=" : "R") + n(p.radius));
        }
    }
    if (!out.empty() && description.first > 0)
        out.front() = "N" + std::to_string(description.first) + " " + out.front();
    if (out.size() > 1 && description.last > 0)
        out.back() = "N" + std::to_string(description.last) + " " + out.back();
    return out;
}

std::vector<std::string> write_contour(const Description& d, const Solved& solved,
                                       const Writing& w) {
    std::vector<std::string> out;
    const double scale = w.diameter ? 2.0 : 1.0;
    std::string head = "CONTOUR";
    if (w.diameter) head += " DIA";
    head += " Z" + shortest(d.contour.start.z) + " X" + shortest(d.contour.start.x * scale);
    if (d.approach) head += d.approach == 2 ? " G0" : " G1";
    if (d.first > 0) head += " FIRST" + std::to_string(d.first);
    if (d.last > 0) head += " LAST" + std::to_string(d.last);
    out.push_back(comment(head, w));
    for (const Element& e : d.contour.elements) {
        std::string text = e.kind == Kind::Line ? "LINE" : e.kind == Kind::ArcCw ? "CW" : "CCW";
        if (e.tangent) text += " T";
        for (const Datum& datum : kData)
            if (const auto& value = e.*datum.value)
                text += std::string(" ") + datum.name + shortest(*value * (datum.x ? scale : 1.0));
        if (e.chamfer > 0) text += " CH" + shortest(e.chamfer);
        if (e.round > 0) text += " RD" + shortest(e.round);
        if (e.solution) text += " SOL" + std::to_string(e.solution);
        out.push_back(comment(text, w));
    }
    out.push_back(comment("BLOCKS", w));
    for (std::string& line : blocks_of(d, solved, w)) out.push_back(std::move(line));
    out.push_back(comment("CONTOUR END", w));
    return out;
}

}  // namespace polyturn::contour
