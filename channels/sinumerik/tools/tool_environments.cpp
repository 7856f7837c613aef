// TOOLENV, GETTENV, DELTOOLENV: the tool, edge and sum offset that count now, kept under a name
// (sinumerik_part3 9.5). The answer is 0, or -1 where there is no such name.
#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr int kAnswered = 0, kUnknown = -1;
constexpr std::size_t kMost = 100;  // names that are kept

}  // namespace

bool Interpreter::f_toolenv(Call& c) {
    const std::string name = upper(c.value(0).text);
    if (name.empty()) return fail(Alarm::FunctionArgument, "TOOLENV", 1);
    if (!tool_environments_.contains(name) && tool_environments_.size() >= kMost)
        return fail(Alarm::FunctionArgument, "TOOLENV", static_cast<double>(kMost));
    undo([this, before = tool_environments_] { tool_environments_ = before; });
    tool_environments_[name] = {static_cast<double>(modal_.tool), static_cast<double>(modal_.edge),
                                static_cast<double>(modal_.sum_offset)};
    c.result = Value::of_int(kAnswered);
    return true;
}

bool Interpreter::f_gettenv(Call& c) {
    const Reference& result = c.arguments[1].reference;
    const auto found = tool_environments_.find(upper(c.value(0).text));
    if (found == tool_environments_.end()) {
        c.result = Value::of_int(kUnknown);
        return true;
    }
    if (result.element + found->second.size() > result.variable->cells.size())
        return fail(Alarm::FunctionArgument, "GETTENV", 2);
    for (std::size_t i = 0; i < found->second.size(); ++i)
        if (!assign({result.variable, result.element + i, false}, Value::of_int(found->second[i]),
                    cursor_.begin()))
            return false;
    c.result = Value::of_int(kAnswered);
    return true;
}

bool Interpreter::f_deltoolenv(Call& c) {  // without a name: all of them
    undo([this, before = tool_environments_] { tool_environments_ = before; });
    if (!c.has(0)) {
        tool_environments_.clear();
        c.result = Value::of_int(kAnswered);
        return true;
    }
    c.result =
        Value::of_int(tool_environments_.erase(upper(c.value(0).text)) ? kAnswered : kUnknown);
    return true;
}

}  // namespace polyturn::channels::sinumerik
