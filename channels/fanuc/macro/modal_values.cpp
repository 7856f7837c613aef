#include "channels/fanuc/macro/modal_values.hpp"

#include "channels/fanuc/execution.hpp"
#include "ipc/image/interrupt_inputs.hpp"

namespace polyturn::channels::fanuc {
namespace {

// #4001..#4022: the groups as the control counts them (fanuc_lathe 6.3.5, nct part 1 14.2); Count:
// none of that number.
constexpr GGroup kNone = GGroup::Count;

constexpr GGroup kModalGroups[] = {GGroup::Motion,
                                   GGroup::Surface,
                                   GGroup::Distance,
                                   GGroup::Rotation,
                                   GGroup::FeedMode,
                                   GGroup::Units,
                                   GGroup::Comp,
                                   GGroup::SpindleWatch,
                                   GGroup::StrokeArea,
                                   GGroup::Drilling,
                                   GGroup::ReturnLevel,
                                   GGroup::MacroModal,
                                   kNone,
                                   GGroup::Zero,
                                   GGroup::ExactStop,
                                   GGroup::Plane,
                                   kNone,
                                   kNone,
                                   kNone,
                                   kNone,
                                   GGroup::Transform,
                                   kNone};

constexpr GGroup kModalGroupsNct[] = {GGroup::Motion,
                                      GGroup::Plane,
                                      GGroup::Distance,
                                      GGroup::StrokeArea,
                                      GGroup::FeedMode,
                                      GGroup::Units,
                                      GGroup::Comp,
                                      GGroup::Length,
                                      GGroup::Drilling,
                                      GGroup::ReturnLevel,
                                      GGroup::Scale,
                                      GGroup::MacroModal,
                                      GGroup::Surface,
                                      GGroup::Zero,
                                      GGroup::ExactStop,
                                      GGroup::Rotation,
                                      GGroup::Polar,
                                      kNone,
                                      kNone,
                                      kNone,
                                      GGroup::Transform,
                                      GGroup::Mirror};

}  // namespace

// #4001 to #4130: what the blocks before have left in force. False: there is no such group.
bool modal_variable(Execution& x, std::int64_t number, double& value) {
    if (number >= 4001 && number <= 4022) {
        const GGroup group =
            (x.settings.policy.macro.groups_of_nct ? kModalGroupsNct : kModalGroups)[number - 4001];
        const GCode* row = group == kNone            ? nullptr
                           : group == GGroup::Motion ? x.modal.motion
                                                     : x.modal.in_force(group);
        if (group == GGroup::Drilling &&
            !x.modal.drilling) {  // a motion code ends the cycle without G80
            value = 80;
            return row != nullptr;
        }
        value = row ? row->tenths / 10.0 : 0.0;
        return row != nullptr;
    }
    switch (number) {
        case 4109:
            value = x.core.path.feed / x.modal.input.unit;
            return true;
        case 4113:
            value = static_cast<double>(x.modal.last.m);
            return true;
        case 4114:
            value = static_cast<double>(x.modal.last.n);
            return true;
        case 4115:
            value = static_cast<double>(x.modal.program.number);
            return true;
        case 4119:
            value = x.core.path.spindle.mode == SpindleModeCode::SurfaceSpeed
                        ? x.core.path.spindle.surface_m_min / (x.modal.input.inch ? 0.3048 : 1.0)
                        : x.core.path.spindle.rpm;
            return true;
        case 4120:
            value = static_cast<double>(x.modal.last.t);
            return true;
        default:
            return false;
    }
}

// Screens show the way of moving first, then everything else that holds, in the order of execution.
void active_codes(const Execution& x, std::string& out) {
    if (x.modal.motion) out += x.modal.motion->name;
    for (std::size_t group = 0; group < x.modal.active.size(); ++group) {
        const GCode* row = x.modal.active[group];
        if (!row || group == static_cast<std::size_t>(GGroup::Motion) ||
            group == static_cast<std::size_t>(GGroup::OneShot))
            continue;
        if (group == static_cast<std::size_t>(GGroup::Drilling) && !x.modal.drilling) continue;
        if (!out.empty()) out += ' ';
        out += row->name;
    }
}

// Local ones of the running macro level, common ones, kept ones: «#101», «#510 TOOL_NO» where SETVN
// has given a name.
void list_variables(const Execution& x, const Language::ShowVariable& show) {
    const auto one = [&](std::size_t number, double value) {
        if (is_null(value)) return;
        const std::string_view name = number < kLocals
                                          ? std::string_view()
                                          : x.macro.names.of(static_cast<std::int64_t>(number));
        show("#" + std::to_string(number) + (name.empty() ? "" : " ") + std::string(name), value);
    };
    const LocalSet& locals = x.macro.variables.levels().back();
    for (std::size_t n = 1; n < kLocals; ++n) one(n, locals[n]);
    for (std::size_t n = 0; n < x.macro.variables.common().size(); ++n)
        one(x.macro.variables.common_first() + n, x.macro.variables.common()[n]);
    for (std::size_t n = 0; n < 500; ++n) one(500 + n, x.core.view().store->variables[n]);
}

// #3003, #3004: single block, waiting for functions and feed hold are the kernel's, in path order.
// Where G63 taps a hold waits for G64: the spindle would turn on under the stopped tool (the
// field's standard).
std::uint32_t control_bits(const Execution& x) {
    const GCode* mode = x.modal.in_force(GGroup::ExactStop);
    const bool taps = mode && mode->tenths == 630;
    return (x.modal.control.single_block_off || x.calls.hidden ? kControlNoSingleBlock : 0u) +
           (x.modal.control.no_finish_wait ? kControlNoFinish : 0u) +
           ((x.modal.control.automatic & 1) || taps ? kControlNoHold : 0u);
}

void tell_control(Execution& x) { x.core.tell_control(control_bits(x)); }

}  // namespace polyturn::channels::fanuc
