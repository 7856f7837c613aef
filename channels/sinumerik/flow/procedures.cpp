// Messages, alarms, master spindle; markers and waits between channels (sinumerik_part3 7.14, part
// 2 17.1b).
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/machine/wait_name.hpp"

namespace polyturn::channels::sinumerik {

bool Interpreter::p_as_machine(Call&) { return true; }

// SBLOF: single block does not stop until SBLON, or in the subprogram whose PROC says so
// (sinumerik_part3 7.12).
void Interpreter::tell_single_block() {
    const bool hides = modal_.hides_steps || std::ranges::any_of(levels_, &Level::hides_steps);
    if (hides == modal_.steps_hidden) return;
    modal_.steps_hidden = hides;
    core_.tell_control(hides ? kControlNoSingleBlock : 0u);
}

bool Interpreter::p_single_block(Call&) {
    modal_.hides_steps = block_.procedures.front().first->name == "SBLOF";
    tell_single_block();
    return true;
}

// The second argument of MSG and WRTPR: 0 with the next block, 1 in a block of its own
// (sinumerik_part2 15.1); here the same.
bool Interpreter::told_when(const Call& c, std::string_view name) {
    if (!c.has(1) || c.number(1) == 0 || c.number(1) == 1) return true;
    return fail(Alarm::ValueOutOfRange, std::string(name), c.number(1));
}

bool Interpreter::p_msg(Call& c) {
    if (!told_when(c, "MSG")) return false;
    message_ = c.has(0) ? to_text(c.value(0)) : std::string();
    if (message_.size() > 124) return fail(Alarm::TextTooLong, "MSG", 124);
    core_.mark_emitted();
    core_.sink().message(message_, core_.at);
    return true;
}

// WRTPR: a text for the operator panel's log (progProtText); it moves nothing and is shown as a
// message.
bool Interpreter::p_wrtpr(Call& c) {
    if (!told_when(c, "WRTPR")) return false;
    const std::string text = to_text(c.value(0));
    if (text.size() > 128) return fail(Alarm::TextTooLong, "WRTPR", 128);
    core_.mark_emitted();
    core_.sink().message(text, core_.at);
    return true;
}

// SETAL(65001, "text"): errors stop the program as any alarm does; %1 channel, %2 block, %4 the
// text.
bool Interpreter::p_setal(Call& c) {
    const double number = c.number(0);
    if (number < 60000 || number > 69999) return fail(Alarm::AlarmNumberIllegal, {}, number);
    std::string text = c.has(1) ? c.value(1).text : std::string();
    const auto replace = [&](std::string_view key, const std::string& by) {
        if (const std::size_t at = text.find(key); at != std::string::npos)
            text.replace(at, key.size(), by);
    };
    replace("%1", std::to_string(core_.view().channel));
    replace("%2", core_.at.block >= 0 ? "N" + std::to_string(core_.at.block) : std::string());
    replace("%4", {});
    return core_.program_alarm(text.empty() ? "SETAL " + to_text(Value::of_int(number)) : text,
                               number);
}

bool Interpreter::p_stopre(Call&) {
    core_.mark_emitted();
    core_.asks_at(levels_.back().file, here_.offset);
    core_.sink().barrier(core_.at);
    stop_reading();
    return true;
}

// SETMS(n): plain S, M3, G95, G96 and G33 mean spindle n from now on.
bool Interpreter::p_setms(Call& c) {
    const double n = c.has(0) ? c.number(0) : core_.view().config().default_spindle;
    if (!(n >= 1 && n <= kMaxSpindles) ||
        !core_.view().machine.spindle(static_cast<std::size_t>(n)).exists())
        return fail(Alarm::SpindleNumberIllegal, {}, n);
    const auto wanted = static_cast<std::uint16_t>(n);
    if (wanted == modal_.master_spindle) return true;
    SpindleState& now = core_.path.spindle;
    // G96 is the master spindle's: the old one goes on as fast as it is, the new one waits for S
    if (now.mode == SpindleModeCode::SurfaceSpeed) {
        if (!core_.surface_speed(false)) return false;
        modal_.asked_rpm[now.spindle] = now.rpm;
        if (!core_.commit_spindle()) return false;
    }
    modal_.spindles[now.spindle] = now;
    if (const auto kept = modal_.spindles.find(wanted); kept != modal_.spindles.end()) {
        now = kept->second;
        modal_.spindles.erase(kept);
    } else {
        now = {};
        now.spindle = wanted;
    }
    modal_.master_spindle = wanted;
    return true;
}

// SETMTH(n): T means this holder. A channel has one turret here, whatever number MD20124 gives its
// holders.
bool Interpreter::p_master_holder(Call& c) {
    const auto holders = static_cast<double>(
        params::get(core_.view().table(), params::md20124, core_.view().channel));
    const double n = c.number(0, 1.0);
    if (!(n >= 1 && n <= std::fmax(holders, 1.0) && n == std::floor(n)))
        return fail(Alarm::ValueOutOfRange, "SETMTH", n);
    // tools are changed where the channel's tool management changes them
    return n == 1 || p_without_effect(c);
}

// --- between channels

// A channel by number or by its name (MD20000, here N0003).
bool Interpreter::channel_of(const Value& value, unsigned& channel) {
    channel = 0;
    const MachineConfig& machine = core_.view().machine;
    if (value.is_number()) {
        if (value.number >= 1 && value.number <= kMaxChannels &&
            value.number == std::floor(value.number))
            channel = static_cast<unsigned>(value.number);
    } else if (value.type == Type::String) {
        for (unsigned l = 1; l <= kMaxChannels && !channel; ++l)
            if (machine.channel(l).exists() &&
                upper(params::get_text(core_.view().table(), params::n0003_channel_name, l)) ==
                    upper(value.text))
                channel = l;
    }
    if (channel && machine.channel(channel).exists()) return true;
    return fail(Alarm::ChannelIllegal, to_text(value));
}

bool Interpreter::marker_of(const Value& value, int& marker) {
    // 0 to 99 (part 2, 17.1b; 0 to 9 on older ones); beyond them the machine's own waiting codes,
    // with which it meets channels of other languages.
    const bool known = (value.number >= 0 && value.number <= 99) ||
                       core_.view().machine.is_wait_code(value.number);
    if (!known || value.number != std::floor(value.number))
        return fail(Alarm::MarkerIllegal, {}, value.number);
    marker = static_cast<int>(value.number);
    return true;
}

bool Interpreter::p_wait_marker(Call& c) {
    const Command* command = block_.procedures.front().first;
    int marker = 0;
    if (!marker_of(c.value(0), marker)) return false;
    std::uint32_t channels = 1u << (core_.view().channel - 1);  // the own one may be left out
    for (std::size_t i = 1; i < c.arguments.size(); ++i) {
        unsigned channel = 0;
        if (!c.has(i) || !channel_of(c.value(i), channel))
            return c.has(i) ? false
                            : fail(Alarm::ArgumentCountIllegal, std::string(command->name),
                                   static_cast<double>(i));
        channels |= 1u << (channel - 1);
    }
    const bool flying = command->name == "WAITMC";
    core_.mark_emitted();
    core_.sink().wait({marker, {}, channels, flying}, core_.at);
    // a flying one is passed without a stop where the others are there already
    if (!flying) stop_reading();
    return true;
}

// WAITE(channel ...): until the programs of the other channels have ended.
bool Interpreter::p_wait_end(Call& c) {
    std::uint32_t channels = 1u << (core_.view().channel - 1);
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        unsigned channel = 0;
        if (!c.has(i)) return fail(Alarm::ArgumentCountIllegal, "WAITE", static_cast<double>(i));
        if (!channel_of(c.value(i), channel)) return false;
        // it would wait for itself
        if (channel == core_.view().channel)
            return fail(Alarm::ChannelIllegal, to_text(c.value(i)));
        channels |= 1u << (channel - 1);
    }
    core_.mark_emitted();
    core_.sink().wait({kWaitAtProgramEnd, "WAITE", channels, false}, core_.at);
    stop_reading();
    return true;
}

// SETM, CLEARM: the own markers, in the order of the path; the channel itself goes on.
bool Interpreter::p_set_marker(Call& c) {
    const bool set = block_.procedures.front().first->name == "SETM";
    const auto tell = [&](int marker) {
        Wait told;
        told.code = marker;
        told.act = set ? Wait::Act::SetMarker : Wait::Act::ClearMarker;
        told.channels = 1u << (core_.view().channel - 1);
        core_.mark_emitted();
        core_.sink().wait(told, core_.at);
    };
    for (const Argument& argument : c.arguments) {
        int marker = 0;
        if (!argument.given || !marker_of(argument.value, marker) || marker > 99)
            return argument.given && marker <= 99 ? false : fail(Alarm::MarkerIllegal, {}, marker);
        tell(marker);
    }
    if (c.arguments.empty()) tell(-1);
    return true;
}

// Axes of POSA arrive; then they are free for everybody.
bool Interpreter::p_wait_axis(Call& c) {
    AxisSet which = 0;
    for (const Argument& argument : c.arguments) {
        if (!argument.given || argument.value.type != Type::Axis)
            return fail(Alarm::AxisArgumentMissing, "WAITP");
        if (const int place = argument.value.place(); place >= 0 && place < kSpindleAxis)
            which |= 1u << place;
    }
    core_.arrive(which, 0);
    return true;
}

bool Interpreter::p_wait_spindle(Call& c) {
    std::uint32_t which = 0;
    for (const Argument& argument : c.arguments) {
        const double n = argument.value.number;
        if (!argument.given || !(n >= 1 && n <= kMaxSpindles) ||
            !core_.view().machine.spindle(static_cast<std::size_t>(n)).exists())
            return fail(Alarm::SpindleNumberIllegal, {}, n);
        which |= 1u << (static_cast<unsigned>(n) - 1);
    }
    if (c.arguments.empty() && modal_.master_spindle) which = 1u << (modal_.master_spindle - 1u);
    core_.arrive(0, which);
    return true;
}

// --- tools by their names

}  // namespace polyturn::channels::sinumerik
