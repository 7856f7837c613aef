// Zero offsets as a setter enters them: typed in, from a surface that the tool touches, from the
// workpiece setter (N3014, N3015).
//
//   machine = zero + external + shift + offset + value
//   zero    = machine - offset - value - external - shift       (X as the table shows it)
//
// The offset is that of the tool or probe that is there: its geometry and wear. A probe whose
// lengths lead to the middle of its ball (tip 0 or 9) touches with the ball's side: its nose radius
// counts towards where it travelled.
#include <cmath>
#include <nlohmann/json.hpp>

#include "ipc/image/segments.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/operations/offset_rules.hpp"
#include "toolmgmt/operations/rectangular.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::string_view kAxes = "XYZ";

bool read_channel(const Json& request, Work& work, unsigned& out) {
    std::int64_t channel = 1;
    read_whole(request, "channel", channel, work, false);
    if (!work.good()) return false;
    if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
        !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " does not exist", 0, "channel");
        return false;
    }
    out = static_cast<unsigned>(channel);
    return true;
}

bool read_system(const Json& request, Work& work, std::size_t& row) {
    const std::string name = request.contains("zero") ? read_text(request, "zero") : "G54";
    const auto found = work_zero_row(name);
    if (!found) {
        work.fault(Alarm::StoreRequestBad, "there is no zero offset " + name, 0, "zero");
        return false;
    }
    row = *found;
    return true;
}

const AxisConfig* read_axis(const Json& request, Work& work, unsigned channel) {
    const std::string field = read_text(request, "field");
    const AxisConfig* axis = find_axis(work.machine, channel, field);
    if (!axis)
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " has no axis " + field, 0, "field");
    return axis;
}

// Writes one value and tells it; `value` as the table shows it.
Json enter(Work& work, unsigned channel, std::size_t row, const AxisConfig& axis, double value,
           Json more = Json::object(), double parts = 1e6) {
    const Key key{Kind::WorkZero,
                  static_cast<std::int32_t>(channel),
                  static_cast<std::int32_t>(row),
                  axis.slot,
                  {}};
    const double* now = number_at(work.values, key);
    if (!now) {
        work.fault(Alarm::StoreRequestBad, "there is no such zero offset");
        return Json();
    }
    const double before = *now, fresh = std::round(value * parts) / parts + 0.0;
    constexpr double kMost = 1e5;  // mm: no slide is so long
    if (!(std::fabs(fresh) <= kMost)) {
        work.fault(Alarm::StoreRequestBad, "a zero offset of " + std::to_string(fresh) + " mm");
        return Json();
    }
    set_value(work.values, key, fresh, work.changes);
    more.update({{"what", "L" + std::to_string(channel) + " " + work_zero_name(row) + " " +
                              std::string(axis.name_text())},
                 {"old", before},
                 {"new", fresh},
                 {"difference", rounded(fresh - before)}});
    return more;
}

Json list_zeros(const Json& request, Work& work) {
    unsigned channel = 1;
    if (!read_channel(request, work, channel)) return {};
    const ChannelConfig& config = work.machine.channel(channel);
    const auto& zeros = work.values.channels[channel - 1].zeros;
    Json out = Json::array();
    for (std::size_t row = 0; row < kWorkZeros; ++row) {
        const std::string name = work_zero_name(row);
        Json one = {{"zero", name}};
        // external, G54 to G59, shift: always; the others where they hold something
        bool any = row <= 7;
        for (std::size_t i = 0; i < config.axis_count; ++i) {
            const AxisConfig& axis = work.machine.axis(config.axes[i]);
            const double value = zeros[row * kChannelAxes + axis.slot];
            one[std::string(axis.name_text())] = value;
            any = any || value != 0;
        }
        if (any && !name.empty()) out.push_back(std::move(one));
    }
    return {{"channel", channel}, {"zeros", std::move(out)}};
}

Json set(const Json& request, Work& work) {
    unsigned channel = 1;
    std::size_t row = 0;
    double value = 0;
    if (!read_channel(request, work, channel) || !read_system(request, work, row)) return {};
    const AxisConfig* axis = read_axis(request, work, channel);
    if (!axis ||
        !read_entry(request,
                    work.values.channels[channel - 1].zeros[row * kChannelAxes + axis->slot],
                    "L" + std::to_string(channel) + " " + work_zero_name(row) + " " +
                        std::string(axis->name_text()),
                    value, work))
        return {};
    return enter(work, channel, row, *axis, value, Json::object(), 1e9);
}

// What stands at the tool's tip is to be `value` (0 where nothing is said). «length»: what the tool
// takes from the axis just now, also one that a program before has left; as positions are
// displayed.
Json here(const Json& request, Work& work) {
    unsigned channel = 1;
    std::size_t row = 0;
    double value = 0, length = 0;
    if (!read_channel(request, work, channel) || !read_system(request, work, row)) return {};
    const AxisConfig* axis = read_axis(request, work, channel);
    if (!axis) return {};
    read_real(request, "value", value, work, false);
    read_real(request, "length", length, work, false);
    if (!work.good()) return {};
    const auto position = rectangular_position(work, channel, *axis);
    if (!position) {
        work.fault(Alarm::StoreRequestBad, "the kernel does not say where the axis stands");
        return Json();
    }
    const double machine = *position * (axis->diameter ? 2.0 : 1.0);
    return enter(work, channel, row, *axis,
                 machine - length - value - zeros_of_positioning(work, channel, row, *axis),
                 {{"machine", machine}, {"length", length}});
}

// What the tool of this offset takes from the axis, as positions are displayed; 0 for no offset.
bool offset_of(Work& work, unsigned channel, std::int64_t number, const AxisConfig& axis,
               std::size_t field, double& out, const OffsetCell** cell) {
    out = 0;
    *cell = nullptr;
    if (number == 0) return true;
    if (number < 0 || number > work.machine.channel(channel).offset_count) {
        work.fault(Alarm::StoreRequestBad,
                   "channel L" + std::to_string(channel) + " has " +
                       std::to_string(work.machine.channel(channel).offset_count) +
                       " offsets (N1400)",
                   0, "offset");
        return false;
    }
    const OffsetCell& found = offset_cell(work, channel, number);
    // F5004 #1
    out = (found.geometry[field] + found.wear[field]) *
          (axis.diameter && !axis.offset_diameter ? 2.0 : 1.0);
    *cell = &found;
    return true;
}

// The tip stands at a surface that is to be `value`.
Json measure(const Json& request, Work& work) {
    unsigned channel = 1;
    std::size_t row = 0;
    double value = 0, length = 0;
    std::int64_t number = 0;
    if (!read_channel(request, work, channel) || !read_system(request, work, row)) return {};
    const AxisConfig* axis = read_axis(request, work, channel);
    if (!axis || !read_real(request, "value", value, work)) return {};
    read_whole(request, "offset", number, work, false);
    if (!work.good()) return {};
    const auto field = kAxes.find(axis->role == PlaneRole::BasicX   ? 'X'
                                  : axis->role == PlaneRole::BasicY ? 'Y'
                                                                    : 'Z');
    const OffsetCell* cell = nullptr;
    const bool linear = axis->role == PlaneRole::BasicX || axis->role == PlaneRole::BasicY ||
                        axis->role == PlaneRole::BasicZ;
    if (linear && !offset_of(work, channel, number, *axis, field, length, &cell)) return {};
    const auto position = rectangular_position(work, channel, *axis);
    if (!position) {
        work.fault(Alarm::StoreRequestBad, "the kernel does not say where the axis stands");
        return Json();
    }
    const double machine = *position * (axis->diameter ? 2.0 : 1.0);
    return enter(work, channel, row, *axis,
                 machine - length - value - zeros_of_positioning(work, channel, row, *axis),
                 {{"machine", machine}, {"offset", number}});
}

// The workpiece setter has answered: the surface that it touched is to be `value` (0 where nothing
// is said).
Json touch(const Json& request, Work& work) {
    unsigned channel = 1;
    if (!read_channel(request, work, channel)) return {};
    const std::string here = "channel L" + std::to_string(channel);
    const params::Table& t = work.values.parameters;
    const auto touch = work.touch ? work.touch(channel) : std::nullopt;
    if (!touch) {
        work.fault(Alarm::StoreRequestBad,
                   "the kernel does not say where the workpiece was touched");
        return Json();
    }
    if (params::get(t, params::n3014_sensor_input_of_workpiece_setter_s1, channel) == 0 &&
        params::get(t, params::n3015_sensor_input_of_workpiece_setter_s2, channel) == 0) {
        work.fault(Alarm::SetterUnset, here + ", workpiece");
        return Json();
    }
    if (touch->axis == 0 || touch->axis > kMaxAxes || !touch->workpiece()) {
        work.fault(Alarm::SetterNoTouch, here + ", workpiece");
        return Json();
    }
    const AxisConfig& axis = work.machine.axis(touch->axis);
    if (axis.role != PlaneRole::BasicX && axis.role != PlaneRole::BasicY &&
        axis.role != PlaneRole::BasicZ) {
        work.fault(Alarm::SetterNoTouch, here + ", axis " + std::string(axis.name_text()));
        return Json();
    }
    const std::size_t field = axis.role == PlaneRole::BasicX   ? 0
                              : axis.role == PlaneRole::BasicY ? 1
                                                               : 2;
    // N3016 WPS: the system is N3017's or N3018's, by the spindle; else the operator says it.
    std::size_t row = 0;
    if (params::bit(t, params::n3016_tool_wp_setter_config, channel, 1)) {
        const auto code = touch->spindle() == 2
                              ? params::get(t, params::n3018_coordinate_system_no_of_s2, channel)
                              : params::get(t, params::n3017_coordinate_system_no_of_s1, channel);
        const auto chosen = work_zero_row("G" + std::to_string(code));
        if (!chosen) {
            work.fault(Alarm::SetterUnset, here + ", workpiece");
            return Json();
        }
        row = *chosen;
        std::size_t named = 0;
        if (request.contains("zero") && (!read_system(request, work, named) || named != row))
            return work.good()
                       ? (work.fault(Alarm::StoreRequestBad,
                                     "G" + std::to_string(code) + " is measured here (N3016 WPS)",
                                     0, "zero"),
                          Json())
                       : Json();
    } else if (!read_system(request, work, row)) {
        return {};
    }
    // N3016 ONS: the PLC says whose length counts.
    std::int64_t number = 0;
    const bool named = request.contains("offset");
    if (named && !read_whole(request, "offset", number, work)) return {};
    if (params::bit(t, params::n3016_tool_wp_setter_config, channel, 0)) {
        if (named && number != touch->plc_offset) {
            work.fault(Alarm::StoreRequestBad,
                       "the PLC has chosen offset " + std::to_string(touch->plc_offset) +
                           " (N3016 ONS, CP_OFFSNO)",
                       0, "offset");
            return Json();
        }
        number = touch->plc_offset;
    } else if (!named) {
        work.fault(Alarm::StoreRequestBad,
                   "offset is missing: the number of the probe's offset, 0 for none", 0, "offset");
        return Json();
    }
    double value = 0, length = 0;
    if (request.contains("field") &&
        find_axis(work.machine, channel, read_text(request, "field")) != &axis) {
        work.fault(Alarm::StoreRequestBad,
                   "the workpiece was touched in " + std::string(axis.name_text()), 0, "field");
        return Json();
    }
    read_real(request, "value", value, work, false);
    const OffsetCell* cell = nullptr;
    if (!work.good() || !offset_of(work, channel, number, axis, field, length, &cell)) return {};
    const double unit = axis.diameter ? 2.0 : 1.0,
                 machine = rectangular_touch(work, channel, axis, *touch) * unit;
    const bool to_middle = cell && (cell->tip == 0 || cell->tip == 9);
    const double side =
        to_middle ? (touch->negative ? -1.0 : 1.0) * (cell->geometry_r + cell->wear_r) * unit : 0.0;
    return enter(work, channel, row, axis,
                 machine + side - length - value - zeros_of_positioning(work, channel, row, axis),
                 {{"machine", machine},
                  {"surface", value},
                  {"offset", number},
                  {"setter", touch->spindle()}});
}

}  // namespace

Json zero_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "list") return list_zeros(request, work);
    if (what == "set") return set(request, work);
    if (what == "measure") return measure(request, work);
    if (what == "here") return here(request, work);
    if (what == "touch") return touch(request, work);
    work.fault(Alarm::StoreRequestBad, "zeros." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
