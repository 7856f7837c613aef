// Moves that end before their target: at a skip signal, or where a fixed stop is met.
#pragma once
#include "kernel/channel/channel.hpp"

namespace polyturn::kernel {

// A skip move (G31; with kFlying it only stores the position) ends where its signal comes: the path
// brakes, the rest of the record is dropped, and the channel, which waits at the barrier behind it,
// continues from the axes' position.
bool skip_signal(Channel& c) noexcept;
// The drives of a move that ends at a torque give no more than that, and as much as ever when it is
// over.
void allow_torque(Channel& c, const PathRecord* r) noexcept;
// The slide goes back from its fixed stop to where it is: what is read at the barrier must be that
// place.
bool leaves_stop(const Core& core, std::uint32_t number) noexcept;
void end_skipped_move(Channel& c) noexcept;

}  // namespace polyturn::kernel
