// Offsets as a setter enters them: absolute, incremental, measured, relative; undo; the history of
// everything. A request that names a tool and an edge means that edge ($TC_DPx) in place of a
// number of the table.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "ipc/image/segments.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/apply_request.hpp"
#include "toolmgmt/operations/offset_rules.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/operations/rectangular.hpp"
#include "toolmgmt/operations/tool_json.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {

constexpr const char* kTables[] = {"geometry", "wear", "second"};  // order of OffsetTable
constexpr std::string_view kFields = "XYZRT";                      // order of OffsetField

Key offset_key(const Work& work, std::int64_t channel, std::int64_t number, int table, int field) {
    return {Kind::Offset,
            offset_owner(work.values.parameters, work.machine, channel, number),
            static_cast<std::int32_t>(number),
            table * 256 + field,
            {}};
}

const OffsetCell& offset_cell(const Work& work, std::int64_t channel, std::int64_t number) {
    return work.values
        .channels[static_cast<std::size_t>(
            offset_owner(work.values.parameters, work.machine, channel, number) - 1)]
        .offsets[static_cast<std::size_t>(number)];
}

double zeros_of_positioning(const Work& work, std::int64_t channel, std::size_t row,
                            const AxisConfig& axis) {
    const auto& zeros = work.values.channels[static_cast<std::size_t>(channel - 1)].zeros;
    double sum = 0.0;
    for (const std::size_t common : {kZeroExternal, kZeroShift})
        if (common != row) sum += zeros[common * kChannelAxes + axis.slot];
    return sum;
}

namespace {

// N1415 and PT_WEAR_STEP; empty: the value may be entered.
std::string wear_refusal(const Work& work, const ChannelConfig& config, double now, double value) {
    // N1415: 0 stands for one millimetre, or 0.394 inch (part 1, 15.1).
    const double stated =
        params::get(work.values.parameters, params::n1415_max_amount_of_wear_comp, config.number) *
        config.length_unit_mm();
    const double most = stated > 0                      ? stated
                        : config.length_unit_mm() > 1.0 ? 0.394 * config.length_unit_mm()
                                                        : 1.0;
    if (std::abs(value) > most) return "wear is " + shortest_text(most) + " mm at the most (N1415)";
    const double step = params::get(work.values.parameters, params::pt_wear_step, config.number) *
                        config.length_unit_mm();
    if (step > 0 && std::abs(value - now) > step * (1 + 1e-9))
        return "one entry changes wear by " + shortest_text(step) +
               " mm at the most (PT_WEAR_STEP)";
    return {};
}

}  // namespace

bool enter_offset(Work& work, std::int32_t channel, std::int32_t number, int table, int field,
                  double value) {
    const Key key = offset_key(work, channel, number, table, field);
    const auto refuse = [&](Alarm alarm, const std::string& why) {
        work.fault(alarm, describe(key) + "=" + shortest_text(value) + ": " + why);
        return false;
    };
    const double* now = number_at(work.values, key);
    if (!now || channel < 1 || channel > static_cast<std::int32_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists())
        return refuse(Alarm::StoreRequestBad, "there is no such offset");
    const ChannelConfig& config = work.machine.channel(static_cast<std::size_t>(channel));
    if (number > config.offset_count)
        return refuse(Alarm::StoreRequestBad, "channel L" + std::to_string(channel) + " has " +
                                                  std::to_string(config.offset_count) + " (N1400)");
    if (table != 1 && work.caller.level < UserLevel::Setter)
        return refuse(Alarm::LevelTooLow, "geometry is the setter's");
    if (field == 4 && (value < 0 || value > 9 || value != std::trunc(value)))
        return refuse(Alarm::StoreRequestBad, "tip directions are 0 to 9");
    if (table == 1 && field != 4)
        if (const std::string why = wear_refusal(work, config, *now, value); !why.empty())
            return refuse(Alarm::StoreRequestBad, why);
    set_value(work.values, key, value + 0.0, work.changes);
    look_at_wear(work.values, static_cast<unsigned>(key.scope), number, work.changes);
    return true;
}

bool enter_edge(Work& work, std::int32_t channel, std::int32_t tool, std::int32_t edge, int dp,
                double value) {
    const Key key{Kind::Edge, tool, edge, dp, {}};
    const auto refuse = [&](Alarm alarm, const std::string& why) {
        work.fault(alarm, describe(key) + "=" + shortest_text(value) + ": " + why);
        return false;
    };
    const ToolRow* row = work.values.tool(tool);
    if (!row || !row->used) {
        work.fault(Alarm::ToolMissing, std::to_string(tool));
        return false;
    }
    if (channel < 1 || channel > static_cast<std::int32_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists())
        return refuse(Alarm::StoreRequestBad,
                      "channel L" + std::to_string(channel) + " does not exist");
    if (!is_edge_wear(dp) && work.caller.level < UserLevel::Setter)
        return refuse(Alarm::LevelTooLow, "geometry is the setter's");
    const ToolEdge* found = find_edge(work.values, tool, edge);
    if (dp >= kDpWear && dp <= kDpWearRadius)
        if (const std::string why =
                wear_refusal(work, work.machine.channel(static_cast<std::size_t>(channel)),
                             found ? found->dp[static_cast<std::size_t>(dp)] : 0.0, value);
            !why.empty())
            return refuse(Alarm::StoreRequestBad, why);
    if (!set_field(work, tool, "D" + std::to_string(edge) + ".DP" + std::to_string(dp),
                   shortest_text(value + 0.0), 0))
        return false;
    if (is_edge_wear(dp)) check_edge_wear(work.values, tool, work.changes);
    return true;
}

int edge_parameter(const Work& work, std::int32_t channel, std::int32_t tool, std::int32_t edge,
                   int table, int field, unsigned plane) {
    constexpr int kRadius[] = {kDpRadius, kDpWearRadius, kDpBaseRadius},
                  kLength[] = {kDpLength, kDpWear, kDpBase};
    if (field == 4) return kDpTip;
    if (field == 3) return kRadius[table];
    const ToolEdge* found = find_edge(work.values, tool, edge);
    const int length =
        length_along(axes_of_edge(work.values.parameters, static_cast<unsigned>(channel),
                                  found ? static_cast<int>(found->dp[kDpType]) : 0, plane),
                     field);
    return length < 0 ? -1 : kLength[table] + length;
}

double share_in_offsets(const AxisConfig& axis) {
    return axis.diameter && !axis.offset_diameter ? 0.5 : 1.0;
}
double share_in_edges(const AxisConfig& axis) { return axis.diameter ? 0.5 : 1.0; }

namespace {

// A value of the offset table, or of a tool's edge where `tool` is not 0.
struct Target {
    std::int64_t channel = 1, number = 0;
    int table = 0, field = 0;
    std::int32_t tool = 0, edge = 0;
    int dp = 0;
    bool of_edge() const { return tool != 0; }
};

// «"tool": 5, "edge": 1»: false when the request is about the offset table, or wrong.
bool read_edge(const Json& request, Work& work, Target& out) {
    std::int64_t tool = 0, edge = 1;
    if (!request.contains("tool") || !read_whole(request, "tool", tool, work)) return false;
    read_whole(request, "edge", edge, work, false);
    const ToolRow* row = work.values.tool(tool);
    if (!row || !row->used) {
        work.fault(Alarm::ToolMissing, std::to_string(tool));
        return false;
    }
    if (edge < 1 || edge > kMostEdgesOfTool) {
        work.fault(Alarm::StoreRequestBad, "edges are D1 to D" + std::to_string(kMostEdgesOfTool),
                   0, "edge");
        return false;
    }
    out.tool = static_cast<std::int32_t>(tool);
    out.edge = static_cast<std::int32_t>(edge);
    return true;
}

// Which parameter of the edge table and field mean, in the plane that the request says (17, 18, 19;
// 18 where it says none).
bool find_parameter(const Json& request, Work& work, Target& target) {
    std::int64_t plane = 18;
    read_whole(request, "plane", plane, work, false);
    if (plane < 17 || plane > 19) {
        work.fault(Alarm::StoreRequestBad, "planes are 17, 18 and 19", 0, "plane");
        return false;
    }
    target.dp =
        edge_parameter(work, static_cast<std::int32_t>(target.channel), target.tool, target.edge,
                       target.table, target.field, static_cast<unsigned>(plane - 17));
    if (target.dp < 0) {
        work.fault(Alarm::StoreRequestBad,
                   "tool " + std::to_string(target.tool) + " D" + std::to_string(target.edge) +
                       " has no length along " + kFields[static_cast<std::size_t>(target.field)] +
                       " in G" + std::to_string(plane),
                   0, "field");
        return false;
    }
    return work.good();
}

Key key_of(const Work& work, const Target& target) {
    if (target.of_edge()) return {Kind::Edge, target.tool, target.edge, target.dp, {}};
    return offset_key(work, target.channel, target.number, target.table, target.field);
}

double value_now(const Work& work, const Target& target) {
    if (target.of_edge()) {
        const ToolEdge* found = find_edge(work.values, target.tool, target.edge);
        return found && target.dp > 0 && target.dp < 36
                   ? found->dp[static_cast<std::size_t>(target.dp)]
                   : 0.0;
    }
    const double* now = number_at(work.values, key_of(work, target));
    return now ? *now : 0.0;
}

// What else the sum has along that axis (X, Y, Z) that acts: geometry and wear of an offset; of an
// edge its base too.
double beside(const Work& work, const Target& target) {
    if (target.of_edge()) {
        const ToolEdge* found = find_edge(work.values, target.tool, target.edge);
        if (!found) return 0.0;
        const std::size_t length =
            static_cast<std::size_t>(target.dp - (target.table == 0   ? kDpLength
                                                  : target.table == 1 ? kDpWear
                                                                      : kDpBase));
        return found->dp[kDpLength + length] + found->dp[kDpWear + length] +
               found->dp[kDpBase + length] - found->dp[static_cast<std::size_t>(target.dp)];
    }
    if (!number_at(work.values, key_of(work, target))) return 0.0;
    const OffsetCell& cell = offset_cell(work, target.channel, target.number);
    const auto field = static_cast<std::size_t>(target.field);
    return target.table == 0 ? cell.wear[field] : target.table == 1 ? cell.geometry[field] : 0.0;
}

double share(const Target& target, const AxisConfig& axis) {
    return target.of_edge() ? share_in_edges(axis) : share_in_offsets(axis);
}

bool enter(Work& work, const Target& target, double value) {
    if (target.of_edge())
        return enter_edge(work, static_cast<std::int32_t>(target.channel), target.tool, target.edge,
                          target.dp, value);
    return enter_offset(work, static_cast<std::int32_t>(target.channel),
                        key_of(work, target).number, target.table, target.field, value);
}

bool read_target(const Json& request, Work& work, Target& out) {
    read_whole(request, "channel", out.channel, work, false);
    if (!read_edge(request, work, out)) {
        if (!work.good() || !read_whole(request, "number", out.number, work)) return false;
    } else if (std::int64_t dp = 0; read_whole(request, "dp", dp, work, false)) {
        out.dp = static_cast<int>(dp);
        return work.good();
    }
    const std::string table = request.contains("table") ? read_text(request, "table") : "geometry",
                      field = read_text(request, "field");
    const auto at = std::find(std::begin(kTables), std::end(kTables), table);
    const auto which = field.size() == 1 ? kFields.find(field[0]) : std::string_view::npos;
    if (at == std::end(kTables)) {
        work.fault(Alarm::StoreRequestBad, "table " + table + ": geometry, wear or second", 0,
                   "table");
        return false;
    }
    if (which == std::string_view::npos) {
        work.fault(Alarm::StoreRequestBad, "field " + field + ": X Y Z R or T", 0, "field");
        return false;
    }
    out.table = static_cast<int>(at - std::begin(kTables));
    out.field = static_cast<int>(which);
    return work.good() && (!out.of_edge() || find_parameter(request, work, out));
}

// The axis' position, as it is displayed.
bool position_now(Work& work, std::int64_t channel, int field, double& out,
                  const AxisConfig*& axis) {
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) || field > 2) {
        work.fault(Alarm::StoreRequestBad, "measuring needs a channel and X, Y or Z");
        return false;
    }
    axis = find_axis(work.machine, static_cast<unsigned>(channel),
                     kFields.substr(static_cast<std::size_t>(field), 1));
    if (!axis) {
        work.fault(Alarm::StoreRequestBad, "channel L" + std::to_string(channel) + " has no axis " +
                                               kFields[static_cast<std::size_t>(field)]);
        return false;
    }
    const auto position = rectangular_position(work, static_cast<unsigned>(channel), *axis);
    if (!position) {
        work.fault(Alarm::StoreRequestBad, "the kernel does not say where the axis stands");
        return false;
    }
    out = *position * (axis->diameter ? 2.0 : 1.0);
    return true;
}

Json set(const Json& request, Work& work) {
    Target target;
    double value = 0;
    if (!read_target(request, work, target)) return {};
    const double before = value_now(work, target);
    if (!read_entry(request, before, describe(key_of(work, target)), value, work)) return {};
    enter(work, target, value);
    return {{"what", describe(key_of(work, target))}, {"old", before}, {"new", value}};
}

// The tip is where the workpiece measures `value` (diameter on a diameter axis): machine = zero
// + value + offset.
Json measure(const Json& request, Work& work) {
    Target target;
    double value = 0, position = 0;
    const AxisConfig* axis = nullptr;
    if (!read_target(request, work, target) || !read_real(request, "value", value, work) ||
        !position_now(work, target.channel, target.field, position, axis))
        return {};
    double zero = 0;
    // where the program has put it: what acts now is more than the table
    if (request.contains("zero_at")) {
        if (!read_real(request, "zero_at", zero, work)) return {};
    } else {
        const std::string system = request.contains("zero") ? read_text(request, "zero") : "G54";
        const auto row = work_zero_row(system);
        if (!row) {
            work.fault(Alarm::StoreRequestBad, "there is no zero offset " + system, 0, "zero");
            return Json();
        }
        const auto& zeros =
            work.values.channels[static_cast<std::size_t>(target.channel - 1)].zeros;
        zero = zeros[*row * kChannelAxes + axis->slot] +
               zeros_of_positioning(work, target.channel, *row, *axis);
    }
    const double before = value_now(work, target);
    // Wear stays what it is: what is measured is the sum of both.
    const double fresh = (position - zero - value) * share(target, *axis) -
                         (target.table != 1 ? beside(work, target) : 0.0);
    enter(work, target, std::round(fresh * 1e6) / 1e6);
    return {{"what", describe(key_of(work, target))},
            {"machine", position},
            {"zero", zero},
            {"old", before},
            {"new", std::round(fresh * 1e6) / 1e6},
            {"difference", std::round((fresh - before) * 1e6) / 1e6}};
}

// N0205 to N0216: where the setter switches, by spindle, axis and direction of travel; as the table
// shows it, in mm.
double contact_position(const Work& work, unsigned channel, const Touch& touch, int field) {
    char name[8];
    std::snprintf(name, sizeof name, "N%04d",
                  205 + (touch.setter == 2 ? 6 : 0) + 2 * field + (touch.negative ? 0 : 1));
    const params::Row* row = params::find(name);
    return row ? work.values.parameters.numbers[row->first_slot + (channel - 1) * row->array] *
                     work.machine.channel(channel).length_unit_mm()
               : 0.0;
}

// The tool has touched the setter: its tip was at the contact position, so the offset is how far
// the machine stood from there.
Json touched(const Json& request, Work& work) {
    std::int64_t channel = 1, number = 0;
    read_whole(request, "channel", channel, work, false);
    const std::string table = request.contains("table") ? read_text(request, "table") : "geometry";
    if (table != "geometry" && table != "wear") {
        work.fault(Alarm::StoreRequestBad, "table " + table + ": geometry or wear", 0, "table");
        return Json();
    }
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " does not exist");
        return Json();
    }
    const auto l = static_cast<unsigned>(channel);
    const params::Table& t = work.values.parameters;
    const auto touch = work.touch ? work.touch(l) : std::nullopt;
    if (!touch) {
        work.fault(Alarm::StoreRequestBad, "the kernel does not say where the tool has touched");
        return Json();
    }
    if (params::get(t, params::n3012_sensor_input_of_tool_setter_s1, l) == 0 &&
        params::get(t, params::n3013_sensor_input_of_tool_setter_s2, l) == 0) {
        work.fault(Alarm::SetterUnset, "channel L" + std::to_string(channel));
        return Json();
    }
    if (touch->axis == 0 || touch->axis > kMaxAxes || touch->workpiece()) {
        work.fault(Alarm::SetterNoTouch, "channel L" + std::to_string(channel));
        return Json();
    }
    const AxisConfig& axis = work.machine.axis(touch->axis);
    const auto field = axis.role == PlaneRole::BasicX   ? std::size_t{0}
                       : axis.role == PlaneRole::BasicY ? std::size_t{1}
                                                        : std::size_t{2};
    if (axis.role != PlaneRole::BasicX && axis.role != PlaneRole::BasicY &&
        axis.role != PlaneRole::BasicZ) {
        work.fault(Alarm::SetterNoTouch, "axis " + std::string(axis.name_text()));
        return Json();
    }
    // N3016 ONS: the PLC says which offset is measured; of a tool with edges, which D.
    const bool by_plc = params::bit(t, params::n3016_tool_wp_setter_config, l, 0);
    Target target;
    target.channel = channel;
    target.table = table == "wear" ? 1 : 0;
    target.field = static_cast<int>(field);
    const bool of_edge = read_edge(request, work, target),
               named = request.contains(of_edge ? "edge" : "number");
    if (!work.good()) return {};
    if (of_edge)
        number = target.edge;
    else if (named && !read_whole(request, "number", number, work))
        return {};
    if (by_plc) {
        if (named && number != touch->plc_offset) {
            work.fault(Alarm::StoreRequestBad,
                       "the PLC has chosen offset " + std::to_string(touch->plc_offset) +
                           " (N3016 ONS, CP_OFFSNO)",
                       0, "number");
            return Json();
        }
        number = touch->plc_offset;
    } else if (!named) {
        work.fault(Alarm::StoreRequestBad, "number is missing", 0, "number");
        return Json();
    }
    target.number = number;
    if (of_edge) {
        if (number < 1 || number > kMostEdgesOfTool) {
            work.fault(Alarm::StoreRequestBad,
                       "edges are D1 to D" + std::to_string(kMostEdgesOfTool), 0, "edge");
            return Json();
        }
        target.edge = static_cast<std::int32_t>(number);
        if (!find_parameter(request, work, target)) return {};
    }
    const double before = value_now(work, target);
    const double machine = rectangular_touch(work, l, axis, *touch) * (axis.diameter ? 2.0 : 1.0),
                 contact = contact_position(work, l, *touch, static_cast<int>(field));
    const double fresh =
        std::round(((machine - contact) * share(target, axis) - beside(work, target)) * 1e6) / 1e6;
    enter(work, target, fresh);
    return {{"what", describe(key_of(work, target))},
            {"machine", machine},
            {"contact", contact},
            {"setter", touch->spindle()},
            {"old", before},
            {"new", fresh},
            {"difference", std::round((fresh - before) * 1e6) / 1e6}};
}

// What a presetter has measured (X as a radius): geometry, nose radius and tip number of one offset
// or edge.
Json preset(const Json& request, Work& work) {
    Target target;
    read_whole(request, "channel", target.channel, work, false);
    const bool of_edge = read_edge(request, work, target);
    if (!work.good() || (!of_edge && !read_whole(request, "number", target.number, work)))
        return {};
    const std::int64_t channel = target.channel;
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " does not exist");
        return Json();
    }
    Json rows = Json::array();
    for (int field = 0; field < 5; ++field) {
        const std::string name(1, kFields[static_cast<std::size_t>(field)]);
        double value = 0;
        if (!request.contains(name)) continue;
        if (!read_real(request, name.c_str(), value, work)) return {};
        if (field < 3) {
            const AxisConfig* axis = find_axis(work.machine, static_cast<std::size_t>(channel),
                                               field == 0   ? PlaneRole::BasicX
                                               : field == 1 ? PlaneRole::BasicY
                                                            : PlaneRole::BasicZ);
            if (!axis) {
                work.fault(Alarm::StoreRequestBad,
                           "channel L" + std::to_string(channel) + " has no axis " + name, 0, name);
                continue;
            }
            if (axis->offset_diameter && !of_edge) value *= 2;
            value = std::round(value * 1e4) / 1e4;
        }
        target.field = field;
        if (of_edge && !find_parameter(request, work, target)) continue;
        const double before = value_now(work, target);
        if (!enter(work, target, value)) continue;
        rows.push_back({{"what", describe(key_of(work, target))},
                        {"old", before},
                        {"new", value},
                        {"difference", std::round((value - before) * 1e6) / 1e6}});
    }
    return {{"entries", std::move(rows)}};
}

// The relative counter begins to count here.
Json origin(const Json& request, Work& work) {
    std::int64_t channel = 1;
    read_whole(request, "channel", channel, work, false);
    Json out = Json::object();
    for (int field = 0; field < 3; ++field) {
        if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
            !find_axis(work.machine, static_cast<unsigned>(channel),
                       kFields.substr(static_cast<std::size_t>(field), 1)))
            continue;
        double position = 0;
        const AxisConfig* axis = nullptr;
        if (!position_now(work, channel, field, position, axis)) return {};
        set_value(work.values,
                  {Kind::Setting, static_cast<std::int32_t>(channel), field, 0, "relative origin"},
                  position, work.changes);
        out[std::string(1, kFields[static_cast<std::size_t>(field)])] = position;
    }
    return {{"origin", std::move(out)}};
}

Json relative(const Json& request, Work& work) {
    Target target;
    double position = 0;
    const AxisConfig* axis = nullptr;
    if (!read_target(request, work, target) ||
        !position_now(work, target.channel, target.field, position, axis))
        return {};
    const Cell* from = work.values.cell({Kind::Setting, static_cast<std::int32_t>(target.channel),
                                         target.field, 0, "relative origin"});
    if (!from) {
        work.fault(Alarm::StoreRequestBad,
                   "the relative counter has no origin yet: offsets origin");
        return Json();
    }
    const double value = std::round((position - from->number) * share(target, *axis) * 1e6) / 1e6,
                 before = value_now(work, target);
    enter(work, target, value);
    return {{"what", describe(key_of(work, target))},
            {"old", before},
            {"new", value},
            {"machine", position},
            {"origin", from->number}};
}

Json list(const Json& request, Work& work) {
    std::int64_t channel = 1;
    read_whole(request, "channel", channel, work, false);
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " does not exist");
        return Json();
    }
    Json out = Json::array();
    for (int n = 1; n <= work.machine.channel(static_cast<std::size_t>(channel)).offset_count;
         ++n) {
        const OffsetCell& cell = offset_cell(work, channel, n);
        out.push_back(
            {{"number", n},
             {"geometry",
              {{"X", cell.geometry[0]},
               {"Y", cell.geometry[1]},
               {"Z", cell.geometry[2]},
               {"R", cell.geometry_r},
               {"T", cell.tip}}},
             {"wear",
              {{"X", cell.wear[0]}, {"Y", cell.wear[1]}, {"Z", cell.wear[2]}, {"R", cell.wear_r}}},
             {"second", {{"X", cell.second[0]}, {"Y", cell.second[1]}, {"Z", cell.second[2]}}}});
    }
    return {{"channel", channel}, {"offsets", std::move(out)}};
}

// "L1 offset 3 wear X" back to its key.
bool key_of(const std::string& what, Key& key) {
    int channel = 0, number = 0, used = 0;
    if (std::sscanf(what.c_str(), "L%d offset %d %n", &channel, &number, &used) != 2 || used == 0)
        return false;
    const std::string rest = what.substr(static_cast<std::size_t>(used));
    // as describe() writes them
    static constexpr const char* kNames[] = {"geometry ", "wear ", "second geometry "};
    for (int table = 0; table < 3; ++table) {
        const std::string_view name = kNames[table];
        if (rest.rfind(name, 0) != 0 || rest.size() != name.size() + 1) continue;
        const auto field = kFields.find(rest.back());
        if (field == std::string_view::npos) return false;
        key = {Kind::Offset, channel, number, table * 256 + static_cast<int>(field), {}};
        return true;
    }
    return false;
}

// "tool 41 D1 DP3" likewise.
bool edge_of(const std::string& what, Key& key) {
    int tool = 0, edge = 0, dp = 0, used = 0;
    if (std::sscanf(what.c_str(), "tool %d D%d DP%d%n", &tool, &edge, &dp, &used) != 3 ||
        static_cast<std::size_t>(used) != what.size())
        return false;
    key = {Kind::Edge, tool, edge, dp, {}};
    return true;
}

// The newest entry that was made and not taken back: of the channel's offsets, or
// of the tool («tool», «edge») that is named.
Json undo(const Json& request, Work& work) {
    if (!work.disk) {
        work.fault(Alarm::StoreRequestBad, "this controller keeps no history");
        return Json();
    }
    std::int64_t channel = 0, tool = 0, edge = 0;
    read_whole(request, "channel", channel, work, false);
    const bool of_edges = request.contains("tool");
    if (of_edges && !read_whole(request, "tool", tool, work)) return {};
    read_whole(request, "edge", edge, work, false);
    if (!work.good()) return {};
    const std::string about = of_edges ? "tool " + std::to_string(tool) +
                                             (edge > 0 ? " D" + std::to_string(edge) + " " : " ")
                              : channel ? "L" + std::to_string(channel) + " offset"
                                        : "";
    const auto entries = work.disk->history({of_edges ? Database::HistoryOf::Kind::EnteredEdges
                                                      : Database::HistoryOf::Kind::EnteredOffsets,
                                             about,
                                             {},
                                             {},
                                             0,
                                             2000});
    if (!entries) {
        work.fault(entries.diagnosis());
        return Json();
    }
    int undone = 0;  // what was taken back already, newest first
    for (const auto& entry : entries->entries) {
        Key key;
        if (entry.who == "program" || entry.who == "setup" ||
            !(of_edges ? edge_of(entry.what, key) : key_of(entry.what, key)))
            continue;
        if (entry.who.size() > 5 && entry.who.ends_with(" undo")) {
            ++undone;
            continue;
        }
        if (undone > 0) {
            --undone;
            continue;
        }
        const ToolEdge* const held =
            of_edges ? find_edge(work.values, key.scope, key.number) : nullptr;
        const double none = 0.0;  // of an edge without a value
        const double* now = of_edges
                                ? (held ? &held->dp[static_cast<std::size_t>(key.field)] : &none)
                                : number_at(work.values, key);
        const double before = std::strtod(entry.before.c_str(), nullptr),
                     after = std::strtod(entry.after.c_str(), nullptr);
        if (!now || *now != after) {
            work.fault(Alarm::StoreRequestBad,
                       entry.what + " is " + (now ? shortest_text(*now) : "") +
                           " now: something else has changed it since " + entry.utc);
            return Json();
        }
        work.caller.name += " undo";
        if (of_edges)
            enter_edge(work, static_cast<std::int32_t>(channel ? channel : 1), key.scope,
                       key.number, key.field, before);
        else
            enter_offset(work, key.scope, key.number, key.field / 256, key.field % 256, before);
        return {{"what", entry.what},
                {"old", after},
                {"new", before},
                {"entered", entry.utc},
                {"who", entry.who}};
    }
    work.fault(Alarm::StoreRequestBad, "there is nothing to take back");
    return Json();
}

// Of a value by its whole name ("of"), of all parameters ("kind"), or of what contains a text;
// "before_utc", "before_id": what is older than that row. "more" in the answer: it has looked until
// there, and what is older is to be asked for.
Json history(const Json& request, Work& work, const std::string& about) {
    if (!work.disk) {
        work.fault(Alarm::StoreRequestBad, "this controller keeps no history");
        return Json();
    }
    Database::HistoryOf wanted{Database::HistoryOf::Kind::All, about, read_text(request, "who"),
                               read_text(request, "before_utc")};
    if (request.contains("of")) {
        wanted.kind = Database::HistoryOf::Kind::Value;
        wanted.about = read_text(request, "of");
    } else if (read_text(request, "kind") == "parameters")
        wanted.kind = Database::HistoryOf::Kind::Parameters;
    read_whole(request, "before_id", wanted.before_id, work, false);
    read_whole(request, "most", wanted.most, work, false);
    wanted.most = std::clamp<std::int64_t>(wanted.most, 1, 100'000);
    const auto found = work.disk->history(wanted);
    if (!found) {
        work.fault(found.diagnosis());
        return Json();
    }
    Json out = {{"history", Json::array()}};
    for (const auto& entry : found->entries)
        out["history"].push_back({{"id", entry.id},
                                  {"utc", entry.utc},
                                  {"who", entry.who},
                                  {"what", entry.what},
                                  {"old", entry.before},
                                  {"new", entry.after}});
    if (found->more) out["more"] = {{"utc", found->more->first}, {"id", found->more->second}};
    return out;
}

}  // namespace

Json offset_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "list" && read_text(request, "do") == "history.list")
        return history(request, work, read_text(request, "about"));
    if (what == "list") return list(request, work);
    if (what == "set") return set(request, work);
    if (what == "measure") return measure(request, work);
    if (what == "touch") return touched(request, work);
    if (what == "preset") return preset(request, work);
    if (what == "origin") return origin(request, work);
    if (what == "relative") return relative(request, work);
    if (what == "undo") return undo(request, work);
    if (what == "history") return history(request, work, " offset ");
    work.fault(Alarm::StoreRequestBad, "offsets." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
