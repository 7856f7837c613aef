// How far the search for the block at which a program restarts has come, alone or as a member of a
// group (restart_groups.hpp).
#pragma once
#include <cstdint>

#include "polyturn/image_structs.hpp"

namespace polyturn::kernel {

struct RestartStage {
    RestartState stage = RestartState::None;
    std::uint32_t group = 0;  // of the search
    bool complete = false;    // all of its group are at their blocks
    // a start would begin the program at its first block, which was not requested
    bool refused = false;

    bool searches() const noexcept { return stage == RestartState::Searching; }
    bool at_block() const noexcept { return stage == RestartState::AtBlock; }
    void search(std::uint32_t of_group) noexcept {
        stage = RestartState::Searching;
        group = of_group;
        complete = refused = false;
    }
};

}  // namespace polyturn::kernel
