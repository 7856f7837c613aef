// Words for people: `params get`, the manual.
#include <fmt/format.h>

#include "ipc/params/limits_text.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::params {

std::string_view to_string(Scope scope) noexcept {
    switch (scope) {
        case Scope::Group:
            return "machine group";
        case Scope::Channel:
            return "channel";
        case Scope::Axis:
            return "axis";
        case Scope::Spindle:
            return "spindle";
        case Scope::Global:
            break;
    }
    return "global";
}

std::string_view to_string(Type type) noexcept {
    switch (type) {
        case Type::Bits:
            return "eight bits";
        case Type::Int:
            return "whole number";
        case Type::Real:
            return "number";
        case Type::Text:
            break;
    }
    return "text";
}

std::string_view to_string(Effect effect) noexcept {
    switch (effect) {
        case Effect::Tick:
            return "at the next tick";
        case Effect::Barrier:
            return "at the channel's next barrier";
        case Effect::Restart:
            break;
    }
    return "at the next start";
}

std::string_view to_string(Protection protection) noexcept {
    switch (protection) {
        case Protection::Operator:
            return "operator";
        case Protection::Setter:
            return "setter";
        case Protection::Maker:
            break;
    }
    return "machine builder";
}

std::string limits_text(const Row& row) {
    if (row.text_rule == TextRule::Choice) return fmt::format("one of {}", fmt::join(row.choices, ", "));
    if (row.text_rule == TextRule::Ipv4) return "four numbers 0 to 255 with points between, or empty";
    if (row.type == Type::Text) return fmt::format("{} to {} characters", row.min, row.max);
    constexpr double kUnlimited = 1e307;  // the widest range that a row has stands for none
    if (row.min < -kUnlimited && row.max > kUnlimited) return "any";
    if (row.min < -kUnlimited) return fmt::format("up to {}", row.max);
    if (row.max > kUnlimited) return fmt::format("from {}", row.min);
    if (row.type == Type::Real) return fmt::format("{} to {}", row.min, row.max);
    return fmt::format("{:.0f} to {:.0f}", row.min, row.max);
}

std::string describe(const Row& row) {
    const char letter = scope_letter(row.scope);
    std::string out = fmt::format("{}  {}  ({})\n  {}\n", row.number, row.name, row.group, row.meaning);
    for (const Bit& bit : row.bits) out += fmt::format("  #{} {}: {}\n", bit.number, bit.name, bit.meaning);
    if (letter == '\0')
        out += "  once per machine";
    else
        out += fmt::format("  once per {}, {}1 to {}{}", to_string(row.scope), letter, letter, instances(row.scope));
    if (row.array > 1) out += fmt::format(", [0] to [{}]", row.array - 1);
    out += fmt::format("; {}, {}", to_string(row.type), limits_text(row));
    if (!row.unit.empty()) out += fmt::format(", in {}", row.unit);
    out += row.type == Type::Text ? fmt::format("; default \"{}\"\n", row.default_text) : fmt::format("; default {}\n", fmt::join(row.default_numbers, " "));
    out += fmt::format("  changed by: {}; takes effect {}\n", to_string(row.protection), to_string(row.effect));
    out += fmt::format("  acts: {}\n", row.acts);
    return out;
}

}  // namespace polyturn::params
