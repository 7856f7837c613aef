// What the operator is shown of the program: the text of MSG and the count of parts.
#pragma once
#include <string>

namespace polyturn::channels::sinumerik {

struct ShownState {
    double parts = 0;
    std::string message;
};

}  // namespace polyturn::channels::sinumerik
