// The variables that a fagor program can name (fagor_8037t part 2, 11.2), as one table: name, what
// follows it, whether its value is one of the machine's (reading stops block preparation), whether
// a program may write it.
#pragma once
#include <array>
#include <cstdint>
#include <string_view>

namespace polyturn::channels::fagor {

enum class Var : std::uint8_t {
    Tool,
    Tod,
    NextTool,
    NextOffset,
    ManagedTool,
    TablePocket,
    TableX,
    TableZ,
    TableTip,
    TableRadius,
    TableWearX,
    TableWearZ,
    NoseAngle,
    NoseWidth,
    CutAngle,
    ToolOffset,
    ToolFamily,
    ToolLife,
    ToolUsed,
    PocketTool,
    UsedRadius,
    ActiveZero,
    PolarF,
    PolarS,
    AdditiveZero,
    PlcZero,
    ParameterGeneral,
    ParameterAxis,
    ParameterSpindle,
    ParameterPlc,
    ZoneState,
    ZoneLow,
    ZoneHigh,
    FeedReal,
    FeedAxis,
    Feed,
    FeedProgram,
    FeedRev,
    FeedRevProgram,
    FeedInverse,
    Override,
    OverrideProgram,
    OverridePanel,
    Programmed,
    Position,
    Theoretical,
    PartPosition,
    PartTheoretical,
    Lag,
    Displayed,
    BlockPosition,
    SpindleReal,
    SpindleTheoretical,
    SpindleSpeed,
    SpindleProgram,
    SurfaceSpeed,
    SurfaceProgram,
    SpindleOverride,
    SpindleOverrideProgram,
    SpindleOverridePanel,
    SpindleLimit,
    SpindleAngle,
    SpindleTurnAngle,
    SpindleLag,
    SpindleAngleProgram,
    PlcInputs,
    PlcOutputs,
    PlcMarks,
    PlcRegister,
    PlcTimer,
    PlcCounter,
    PlcMark,
    CallParameters,
    Mode,
    ModeBits,
    Program,
    Label,
    GState,
    MState,
    PlaneAxes,
    LengthAxis,
    Mirror,
    Scale,
    ScaleAxis,
    Probe,
    Clock,
    Time,
    Date,
    CycleTime,
    First,
    ProbeInput,
    Diameter,
    ProbeMode,
    Parts,
    Nothing,  // belongs to equipment that is not there: reads 0
    Kept,     // a value that programs keep there themselves
    KeptAxis,
    Way,
};

enum class Shape : std::uint8_t { Plain, Axis, Index, AxisOrIndex, AxisIndex, BlockOfProgram };

struct VariableRow {
    std::string_view name;
    Shape shape;
    Var var;
    bool live;  // P in the specification: the machine must have come to this block
    bool writable;
    std::uint8_t sub;  // which of several: zone number ...
};

std::size_t variable_count();
const VariableRow& variable_row(std::size_t index);

// `axis` is the letter behind an axis name, 0 without one; nullptr: no such variable.
const VariableRow* find_variable(std::string_view name, char& axis);

}  // namespace polyturn::channels::fagor
