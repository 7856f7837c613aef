#include "channels/fagor/flow/start_end.hpp"

#include "channels/engine/block_edges.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/interrupts.hpp"
#include "channels/fagor/flow/programs.hpp"
#include "channels/fagor/motion/compensation.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {
namespace {

// 000611.PIT is program 611; -1: the name is no number.
std::int64_t number_of_file(const std::string& path) {
    std::int64_t number = -1;
    for (std::size_t i = path.find_last_of('/') + 1; i < path.size() && path[i] != '.'; ++i) {
        if (path[i] < '0' || path[i] > '9' || number > 999'999) return -1;
        number = (number < 0 ? 0 : number * 10) + (path[i] - '0');
    }
    return number;
}

}  // namespace

// What the machine parameters say holds at the start of a program (fagor_8037t part 1, 9.1).
void clear_modal(Execution& x) {
    const bool diameter = x.modal.diameter;
    Modal fresh;
    fresh.written = x.modal.written;
    fresh.parts = x.modal.parts;
    fresh.speed_limit = x.modal.speed_limit;  // until power-off (4.4.1)
    // M30 and reset leave them (4.4.2)
    fresh.zero = x.modal.zero;
    fresh.zero_number = x.modal.zero_number;
    fresh.zero_added = x.modal.zero_added;
    fresh.inclined = x.core.transformed() ? 1 : 0;  // only its freezing ends (part 2, 13)
    x.modal = fresh;
    x.modal.diameter = diameter;
    x.modal.motion = x.settings.g1 ? 1 : 0;
    x.modal.plane = x.settings.g17 ? 17 : 18;
    x.modal.corner = x.settings.round_corner ? 5 : 7;
    x.modal.inch = x.settings.inch;
    x.modal.absolute = !x.settings.incremental;
    x.modal.feed_code = x.settings.per_revolution ? 95 : 94;
    x.core.path.plane = x.settings.g17 ? Plane::XY : Plane::ZX;
    x.core.path.plane_p = x.core.path.plane_q = -1;
    x.core.path.feed_mode =
        x.settings.per_revolution ? FeedMode::PerRevolution : FeedMode::PerMinute;
    x.core.path.feed = 0.0;
    x.core.path.exact_stop_mode = x.modal.corner == 7;
    x.core.path.override_locked = false;
    x.out.spindles.set(1.0, x.core.at);
    AxisValues ones{};
    ones.fill(1.0);
    x.core.set_factors(ones, Frame{});
}

void start_program(Execution& x, FileId main) {
    x.core.begin_control();
    x.core.compensation_reset();
    compensation::Options options;
    options.tips = &compensation::kTipsAround;
    options.corner = outer_corner(x);
    // 300 degrees on the tool's side
    options.intersection_from_deg = options.arc_below_deg = 60.0;
    options.small_vector = compensation::kTangentialMm;
    // 8.2.6: from the perpendicular point straight to the end of the G40 block
    options.leaves_direct = true;
    options.in_place = options.sides_meet_on_paths = options.rapid_suspends =
        options.straight_after_halt = options.idle_is_fault = true;
    options.idle_blocks = 48;
    x.core.compensation_options(options);
    clear_modal(x);
    while (x.values.levels().size() > 1) x.values.pop_level();
    CallFrame frame;
    frame.file = main;
    frame.maker = attribute_of(x, main, 'O');
    frame.program = number_of_file(x.programs.files.path(main));
    x.calls.start(frame);
    engine::begin_run(x.run);
    x.probe.under_way = x.interrupt.fill = false;
    x.facts.began_ms = x.core.port().running_ms();
    x.points.clear();
    x.values.undo().clear();
    x.core.refresh_limits();
    x.core.load_zeros();
    show_diameter(x);
    index_subroutines(x, main);
    arm_interrupts(x);
}

}  // namespace polyturn::channels::fagor
