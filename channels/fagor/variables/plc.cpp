#include "channels/fagor/variables/plc.hpp"

#include "channels/fagor/execution.hpp"
#include "channels/fagor/variables/named.hpp"

namespace polyturn::channels::fagor {
namespace {

double* plc_cell(Execution& x, const Target& target) {
    const double n = target.index;
    const auto within = [n](std::size_t count) { return n >= 1 && n < static_cast<double>(count); };
    const auto i = static_cast<std::size_t>(n < 0 ? 0 : n);
    switch (target.row->var) {
        case Var::PlcRegister:
            return within(Values::kRegisters) ? &x.values.plc_register(i) : nullptr;
        case Var::PlcTimer:
            return within(Values::kTimers) ? &x.values.timer(i) : nullptr;
        case Var::PlcCounter:
            return within(Values::kCounters) ? &x.values.counter(i) : nullptr;
        case Var::PlcMark:
        case Var::PlcMarks:
            return within(Values::kMarks) ? &x.values.mark(i) : nullptr;
        case Var::PlcInputs:
            return within(Values::kPins) ? &x.values.input(i) : nullptr;
        default:
            return within(Values::kPins) ? &x.values.output(i) : nullptr;
    }
}

}  // namespace

// One number, one mark, or 32 of them beginning with the named one.
Access plc_value(Execution& x, const Target& target, bool write, double& value) {
    const Var var = target.row->var;
    double* const cell = plc_cell(x, target);
    if (!cell) return variable_fault(x, Alarm::FagorValueRange, target_name(target), target.index);
    const bool many = var == Var::PlcMarks || var == Var::PlcInputs || var == Var::PlcOutputs;
    if (!many) {
        if (write)
            x.values.write(*cell, var == Var::PlcMark ? (value != 0 ? 1.0 : 0.0) : value);
        else
            value = *cell;
        return Access::Ok;
    }
    const std::size_t count = var == Var::PlcMarks ? Values::kMarks : Values::kPins;
    const auto bits = static_cast<std::uint32_t>(static_cast<std::int64_t>(write ? value : 0.0));
    double out = 0.0;
    Target one = target;
    for (unsigned k = 0; k < 32; ++k) {
        one.index = target.index + k;
        if (one.index >= static_cast<double>(count)) break;
        double* const bit = plc_cell(x, one);
        if (write)
            x.values.write(*bit, bits >> k & 1u);
        else if (*bit != 0)
            out += std::ldexp(1.0, static_cast<int>(k));
    }
    if (!write) value = out;
    return Access::Ok;
}

}  // namespace polyturn::channels::fagor
