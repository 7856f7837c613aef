// The text of a statement: numbers, names, quoted texts, and what a fault in it points to.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "channels/fagor/grammar/expression.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// How a statement, or a part of one, has ended.
enum class Flow : std::uint8_t { Done, NeedsBarrier, Fault };

// What a statement does. `word`: its name, where it stands in the line; `at`: behind it.
using StatementAct = Flow (*)(Execution& x, std::string_view word, const char*& at,
                              const char* end);

// Each of the following moves `at` behind what it has read.
inline std::string_view letters_at(const char* at, const char* end) {
    const char* q = at;
    while (q != end && is_capital(*q)) ++q;
    return {at, static_cast<std::size_t>(q - at)};
}

// A comma, and the blanks around it.
inline bool comma(const char*& at, const char* end) {
    blanks(at, end);
    if (at == end || *at != ',') return false;
    ++at;
    blanks(at, end);
    return true;
}

// Notes a fault at this place of the line.
Flow flow_fault(Execution& x, Alarm alarm, const char* at, std::size_t length = 1,
                std::string detail = {}, double value = 0.0);
// A fault that is noted already stands at this place.
Flow fault_stands_at(Execution& x, const char* at);
Flow evaluate(Execution& x, const char*& at, const char* end, double& value);
Flow read_target(Execution& x, const char*& at, const char* end, Target& to);
// What jumps or calls asks this before it does so: of a block that cannot be read nothing is done.
Flow nothing_follows(Execution& x, const char*& at, const char* end);
// A whole number, or an expression that gives one, behind `letter` (0: none).
Flow number_of_statement(Execution& x, const char*& at, const char* end, char letter,
                         std::int64_t& number);
bool quoted(const char*& at, const char* end, std::string& text);
// ?P12 becomes the value; with only_marked false P12 behind a letter becomes it too.
std::string with_parameters(Execution& x, std::string_view text, bool only_marked);

}  // namespace polyturn::channels::fagor
