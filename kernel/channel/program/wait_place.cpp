#include "kernel/channel/program/wait_place.hpp"

namespace polyturn::kernel {

WaitBoard::Phase wait_phase(const Channel& c) noexcept {
    if (c.restart.searches()) return {WaitBoard::Kind::Search, c.restart.group};
    return {c.program.mode == ChannelMode::Mdi || c.resume.runs_by_hand() ? WaitBoard::Kind::ByHand
                                                                          : WaitBoard::Kind::Cut,
            0};
}

void stand_at_wait(Channel& c, const PathRecord& r) noexcept {
    c.core.waits.arrive(c.index, r.code, r.mask | ChannelSet{1} << c.index, c.program.run,
                        wait_phase(c));
}

void write_code(const Channel& c, ShortText& text) noexcept {
    const std::int32_t code = c.core.waits.at(c.index).code;
    if (code == WaitBoard::kProgramEnd)
        text << kWaitAtProgramEndWord;
    else
        text << c.traits().wait_prefix << code << c.traits().wait_suffix;
}

void describe_wait(Channel& c, ShortText& text) noexcept {
    text << "L" << c.number << " ";
    const std::string_view name = c.process.program(c.shown.file);
    if (!name.empty()) text << name;
    text << ":" << c.shown.line << " ";
    write_code(c, text);
    text << " (";
    text.channels(c.core.waits.at(c.index).set);
    text << ")";
}

}  // namespace polyturn::kernel
