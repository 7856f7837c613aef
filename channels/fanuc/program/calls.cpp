#include "channels/fanuc/program/calls.hpp"

#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/macro/modal_values.hpp"
#include "channels/fanuc/program/interrupts.hpp"
#include "channels/fanuc/program/search.hpp"

namespace polyturn::channels::fanuc {

void look_whether_hidden(Execution& x) {
    const std::int64_t program = x.calls.frames.back().program;
    const bool hidden =
        x.calls.frames.size() > 1 &&
        ((program >= 8000 && program <= 8999 && (x.settings.hidden_programs & 1u)) ||
         (program >= 9000 && program <= 9999 && (x.settings.hidden_programs & 2u)));
    if (hidden == x.calls.hidden) return;
    x.calls.hidden = hidden;
    if (x.run.keeps_states) tell_control(x);
}

bool call_levels_left(Execution& x, bool macro, bool modal, char letter) {
    unsigned subs = 0, macros = 0;
    for (std::size_t i = 1; i < x.calls.frames.size(); ++i)
        if (!x.calls.frames[i].interrupt) ++(x.calls.frames[i].macro ? macros : subs);
    if (macro && macros >= x.settings.macro_levels)
        return x.core.fail(modal || x.settings.policy.macro.alarm_of_macro_depth
                               ? Alarm::MacroTooDeep
                               : Alarm::CallTooDeep,
                           letter, {}, x.settings.macro_levels);
    if (!macro && subs >= x.settings.sub_levels)
        return x.core.fail(Alarm::CallTooDeep, letter, {}, x.settings.sub_levels);
    return true;
}

// The next block is the first one of that program, at its O number or at the beginning of the text.
bool enter_program(Execution& x, FileId file, std::int64_t number, std::int64_t repeats,
                   const LocalSet* arguments, bool by_code, bool modal) {
    CallLevel frame;
    frame.file = file;
    if (const auto begin = find_program_in(x, file, number)) frame.begin = *begin;
    frame.resume = place_behind(x, x.text.behind);
    frame.repeats = repeats - 1;
    frame.macro = arguments != nullptr;
    frame.by_code = by_code;
    frame.modal_call = modal;
    frame.loops = x.calls.loops.size();
    frame.outer_program = x.modal.program.number;
    frame.program = number;
    if (arguments) {
        frame.arguments = *arguments;
        x.macro.variables.push_locals(*arguments);
    }
    frame.outer_modals = x.calls.modal;
    if (modal) x.calls.modal.pop_back();
    x.text.source = &x.files.source(frame.file);
    x.text.source->seek(frame.begin);
    x.calls.frames.push_back(std::move(frame));
    look_whether_hidden(x);
    x.modal.program.blocks_begun = false;
    x.text.line_left = false;
    x.run.jumped = true;
    return true;
}

bool call_program(Execution& x, std::int64_t number, std::int64_t repeats,
                  const LocalSet* arguments, bool by_code, bool modal, char letter) {
    if (repeats < 1) return true;
    if (!call_levels_left(x, arguments != nullptr, modal, letter)) return false;
    // by its name
    if (number < 0)
        return enter_program(x, static_cast<FileId>(-1 - number), 0, repeats, arguments, by_code,
                             modal);
    if (const auto file = x.files.find_number(number))
        return enter_program(x, *file, number, repeats, arguments, by_code, modal);
    if (find_program_in(x, x.calls.frames.back().file, number))
        return enter_program(x, x.calls.frames.back().file, number, repeats, arguments, by_code,
                             modal);
    return x.core.fail(Alarm::SubprogramMissing, letter, "O" + std::to_string(number));
}

// M97 P300: the watch for interrupts ends, and the program goes on at N300 of the same text, to M99
// and then behind this block. The specification knows M97 without P only; controls of this family
// call a part of the program so.
bool call_part(Execution& x, std::int64_t number) {
    if (x.run.ended) return true;
    if (!call_levels_left(x, false, false, 'P')) return false;
    const CallLevel& here = x.calls.frames.back();
    const FileId file = here.file;
    const TextPosition begin = here.begin;
    const std::int64_t program = here.program;
    const auto found = find_block(x, number);
    if (!found) return x.core.fail(Alarm::SequenceNumberMissing, 'P', std::to_string(number));
    x.run.called = true;
    CallLevel frame;
    frame.file = file;
    frame.begin = begin;  // jumps look through the whole program
    frame.resume = place_behind(x, x.text.behind);
    frame.loops = x.calls.loops.size();
    frame.outer_program = x.modal.program.number;
    frame.program = program;
    frame.outer_modals = x.calls.modal;
    x.calls.frames.push_back(std::move(frame));
    x.text.line_left = false;
    go_on_at(x, *found);
    return true;
}

// M99: the next repetition, the caller, or (in the main program) the end of a part.
bool return_from_program(Execution& x, bool has_target, std::int64_t target) {
    CallLevel& frame = x.calls.frames.back();
    if (x.calls.frames.size() == 1) {
        if (has_target) return jump_to_block(x, target);
        x.core.mark_emitted();
        x.core.sink().part(++x.modal.parts, x.core.at);
        x.run.ended = true;
        return true;
    }
    if (frame.interrupt) return return_from_interrupt(x, has_target, target);
    x.calls.loops.resize(frame.loops);
    if (frame.repeats > 0 && !has_target) {
        --frame.repeats;
        // those of G66 are given once (fanuc_lathe 6.9.3)
        if (frame.macro && !frame.modal_call) x.macro.variables.locals() = frame.arguments;
        x.text.source->seek(frame.begin);
        x.modal.program.blocks_begun = false;
        x.run.jumped = true;
        x.text.line_left = false;
        return true;
    }
    CallLevel done = std::move(frame);
    x.calls.frames.pop_back();
    look_whether_hidden(x);
    // the next call goes on with them
    if (done.modal_call && !done.outer_modals.empty())
        done.outer_modals.back().arguments = x.macro.variables.locals();
    if (done.macro) x.macro.variables.pop_locals();
    if (done.modal_call) x.calls.modal = std::move(done.outer_modals);
    x.modal.program.number = done.outer_program;
    x.text.source = &x.files.source(x.calls.frames.back().file);
    go_on_at(x, done.resume);
    x.modal.program.blocks_begun = true;
    return has_target ? jump_to_block(x, target) : true;
}

// Another program in the place of this one: it ends where this one would have ended. False: there
// is none.
bool go_on_with(Execution& x, std::int64_t number) {
    auto file = x.files.find_number(number);
    if (!file && find_program_in(x, x.calls.frames.back().file, number))
        file = x.calls.frames.back().file;
    if (!file) return false;
    CallLevel& frame = x.calls.frames.back();
    x.calls.loops.resize(frame.loops);
    frame.file = *file;
    frame.program = number;
    frame.begin = find_program_in(x, *file, number).value_or(TextPosition{});
    x.text.source = &x.files.source(*file);
    x.text.source->seek(frame.begin);
    look_whether_hidden(x);
    x.modal.program.blocks_begun = x.modal.program.tape_begun = x.text.line_left = false;
    x.run.jumped = true;
    return true;
}

}  // namespace polyturn::channels::fanuc
