#include "channels/fagor/motion/homing.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/calls.hpp"
#include "channels/fagor/frames/inclined.hpp"

namespace polyturn::channels::fagor {

bool g_home(Execution& x, const GCode&) {
    if (!x.words.has_axes()) {
        if (x.settings.homing_subroutine == 0)
            return x.fail(Alarm::ReferenceAxisMissing, 'G', "G74");
        return call_subroutine(x, x.settings.homing_subroutine, {}, nullptr);
    }
    if (x.modal.motion == 2 || x.modal.motion == 3) x.modal.motion = 1;
    x.modal.comp = 40;
    x.core.compensation_off(0.0, 0.0);
    const MachineView& view = x.core.view();
    // The marker is looked for axis by axis, in the order in which they are programmed.
    for (unsigned k = 0; k < x.line.block.count; ++k) {
        const Word& word = x.line.block.words[k];
        const int place = word.letter == 'G' ? -1 : x.places.of(word.letter);
        if (place < 0) continue;
        const auto i = static_cast<std::size_t>(place);
        if (x.modal.inclined && (place == x.inclined.axis || place == x.inclined.orthogonal))
            set_inclined(x, 0);
        AxisValues machine = x.core.path.machine;
        machine[i] = view.axes[i].reference_mm[0];
        if (!x.core.reference(machine, 1u << i, MoveKind::Reference)) return false;
    }
    // an axis finds its reference point
    x.run.wants_barrier = x.run.wants_barrier || x.core.due_at_barrier();
    return true;
}

}  // namespace polyturn::channels::fagor
