// What RET of an interrupt subroutine goes back to: the state that held where the program was left
// and, when a block had begun there, its start, because that block is read again.
#pragma once
#include <memory>

#include "channels/fagor/flow/resume_state.hpp"

namespace polyturn::channels::fagor {

struct InterruptReturn {
    std::shared_ptr<ResumeState> before;  // what held where the program was left
    bool again = false;                   // the block in which it was left is read again
    AxisValues begin{};                   // the start of that block
    AxisValues left{};                    // where the subroutine has left the axes ...
    // ... for those outside of the plane that the block read again does not name
    bool fill = false;
};

}  // namespace polyturn::channels::fagor
