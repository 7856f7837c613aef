// Expressions of fagor statements (fagor_8037t part 2, 11.3 to 11.5), evaluated where they stand in
// the text.
//
//   OR                          lowest
//   AND XOR
//   EQ NE GT GE LT LE           gives 1 or 0
//   + -
//   * /
//   EXP MOD                     left to right
//   NOT, functions, sign        right to left
//   number  $hex  PI  P<n>  P(e)  letter  VARIABLE  (e)
//
// AND OR XOR NOT join conditions where both sides are conditions, 32 bit patterns otherwise.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "channels/fagor/grammar/variable_names.hpp"
#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::fagor {

// What an assignment writes, or a value that an expression reads.
struct Target {
    const VariableRow* row = nullptr;  // nullptr: the arithmetic parameter `number`
    std::int64_t number = -1;
    char axis = 0;
    bool has_index = false;
    double index = 0.0, second = 0.0;  // BlockOfProgram: label and program
    bool by_letter = false;
};

enum class Access : std::uint8_t { Ok, Unknown, ReadOnly, NeedsBarrier, Fault };

class VariableHost {
public:
    virtual ~VariableHost() = default;
    virtual Access read(const Target& target, double& value) = 0;
};

struct ExpressionFault {
    Alarm alarm{};
    const char* at = nullptr;
    std::size_t length = 1;
    std::string detail;
};

class Expression {
public:
    enum class Status : std::uint8_t { Ok, NeedsBarrier, Fault };
    static constexpr unsigned kDepth = 60;  // brackets within brackets

    explicit Expression(VariableHost& host) : host_(&host) {}
    // Each moves `at` behind what it has read.
    Status evaluate(const char*& at, const char* end, double& value);
    Status target(const char*& at, const char* end, Target& target);
    const ExpressionFault& fault() const { return fault_; }
    void set_fault(ExpressionFault fault) { fault_ = std::move(fault); }

private:
    struct Value {
        double number = 0.0;
        bool condition = false;
    };
    bool either(Value&v), both(Value&v), relation(Value&v), sum(Value&v), product(Value&v),
        power(Value&v), unary(Value&v), primary(Value&v);
    bool bracket(Value& v);
    bool argument(double& value);
    bool function(std::string_view name, Value& v);
    bool read_target(Target& target);
    bool index(double& value);
    bool whole(double& value);
    bool take_word(std::string_view word);
    bool fail(Alarm alarm, const char* at, std::string detail = {}, std::size_t length = 1);
    void blanks() {
        while (p_ != end_ && (*p_ == ' ' || *p_ == '\t')) ++p_;
    }
    Status finish(bool good, const char*& at);

    VariableHost* host_;
    const char* p_ = nullptr;
    const char* end_ = nullptr;
    unsigned depth_ = 0;
    bool needs_barrier_ = false;
    ExpressionFault fault_;
};

// The name of what is written, as events and alarms show it: P12, TOX3, ORGX55.
std::string target_name(const Target& target);

}  // namespace polyturn::channels::fagor
