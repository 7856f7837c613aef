#include "channels/fanuc/macro/system_writes.hpp"

#include <cmath>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/macro/offset_variables.hpp"
#include "channels/fanuc/motion/modes.hpp"
#include "channels/fanuc/tools/offset_tables.hpp"

namespace polyturn::channels::fanuc {
namespace {

VariableStatus value_fault(Execution& x, std::int64_t number, double value) {
    x.core.fail(Alarm::VariableValue, 0, variable_name(number), value);
    return VariableStatus::Fault;
}

}  // namespace

VariableStatus write_system(Execution& x, std::int64_t number, double value) {
    MachineView& view = x.core.view();
    std::int32_t offset = 0;
    if (const OffsetRange* range = find_range(number, offset)) {
        if (offset > view.config().offset_count) return VariableStatus::Unknown;
        const bool tip = range->field == OffsetField::T;
        const double given = is_null(value) ? 0.0 : value,
                     cell = tip ? std::nearbyint(given) : given * x.modal.input.unit;
        // as G10 (fanuc_lathe 1.1, 1.8; nct N1415)
        if (!(tip ? cell >= 0 && cell <= 9 : offset_value_good(x, range->table, cell))) {
            x.core.fail(Alarm::OffsetValueIllegal, 0, {}, given);
            return VariableStatus::Fault;
        }
        write_offset(x, range->table, offset, range->field, cell);
        return VariableStatus::Ok;
    }
    if (number >= 5201 && number < 5340) {
        const std::int64_t row = (number - 5201) / 20, i = (number - 5201) % 20;
        if (i >= static_cast<std::int64_t>(view.axis_count)) return VariableStatus::Unknown;
        const bool rotary = view.axes[static_cast<std::size_t>(i)].rotary;
        write_zero(x, static_cast<std::int32_t>(row), static_cast<unsigned>(i),
                   (is_null(value) ? 0.0 : value) * (rotary ? 1.0 : x.modal.input.unit));
        return VariableStatus::Ok;
    }
    const double plain = is_null(value) ? 0.0 : value;
    if (number >= 1100 && number <= x.settings.policy.macro.last_output) {
        const std::uint32_t bit = 1u << (number - 1100);
        x.macro.system.outputs =
            plain != 0.0 ? x.macro.system.outputs | bit : x.macro.system.outputs & ~bit;
        x.core.signal("CN_UOUT", x.macro.system.outputs);
        return VariableStatus::Ok;
    }
    if (number == 1132) {
        if (plain < 0 || plain > 65535) return value_fault(x, number, plain);
        x.macro.system.outputs =
            (x.macro.system.outputs & ~0xFFFFu) | static_cast<std::uint32_t>(std::llround(plain));
        x.core.signal("CN_UOUT", x.macro.system.outputs);
        return VariableStatus::Ok;
    }
    if (number >= 1133 && number <= x.settings.policy.macro.last_wide_output) {
        if (std::fabs(plain) > 99999999) return value_fault(x, number, plain);
        x.macro.system.outputs_wide = plain;
        x.core.signal("CN_UOUTW", std::nearbyint(plain));
        return VariableStatus::Ok;
    }
    switch (number) {
        case 3001:
            x.macro.system.timer_ms_offset = plain - x.core.port().running_ms();
            return VariableStatus::Ok;
        case 3002:
            x.macro.system.timer_h_offset = plain - x.core.port().lamp_ms() / 3'600'000.0;
            return VariableStatus::Ok;
        case 3003:
            if (plain < 0 || plain > 3) return value_fault(x, number, plain);
            x.modal.control.single_block_off = (static_cast<int>(plain) & 1) != 0;
            x.modal.control.no_finish_wait = (static_cast<int>(plain) & 2) != 0;
            tell_control(x);
            return VariableStatus::Ok;
        case 3004:
            if (plain < 0 || plain > 7) return value_fault(x, number, plain);
            x.modal.control.automatic = static_cast<int>(plain);
            x.core.path.override_locked = (x.modal.control.automatic & 2) != 0 ||
                                          (x.modal.in_force(GGroup::ExactStop) &&
                                           x.modal.in_force(GGroup::ExactStop)->tenths == 630);
            x.core.path.exact_stop_off = (x.modal.control.automatic & 4) != 0;
            tell_control(x);
            return VariableStatus::Ok;
        case 3005: {
            const auto bits = static_cast<unsigned>(std::llround(plain < 0 ? 0 : plain));
            x.macro.system.tv = bits & 1u;
            x.macro.system.iso = bits & 2u;
            x.macro.system.sequence = bits & 32u;
            x.settings.series15 = bits & 512u;
            x.modal.input.inch = bits & 4u;
            x.modal.input.unit = x.modal.input.inch ? 25.4 : 1.0;
            x.modal.in_force(GGroup::Units) =
                x.vocabulary.table.find(units_code(x, x.modal.input.inch));
            return VariableStatus::Ok;
        }
        case 3901:
            x.modal.parts = plain;
            return VariableStatus::Ok;
        case 3902:
            if (plain < 0) return value_fault(x, number, plain);
            x.macro.system.parts_wanted = plain;
            return VariableStatus::Ok;
        case 5900:
            x.macro.system.pattern = plain;
            return VariableStatus::Ok;
        default:
            break;
    }
    const bool readable = (number >= 1000 && number <= 1035) ||
                          (number >= 3001 && number <= 3012) ||
                          (number >= 4001 && number <= 4130) || (number >= 5001 && number < 5200);
    return readable ? VariableStatus::ReadOnly : VariableStatus::Unknown;
}

}  // namespace polyturn::channels::fanuc
