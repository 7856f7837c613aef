// Nothing of a program begins or goes on without a permit (kernel/gate): a refused one has been
// said.
#pragma once
#include <optional>

#include "kernel/channel/channel.hpp"
#include "kernel/gate/motion_gate.hpp"
#include "kernel/gate/start_conditions.hpp"

namespace polyturn::kernel {

// What the start conditions must know of the channel.
StartView start_view(const Channel& c) noexcept;
std::optional<StartPermit> permit_of(Channel& c, Door door, const StartView& view) noexcept;
// `door`: another one than the key of cycle start.
void start_by(Channel& c, std::optional<Door> door) noexcept;
// `text`: a block by hand, which begins no program and no part.
void begin_program(Channel& c, StartPermit, ChannelEventKind how, double value,
                   std::uint64_t record, std::string_view text) noexcept;

}  // namespace polyturn::kernel
