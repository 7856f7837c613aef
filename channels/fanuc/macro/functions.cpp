// S, T and M words: spindle, tool and its offsets, auxiliary functions, waits, program stops, M98
// and M99.
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr std::int64_t power_of_ten(unsigned digits) {
    std::int64_t value = 1;
    while (digits--) value *= 10;
    return value;
}

bool in_ranges(const std::vector<std::pair<double, double>>& ranges, double code) {
    for (const auto& [low, high] : ranges)
        if (code >= low && code <= high) return true;
    return false;
}

// M codes that act behind the block's motion: what ends something must not end it before the cut.
bool acts_late(double code, const MachineConfig& machine) {
    return code == 0 || code == 1 || code == 2 || code == 5 || code == 9 || code == 30 ||
           code == 98 || code == 99 || code == 198 || machine.is_wait_code(code);
}

}  // namespace

bool Interpreter::is_draining(double code) const { return in_ranges(settings_.draining_m, code); }

bool Interpreter::spindle_word() {
    Word word = block_.word('S');
    // a whole number, as M (fanuc_lathe 6.1)
    if (word.from_expression && !settings_.nct) word.value = whole_steps(word.value, 1.0);
    const bool one_shot = (coded_groups_ >> static_cast<unsigned>(GGroup::OneShot)) & 1u;
    if (one_shot &&
        coded_[static_cast<std::size_t>(GGroup::OneShot)]->act == &Interpreter::g_preset) {
        return core_.spindle_limit(word.value) && core_.commit_spindle();
    }
    double value = word.value;
    // feet a minute
    if (core_.path.spindle.mode == SpindleModeCode::SurfaceSpeed && inch_) value *= 0.3048;
    if (!core_.spindle_speed(value)) return false;
    if (settings_.s_drains) wants_barrier_ = true;
    return true;
}

// S2=3200: the speed of a spindle by its name; M3, M4, M5 and M19 mean it until a plain S.
bool Interpreter::named_spindles() {
    for (unsigned i = 0; i < block_.count; ++i) {
        const Word& word = block_.words[i];
        if (word.axis < kNamedSpindle) continue;
        const auto& [name, spindle] =
            settings_.spindle_names[static_cast<std::size_t>(word.axis - kNamedSpindle)];
        if (!core_.named_spindle(spindle, word.value)) return false;
        if (settings_.s_drains) wants_barrier_ = true;
    }
    return true;
}

bool Interpreter::tool_word() {
    std::int64_t value = 0;
    if (!whole('T', value)) return false;
    const ToolCode& code = settings_.tool;
    const ToolRequest wish = tool_request();
    if (wish == ToolRequest::Place) {  // its offset stays
        core_.path.tool.ref.number = last_t_ = value;
        core_.at.tool = core_.path.tool.ref;
        core_.aux('T', static_cast<double>(value), fmt::format("T{:08}", value), settings_.t_drains,
                  false, ToolCallBy::Place);
        if (settings_.t_drains) wants_barrier_ = true;
        return true;
    }
    if (settings_.offsets_by_g) {  // T is the tool alone; offsets come by G codes
        core_.path.tool.ref.number = last_t_ = value;
        core_.at.tool = core_.path.tool.ref;
        core_.aux('T', static_cast<double>(value), fmt::format("T{}", value), settings_.t_drains);
        if (settings_.t_drains) wants_barrier_ = true;
        return true;
    }
    const std::int64_t modulus = power_of_ten(code.offset_digits);
    std::int64_t tool = value / modulus;
    auto offset = static_cast<std::int32_t>(value % modulus);
    // the T has been executed
    const bool called = managed_serial_ == core_.at.serial && waits_for_tool();
    if (called) {
        std::int64_t own = 0;
        if (!managed_offset(false, own)) return false;
        offset = static_cast<std::int32_t>(own);
    }
    ToolState& state = core_.path.tool;
    // T gg 88 ends the offset of the group's tool; no tool is called, gg is none.
    const bool cancels = !called && settings_.group_calls && code.offset_digits >= 2 &&
                         offset == 8 * (modulus - 1) / 9;
    if (cancels) {
        offset = 0;
        tool = state.ref.number;
    }
    const int limit = core_.view().config().offset_count;
    std::int64_t geometry = code.geometry_by_tool ? tool : offset;
    if (code.offset_digits == 0) geometry = code.geometry_by_tool ? tool : state.geometry;
    if (offset == 0 && code.offset_digits != 0) {
        if (settings_.nct)
            geometry = code.geometry_by_tool && !code.zero_cancels_geometry ? tool : 0;
        else if (!code.geometry_by_tool && !code.geometry_travels && !code.zero_cancels_geometry)
            geometry = state.geometry;
    }
    if (offset > limit || geometry > limit)
        return core_.fail(Alarm::OffsetNumberIllegal, 'T', {},
                          static_cast<double>(offset > limit ? offset : geometry), limit);
    state.ref.number = tool;
    state.ref.offset = offset;
    state.geometry = static_cast<std::int32_t>(geometry);
    if (code.offset_digits != 0) state.wear = offset;
    last_t_ = value;
    core_.at.tool = state.ref;
    // T0303, T33, T3003: as they are written
    const std::string text =
        fmt::format("T{:0{}}", value, code.offset_digits == 2 ? 4 : code.offset_digits + 1);
    // the PLC's turret wants the tool; the event shows the word
    if (!called && !cancels) core_.aux('T', static_cast<double>(tool), text, settings_.t_drains);
    if (settings_.t_drains && !called && !cancels) wants_barrier_ = true;
    if (!apply_tool_offsets()) return false;
    // A T word alone travels the change of the vector at once, unless it waits for the next move
    // (5002#6).
    constexpr std::uint32_t kMoving = (1u << static_cast<unsigned>(GGroup::OneShot));
    const bool alone = axis_word_count_ == 0 && !(coded_groups_ & kMoving);
    if (alone && !code.with_next_move && core_.vector_pending()) {
        return core_.travel_offset(motion_->tenths == 0);
    }
    return true;
}

bool Interpreter::apply_tool_offsets() {
    const ToolCode& code = settings_.tool;
    ToolState& state = core_.path.tool;
    MachineView& view = core_.view();
    const OffsetCell& geometry = view.store->offsets[static_cast<std::size_t>(state.geometry)];
    const OffsetCell& wear = view.store->offsets[static_cast<std::size_t>(state.wear)];
    AxisValues shift{}, vector{};
    static constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    for (std::size_t k = 0; k < 3; ++k) {
        const int place = view.axis_by_role(kRoles[k]);
        if (place < 0) continue;
        const auto i = static_cast<unsigned>(place);
        const double g =
            state.geometry && !settings_.offsets_by_g
                ? view.from_offset(i, geometry.geometry[k] + second_geometry(k, geometry))
                : 0.0;
        const double w =
            state.wear && !settings_.offsets_by_g ? view.from_offset(i, wear.wear[k]) : 0.0;
        (code.geometry_travels ? vector : shift)[i] += g;
        (code.wear_travels ? vector : shift)[i] += w;
        if (length_.number) {
            const OffsetCell& cell = view.store->offsets[static_cast<std::size_t>(length_.number)];
            if (length_.turning)
                shift[i] +=
                    view.from_offset(i, cell.geometry[k] + cell.wear[k] + second_geometry(k, cell));
            else if (length_.axes >> i & 1u)
                // a milling tool's length
                shift[i] += length_.sign * (cell.geometry[2] + cell.wear[2]);
        }
    }
    // nct part 1 15.5, RTL; a head turns them itself
    if (settings_.offsets_turn && !core_.transformed() && !frames_of_.rotation.is_identity()) {
        Point3 lengths{};
        for (std::size_t k = 0; k < 3; ++k)
            if (const int place = view.axis_by_role(kRoles[k]); place >= 0)
                lengths[k] = shift[static_cast<std::size_t>(place)];
        lengths = frames_of_.rotation.direction(lengths);
        for (std::size_t k = 0; k < 3; ++k)
            if (const int place = view.axis_by_role(kRoles[k]); place >= 0)
                shift[static_cast<std::size_t>(place)] = lengths[k];
    }
    load_nose();
    core_.set_shift(shift);
    core_.set_wanted(vector);
    return true;
}

// nct N1414#4: a second table is added for the axes that the PLC selects.
double Interpreter::second_geometry(std::size_t axis, const OffsetCell& cell) {
    return settings_.second_geometry && core_.port().second_geometry(static_cast<unsigned>(axis))
               ? cell.second[axis]
               : 0.0;
}

// Radius and tip of the offsets in use; a changed value counts from the next corner on.
void Interpreter::load_nose() {
    const ToolCode& code = settings_.tool;
    ToolState& state = core_.path.tool;
    const MachineView& view = core_.view();
    const OffsetCell& geometry = view.store->offsets[static_cast<std::size_t>(state.geometry)];
    const OffsetCell& wear = view.store->offsets[static_cast<std::size_t>(state.wear)];
    state.nose_off = !settings_.nct && state.ref.offset == 0;
    state.nose_radius = state.nose_off ? 0.0
                                       : (state.geometry ? geometry.geometry_r : 0.0) +
                                             (state.wear ? wear.wear_r : 0.0);
    const std::int32_t tip_number = code.tip_from_wear ? state.wear : state.geometry;
    if (length_.turning && length_.number)
        state.tip = static_cast<std::int32_t>(
            view.store->offsets[static_cast<std::size_t>(length_.number)].tip);
    // D, or the lathe offset of G43.7
    if (length_.radius || (length_.turning && length_.number)) {
        const std::int32_t number = length_.radius ? length_.radius : length_.number;
        const OffsetCell& cell = view.store->offsets[static_cast<std::size_t>(number)];
        const bool diameter = view.config().kind == ChannelKind::Mill &&
                              params::bit(view.table(), params::n1402_tool_meas, view.channel, 0);
        state.nose_radius = (cell.geometry_r + cell.wear_r) * (diameter ? 0.5 : 1.0);
        state.nose_off = false;
        state.geometry = number;
        if (!length_.turning) state.tip = 0;
        return;
    }
    state.tip = tip_number ? static_cast<std::int32_t>(
                                 view.store->offsets[static_cast<std::size_t>(tip_number)].tip)
                           : 0;
}

bool Interpreter::m_before() {
    for (unsigned k = 0; k < m_count_; ++k) {
        const double code = block_.words[m_words_[k]].value;
        for (unsigned other = 0; other < k && !settings_.m_groups.empty(); ++other) {
            const double before = block_.words[m_words_[other]].value;
            for (const auto& [low, high] : settings_.m_groups)
                if (code >= low && code <= high && before >= low && before <= high &&
                    code != before)
                    return core_.fail(Alarm::MCodesContradict, 'M',
                                      fmt::format("M{:.0f} and M{:.0f}", before, code));
        }
        if (code == 3 || code == 4) {
            note_loop(code);
            if (!core_.spindle_turn(code == 3 ? SpindleTurn::Cw : SpindleTurn::Ccw)) return false;
        }
    }
    if (!core_.commit_spindle()) return false;
    for (unsigned k = 0; k < m_count_; ++k) {
        const Word& word = block_.words[m_words_[k]];
        if (acts_late(word.value, core_.view().machine)) continue;
        if (!function_code(word, false)) return false;
    }
    // G1: with F in degrees a minute.
    const double rpm = motion_->tenths == 10 && core_.path.feed_mode == FeedMode::PerMinute
                           ? core_.path.feed / unit_ / 360.0
                           : 0.0;
    for (const auto& [name, spindle] : settings_.spindle_addresses) {
        if (name.size() != 1 || !block_.has(name[0]) || (axis_letters_ & letter_bit(name[0])))
            continue;
        if (!turn_spindle(spindle, block_.value(name[0]), !absolute_, true, rpm)) return false;
    }
    for (unsigned i = 0; spindle_words_ && i < block_.count; ++i)
        if (const Word& word = block_.words[i];
            word.axis >= kSpindleWord && word.axis < kNamedSpindle &&
            !turn_spindle(
                settings_.spindle_addresses[static_cast<std::size_t>(word.axis - kSpindleWord)]
                    .spindle,
                word.value, !absolute_, true, rpm))
            return false;
    for (std::size_t n = 0; n < settings_.aux_letters.size(); ++n) {
        const char letter = settings_.aux_letters[n];
        if (!letter || !block_.has(letter) || (axis_letters_ & letter_bit(letter))) continue;
        const double value = block_.value(letter);
        core_.aux(letter, value, fmt::format("{}{}", letter, value), settings_.aux_drains[n]);
        if (settings_.aux_drains[n]) wants_barrier_ = true;
    }
    return true;
}

bool Interpreter::function_code(const Word& word, bool late) {
    const double code = word.value;
    if (code < 0 || code != std::floor(code)) {
        fault_column_ = word.column;
        fault_length_ = word.length;
        return core_.fail(code < 0 ? Alarm::NegativeSign : Alarm::PointForbidden, 'M', "M");
    }
    if (code == settings_.interrupt.on || code == settings_.interrupt.off)
        return interrupt_code(word);
    if (late && code == 5 && !(core_.spindle_turn(SpindleTurn::Stop) && core_.commit_spindle()))
        return false;
    note_loop(code);
    if (code == 19 &&
        !(can_orient(spindle_of_codes()) && turn_spindle(spindle_of_codes(), 0.0, false, false)))
        return false;
    if (const Settings::Indexing* turns = indexing_of(code);
        turns &&
        !turn_spindle(turns->spindle, (code - turns->first + 1) * turns->angle, true, true))
        return false;
    const bool drains = is_draining(code) || (code == 5 && core_.frees_axis());
    char text[24];
    const auto end = fmt::format_to_n(text, sizeof text, "M{}", static_cast<std::int64_t>(code));
    const bool b_axis = !settings_.nct && !settings_.mefi;
    // with the code, not behind it
    const bool at_once =
        b_axis && params::bit(core_.view().table(), params::f8240, core_.view().channel, 7);
    if (at_once && !b_start(code)) return false;
    core_.aux('M', code, {text, end.size}, drains);
    last_m_ = static_cast<std::int64_t>(code);
    if (drains) wants_barrier_ = true;
    if (settings_.part_code != 0 && code == settings_.part_code)
        core_.sink().part(++parts_, core_.at);
    return !b_axis || at_once || b_start(code);
}

// Of several waiting codes none is waited for.
bool Interpreter::one_wait_code() {
    bool waits = false;
    for (unsigned k = 0; k < m_count_; ++k) {
        const Word& word = block_.words[m_words_[k]];
        if (!core_.view().machine.is_wait_code(word.value)) continue;
        if (std::exchange(waits, true)) {
            fault_column_ = word.column;
            fault_length_ = word.length;
            return core_.fail(Alarm::ClampTooLong, 0, {}, word.value);
        }
    }
    return true;
}

bool Interpreter::m_after() {
    if (m_count_ > 1 && !one_wait_code()) return false;
    bool waits = false;
    const Word* last = nullptr;  // what ends or leaves the block: M0 M1 M2 M30 M98 M99
    for (unsigned k = 0; k < m_count_; ++k) {
        const Word& word = block_.words[m_words_[k]];
        const double code = word.value;
        if (!acts_late(code, core_.view().machine)) continue;
        if (core_.view().machine.is_wait_code(code)) {
            waits = true;
            if (!wait_code(word)) return false;
        } else if (code == 5 || code == 9) {
            if (!function_code(word, true)) return false;
        } else {
            if (last && last->value != code)
                return core_.fail(Alarm::CodesContradict, 'M',
                                  fmt::format("M{:.0f} and M{:.0f}", last->value, code));
            last = &word;
        }
    }
    if (block_.has_list && !waits) return core_.fail(Alarm::PointListForbidden, 'P');
    if (!last) return true;
    const auto code = static_cast<int>(last->value);
    switch (code) {
        case 0:
        case 1:
            if (code == 1 && !core_.port().optional_stop()) {
                core_.sink().stop({StopReason::M01, nullptr, false}, core_.at);
                return true;
            }
            core_.mark_emitted();
            core_.sink().stop({code == 0 ? StopReason::M00 : StopReason::M01}, core_.at);
            wants_barrier_ = true;
            return true;
        case 2:
        case 30:
            if (settings_.part_code == 0) core_.sink().part(++parts_, core_.at);
            finish(code == 2 ? StopReason::M02 : StopReason::M30);
            return true;
        case 98:
            return sub_call(false);
        case 198:
            return sub_call(true);
        default:
            break;
    }
    // M99
    std::int64_t target = 0;
    const bool has_target = block_.has('P');
    if (has_target && !whole('P', target)) return false;
    called_ = true;
    return return_from(has_target, target);
}

// M98, and M198: the program comes from outside (PT_EXTERNAL).
bool Interpreter::sub_call(bool external) {
    std::int64_t number = 0, repeats = 1;
    if (!program_word('M', number)) return false;
    if (external && number < 0) return core_.fail(Alarm::SubprogramWordMissing, 'M');
    if (!settings_.nct && number >= 0) {
        if (settings_.series15) {
            number %= 10000;
        } else if (number > 9999) {  // the count precedes the four digits of the number
            repeats = number / 10000;
            number %= 10000;
        }
    }
    if (block_.has('L') && !call_count(repeats)) return false;
    called_ = true;
    if (external) return external_call(number, repeats);
    if (!call_program(number, repeats, nullptr, false, false, 'P')) return false;
    std::int64_t from = 0;  // Q: the block with which the subprogram begins
    return !block_.has('Q') || (whole('Q', from) && jump_to(from));
}

// A waiting code: digits of P name channels 1 to 9, P=1.12.16 any.
bool Interpreter::wait_code(const Word& word) {
    const MachineConfig& machine = core_.view().machine;
    const unsigned own = core_.view().channel;
    std::uint32_t channels = 0;
    if (block_.has('P')) {
        const Word& p = block_.word('P');
        std::string digits =
            p.from_expression ? fmt::format("{:.0f}", p.value) : std::string(text_of(p).substr(1));
        for (std::size_t open; (open = digits.find('(')) != std::string::npos;)
            digits.erase(open, digits.find(')', open) - open + 1);
        const bool list = digits.find('.') != std::string::npos;
        const auto add = [&](unsigned channel) {
            if (channel < 1 || channel > kMaxChannels || !machine.channel(channel).exists())
                return core_.fail(Alarm::WaitSetIllegal, 'P', std::to_string(channel), word.value);
            channels |= 1u << (channel - 1);
            return true;
        };
        if (digits.find('-') != std::string::npos)
            return core_.fail(Alarm::WaitSetIllegal, 'P', digits, word.value);
        unsigned number = 0;
        bool any = false;
        for (const char c : digits) {
            if (c >= '0' && c <= '9') {
                number = list ? number * 10 + static_cast<unsigned>(c - '0')
                              : static_cast<unsigned>(c - '0');
                if (number > 1000) number = 1000;
                any = true;
                if (list) continue;
            } else if (c != '.') {
                continue;
            }
            if (any && !add(number)) return false;
            number = 0;
            any = false;
        }
        if (any && !add(number)) return false;
        if (!(channels >> (own - 1) & 1u))
            return core_.fail(Alarm::WaitSetWithoutSelf, 'P', {}, word.value);
    } else {
        channels = machine.channels_of_group(machine.channel(own).group);
        if (__builtin_popcount(channels) != 2)
            return core_.fail(Alarm::WaitSetMissing, 'M', {}, word.value);
    }
    core_.mark_emitted();
    core_.sink().wait({static_cast<std::int64_t>(word.value), {}, channels, false}, core_.at);
    wants_barrier_ = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
