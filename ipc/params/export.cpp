#include "ipc/params/export.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "ipc/params/unit.hpp"

namespace polyturn::params {
namespace {

constexpr std::size_t kCommentColumn = 24;

std::string quoted_where_needed(std::string_view text) {
    const bool plain = text.find_first_of(";\"") == std::string_view::npos &&
                       (text.empty() || (text.front() != ' ' && text.back() != ' '));
    if (plain) return std::string(text);
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::size_t slot_of(const Row& row, unsigned instance, unsigned element) {
    return row.first_slot + static_cast<std::size_t>(instance - 1) * row.array + element;
}

bool is_default(const Row& row, const Table& table, unsigned instance, unsigned element) {
    const std::size_t slot = slot_of(row, instance, element);
    if (row.type == Type::Text) return text_at(table, slot) == row.default_text;
    return table.numbers[slot] == row.default_number(element);
}

bool alike(const Row& row, const Table& table, unsigned instance) {
    for (unsigned element = 0; element < row.array; ++element) {
        const std::size_t one = slot_of(row, 1, element), other = slot_of(row, instance, element);
        const bool equal = row.type == Type::Text ? text_at(table, one) == text_at(table, other)
                                                  : table.numbers[one] == table.numbers[other];
        if (!equal) return false;
    }
    return true;
}

// Names of the bits that are on, for the comment.
std::string bits_on(const Row& row, double value) {
    std::string out;
    for (const Bit& bit : row.bits)
        if ((static_cast<unsigned>(value) >> bit.number & 1U) != 0)
            out += fmt::format(" {}", bit.name);
    return out;
}

void append_line(std::string& out, const Row& row, const Table& table, const Target& target) {
    const unsigned instance = target.instance == Target::kEveryInstance ? 1 : target.instance;
    const unsigned element =
        target.element == Target::kEveryElement ? 0 : static_cast<unsigned>(target.element);
    std::string line = target_text(target) + '=' + value_text(row, table, instance, element);
    line.resize(std::max(line.size() + 1, kCommentColumn), ' ');
    out += line + "; " + std::string(row.name);
    // then the axes may differ in their units
    const bool every = target.instance == Target::kEveryInstance;
    const std::string_view unit =
        every && row.scope != Scope::Global ? row.unit : unit_of(row, table, instance);
    if (!unit.empty()) out += fmt::format(", {}", unit);
    if (row.type == Type::Bits) out += bits_on(row, table.numbers[slot_of(row, instance, element)]);
    out += '\n';
}

// The least number of lines that give this row: one for all instances when they are alike.
void append_row(std::string& out, const Row& row, const Table& table, Content content) {
    const unsigned count = instances(row.scope);
    bool all_alike = true;
    for (unsigned instance = 2; instance <= count && all_alike; ++instance)
        all_alike = alike(row, table, instance);
    for (unsigned instance = 1; instance <= (all_alike ? 1 : count); ++instance) {
        for (unsigned element = 0; element < row.array; ++element) {
            if (content == Content::Changed && is_default(row, table, instance, element)) continue;
            Target target{&row};
            if (!all_alike) target.instance = instance;
            if (row.array > 1) target.element = static_cast<int>(element);
            append_line(out, row, table, target);
        }
    }
}

}  // namespace

std::string value_text(const Row& row, const Table& table, unsigned instance, unsigned element) {
    const std::size_t slot = slot_of(row, instance, element);
    if (row.type == Type::Text) return quoted_where_needed(text_at(table, slot));
    const double value = table.numbers[slot];
    // Integers without exponent, up to what a double holds exactly; the rest as the shortest
    // digits that read back.
    if (row.type != Type::Real) return fmt::format("{:.0f}", value);
    return fmt::format("{}", value);
}

std::string value_text(const Table& table, const Target& target) {
    const Row& row = *target.row;
    const auto one = [&](unsigned instance, unsigned element) {
        if (target.bit == Target::kWhole) return value_text(row, table, instance, element);
        const auto value = static_cast<unsigned>(table.numbers[slot_of(row, instance, element)]);
        return std::string((value >> target.bit & 1U) != 0 ? "1" : "0");
    };
    const bool every = target.instance == Target::kEveryInstance;
    const unsigned first = every ? 1 : target.instance,
                   last = every ? instances(row.scope) : target.instance;
    std::string lines, common;
    bool alike = true;
    for (unsigned instance = first; instance <= last; ++instance) {
        for (unsigned element = 0; element < row.array; ++element) {
            if (target.element != Target::kEveryElement &&
                static_cast<int>(element) != target.element)
                continue;
            const std::string text = one(instance, element);
            if (lines.empty()) common = text;
            alike = alike && text == common;
            Target place = target;
            if (row.scope != Scope::Global) place.instance = instance;
            if (row.array > 1) place.element = static_cast<int>(element);
            lines += fmt::format("{}{}={}", lines.empty() ? "" : "\n", target_text(place), text);
        }
    }
    return alike ? common : lines;
}

std::string target_text(const Target& target) {
    std::string out(target.row->number);
    if (target.bit != Target::kWhole) out += fmt::format("#{}", target.bit);
    if (target.element != Target::kEveryElement) out += fmt::format("[{}]", target.element);
    if (target.instance != Target::kEveryInstance && target.row->scope != Scope::Global)
        out += fmt::format(" {}{}", scope_letter(target.row->scope), target.instance);
    return out;
}

std::string export_lines(const Table& table, Content content) {
    std::string out;
    std::string_view group;
    for (const Row& row : rows()) {
        std::string lines;
        append_row(lines, row, table, content);
        if (!lines.empty() && row.group != group)
            out += fmt::format("{}; {}\n", out.empty() ? "" : "\n", row.group);
        if (!lines.empty()) group = row.group;
        out += lines;
    }
    return out;
}

std::string export_row(const Row& row, const Table& table, Content content) {
    std::string out;
    append_row(out, row, table, content);
    return out;
}

std::vector<Difference> difference(const Table& before, const Table& after) {
    std::vector<Difference> out;
    for (const Row& row : rows())
        for (unsigned instance = 1; instance <= instances(row.scope); ++instance)
            for (unsigned element = 0; element < row.array; ++element) {
                const std::size_t slot = slot_of(row, instance, element);
                const bool equal = row.type == Type::Text
                                       ? text_at(before, slot) == text_at(after, slot)
                                       : before.numbers[slot] == after.numbers[slot];
                if (!equal)
                    out.push_back(
                        {&row, instance, element, value_text(row, before, instance, element),
                         value_text(row, after, instance, element), unit_of(row, after, instance)});
            }
    return out;
}

std::string to_string(const Difference& difference) {
    const Row& row = *difference.row;
    Target target{&row, difference.instance};
    if (row.array > 1) target.element = static_cast<int>(difference.element);
    return fmt::format("{}: {} -> {}{}{}   ({})", target_text(target), difference.before,
                       difference.after, difference.unit.empty() ? "" : " ", difference.unit,
                       row.name);
}

}  // namespace polyturn::params
