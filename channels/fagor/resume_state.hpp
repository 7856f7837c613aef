// What a resume state of fagor keeps besides positions; for resume.cpp and interrupts.cpp.
#pragma once
#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {

struct Interpreter::ResumeState {
    PathState path;
    Modal modal;
    std::vector<CallFrame> frames;
    std::vector<LocalSet> levels;
};

}  // namespace polyturn::channels::fagor
