#include "channels/fanuc/motion/stroke_area.hpp"

#include <fmt/format.h>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/tools/parameter_input.hpp"

namespace polyturn::channels::fanuc {
namespace {

// G22 X Y Z I J K: the corners of stroke range 2 in machine coordinates, the greater ones and the
// smaller ones; they become N1006 and N1007, and the range counts for the axes named.
bool stroke_limits(Execution& x) {
    MachineView& view = x.core.view();
    static constexpr struct {
        PlaneRole role;
        char greater, smaller;
    } kCorners[] = {{PlaneRole::BasicX, 'X', 'I'},
                    {PlaneRole::BasicY, 'Y', 'J'},
                    {PlaneRole::BasicZ, 'Z', 'K'}};
    for (unsigned k = 0; k < x.words.axis_count; ++k)
        if (const Word& word = x.block.words[x.words.axes[k]];
            word.axis >= 0 || (word.address != 'X' && word.address != 'Y' && word.address != 'Z'))
            return x.core.fail(Alarm::AddressIllegal, word.address, std::string(1, word.address));
    const double machine_unit =
        params::bit(view.table(), params::n0104_unit_of_measure, view.channel, 0) ? 25.4 : 1.0;
    for (const auto& [role, greater, smaller] : kCorners) {
        if (!x.block.has(greater) && !x.block.has(smaller)) continue;
        const int place = view.axis_by_role(role);
        if (place < 0)
            return x.core.fail(Alarm::AddressIllegal, x.block.has(greater) ? greater : smaller,
                               std::string(1, greater));
        if (!x.block.has(greater) || !x.block.has(smaller))
            return x.core.fail(Alarm::CycleWordMissing, 'G',
                               std::string(1, x.block.has(greater) ? smaller : greater));
        const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place)];
        const auto limit = [&](char letter) {
            return length_of(x, x.block.word(letter), place) * (axis.diameter ? 0.5 : 1.0) /
                   (axis.rotary ? 1.0 : machine_unit);
        };
        const double most = limit(greater), least = limit(smaller);
        if (most <= least)
            return x.core.fail(Alarm::CycleValueIllegal, greater, std::string(1, greater),
                               x.block.value(greater));
        const unsigned a = axis.machine_axis + 1u;
        // Where F1322 holds instead of N1006 it takes the corner too.
        if (params::get(view.table(), params::f1322, a) != 0 &&
            !give_parameter(x, fmt::format("F1322 A{}=0", a), greater))
            return false;
        if (!give_parameter(x, fmt::format("N1006 A{}={}", a, most), greater) ||
            !give_parameter(x, fmt::format("N1007 A{}={}", a, least), smaller))
            return false;
        if (!params::bit(view.table(), params::n1000_range_enable, a, 1) &&
            !give_parameter(x, fmt::format("N1000#1 A{}=1", a), greater))
            return false;
    }
    if (!params::bit(view.table(), params::n1001_strkcont, view.channel, 1) &&
        !give_parameter(x, fmt::format("N1001#1 L{}=1", view.channel), 'G'))
        return false;
    x.words.used = true;
    return true;
}

}  // namespace

// G22, G23: both sides must mean the same, so the path comes to rest.
bool g_stroke_area(Execution& x, const GCode& row) {
    const bool off = row.tenths == 230;
    const bool limits =
        x.words.axis_count || x.block.has('I') || x.block.has('J') || x.block.has('K');
    if (limits && !stroke_limits(x)) return false;
    x.run.wants_barrier = x.run.wants_barrier || limits;
    if (off == x.core.path.stroke2_off) return true;
    x.core.path.stroke2_off = off;
    x.core.signal("STROKE2", off ? 0.0 : 1.0);
    x.run.wants_barrier = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
