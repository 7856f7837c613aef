// G10: offsets, work zeros and parameters written by the program.
#include <fmt/format.h>

#include <cmath>

#include "channels/fanuc/interpreter.hpp"
#include "ipc/machine/errors/compensation_tables.hpp"
#include "ipc/machine/store/work_zeros.hpp"
#include "ipc/params/param_file.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr const char* kFieldNames[] = {"X", "Y", "Z", "R", "T"};

constexpr std::int64_t kLastFanucCell = 11'023;  // fanuc_lathe 7

// N10000 and on: a point of the compensation tables, which the program itself does not need. Whole
// numbers of a fanuc program count increments of the channel's first axis.
bool compensation_cell(Core& core, std::int64_t cell, double value) {
    core.mark_emitted();
    core.sink().parameter(fmt::format("{}={}", cell, static_cast<float>(value)), core.at);
    return true;
}

double& cell_of(OffsetCell& cell, OffsetTable table, OffsetField field) {
    const auto k = static_cast<std::size_t>(field);
    if (field == OffsetField::T) return cell.tip;
    if (field == OffsetField::R)
        return table == OffsetTable::Geometry ? cell.geometry_r : cell.wear_r;
    return table == OffsetTable::Geometry ? cell.geometry[k] : cell.wear[k];
}

}  // namespace

void Interpreter::write_offset(OffsetTable table, std::int32_t number, OffsetField field,
                               double value) {
    double& cell =
        cell_of(core_.view().store->offsets[static_cast<std::size_t>(number)], table, field);
    variables_.note_cell(cell);
    cell = value;
    if (number == core_.path.tool.geometry || number == core_.path.tool.wear) load_nose();
    OffsetWrite write;
    write.table = table == OffsetTable::Geometry ? "geometry" : "wear";
    write.axis = kFieldNames[static_cast<std::size_t>(field)];
    write.number = number;
    if (const CommonOffsets common = common_offsets(core_.view());
        static_cast<unsigned>(number) <= common.count)
        write.channel = common.channel;
    write.store_table = table;
    write.field = field;
    write.value = value;
    core_.mark_emitted();
    core_.sink().offset(write, core_.at);
}

void Interpreter::write_zero(std::int32_t row, unsigned place, double value) {
    double& cell = core_.view().store->zeros[static_cast<std::size_t>(row) * kChannelAxes + place];
    variables_.note_cell(cell);
    cell = value;
    const std::string name = work_zero_name(static_cast<std::size_t>(row));
    OffsetWrite write;
    write.table = "work";
    write.zero_name = name;
    write.axis = core_.view().axes[place].name;
    write.number = row;
    write.work = true;
    write.row = row;
    write.place = static_cast<std::int32_t>(place);
    write.value = value;
    write.until_power_off = settings_.mefi;
    core_.mark_emitted();
    core_.sink().offset(write, core_.at);
    core_.load_zeros();
}

// Range of an offset value: fanuc_lathe 1.1 (three digits before the point), wear of an nct N1415.
bool Interpreter::offset_value_good(OffsetTable table, double shown) {
    const params::Table& t = core_.view().table();
    const unsigned l = core_.view().channel;
    double limit = 9999.9999;
    if (!settings_.nct) {
        limit = inch_ ? 99.9999 * 25.4 : 999.999;
        if (core_.view().axes[0].increment < 0.0005) limit = inch_ ? 99.99999 * 25.4 : 999.9999;
    } else if (table == OffsetTable::Wear) {
        const double most = params::get(t, params::n1415_max_amount_of_wear_comp, l);
        // 1.3: the unit of the machine, whatever the program counts in
        const bool inch_machine = params::bit(t, params::n0104_unit_of_measure, l, 0);
        limit = most > 0 ? most * (inch_machine ? 25.4 : 1.0) : inch_machine ? 0.394 * 25.4 : 1.0;
    }
    return std::fabs(shown) <= limit + 1e-9;
}

bool Interpreter::g_data(const GCode&) {
    if (block_.has('L')) {
        const auto kind = static_cast<int>(block_.value('L'));
        if (kind == 50 || kind == 52) {
            parameter_input_ = true;
            return true;
        }
        if (kind == 3) return begin_life_groups();
        if (kind == 2 || kind == 20 || kind == 21) return g10_zero();
        const bool milling = settings_.nct && core_.view().config().kind == ChannelKind::Mill;
        if (milling && kind >= 10 && kind <= 13 && !axis_word_count_)
            return g10_milling_offset(kind);
        if (kind == 10 || kind == 11) return g10_offset();
        return core_.fail(Alarm::NotBuilt, 'L', fmt::format("G10 L{}", kind));
    }
    return g10_offset();
}

// G10 P_ X_ Z_ R_ Q_ (U_ W_ C_): P0 work shift, P1.. wear, P10001.. geometry. With L10 geometry and
// L11 wear by number.
bool Interpreter::g10_offset() {
    std::int64_t p = 0;
    if (!block_.has('P')) return core_.fail(Alarm::CycleWordMissing, 'G', "P");
    if (!whole('P', p)) return false;
    OffsetTable table = OffsetTable::Wear;
    std::int64_t number = p;
    if (block_.has('L'))
        table = block_.value('L') == 10 ? OffsetTable::Geometry : OffsetTable::Wear;
    else if (p > 10000) {
        table = OffsetTable::Geometry;
        number = p - 10000;
    }
    const MachineView& view = core_.view();
    const int limit = view.config().offset_count;
    if (number > limit || (number == 0 && (p != 0 || block_.has('L'))))
        return core_.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number), limit);
    const auto cell = [&](OffsetField field) {
        return cell_of(core_.view().store->offsets[static_cast<std::size_t>(number)], table, field);
    };
    for (unsigned k = 0; k < block_.count; ++k) {
        const Word& word = block_.words[k];
        if (word.axis >= 0) return core_.fail(Alarm::NotBuilt, 0, "G10 with a long axis name");
        const auto letter = static_cast<std::size_t>(word.address - 'A');
        int place = absolute_axis_[letter];
        bool incremental = !absolute_;
        // C is the increment of the nose radius here
        if (word.address == 'C' && place >= 0 && p != 0) place = -1;
        if (place < 0 && word.address != 'C') {
            place = incremental_axis_[letter];
            incremental = true;
        }
        if (place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        const double value = length(word, place);  // as the table shows it
        if (p == 0 && !block_.has('L')) {
            const double before =
                view.store->zeros[static_cast<std::size_t>(kZeroShiftRow) * kChannelAxes + i];
            write_zero(kZeroShiftRow, i, incremental ? before + value : value);
            continue;
        }
        OffsetField field = OffsetField::X;
        switch (view.axes[i].role) {
            case PlaneRole::BasicX:
                break;
            case PlaneRole::BasicY:
                field = OffsetField::Y;
                break;
            case PlaneRole::BasicZ:
                field = OffsetField::Z;
                break;
            default:
                return core_.fail(Alarm::AddressIllegal, word.address,
                                  std::string(1, word.address));
        }
        const double shown = incremental ? cell(field) + value : value;
        if (!offset_value_good(table, shown))
            return core_.fail(Alarm::OffsetValueIllegal, word.address, {}, shown);
        write_offset(table, static_cast<std::int32_t>(number), field, shown);
    }
    if (p == 0 && !block_.has('L')) return true;
    const auto n = static_cast<std::int32_t>(number);
    for (const char letter : {'R', 'C'}) {
        if (!block_.has(letter) || (letter == 'C' && settings_.nct)) continue;
        const double value = radius_length(letter) + (letter == 'C' ? cell(OffsetField::R) : 0.0);
        if (!offset_value_good(table, value))
            return core_.fail(Alarm::OffsetValueIllegal, letter, {}, value);
    }
    if (block_.has('R')) write_offset(table, n, OffsetField::R, radius_length('R'));
    if (block_.has('C'))
        write_offset(table, n, OffsetField::R, cell(OffsetField::R) + radius_length('C'));
    if (block_.has('Q')) {
        std::int64_t tip = 0;
        if (!whole('Q', tip)) return false;
        if (tip > 9)
            return core_.fail(Alarm::OffsetValueIllegal, 'Q', {}, static_cast<double>(tip));
        write_offset(table, n, OffsetField::T, static_cast<double>(tip));
    }
    return true;
}

// In a milling channel (the field's standard, the specification is silent): R is geometry (L10) and
// wear (L11) of the length that H calls, geometry (L12) and wear (L13) of the radius that D calls.
bool Interpreter::g10_milling_offset(int kind) {
    std::int64_t number = 0;
    for (const char letter : {'P', 'R'})
        if (!block_.has(letter))
            return core_.fail(Alarm::CycleWordMissing, 'G', std::string(1, letter));
    if (!whole('P', number)) return false;
    const int limit = core_.view().config().offset_count;
    if (number < 1 || number > limit)
        return core_.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(number), limit);
    const OffsetTable table = kind == 10 || kind == 12 ? OffsetTable::Geometry : OffsetTable::Wear;
    const OffsetField field = kind < 12 ? OffsetField::Z : OffsetField::R;
    const double before =
        absolute_
            ? 0.0
            : cell_of(core_.view().store->offsets[static_cast<std::size_t>(number)], table, field);
    const double value = before + radius_length('R');
    if (!offset_value_good(table, value))
        return core_.fail(Alarm::OffsetValueIllegal, 'R', {}, value);
    write_offset(table, static_cast<std::int32_t>(number), field, value);
    return true;
}

// G10 L2 Pn, G10 L20 Pn: work zeros; P0 is the external shift. G10 L21 Pn: fixture offsets of the
// table (G54.2).
bool Interpreter::g10_zero() {
    std::int64_t p = 0;
    if (block_.has('P') && !whole('P', p)) return false;
    const bool extended = block_.value('L') == 20, fixture = block_.value('L') == 21;
    const std::int64_t most = fixture    ? static_cast<std::int64_t>(kFixtureRows.size())
                              : extended ? 300
                                         : 6;
    if (p > most || ((extended || fixture) && p < 1))
        return core_.fail(Alarm::OffsetNumberIllegal, 'P', {}, static_cast<double>(p),
                          static_cast<double>(most));
    const std::int32_t row = fixture    ? kFixtureRows[static_cast<std::size_t>(p - 1)]
                             : extended ? kZeroG541Row + static_cast<std::int32_t>(p)
                                        : static_cast<std::int32_t>(p);
    for (unsigned k = 0; k < axis_word_count_; ++k) {
        const Word& word = block_.words[axis_words_[k]];
        const auto [place, incremental] = axis_of(word);
        const auto i = static_cast<unsigned>(place);
        const double before =
            core_.view().store->zeros[static_cast<std::size_t>(row) * kChannelAxes + i];
        const double value = length(word, place);
        write_zero(row, i, incremental ? before + value : value);
    }
    return true;
}

// A block between G10 L50 and G11: N parameter, P axis, R value (bit parameters: eight digits, #7
// first).
bool Interpreter::g10_parameter_block() {
    if (m_count_ || axis_word_count_ || coded_groups_)
        return core_.fail(Alarm::TextInParameterInput, 'G');
    if (!block_.has('N') || !block_.has('R'))
        return core_.fail(Alarm::ParameterInputIllegal, 'N', "N and R are needed");
    if (const Word& r = block_.word('R'); r.has_point && !r.from_expression && !settings_.nct)
        return core_.fail(Alarm::PointForbidden, 'R', "R");
    const auto number = static_cast<std::int64_t>(block_.value('N'));
    core_.at.block = -1;
    if (number >= kFirstCell && number <= (settings_.nct ? kLastCell : kLastFanucCell))
        return compensation_cell(
            core_, number,
            settings_.nct ? block_.value('R') : block_.value('R') * core_.view().axes[0].increment);
    const std::string name = fmt::format("{}{:04}", settings_.nct ? 'N' : 'F', number);
    const params::Row* row = params::find(name);
    if (!row || row->type == params::Type::Text)
        return core_.fail(Alarm::ParameterInputIllegal, 'N', name);
    MachineView& view = core_.view();
    std::string line = name;
    if (row->scope == params::Scope::Channel) {
        line += fmt::format(" L{}", view.channel);
    } else if (row->scope == params::Scope::Axis) {
        const auto axis = block_.has('P') ? static_cast<std::int64_t>(block_.value('P')) : 0;
        if (axis < 1 || axis > view.axis_count)
            return core_.fail(Alarm::ParameterInputIllegal, 'P', name + " needs P with the axis");
        line += fmt::format(" A{}", view.axes[static_cast<std::size_t>(axis - 1)].machine_axis + 1);
    }
    const double value = block_.value('R');
    // digits of 0 and 1, #7 first; leading zeros may be left out
    if (row->type == params::Type::Bits) {
        bool binary = value >= 0 && value <= 11'111'111 && value == std::floor(value);
        for (auto digits = static_cast<std::int64_t>(binary ? value : 0); digits > 0; digits /= 10)
            binary = binary && digits % 10 <= 1;
        if (!binary)
            return core_.fail(Alarm::ParameterInputIllegal, 'R',
                              name + " takes eight digits of 0 and 1");
        line += fmt::format("={:08.0f}", value);
    } else {
        // fanuc: no point in R; lengths and angles count increments, as on the control's own
        // parameter screen.
        const bool increments = !settings_.nct && row->type == params::Type::Real &&
                                (row->unit == "mm" || row->unit == "deg" || row->unit == "mm|deg");
        const auto place = row->scope == params::Scope::Axis
                               ? static_cast<std::size_t>(block_.value('P') - 1)
                               : std::size_t{0};
        line += fmt::format("={}", increments ? value * view.axes[place].increment : value);
    }
    // ends of the stroke: as with G22 both sides must mean the same
    if (number == 1322 || (settings_.nct && number >= 1000 && number <= 1009))
        wants_barrier_ = true;
    if (!give_parameter(line, 'R')) return false;
    // the next word of the axis is read by them
    if (!settings_.nct && (number == 1008 || number == 1260)) {
        fanuc_rollover(view);
        core_.load_zeros();
    }
    return true;
}

// The program's own machine has the value at once, everybody else when the machine comes here.
bool Interpreter::give_parameter(const std::string& line, char letter) {
    const auto parsed = params::parse_assignment(line);
    if (!parsed) return core_.fail(Alarm::ParameterInputIllegal, letter, parsed.diagnosis().text());
    const auto applied = params::apply(*core_.view().parameters, std::span(&*parsed, 1));
    if (!applied)
        return core_.fail(Alarm::ParameterInputIllegal, letter, applied.diagnosis().text());
    core_.mark_emitted();
    core_.sink().parameter(line, core_.at);
    MachineView& view = core_.view();
    const MachineConfig derived = derive_machine_config(view.table());
    for (unsigned i = 0; i < view.axis_count; ++i) {
        ChannelAxis& axis = view.axes[i];
        axis.stroke = read_axis_stroke(view.table(), axis.machine_axis + 1u);
        axis.offset_diameter = derived.axis(axis.machine_axis + 1u).offset_diameter;
    }
    view.stroke = read_channel_stroke(view.table(), view.channel);
    reload_settings();
    return true;
}

// G22 X Y Z I J K: the corners of stroke range 2 in machine coordinates, the greater ones and the
// smaller ones; they become N1006 and N1007, and the range counts for the axes named.
bool Interpreter::stroke_limits() {
    MachineView& view = core_.view();
    static constexpr struct {
        PlaneRole role;
        char greater, smaller;
    } kCorners[] = {{PlaneRole::BasicX, 'X', 'I'},
                    {PlaneRole::BasicY, 'Y', 'J'},
                    {PlaneRole::BasicZ, 'Z', 'K'}};
    for (unsigned k = 0; k < axis_word_count_; ++k)
        if (const Word& word = block_.words[axis_words_[k]];
            word.axis >= 0 || (word.address != 'X' && word.address != 'Y' && word.address != 'Z'))
            return core_.fail(Alarm::AddressIllegal, word.address, std::string(1, word.address));
    const double machine_unit =
        params::bit(view.table(), params::n0104_unit_of_measure, view.channel, 0) ? 25.4 : 1.0;
    for (const auto& [role, greater, smaller] : kCorners) {
        if (!block_.has(greater) && !block_.has(smaller)) continue;
        const int place = view.axis_by_role(role);
        if (place < 0)
            return core_.fail(Alarm::AddressIllegal, block_.has(greater) ? greater : smaller,
                              std::string(1, greater));
        if (!block_.has(greater) || !block_.has(smaller))
            return core_.fail(Alarm::CycleWordMissing, 'G',
                              std::string(1, block_.has(greater) ? smaller : greater));
        const ChannelAxis& axis = view.axes[static_cast<std::size_t>(place)];
        const auto limit = [&](char letter) {
            return length(block_.word(letter), place) * (axis.diameter ? 0.5 : 1.0) /
                   (axis.rotary ? 1.0 : machine_unit);
        };
        const double most = limit(greater), least = limit(smaller);
        if (most <= least)
            return core_.fail(Alarm::CycleValueIllegal, greater, std::string(1, greater),
                              block_.value(greater));
        const unsigned a = axis.machine_axis + 1u;
        // Where F1322 holds instead of N1006 it takes the corner too.
        if (params::get(view.table(), params::f1322, a) != 0 &&
            !give_parameter(fmt::format("F1322 A{}=0", a), greater))
            return false;
        if (!give_parameter(fmt::format("N1006 A{}={}", a, most), greater) ||
            !give_parameter(fmt::format("N1007 A{}={}", a, least), smaller))
            return false;
        if (!params::bit(view.table(), params::n1000_range_enable, a, 1) &&
            !give_parameter(fmt::format("N1000#1 A{}=1", a), greater))
            return false;
    }
    if (!params::bit(view.table(), params::n1001_strkcont, view.channel, 1) &&
        !give_parameter(fmt::format("N1001#1 L{}=1", view.channel), 'G'))
        return false;
    words_used_ = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
