#include "channels/fagor/motion/loop_scan.hpp"

#include <cmath>
#include <vector>

#include "channels/cycles/contour.hpp"
#include "channels/engine/text_search.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/step.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/motion/compensation.hpp"
#include "channels/fagor/motion/contour_loops.hpp"
#include "channels/fagor/motion/lengths.hpp"
#include "channels/fagor/motion/lines.hpp"

namespace polyturn::channels::fagor {
namespace {

// of one scan; the next one begins where it ended
constexpr std::size_t kMostElements = 1000, kMostBlocks = 5000;

std::vector<cycles::Element> record_ahead(Execution& x, const Execution& caller,
                                          cycles::ContourRecorder& recorder, unsigned p, unsigned q,
                                          std::uint64_t& to) {
    x.ahead.scans_loops = true;
    x.values.take_values(caller.values);
    x.modal = caller.modal;
    x.modal.comp = 40;
    x.core.compensation_reset();
    x.core.path = caller.core.path;
    x.core.path.zones = {};
    x.core.path.second_limits = {};
    x.core.set_frame(Frame{});
    // behind compensation: nothing of the contour that is compensated
    x.core.path.factored = false;
    x.core.path.factor.fill(1.0);
    x.core.start_at_machine(x.core.path.machine);
    x.core.path.programmed = caller.core.path.programmed;
    recorder.from({x.core.path.programmed[p], x.core.path.programmed[q]});
    x.calls.share(caller.calls);
    x.run.serial = caller.run.serial;
    for (std::size_t blocks = 0;
         blocks < kMostBlocks && recorder.contour.elements.size() < kMostElements; ++blocks) {
        const Step done = step(x);
        if (x.ahead.over || done != Step::Continue || recorder.error || recorder.foreign) break;
        to = x.run.serial;
    }
    return recorder.contour.elements;
}

}  // namespace

bool scan_loops(Execution& x) {
    x.loops.plans.clear();
    x.loops.scanned_to = 0;
    if (x.modal.collision_blocks == 0 || x.modal.comp == 40 || x.ahead.scans_loops ||
        x.ahead.reads_profile)
        return true;
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    cycles::ContourRecorder recorder(p, q);
    recorder.only_plane = true;  // a block moves its other axes, whether it is left out or not
    Execution reader(x.core.view(), recorder, x.core.port(), x.programs.files);
    std::vector<cycles::Element> elements;
    {
        const engine::KeepPosition keep(x.calls.source());
        elements = record_ahead(reader, x, recorder, p, q, x.loops.scanned_to);
    }
    show_diameter(x);
    // The contour is read as it is programmed: G72 S makes it larger than that, and the nose
    // smaller beside it.
    const Nose nose{x.core.path.tool.nose_radius / x.modal.scale, x.modal.comp == 41 ? 1 : -1,
                    outer_corner(x)};
    for (const ContourLoop& loop :
         find_loops(elements, nose, static_cast<std::size_t>(x.modal.collision_blocks))) {
        const std::uint64_t before = elements[loop.before].at.serial;
        if (loop.meeting) x.loops.plans[before].end = loop.meeting;
        for (std::size_t k = loop.before + 1; k < loop.after; ++k) {
            LoopPlan& plan = x.loops.plans[elements[k].at.serial];
            plan.first = plan.first || k == loop.before + 1;
            (elements[k].at.serial == before ? plan.sharp : plan.left_out) = true;
        }
    }
    return true;
}

// The plan of this block, applied to its target. True: its way in the plane is left out.
bool leave_out(Execution& x, AxisValues& target) {
    const auto plan = x.loops.plans.find(x.core.at.serial);
    if (plan == x.loops.plans.end()) return false;
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    if (!plan->second.left_out && plan->second.end) {
        target[p] = plan->second.end->z;
        target[q] = plan->second.end->x;
    }
    if (plan->second.first)
        x.core.sink().alarm({Alarm::FagorProfileHollow,
                             {x.programs.files.path(x.core.at.file), x.core.at.line, 0, 0},
                             {},
                             {}},
                            x.core.at);
    return plan->second.left_out;
}

// The chamfer or rounding at the end of this block is too small for the nose, the block itself is
// not.
bool ends_sharp(const Execution& x) {
    const auto plan = x.loops.plans.find(x.core.at.serial);
    return plan != x.loops.plans.end() && plan->second.sharp;
}

// Only what lies outside of the plane is driven; the program is where the block would have led.
bool drive_left_out(Execution& x, const AxisValues& target, bool rapid) {
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    AxisValues stays = target;
    const AxisValues here = x.core.programmed_now();
    stays[p] = here[p];
    stays[q] = here[q];
    bool moves = false;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        moves = moves || (i != p && i != q && std::fabs(stays[i] - here[i]) > 1e-7);
    if (moves && !drive_straight(x, stays, rapid)) return false;
    x.core.path.programmed = target;
    return true;
}

}  // namespace polyturn::channels::fagor
