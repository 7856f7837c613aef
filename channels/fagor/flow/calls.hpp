// Jumps, calls and returns: the frames of the texts that are being run.
#pragma once
#include <cstdint>

#include "channels/fagor/flow/call_frames.hpp"
#include "channels/fagor/variables/values.hpp"

namespace polyturn::channels::fagor {

struct Execution;

// To the first block of the running text with this label.
bool jump_to(Execution& x, std::int64_t label);
// What `frame` names becomes the running text; false: too deep.
bool push_frame(Execution& x, CallFrame frame);
// `arguments`: a set of local parameters of its own; nullptr: those of the caller.
bool call_subroutine(Execution& x, std::int64_t number, CallFrame frame, const LocalSet* arguments);
bool call_program(Execution& x, std::int64_t number, CallFrame frame);
void pop_frame(Execution& x);
// RET, the end of a program, the end of a repeated part: once more, or back to the caller.
bool return_from_frame(Execution& x);
bool inside_modal_call(const Execution& x);
// MCALL, MEXEC: the block has moved.
bool run_modal_call(Execution& x, std::int64_t repeats);

}  // namespace polyturn::channels::fagor
