#include "kernel/channel/mdi_lines.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

#include "kernel/tick/event_log.hpp"

namespace polyturn::kernel {

bool MdiLines::enter(std::string_view text) noexcept {
    if (list_.count == list_.lines.size()) {
        std::uint32_t oldest = 0;
        while (oldest < list_.count && (is(list_.lines[oldest], MdiState::Entered) ||
                                        is(list_.lines[oldest], MdiState::Runs)))
            ++oldest;
        if (oldest == list_.count) return false;
        drop(oldest);
    }
    MdiLine& line = list_.lines[list_.count++];
    line = {};
    line.number = ++entered_;
    line.state = static_cast<std::uint32_t>(MdiState::Entered);
    copy_text(line.text, text);
    ++list_.waiting;
    changed_ = true;
    return true;
}

void MdiLines::begin(bool all) noexcept {
    due_ = all ? list_.waiting : std::min<std::uint32_t>(list_.waiting, 1);
}

std::string_view MdiLines::next() const noexcept {
    for (std::uint32_t i = 0; i < list_.count; ++i)
        if (is(list_.lines[i], MdiState::Entered))
            return {list_.lines[i].text.data(),
                    ::strnlen(list_.lines[i].text.data(), list_.lines[i].text.size())};
    return {};
}

std::string_view MdiLines::run_next() noexcept {
    leave(MdiState::Done);  // L4
    const std::string_view text = next();
    for (std::uint32_t i = 0; i < list_.count; ++i)
        if (is(list_.lines[i], MdiState::Entered)) {
            list_.lines[i].state = static_cast<std::uint32_t>(MdiState::Runs);
            --list_.waiting;
            if (due_ > 0) --due_;
            changed_ = true;
            break;
        }
    return text;
}

void MdiLines::leave(MdiState state) noexcept {
    for (std::uint32_t i = 0; i < list_.count; ++i)
        if (is(list_.lines[i], MdiState::Runs)) {
            list_.lines[i].state = static_cast<std::uint32_t>(state);
            changed_ = true;
        }
}

void MdiLines::broken_off() noexcept {
    leave(MdiState::BrokenOff);
    due_ = 0;
    for (std::uint32_t i = list_.count; i-- > 0;)
        if (is(list_.lines[i], MdiState::Entered)) drop(i);
}

void MdiLines::clear() noexcept {
    due_ = 0;
    for (std::uint32_t i = list_.count; i-- > 0;)
        if (!is(list_.lines[i], MdiState::Runs)) drop(i);
}

void MdiLines::drop(std::uint32_t at) noexcept {
    if (is(list_.lines[at], MdiState::Entered)) --list_.waiting;
    std::move(list_.lines.begin() + at + 1, list_.lines.begin() + list_.count,
              list_.lines.begin() + at);
    --list_.count;
    due_ = std::min(due_, list_.waiting);
    changed_ = true;
}

void MdiLines::publish(Snapshot<MdiList>& shown) noexcept {
    if (std::exchange(changed_, false)) shown.write(list_);
}

}  // namespace polyturn::kernel
