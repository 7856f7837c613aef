// What a program leaves to the next one in its channel (fagor_8037t part 1, 4.4.2, 9.1; part 2,
// 11.2, 13): parameters but the local ones, tables, programs that were written, the active zero
// offset, work zones, the tool in work, the inclined axis. Everything else begins as the machine
// parameters say.
#include "channels/fagor/interpreter.hpp"

namespace polyturn::channels::fagor {

struct Interpreter::Left {
    Values values;
    Modal modal;
    PathState path;
    TravelCounter ways;
    std::string program;
    int inclined = -1, orthogonal = -1;
};

std::any Interpreter::carry() const {
    return std::make_shared<Left>(
        Left{values_, modal_, core_.path, ways_,
             frames_.empty() ? std::string() : files_->path(frames_.front().file), inclined_place_,
             orthogonal_place_});
}

void Interpreter::take_carry(const std::any& before, bool) {
    const auto* held = std::any_cast<std::shared_ptr<Left>>(&before);
    if (!held || !*held) return;
    const Left& last = **held;
    values_.take_tables(last.values);
    ways_.take_ways(last.ways);
    first_run_ = last.program != files_->path(frames_.front().file);
    const Modal& m = last.modal;
    modal_.written = m.written;
    modal_.parts = m.parts;
    modal_.speed_limit = m.speed_limit;
    modal_.gear = m.gear;
    modal_.probe_input = m.probe_input;
    modal_.next_tool = m.next_tool;
    modal_.next_offset = m.next_offset;
    modal_.zero = m.zero;
    modal_.zero_number = m.zero_number;
    modal_.zero_added = m.zero_added;
    PathState& path = core_.path;
    path.zones = last.path.zones;
    path.second_limits = last.path.second_limits;
    path.spindle.rpm = last.path.spindle.rpm;
    path.spindle.surface_m_min = last.path.spindle.surface_m_min;
    path.spindle.limit_rpm = last.path.spindle.limit_rpm;
    path.tool = last.path.tool;
    core_.at.tool = path.tool.ref;
    load_tool();  // HTOR is that of the table again
    core_.take_wanted();
    path.zero_row = last.path.zero_row;
    path.preset = last.path.preset;
    path.local = last.path.local;
    refresh_zero();
    reset_polar_origin();
    inclined_place_ = last.inclined;
    orthogonal_place_ = last.orthogonal;
    if (m.inclined) set_inclined(1);  // no longer frozen
}

}  // namespace polyturn::channels::fagor
