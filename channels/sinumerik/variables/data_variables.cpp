// Machine and setting data by their names: $MC_GCODE_RESET_VALUES[5], $SC_FRAME_OFFSET_INCR_PROG=0,
// $MA_MAX_AX_VELO[X]. They are rows of the parameter registry; a program may write setting data,
// for its own run.
#include "channels/sinumerik/variables/data_variables.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/spindles/speed_limits.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::channels::sinumerik {
namespace {

struct DataName {
    std::string_view name, row;  // row of the registry; empty: see below
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
    {"$MN_CIRCLE_ERROR_CONST", "MD21000"},
    {"$MC_CIRCLE_ERROR_CONST", "MD21000"},
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
    {"$SA_M19_SPOS", "SD43240"},
    {"$SA_M19_SPOSMODE", "SD43250"},
    {"$SA_SPIND_MIN_VELO_G25", "SD43210"},
    {"$SA_SPIND_MAX_VELO_G26", "SD43220"},
    {"$SA_SPIND_MAX_VELO_LIMS", "SD43230"},
    {"$SC_THREAD_RAMP_DISP", "SD42010"},
    {"$SC_SMOOTH_CONTUR_TOL", "SD42465"},
    {"$SC_SMOOTH_ORI_TOL", "SD42466"},
    {"$SC_CUTCOM_CLSD_CONT", "SD42496"},
    {"$SA_IPOBRAKE_BLOCK_EXCHANGE", "SD43600"},
    {"$MN_PROG_FUNCTION_MASK", "MD10280"},
    {"$MN_MIRROR_REF_AX", "MD10610"},
    {"$MC_WAB_CLEARANCE_TOLERANCE", "MD20204"},
    {"$MC_WORKAREA_WITH_TOOL_RADIUS", "MD21020"},
    {"$MC_LIFTFAST_DIST", "MD21200"},
    {"$MA_BASE_FUNCTION_MASK", "MD30460"},
    {"$MN_IPO_CYCLE_TIME", "MD10071"},
    {"$MN_FRAME_ANGLE_INPUT_MODE", "MD10600"},
    {"$MN_CONTOUR_DEF_ANGLE_NAME", "MD10652"},
    {"$MN_RADIUS_NAME", "MD10654"},
    {"$MN_CHAMFER_NAME", "MD10656"},
    {"$MN_PROG_SD_RESET_SAVE_TAB", "MD10710"},
    {"$MC_CHAN_NAME", "N0003"},
    {"$MC_TOOL_MANAGEMENT_TOOLHOLDER", "MD20124"},
    {"$MC_CUTCOM_MAXNUM_CHECK_BLOCKS", "MD20240"},
    {"$MC_SHAPED_TOOL_TYPE_NO", "MD20370"},
    {"$MC_SMOOTHING_MODE", "MD20480"},
    {"$MC_IGNORE_OVL_FACTOR_FOR_ADIS", "MD20490"},
    {"$MC_INVOLUTE_RADIUS_DELTA", "MD21015"},
    {"$MC_X_AXES_IN_OLD_X_Z_PLANE", "MD21110"},
    {"$MC_MM_SYSTEM_FRAME_MASK", "MD28082"},
    {"$MC_MM_SHAPED_TOOLS_ENABLE", "MD28290"},
    {"$MA_AUTO_GET_TYPE", "MD30552"},
    {"$MA_POS_AX_VELO", "MD32060"},
};

// What the machine's configuration says in its own way; n: the index.
constexpr std::string_view kConfiguration[] = {
    "$MN_AXCONF_MACHAX_NAME_TAB",  "$MC_AXCONF_GEOAX_NAME_TAB", "$MC_AXCONF_CHANAX_NAME_TAB",
    "$MC_AXCONF_GEOAX_ASSIGN_TAB", "$MC_AXCONF_MACHAX_USED",    "$MN_MM_MAX_CUTTING_EDGE_PERTOOL"};

}  // namespace

const params::Row* data_row(const std::string& name) {
    for (const DataName& one : kNames)
        if (one.name == name) return params::find(one.row);
    return nullptr;
}

bool is_data_name(std::string_view name) {
    for (const std::string_view one : kConfiguration)
        if (one == name) return true;
    for (const DataName& one : kNames)
        if (one.name == name) return true;
    return false;
}

// Names and numbers of the axes (sinumerik_part2 18.1), and what the control itself fixes.
bool configuration_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                         const char* from, std::size_t length, Value& value, bool& known) {
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    known = std::find(std::begin(kConfiguration), std::end(kConfiguration), name) !=
            std::end(kConfiguration);
    if (!known) return true;
    if (name == "$MN_MM_MAX_CUTTING_EDGE_PERTOOL") {
        value = Value::of_int(kMostEdgesOfTool);
        return true;
    }
    const MachineView& view = x.core.view();
    const bool geometry = name.find("GEOAX") != std::string::npos,
               of_machine = name.starts_with("$MN");
    const std::size_t most = geometry ? 3 : of_machine ? kMaxAxes : kChannelAxes;
    if (indices.size() != 1 || !indices[0].is_number())
        return fail_at(x, Alarm::ArrayIndexMissing, from, length, name);
    const double index = std::nearbyint(indices[0].number);
    if (!(index >= 0 && index < static_cast<double>(most)))
        return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, index);
    const auto n = static_cast<std::size_t>(index);
    // the letter of the axis and 1, as MD10000 is delivered; AX and the number where this channel
    // does not have it
    if (of_machine) {
        const auto axis =
            std::find_if(view.axes.begin(), view.axes.begin() + view.axis_count,
                         [&](const ChannelAxis& one) { return one.machine_axis == n; });
        const bool ours = axis != view.axes.begin() + view.axis_count && axis->name.size() == 1;
        value = Value::of_text(ours                                ? std::string(axis->name) + "1"
                               : view.machine.axis(n + 1).exists() ? "AX" + std::to_string(n + 1)
                                                                   : std::string());
        return true;
    }
    const int place = geometry              ? view.axis_by_role(kRoles[n])
                      : n < view.axis_count ? static_cast<int>(n)
                                            : -1;
    if (name.ends_with("NAME_TAB")) {
        value = Value::of_text(place < 0 ? std::string() : axis_name(x, place));
        return true;
    }
    if (geometry) {
        value = Value::of_int(place + 1.0);
        return true;
    }
    value = Value::of_int(place < 0 ? 0.0 : view.axes[n].machine_axis + 1.0);
    return true;
}

// The cell that a data name means; found is false for names that are no data, and for those that
// are not built.
bool data_cell(Execution& x, const std::string& name, const std::vector<Value>& indices,
               const char* from, std::size_t length, DataCell& cell) {
    cell = {};
    if (name.size() < 5 || (!name.starts_with("$M") && !name.starts_with("$S")) || name[3] != '_')
        return true;
    const params::Row* row = data_row(name);
    if (!row) return fail_at(x, Alarm::SystemVariableUnknown, from, length, name);
    unsigned instance = 1;
    std::size_t element = 0;
    if (row->scope == params::Scope::Channel) instance = x.core.view().channel;
    for (const Value& index : indices) {
        if (index.type == Type::Axis) {
            if (row->scope == params::Scope::Axis && index.place() >= 0 &&
                index.place() < kSpindleAxis)
                instance =
                    x.core.view().axes[static_cast<std::size_t>(index.place())].machine_axis + 1u;
            else if (row->scope == params::Scope::Spindle && index.place() >= kSpindleAxis)
                instance = static_cast<unsigned>(index.place() - kSpindleAxis);
            else
                return fail_at(x, Alarm::AxisKindWrong, from, length, index.text);
        } else if (index.is_number() && index.number >= 0) {
            const double n = std::nearbyint(std::fmin(index.number, 1e6));
            if (row->array > 1)
                element = static_cast<std::size_t>(n);
            else if (row->scope == params::Scope::Spindle)
                instance = n > 0 ? static_cast<unsigned>(n) : x.modal.master_spindle;
        } else {
            return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name);
        }
    }
    if (row->scope == params::Scope::Spindle && indices.empty()) instance = x.modal.master_spindle;
    const bool axis_missing =
        row->scope == params::Scope::Axis && (indices.empty() || indices.back().type != Type::Axis);
    if (axis_missing) return fail_at(x, Alarm::AxisArgumentMissing, from, length, name);
    if (element >= row->array || instance < 1 || instance > params::instances(row->scope))
        return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name,
                       static_cast<double>(element));
    cell.row = row;
    cell.slot = row->first_slot + (instance - 1) * row->array + element;
    return true;
}

bool write_data(Execution& x, const DataCell& cell, const std::string& name, double value,
                const char* from, std::size_t length) {
    if (!name.starts_with("$S"))
        return fail_at(x, Alarm::SystemVariableReadOnly, from, length, name);
    if (!(value >= cell.row->min && value <= cell.row->max))
        return fail_at(x, Alarm::ValueOutOfRange, from, length, name);
    params::Table& table = *x.core.view().parameters;
    const std::size_t slot = cell.slot;
    undo(x, [&x, slot, before = table.numbers[slot]] {
        x.core.view().parameters->numbers[slot] = before;
        x.settings = read_settings(x.core.view().table(), x.core.view());
    });
    table.numbers[slot] = value;
    tell_speed_limit(x, *cell.row, slot, value);
    // those of G25, G26 stand there too
    if (name.starts_with("$SA_WORKAREA_LIMIT")) x.modal.geo.area_high = x.modal.geo.area_low = 0;
    x.settings = read_settings(x.core.view().table(), x.core.view());
    return true;
}

}  // namespace polyturn::channels::sinumerik
