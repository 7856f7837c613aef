#include "channels/hold/approach.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <climits>
#include <cmath>

#include "ipc/params/table.hpp"

namespace polyturn::channels {
namespace {
constexpr double kSamePlace = 1e-6;  // mm, degrees
}  // namespace

std::vector<AxisSet> approach_order(const MachineView& view, const AxisValues& from,
                                    const AxisValues& to) {
    const int cross = view.axis_by_role(PlaneRole::BasicX);
    std::vector<std::pair<int, AxisSet>> groups;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        if (std::fabs(from[i] - to[i]) < kSamePlace) continue;
        const auto told = static_cast<int>(
            params::get(view.table(), params::pt_restart_order, view.axes[i].machine_axis + 1u));
        const int order = told > 0 ? told : static_cast<int>(i) == cross ? INT_MAX : 0;
        const auto group = std::find_if(groups.begin(), groups.end(),
                                        [&](const auto& g) { return g.first == order; });
        if (group != groups.end())
            group->second |= 1u << i;
        else
            groups.emplace_back(order, 1u << i);
    }
    std::sort(groups.begin(), groups.end());
    std::vector<AxisSet> out;
    for (const auto& [order, set] : groups) out.push_back(set);
    return out;
}

void approach(const MachineView& view, const AxisValues& from, const AxisValues& to,
              const AxisValues& pos, const BlockContext& at, Sink& sink) {
    AxisValues here = from;
    for (const AxisSet set : approach_order(view, from, to)) {
        Move move;
        move.kind = MoveKind::Rapid;
        move.exact_stop = true;
        move.moved = set;
        move.machine_start = here;
        for (unsigned i = 0; i < view.axis_count; ++i)
            if (set >> i & 1u) here[i] = to[i];
        move.machine = here;
        for (unsigned i = 0; i < view.axis_count; ++i) move.pos[i] = pos[i] + here[i] - to[i];
        sink.move(move, at);
    }
}

std::string approach_text(const MachineView& view, const AxisValues& from, const AxisValues& to) {
    std::string out;
    for (const AxisSet set : approach_order(view, from, to)) {
        if (!out.empty()) out += ", then ";
        bool first = true;
        for (unsigned i = 0; i < view.axis_count; ++i) {
            if (!(set >> i & 1u)) continue;
            out += fmt::format("{}{} {:.3f} -> {:.3f}", first ? "" : " and ", view.axes[i].name,
                               view.to_shown(i, from[i]), view.to_shown(i, to[i]));
            first = false;
        }
    }
    return out.empty() ? "the axes are there" : out;
}

}  // namespace polyturn::channels
