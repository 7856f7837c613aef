// FCTDEF and SYNFCT: polynomials of third degree with limits (sinumerik_part3 7.12, 8).
#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {

// FCTDEF(number, lower limit, upper limit, a0, a1, a2, a3)
bool Interpreter::p_fctdef(Call& c) {
    for (std::size_t i = 0; i < c.arguments.size(); ++i)
        if (!c.has(i)) return fail(Alarm::ArgumentCountIllegal, "FCTDEF", static_cast<double>(i));
    const double number = c.number(0);
    if (number < 1 || number != std::floor(number))
        return fail(Alarm::ValueOutOfRange, "FCTDEF", number);
    if (c.number(1) > c.number(2)) return fail(Alarm::ValueOutOfRange, "FCTDEF", c.number(1));
    undo([this, before = polynomials_] { polynomials_ = before; });
    polynomials_[static_cast<int>(number)] = {
        c.number(1), c.number(2), {c.number(3), c.number(4), c.number(5), c.number(6)}};
    return true;
}

// SYNFCT(number, variable of the result, input), in synchronized actions
bool Interpreter::p_synfct(Call& c) {
    if (!only_in_action("SYNFCT")) return false;
    const auto found = polynomials_.find(static_cast<int>(c.number(0)));
    if (found == polynomials_.end() || c.number(0) != std::floor(c.number(0)))
        return fail(Alarm::FunctionArgument, "SYNFCT", c.number(0));
    const Polynomial& f = found->second;
    const double x = c.number(2),
                 y = f.factors[0] + x * (f.factors[1] + x * (f.factors[2] + x * f.factors[3]));
    const Value result = Value::of_real(std::clamp(y, f.low, f.high));
    const Argument& target = c.arguments[1];
    const char* const here = cursor_.at();
    return target.reference ? assign(target.reference, result, here)
                            : write_system(target.system, target.indices, result, here, 0, here);
}

}  // namespace polyturn::channels::sinumerik
