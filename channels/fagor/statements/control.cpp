#include "channels/fagor/statements/control.hpp"

#include "channels/fagor/execution.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels::fagor {

// What the program takes out of the operator's hands, in path order (12.3).
void tell_control(Execution& x, bool group_ends) {
    std::uint32_t bits = x.modal.one_block ? kControlNoSingleBlock : 0u;
    if (x.modal.stop_disabled || x.modal.hold_disabled) bits |= kControlNoHold | kControlNoPlcStop;
    if (group_ends) bits |= kControlGroupEnds;
    if (x.modal.spindle_override_program > 0) bits |= kControlOwnSpindleOverride;
    x.core.tell_control(bits);
}

Flow control_statement(Execution& x, std::string_view word, const char*&, const char*) {
    const bool block = word == "ESBLK" || word == "DSBLK";
    if (block)
        x.modal.one_block = word == "ESBLK";
    else if (word == "DSTOP" || word == "ESTOP")
        x.modal.stop_disabled = word == "DSTOP";
    else
        x.modal.hold_disabled = word == "DFHOLD";
    tell_control(x, block && !x.modal.one_block);
    return Flow::Done;
}

}  // namespace polyturn::channels::fagor
