// What a resume state of fagor keeps besides positions. Parameters, tables and zeros are not in it:
// they are put back from the undo log.
#pragma once
#include <vector>

#include "channels/fagor/flow/call_frames.hpp"
#include "channels/fagor/modal.hpp"
#include "channels/fagor/variables/values.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::fagor {

struct ResumeState {
    PathState path;
    Modal modal;
    std::vector<CallFrame> frames;
    std::vector<LocalSet> levels;
};

}  // namespace polyturn::channels::fagor
