// Which level a command to the kernel needs, alike for the supervisor that sends it and the kernel
// that carries it out; what is stored is judged by the store.
#pragma once
#include <string_view>

#include "polyturn/image_structs.hpp"

namespace polyturn {

// Pressing what stands on the machine's panel is the operator's; forcing signals, inputs and drive
// faults is the maker's.
constexpr UserLevel level_of(const Command& command) noexcept {
    switch (static_cast<CommandKind>(command.kind)) {
        case CommandKind::SetSignal:
        case CommandKind::ReleaseSignal:
        case CommandKind::SetInput:
        case CommandKind::DriveFault:
        case CommandKind::Sensor:
            return UserLevel::Maker;
        case CommandKind::EmergencyStop:
        case CommandKind::FeedHold:
            return UserLevel::None;  // whoever can stop a machine may
        default:
            return UserLevel::Operator;
    }
}
constexpr std::string_view level_words(const Command& command) noexcept {
    return level_of(command) == UserLevel::Maker ? "forcing signals" : "press";
}

}  // namespace polyturn
