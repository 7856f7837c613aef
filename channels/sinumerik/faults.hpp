// What a handler says when it refuses: the alarm, and which part of the line is to blame.
#pragma once
#include <cstddef>
#include <string>
#include <utility>

#include "channels/sinumerik/execution.hpp"

namespace polyturn::channels::sinumerik {

bool fail_word(Execution& x, Alarm alarm, const Word& word, std::string detail = {},
               double v0 = 0.0, double v1 = 0.0);
bool syntax(Execution& x, const char* at, std::string detail = {});
bool fail_at(Execution& x, Alarm alarm, const char* from, std::size_t length,
             std::string detail = {}, double v0 = 0.0, double v1 = 0.0);
bool rest_must_be_empty(Execution& x);

inline bool fail(Execution& x, Alarm alarm, std::string detail = {}, double v0 = 0.0,
                 double v1 = 0.0) {
    return x.core.fail(alarm, 0, std::move(detail), v0, v1);
}

}  // namespace polyturn::channels::sinumerik
