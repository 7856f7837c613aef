#include "channels/fagor/flow/calls.hpp"

#include <cstdio>

#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/interrupts.hpp"
#include "channels/fagor/flow/programs.hpp"

namespace polyturn::channels::fagor {
namespace {

constexpr unsigned kCallLevels = 15, kLocalLevels = 6;

}  // namespace

bool jump_to(Execution& x, std::int64_t label) {
    const auto found = find_label(x, x.calls.here().file, label);
    if (!found) return x.fail(Alarm::SequenceNumberMissing, 0, std::to_string(label));
    // A jump out of a repeated part ends the repetition.
    while (x.calls.here().kind == CallFrame::Kind::Repeat &&
           (found->line < x.calls.here().begin.line || found->line > x.calls.here().last_line)) {
        const FileId file = x.calls.here().file;
        x.calls.drop();
        if (x.calls.here().file != file)
            return x.fail(Alarm::SequenceNumberMissing, 0, std::to_string(label));
    }
    x.calls.source().seek(*found);
    x.run.fresh = false;  // a loop asks the machine anew each time
    x.run.jumped = true;
    return true;
}

bool push_frame(Execution& x, CallFrame frame) {
    unsigned levels = 0, locals = 0;
    for (const CallFrame& other : x.calls.frames()) {
        levels +=
            other.kind == CallFrame::Kind::Subroutine || other.kind == CallFrame::Kind::Program;
        locals += other.own_level;
    }
    if (frame.kind != CallFrame::Kind::Repeat && levels >= kCallLevels)
        return x.fail(Alarm::CallTooDeep, 0, {}, kCallLevels);
    if (frame.own_level && locals >= kLocalLevels)
        return x.fail(Alarm::FagorLevels, 0, {}, kLocalLevels);
    if (x.calls.depth() > 60) return x.fail(Alarm::CallTooDeep, 0, {}, 60);
    x.calls.enter(frame);
    x.run.called = x.run.jumped = true;
    return true;
}

bool call_subroutine(Execution& x, std::int64_t number, CallFrame frame,
                     const LocalSet* arguments) {
    FileId file = 0;
    TextPosition begin;
    if (!find_subroutine(x, number, file, begin))
        return x.fail(Alarm::SubprogramMissing, 0, "SUB " + std::to_string(number));
    if (defined_twice(x, number, file))
        return x.fail(Alarm::FagorSubroutineTwice, 0, std::to_string(number));
    if (number >= kMakerFirst) {
        if (!attribute_of(x, file, 'O'))
            return x.fail(Alarm::FagorMakerSubroutine, 0, std::to_string(number));
        if (!x.calls.here().maker) return x.fail(Alarm::FagorMakerCall, 0, std::to_string(number));
    }
    frame.kind = CallFrame::Kind::Subroutine;
    frame.file = file;
    frame.begin = begin;
    frame.program = x.calls.here().program;
    frame.maker = attribute_of(x, file, 'O');
    frame.own_level = arguments != nullptr;
    if (!push_frame(x, frame)) return false;
    if (arguments) x.values.push_level(*arguments);
    return true;
}

bool call_program(Execution& x, std::int64_t number, CallFrame frame) {
    const auto file = find_program(x, number);
    if (!file) return x.fail(Alarm::SubprogramMissing, 0, "P" + std::to_string(number));
    frame.kind = CallFrame::Kind::Program;
    frame.file = *file;
    frame.begin = {0, 1};
    frame.program = number;
    frame.maker = attribute_of(x, *file, 'O');
    return push_frame(x, frame);
}

void pop_frame(Execution& x) {
    if (x.calls.leave().own_level) x.values.pop_level();
    x.run.jumped = true;
}

// RET, the end of a program, the end of a repeated part: once more, or back to the caller.
bool return_from_frame(Execution& x) {
    x.run.state_changed = true;
    CallFrame& frame = x.calls.here();
    if (frame.interrupt) return return_from_interrupt(x);
    if (frame.runs_left > 0) {  // the same parameters as they are now (12.5)
        --frame.runs_left;
        x.calls.again();
        x.run.jumped = true;
        return true;
    }
    const std::int32_t code = frame.m_itself ? frame.m_code : -1;
    const std::int32_t done = frame.reads_again ? frame.m_code : -1;
    pop_frame(x);
    if (done >= 0) x.modal.m_done = done;
    if (code >= 0) {
        char text[16];
        const int length = std::snprintf(text, sizeof text, "M%d", code);
        x.core.aux('M', code, {text, static_cast<std::size_t>(length)}, false);
        x.core.end_block();
    }
    return true;
}

bool inside_modal_call(const Execution& x) {
    for (const CallFrame& frame : x.calls.frames())
        if (frame.modal) return true;
    return false;
}

bool run_modal_call(Execution& x, std::int64_t repeats) {
    if (repeats < 1) return true;
    const ModalCall call = x.modal.modal_call;
    CallFrame frame;
    frame.modal = true;
    frame.given = call.given;
    // N does not count (12.7)
    if (call.kind == ModalCall::Kind::Program) return call_program(x, call.number, frame);
    frame.runs_left = repeats - 1;
    return call_subroutine(x, call.number, frame, &call.arguments);
}

}  // namespace polyturn::channels::fagor
