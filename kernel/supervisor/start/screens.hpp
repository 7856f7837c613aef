// The screens that `polyturn start` opens where there is a display. They belong to the controller
// only in that they end with it: it is not noticed when they are closed or die, and they can be
// opened again by hand (polyturn-hmi).
#pragma once
#include <string>

#include "kernel/supervisor/base/child.hpp"

namespace polyturn::supervisor {

class Screens {
public:
    // Nothing happens where there is no display, or no screens in this build.
    void open(const std::string& instance);
    // now and then: a window that was closed leaves nothing behind
    void look() { (void)child_.reap(); }
    void close();
    bool running() const { return child_.running(); }

private:
    Child child_;
};

}  // namespace polyturn::supervisor
