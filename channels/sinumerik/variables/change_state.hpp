// Changes of values that can be put back: those of the block being read, which a barrier before it
// undoes, and those of the run, for blocks that are interpreted again (resume.cpp). Newest first.
#pragma once
#include <cstdint>
#include <deque>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "channels/sinumerik/grammar/value.hpp"

namespace polyturn::channels::sinumerik {

struct Written {
    std::string name;
    Value value;
};

struct ChangeState {
    std::vector<std::function<void()>> of_block;
    std::deque<std::pair<std::uint64_t, std::function<void()>>> of_run;  // with the block's serial
    std::vector<Written> written;  // reported when the block acts
};

}  // namespace polyturn::channels::sinumerik
