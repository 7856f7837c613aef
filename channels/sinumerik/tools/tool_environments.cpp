// TOOLENV, GETTENV, DELTOOLENV: the tool, edge and sum offset that count now, kept under a name
// (sinumerik_part3 9.5). The answer is 0, or -1 where there is no such name.
#include "channels/sinumerik/tools/tool_environments.hpp"

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kAnswered = 0, kUnknown = -1;
constexpr std::size_t kMost = 100;  // names that are kept

}  // namespace

bool f_toolenv(Execution& x, Call& c) {
    const std::string name = upper(c.value(0).text);
    if (name.empty()) return fail(x, Alarm::FunctionArgument, "TOOLENV", 1);
    if (!x.tools.environments.contains(name) && x.tools.environments.size() >= kMost)
        return fail(x, Alarm::FunctionArgument, "TOOLENV", static_cast<double>(kMost));
    undo(x, [&x, before = x.tools.environments] { x.tools.environments = before; });
    x.tools.environments[name] = {static_cast<double>(x.modal.tool),
                                  static_cast<double>(x.modal.edge),
                                  static_cast<double>(x.modal.sum_offset)};
    c.result = Value::of_int(kAnswered);
    return true;
}

bool f_gettenv(Execution& x, Call& c) {
    const Reference& result = c.arguments[1].reference;
    const auto found = x.tools.environments.find(upper(c.value(0).text));
    if (found == x.tools.environments.end()) {
        c.result = Value::of_int(kUnknown);
        return true;
    }
    if (result.element + found->second.size() > result.variable->cells.size())
        return fail(x, Alarm::FunctionArgument, "GETTENV", 2);
    for (std::size_t i = 0; i < found->second.size(); ++i)
        if (!assign(x, {result.variable, result.element + i, false},
                    Value::of_int(found->second[i]), x.line.cursor.begin()))
            return false;
    c.result = Value::of_int(kAnswered);
    return true;
}

bool f_deltoolenv(Execution& x, Call& c) {  // without a name: all of them
    undo(x, [&x, before = x.tools.environments] { x.tools.environments = before; });
    if (!c.has(0)) {
        x.tools.environments.clear();
        c.result = Value::of_int(kAnswered);
        return true;
    }
    c.result =
        Value::of_int(x.tools.environments.erase(upper(c.value(0).text)) ? kAnswered : kUnknown);
    return true;
}

}  // namespace polyturn::channels::sinumerik
