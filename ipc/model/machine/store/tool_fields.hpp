// The columns of the tool table, declared once: name in CSV, JSON, command line and history; place
// in ToolRow; limits and unit. Languages and store name a column by its index here; the disk by its
// name, so that columns may move.
//
//   life_kind     none minutes pieces uses metres wear: the unit of life, counter and warning
//   outline       boxes about the seat of the tool, X as a radius: "X -60:0 Z -20:5; X -40:0 Z
//                 5:60"
//   size_...      half places: 1 is its own half of its place, 2 reaches over the neighbour's half
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

enum class ToolFieldType : std::uint8_t { Whole, Flag, Number, Text, Life, Outline };

struct ToolField {
    std::string_view name;
    ToolFieldType type;
    std::size_t offset;  // in ToolRow
    std::uint32_t bit;   // Flag: mask in ToolRow::state
    double least, most, fallback;
    std::string_view unit, meaning;
    bool is_text() const noexcept {
        return type == ToolFieldType::Text || type == ToolFieldType::Outline;
    }
};

// order of LifeKind
inline constexpr std::string_view kLifeKinds[] = {"none", "minutes", "pieces",
                                                  "uses", "metres",  "wear"};
inline constexpr std::string_view kLifeUnits[] = {"", "min", "pieces", "uses", "m", "mm"};

std::span<const ToolField> tool_fields() noexcept;
std::optional<std::size_t> find_tool_field(std::string_view name) noexcept;
const ToolField& tool_field(std::string_view name) noexcept;  // one that exists

double tool_number(const ToolRow& row, const ToolField& field) noexcept;
// also of numbers, as people read them
std::string tool_text(const ToolRow& row, const ToolField& field);
// Writes without asking; text only for text fields, a NaN is the fallback.
void put_tool_number(ToolRow& row, const ToolField& field, double value) noexcept;
void put_tool_text(ToolRow& row, const ToolField& field, std::string_view text) noexcept;
void clear_tool(ToolRow& row) noexcept;  // unused, every field at its fallback

// What a person wrote, checked against kind and limits.
struct ToolFieldValue {
    double number = 0.0;
    std::string text;
};
Result<ToolFieldValue> read_tool_value(const ToolField& field, std::string_view text);

// "X -60:0 Z -20:5; ..." into x0 x1 z0 z1 of each box; nothing when it is no outline of at most
// three boxes.
struct ToolOutline {
    std::uint32_t boxes = 0;
    std::array<double, 12> edge{};
};
std::optional<ToolOutline> read_outline(std::string_view text) noexcept;

}  // namespace polyturn
