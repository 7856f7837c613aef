// The shared image: one segment for each writing process, mapped writable by its writer and
// read-only by all others.
//
//   supervisor --commands--> kernel <--path records-- channel 1..16
//        ^   <--log, trace--   |    --channel events-->    |
//        |                     +--inputs--> plc --outputs--+
//        +--requests--> toolmgmt <--persist-- kernel       |
//        ^                 '--parameters, offsets--> all   |
//        '---------------------- event notes --------------'
//
// Virtual time (architecture 6). Participants are the channels, the PLC, toolmgmt and the
// supervisor. The kernel goes on to the next tick when for each channel either its ring holds
// PT_HORIZON records beyond the tail or its `quiet` equals the number of the newest event sent to
// it; when the PLC has answered the cycle that acts now; when the store has answered what acts now;
// and, with RunOptions::follow_log, when the supervisor's `log_seen` equals the newest event.
// Everything else is the same code as in real time.
#pragma once
#include "ipc/memory/doorbell.hpp"
#include "ipc/memory/note_ring.hpp"
#include "ipc/memory/snapshot.hpp"
#include "ipc/memory/spsc_ring.hpp"
#include "ipc/params/table.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn {

enum class SegmentKind : std::uint8_t { Supervisor, Kernel, Plc, Store, Channel };

// PlcFastPlan::read: what is not less is a digital input, by its number behind this one.
inline constexpr std::uint32_t kFastInput = 1u << 16;
static_assert(kNcSignals < kFastInput);

// Slots of SupervisorSegment::processes.
inline constexpr std::size_t kProcessKernel = 0, kProcessPlc = 1, kProcessStore = 2,
                             kProcessHmi = 3, kProcessCell = 4, kProcessDrives = 5,
                             kProcessChannel = 8;
inline constexpr std::size_t kProcesses = kProcessChannel + kMaxChannels;

struct ChannelSegment {
    static constexpr SegmentKind kKind = SegmentKind::Channel;
    SegmentHeader header;
    RingHead<PathRecord, kPathRing> path;  // tail: KernelSegment::path_tail
    // PathRecord::transform; an entry is written before the push of what names it
    std::array<Kinematics, kKinematics> kinematics;
    // «I have seen event n and have nothing more to say»; stored after all pushes
    alignas(64) std::atomic<std::uint64_t> quiet{0};
    std::atomic<std::uint64_t> heartbeat{0};  // grows while the process lives and works
    std::atomic<std::uint32_t> epoch{0};      // of the records it pushes now
    // ResumeAnswer to the event `answered`; stored before it
    std::atomic<std::uint32_t> answer{0};
    std::atomic<std::uint64_t> answered{0};
    // 1: after axes were moved in a hold, a start goes on from where they stand
    std::atomic<std::uint32_t> starts_away{0};
    RingTail event_tail;  // consumer of KernelSegment::events
    NoteHead notes;       // tail: SupervisorSegment::note_tail
    Snapshot<ProgramNames> programs;
    Snapshot<VariableList> variables;
    Snapshot<Dialogue> dialogue;
    // pictures before it belong to an earlier program
    alignas(64) std::atomic<std::uint64_t> picture_first{0};
    // BlockPicture::serial of each slot, side by side: they are searched many times a second
    std::array<std::atomic<std::uint64_t>, kPictures> picture_serials{};
    // they are not consumed, the oldest are written over: ipc/image/block_pictures.hpp
    RingHead<BlockPicture, kPictures> pictures;
    // rung after pushes and when quiet; the kernel waits on it in virtual time
    Doorbell bell;
};

struct KernelSegment {
    static constexpr SegmentKind kKind = SegmentKind::Kernel;
    SegmentHeader header;
    alignas(64) std::atomic<std::uint64_t> tick{0};  // ticks since start
    std::atomic<std::uint64_t> tick_ns{0};           // length of a tick, constant
    Snapshot<MachineStatus> status;
    std::array<RingTail, kMaxChannels> path_tail;  // everything before it is executed
    // tail: ChannelSegment::event_tail
    std::array<RingHead<ChannelEvent, 64>, kMaxChannels> events;
    std::array<Doorbell, kMaxChannels> channel_bell;  // an event, or the ring has room again
    RingHead<KernelEvent, 16384> log;                 // tail: SupervisorSegment::log_tail
    RingHead<TraceSample, 1024> trace;                // tail: SupervisorSegment::trace_tail
    RingTail command_tail;                            // consumer of SupervisorSegment::commands
    // what programs write, in path order; tail: StoreSegment::persist_tail
    RingHead<StoreRequest, 8192> persist;
    RingTail param_tail;  // consumer of StoreSegment::param_changes
    RingTail tool_tail;   // consumer of StoreSegment::tool_answers
    // own position of an axis when moving it in a hold was allowed; stored before the Resume that
    // needs it
    std::array<std::atomic<double>, kMaxAxes> left_at;
    std::array<Snapshot<MdiList>, kMaxChannels> mdi;  // blocks entered by hand
    // shapes of the machine as they stand, some times a second
    Snapshot<GuardStatus> guard;
    Snapshot<PlcInputs> plc_inputs;
    // the PLC's signals as they act (forced ones included)
    Snapshot<PlcOutputs> plc_seen;
    Snapshot<ScopeChoice> scope_choice;
    // it is not consumed, the oldest samples are written over
    RingHead<ScopeSample, kScopeRing> scope;
    Snapshot<PlcFastInputs> plc_fast;  // each tick, while the PLC has a fast task
    Doorbell plc_bell, supervisor_bell, store_bell;
    // histogram: ticks that computed for 2^(i/4) us and less
    std::array<std::atomic<std::uint64_t>, 64> tick_cost;
};

struct PlcSegment {
    static constexpr SegmentKind kKind = SegmentKind::Plc;
    SegmentHeader header;
    Snapshot<PlcOutputs> outputs;
    // of the newest outputs; stored after they are published
    alignas(64) std::atomic<std::uint64_t> cycle{0};
    PlcFastPlan fast_plan{};  // written before the segment is published
    Snapshot<PlcFastOutputs> fast;
    // of the newest of them; stored after they are published
    alignas(64) std::atomic<std::uint64_t> fast_count{0};
    Doorbell bell;
};

struct StoreSegment {
    static constexpr SegmentKind kKind = SegmentKind::Store;
    SegmentHeader header;
    alignas(64) std::atomic<std::uint64_t> version{0};  // grows with each change of what follows
    Snapshot<params::Table> parameters;
    std::array<Snapshot<ChannelStore>, kMaxChannels> channels;
    Snapshot<StoreTotals> totals;
    Snapshot<ToolTable> tools;
    Snapshot<ToolEdgeTable> edges;
    Snapshot<ToolPlaceTable> places;
    Snapshot<UserTable> users;
    // tail: KernelSegment::tool_tail; an answer is there before persist_tail has passed its
    // question
    RingHead<ToolAnswer, 64> tool_answers;
    RingHead<ParamChange, 8192> param_changes;  // tail: KernelSegment::param_tail
    // consumer of KernelSegment::persist; before it all is applied
    RingTail persist_tail;
    // persist requests before this index are on disk
    alignas(64) std::atomic<std::uint64_t> on_disk{0};
    // process that this store serves: its successor goes on in the same segment
    std::atomic<std::int64_t> supervisor{0};
    RingTail request_tail;               // consumer of SupervisorSegment::requests
    RingHead<StoreAnswer, 256> answers;  // tail: SupervisorSegment::answer_tail
    Doorbell bell;
};

struct SupervisorSegment {
    static constexpr SegmentKind kKind = SegmentKind::Supervisor;
    SegmentHeader header;
    RunOptions options;
    std::array<ProcessEntry, kProcesses> processes;
    RingHead<Command, 1024> commands;  // tail: KernelSegment::command_tail
    RingTail log_tail, trace_tail, answer_tail;
    std::array<std::atomic<std::uint64_t>, kMaxChannels> note_tail;
    // «I have seen kernel event n and have nothing more to say»
    alignas(64) std::atomic<std::uint64_t> log_seen{0};
    std::atomic<std::uint64_t> heartbeat{0};
    RingHead<StoreRequest, 256> requests;  // tail: StoreSegment::request_tail
    // rung with log_seen, commands, and when note or log room is made
    Doorbell bell;
    Doorbell store_bell;  // rung with requests
};

// Rows of ChannelStore::zeros (each kChannelAxes values, by the position of the axis in its
// channel): 0 external shift (all systems), 1..6 G54..G59, 7 work shift (G10 P0), 8 free (the shift
// of G92/G50 is not stored), 10 + p: G54.1 Pp (p = 1..300), 311 G53 (mefi), 312 G500, 313..319 and
// 9: G54.2 P1..P8 (ipc/model/machine/store/work_zeros.hpp).
inline constexpr std::size_t kZeroExternal = 0, kZeroG54 = 1, kZeroShift = 7, kZeroG541 = 10;

}  // namespace polyturn
