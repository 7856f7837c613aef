// Commands come out of the supervisor's memory, as records come out of a channel's: the kernel acts
// on a copy that was checked once. Objects (axes, spindles, channels) are compared with the machine
// where they are used; this file has the range of a command's numbers.
#pragma once
#include <cmath>
#include <iterator>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/diagnosis/languages.hpp"
#include "ipc/image/commands.hpp"
#include "kernel/tick/signals.hpp"

namespace polyturn::kernel {

// The object (axis, spindle, slot, input) can be one at all, and where one channel or axis is
// meant, one is named.
inline const char* fault_of_object(const Command& c) noexcept {
    const auto among = [&](std::size_t least, std::size_t last) {
        return c.object >= least && c.object <= last ? nullptr : "object";
    };
    const std::size_t last_slot = (c.flags & kSlotOfPlc ? kPlcSignals : kNcSignals) - 1;
    switch (static_cast<CommandKind>(c.kind)) {
        case CommandKind::Jog:
        case CommandKind::Step:
            return among(1, kMaxAxes);
        case CommandKind::Handwheel:
            return c.object == 0 && c.channel == 0 ? "channel" : among(0, kMaxAxes);
        case CommandKind::Return:
            return c.channel == 0 ? "channel" : nullptr;
        case CommandKind::Reference:
            return among(0, kMaxAxes);
        case CommandKind::SpindleOverride:
            return among(0, kMaxSpindles);
        case CommandKind::DriveFault:
            return among(1, c.flags ? kMaxSpindles : kMaxAxes);
        case CommandKind::Sensor:
            return c.flags >= kInputs ? "flags" : among(1, kMaxAxes + kMaxSpindles);
        case CommandKind::SetInput:
            return among(0, kInputs - 1);
        case CommandKind::SetSignal:
        case CommandKind::ReleaseSignal:
        case CommandKind::Watch:
            return among(0, last_slot);
        default:
            return nullptr;
    }
}

// The name of the field that cannot be, nullptr: none.
inline const char* fault_of(const Command& c) noexcept {
    constexpr double kFarthest = 1e9;  // mm, degrees, seconds, clicks
    const auto kind = static_cast<CommandKind>(c.kind);
    if (c.text.back() != 0) return "text";
    // there it is a bit of the signal
    if (c.channel >
        (kind == CommandKind::SetSignal ? 32u : static_cast<std::uint32_t>(kMaxChannels)))
        return "channel";
    if (const char* const field = fault_of_object(c)) return field;
    const auto among = [&](double least, double last) {
        return c.value >= least && c.value <= last ? nullptr : "value";
    };
    switch (kind) {
        case CommandKind::Mode:
            return among(0, static_cast<double>(ChannelMode::Reference));
        case CommandKind::Select:
            return among(0, static_cast<double>(std::size(kProgramLanguages)));
        case CommandKind::Scope:
            return among(0, static_cast<double>(ScopeKind::Input));
        case CommandKind::DriveFault:
            return among(0, 65'535);
        case CommandKind::SetSignal:
            return among(-2'147'483'648.0, 2'147'483'647.0);
        case CommandKind::Jog:
        case CommandKind::Step:
        case CommandKind::Handwheel:
        case CommandKind::WarmUp:
        case CommandKind::Restart:
        case CommandKind::Sensor:
            return among(-kFarthest, kFarthest);
        case CommandKind::StoreValue:
        // no number empties a variable
        case CommandKind::DialogueValue:
            return std::isinf(c.value) ? "value" : nullptr;
        default:
            return std::isfinite(c.value) ? nullptr : "value";
    }
}

}  // namespace polyturn::kernel
