#include "channels/fanuc/macro/flow.hpp"

#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/statement_words.hpp"

namespace polyturn::channels::fanuc {

Flow flow_fault(Execution& x, Alarm alarm, const char* at, std::string detail, double value) {
    x.words.culprit.column = static_cast<std::uint32_t>(at - x.text.line.data()) + 1;
    x.words.culprit.length = 1;
    x.core.fail(alarm, 0, std::move(detail), value);
    return Flow::Fault;
}

Flow flow_of(Execution& x, Expression::Status status) {
    if (status == Expression::Status::Ok) return Flow::Done;
    if (status == Expression::Status::NeedsBarrier) return Flow::NeedsBarrier;
    const ExpressionFault& f = x.macro.expression.fault();
    return flow_fault(x, f.alarm, f.at, f.detail, f.value);
}

Flow evaluate_expression(Execution& x, const char*& at, const char* end, double& value) {
    return flow_of(x, x.macro.expression.evaluate(at, end, value));
}

Flow bracketed_condition(Execution& x, const char*& at, const char* end, bool& holds) {
    gap(at, end);
    if (at == end || *at != '[') return flow_fault(x, Alarm::BracketMissing, at);
    double value = 0.0;
    const Flow flow = flow_of(x, x.macro.expression.operand(at, end, value));
    holds = !is_null(value) && value != 0.0;
    return flow;
}

}  // namespace polyturn::channels::fanuc
