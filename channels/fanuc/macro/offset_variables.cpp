#include "channels/fanuc/macro/offset_variables.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr OffsetRange kOffsetRanges[] = {
    {2001, 64, OffsetTable::Wear, OffsetField::X},
    {2101, 64, OffsetTable::Wear, OffsetField::Z},
    {2201, 64, OffsetTable::Wear, OffsetField::R},
    {2301, 64, OffsetTable::Wear, OffsetField::T},
    {2401, 49, OffsetTable::Wear, OffsetField::Y},
    {2451, 49, OffsetTable::Geometry, OffsetField::Y},
    {2701, 49, OffsetTable::Geometry, OffsetField::X},
    {2801, 49, OffsetTable::Geometry, OffsetField::Z},
    {2901, 49, OffsetTable::Geometry, OffsetField::R},
    {10001, 99, OffsetTable::Wear, OffsetField::X},
    {11001, 99, OffsetTable::Wear, OffsetField::Z},
    {12001, 99, OffsetTable::Wear, OffsetField::R},
    {13001, 99, OffsetTable::Wear, OffsetField::T},
    {14001, 99, OffsetTable::Wear, OffsetField::Y},
    {15001, 99, OffsetTable::Geometry, OffsetField::X},
    {16001, 99, OffsetTable::Geometry, OffsetField::Z},
    {17001, 99, OffsetTable::Geometry, OffsetField::R},
    {19001, 99, OffsetTable::Geometry, OffsetField::Y},
};

}  // namespace

const OffsetRange* find_range(std::int64_t number, std::int32_t& offset) {
    for (const OffsetRange& range : kOffsetRanges)
        if (number >= range.first && number < range.first + range.count) {
            offset = static_cast<std::int32_t>(number - range.first + 1);
            return &range;
        }
    return nullptr;
}

}  // namespace polyturn::channels::fanuc
