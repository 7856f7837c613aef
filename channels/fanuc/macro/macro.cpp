// Statements of custom macro B: assignments, IF, WHILE, DO, END, GOTO.
#include <algorithm>
#include <cmath>

#include "channels/fanuc/interpreter.hpp"
#include "channels/text/chars.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Past blanks and comments, which may stand in a statement wherever blanks may (fanuc_lathe 6.4).
void gap(const char*& at, const char* end) {
    blanks(at, end);
    if (at != end && *at == '(') skip_comments(at, end);
}

// Takes the word at `at` if it is `name`, or two and more of its first letters where no further
// letter stands (WH for WHILE).
bool take(const char*& at, const char* end, std::string_view name) {
    gap(at, end);
    const char* p = at;
    std::size_t letters = 0;
    while (letters < name.size() && p != end && capital(*p) == name[letters]) {
        ++p;
        ++letters;
    }
    if (letters < name.size() && (letters < 2 || (p != end && is_letter(*p)))) return false;
    at = p;
    return true;
}

// Word of output statements and names that `letters` is, or is the beginning of.
std::string_view statement_name(std::string_view letters) {
    for (const std::string_view name : {"POPEN", "PCLOS", "DPRNT", "BPRNT", "SETVN"})
        if (letters.size() >= 2 && name.starts_with(letters)) return name;
    return {};
}

// The text of a comment that begins at `at`, for #3000=1(TEXT).
std::string_view comment_text(const char*& at, const char* end) {
    blanks(at, end);
    if (at == end || *at != '(') return {};
    const char* const begin = ++at;
    while (at != end && *at != ')') ++at;
    const std::string_view text(begin, static_cast<std::size_t>(at - begin));
    if (at != end) ++at;
    return text;
}

}  // namespace

Interpreter::Flow Interpreter::flow_fault(Alarm alarm, const char* at, std::string detail,
                                          double value) {
    fault_column_ = static_cast<std::uint32_t>(at - line_.data()) + 1;
    fault_length_ = 1;
    core_.fail(alarm, 0, std::move(detail), value);
    return Flow::Fault;
}

Interpreter::Flow Interpreter::flow_of(Expression::Status status) {
    if (status == Expression::Status::Ok) return Flow::Done;
    if (status == Expression::Status::NeedsBarrier) return Flow::NeedsBarrier;
    const ExpressionFault& f = expression_.fault();
    return flow_fault(f.alarm, f.at, f.detail, f.value);
}

Interpreter::Flow Interpreter::evaluate(const char*& at, const char* end, double& value) {
    return flow_of(expression_.evaluate(at, end, value));
}

// The scanner's question: a value behind an address.
ScanHook::Read Interpreter::read_value(const char*& at, const char* end, double& value) {
    if (settings_.mefi) {
        pending_fault_ = {Alarm::NotBuilt, 0, 0.0, 0.0, "expressions in mefi", std::nullopt};
        has_pending_fault_ = true;
        fault_column_ = static_cast<std::uint32_t>(at - line_.data()) + 1;
        fault_length_ = 1;
        return Read::Fault;
    }
    // The word that is being read follows the last one counted.
    const char address =
        block_.count < Block::kMaxWords ? block_.words[block_.count].address : '\0';
    expression_.round_to(settings_.nct ? 1.0 : rounding_step(address));
    const Expression::Status status = expression_.operand(at, end, value);
    expression_.round_to(1.0);
    switch (status) {
        case Expression::Status::Ok:
            // whole codes (fanuc_lathe 6.1)
            if (!settings_.nct && (address == 'G' || address == 'M' || address == 'T'))
                value = std::round(value);
            return is_null(value) ? Read::Null : Read::Value;
        case Expression::Status::NeedsBarrier:
            return Read::NeedsBarrier;
        case Expression::Status::Fault:
            break;
    }
    const ExpressionFault& f = expression_.fault();
    pending_fault_ = {f.alarm, 0, f.value, 0.0, f.detail, std::nullopt};
    has_pending_fault_ = true;
    fault_column_ = static_cast<std::uint32_t>(f.at - line_.data()) + 1;
    fault_length_ = 1;
    return Read::Fault;
}

// What ROUND rounds to within an address: the least increment of it (fanuc_lathe 6.4).
double Interpreter::rounding_step(char address) const {
    constexpr std::uint32_t kLengths = letter_set("IJKREF");
    if (address < 'A' || address > 'Z') return 1.0;
    const auto letter = static_cast<std::size_t>(address - 'A');
    const int place =
        absolute_axis_[letter] >= 0 ? absolute_axis_[letter] : incremental_axis_[letter];
    if (place < 0 && !(kLengths & letter_bit(address))) return 1.0;
    if (address == 'F')
        return core_.path.feed_mode == FeedMode::PerRevolution ? (inch_ ? 1e-6 : 1e-4) : 1.0;
    const ChannelAxis& axis = core_.view().axes[place < 0 ? 0 : static_cast<std::size_t>(place)];
    return axis.increment * (inch_ && !axis.rotary ? 0.1 : 1.0);
}

Step Interpreter::macro_statement(std::size_t from) {
    jumped_ = called_ = wants_barrier_ = false;
    core_.at.statement = !settings_.stops_at_macros;  // fanuc_lathe 6.7
    bool ends = false;
    if (const std::uint8_t number = loop_word(line_.substr(from), ends);
        number && !ends && !loops_nest(number, from))
        return fault(core_.fault());
    const char* at = line_.data() + from;
    const char* const end = line_.data() + line_.size();
    const std::size_t next = next_block(line_, from);
    line_left_ = next != std::string_view::npos;
    behind_ = next;
    Flow flow = run_statement(at, end);
    if (flow == Flow::Done && !jumped_) {
        gap(at, end);
        if (at != end && *at == '(')
            flow = flow_fault(Alarm::CommentOpen, at);
        else if (at != end && *at != ';')
            flow = flow_fault(Alarm::MacroFormat, at, std::string(at, end));
        else
            column_ = next;
    }
    if (flow == Flow::NeedsBarrier) {
        read_value_barrier();
        return Step::AtBarrier;
    }
    if (flow == Flow::Fault) return fault(core_.fault());
    if (core_.emitted()) {
        fresh_ = false;
        core_.end_block();
    }
    if (ended_) return Step::Ended;
    // the machine comes here, so that it can stand here
    if (settings_.stops_at_macros && !core_.reads_ahead() && keep_states_) {
        core_.sink().block_end(core_.at);
        wants_barrier_ = true;
    }
    return wants_barrier_ ? Step::AtBarrier : Step::Continue;
}

Interpreter::Flow Interpreter::run_statement(const char*& at, const char* end) {
    gap(at, end);
    if (at == end) return Flow::Done;
    if (*at == '#' || *at == '[') return assignment(at, end);
    const char* const begin = at;
    if (take(at, end, "IF")) {
        bool holds = false;
        if (const Flow flow = condition(at, end, holds); flow != Flow::Done) return flow;
        if (take(at, end, "GOTO")) {
            if (holds) return jump(at, end);
            double ignored = 0.0;
            gap(at, end);
            return at != end && (*at == '#' || *at == '[')
                       ? flow_of(expression_.operand(at, end, ignored))
                       : evaluate(at, end, ignored);
        }
        if (!take(at, end, "THEN"))
            return flow_fault(Alarm::MacroFormat, at, "IF without GOTO or THEN");
        if (!holds) {
            at = end;
            return Flow::Done;
        }
        gap(at, end);
        const char* word = at;
        if (at == end || take(word, end, "IF") || take(word, end, "WHILE") ||
            take(word, end, "DO") || take(word, end, "END"))
            return flow_fault(Alarm::MacroFormat, at, "THEN takes one statement, and no loop");
        return run_statement(at, end);
    }
    if (take(at, end, "GOTO")) return jump(at, end);
    if (take(at, end, "WHILE")) {
        bool holds = false;
        const TextPlace here(source_->position(), column_);
        if (const Flow flow = condition(at, end, holds); flow != Flow::Done) return flow;
        if (!take(at, end, "DO")) return flow_fault(Alarm::MacroFormat, at, "WHILE without DO");
        std::uint8_t number = 0;
        if (const Flow flow = loop_number(at, end, number); flow != Flow::Done) return flow;
        // A loop that is entered again (jumped out of, or the next round) replaces its old entry
        // and what was inside.
        while (loops_.size() > frames_.back().loops && loops_.back().number == number)
            loops_.pop_back();
        if (!holds) return skip_loop(number, begin);
        loops_.push_back({number, here});
        return Flow::Done;
    }
    if (take(at, end, "DO")) {
        std::uint8_t number = 0;
        if (const Flow flow = loop_number(at, end, number); flow != Flow::Done) return flow;
        while (loops_.size() > frames_.back().loops && loops_.back().number == number)
            loops_.pop_back();
        loops_.push_back({number, TextPlace(source_->position(), column_)});
        return Flow::Done;
    }
    if (take(at, end, "END")) {
        std::uint8_t number = 0;
        if (const Flow flow = loop_number(at, end, number); flow != Flow::Done) return flow;
        std::size_t found = loops_.size();
        while (found > frames_.back().loops && loops_[found - 1].number != number) --found;
        if (found == frames_.back().loops) return flow_fault(Alarm::DoEndMismatch, begin);
        const Loop loop = loops_[found - 1];
        loops_.resize(found - 1);  // loops inside were left by a jump
        fresh_ = false;            // the condition is asked of the machine anew
        go_on_at(loop.at);
        return Flow::Done;
    }
    std::string letters;
    for (const char* p = at; p != end && is_letter(*p); ++p) letters += capital(*p);
    const std::string_view name = statement_name(letters);
    if (name.empty() || (name == "SETVN" && (settings_.nct || settings_.mefi)))
        return flow_fault(Alarm::WordUnknown, at, letters);
    if (name == "SETVN") return name_variables(at += letters.size(), end);
    return print_statement(name, at, end);
}

Interpreter::Flow Interpreter::condition(const char*& at, const char* end, bool& holds) {
    gap(at, end);
    if (at == end || *at != '[') return flow_fault(Alarm::BracketMissing, at);
    double value = 0.0;
    const Flow flow = flow_of(expression_.operand(at, end, value));
    holds = !is_null(value) && value != 0.0;
    return flow;
}

Interpreter::Flow Interpreter::loop_number(const char*& at, const char* end, std::uint8_t& number) {
    gap(at, end);
    const char* const begin = at;
    double value = 0.0;
    if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
    if (value != 1 && value != 2 && value != 3) return flow_fault(Alarm::DoNumberIllegal, begin);
    number = static_cast<std::uint8_t>(value);
    return Flow::Done;
}

// The number of a loop that a block begins or ends, behind block number and skip signs: 0 neither.
// `ends`: it is an END.
std::uint8_t Interpreter::loop_word(std::string_view line, bool& ends) {
    const char* at = line.data();
    const char* const end = at + line.size();
    gap(at, end);
    while (at != end && *at == '/') {
        ++at;
        while (at != end && ((*at >= '0' && *at <= '9') || *at == ' ')) ++at;
    }
    if (at != end && capital(*at) == 'N') {
        ++at;
        while (at != end && (*at == ' ' || (*at >= '0' && *at <= '9'))) ++at;
    }
    ends = take(at, end, "END");
    if (!ends) {
        if (take(at, end, "WHILE")) {
            int depth = 0;
            for (gap(at, end); at != end; ++at) {
                if (*at == '(') at = std::find(at, end, ')');
                if (at == end) break;
                if (*at == '[') ++depth;
                if (*at == ']' && --depth == 0) break;
            }
            if (at != end) ++at;
        }
        if (!take(at, end, "DO")) return 0;
    }
    gap(at, end);
    return at != end && *at >= '1' && *at <= '3' ? static_cast<std::uint8_t>(*at - '0') : 0;
}

// Each DO from here on has its END, and they do not cross (fanuc_lathe 6.8). Looked at once for
// each place.
bool Interpreter::loops_nest(std::uint8_t number, std::size_t from) {
    const auto place = std::pair(frames_.back().file, source_->position().offset + from);
    if (std::find(checked_loops_.begin(), checked_loops_.end(), place) != checked_loops_.end())
        return true;
    const TextPosition here = source_->position();
    const auto column = static_cast<std::uint32_t>(from) + 1;
    std::array<std::uint8_t, 3> open{number};
    std::size_t depth = 1;
    bool crossed = false;
    kept_line_ = line_;  // reading on moves the window
    std::string_view line = kept_line_;
    std::uint32_t last_line = here.line;
    for (std::size_t next = next_block(line, from); depth && !crossed;
         next = next_block(line, next)) {
        if (next == std::string_view::npos) {
            if (source_->next(line) != LineSource::Status::Line) break;
            last_line = source_->position().line;
            next = 0;
        }
        bool ends = false;
        const std::uint8_t word = loop_word(line.substr(next), ends);
        if (!word) continue;
        if (ends)
            crossed = open[--depth] != word;
        else if (crossed =
                     depth == open.size() ||
                     std::find(open.begin(), open.begin() + static_cast<std::ptrdiff_t>(depth),
                               word) != open.begin() + static_cast<std::ptrdiff_t>(depth);
                 !crossed)
            open[depth++] = word;
    }
    source_->seek(here);
    if (source_->next(line_) != LineSource::Status::Line) line_ = {};
    if (!crossed && !depth) {
        if (checked_loops_.size() < 256) checked_loops_.push_back(place);
        return true;
    }
    fault_line_ = crossed ? last_line : here.line;
    fault_column_ = crossed ? 1 : column;
    fault_length_ = 2;
    return core_.fail(Alarm::DoEndMismatch);
}

// Goes on behind END number.
Interpreter::Flow Interpreter::skip_loop(std::uint8_t number, const char* from) {
    const TextPlace back = place_behind(behind_);
    const std::size_t column = static_cast<std::size_t>(from - line_.data());
    const std::uint32_t at_line = source_->position().line;
    const JumpMemory::Place place{frames_.back().file, back.byte(), 0,
                                  -static_cast<std::int64_t>(number)};
    if (const TextPlace* known = jumps_.find(place)) {
        go_to(*known);
        return Flow::Done;
    }
    kept_line_ = line_;  // searching moves the window
    std::string_view line = kept_line_;
    for (std::size_t next = line_left_ ? behind_ : std::string_view::npos;;) {
        if (next == std::string_view::npos) {
            if (source_->next(line) != LineSource::Status::Line) break;
            next = 0;
        }
        bool ends = false;
        const std::uint8_t word = loop_word(line.substr(next), ends);
        next = next_block(line, next);
        if (word != number || !ends) continue;  // N120 END1, /END1 too
        const TextPlace found = next == std::string_view::npos
                                    ? TextPlace(source_->next_position())
                                    : TextPlace(source_->position(), next);
        jumps_.remember(place, found);
        go_on_at(found);
        return Flow::Done;
    }
    source_->seek(back);
    fault_column_ = static_cast<std::uint32_t>(column) + 1;
    fault_length_ = 5;
    fault_line_ = at_line;
    line_ = kept_line_;
    core_.fail(Alarm::DoEndMismatch);
    return Flow::Fault;
}

Interpreter::Flow Interpreter::jump(const char*& at, const char* end) {
    gap(at, end);
    const char* const begin = at;
    double value = 0.0;
    const Flow flow = evaluate(at, end, value);
    if (flow != Flow::Done) return flow;
    const double number = std::nearbyint(value);
    if (is_null(value) || number < 1 || number > static_cast<double>(settings_.goto_max))
        return flow_fault(Alarm::GotoNumberIllegal, begin, {}, is_null(value) ? 0.0 : value);
    fault_column_ = static_cast<std::uint32_t>(begin - line_.data()) + 1;
    fault_length_ = 1;
    const auto found = find_block(static_cast<std::int64_t>(number));
    if (!found) {  // 128 also when it cannot be found
        core_.fail(Alarm::GotoNumberIllegal, 0, {}, value);
        return Flow::Fault;
    }
    go_to(*found);
    return Flow::Done;
}

Interpreter::Flow Interpreter::assignment(const char*& at, const char* end) {
    const char* const begin = at;
    std::int64_t number = 0;
    if (const Flow flow = flow_of(expression_.variable_number(at, end, number)); flow != Flow::Done)
        return flow;
    gap(at, end);
    if (at == end || *at != '=')
        return flow_fault(Alarm::MacroFormat, at == end ? begin : at, "= is missing");
    ++at;
    // a clock is set when the machine has come here
    if ((number == 3001 || number == 3002) && !fresh_ && !inputs_fresh_) return Flow::NeedsBarrier;
    double value = 0.0;
    if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
    const std::string_view comment = comment_text(at, end);
    fault_column_ = static_cast<std::uint32_t>(begin - line_.data()) + 1;
    fault_length_ = static_cast<std::uint32_t>(at - begin);
    // the call writes them (nct_parameters_part2 38)
    const bool of_letter_call = settings_.nct && number >= 191 && number <= 199;
    if (of_letter_call) {
        core_.fail(Alarm::VariableReadOnly, 0, variable_name(number));
        return Flow::Fault;
    }
    if (!written(number, value, comment)) return Flow::Fault;
    fault_column_ = fault_length_ = 0;
    return Flow::Done;
}

// SETVN 510[TOOL_NO,COUNT]
Interpreter::Flow Interpreter::name_variables(const char*& at, const char* end) {
    blanks(at, end);
    const char* const begin = at;
    double value = 0.0;
    if (const Flow flow = evaluate(at, end, value); flow != Flow::Done) return flow;
    blanks(at, end);
    if (at == end || *at != '[') return flow_fault(Alarm::BracketMissing, at);
    auto number = static_cast<std::int64_t>(is_null(value) ? 0 : std::nearbyint(value));
    VariableNames given = names_;
    do {
        ++at;
        blanks(at, end);
        const char* const from = at;
        while (at != end && VariableNames::goes_on(*at)) ++at;
        const std::string_view name(from, static_cast<std::size_t>(at - from));
        if (name.empty() || name.size() > VariableNames::kLongest ||
            !VariableNames::begins(name[0]))
            return flow_fault(Alarm::MacroFormat, from,
                              "a name has 1 to 8 letters, digits and _, a letter first");
        if (!variables_.is_common(number))
            return flow_fault(Alarm::VariableUnknown, begin, variable_name(number));
        given.name(number++, name);
        blanks(at, end);
    } while (at != end && *at == ',');
    if (at == end || *at != ']') return flow_fault(Alarm::BracketMissing, at);
    ++at;
    names_ = std::move(given);
    if (!reads_contour_ && !core_.port().keep(kNamesKept, names_.text()))
        return flow_fault(Alarm::OutputFile, begin, "SETVN");
    return Flow::Done;
}

// A variable is written: the channel sees it at once, the others when the record is executed.
bool Interpreter::written(std::int64_t number, double value, std::string_view comment) {
    core_.did();
    if (number == 3000) {  // an alarm of the program's own
        message_ = comment;
        if (message_.empty()) message_ = "alarm of the program";
        if (!is_null(value) && (value < 0 || value > 200) && !settings_.nct)
            return core_.fail(Alarm::VariableValue, 0, "#3000", value);
        return core_.program_alarm(message_, 3000 + (is_null(value) ? 0 : std::nearbyint(value)));
    }
    if (number == 3006) {  // a message, and the program stops
        core_.mark_emitted();
        core_.sink().message(comment, core_.at);
        core_.sink().stop({StopReason::M00}, core_.at);
        wants_barrier_ = true;
        return true;
    }
    if (number >= settings_.protected_first && number <= settings_.protected_last)
        return core_.fail(Alarm::VariableReadOnly, 0, variable_name(number));
    switch (variables_.write(number, value)) {
        case VariableStatus::Ok:
            break;
        case VariableStatus::ReadOnly:
            return core_.fail(Alarm::VariableReadOnly, 0, variable_name(number));
        case VariableStatus::Fault:
            return false;
        default:
            return core_.fail(Alarm::VariableUnknown, 0, variable_name(number));
    }
    char text[24] = {'#'};
    char* last = text + 1;
    std::int64_t rest = number;
    char digits[20];
    int count = 0;
    do digits[count++] = static_cast<char>('0' + rest % 10);
    while (rest /= 10);
    while (count) *last++ = digits[--count];
    Variable variable;
    variable.name = {text, static_cast<std::size_t>(last - text)};
    variable.value = value;
    if (number >= 500 && number < 1000)
        variable.persistent = static_cast<std::int32_t>(number - 500);
    // kept in the first channel's store, #100 and on behind the others
    if (number < 1000 && variables_.is_shared(number)) {
        variable.persistent =
            static_cast<std::int32_t>(number >= 500 ? number - 500 : 400 + number);
        variable.channel = 1;
    }
    core_.mark_emitted();
    core_.sink().variable(variable, core_.at);
    return true;
}

bool Interpreter::preset_variable(std::string_view name, double value) {
    if (name.size() < 2 || name[0] != '#') return false;
    std::int64_t number = 0;
    for (const char c : name.substr(1)) {
        if (c < '0' || c > '9' || number > 10'000'000) return false;
        number = number * 10 + (c - '0');
    }
    if (number >= 1000) return false;
    return variables_.write(number, value) == VariableStatus::Ok;
}

}  // namespace polyturn::channels::fanuc
