#include "ipc/model/compensation/compensation_cells.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ipc/model/compensation/compensation_tables.hpp"

namespace polyturn {
namespace {

using namespace params;

using GridPoint = std::array<float, 3>;
using GridKey = std::pair<unsigned, std::int64_t>;  // channel, number
constexpr float kNotGiven = std::numeric_limits<float>::quiet_NaN();

std::string cell_text(float value) {
    char digits[32];
    // no -0
    const auto done = std::to_chars(digits, digits + sizeof digits, value == 0 ? 0.0F : value);
    return {digits, done.ptr};
}
std::string line_of(std::int64_t cell, float value) {
    return std::to_string(cell) + "=" + cell_text(value) + "\n";
}
std::string line_of(const GridKey& point, const GridPoint& value) {
    return "3D L" + std::to_string(point.first) + " " + std::to_string(point.second) + "=" +
           cell_text(value[0]) + " " + cell_text(value[1]) + " " + cell_text(value[2]) + "\n";
}

void use(std::map<std::int64_t, float>& values, std::int64_t first, std::int64_t last) {
    for (std::int64_t n = std::max(first, kFirstCell); n <= std::min(last, kLastCell); ++n)
        values.emplace(n, 0.0F);
}

// What the tables use (check_compensation_tables checks the same ranges).
void use_tables(std::map<std::int64_t, float>& values, const Table& t) {
    for (unsigned a = 1; a <= kMaxAxes; ++a) {
        const auto first = get(t, n2503_primary_smallest_cell_no, a),
                   last = get(t, n2504_primary_largest_cell_no, a),
                   second = get(t, n2505_primary_smallest_cell_no_both_dir, a);
        if (bit(t, n2500_pitch_comp_contr, a, 0)) use(values, first, last);
        if (bit(t, n2500_pitch_comp_contr, a, 0) && bit(t, n2500_pitch_comp_contr, a, 1))
            use(values, second, second + last - first);
        if (bit(t, n2500_pitch_comp_contr, a, 3))
            use(values, get(t, n2508_secondary_smallest_cell_no, a),
                get(t, n2509_secondary_largest_cell_no, a));
    }
    for (unsigned l = 1; l <= kMaxChannels; ++l)
        for (unsigned g = 1; g <= 6 && !bit(t, n2600_straightness_comp_contr, l, 0); ++g) {
            const auto moving = get(t, nth(n2601_no_of_moving_axis_1, g), l);
            if (moving < 1 || moving > static_cast<std::int64_t>(kMaxAxes)) continue;
            const auto first = get(t, nth(n2613_smallest_cell_no_of_moving_axis_1, g), l);
            use(values, first,
                first + get(t, n2504_primary_largest_cell_no, static_cast<unsigned>(moving)) -
                    get(t, n2503_primary_smallest_cell_no, static_cast<unsigned>(moving)));
        }
}

}  // namespace

std::optional<CellEntry> cell_entry(std::string_view line) {
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) return std::nullopt;
    CellEntry entry;
    const auto number = std::from_chars(line.data(), line.data() + sign, entry.cell);
    const auto value =
        std::from_chars(line.data() + sign + 1, line.data() + line.size(), entry.value);
    const bool whole = number.ec == std::errc{} && number.ptr == line.data() + sign &&
                       value.ec == std::errc{} && value.ptr == line.data() + line.size();
    if (!whole || entry.cell < kFirstCell || entry.cell > kLastCell || !std::isfinite(entry.value))
        return std::nullopt;
    return entry;
}

std::string with_cells(std::string_view content, const Table& parameters,
                       std::span<const CellEntry> entries, std::span<const PointEntry> points,
                       Gaps gaps) {
    // lines that cannot be read stay as they are; whoever checks the file says what is wrong with
    // them
    std::vector<Diagnosis> ignored;
    const CompensationTables before = parse_compensation(content, {}, ignored);
    std::map<std::int64_t, float> values;
    std::map<GridKey, GridPoint> grid;
    for (const CellEntry& entry : entries) values.insert_or_assign(entry.cell, entry.value);
    const auto was = [&](const GridKey& key) {
        const auto& all = before.points[key.first - 1];
        const auto number = static_cast<std::size_t>(key.second);
        return number < all.size() ? all[number] : GridPoint{kNotGiven, kNotGiven, kNotGiven};
    };
    const auto given = [&](const GridKey& key) {  // its other two stay
        GridPoint out = was(key);
        for (float& one : out) one = std::isnan(one) ? 0.0F : one;
        return out;
    };
    for (const PointEntry& entry : points) {
        if (entry.channel < 1 || entry.channel > kMaxChannels || entry.point < 0 ||
            entry.point >= kMostGridPoints || entry.component > 2)
            continue;
        const GridKey key{entry.channel, entry.point};
        grid.try_emplace(key, given(key)).first->second[entry.component] = entry.value;
    }
    if (content.empty() || gaps == Gaps::Filled) {
        std::map<std::int64_t, float> used;
        use_tables(used, parameters);
        for (const auto& [cell, none] : used)
            if (std::isnan(before.cells[static_cast<std::size_t>(cell - kFirstCell)]))
                values.emplace(cell, none);
        for (unsigned l = 1; l <= kMaxChannels; ++l)
            for (std::int64_t n = 0, count = compensation_grid(parameters, l).points(); n < count;
                 ++n)
                if (const GridKey key{l, n}; std::isnan(was(key)[0]))
                    grid.try_emplace(key, GridPoint{});
    }
    std::string out;
    while (!content.empty()) {
        const std::size_t end = std::min(content.find('\n'), content.size());
        const std::string_view line = content.substr(0, end);
        content.remove_prefix(std::min(content.size(), end + 1));
        const CompensationLine about = compensation_line(line);
        if (const auto found = values.find(about.cell); found != values.end()) {
            out += line_of(found->first, found->second);
            values.erase(found);
        } else if (const auto point = grid.find({about.channel, about.point});
                   point != grid.end()) {
            out += line_of(point->first, point->second);
            grid.erase(point);
        } else {
            out.append(line) += '\n';
        }
    }
    for (const auto& [cell, value] : values) out += line_of(cell, value);
    for (const auto& [point, value] : grid) out += line_of(point, value);
    return out;
}

}  // namespace polyturn
