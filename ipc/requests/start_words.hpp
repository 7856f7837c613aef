// What must hold before a program may start, as the operator reads it: the kernel judges
// (kernel/gate/start_conditions.cpp, row by row the same order), ChannelStatus::start_missing shows
// which rows fail.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace polyturn {

struct StartWords {
    std::string_view name;  // for tests and documents
    std::string_view text;  // what is missing; of an axis or spindle, its name precedes it
    std::string_view remedy;
};

inline constexpr std::array<StartWords, 22> kStartWords{{
    {"process", "the channel's process is not there", "wait until it is started again, then reset"},
    {"emergency_stop", "the emergency stop is active", "release it and switch the machine on"},
    {"machine_on", "the machine is not switched on", "switch it on"},
    {"no_stop", "everything was stopped by an alarm", "remove its cause and reset"},
    {"store", "the store is dead: nothing would be kept", "wait until it runs again"},
    {"store_whole", "the store has lost data: no production",
     "restore a backup, or let a maker confirm what is left"},
    {"reset_over", "the reset is not over", "wait until the axes rest"},
    {"by_hand", "an axis is being moved by hand", "wait until it rests"},
    {"back_on_path", "axes were moved in the hold", "press return"},
    {"alarm", "an alarm of the channel stands", "press reset"},
    {"mode", "the mode is for moving by hand", "choose auto or mdi"},
    {"door", "the door is open", "close it, or switch to setup mode"},
    {"lubrication", "the lubrication is missing", "fill up its oil"},
    {"bar", "the bar is used up", "load a new one"},
    {"tailstock", "the tailstock is neither back nor does it hold", "bring it to its end"},
    {"tool", "no tool is in place, the turret is not locked", "bring a tool into place"},
    {"chuck", "the chuck does not hold", "close it, look at its pressure"},
    {"attached", "detached", "attach it (AP_DETCHR)"},
    {"referenced", "not referenced", "reference it"},
    {"program", "no program is selected", "select one on the page of programs"},
    {"block", "no block is entered", "enter one, or choose auto"},
    {"restart", "not all channels of the restart are at their blocks",
     "wait for them; if it was refused, restart again or reset"},
}};

// The bit of a row in ChannelStatus::start_missing.
constexpr std::uint32_t start_bit(std::string_view name) noexcept {
    for (std::size_t row = 0; row < kStartWords.size(); ++row)
        if (kStartWords[row].name == name) return 1u << row;
    return 0;
}
// With one of these a channel has nothing that could begin: a start of several passes it over.
inline constexpr std::uint32_t kNothingToBegin = start_bit("program") | start_bit("block");

}  // namespace polyturn
