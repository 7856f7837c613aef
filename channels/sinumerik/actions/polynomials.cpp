// FCTDEF and SYNFCT: polynomials of third degree with limits (sinumerik_part3 7.12, 8).
#include "channels/sinumerik/actions/polynomials.hpp"

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/actions/synchronized.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/system_variables.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {

// FCTDEF(number, lower limit, upper limit, a0, a1, a2, a3)
bool p_fctdef(Execution& x, Call& c) {
    for (std::size_t i = 0; i < c.arguments.size(); ++i)
        if (!c.has(i))
            return fail(x, Alarm::ArgumentCountIllegal, "FCTDEF", static_cast<double>(i));
    const double number = c.number(0);
    if (number < 1 || number != std::floor(number))
        return fail(x, Alarm::ValueOutOfRange, "FCTDEF", number);
    if (c.number(1) > c.number(2)) return fail(x, Alarm::ValueOutOfRange, "FCTDEF", c.number(1));
    undo(x, [&x, before = x.actions.polynomials] { x.actions.polynomials = before; });
    x.actions.polynomials[static_cast<int>(number)] = {
        c.number(1), c.number(2), {c.number(3), c.number(4), c.number(5), c.number(6)}};
    return true;
}

// SYNFCT(number, variable of the result, input), in synchronized actions
bool p_synfct(Execution& x, Call& c) {
    if (!only_in_action(x, "SYNFCT")) return false;
    const auto found = x.actions.polynomials.find(static_cast<int>(c.number(0)));
    if (found == x.actions.polynomials.end() || c.number(0) != std::floor(c.number(0)))
        return fail(x, Alarm::FunctionArgument, "SYNFCT", c.number(0));
    const Polynomial& f = found->second;
    const double in = c.number(2),
                 y = f.factors[0] + in * (f.factors[1] + in * (f.factors[2] + in * f.factors[3]));
    const Value result = Value::of_real(std::clamp(y, f.low, f.high));
    const Argument& target = c.arguments[1];
    const char* const here = x.line.cursor.at();
    return target.reference ? assign(x, target.reference, result, here)
                            : write_system(x, target.system, target.indices, result, here, 0, here);
}

}  // namespace polyturn::channels::sinumerik
