#include "ipc/model/machine/store/tool_fields.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "ipc/model/machine/shortest_text.hpp"

namespace polyturn {
namespace {

using Type = ToolFieldType;
constexpr double kMany = 1e9;
#define AT(field) offsetof(ToolRow, field)
#pragma GCC diagnostic ignored "-Winvalid-offsetof"
constexpr std::size_t element(std::size_t base, std::size_t i) { return base + i * sizeof(double); }

constexpr ToolField custom(std::string_view name, std::size_t i) {
    return {name, Type::Number, element(AT(custom), i),
            0,    -kMany,       kMany,
            0,    "",           "column of the machine builder (N2903)"};
}

constexpr ToolField kFields[] = {
    {"name", Type::Text, AT(name), 0, 0, sizeof(ToolRow{}.name) - 1, 0, "",
     "name; sisters share it"},
    {"type", Type::Whole, AT(type_number), 0, 0, 99'999'999, 0, "",
     "type number: the T code that calls it"},
    {"duplo", Type::Whole, AT(duplo), 0, 1, 9999, 1, "", "order among sisters"},
    {"group", Type::Whole, AT(group), 0, 0, 9999, 0, "", "tool life group of programs (G10 L3)"},
    {"unit", Type::Whole, AT(unit), 0, 0, 16, 0, "", "tool unit whose channels see it; 0 all"},
    {"kind", Type::Whole, AT(kind), 0, 0, 999, 0, "",
     "type of tool: 500 roughing, 510 finishing, 200 drill ..."},
    {"h", Type::Whole, AT(h_cell), 0, 0, 999, 0, "", "offset cell of the length"},
    {"d", Type::Whole, AT(d_cell), 0, 0, 999, 0, "", "offset cell of the radius"},
    {"active", Type::Flag, AT(state), kToolActive, 0, 1, 0, "",
     "the one of its sisters that works"},
    {"enabled", Type::Flag, AT(state), kToolEnabled, 0, 1, 1, "", "may be used"},
    {"locked", Type::Flag, AT(state), kToolLocked, 0, 1, 0, "", "must not be used"},
    {"worn", Type::Flag, AT(state), kToolWorn, 0, 1, 0, "", "its life is over"},
    {"warned", Type::Flag, AT(state), kToolWarned, 0, 1, 0, "", "its warning limit is reached"},
    {"broken", Type::Flag, AT(state), kToolBroken, 0, 1, 0, "", "broken"},
    {"fixed", Type::Flag, AT(state), kToolFixedPlace, 0, 1, 0, "", "goes back to its own place"},
    {"was_used", Type::Flag, AT(state), kToolUsed, 0, 1, 0, "", "has been in use"},
    {"measured", Type::Flag, AT(state), kToolMeasured, 0, 1, 0, "", "has been measured"},
    {"life_kind", Type::Life, AT(life_kind), 0, 0, 5, 0, "",
     "none minutes pieces uses metres wear"},
    {"life", Type::Number, AT(life), 0, 0, kMany, 0, "of life_kind", "its life; 0 is not watched"},
    {"counter", Type::Number, AT(counter), 0, 0, kMany, 0, "of life_kind", "what of it is used up"},
    {"warning", Type::Number, AT(warning), 0, 0, kMany, 0, "of life_kind",
     "so much left is a warning"},
    {"speed", Type::Number, AT(speed), 0, 0, 1e6, 0, "1/min", "S of the table"},
    {"feed", Type::Number, AT(feed), 0, 0, 1e6, 0, "", "F of the table"},
    {"weight", Type::Number, AT(weight), 0, 0, 1000, 0, "kg", "weight"},
    {"length", Type::Number, AT(length), 0, 0, 10'000, 0, "mm", "dimension along its axis"},
    {"diameter", Type::Number, AT(diameter), 0, 0, 10'000, 0, "mm", "dimension across"},
    {"size_left", Type::Number, element(AT(size), 0), 0, 0.5, 20, 1, "half places",
     "room to the left"},
    {"size_right", Type::Number, element(AT(size), 1), 0, 0.5, 20, 1, "half places",
     "room to the right"},
    {"size_up", Type::Number, element(AT(size), 2), 0, 0.5, 20, 1, "half places", "room above"},
    {"size_down", Type::Number, element(AT(size), 3), 0, 0.5, 20, 1, "half places", "room below"},
    {"outline", Type::Outline, AT(outline), 0, 0, 0, 0, "mm",
     "boxes about the seat that protection guards"},
    {"place_type", Type::Whole, AT(place_type), 0, 0, 999, 0, "",
     "kind of place that it needs; 0 any"},
    {"home_magazine", Type::Whole, AT(home_magazine), 0, 0, 999, 0, "", "where it goes back to"},
    {"home_pot", Type::Whole, AT(home_pot), 0, 0, 99'999'999, 0, "", "where it goes back to"},
    {"magazine", Type::Whole, AT(magazine), 0, 0, 999, 0, "", "where it is; 0 nowhere"},
    {"pot", Type::Whole, AT(pot), 0, 0, 99'999'999, 0, "", "where it is"},
    // The first one is always binary (nct part 2 30.1): written as eight digits, bit 7 first, or as
    // a number.
    {"custom1", Type::Number, element(AT(custom), 0), 0, 0, 255, 0, "bits",
     "column of the machine builder: eight bits (N2903)"},
    custom("custom2", 1),
    custom("custom3", 2),
    custom("custom4", 3),
    custom("custom5", 4),
    custom("custom6", 5),
    custom("custom7", 6),
    custom("custom8", 7),
    custom("custom9", 8),
    custom("custom10", 9),
    custom("custom11", 10),
    custom("custom12", 11),
    custom("custom13", 12),
    custom("custom14", 13),
    custom("custom15", 14),
    custom("custom16", 15),
    custom("custom17", 16),
    custom("custom18", 17),
    custom("custom19", 18),
    custom("custom20", 19),
};
#undef AT

template <class T>
T& part(ToolRow& row, const ToolField& field) noexcept {
    return *reinterpret_cast<T*>(reinterpret_cast<std::byte*>(&row) + field.offset);
}
template <class T>
const T& part(const ToolRow& row, const ToolField& field) noexcept {
    return *reinterpret_cast<const T*>(reinterpret_cast<const std::byte*>(&row) + field.offset);
}

// "00000101"
constexpr std::size_t kBits = 8;
bool is_bits(const ToolField& field) noexcept { return field.unit == "bits"; }
bool are_bits(std::string_view text) noexcept {
    return text.size() == kBits && text.find_first_not_of("01") == std::string_view::npos;
}

std::optional<double> number_of(std::string_view text) noexcept {
    if (!text.empty() && text[0] == '+') text.remove_prefix(1);
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    if (end.ec != std::errc() || end.ptr != text.data() + text.size() || !std::isfinite(value))
        return {};
    return value;
}

std::string_view trimmed(std::string_view text) noexcept {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
    return text;
}

// "X -60:0" or, at the axis' own letter, the two numbers.
bool read_span(std::string_view& rest, char axis, double& from, double& to) noexcept {
    rest = trimmed(rest);
    if (rest.empty() || rest.front() != axis) return false;
    rest = trimmed(rest.substr(1));
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string_view span = rest.substr(0, end);
    rest.remove_prefix(end);
    const std::size_t colon = span.find(':');
    if (colon == std::string_view::npos) return false;
    const auto a = number_of(span.substr(0, colon)), b = number_of(span.substr(colon + 1));
    if (!a || !b || *a > *b || std::abs(*a) > 10'000 || std::abs(*b) > 10'000) return false;
    from = *a;
    to = *b;
    return true;
}

}  // namespace

std::span<const ToolField> tool_fields() noexcept { return kFields; }

std::optional<std::size_t> find_tool_field(std::string_view name) noexcept {
    for (std::size_t i = 0; i < std::size(kFields); ++i)
        if (kFields[i].name == name) return i;
    return {};
}

const ToolField& tool_field(std::string_view name) noexcept {
    return kFields[find_tool_field(name).value_or(0)];
}

double tool_number(const ToolRow& row, const ToolField& field) noexcept {
    switch (field.type) {
        case Type::Whole:
            return part<std::int32_t>(row, field);
        case Type::Life:
            return part<std::uint32_t>(row, field);
        case Type::Flag:
            return (row.state & field.bit) != 0;
        case Type::Number:
            return part<double>(row, field);
        case Type::Text:
        case Type::Outline:
            break;
    }
    return 0.0;
}

std::string tool_text(const ToolRow& row, const ToolField& field) {
    switch (field.type) {
        case Type::Text:
            return {row.name.data(), ::strnlen(row.name.data(), row.name.size())};
        case Type::Life:
            return std::string(
                kLifeKinds[std::min<std::size_t>(row.life_kind, std::size(kLifeKinds) - 1)]);
        case Type::Outline: {
            std::string out;
            for (std::size_t i = 0; i < std::min<std::size_t>(row.boxes, 3); ++i) {
                const double* e = &row.outline[i * 4];
                out += (i ? "; X " : "X ") + shortest_text(e[0]) + ":" + shortest_text(e[1]) +
                       " Z " + shortest_text(e[2]) + ":" + shortest_text(e[3]);
            }
            return out;
        }
        default: {
            if (!is_bits(field)) return shortest_text(tool_number(row, field));
            std::string out(kBits, '0');
            for (std::size_t i = 0; i < kBits; ++i)
                out[kBits - 1 - i] =
                    static_cast<unsigned>(tool_number(row, field)) >> i & 1u ? '1' : '0';
            return out;
        }
    }
}

void put_tool_number(ToolRow& row, const ToolField& field, double value) noexcept {
    if (std::isnan(value)) value = field.fallback;
    switch (field.type) {
        case Type::Whole:
            part<std::int32_t>(row, field) = static_cast<std::int32_t>(value);
            break;
        case Type::Life:
            part<std::uint32_t>(row, field) = static_cast<std::uint32_t>(value);
            break;
        case Type::Flag:
            row.state = value != 0.0 ? row.state | field.bit : row.state & ~field.bit;
            break;
        case Type::Number:
            part<double>(row, field) = value;
            break;
        case Type::Text:
        case Type::Outline:
            put_tool_text(row, field, {});
            break;
    }
}

void put_tool_text(ToolRow& row, const ToolField& field, std::string_view text) noexcept {
    if (field.type == Type::Text) {
        row.name.fill(0);
        std::copy_n(text.begin(), std::min(text.size(), row.name.size() - 1), row.name.begin());
    } else if (field.type == Type::Outline) {
        const ToolOutline outline = read_outline(text).value_or(ToolOutline{});
        row.boxes = outline.boxes;
        row.outline = outline.edge;
    }
}

void clear_tool(ToolRow& row) noexcept {
    row = {};
    for (const ToolField& field : kFields)
        if (!field.is_text()) put_tool_number(row, field, field.fallback);
}

std::optional<ToolOutline> read_outline(std::string_view text) noexcept {
    ToolOutline out;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        if (out.boxes == 3) return {};
        double* e = &out.edge[out.boxes++ * 4];
        if (!read_span(text, 'X', e[0], e[1]) || !read_span(text, 'Z', e[2], e[3])) return {};
        text = trimmed(text);
        if (text.empty()) break;
        if (text.front() != ';') return {};
        text.remove_prefix(1);
    }
    return out;
}

Result<ToolFieldValue> read_tool_value(const ToolField& field, std::string_view text) {
    text = trimmed(text);
    const auto wrong = [&](std::string why) {
        return Diagnosis{Alarm::ToolValueBad,
                         {},
                         {},
                         std::string(field.name) + "=" + std::string(text) + ": " + std::move(why)};
    };
    ToolFieldValue out;
    if (field.type == Type::Text) {
        if (text.size() > static_cast<std::size_t>(field.most))
            return wrong("at most " + shortest_text(field.most) + " characters");
        for (const char c : text)
            if (static_cast<unsigned char>(c) < 0x20 || c == '"' || c == ',' || c == ';')
                return wrong("no quotes, commas or control characters");
        out.text = text;
        return out;
    }
    if (field.type == Type::Outline) {
        const auto outline = read_outline(text);
        if (!outline) return wrong("write up to three boxes as X -60:0 Z -20:5; ...");
        ToolRow row{};
        row.boxes = outline->boxes;
        row.outline = outline->edge;
        out.text = tool_text(row, field);
        return out;
    }
    if (field.type == Type::Life)
        for (std::size_t i = 0; i < std::size(kLifeKinds); ++i)
            if (text == kLifeKinds[i]) {
                out.number = static_cast<double>(i);
                return out;
            }
    if (field.type == Type::Flag && (text == "on" || text == "yes")) {
        out.number = 1;
        return out;
    }
    if (field.type == Type::Flag && (text == "off" || text == "no")) {
        out.number = 0;
        return out;
    }
    if (is_bits(field) && are_bits(text)) {
        unsigned bits = 0;
        for (const char c : text) bits = bits << 1 | (c == '1' ? 1u : 0u);
        out.number = bits;
        return out;
    }
    // eight digits are meant as bits
    const auto number = is_bits(field) && text.size() == kBits ? std::nullopt : number_of(text);
    if (!number)
        return wrong(is_bits(field)             ? "eight digits 0 or 1, or 0 to 255"
                     : field.type == Type::Life ? "one of none minutes pieces uses metres wear"
                                                : "not a number");
    if (*number < field.least || *number > field.most)
        return wrong(shortest_text(field.least) + " to " + shortest_text(field.most) +
                     (field.unit.empty() ? "" : " " + std::string(field.unit)));
    if ((field.type != Type::Number || is_bits(field)) && *number != std::trunc(*number))
        return wrong("a whole number");
    out.number = *number + 0.0;
    return out;
}

}  // namespace polyturn
