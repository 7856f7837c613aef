#include "channels/fagor/flow/carry.hpp"

#include <memory>
#include <string>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/frames/inclined.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/frames/zeros.hpp"
#include "channels/fagor/tools/tool_words.hpp"

namespace polyturn::channels::fagor {
namespace {

struct Left {
    Values values;
    Modal modal;
    PathState path;
    TravelCounter ways;
    std::string program;
    InclinedAxes inclined;
};

}  // namespace

std::any carry(const Execution& x) {
    return std::make_shared<Left>(Left{
        x.values, x.modal, x.core.path, x.out.ways,
        x.calls.empty() ? std::string() : x.programs.files.path(x.calls.main().file), x.inclined});
}

void take_carry(Execution& x, const std::any& before) {
    const auto* held = std::any_cast<std::shared_ptr<Left>>(&before);
    if (!held || !*held) return;
    const Left& last = **held;
    x.values.take_tables(last.values);
    x.out.ways.take_ways(last.ways);
    x.facts.first_run = last.program != x.programs.files.path(x.calls.main().file);
    const Modal& m = last.modal;
    x.modal.written = m.written;
    x.modal.parts = m.parts;
    x.modal.speed_limit = m.speed_limit;
    x.modal.gear = m.gear;
    x.modal.probe_input = m.probe_input;
    x.modal.next_tool = m.next_tool;
    x.modal.next_offset = m.next_offset;
    x.modal.zero = m.zero;
    x.modal.zero_number = m.zero_number;
    x.modal.zero_added = m.zero_added;
    PathState& path = x.core.path;
    path.zones = last.path.zones;
    path.second_limits = last.path.second_limits;
    path.spindle.rpm = last.path.spindle.rpm;
    path.spindle.surface_m_min = last.path.spindle.surface_m_min;
    path.spindle.limit_rpm = last.path.spindle.limit_rpm;
    path.tool = last.path.tool;
    x.core.at.tool = path.tool.ref;
    load_tool(x);  // HTOR is that of the table again
    x.core.take_wanted();
    path.zero_row = last.path.zero_row;
    path.preset = last.path.preset;
    path.local = last.path.local;
    refresh_zero(x);
    reset_polar_origin(x);
    x.inclined = last.inclined;
    if (m.inclined) set_inclined(x, 1);  // no longer frozen
}

}  // namespace polyturn::channels::fagor
