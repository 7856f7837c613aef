#include "channels/fagor/frames/mirror_scale.hpp"

#include "channels/fagor/execution.hpp"

namespace polyturn::channels::fagor {
namespace {

// Mirror about the part zero and scale are one frame: the numbers that are programmed lie inside of
// it (7.5, 7.6).
void refresh_frame(Execution& x) {
    const MachineView& view = x.core.view();
    double factors[3] = {x.modal.scale, x.modal.scale, x.modal.scale};
    Frame frame;
    for (unsigned i = 0; i < view.axis_count; ++i) {
        double factor = x.modal.axis_scale[i] == 0.0 ? 1.0 : x.modal.axis_scale[i];
        if (x.modal.mirrored >> i & 1u) factor = -factor;
        switch (view.axes[i].role) {
            case PlaneRole::BasicX:
                factors[0] *= factor;
                break;
            case PlaneRole::BasicY:
                factors[1] *= factor;
                break;
            case PlaneRole::BasicZ:
                factors[2] *= factor;
                break;
            default:
                frame = Frame::scaling(i, factor * x.modal.scale) * frame;
                break;
        }
    }
    // Those of single axes multiply what compensation has made of the path.
    AxisValues behind{};
    for (unsigned i = 0; i < view.axis_count; ++i)
        behind[i] = x.modal.axis_scale[i] == 0.0 ? 1.0 : x.modal.axis_scale[i];
    x.core.set_factors(behind, Frame::scaling({factors[0], factors[1], factors[2]}) * frame);
}

}  // namespace

bool g_mirror(Execution& x, const GCode& row) {
    if (x.ahead.scans_loops)
        return x.ahead.over = true;  // what comes behind lies in another system
    if (row.number == 10) {
        x.modal.mirrored = 0;
        refresh_frame(x);
        return true;
    }
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(x.words.mirrors >> k & 1u)) continue;
        const int place = x.core.view().axis_by_role(kRoles[k]);
        if (place < 0)
            return x.fail(Alarm::CoordinateAxisNone, 'G',
                          std::string("G1") + static_cast<char>('1' + k));
        x.modal.mirrored |= 1u << place;
    }
    refresh_frame(x);
    return true;
}

bool g_mirror_axes(Execution& x, const GCode&) {
    if (x.ahead.scans_loops)
        return x.ahead.over = true;  // what comes behind lies in another system
    if (!x.words.has_axes()) return x.fail(Alarm::CoordinateAxisNone, 'G', "G14");
    for (unsigned i = 0; i < x.core.view().axis_count; ++i)
        if (x.words.axis[i]) x.modal.mirrored |= 1u << i;
    refresh_frame(x);
    return true;
}

bool g_scale(Execution& x, const GCode&) {
    if (x.ahead.scans_loops)
        return x.ahead.over = true;  // what comes behind lies in another system
    if (x.words.has('S')) {
        if (x.words.has_axes()) return x.fail(Alarm::AddressIllegal, 'S', "S");
        if (x.words.number('S') <= 0)
            return x.fail(Alarm::FagorValueRange, 'S', "S", x.words.number('S'));
        x.modal.scale = x.words.number('S');
        refresh_frame(x);
        return true;
    }
    if (!x.words.has_axes()) return x.fail(Alarm::FagorMotionWord, 'G', "S or an axis", 72);
    for (unsigned i = 0; i < x.core.view().axis_count; ++i) {
        if (!x.words.axis[i]) continue;
        if (x.words.axis[i]->value <= 0)
            return x.fail_word(*x.words.axis[i], Alarm::FagorValueRange, x.core.view().axes[i].name,
                               x.words.axis[i]->value);
        x.modal.axis_scale[i] = x.words.axis[i]->value;
    }
    refresh_frame(x);
    return true;
}

}  // namespace polyturn::channels::fagor
