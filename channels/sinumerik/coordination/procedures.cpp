// Messages, alarms, master spindle; markers and waits between channels (sinumerik_part3 7.14, part
// 2 17.1b).
#include "channels/sinumerik/coordination/procedures.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "ipc/image/interrupt_inputs.hpp"
#include "ipc/model/languages/wait_name.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// The second argument of MSG and WRTPR: 0 with the next block, 1 in a block of its own
// (sinumerik_part2 15.1); here the same.
bool told_when(Execution& x, const Call& c, std::string_view name) {
    if (!c.has(1) || c.number(1) == 0 || c.number(1) == 1) return true;
    return fail(x, Alarm::ValueOutOfRange, std::string(name), c.number(1));
}

bool marker_of(Execution& x, const Value& value, int& marker) {
    // 0 to 99 (part 2, 17.1b; 0 to 9 on older ones); beyond them the machine's own waiting codes,
    // with which it meets channels of other languages.
    const bool known = (value.number >= 0 && value.number <= 99) ||
                       x.core.view().machine.is_wait_code(value.number);
    if (!known || value.number != std::floor(value.number))
        return fail(x, Alarm::MarkerIllegal, {}, value.number);
    marker = static_cast<int>(value.number);
    return true;
}

}  // namespace

// SBLOF: single block does not stop until SBLON, or in the subprogram whose PROC says so
// (sinumerik_part3 7.12).
void tell_single_block(Execution& x) {
    const bool hides =
        x.modal.hides_steps || std::ranges::any_of(x.calls.levels, &Level::hides_steps);
    if (hides == x.modal.steps_hidden) return;
    x.modal.steps_hidden = hides;
    x.core.tell_control(hides ? kControlNoSingleBlock : 0u);
}

bool p_single_block(Execution& x, Call&) {
    x.modal.hides_steps = x.block.procedures.front().first->name == "SBLOF";
    tell_single_block(x);
    return true;
}

bool p_msg(Execution& x, Call& c) {
    if (!told_when(x, c, "MSG")) return false;
    x.shown.message = c.has(0) ? to_text(c.value(0)) : std::string();
    if (x.shown.message.size() > 124) return fail(x, Alarm::TextTooLong, "MSG", 124);
    x.core.mark_emitted();
    x.core.sink().message(x.shown.message, x.core.at);
    return true;
}

// WRTPR: a text for the operator panel's log (progProtText); it moves nothing and is shown as a
// message.
bool p_wrtpr(Execution& x, Call& c) {
    if (!told_when(x, c, "WRTPR")) return false;
    const std::string text = to_text(c.value(0));
    if (text.size() > 128) return fail(x, Alarm::TextTooLong, "WRTPR", 128);
    x.core.mark_emitted();
    x.core.sink().message(text, x.core.at);
    return true;
}

// SETAL(65001, "text"): errors stop the program as any alarm does; %1 channel, %2 block, %4 the
// text.
bool p_setal(Execution& x, Call& c) {
    const double number = c.number(0);
    if (number < 60000 || number > 69999) return fail(x, Alarm::AlarmNumberIllegal, {}, number);
    std::string text = c.has(1) ? c.value(1).text : std::string();
    const auto replace = [&](std::string_view key, const std::string& by) {
        if (const std::size_t at = text.find(key); at != std::string::npos)
            text.replace(at, key.size(), by);
    };
    replace("%1", std::to_string(x.core.view().channel));
    replace("%2", x.core.at.block >= 0 ? "N" + std::to_string(x.core.at.block) : std::string());
    replace("%4", {});
    return x.core.program_alarm(text.empty() ? "SETAL " + to_text(Value::of_int(number)) : text,
                                number);
}

bool p_stopre(Execution& x, Call&) {
    x.core.mark_emitted();
    x.core.asks_at(x.calls.levels.back().file, x.line.here.offset);
    x.core.sink().barrier(x.core.at);
    stop_reading(x);
    return true;
}

// SETMTH(n): T means this holder. A channel has one turret here, whatever number MD20124 gives its
// holders.
bool p_master_holder(Execution& x, Call& c) {
    const auto holders = static_cast<double>(
        params::get(x.core.view().table(), params::md20124, x.core.view().channel));
    const double n = c.number(0, 1.0);
    if (!(n >= 1 && n <= std::fmax(holders, 1.0) && n == std::floor(n)))
        return fail(x, Alarm::ValueOutOfRange, "SETMTH", n);
    // tools are changed where the channel's tool management changes them
    return n == 1 || p_without_effect(x, c);
}

// --- between channels

// A channel by number or by its name (MD20000, here N0003).
bool channel_of(Execution& x, const Value& value, unsigned& channel) {
    channel = 0;
    const MachineConfig& machine = x.core.view().machine;
    if (value.is_number()) {
        if (value.number >= 1 && value.number <= kMaxChannels &&
            value.number == std::floor(value.number))
            channel = static_cast<unsigned>(value.number);
    } else if (value.type == Type::String) {
        for (unsigned l = 1; l <= kMaxChannels && !channel; ++l)
            if (machine.channel(l).exists() &&
                upper(params::get_text(x.core.view().table(), params::n0003_channel_name, l)) ==
                    upper(value.text))
                channel = l;
    }
    if (channel && machine.channel(channel).exists()) return true;
    return fail(x, Alarm::ChannelIllegal, to_text(value));
}

bool p_wait_marker(Execution& x, Call& c) {
    const Command* command = x.block.procedures.front().first;
    int marker = 0;
    if (!marker_of(x, c.value(0), marker)) return false;
    std::uint32_t channels = 1u << (x.core.view().channel - 1);  // the own one may be left out
    for (std::size_t i = 1; i < c.arguments.size(); ++i) {
        unsigned channel = 0;
        if (!c.has(i) || !channel_of(x, c.value(i), channel))
            return c.has(i) ? false
                            : fail(x, Alarm::ArgumentCountIllegal, std::string(command->name),
                                   static_cast<double>(i));
        channels |= 1u << (channel - 1);
    }
    const bool flying = command->name == "WAITMC";
    x.core.mark_emitted();
    x.core.sink().wait({marker, {}, channels, flying}, x.core.at);
    // a flying one is passed without a stop where the others are there already
    if (!flying) stop_reading(x);
    return true;
}

// WAITE(channel ...): until the programs of the other channels have ended.
bool p_wait_end(Execution& x, Call& c) {
    std::uint32_t channels = 1u << (x.core.view().channel - 1);
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        unsigned channel = 0;
        if (!c.has(i)) return fail(x, Alarm::ArgumentCountIllegal, "WAITE", static_cast<double>(i));
        if (!channel_of(x, c.value(i), channel)) return false;
        // it would wait for itself
        if (channel == x.core.view().channel)
            return fail(x, Alarm::ChannelIllegal, to_text(c.value(i)));
        channels |= 1u << (channel - 1);
    }
    x.core.mark_emitted();
    x.core.sink().wait({kWaitAtProgramEnd, "WAITE", channels, false}, x.core.at);
    stop_reading(x);
    return true;
}

// SETM, CLEARM: the own markers, in the order of the path; the channel itself goes on.
bool p_set_marker(Execution& x, Call& c) {
    const bool set = x.block.procedures.front().first->name == "SETM";
    const auto tell = [&](int marker) {
        Wait told;
        told.code = marker;
        told.act = set ? Wait::Act::SetMarker : Wait::Act::ClearMarker;
        told.channels = 1u << (x.core.view().channel - 1);
        x.core.mark_emitted();
        x.core.sink().wait(told, x.core.at);
    };
    for (const Argument& argument : c.arguments) {
        int marker = 0;
        if (!argument.given || !marker_of(x, argument.value, marker) || marker > 99)
            return argument.given && marker <= 99 ? false
                                                  : fail(x, Alarm::MarkerIllegal, {}, marker);
        tell(marker);
    }
    if (c.arguments.empty()) tell(-1);
    return true;
}

// Axes of POSA arrive; then they are free for everybody.
bool p_wait_axis(Execution& x, Call& c) {
    AxisSet which = 0;
    for (const Argument& argument : c.arguments) {
        if (!argument.given || argument.value.type != Type::Axis)
            return fail(x, Alarm::AxisArgumentMissing, "WAITP");
        if (const int place = argument.value.place(); place >= 0 && place < kSpindleAxis)
            which |= 1u << place;
    }
    x.core.arrive(which, 0);
    return true;
}

// --- tools by their names

}  // namespace polyturn::channels::sinumerik
