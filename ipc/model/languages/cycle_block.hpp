// A form and the blocks of a program: read from the cursor's position, written so that only the
// words change that have changed.
//
// Invariants
//   I1  write(read(x)) == x: a form that is not changed changes nothing.
//   I2  read(write(values)) == values, to the decimals that the language writes.
//   I3  Comments, block numbers, other words and all other lines stay byte for byte.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "ipc/model/languages/forms.hpp"

namespace polyturn::forms {

// The content of a field. An expression (#100, [#1*2], P5) stays text.
struct Value {
    bool set = false;
    double number = 0.0;
    std::string expression;  // not empty: instead of the number
    // of the word it came from, where a field has two (X, U); empty: its first
    std::string address;
    bool operator==(const Value&) const = default;
};

struct CycleBlock {
    const Form* form = nullptr;
    std::vector<Value> values;  // one for each field
    int line[2] = {-1, -1};     // of its blocks, from 0; -1: it is not there
};

// The cycle at a line, or that whose second (first) block stands there.
std::optional<CycleBlock> read_cycle(const std::vector<std::string>& lines, int line,
                                     const Dialect& dialect);
// What a form proposes for an empty field.
CycleBlock new_cycle(const Form& form, const Dialect& dialect = {});

struct FieldFault {
    enum Kind { None, Missing, TooSmall, TooLarge, NotWhole, NoNumber } kind = None;
    double limit = 0.0;
};
// One for each field.
std::vector<FieldFault> check_cycle(const CycleBlock& cycle);
inline bool is_good(const std::vector<FieldFault>& faults) {
    for (const FieldFault& fault : faults)
        if (fault.kind != FieldFault::None) return false;
    return true;
}

// The lines that differ: a replaced line, a new one before line `at`, or one that goes.
struct LineChange {
    int at = 0;
    bool inserts = false;
    std::string text;
    bool removes = false;
};
// `before`: what read_cycle gave; without a line of its own the cycle becomes new lines before
// `cursor`. In order of the text.
std::vector<LineChange> write_cycle(const std::vector<std::string>& lines, const CycleBlock& before,
                                    const CycleBlock& now, int cursor, const Dialect& dialect);
void apply_changes(std::vector<std::string>& lines, const std::vector<LineChange>& changes);

// The digits behind the point that a field is written with.
int decimals_of(const Field& field, const Dialect& dialect);

}  // namespace polyturn::forms
