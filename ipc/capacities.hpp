// How much one machine can hold. Part of the layout hash: processes built with other numbers refuse
// to attach. The control languages' own limits (8 channels, 32 axes, 16 spindles) are smaller and
// belong to the languages.
#pragma once
#include <cstddef>
#include <cstdint>

namespace polyturn {

inline constexpr std::size_t kMaxChannels = 16;
inline constexpr std::size_t kMaxAxes = 96;
inline constexpr std::size_t kMaxSpindles = 32;
inline constexpr std::size_t kMaxGroups = 8;

inline constexpr std::size_t kMaxPathAxes = 8;  // axes that one record moves together
// axes that a blend can bend; a corner of more is a stop
inline constexpr std::size_t kMaxCurveAxes = 5;
// bytes of a program's path or a block by hand, the end included
inline constexpr std::size_t kCommandText = 256;
// transformations that a channel's records can name
inline constexpr std::size_t kKinematics = 16;
// blocks that a channel's list of those entered by hand holds
inline constexpr std::size_t kMdiLines = 16;
inline constexpr std::size_t kPathRing = 4096;  // records a channel can be ahead of the machine
// Changes of what holds in a channel that screens can look up: each record that waits in the ring
// may have one of its own (G0 and G1 in turn), and there are blocks without a record.
inline constexpr std::size_t kPictures = 2 * kPathRing;
// bytes of event notes a channel can be ahead of its reader
inline constexpr std::size_t kNoteRing = 1u << 20;
// offset numbers 0..999 of a channel; 0 is always zero
inline constexpr std::size_t kOffsets = 1000;
// zero offsets of a channel, see work_zero_index()
inline constexpr std::size_t kWorkZeros = 320;
inline constexpr std::size_t kChannelAxes = 16;  // axes of one channel
// variables a channel keeps over power-off
inline constexpr std::size_t kPersistentVariables = 1000;
inline constexpr std::size_t kTools = 1000;      // rows of the tool table (N2902)
inline constexpr std::size_t kToolEdges = 3000;  // cutting edges of all tools
// places of all magazines, spindles and change arms
inline constexpr std::size_t kToolPlaces = 2000;
inline constexpr std::size_t kUsers = 64;
inline constexpr std::size_t kScopeTraces = 8;       // signals that the scope records at each tick
inline constexpr std::size_t kScopeRing = 8192;      // ticks that a screen may be late
inline constexpr std::size_t kShownVariables = 800;  // of a channel, on screens
inline constexpr std::size_t kDialogueFields = 32;   // values that one page of a dialogue asks for
// that the PLC's fast task Int0 reads, and that it writes
inline constexpr std::size_t kFastSignals = 64;
inline constexpr std::size_t kInputs = 256;  // digital inputs of the machine

}  // namespace polyturn
