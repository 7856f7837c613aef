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
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kWaySamples = 1000;
constexpr double kWayExact = 1e-7;  // mm or degrees of the axis that moves farthest
constexpr std::string_view kWayPositions[] = {"AA_IM",    "AA_IW", "AA_IB", "AC_MARKER",
                                              "AC_PARAM", "R",     "PI"};

}  // namespace

// The condition of an action that deletes a way, from the cursor to its DO.
bool Interpreter::asks_positions_only(Cursor condition, std::size_t end) {
    while (!condition.at_end() && condition.column(condition.at()) <= end) {
        const bool system = condition.next_raw() == '$';
        if (system) condition.advance(1);
        const std::string name = upper(condition.name_ahead());
        const bool known = std::find(std::begin(kWayPositions), std::end(kWayPositions), name) !=
                               std::end(kWayPositions) ||
                           (name.size() > 1 && name[0] == 'R' && is_digit(name[1]));
        if (system && !known)
            return fail_at(Alarm::NotBuilt, condition.at(), std::max<std::size_t>(name.size(), 1),
                           "DELDTG: $" + name);
        condition.advance(std::max<std::size_t>(name.size(), system ? 0 : 1));
    }
    return true;
}

bool Interpreter::deletes_travel() const {
    return travel_deleted_ ||
           std::any_of(actions_.begin(), actions_.end(), [](const SynchronizedAction& one) {
               return one.deletes_travel && !one.locked;
           });
}

// Does its condition hold when the axes stand at `point`?
bool Interpreter::holds_at(const SynchronizedAction& action, const AxisValues& point, bool& holds) {
    const AxisValues programmed = core_.path.programmed, machine = core_.path.machine;
    const AxisValues here = core_.framed(programmed), there = core_.framed(point);
    const Cursor cursor = cursor_;
    for (std::size_t i = 0; i < point.size(); ++i) core_.path.machine[i] += there[i] - here[i];
    core_.path.programmed = point;
    cursor_ = Cursor(action.text);
    cursor_.advance(action.condition_at);
    const bool known = condition(holds);
    cursor_ = cursor;
    core_.path.programmed = programmed;
    core_.path.machine = machine;
    return known;
}

bool Interpreter::limited_travel(AxisValues& target) {
    if (!deletes_travel()) return true;
    if (core_.compensating()) return fail(Alarm::CompReference);
    if (core_.transformed() || !modal_.trails.empty())
        return fail(Alarm::NotBuilt, "DELDTG: TRANSMIT, TRAILON");
    const AxisValues from = core_.path.programmed;
    const auto at = [&](double t) {
        AxisValues point = from;
        for (std::size_t i = 0; i < point.size(); ++i) point[i] += t * (target[i] - from[i]);
        return point;
    };
    double share = travel_deleted_ ? 0.0 : 1.0, longest = 0.0;
    for (std::size_t i = 0; i < target.size(); ++i)
        longest = std::fmax(longest, std::fabs(target[i] - from[i]));
    SynchronizedAction* cuts = nullptr;
    undo([this, before = actions_] { actions_ = before; });
    for (SynchronizedAction& one : actions_) {
        if (!one.deletes_travel || one.locked || one.began) continue;
        double before = 0.0;
        // EVERY: it must begin to hold
        bool held = one.when == SynchronizedAction::When::Edge && one.held_before;
        for (int k = 1; k <= kWaySamples && before < share; ++k) {
            double behind = static_cast<double>(k) / kWaySamples;
            bool holds = false;
            if (!holds_at(one, at(behind), holds)) return false;
            if (!holds || held) {
                held = held && holds;
                before = behind;
                continue;
            }
            while ((behind - before) * longest > kWayExact) {
                const double middle = 0.5 * (before + behind);
                if (!holds_at(one, at(middle), holds)) return false;
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
        if (const Word* w = word(name); w && w->number() > 0)
            return fail_word(Alarm::CornerWithoutNext, *w);
    if (cuts)
        cuts->has_cut = cuts->when == SynchronizedAction::When::Once ||
                        cuts->when == SynchronizedAction::When::Edge;
    for (std::size_t i = 0; i < target.size(); ++i)
        modal_.travel_left[i] = (1.0 - share) * (target[i] - from[i]);
    modal_.travel_limited = true;
    target = at(share);
    stop_reading();
    return true;
}

}  // namespace polyturn::channels::sinumerik
