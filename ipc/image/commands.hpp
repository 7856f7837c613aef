// The meaning of a Command's fields, kind by kind. Written by the supervisor (press, set,
// scenario), carried out by the kernel at the start of Command::tick. channel, axis, spindle count
// from 1; channel 0 means all that exist.
//
//   CycleStart                    channel; 0: those that have something to begin, object: of this
//                                 machine group, 0 of all;
//                                 flags: kStartByHand, only a block of the MDI list
//   FeedHold, Reset               channel
//   EmergencyStop, MachineOn, ReleaseStop   -
//   Mode                          channel, value: ChannelMode; flags: kStartByHand, for the block
//                                 that follows: where it runs in a hold,
//                                 the mode stays
//   Select                        channel, text: program file, value: Dialect that its job names, 0
//                                 none
//   Mdi                           channel, text: the block, which comes into the list of those
//                                 entered by hand; nothing moves
//   MdiClear                      channel: blocks of that list which have not run are taken back,
//                                 what has run is no longer shown
//   HandKey                       channel, text: a block that is started at once, by a key whose
//                                 label says so
//   Jog                           object: axis, value: seconds with the sign of the direction, from
//                                 now on when it jogs already; 0 stops it
//   Step                          object: axis, value: true mm or degrees, signed
//   Handwheel                     object: axis (0: the time of the program of `channel`), flags:
//                                 number of the wheel, value: clicks, signed
//   Reference                     object: axis, 0 all
//   FeedOverride, RapidOverride   channel, value: 1 is 100 %
//   SpindleOverride               object: spindle (0 all), value: 1 is 100 %
//   SingleBlock, OptionalStop, DryRun, MachineLock, IgnoreWaits, Retrace, RapidKey, Superpose
//                                 channel, value: 1 on, 0 off
//   BlockSkip                     channel, flags: level 1..10 (0 every level), value: 1 on, 0 off
//   SetSignal, ReleaseSignal      object: slot, flags: 0 written by the NC, 1 by the PLC; value;
//                                 channel: 0 the whole signal, else bit channel - 1 of it
//   SetInput                      object: number of the input, value: 0 or 1; flags 1: given back
//                                 to sensors and PLC
//   DriveFault                    object: axis (flags 0) or spindle (flags 1), value: 1 fault, 2
//                                 fault of its encoder, 0 gone
//   Sensor                        object: axis (kMaxAxes + n: spindle n), flags: number of the
//                                 input, channel: 1 in positive, 2 in negative, 0 in both
//                                 directions of travel, value: true machine mm or degrees from
//                                 which on the input is on
//   SetParameter                  text: a parameter line
//   Watch                         object: slot, flags as SetSignal: each change is logged as a
//                                 Signal event
//   Restart                       channel, value: block number N, flags: set of channels that
//                                 restart together (0: this one alone)
//   FirstPart, ProgramHandwheel       channel, value: 1 on, 0 off; ProgramHandwheel: for the whole
//                                     machine group of the channel
//   StoreValue                    channel, object: StoreRequestKind, flags: StoreRequest::number <<
//                                 16 | StoreRequest::field, value,
//                                 text: StoreRequest::name
//   JogInHold, Return             channel
//   StopAfterPart                 channel, value: 1 on, 0 off
//   WarmUp                        channel, value: seconds after which the program ends with its
//                                 part; 0: no warm-up
//   Scope                         flags: trace from 0, value: ScopeKind, object: what it is of (see
//                                 ScopeChoice)
//   DialogueValue                 channel, text: variable of the field, value
//   DialogueKey                   channel, value: number of the key
//   Action                        nothing but an ActionDue event with code = seq
//   ProcessDied, ProcessStopped, ProcessContinued   object: process slot (kProcessKernel ...)
//   EndRun                        controlled end: axes and spindles come to rest, then the kernel
//                                 ends
#pragma once
#include "polyturn/image_structs.hpp"

namespace polyturn {
// Command::flags and KernelEvent::line of signals
inline constexpr std::uint32_t kSlotOfNc = 0, kSlotOfPlc = 1;
// bit of Command::flags of a Watch: two slots, the low word first
inline constexpr std::uint32_t kSlotOfDouble = 2;
// Command::flags of CycleStart and Mode: a block of the MDI list, or nothing
inline constexpr std::uint32_t kStartByHand = 1;
inline constexpr std::size_t kMaxWatches = 64;  // signals that one run reports
}  // namespace polyturn
