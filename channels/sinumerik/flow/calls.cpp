// Subprograms: finding them, passing parameters, returning; sections that REPEAT runs.
#include <algorithm>

#include "channels/sinumerik/interpreter.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr std::size_t kMostLevels = 16;  // program levels

}  // namespace

// The text between the brackets of a call. Which of the arguments are variables by reference the
// PROC line says.
bool Interpreter::read_program_arguments(const std::string&, std::vector<Argument>& arguments) {
    if (!cursor_.eat('(')) return true;
    if (cursor_.eat(')')) return true;
    for (;;) {
        Argument argument;
        const char next = cursor_.peek();
        argument.column = cursor_.column(cursor_.at());
        if (next != ',' && next != ')') {
            const char* const from = cursor_.at();
            if (!reference_ahead(argument.reference)) return false;
            const char behind = cursor_.peek();
            if (argument.reference && argument.reference.component.empty() &&
                (behind == ',' || behind == ')')) {
                if (!argument.reference.whole || argument.reference.variable->dimensions.empty())
                    argument.value = argument.reference.cell();
            } else {
                argument.reference = {};
                cursor_.at() = from;
                if (!expression(argument.value)) return false;
            }
            argument.given = true;
        }
        arguments.push_back(std::move(argument));
        if (cursor_.eat(')')) return true;
        if (!cursor_.eat(',')) return syntax(cursor_.at(), ")");
        if (arguments.size() > 127) return fail_at(Alarm::ArgumentCountIllegal, cursor_.at(), 1);
    }
}

bool Interpreter::call_program(const std::string& name, std::vector<Argument> arguments,
                               std::int64_t repeats, bool modal) {
    if (repeats < 1) return true;
    if (repeats > 9999) return fail(Alarm::RepeatsIllegal, name, static_cast<double>(repeats));
    std::size_t depth = 0;
    for (const Level& level : levels_) depth += !level.section;
    if (depth >= kMostLevels) return fail(Alarm::CallTooDeep, name, kMostLevels);
    auto file = files_->find_name(name);
    for (const char* suffix : {".SPF", ".MPF", "_SPF", "_MPF"})
        if (!file) file = files_->find_name(name + suffix);
    if (!file) return fail(Alarm::SubprogramMissing, name);
    Level level;
    level.file = *file;
    level.name = name;
    level.call = here_;
    level.resume = source_->next_position();
    level.repeats = repeats - 1;
    level.modal_call = modal;
    level.scope = std::make_shared<Scope>();
    const std::string line = line_;
    const Cursor cursor = cursor_;
    const bool bound = bind_parameters(*file, name, arguments, level);
    line_ = line;
    (void)cursor;
    if (!bound) return false;
    if (level.save) level.saved = std::make_shared<const Modal>(modal_);
    source_ = &files_->source(*file);
    source_->seek(level.begin);
    levels_.push_back(std::move(level));
    called_ = jumped_ = state_changed_ = true;
    tell_single_block();
    return true;
}

// The PROC line of a program, if it has one: parameters, their types and defaults, SAVE.
// level.begin is set behind it.
bool Interpreter::bind_parameters(FileId file, const std::string& name,
                                  std::vector<Argument>& arguments, Level& level) {
    LineSource& source = files_->source(file);
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
               fail(Alarm::ArgumentCountIllegal, name, static_cast<double>(arguments.size()));
    // Read it with the caller's cursor put aside.
    const Cursor cursor = cursor_;
    const std::string line = line_;
    line_ = proc;
    cursor_ = Cursor(line_);
    const bool ok = read_proc(name, arguments, level);
    line_ = line;
    cursor_ = cursor;
    return ok;
}

bool Interpreter::read_proc(const std::string& name, std::vector<Argument>& arguments,
                            Level& level) {
    if (upper(cursor_.peek()) == 'N' && is_digit(cursor_.next_raw(1))) {
        cursor_.advance(1);
        while (is_digit(cursor_.next_raw())) cursor_.advance(1);
    }
    cursor_.advance(cursor_.name_ahead().size());  // PROC
    if (cursor_.peek() == '_' || is_letter(cursor_.peek()))
        cursor_.advance(cursor_.name_ahead().size());
    else
        return syntax(cursor_.at(), "PROC");
    std::size_t i = 0;
    if (cursor_.eat('(') && !cursor_.eat(')')) {
        for (;; ++i) {
            bool by_reference = false;
            if (upper(cursor_.name_ahead()) == "VAR") {
                by_reference = true;
                cursor_.advance(3);
            }
            auto variable = std::make_shared<Variable>();
            if (!parse_type(variable->type, variable->text_length)) return false;
            const char* const at = cursor_.at();
            variable->name = upper(cursor_.name_ahead());
            if (variable->name.empty()) return syntax(at);
            cursor_.advance(variable->name.size());
            bool array = false;
            if (cursor_.eat('[')) {
                array = true;
                while (!cursor_.eat(']')) {
                    if (cursor_.at_end()) return syntax(cursor_.at(), "]");
                    cursor_.advance(1);
                }
            }
            Argument argument;
            if (i < arguments.size()) argument = arguments[i];
            if (cursor_.at_assign()) {
                cursor_.advance(1);
                Value value;
                if (!expression(value)) return false;
                if (!argument.given) {
                    argument.value = value;
                    argument.given = true;
                }
            }
            if (by_reference) {
                if (!argument.reference)
                    return fail(i < arguments.size() && argument.given ? Alarm::ArgumentNoVariable
                                                                       : Alarm::ArgumentMissing,
                                name, static_cast<double>(i + 1));
                if (argument.reference.variable->type != variable->type)
                    return fail(
                        Alarm::ArgumentTypeIllegal,
                        name + ": " + std::string(type_name(argument.reference.variable->type)),
                        static_cast<double>(i + 1));
                argument.reference.whole = array;
                level.scope->names[variable->name] = argument.reference;
            } else {
                if (!argument.given) {
                    if (variable->type == Type::Axis)
                        return fail(Alarm::AxisArgumentMissing, name, static_cast<double>(i + 1));
                    argument.value = {};
                    argument.value.type = variable->type;
                    if (variable->type == Type::Frame) argument.value = Value::of_frame({});
                }
                if (!convert(argument.value, variable->type))
                    return fail(Alarm::ArgumentTypeIllegal,
                                name + ": " + std::string(type_name(argument.value.type)),
                                static_cast<double>(i + 1));
                variable->cells.assign(1, argument.value);
                level.scope->names[variable->name] = {variable, 0, true};
            }
            if (cursor_.eat(')')) break;
            if (!cursor_.eat(',')) return syntax(cursor_.at(), ")");
        }
        ++i;
    }
    if (arguments.size() > i)
        return fail(Alarm::ArgumentCountIllegal, name, static_cast<double>(arguments.size()));
    while (!cursor_.at_end()) {
        const std::string attribute = upper(cursor_.name_ahead());
        if (attribute.empty()) return syntax(cursor_.at());
        if (attribute == "SAVE")
            level.save = true;
        else if (attribute == "SBLOF")
            level.hides_steps = true;
        else if (attribute == "DISPLOF")
            // the running block is shown always
            without_effect(attribute, 0, 0);
        else if (attribute != "DISPLON" && attribute != "SBLON" && attribute != "PREPRO" &&
                 attribute != "ACTBLOCNO")
            return syntax(cursor_.at(), attribute);
        cursor_.advance(attribute.size());
    }
    return true;
}

// M17, RET, M2 or M30 in a subprogram, its end: the next run, or the caller.
bool Interpreter::return_from_level() {
    while (levels_.back().section) levels_.pop_back();
    Level& level = levels_.back();
    called_ = jumped_ = state_changed_ = true;
    if (level.repeats > 0) {
        --level.repeats;
        fresh_ = false;  // a repetition asks the machine anew, as a loop does
        source_->seek(level.begin);
        return true;
    }
    const Level done = std::move(levels_.back());
    levels_.pop_back();
    source_ = &files_->source(levels_.back().file);
    source_->seek(done.resume);
    here_ = done.call;
    modal_.holes = done.holes;
    tell_single_block();
    if (done.interrupt) {
        core_.path.programmed = done.begin_of_block;
        arm_interrupts();  // no signal counts while the routine runs
    }
    return done.saved ? restore_modal(*done.saved) : true;
}

// PROC ... SAVE: modal G commands and the programmable frame are those of the caller again.
bool Interpreter::restore_modal(const Modal& saved) {
    for (unsigned group = 1; group < kGroups; ++group) {
        if (modal_.active[group] == saved.active[group]) continue;
        const GCode* code = find_g(group, saved.active[group]);
        if (!code || !code->modal) continue;
        if (group != 1 && code->act && !(this->*code->act)(*code)) return false;
        modal_.active[group] = saved.active[group];
    }
    modal_.feed = saved.feed;
    modal_.feed_per_tooth = saved.feed_per_tooth;
    const Frame &now = modal_.geo.exact, &before = saved.geo.exact;
    if (now.linear != before.linear || now.shift != before.shift || now.scale != before.scale ||
        now.offset != before.offset) {
        modal_.geo.frame = saved.geo.frame;
        modal_.geo.exact = saved.geo.exact;
        use_frame();
    }
    return true;
}

bool Interpreter::run_section(TextPosition from, std::uint64_t end, std::int64_t repeats,
                              bool block_only) {
    if (repeats < 1) return true;
    if (levels_.size() >= 4 * kMostLevels)
        return fail(Alarm::CallTooDeep, "REPEAT", 4 * kMostLevels);
    Level level;
    level.file = levels_.back().file;
    level.section = true;
    level.block_only = block_only;
    level.begin = from;
    level.end = end;
    level.call = here_;
    level.resume = source_->next_position();
    level.repeats = repeats - 1;
    level.name = levels_.back().name;
    level.scope = levels_.back().scope;
    levels_.push_back(std::move(level));
    called_ = true;
    seek(from);
    return true;
}

// CALL name BLOCK first TO last: this section of another program; behind it the end of that program
// is next.
bool Interpreter::call_section(const std::string& name, const std::string& first,
                               const std::string& last) {
    if (!call_program(name, {}, 1, false)) return false;
    const TextIndex& index = index_of(levels_.back().file);
    const std::vector<TextPosition>* const begins = index.label(first);
    const std::vector<TextPosition>* const ends = index.label(last);
    const TextPosition* stop = nullptr;
    if (begins && ends)
        for (const TextPosition& place : *ends)
            if (!stop && place.offset >= begins->front().offset) stop = &place;
    if (!stop) return fail(Alarm::JumpTargetMissing, begins ? last : first);
    std::string_view text;
    source_->seek(*stop);
    if (source_->next(text) != LineSource::Status::Line) return fail(Alarm::FileUnreadable);
    const std::uint64_t end = source_->next_position().offset;
    while (source_->next(text) == LineSource::Status::Line) {}
    return run_section(begins->front(), end, 1, false);
}

// A jump out of a repeated section ends its repetitions.
void Interpreter::leave_sections(std::uint64_t offset) {
    while (levels_.back().section &&
           (offset < levels_.back().begin.offset || offset >= levels_.back().end))
        levels_.pop_back();
}

}  // namespace polyturn::channels::sinumerik
