#include "channels/fagor/motion/feed.hpp"

#include <cmath>
#include <numbers>

#include "channels/fagor/execution.hpp"

namespace polyturn::channels::fagor {
namespace {

// The largest feed on the way to a target: no axis faster than it can (F0, or F never programmed).
double largest_feed(const Execution& x, const AxisValues& target) {
    const MachineView& view = x.core.view();
    const AxisValues from = x.core.framed(x.core.path.programmed), to = x.core.framed(target);
    double length2 = 0.0, seconds = 0.0, slowest = 0.0;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        const double way = std::fabs(to[i] - from[i]), can = view.axes[i].max_feed_mm_min;
        length2 += way * way;
        if (can > 0) seconds = std::fmax(seconds, way / can);
        if (can > 0 && (slowest == 0.0 || can < slowest) && !view.axes[i].rotary) slowest = can;
    }
    const double length = std::sqrt(length2);
    return seconds > 0 ? length / seconds : slowest > 0 ? slowest : 1.0;
}

}  // namespace

bool g_feed_mode(Execution& x, const GCode& row) {
    x.modal.feed_code = row.number;
    return true;
}

bool feed_word(Execution& x) {
    const Word& f = *x.words.word('F');
    if (f.value < 0) return x.fail_word(f, Alarm::NegativeSign, "F");
    if (x.modal.motion >= 33 && x.words.has_axes())
        return x.fail_word(f, Alarm::FagorIncompatible, "F in a thread");
    switch (x.modal.feed_code) {
        case 94:
            x.modal.feed_minute = f.value * x.modal.unit();
            break;
        case 95:
            x.modal.feed_revolution = f.value * x.modal.unit();
            break;
        default:
            x.modal.feed_inverse = f.value;
            break;
    }
    return true;
}

// The modal feed becomes that of the next move.
bool set_feed(Execution& x, const AxisValues& target) {
    PathState& path = x.core.path;
    // An override of the program goes before that of the panel (11.2.6).
    path.feed_path.scale = x.modal.override_program > 0 ? x.modal.override_program / 100.0 : 1.0;
    path.override_locked = x.modal.override_program > 0;
    // Degrees count as millimetres; an axis that is positioned only arrives together with the
    // others (5.2.1, 6.2).
    path.feed_path.counted = 0;
    path.feed_path.weight.fill(1.0);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        const int type = get_axis_type(x, i);
        if (type != 1 && type < 3) path.feed_path.counted |= 1u << i;
    }
    const double feed = x.modal.feed_code == 94   ? x.modal.feed_minute
                        : x.modal.feed_code == 95 ? x.modal.feed_revolution
                                                  : x.modal.feed_inverse;
    if (feed > 0) {
        path.feed = feed;
        path.feed_mode = x.modal.feed_code == 94   ? FeedMode::PerMinute
                         : x.modal.feed_code == 95 ? FeedMode::PerRevolution
                                                   : FeedMode::InverseTime;
    } else {
        path.feed = largest_feed(x, target);
        path.feed_mode = FeedMode::PerMinute;
    }
    path.feed_path.active = path.feed_mode != FeedMode::InverseTime;
    if (x.modal.feed_code == 32 && feed > 0) {
        const AxisValues from = x.core.framed(path.programmed), to = x.core.framed(target);
        double length2 = 0.0;
        for (unsigned i = 0; i < x.core.view().axis_count; ++i)
            length2 += (to[i] - from[i]) * (to[i] - from[i]);
        x.modal.feed_of_block = feed * std::sqrt(length2);
        const double most = largest_feed(x, target);
        // an axis would be too fast: its limit is the feed
        if (length2 > 0 && x.modal.feed_of_block > most) {
            x.modal.feed_of_block = most;
            path.feed = most;
            path.feed_mode = FeedMode::PerMinute;
            path.feed_path.active = true;
        }
    }
    return true;
}

// The largest feed on a circle from the angle `from` by `sweep` (radians, signed): of either axis
// what is largest of its share.
double largest_feed_on_arc(const Execution& x, double from, double sweep, unsigned p, unsigned q) {
    constexpr double kQuarter = std::numbers::pi / 2;
    const double low = std::fmin(from, from + sweep), high = std::fmax(from, from + sweep);
    double most = 0.0;
    // The share of the abscissa is |sin|, whole at odd quarters; that of the ordinate |cos|, whole
    // at even ones.
    const auto limit = [&](unsigned axis, double at_begin, double at_end, bool odd) {
        const double can = x.core.view().axes[axis].max_feed_mm_min;
        double share = std::fmax(std::fabs(at_begin), std::fabs(at_end));
        for (double k = std::ceil(low / kQuarter - 1e-9); k * kQuarter <= high + 1e-9; k += 1.0)
            if ((std::fmod(std::fabs(k), 2.0) == 1.0) == odd) share = 1.0;
        if (can > 0 && share > 1e-12 && (most == 0.0 || can / share < most)) most = can / share;
    };
    limit(p, std::sin(low), std::sin(high), true);
    limit(q, std::cos(low), std::cos(high), false);
    return most;
}

// All that moves are axes that are positioned only: "always G00" (3.7). With others they arrive
// together (6.2).
bool only_positions(const Execution& x, const AxisValues& target) {
    bool any = false;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        if (target[i] == x.core.path.programmed[i]) continue;
        const int type = get_axis_type(x, i);
        if (type != 1 && type < 3) return false;
        any = true;
    }
    return any;
}

int get_axis_type(const Execution& x, unsigned place) {
    const MachineView& view = x.core.view();
    return static_cast<int>(
        params::get(view.table(), params::fg_axistype, view.axes[place].machine_axis + 1u));
}

}  // namespace polyturn::channels::fagor
