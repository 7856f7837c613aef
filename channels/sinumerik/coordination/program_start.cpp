// INIT, START: the program of another channel is chosen and started (sinumerik_part3 7.14). What
// becomes of it the machine says: a channel that runs already is not disturbed by START and refuses
// another program.
#include "channels/sinumerik/coordination/program_start.hpp"

#include <filesystem>

#include "channels/program_start.hpp"
#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/call_statements.hpp"

namespace polyturn::channels::sinumerik {

// INIT(channel, "path", "S"): by its name in the folders that a call knows. N or S: whoever asks
// goes on with the selection made either way, since both stand in the order of the path.
bool p_init(Execution& x, Call& c) {
    // of a path that reaches a channel (ChannelEvent::text)
    constexpr std::size_t kLongest = kCommandText - 1;
    unsigned channel = 0;
    if (!c.has(0) || !c.has(1))
        return fail(x, Alarm::ArgumentCountIllegal, "INIT",
                    static_cast<double>(c.arguments.size()));
    if (!channel_of(x, c.value(0), channel)) return false;
    if (channel == x.core.view().channel)
        return fail(x, Alarm::ChannelIllegal, to_text(c.value(0)));
    const std::string answer = c.has(2) ? upper(c.value(2).text) : "S";
    if (answer != "S" && answer != "N") return fail(x, Alarm::ValueOutOfRange, "INIT: " + answer);
    const std::string name = program_of_path(c.value(1).text);
    auto file = x.files.find_name(name);
    for (const char* suffix : {".MPF", ".SPF", "_MPF", "_SPF"})
        if (!file) file = x.files.find_name(name + suffix);
    if (!file) return fail(x, Alarm::SubprogramMissing, name);
    std::error_code none;
    const std::string path =
        std::filesystem::absolute(x.files.path(*file), none).lexically_normal().string();
    if (path.size() > kLongest)
        return fail(x, Alarm::TextTooLong, "INIT", static_cast<double>(kLongest));
    x.core.signal(select_signal(channel, path), 0.0);
    return true;
}

// START(channel, ...): all of them together; the own channel runs already.
bool p_start(Execution& x, Call& c) {
    std::uint32_t channels = 0;
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        unsigned channel = 0;
        if (!c.has(i)) return fail(x, Alarm::ArgumentCountIllegal, "START", static_cast<double>(i));
        if (!channel_of(x, c.value(i), channel)) return false;
        channels |= 1u << (channel - 1);
    }
    channels &= ~(1u << (x.core.view().channel - 1));
    if (channels) x.core.signal(kStartSignal, channels);
    return true;
}

}  // namespace polyturn::channels::sinumerik
