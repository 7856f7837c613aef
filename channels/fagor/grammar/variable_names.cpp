#include "channels/fagor/grammar/variable_names.hpp"

#include "channels/fagor/settings.hpp"

namespace polyturn::channels::fagor {
namespace {

using S = Shape;
using V = Var;
constexpr bool kLive = true, kNow = false, kWritable = true, kReadOnly = false;

constexpr auto kVariableRows = std::to_array<VariableRow>({
    // 11.2.2 tools
    {"TOOL", S::Plain, V::Tool, kNow, kReadOnly, 0},
    {"TOD", S::Plain, V::Tod, kNow, kReadOnly, 0},
    {"NXTOOL", S::Plain, V::NextTool, kNow, kReadOnly, 0},
    {"NXTOD", S::Plain, V::NextOffset, kNow, kReadOnly, 0},
    {"NBTOOL", S::Plain, V::ManagedTool, kNow, kReadOnly, 0},
    {"TMZP", S::Index, V::TablePocket, kNow, kReadOnly, 0},
    {"TOX", S::Index, V::TableX, kNow, kWritable, 0},
    {"TOZ", S::Index, V::TableZ, kNow, kWritable, 0},
    {"TOF", S::Index, V::TableTip, kNow, kWritable, 0},
    {"TOR", S::Index, V::TableRadius, kNow, kWritable, 0},
    {"TOI", S::Index, V::TableWearX, kNow, kWritable, 0},
    {"TOK", S::Index, V::TableWearZ, kNow, kWritable, 0},
    {"NOSEA", S::Index, V::NoseAngle, kNow, kWritable, 0},
    {"NOSEW", S::Index, V::NoseWidth, kNow, kWritable, 1},
    {"CUTA", S::Index, V::CutAngle, kNow, kWritable, 2},
    {"TLFD", S::Index, V::ToolOffset, kNow, kWritable, 3},
    {"TLFF", S::Index, V::ToolFamily, kNow, kWritable, 4},
    {"TLFN", S::Index, V::ToolLife, kNow, kWritable, 5},
    {"TLFR", S::Index, V::ToolUsed, kNow, kWritable, 6},
    {"TMZT", S::Index, V::PocketTool, kNow, kWritable, 7},
    {"HTOR", S::Plain, V::UsedRadius, kNow, kWritable, 0},
    // 11.2.3 zero offsets
    {"ORG", S::AxisOrIndex, V::ActiveZero, kNow, kWritable, 0},
    {"PORGF", S::Plain, V::PolarF, kNow, kReadOnly, 0},
    {"PORGS", S::Plain, V::PolarS, kNow, kReadOnly, 0},
    {"ADIOF", S::Axis, V::AdditiveZero, kNow, kReadOnly, 0},
    {"PLCOF", S::Axis, V::PlcZero, kLive, kWritable, 0},
    // 11.2.4 machine parameters
    {"MPG", S::Index, V::ParameterGeneral, kNow, kReadOnly, 0},
    {"MPS", S::Index, V::ParameterSpindle, kNow, kReadOnly, 0},
    {"MPLC", S::Index, V::ParameterPlc, kNow, kReadOnly, 0},
    {"MP", S::AxisIndex, V::ParameterAxis, kNow, kReadOnly, 0},
    // 11.2.5 work zones
    {"FZONE", S::Plain, V::ZoneState, kNow, kReadOnly, 0},
    {"SZONE", S::Plain, V::ZoneState, kNow, kReadOnly, 1},
    {"TZONE", S::Plain, V::ZoneState, kNow, kReadOnly, 2},
    {"FOZONE", S::Plain, V::ZoneState, kNow, kReadOnly, 3},
    {"FIZONE", S::Plain, V::ZoneState, kNow, kReadOnly, 4},
    {"FZLO", S::Axis, V::ZoneLow, kNow, kReadOnly, 0},
    {"SZLO", S::Axis, V::ZoneLow, kNow, kReadOnly, 1},
    {"TZLO", S::Axis, V::ZoneLow, kNow, kReadOnly, 2},
    {"FOZLO", S::Axis, V::ZoneLow, kNow, kReadOnly, 3},
    {"FIZLO", S::Axis, V::ZoneLow, kNow, kReadOnly, 4},
    {"FZUP", S::Axis, V::ZoneHigh, kNow, kReadOnly, 0},
    {"SZUP", S::Axis, V::ZoneHigh, kNow, kReadOnly, 1},
    {"TZUP", S::Axis, V::ZoneHigh, kNow, kReadOnly, 2},
    {"FOZUP", S::Axis, V::ZoneHigh, kNow, kReadOnly, 3},
    {"FIZUP", S::Axis, V::ZoneHigh, kNow, kReadOnly, 4},
    // 11.2.6 feeds
    {"FREAL", S::Plain, V::FeedReal, kNow, kReadOnly, 0},
    {"FREAL", S::Axis, V::FeedAxis, kNow, kReadOnly, 0},
    {"FTEO", S::Axis, V::FeedAxis, kNow, kReadOnly, 1},
    {"FEED", S::Plain, V::Feed, kNow, kReadOnly, 0},
    {"DNCF", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCF", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRGF", S::Plain, V::FeedProgram, kNow, kReadOnly, 0},
    {"FPREV", S::Plain, V::FeedRev, kNow, kReadOnly, 0},
    {"DNCFPR", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCFPR", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRGFPR", S::Plain, V::FeedRevProgram, kNow, kReadOnly, 0},
    {"PRGFIN", S::Plain, V::FeedInverse, kNow, kReadOnly, 0},
    {"PROGFIN", S::Plain, V::FeedInverse, kNow, kReadOnly, 0},
    {"FRO", S::Plain, V::Override, kNow, kReadOnly, 0},
    {"PRGFRO", S::Plain, V::OverrideProgram, kNow, kWritable, 0},
    {"DNCFRO", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCFRO", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"CNCFRO", S::Plain, V::OverridePanel, kNow, kReadOnly, 0},
    {"PLCCFR", S::Plain, V::OverridePanel, kNow, kReadOnly, 0},
    // 11.2.7 coordinates
    {"PPOS", S::Axis, V::Programmed, kNow, kReadOnly, 0},
    {"POS", S::Axis, V::Position, kLive, kReadOnly, 0},
    {"TPOS", S::Axis, V::Theoretical, kLive, kReadOnly, 0},
    {"APOS", S::Axis, V::PartPosition, kLive, kReadOnly, 0},
    {"ATPOS", S::Axis, V::PartTheoretical, kLive, kReadOnly, 0},
    {"FLWE", S::Axis, V::Lag, kLive, kReadOnly, 0},
    {"DPLY", S::Axis, V::Displayed, kNow, kReadOnly, 0},
    {"DRPO", S::Axis, V::Nothing, kNow, kReadOnly, 0},
    {"GPOS", S::BlockOfProgram, V::BlockPosition, kNow, kReadOnly, 0},
    {"DIST", S::Axis, V::Way, kLive, kWritable, 0},
    {"LIMPL", S::Axis, V::KeptAxis, kNow, kWritable, 0},
    {"LIMMI", S::Axis, V::KeptAxis, kNow, kWritable, 0},
    // 11.2.8 handwheels, 11.2.9 feedback
    {"HANPF", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"HANPS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"HANPT", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"HANPFO", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"HANDSE", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"HANFCT", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"HBEVAR", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"MASLAN", S::Plain, V::Kept, kNow, kWritable, 0},
    {"MASCFI", S::Plain, V::Kept, kNow, kWritable, 0},
    {"MASCSE", S::Plain, V::Kept, kNow, kWritable, 0},
    {"ASIN", S::Axis, V::Nothing, kNow, kReadOnly, 0},
    {"BSIN", S::Axis, V::Nothing, kNow, kReadOnly, 0},
    {"ASINS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"BSINS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    // 11.2.10 spindle
    {"SREAL", S::Plain, V::SpindleReal, kLive, kReadOnly, 0},
    {"FTEOS", S::Plain, V::SpindleTheoretical, kNow, kReadOnly, 0},
    {"SPEED", S::Plain, V::SpindleSpeed, kNow, kReadOnly, 0},
    {"DNCS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRGS", S::Plain, V::SpindleProgram, kNow, kReadOnly, 0},
    {"CSS", S::Plain, V::SurfaceSpeed, kNow, kReadOnly, 0},
    {"DNCCSS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCCSS", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRGCSS", S::Plain, V::SurfaceProgram, kNow, kReadOnly, 0},
    {"SSO", S::Plain, V::SpindleOverride, kNow, kReadOnly, 0},
    {"PRGSSO", S::Plain, V::SpindleOverrideProgram, kNow, kWritable, 0},
    {"DNCSSO", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCSSO", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"CNCSSO", S::Plain, V::SpindleOverridePanel, kNow, kReadOnly, 0},
    {"SLIMIT", S::Plain, V::SpindleLimit, kNow, kReadOnly, 0},
    {"DNCSL", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCSL", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRGSL", S::Plain, V::SpindleLimit, kNow, kReadOnly, 0},
    {"MDISL", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"POSS", S::Plain, V::SpindleAngle, kLive, kReadOnly, 0},
    {"RPOSS", S::Plain, V::SpindleTurnAngle, kLive, kReadOnly, 0},
    {"TPOSS", S::Plain, V::SpindleAngle, kLive, kReadOnly, 0},
    {"RTPOSS", S::Plain, V::SpindleTurnAngle, kLive, kReadOnly, 0},
    {"PRGSP", S::Plain, V::SpindleAngleProgram, kNow, kReadOnly, 0},
    {"FLWES", S::Plain, V::SpindleLag, kLive, kReadOnly, 0},
    // 11.2.11 PLC
    {"PLCMSG", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PLCI", S::Index, V::PlcInputs, kLive, kWritable, 0},
    {"PLCO", S::Index, V::PlcOutputs, kLive, kWritable, 0},
    {"PLCM", S::Index, V::PlcMarks, kLive, kWritable, 0},
    {"PLCR", S::Index, V::PlcRegister, kLive, kWritable, 0},
    {"PLCT", S::Index, V::PlcTimer, kLive, kWritable, 0},
    {"PLCC", S::Index, V::PlcCounter, kLive, kWritable, 0},
    {"PLCMM", S::Index, V::PlcMark, kLive, kWritable, 0},
    // 11.2.12 to 11.2.14
    {"CALLP", S::Plain, V::CallParameters, kNow, kReadOnly, 0},
    {"OPMODE", S::Plain, V::Mode, kNow, kReadOnly, 0},
    {"OPMODA", S::Plain, V::ModeBits, kNow, kReadOnly, 0},
    {"OPMODB", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"OPMODC", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRGN", S::Plain, V::Program, kNow, kReadOnly, 0},
    {"BLKN", S::Plain, V::Label, kNow, kReadOnly, 0},
    {"GS", S::Index, V::GState, kNow, kReadOnly, 0},
    {"MS", S::Index, V::MState, kNow, kReadOnly, 0},
    {"PLANE", S::Plain, V::PlaneAxes, kNow, kReadOnly, 0},
    {"LONGAX", S::Plain, V::LengthAxis, kNow, kReadOnly, 0},
    {"MIRROR", S::Plain, V::Mirror, kNow, kReadOnly, 0},
    {"SCALE", S::Plain, V::Scale, kNow, kReadOnly, 0},
    {"SCALE", S::Axis, V::ScaleAxis, kNow, kReadOnly, 0},
    {"ORGROT", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"PRBST", S::Plain, V::Probe, kLive, kReadOnly, 0},
    {"CLOCK", S::Plain, V::Clock, kLive, kReadOnly, 0},
    {"TIME", S::Plain, V::Time, kLive, kReadOnly, 0},
    {"DATE", S::Plain, V::Date, kLive, kReadOnly, 0},
    {"CYTIME", S::Plain, V::CycleTime, kLive, kReadOnly, 0},
    {"FIRST", S::Plain, V::First, kNow, kReadOnly, 0},
    {"ANAI", S::Index, V::Nothing, kLive, kReadOnly, 0},
    {"TIMEG", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"RIP", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"TIMER", S::Plain, V::Kept, kLive, kWritable, 0},
    {"PARTC", S::Plain, V::Parts, kLive, kWritable, 0},
    {"KEY", S::Plain, V::Nothing, kLive, kReadOnly, 0},
    {"KEYSRC", S::Plain, V::Kept, kNow, kWritable, 0},
    {"ANAO", S::Index, V::Kept, kLive, kWritable, 0},
    {"SELPRO", S::Plain, V::ProbeInput, kLive, kWritable, 0},
    {"DIAM", S::Plain, V::Diameter, kNow, kWritable, 0},
    {"PRBMOD", S::Plain, V::ProbeMode, kNow, kWritable, 0},
    {"FBDIF", S::Axis, V::Nothing, kNow, kReadOnly, 0},
    {"CYCLEV", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"CYCEDI", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"DISBLO", S::Plain, V::Nothing, kNow, kReadOnly, 0},
    {"MIXPO", S::Axis, V::Displayed, kNow, kReadOnly, 0},
    {"FLWAC", S::Axis, V::Lag, kNow, kReadOnly, 0},
    {"RADIOC", S::Plain, V::Nothing, kNow, kReadOnly, 0},
});

constexpr bool with_axis(Shape shape) {
    return shape == S::Axis || shape == S::AxisOrIndex || shape == S::AxisIndex ||
           shape == S::BlockOfProgram;
}

}  // namespace

std::size_t variable_count() { return kVariableRows.size(); }
const VariableRow& variable_row(std::size_t index) { return kVariableRows[index]; }

const VariableRow* find_variable(std::string_view name, char& axis) {
    axis = 0;
    for (const VariableRow& row : kVariableRows)
        if (!with_axis(row.shape) && row.name == name) return &row;
    if (name.size() < 3 || axis_number(name.back()) == 0) return nullptr;
    const std::string_view stem = name.substr(0, name.size() - 1);
    for (const VariableRow& row : kVariableRows) {
        if (!with_axis(row.shape) || row.name != stem) continue;
        axis = name.back();
        return &row;
    }
    return nullptr;
}

}  // namespace polyturn::channels::fagor
