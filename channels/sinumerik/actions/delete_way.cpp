// DELDTG: what is left of a straight way is deleted where a condition on positions begins to hold
// (sinumerik_part3 8).
//
//   from              t                    target       condition  - - - - - * + + + + + + +
//    o----------------o· · · · · · · · · · ·o
//
// The condition is asked along the way, kWaySamples times, then between the last point where it
// does not hold and the first where it does, down to kWayExact. What holds on less than a sample's
// distance is not seen. A condition may ask positions and variables only: what else changes while
// the axes move is not known before they do.
#include "channels/sinumerik/actions/delete_way.hpp"

#include <algorithm>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/control.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/words.hpp"
#include "channels/sinumerik/variables/changes.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kWaySamples = 1000;
constexpr double kWayExact = 1e-7;  // mm or degrees of the axis that moves farthest
constexpr std::string_view kWayPositions[] = {"AA_IM",    "AA_IW", "AA_IB", "AC_MARKER",
                                              "AC_PARAM", "R",     "PI"};

// Does its condition hold when the axes stand at `point`?
bool holds_at(Execution& x, const SynchronizedAction& action, const AxisValues& point,
              bool& holds) {
    const AxisValues programmed = x.core.path.programmed, machine = x.core.path.machine;
    const AxisValues here = x.core.framed(programmed), there = x.core.framed(point);
    const Cursor cursor = x.line.cursor;
    for (std::size_t i = 0; i < point.size(); ++i) x.core.path.machine[i] += there[i] - here[i];
    x.core.path.programmed = point;
    x.line.cursor = Cursor(action.text);
    x.line.cursor.advance(action.condition_at);
    const bool known = condition(x, holds);
    x.line.cursor = cursor;
    x.core.path.programmed = programmed;
    x.core.path.machine = machine;
    return known;
}

}  // namespace

// The condition of an action that deletes a way, from the cursor to its DO.
bool asks_positions_only(Execution& x, Cursor condition, std::size_t end) {
    while (!condition.at_end() && condition.column(condition.at()) <= end) {
        const bool system = condition.next_raw() == '$';
        if (system) condition.advance(1);
        const std::string name = upper(condition.name_ahead());
        const bool known = std::find(std::begin(kWayPositions), std::end(kWayPositions), name) !=
                               std::end(kWayPositions) ||
                           (name.size() > 1 && name[0] == 'R' && is_digit(name[1]));
        if (system && !known)
            return fail_at(x, Alarm::NotBuilt, condition.at(),
                           std::max<std::size_t>(name.size(), 1), "DELDTG: $" + name);
        condition.advance(std::max<std::size_t>(name.size(), system ? 0 : 1));
    }
    return true;
}

bool deletes_travel(const Execution& x) {
    return x.actions.travel_deleted || std::any_of(x.actions.all.begin(), x.actions.all.end(),
                                                   [](const SynchronizedAction& one) {
                                                       return one.deletes_travel && !one.locked;
                                                   });
}

bool limited_travel(Execution& x, AxisValues& target) {
    if (!deletes_travel(x)) return true;
    if (x.core.compensating()) return fail(x, Alarm::CompReference);
    if (x.core.transformed() || !x.modal.trails.empty())
        return fail(x, Alarm::NotBuilt, "DELDTG: TRANSMIT, TRAILON");
    const AxisValues from = x.core.path.programmed;
    const auto at = [&](double t) {
        AxisValues point = from;
        for (std::size_t i = 0; i < point.size(); ++i) point[i] += t * (target[i] - from[i]);
        return point;
    };
    double share = x.actions.travel_deleted ? 0.0 : 1.0, longest = 0.0;
    for (std::size_t i = 0; i < target.size(); ++i)
        longest = std::fmax(longest, std::fabs(target[i] - from[i]));
    SynchronizedAction* cuts = nullptr;
    undo(x, [&x, before = x.actions.all] { x.actions.all = before; });
    for (SynchronizedAction& one : x.actions.all) {
        if (!one.deletes_travel || one.locked || one.began) continue;
        double before = 0.0;
        // EVERY: it must begin to hold
        bool held = one.when == SynchronizedAction::When::Edge && one.held_before;
        for (int k = 1; k <= kWaySamples && before < share; ++k) {
            double behind = static_cast<double>(k) / kWaySamples;
            bool holds = false;
            if (!holds_at(x, one, at(behind), holds)) return false;
            if (!holds || held) {
                held = held && holds;
                before = behind;
                continue;
            }
            while ((behind - before) * longest > kWayExact) {
                const double middle = 0.5 * (before + behind);
                if (!holds_at(x, one, at(middle), holds)) return false;
                (holds ? behind : before) = middle;
            }
            if (behind < share) {
                share = behind;
                cuts = &one;
            }
            break;
        }
    }
    if (share >= 1.0) return true;
    // reading stops behind it: no next block of the contour is known
    for (const std::string_view name : {"RND", "CHR", "CHF"})
        if (const Word* w = word(x, name); w && w->number() > 0)
            return fail_word(x, Alarm::CornerWithoutNext, *w);
    if (cuts)
        cuts->has_cut = cuts->when == SynchronizedAction::When::Once ||
                        cuts->when == SynchronizedAction::When::Edge;
    for (std::size_t i = 0; i < target.size(); ++i)
        x.modal.travel_left[i] = (1.0 - share) * (target[i] - from[i]);
    x.modal.travel_limited = true;
    target = at(share);
    stop_reading(x);
    return true;
}

}  // namespace polyturn::channels::sinumerik
