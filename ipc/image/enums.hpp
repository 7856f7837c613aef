// The words of the shared image: what the small numbers in its fields mean.
#pragma once
#include <cstdint>

namespace polyturn {

inline constexpr std::uint64_t kMagic = 0x4E5255545953'4F50ull;

enum class RecordKind : std::uint8_t {
    None = 0,
    Line,   // start to end, all slots in proportion
    Arc,    // plane slots turn about shape[0..1], the others in proportion to the angle
    Curve,  // a blend: polynomials in shape
    Dwell,  // feed seconds or spindle revolutions (feed_mode)
    Aux,    // M, S or T to the PLC; done when the PLC has finished it
    // code: SpindleModeCode; value: 1/min or m/min or degrees; shape[0] limit 1/min (0 none),
    // shape[1] machine coordinate of the turning axis at diameter 0, axis[0] that axis; Position:
    // plane[0] SpindleApproach, shape[2] travel in degrees when Incremental (value is where it
    // leads), mask 1: its loop must be closed (no M code that closes it follows); Couple: `spindle`
    // leads, axis[0] follows (kMaxAxes + spindle from 0, or an axis): shape[0] of its turns for
    // shape[1] turns of the master, shape[2] phase in degrees (NaN: as it comes), mask 1: gear
    // (N1800), axis[1] the axis of the helix (kNoHelix none), shape[3] degrees a millimetre of it,
    // value 1/min of its own over that; Uncouple: axis[0], mask 4: CN_SSEL is `spindle`. Rpm, mask
    // 1: of a follower, for when it is free Watch: value seconds, shape[0] % to begin with,
    // shape[2] % and shape[3] 1/min; NaN: the parameter's
    SpindleMode,
    SpindleSpeed,  // S word: value 1/min for `spindle`; what it turns like is the PLC's SP_ROT
    Wait,          // code, mask; flags kFlying
    // the channel is stopped until this is executed; the kernel answers with BarrierReached
    Barrier,
    Variable,  // text names it, value; NaN empties it
    // a store write in path order: code OffsetTable, mask number (Work: row), plane[0] OffsetField
    // (Work: place), value
    Offset,
    Message,  // text for the operator
    Stop,     // code: StopReason
    // one part is finished (M99 of the main program, M30 of a counted part); value: count
    Part,
    Interrupts,  // M96, M97: code 1 on 0 off, mask InterruptBit
    Marker,      // SETM, CLEARM: code the marker (-1: all), value 1 set 0 cleared
    Flag,        // reserved for couplings and exchanges: value written to a signal
    // positioning axis: axis[0] goes to end[0] with v_max mm/s (0 rapid; PerRevolution: mm a
    // revolution of `spindle`) beside the path; nobody waits
    PositioningAxis,
    // stands until the positioning axes (kMaxAxes + spindle from 0: spindles) of
    // axis[0..axis_count) are there
    Await,
    // the drive of axis[0] may give only `value` thousandths of its torque, 0 all; shape[0] window
    // of the fixed stop in mm (0: PT_STOP_WINDOW)
    Torque,
    // waits until the axes axis[0..axis_count) that have no reference point have found it
    Home,
    // a value of a tool in path order: mask data number, plane[0] edge, value; code: index of the
    // tool field (of an edge: tool parameter DP); text of a text field
    ToolData,
    Parameter,  // text: a parameter line that the program gives (G10 L50), for the store
    // a step of registering tool life groups (G10 L3): code LifeGroupStep, mask group, plane[0]
    // LifeKind, value life; Tool: value station, text: offset, place in the order, life
    LifeGroup,
};

enum RecordFlag : std::uint32_t {
    kBlockBegin = 1u << 0,  // first record of a block: its move begins here
    kBlockEnd = 1u << 1,    // last record of a block: single block stops here, its move ends here
    // path speed is 0 at the end (corner that is no blend, G9, G61, last before a barrier)
    kExactStop = 1u << 2,
    kInPosition = 1u << 3,      // and the measured axes must be in position before the next record
    kRapid = 1u << 4,           // rapid override acts, feed override does not
    kThread = 1u << 5,          // follows the spindle's angle; overrides locked
    kThreadChained = 1u << 6,   // the thread goes on from the record before: no new start angle
    kOverrideLocked = 1u << 7,  // feed override is 100 %
    kDrains = 1u << 8,          // the channel waits for a BarrierReached when this is executed
    kFlying = 1u << 9,          // a wait that does not brake if the partners are there
    kThreadEnd = 1u << 10,  // last record of a thread: it may start once this one is in the ring
    kSkipMove = 1u << 11,   // ends when the skip input comes (a dwell too)
    kReference = 1u << 12,  // reported as a move of kind reference
    // its effect is not waited for: a spindle that is positioned, an M code that is finished
    // later
    kPositioning = 1u << 13,
    kStopMustCome = 1u << 14,  // kFixedStop: the end of the move without a stop is an alarm
    // rigid tapping: the last slot is a spindle (axis[i] = kMaxAxes + spindle from 0), in
    // revolutions
    kTapping = 1u << 16,
    kTapOut = 1u << 17,       // and this is the retract from the hole
    kMoreBefore = 1u << 19,   // a piece of a curve: its move has begun with an earlier one
    kMoreBehind = 1u << 20,   // and ends with a later one
    kSkipRelease = 1u << 21,  // a skip move that ends when the input goes
    // ends where the axis stops moving though its drive gives the torque of `value` (thousandths)
    kFixedStop = 1u << 18,
};

// Transformations (ipc/kinematics). Roles: Polar linear, rotary; Cylinder rotary; Inclined
// inclined, square; FiveAxis X Y Z, first, second rotary.
enum class KinematicsKind : std::uint32_t { None = 0, Polar, Cylinder, Inclined, FiveAxis };
// Through: a line through the pole; the rotary axis stays at `turn`, the linear one goes from one
// side to the other.
enum class SideOfPole : std::uint8_t { None = 0, Positive, Negative, Through };

// Answers of a channel to AskResume.
// Nothing: no value that it uses has changed
enum class ResumeAnswer : std::uint32_t { Nothing = 0, GoesBack, Cannot };

enum InterruptBit : std::uint32_t {
    kInterruptAtBlockEnd = 1u << 0,
    kInterruptByLevel = 1u << 1,
    kInterruptByMint = 1u << 2
};

inline constexpr std::uint8_t kNoHelix = 0xFF;
enum class FeedMode : std::uint8_t {
    Rapid = 0,
    PerMinute,
    PerRevolution,
    InverseTime,
    Thread,
    Seconds,
    Revolutions
};
enum class SpindleModeCode : std::int32_t {
    Rpm = 0,
    SurfaceSpeed,
    Position,
    Off,
    Limit,
    Watch,
    WatchOff,
    Couple,
    Uncouple
};
// How a positioned spindle comes to an angle.
enum class SpindleApproach : std::uint8_t { Shortest = 0, Positive, Negative, Incremental };
enum class StopReason : std::int32_t {
    None = 0,
    M00,
    M01,
    M02,
    M30,
    End,
    Held,
    Waiting,
    SingleBlock,
    Alarm,
    Reset,
    Death,
    Restart,    // before the approach of a restart
    FirstPart,  // before a tool, in first-part mode
    // no further back, or at the position where retrace began
    Retrace,
    // until the operator has answered what ChannelSegment::dialogue asks
    Dialogue
};
enum class ChannelState : std::uint32_t {
    Absent = 0,
    Reset,
    Running,
    Held,
    Waiting,
    ProgramStop,
    Ended,
    Interrupted,
    Dead
};
enum class ChannelMode : std::uint32_t { Auto = 0, Mdi, Jog, Handwheel, Reference };
// AtBlock: what comes next is the approach
enum class RestartState : std::uint32_t { None = 0, Searching, AtBlock };
enum class ProcessState : std::uint32_t { Absent = 0, Starting, Running, Stopped, Dead };

enum class ChannelEventKind : std::uint32_t {
    None = 0,
    // interpret from the selected program's start (or MDI text); value: parts to make
    CycleStart,
    BarrierReached,  // `record` was executed; axis positions of that tick are in the machine status
    // epoch raised; all that was pushed and not executed is void; start again at the head
    Reset,
    StoreChanged,   // offsets, zeros, parameters: take them at the next barrier
    SelectProgram,  // text: file; value: its Dialect, 0 as PT_LANGUAGE says
    Quit,           // end the process
    // the interrupt signal came and the path rests: epoch raised; value: serial of the first block
    // of which not everything is executed (0 none), record: 1 when it has begun
    Interrupt,
    // as CycleStart, but what precedes a block is interpreted without moving: text `N<block>`,
    // record: the set of channels that restart together
    Restart,
    // the path is held: would the channel go back? value and record as Resume. Answered in
    // ChannelSegment::answer
    AskResume,
    // the path is held; epoch raised: interpretation goes back to the place and reads on with the
    // values that hold now; value: serial of the block (0: none, all is executed), record: part of
    // it, bit 32: that has begun
    Resume,
    // text: a block that is executed in the hold, epoch raised; the program goes on by Resume
    HeldMdi,
    // text: variable of a field of the dialogue, value: what the operator has entered
    DialogueValue,
    DialogueKey,  // value: the key that ends the dialogue; the barrier behind it follows
};
// Bits of ChannelEvent::record of AskResume and Resume, above the part.
inline constexpr std::uint64_t kResumeBegun = 1ull << 32;   // it was held within the part
inline constexpr std::uint64_t kResumeByHand = 1ull << 33;  // a block by hand comes first
// axes were moved in the hold (KernelSegment::left_at) and do not go back first
inline constexpr std::uint64_t kResumeAway = 1ull << 34;

enum class KernelEventKind : std::uint32_t {
    None = 0,
    RecordBegin,  // note, channel: a block's move (or aux, dwell ...) begins
    RecordEnd,    // note, channel
    CycleStarted,
    CycleEnded,  // channel; CycleEnded: code StopReason
    Signal,      // a watched signal changed: code slot, line 0 NC / 1 PLC, value
    Message,     // text for the operator; code Alarm of severity message or warning
    Alarm,       // code Alarm, text detail, value, line
    Stopped,     // channel is stopped: code StopReason
    Idle,        // nothing can go on and no command is due: virtual time is stopped
    // a command that the supervisor must carry out itself (kill, stop): code command sequence
    ActionDue,
    Tick,          // supervision: the clock
    MachineState,  // value: machine_state, code: MachineStep, text
    // an axis begins an asynchronous motion: code axis (from 1), value its target
    PositioningBegin,
    PositioningEnd,  // it has come to rest: code axis, value where
};

enum class CommandKind : std::uint32_t {
    None = 0,
    CycleStart,
    FeedHold,
    Reset,
    EmergencyStop,
    MachineOn,
    Mode,
    Select,
    Mdi,
    Jog,
    Step,
    Handwheel,
    Reference,
    FeedOverride,
    RapidOverride,
    SpindleOverride,
    SingleBlock,
    OptionalStop,
    BlockSkip,
    DryRun,
    MachineLock,
    SetSignal,
    ReleaseSignal,
    SetInput,
    DriveFault,
    SetParameter,
    Watch,
    IgnoreWaits,
    StopAfterPart,
    Action,       // the supervisor acts when it is due (kill, stop, continue a process)
    ProcessDied,  // object: process slot (see process_table.hpp); it has been reaped
    ProcessStopped,
    ProcessContinued,
    Restart,
    Retrace,
    JogInHold,
    Return,
    EndRun,  // controlled end of the kernel
    FirstPart,
    ProgramHandwheel,  // a handwheel becomes the time of the programs of a machine group
    StoreValue,        // an offset or a zero that the operator changes
    Sensor,            // a simulated touch or limit signal, see commands.hpp
    ReleaseStop,       // the emergency stop button is turned back
    RapidKey,
    WarmUp,
    Superpose,  // a handwheel adds its travel to the axes of a running program
    Scope,      // what a trace of the scope records
    DialogueValue,
    DialogueKey,  // answers to the dialogue of a program
    MdiClear,     // blocks entered by hand that have not run are taken back
    // a key that is a start by its label (tool, part transfer): one block at once, refused as a
    // start is
    HandKey,
};
// Of a block in the list of those entered by hand. BrokenOff: a reset or an alarm came while it
// ran.
enum class MdiState : std::uint32_t { Entered = 0, Runs, Done, BrokenOff };

// Of a trace of the scope. Signals are slots, inputs their numbers.
enum class ScopeKind : std::uint32_t {
    Off = 0,
    AxisCommanded,
    AxisMeasured,
    AxisError,
    AxisVelocity,
    AxisTorque,
    AxisCompensation,
    SpindleCommanded,
    SpindleSpeed,
    SpindleAngle,
    SpindleDeviation,
    PathSpeed,
    PathLeft,
    NcSignal,
    PlcSignal,
    Input,
};

// kPictureNoShift: a frame that turns, mirrors or scales, or a transformation, lies between
// programmed and machine coordinates. kPictureNoNose: absolute positions do not contain what
// nose-radius compensation adds (PathRecord::nose).
enum PictureFlag : std::uint32_t {
    kPictureNoShift = 1u << 0,
    kPictureCompLeft = 1u << 1,
    kPictureCompRight = 1u << 2,
    kPictureNoNose = 1u << 3
};

// From power-on to ready (docs/design/power-on-to-ready.md); the same sequence back after a fault.
enum class MachineStep : std::uint32_t {
    EmergencyStop = 0,
    Off,
    NotReferenced,
    Referencing,
    Ready,
    Stopped
};

enum class StoreRequestKind : std::uint32_t {
    None = 0,
    Parameter,
    OffsetValue,
    WorkZero,
    Variable,
    Counter,
    LastPosition,
    Query,
    Flush,
    Operation,    // a piece of the text of an operation of the operator (toolmgmt/operations.hpp)
    ToolCall,     // T: which tool, and where is it? Answered in StoreSegment::tool_answers
    ToolInPlace,  // the PLC has finished a T call: number is the tool that works now
    ToolLife,     // number: data number, field: LifeKind, value: what was used up
    // number: data number, field: index of the tool field, value; written by a program in path
    // order
    ToolValue,
    ToolChanged,  // the tool change code (M06) is finished: what was called before works now
    // number: data number, field: edge * 100 + tool parameter (DP), value; written by a program in
    // path order
    EdgeValue,
    // number: group, field: LifeGroupStep + 16 * LifeKind, value: life or station, name of a tool:
    // "offset order life"
    LifeGroup,
};
// How a T call names its tool: StoreRequest::field and PathRecord::plane[0] of an Aux T.
enum class ToolCallBy : std::int32_t {
    Type = 0,  // value: type number (or station, where nothing is known of types)
    Place,     // value: magazine * 10000 + pot (N2924)
    Group,     // value: tool life group of programs
    Name,      // text: name; sisters by search strategy
    Forced,    // text or value: this very tool, whatever its state
    // value: pot of the channel's turret; its name is then searched for (Sinumerik T=5)
    Location,
    // value: data number; when its life is over another tool of its type number (Fagor's families)
    Substitute,
};
enum ToolState : std::uint32_t {
    kToolActive = 1u << 0,
    kToolEnabled = 1u << 1,
    kToolLocked = 1u << 2,
    kToolWorn = 1u << 3,
    kToolWarned = 1u << 4,
    kToolBroken = 1u << 5,
    kToolFixedPlace = 1u << 6,
    kToolUsed = 1u << 7,
    kToolMeasured = 1u << 8
};
// ToolAnswer::alarm: about the tool that works; `id`: the request that it comes from, 0 an
// operator's
inline constexpr std::int32_t kToolChanges = -2;
// Registering tool life groups, step by step (G10 L3 ... G11).
enum class LifeGroupStep : std::int32_t { ForgetAll = 0, Forget, Open, Tool };
enum class LifeKind : std::uint32_t { None = 0, Minutes, Pieces, Uses, Metres, Wear };
enum class PlaceKind : std::uint32_t { Chain = 0, Matrix, Turret, Spindle, Arm };
enum PlaceState : std::uint32_t { kPlaceLocked = 1u << 0, kPlaceHalf = 1u << 1 };
enum class UserLevel : std::uint32_t { None = 0, Operator, Setter, Maker };
// Work: a row and place of ChannelStore::zeros
enum class OffsetTable : std::int32_t { Geometry = 0, Wear, SecondGeometry, Work };
enum class OffsetField : std::int32_t { X = 0, Y, Z, R, T };

// Operator's switches of a channel; block skip 1 to 10 are bits 8 to 17. Told, not pressed, are:
// that it stops after this part, that its waits are passed over (CP_NOWT), that cycle start drives
// backwards.
enum ChannelKey : std::uint32_t {
    kKeySingleBlock = 1u << 0,
    kKeyOptionalStop = 1u << 1,
    kKeyDryRun = 1u << 2,
    kKeyMachineLock = 1u << 3,
    kKeyFirstPart = 1u << 4,
    kKeyRapid = 1u << 5,
    kKeySuperpose = 1u << 6,
    kKeyStopAfterPart = 1u << 7,
    kKeyBlockSkip1 = 1u << 8,
    kKeyIgnoreWaits = 1u << 18,
    kKeyRetrace = 1u << 19
};

enum AxisFlag : std::uint32_t {
    kReferenced = 1u << 0,
    kInPos = 1u << 1,
    kMoving = 1u << 2,
    kExists = 1u << 3,
    kDriveFault = 1u << 4,
    kRotary = 1u << 5,
    kDiameter = 1u << 6
};

}  // namespace polyturn
