// What a program can ask about a variable: its limits, what DEF gave it, its unit, who may change
// it (sinumerik_part3 9.9). The answer of GETVARLIM and GETVARDFT is 1 where there is such a thing,
// 0 where the variable has none, -1 without a variable.
#include <cmath>
#include <limits>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kFound = 1, kNone = 0, kNoVariable = -1;
constexpr int kEverybody = 7;  // protection level: no restriction

double widest(Type type, bool upper) {
    switch (type) {
        case Type::Bool:
            return upper ? 1.0 : 0.0;
        case Type::Char:
            return upper ? 255.0 : 0.0;
        case Type::Int:
            return upper ? 2147483647.0 : -2147483648.0;
        default:
            return upper ? std::numeric_limits<double>::max() : -std::numeric_limits<double>::max();
    }
}

}  // namespace

bool Interpreter::f_getvarlim(Call& c) {
    const std::string name = upper(c.value(0).text), which = upper(c.value(1).text);
    if (which != "L" && which != "U") return fail(Alarm::FunctionArgument, "GETVARLIM", 2);
    const Reference found = find_variable(name.substr(0, name.find('[')));
    int answer = variable_type(name) ? kNone : kNoVariable;
    if (found) {
        const Variable& variable = *found.variable;
        const bool up = which == "U", given = up ? variable.has_upper : variable.has_lower;
        answer = given ? kFound : kNone;
        if (!assign(c.arguments[2].reference,
                    Value::of_real(given ? (up ? variable.upper : variable.lower)
                                         : widest(variable.type, up)),
                    cursor_.begin()))
            return false;
    }
    c.result = Value::of_int(answer);
    return true;
}

// GETVARDFT(name, value, index ...): of an element by its indices.
bool Interpreter::f_getvardft(Call& c) {
    const std::string name = upper(c.value(0).text);
    const Reference found = find_variable(name.substr(0, name.find('[')));
    int answer = variable_type(name) ? kNone : kNoVariable;
    if (found && !found.variable->defaults.empty()) {
        std::vector<Value> indices;
        for (std::size_t i = 2; i < c.arguments.size(); ++i)
            indices.push_back(c.has(i) ? c.value(i) : Value::of_int(0));
        std::size_t element = 0;
        if ((!indices.empty() || !found.variable->dimensions.empty()) &&
            !element_of(*found.variable, indices, cursor_.begin(), element))
            return false;
        if (!assign(c.arguments[1].reference, found.variable->defaults[element], cursor_.begin()))
            return false;
        answer = kFound;
    }
    c.result = Value::of_int(answer);
    return true;
}

bool Interpreter::f_getvarphu(Call& c) {
    const std::string name = upper(c.value(0).text);
    const Reference found = find_variable(name.substr(0, name.find('[')));
    c.result = Value::of_int(found ? found.variable->unit : variable_type(name) ? 0 : kNoVariable);
    return true;
}

// Programs restrict nothing here: DEF refuses APR and APW.
bool Interpreter::f_getvarap(Call& c) {
    const std::string access = upper(c.value(1).text);
    if (access != "RP" && access != "WP" && access != "RB" && access != "WB")
        return fail(Alarm::FunctionArgument, "GETVARAP", 2);
    c.result = Value::of_int(variable_type(upper(c.value(0).text)) ? kEverybody : kNoVariable);
    return true;
}

}  // namespace polyturn::channels::sinumerik
