// The process that sends a channel's records, and what was chosen for it.
//
//         attach           stopped, goes on            died                path rests
//   Absent -----> Live <--------------------> Frozen ----------> Dead -------------> DeadAtRest
//                 ^  '------------------------ died -------------^                       |
//                 '--------------- attach of a successor, once it rests -----------------'
#pragma once
#include <cstdint>
#include <memory>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/segments.hpp"

namespace polyturn::kernel {

struct ProcessLink {
    enum class Life : std::uint8_t { Live, Frozen, Dead, DeadAtRest };

    const ChannelSegment* segment = nullptr;  // Absent: none
    Life life = Life::Live;
    std::int64_t stopped_since = 0;
    bool selected = false;                 // a program, in the process that is there now
    Dialect language{};  // of the selected program, where its job says one
    bool says_language() const noexcept { return language != Dialect{}; }  // else PT_LANGUAGE
    std::unique_ptr<ProgramNames> names = std::make_unique<ProgramNames>();

    bool attached() const noexcept { return segment != nullptr; }
    bool dead() const noexcept { return life >= Life::Dead; }
    // It has been stopped and says nothing; it may go on.
    bool frozen() const noexcept { return life == Life::Frozen; }
    bool listens() const noexcept { return segment && life == Life::Live; }
    // File name without folders.
    std::string_view program(std::uint32_t file) const noexcept;
};

}  // namespace polyturn::kernel
