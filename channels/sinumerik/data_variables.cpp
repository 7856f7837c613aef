// Machine and setting data by their names: $MC_GCODE_RESET_VALUES[5], $SC_FRAME_OFFSET_INCR_PROG=0, $MA_MAX_AX_VELO[X]. They are
// rows of the parameter registry; a program may write setting data, for its own run.
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::channels::sinumerik {
namespace {

struct DataName {
    std::string_view name, row;   // row of the registry; empty: see below
};
constexpr DataName kNames[] = {
    {"$MN_SCALING_SYSTEM_IS_METRIC", "MD10240"},
    {"$MC_DIAMETER_AX_DEF", "MD20100"},
    {"$MC_GCODE_RESET_VALUES", "MD20150"},
    {"$MC_GCODE_RESET_MODE", "MD20152"},
    {"$MC_CUTTING_EDGE_DEFAULT", "MD20270"},
    {"$MN_MIRROR_TOGGLE", "MD10612"},
    {"$MN_ENABLE_ALARM_MASK", "MD11411"},
    {"$MC_CHFRND_MAXNUM_DUMMY_BLOCKS", "MD20200"},
    {"$MC_CHFRND_MODE_MASK", "MD20201"},
    {"$MC_CUTCOM_CORNER_LIMIT", "MD20210"},
    {"$MC_CUTCOM_MAXNUM_DUMMY_BLOCKS", "MD20250"},
    {"$MC_FRAME_ADD_COMPONENTS", "MD24000"},
    {"$MA_FIX_POINT_POS", "MD30600"},
    {"$MA_NUM_FIX_POINT_POS", "MD30610"},
    {"$SA_WORKAREA_PLUS_ENABLE", "SD43400"},
    {"$SA_WORKAREA_MINUS_ENABLE", "SD43410"},
    {"$SA_WORKAREA_LIMIT_PLUS", "SD43420"},
    {"$SA_WORKAREA_LIMIT_MINUS", "SD43430"},
    {"$MC_TOOL_CHANGE_MODE", "MD22550"},
    {"$MC_TOOL_CHANGE_M_CODE", "MD22560"},
    {"$MC_TOOL_CHANGE_ERROR_MODE", "MD22562"},
    {"$MN_CIRCLE_ERROR_CONST", "MD21000"}, {"$MC_CIRCLE_ERROR_CONST", "MD21000"},
    {"$MC_CIRCLE_ERROR_FACTOR", "MD21010"},
    {"$MC_MM_NUM_R_PARAM", "MD28050"},
    {"$MC_MM_NUM_USER_FRAMES", "MD28080"},
    {"$MA_MAX_AX_VELO", "N0304"},
    {"$MA_AX_VELO_LIMIT", "N0304"},
    {"$SC_THREAD_START_ANGLE", "SD42000"},
    {"$SC_FRAME_OFFSET_INCR_PROG", "SD42440"},
    {"$SC_TOOL_OFFSET_INCR_PROG", "SD42442"},
    {"$SC_TOOL_LENGTH_CONST", "SD42940"},
    {"$SC_TOOL_LENGTH_TYPE", "SD42950"},
    {"$SA_M19_SPOS", "SD43240"}, {"$SA_M19_SPOSMODE", "SD43250"},
    {"$SA_SPIND_MIN_VELO_G25", "SD43210"}, {"$SA_SPIND_MAX_VELO_G26", "SD43220"}, {"$SA_SPIND_MAX_VELO_LIMS", "SD43230"},
    {"$SC_THREAD_RAMP_DISP", "SD42010"},
    {"$SC_SMOOTH_CONTUR_TOL", "SD42465"}, {"$SC_SMOOTH_ORI_TOL", "SD42466"},
    {"$SC_CUTCOM_CLSD_CONT", "SD42496"},
    {"$SA_IPOBRAKE_BLOCK_EXCHANGE", "SD43600"},
    {"$MN_PROG_FUNCTION_MASK", "MD10280"},
    {"$MN_MIRROR_REF_AX", "MD10610"},
    {"$MC_WAB_CLEARANCE_TOLERANCE", "MD20204"},
    {"$MC_WORKAREA_WITH_TOOL_RADIUS", "MD21020"},
    {"$MC_LIFTFAST_DIST", "MD21200"},
    {"$MA_BASE_FUNCTION_MASK", "MD30460"},
};

}  // namespace

const params::Row* Interpreter::data_row(const std::string& name) {
    for (const DataName& one : kNames)
        if (one.name == name) return params::find(one.row);
    return nullptr;
}

bool Interpreter::is_data_name(std::string_view name) const {
    for (const DataName& one : kNames)
        if (one.name == name) return true;
    return false;
}

// The cell that a data name means; found is false for names that are no data, and for those that are not built.
bool Interpreter::data_cell(const std::string& name, const std::vector<Value>& indices, const char* from, std::size_t length, DataCell& cell) {
    cell = {};
    if (name.size() < 5 || (!name.starts_with("$M") && !name.starts_with("$S")) || name[3] != '_') return true;
    const params::Row* row = data_row(name);
    if (!row) return fail_at(Alarm::SystemVariableUnknown, from, length, name);
    unsigned instance = 1;
    std::size_t element = 0;
    if (row->scope == params::Scope::Channel) instance = core_.view().channel;
    for (const Value& index : indices) {
        if (index.type == Type::Axis) {
            if (row->scope == params::Scope::Axis && index.place() >= 0 && index.place() < kSpindleAxis) instance = core_.view().axes[static_cast<std::size_t>(index.place())].machine_axis + 1u;
            else if (row->scope == params::Scope::Spindle && index.place() >= kSpindleAxis) instance = static_cast<unsigned>(index.place() - kSpindleAxis);
            else return fail_at(Alarm::AxisKindWrong, from, length, index.text);
        } else if (index.is_number() && index.number >= 0) {
            const double n = std::nearbyint(std::fmin(index.number, 1e6));
            if (row->array > 1) element = static_cast<std::size_t>(n);
            else if (row->scope == params::Scope::Spindle) instance = n > 0 ? static_cast<unsigned>(n) : modal_.master_spindle;
        } else {
            return fail_at(Alarm::ArrayIndexIllegal, from, length, name);
        }
    }
    if (row->scope == params::Scope::Spindle && indices.empty()) instance = modal_.master_spindle;
    const bool axis_missing = row->scope == params::Scope::Axis && (indices.empty() || indices.back().type != Type::Axis);
    if (axis_missing) return fail_at(Alarm::AxisArgumentMissing, from, length, name);
    if (element >= row->array || instance < 1 || instance > params::instances(row->scope)) return fail_at(Alarm::ArrayIndexIllegal, from, length, name, static_cast<double>(element));
    cell.row = row;
    cell.slot = row->first_slot + (instance - 1) * row->array + element;
    return true;
}

bool Interpreter::write_data(const DataCell& cell, const std::string& name, double value, const char* from, std::size_t length) {
    if (!name.starts_with("$S")) return fail_at(Alarm::SystemVariableReadOnly, from, length, name);
    if (!(value >= cell.row->min && value <= cell.row->max)) return fail_at(Alarm::ValueOutOfRange, from, length, name);
    params::Table& table = *core_.view().parameters;
    const std::size_t slot = cell.slot;
    undo([this, slot, before = table.numbers[slot]] {
        core_.view().parameters->numbers[slot] = before;
        settings_ = read_settings(core_.view().table(), core_.view());
    });
    table.numbers[slot] = value;
    tell_speed_limit(*cell.row, slot, value);
    if (name.starts_with("$SA_WORKAREA_LIMIT")) modal_.geo.area_high = modal_.geo.area_low = 0;   // those of G25, G26 stand there too
    settings_ = read_settings(core_.view().table(), core_.view());
    return true;
}

}  // namespace polyturn::channels::sinumerik
