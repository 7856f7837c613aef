// INIT, START: the program of another channel is chosen and started (sinumerik_part3 7.14). What
// becomes of it the machine says: a channel that runs already is not disturbed by START and refuses
// another program.
#include "channels/program_start.hpp"

#include <filesystem>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// INIT(channel, "path", "S"): by its name in the folders that a call knows. N or S: whoever asks
// goes on with the selection made either way, since both stand in the order of the path.
bool Interpreter::p_init(Call& c) {
    // of a path that reaches a channel (ChannelEvent::text)
    constexpr std::size_t kLongest = kCommandText - 1;
    unsigned channel = 0;
    if (!c.has(0) || !c.has(1))
        return fail(Alarm::ArgumentCountIllegal, "INIT", static_cast<double>(c.arguments.size()));
    if (!channel_of(c.value(0), channel)) return false;
    if (channel == core_.view().channel) return fail(Alarm::ChannelIllegal, to_text(c.value(0)));
    const std::string answer = c.has(2) ? upper(c.value(2).text) : "S";
    if (answer != "S" && answer != "N") return fail(Alarm::ValueOutOfRange, "INIT: " + answer);
    const std::string name = program_of_path(c.value(1).text);
    auto file = files_->find_name(name);
    for (const char* suffix : {".MPF", ".SPF", "_MPF", "_SPF"})
        if (!file) file = files_->find_name(name + suffix);
    if (!file) return fail(Alarm::SubprogramMissing, name);
    std::error_code none;
    const std::string path =
        std::filesystem::absolute(files_->path(*file), none).lexically_normal().string();
    if (path.size() > kLongest)
        return fail(Alarm::TextTooLong, "INIT", static_cast<double>(kLongest));
    core_.signal(select_signal(channel, path), 0.0);
    return true;
}

// START(channel, ...): all of them together; the own channel runs already.
bool Interpreter::p_start(Call& c) {
    std::uint32_t channels = 0;
    for (std::size_t i = 0; i < c.arguments.size(); ++i) {
        unsigned channel = 0;
        if (!c.has(i)) return fail(Alarm::ArgumentCountIllegal, "START", static_cast<double>(i));
        if (!channel_of(c.value(i), channel)) return false;
        channels |= 1u << (channel - 1);
    }
    channels &= ~(1u << (core_.view().channel - 1));
    if (channels) core_.signal(kStartSignal, channels);
    return true;
}

}  // namespace polyturn::channels::sinumerik
