// What a program can ask about a variable: its limits, what DEF gave it, its unit, who may change
// it (sinumerik_part3 9.9). The answer of GETVARLIM and GETVARDFT is 1 where there is such a thing,
// 0 where the variable has none, -1 without a variable.
#include "channels/sinumerik/variables/variable_facts.hpp"

#include <limits>

#include "channels/angles.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/data_variables.hpp"
#include "channels/sinumerik/variables/system_names.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

// VARTYP: what DEF made it
int type_code(Type type) {
    constexpr int kCodes[] = {1, 2, 3, 4, 5, 7, 8};  // BOOL CHAR INT REAL STRING AXIS FRAME
    return kCodes[static_cast<std::size_t>(type)];
}

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

// 0: no variable; else the code of its type.
int variable_type(const Execution& x, const std::string& text) {
    std::string name = text.substr(0, text.find('['));
    if (!name.empty() && name[0] == '$') {
        if (name.size() > 1 && name[1] == 'R' &&
            (name.size() == 2 || name.find_first_not_of("0123456789", 2) == std::string::npos))
            return 4;
        return is_system_variable(name) || is_data_name(name) ? 4 : 0;
    }
    if (!name.empty() && name[0] == 'R' &&
        (name.size() == 1 || name.find_first_not_of("0123456789", 1) == std::string::npos))
        return 4;
    const Reference reference = find_variable(x, name);
    return reference ? type_code(reference.variable->type) : 0;
}

}  // namespace

bool f_getvarlim(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text), which = upper(c.value(1).text);
    if (which != "L" && which != "U") return fail(x, Alarm::FunctionArgument, "GETVARLIM", 2);
    const Reference found = find_variable(x, name.substr(0, name.find('[')));
    int answer = variable_type(x, name) ? kNone : kNoVariable;
    if (found) {
        const Variable& variable = *found.variable;
        const bool up = which == "U", given = up ? variable.has_upper : variable.has_lower;
        answer = given ? kFound : kNone;
        if (!assign(x, c.arguments[2].reference,
                    Value::of_real(given ? (up ? variable.upper : variable.lower)
                                         : widest(variable.type, up)),
                    x.line.cursor.begin()))
            return false;
    }
    c.result = Value::of_int(answer);
    return true;
}

// GETVARDFT(name, value, index ...): of an element by its indices.
bool f_getvardft(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text);
    const Reference found = find_variable(x, name.substr(0, name.find('[')));
    int answer = variable_type(x, name) ? kNone : kNoVariable;
    if (found && !found.variable->defaults.empty()) {
        std::vector<Value> indices;
        for (std::size_t i = 2; i < c.arguments.size(); ++i)
            indices.push_back(c.has(i) ? c.value(i) : Value::of_int(0));
        std::size_t element = 0;
        if ((!indices.empty() || !found.variable->dimensions.empty()) &&
            !element_of(x, *found.variable, indices, x.line.cursor.begin(), element))
            return false;
        if (!assign(x, c.arguments[1].reference, found.variable->defaults[element],
                    x.line.cursor.begin()))
            return false;
        answer = kFound;
    }
    c.result = Value::of_int(answer);
    return true;
}

bool f_getvarphu(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text);
    const Reference found = find_variable(x, name.substr(0, name.find('[')));
    c.result = Value::of_int(found                    ? found.variable->unit
                             : variable_type(x, name) ? 0
                                                      : kNoVariable);
    return true;
}

// Programs restrict nothing here: DEF refuses APR and APW.
bool f_getvarap(Execution& x, Call& c) {
    const std::string access = upper(c.value(1).text);
    if (access != "RP" && access != "WP" && access != "RB" && access != "WB")
        return fail(x, Alarm::FunctionArgument, "GETVARAP", 2);
    c.result = Value::of_int(variable_type(x, upper(c.value(0).text)) ? kEverybody : kNoVariable);
    return true;
}

bool f_isvar(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text);
    c.result = Value::of_bool(variable_type(x, name) != 0);
    return true;
}
bool f_getvartyp(Execution& x, Call& c) {
    const int type = variable_type(x, upper(c.value(0).text));
    // below 0: no such variable
    c.result = Value::of_int(type ? type : -1);
    return true;
}

// 0: unknown; 1xx known but not built; 2xx can be programmed (sinumerik_part3 9.9).
bool f_stringis(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text);
    const Symbol symbol = find_symbol(name);
    int answer = 0;
    switch (symbol.kind) {
        case Symbol::Kind::None:
            answer = variable_type(x, name) || x.names.macros.contains(name) ? 200
                     : x.files.find_name(name)                               ? 200
                                                                             : 0;
            break;
        case Symbol::Kind::Reserved:
            answer = 100;
            break;
        case Symbol::Kind::G:
            answer = symbol.g().act ? 200 : 100;
            break;
        case Symbol::Kind::Address:
            answer = symbol.address().use == Address::Use::Refused ? 100 : 200;
            break;
        case Symbol::Kind::Command:
            answer = symbol.command().act ? 200 : 100;
            break;
        case Symbol::Kind::Statement:
            answer = symbol.statement().act ? 200 : 100;
            break;
        case Symbol::Kind::Operator:
            answer = 200;
            break;
    }
    c.result = Value::of_int(answer);
    return true;
}
}  // namespace polyturn::channels::sinumerik
