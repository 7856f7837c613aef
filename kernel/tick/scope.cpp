#include "kernel/tick/scope.hpp"

namespace polyturn::kernel {
namespace {

double axis_value(ScopeKind kind, const AxisStatus& axis) noexcept {
    switch (kind) {
        case ScopeKind::AxisCommanded:
            return axis.cmd;
        case ScopeKind::AxisMeasured:
            return axis.act;
        case ScopeKind::AxisError:
            return axis.error;
        case ScopeKind::AxisVelocity:
            return axis.velocity;
        case ScopeKind::AxisTorque:
            return axis.torque;
        default:
            return axis.compensation;
    }
}

double spindle_value(ScopeKind kind, const SpindleStatus& spindle) noexcept {
    switch (kind) {
        case ScopeKind::SpindleCommanded:
            return spindle.command;
        case ScopeKind::SpindleSpeed:
            return spindle.speed;
        case ScopeKind::SpindleAngle:
            return spindle.angle;
        default:
            return spindle.deviation;
    }
}

}  // namespace

void Scope::choose(KernelSegment& image, std::uint32_t trace, ScopeKind kind,
                   std::uint32_t object) noexcept {
    if (trace >= kScopeTraces) return;
    choice_.kind[trace] = static_cast<std::uint32_t>(kind);
    choice_.object[trace] = object;
    // P4: own head
    choice_.first = image.scope.head.load(std::memory_order_relaxed);
    any_ = false;
    for (const std::uint32_t one : choice_.kind) any_ |= one != 0;
    image.scope_choice.write(choice_);
}

void Scope::sample(Core& core, const MachineStatus& status) noexcept {
    if (!any_) return;
    // P4: own head
    const std::uint64_t head = core.image.scope.head.load(std::memory_order_relaxed);
    // P5: what follows stays behind the head of before: else a reader could miss that it is
    // overtaken
    std::atomic_thread_fence(std::memory_order_release);
    ScopeSample& out = core.image.scope.slot(head);
    out.tick = core.tick;
    for (std::size_t i = 0; i < kScopeTraces; ++i) {
        const auto kind = static_cast<ScopeKind>(choice_.kind[i]);
        const std::uint32_t object = choice_.object[i];
        double value = 0;
        if (kind >= ScopeKind::AxisCommanded && kind <= ScopeKind::AxisCompensation) {
            if (object >= 1 && object <= kMaxAxes)
                value = axis_value(kind, status.axes[object - 1]);
        } else if (kind >= ScopeKind::SpindleCommanded && kind <= ScopeKind::SpindleDeviation) {
            if (object >= 1 && object <= kMaxSpindles)
                value = spindle_value(kind, status.spindles[object - 1]);
        } else if (kind == ScopeKind::PathSpeed || kind == ScopeKind::PathLeft) {
            if (object >= 1 && object <= kMaxChannels)
                value = kind == ScopeKind::PathSpeed ? status.channels[object - 1].path_speed
                                                     : status.channels[object - 1].path_left;
        } else if (kind == ScopeKind::NcSignal) {
            if (object < kNcSignals) value = core.signals.nc(object);
        } else if (kind == ScopeKind::PlcSignal) {
            if (object < kPlcSignals) value = core.signals.plc(object);
        } else if (kind == ScopeKind::Input) {
            if (object < kInputs) value = core.signals.input(object);
        }
        out.value[i] = value;
    }
    // P1: the sample is complete
    core.image.scope.head.store(head + 1, std::memory_order_release);
}

}  // namespace polyturn::kernel
