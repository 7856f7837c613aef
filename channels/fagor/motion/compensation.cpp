#include "channels/fagor/motion/compensation.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/motion/points.hpp"

namespace polyturn::channels::fagor {

bool g_comp(Execution& x, const GCode& row) {
    if (x.ahead.scans_loops) {  // what comes behind is no part of the contour
        x.ahead.over = true;
        return true;
    }
    const std::uint16_t motion =
        x.words.has(GGroup::Motion) ? x.words.code(GGroup::Motion)->number : x.modal.motion;
    if (row.number == 40) {
        if (x.modal.comp != 40 && (motion == 2 || motion == 3) && !at_standstill(x))
            return x.fail(Alarm::CompArcStartEnd, 'G');
        x.modal.comp = 40;
        x.modal.collision_blocks = 0;
        x.loops.plans.clear();
        x.loops.scanned_to = 0;
        return x.core.compensation_off(0.0, 0.0);
    }
    if (x.modal.comp == 40 && (motion == 2 || motion == 3))
        return x.fail(Alarm::CompArcStartEnd, 'G');
    if (x.words.has(GGroup::OneShot) && x.words.code(GGroup::OneShot)->number != 4)
        return x.fail(Alarm::FagorIncompatible, 'G',
                      "G" + std::to_string(x.words.code(GGroup::OneShot)->number) + " G" +
                          std::to_string(row.number));
    if (!x.settings.comp_every_plane) {
        int p = -1, q = -1;
        x.core.plane_axes(p, q);
        const MachineView& view = x.core.view();
        if (p < 0 || q < 0 || view.axes[static_cast<std::size_t>(p)].role != PlaneRole::BasicZ ||
            view.axes[static_cast<std::size_t>(q)].role != PlaneRole::BasicX)
            return x.fail(Alarm::FagorNotInPlane, 'G', "G" + std::to_string(row.number));
    }
    x.modal.collision_blocks = 0;
    if (x.words.bound_number) {
        std::int64_t blocks = 0;
        if (!whole(x, *x.words.bound_number, blocks)) return false;
        if (blocks > 50)
            return x.fail_word(*x.words.bound_number, Alarm::FagorValueRange, "N",
                               static_cast<double>(blocks));
        x.modal.collision_blocks = blocks >= 3 ? static_cast<int>(blocks) : 0;
    }
    x.loops.plans.clear();
    x.loops.scanned_to = 0;
    x.loops.due = x.modal.collision_blocks != 0;
    // the side is modal: what is active already begins nothing anew (8.2.3)
    if (x.modal.comp == row.number) return true;
    x.modal.comp = row.number;
    return x.core.compensation(row.number == 41 ? CompSide::Left : CompSide::Right);
}

// The block names axes, but no way: G91 G40 X0 under a modal G03 ends compensation where the tool
// stands (8.2.6).
bool at_standstill(Execution& x) {
    AxisValues target{};
    if ((x.words.letters & letter_set("IJKQR")) || !read_point(x, target, nullptr)) return false;
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (target[i] != x.core.path.programmed[i]) return false;
    return true;
}

compensation::Corner outer_corner(const Execution& x) {
    return x.settings.comp_mode == 1   ? compensation::Corner::Arc
           : x.settings.comp_mode == 2 ? compensation::Corner::Intersection
                                       : compensation::Corner::Extended;
}

}  // namespace polyturn::channels::fagor
