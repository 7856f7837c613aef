// Expressions of custom macro B, evaluated where they stand in the text.
//
//   comparison  EQ NE GT GE LT LE          lowest; gives 1 or 0
//   sum         + - OR XOR
//   product     * / AND MOD
//   factor      number  #n  #[..]  [#NAME]  [..]  FUNCTION[..]  ATAN[y]/[x]
//
// A comment ( ... ) may stand wherever a blank may (fanuc_lathe 6.4). Those behind the expression
// are left to the caller: the one behind #3000=n is the text of an alarm.
//
// Empty (NaN) survives only where it is alone and in EQ and NE; everywhere else it counts as 0
// (fanuc_lathe 6.2).
#pragma once
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

#include "channels/fanuc/macro/variable_names.hpp"
#include "channels/fanuc/macro/variables.hpp"
#include "channels/text/chars.hpp"
#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::fanuc {

// How many whole steps the value is, a half counted away from zero: 1.2345 is 1235 steps of 0.001.
// What the binary digits of a quotient lack of a half (1.0005/0.001) is made up.
inline double whole_steps(double value, double step) {
    return std::round(value / step * (1 + 1e-12));
}

struct ExpressionFault {
    Alarm alarm{};
    const char* at = nullptr;  // where in the text
    std::string detail;
    double value = 0.0;
};

class Expression {
public:
    enum class Status : std::uint8_t { Ok, NeedsBarrier, Fault };
    static constexpr unsigned kDepth = 5;  // brackets within brackets

    Expression(VariableSet& variables, bool angle_positive, bool short_constants = false)
        : variables_(&variables),
          angle_positive_(angle_positive),
          short_constants_(short_constants) {}

    // Reads a whole expression; `at` is moved behind it.
    Status evaluate(const char*& at, const char* end, double& value);
    // Only #.. or [..], as behind an address.
    Status operand(const char*& at, const char* end, double& value);
    // The number of a variable behind '#', or of [#NAME], for an assignment.
    Status variable_number(const char*& at, const char* end, std::int64_t& number);
    void names_from(const VariableNames& names) { names_ = &names; }  // none: there are no names
    const ExpressionFault& fault() const { return fault_; }
    void round_to(double step) { round_step_ = step; }  // of ROUND; 1 outside addresses

private:
    bool comparison(double&value), sum(double&value), product(double&value), factor(double&value),
        bracket(double&value);
    bool variable(double&value), number_of_variable(std::int64_t&number), function(double&value),
        read(std::int64_t number, const char*begin, double&value);
    bool at_name() const;  // [#N..
    bool named(std::int64_t& number);
    bool fail(Alarm alarm, std::string detail = {}, double value = 0.0);
    bool in_range(double value);
    void blanks() {
        channels::blanks(p_, end_);
        if (p_ != end_ && *p_ == '(') comments();
    }
    void comments();
    std::string_view word();  // letters at p_, not consumed
    void read_from(const char* at, const char* end) {
        p_ = at;
        end_ = end;
        behind_comments_ = nullptr;
        depth_ = 0;
        needs_barrier_ = false;
    }
    Status finish(bool ok, const char*& at);

    VariableSet* variables_;
    const VariableNames* names_ = nullptr;
    bool angle_positive_;
    bool short_constants_;  // eight digits, 0.0000001 to 99999999 (fanuc_lathe 6.4)
    const char* p_ = nullptr;
    const char* end_ = nullptr;
    const char* comments_ = nullptr;         // the last ones that were skipped: where they begin
    const char* behind_comments_ = nullptr;  // and what follows them
    unsigned depth_ = 0;
    double round_step_ = 1.0;
    bool needs_barrier_ = false;
    ExpressionFault fault_;
};

// The name of a variable as events and alarms write it.
std::string variable_name(std::int64_t number);

}  // namespace polyturn::channels::fanuc
