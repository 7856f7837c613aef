#include "ipc/params/unit.hpp"

#include <algorithm>

namespace polyturn::params {
namespace {

constexpr unsigned kRotary = 1, kInch = 0;  // bits of N0106 and N0104

bool is_inch(const Table& table, std::int64_t channel) {
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels)) return false;
    return bit(table, n0104_unit_of_measure, static_cast<unsigned>(channel), kInch);
}

}  // namespace

std::string_view unit_of(const Row& row, const Table& table, unsigned instance) noexcept {
    bool rotary = false, inch = false;
    if (row.scope == Scope::Axis) {
        rotary = bit(table, n0106_axis_properties, instance, kRotary);
        inch = !rotary && is_inch(table, get(table, n0002_axis_assign, instance));
    } else if (row.scope == Scope::Channel) {
        inch = is_inch(table, instance);
    }
    const std::string_view wanted = rotary ? "deg" : inch ? "inch" : "";
    for (std::string_view rest = row.unit; !wanted.empty() && !rest.empty();) {
        const std::string_view one = rest.substr(0, rest.find('|'));
        if (one.starts_with(wanted) || (inch && one.starts_with("ft"))) return one;
        rest.remove_prefix(std::min(rest.size(), one.size() + 1));
    }
    return row.unit.substr(0, row.unit.find('|'));
}

}  // namespace polyturn::params
