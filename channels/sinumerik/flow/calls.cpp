// Subprograms: finding them, passing parameters, returning; sections that REPEAT runs.
#include "channels/sinumerik/flow/calls.hpp"

#include "channels/sinumerik/coordination/procedures.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/interrupts.hpp"
#include "channels/sinumerik/flow/jumps.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/frames/settable_frames.hpp"
#include "channels/sinumerik/grammar/expression.hpp"
#include "channels/sinumerik/grammar/without_effect.hpp"
#include "channels/sinumerik/variables/declarations.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::size_t kMostLevels = 16;  // program levels

// The PROC line of a program, if it has one: parameters, their types and defaults, SAVE.
// level.begin is set behind it.
bool bind_parameters(Execution& x, FileId file, const std::string& name,
                     std::vector<Argument>& arguments, Level& level) {
    LineSource& source = x.files.source(file);
    const TextPosition back = source.next_position();
    source.seek({0, 1});
    std::string_view text;
    std::string proc;
    while (source.next(text) == LineSource::Status::Line) {
        Cursor cursor(text);
        if (cursor.at_end() || cursor.peek() == '%') continue;
        if ((cursor.peek() == 'N' || cursor.peek() == 'n') && is_digit(cursor.next_raw(1))) {
            cursor.advance(1);
            while (is_digit(cursor.next_raw())) cursor.advance(1);
        }
        if (upper(cursor.name_ahead()) == "PROC") {
            proc = text;
            level.begin = source.next_position();
        }
        break;
    }
    source.seek(back);
    if (proc.empty())
        return arguments.empty() ||
               fail(x, Alarm::ArgumentCountIllegal, name, static_cast<double>(arguments.size()));
    // Read it with the caller's cursor put aside.
    const Cursor cursor = x.line.cursor;
    const std::string line = x.line.text;
    x.line.text = proc;
    x.line.cursor = Cursor(x.line.text);
    const bool ok = read_proc(x, name, arguments, level);
    x.line.text = line;
    x.line.cursor = cursor;
    return ok;
}

// PROC ... SAVE: modal G commands and the programmable frame are those of the caller again.
bool restore_modal(Execution& x, const Modal& saved) {
    for (unsigned group = 1; group < kGroups; ++group) {
        if (x.modal.active[group] == saved.active[group]) continue;
        const GCode* code = find_g(group, saved.active[group]);
        if (!code || !code->modal) continue;
        if (group != 1 && code->act && !code->act(x, *code)) return false;
        x.modal.active[group] = saved.active[group];
    }
    x.modal.feed = saved.feed;
    x.modal.feed_per_tooth = saved.feed_per_tooth;
    const Frame &now = x.modal.geo.exact, &before = saved.geo.exact;
    if (now.linear != before.linear || now.shift != before.shift || now.scale != before.scale ||
        now.offset != before.offset) {
        x.modal.geo.frame = saved.geo.frame;
        x.modal.geo.exact = saved.geo.exact;
        use_frame(x);
    }
    return true;
}

}  // namespace

bool call_program(Execution& x, const std::string& name, std::vector<Argument> arguments,
                  std::int64_t repeats, bool modal) {
    if (repeats < 1) return true;
    if (repeats > 9999) return fail(x, Alarm::RepeatsIllegal, name, static_cast<double>(repeats));
    std::size_t depth = 0;
    for (const Level& level : x.calls.levels) depth += !level.section;
    if (depth >= kMostLevels) return fail(x, Alarm::CallTooDeep, name, kMostLevels);
    auto file = x.files.find_name(name);
    for (const char* suffix : {".SPF", ".MPF", "_SPF", "_MPF"})
        if (!file) file = x.files.find_name(name + suffix);
    if (!file) return fail(x, Alarm::SubprogramMissing, name);
    Level level;
    level.file = *file;
    level.name = name;
    level.call = x.line.here;
    level.resume = x.calls.source->next_position();
    level.repeats = repeats - 1;
    level.modal_call = modal;
    level.scope = std::make_shared<Scope>();
    const std::string line = x.line.text;
    const Cursor cursor = x.line.cursor;
    const bool bound = bind_parameters(x, *file, name, arguments, level);
    x.line.text = line;
    (void)cursor;
    if (!bound) return false;
    if (level.save) level.saved = std::make_shared<const Modal>(x.modal);
    x.calls.source = &x.files.source(*file);
    x.calls.source->seek(level.begin);
    x.calls.levels.push_back(std::move(level));
    x.run.called = x.run.jumped = x.run.state_changed = true;
    tell_single_block(x);
    return true;
}

bool read_proc(Execution& x, const std::string& name, std::vector<Argument>& arguments,
               Level& level) {
    if (upper(x.line.cursor.peek()) == 'N' && is_digit(x.line.cursor.next_raw(1))) {
        x.line.cursor.advance(1);
        while (is_digit(x.line.cursor.next_raw())) x.line.cursor.advance(1);
    }
    x.line.cursor.advance(x.line.cursor.name_ahead().size());  // PROC
    if (x.line.cursor.peek() == '_' || is_letter(x.line.cursor.peek()))
        x.line.cursor.advance(x.line.cursor.name_ahead().size());
    else
        return syntax(x, x.line.cursor.at(), "PROC");
    std::size_t i = 0;
    if (x.line.cursor.eat('(') && !x.line.cursor.eat(')')) {
        for (;; ++i) {
            bool by_reference = false;
            if (upper(x.line.cursor.name_ahead()) == "VAR") {
                by_reference = true;
                x.line.cursor.advance(3);
            }
            auto variable = std::make_shared<Variable>();
            if (!parse_type(x, variable->type, variable->text_length)) return false;
            const char* const at = x.line.cursor.at();
            variable->name = upper(x.line.cursor.name_ahead());
            if (variable->name.empty()) return syntax(x, at);
            x.line.cursor.advance(variable->name.size());
            bool array = false;
            if (x.line.cursor.eat('[')) {
                array = true;
                while (!x.line.cursor.eat(']')) {
                    if (x.line.cursor.at_end()) return syntax(x, x.line.cursor.at(), "]");
                    x.line.cursor.advance(1);
                }
            }
            Argument argument;
            if (i < arguments.size()) argument = arguments[i];
            if (x.line.cursor.at_assign()) {
                x.line.cursor.advance(1);
                Value value;
                if (!expression(x, value)) return false;
                if (!argument.given) {
                    argument.value = value;
                    argument.given = true;
                }
            }
            if (by_reference) {
                if (!argument.reference)
                    return fail(x,
                                i < arguments.size() && argument.given ? Alarm::ArgumentNoVariable
                                                                       : Alarm::ArgumentMissing,
                                name, static_cast<double>(i + 1));
                if (argument.reference.variable->type != variable->type)
                    return fail(
                        x, Alarm::ArgumentTypeIllegal,
                        name + ": " + std::string(type_name(argument.reference.variable->type)),
                        static_cast<double>(i + 1));
                argument.reference.whole = array;
                level.scope->names[variable->name] = argument.reference;
            } else {
                if (!argument.given) {
                    if (variable->type == Type::Axis)
                        return fail(x, Alarm::AxisArgumentMissing, name,
                                    static_cast<double>(i + 1));
                    argument.value = {};
                    argument.value.type = variable->type;
                    if (variable->type == Type::Frame) argument.value = Value::of_frame({});
                }
                if (!convert(argument.value, variable->type))
                    return fail(x, Alarm::ArgumentTypeIllegal,
                                name + ": " + std::string(type_name(argument.value.type)),
                                static_cast<double>(i + 1));
                variable->cells.assign(1, argument.value);
                level.scope->names[variable->name] = {variable, 0, true};
            }
            if (x.line.cursor.eat(')')) break;
            if (!x.line.cursor.eat(',')) return syntax(x, x.line.cursor.at(), ")");
        }
        ++i;
    }
    if (arguments.size() > i)
        return fail(x, Alarm::ArgumentCountIllegal, name, static_cast<double>(arguments.size()));
    while (!x.line.cursor.at_end()) {
        const std::string attribute = upper(x.line.cursor.name_ahead());
        if (attribute.empty()) return syntax(x, x.line.cursor.at());
        if (attribute == "SAVE")
            level.save = true;
        else if (attribute == "SBLOF")
            level.hides_steps = true;
        else if (attribute == "DISPLOF")
            // the running block is shown always
            without_effect(x, attribute, 0, 0);
        else if (attribute != "DISPLON" && attribute != "SBLON" && attribute != "PREPRO" &&
                 attribute != "ACTBLOCNO")
            return syntax(x, x.line.cursor.at(), attribute);
        x.line.cursor.advance(attribute.size());
    }
    return true;
}

// M17, RET, M2 or M30 in a subprogram, its end: the next run, or the caller.
bool return_from_level(Execution& x) {
    while (x.calls.levels.back().section) x.calls.levels.pop_back();
    Level& level = x.calls.levels.back();
    x.run.called = x.run.jumped = x.run.state_changed = true;
    if (level.repeats > 0) {
        --level.repeats;
        x.run.fresh = false;  // a repetition asks the machine anew, as a loop does
        x.calls.source->seek(level.begin);
        return true;
    }
    const Level done = std::move(x.calls.levels.back());
    x.calls.levels.pop_back();
    x.calls.source = &x.files.source(x.calls.levels.back().file);
    x.calls.source->seek(done.resume);
    x.line.here = done.call;
    x.modal.holes = done.holes;
    tell_single_block(x);
    if (done.interrupt) {
        x.core.path.programmed = done.begin_of_block;
        arm_interrupts(x);  // no signal counts while the routine runs
    }
    return done.saved ? restore_modal(x, *done.saved) : true;
}

bool run_section(Execution& x, TextPosition from, std::uint64_t end, std::int64_t repeats,
                 bool block_only) {
    if (repeats < 1) return true;
    if (x.calls.levels.size() >= 4 * kMostLevels)
        return fail(x, Alarm::CallTooDeep, "REPEAT", 4 * kMostLevels);
    Level level;
    level.file = x.calls.levels.back().file;
    level.section = true;
    level.block_only = block_only;
    level.begin = from;
    level.end = end;
    level.call = x.line.here;
    level.resume = x.calls.source->next_position();
    level.repeats = repeats - 1;
    level.name = x.calls.levels.back().name;
    level.scope = x.calls.levels.back().scope;
    x.calls.levels.push_back(std::move(level));
    x.run.called = true;
    seek(x, from);
    return true;
}

// CALL name BLOCK first TO last: this section of another program; behind it the end of that program
// is next.
bool call_section(Execution& x, const std::string& name, const std::string& first,
                  const std::string& last) {
    if (!call_program(x, name, {}, 1, false)) return false;
    const TextIndex& index = index_of(x, x.calls.levels.back().file);
    const std::vector<TextPosition>* const begins = index.label(first);
    const std::vector<TextPosition>* const ends = index.label(last);
    const TextPosition* stop = nullptr;
    if (begins && ends)
        for (const TextPosition& place : *ends)
            if (!stop && place.offset >= begins->front().offset) stop = &place;
    if (!stop) return fail(x, Alarm::JumpTargetMissing, begins ? last : first);
    std::string_view text;
    x.calls.source->seek(*stop);
    if (x.calls.source->next(text) != LineSource::Status::Line)
        return fail(x, Alarm::FileUnreadable);
    const std::uint64_t end = x.calls.source->next_position().offset;
    while (x.calls.source->next(text) == LineSource::Status::Line) {}
    return run_section(x, begins->front(), end, 1, false);
}

// A jump out of a repeated section ends its repetitions.
void leave_sections(Execution& x, std::uint64_t offset) {
    while (x.calls.levels.back().section &&
           (offset < x.calls.levels.back().begin.offset || offset >= x.calls.levels.back().end))
        x.calls.levels.pop_back();
}

}  // namespace polyturn::channels::sinumerik
