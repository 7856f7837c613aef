// Ends the process when one PLC cycle computes for longer than kCpuLimit: an endless loop becomes
// what a crash is, and the machine stops in a controlled way. It counts processor time, so a busy
// or suspended computer is not mistaken for a fault of the PLC; a PLC that sleeps is the kernel's
// to notice, its outputs stay away.
//
//   cycle     |  7  |  8  |  9 ................................ 9
//   timer     ^           ^           ^ still 9, was 9: end
//
// Cost: two stores a cycle. Weakness: a cycle is ended after one to two limits.
#pragma once
#include <cstdint>

namespace polyturn::plc::cycle_watch {

inline constexpr std::int64_t kCpuLimitMs = 500;

void start();  // once
void begin(std::uint64_t cycle) noexcept;
void end() noexcept;

}  // namespace polyturn::plc::cycle_watch
