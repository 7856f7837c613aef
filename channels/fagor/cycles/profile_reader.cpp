#include "channels/fagor/cycles/profile_reader.hpp"

#include <algorithm>
#include <utility>

#include "channels/engine/text_search.hpp"
#include "channels/fagor/cycles/cycle_words.hpp"
#include "channels/fagor/execution.hpp"
#include "channels/fagor/flow/block_order.hpp"
#include "channels/fagor/flow/programs.hpp"
#include "channels/fagor/frames/plane.hpp"
#include "channels/fagor/grammar/words.hpp"
#include "channels/fagor/motion/lengths.hpp"

namespace polyturn::channels::fagor {

using cycles::Contour;
using cycles::Point;

namespace {

// G36 R2 or G39 R2 in a line of its own: in a profile it may stand between the two blocks of its
// corner (9.1.2). Its words; empty: another block.
std::string_view corner_alone(std::string_view line) {
    std::size_t i = 0;
    const auto blanks = [&] {
        while (i < line.size() && (line[i] == ' ' || line[i] == '\t')) ++i;
    };
    const auto letter = [&](char c) {
        return i < line.size() && (line[i] == c || line[i] == c + 32) ? (++i, true) : false;
    };
    const auto digits = [&](bool point) {
        const std::size_t begin = i;
        while (i < line.size() && ((line[i] >= '0' && line[i] <= '9') || (point && line[i] == '.')))
            ++i;
        return line.substr(begin, i - begin);
    };
    blanks();
    if (letter('N')) {
        blanks();
        (void)digits(false);
        blanks();
    }
    const std::size_t begin = i;
    if (!letter('G')) return {};
    const std::string_view code = digits(false);
    blanks();
    if ((code != "36" && code != "39") || !letter('R')) return {};
    blanks();
    if (digits(true).empty()) return {};
    const std::size_t end = i;
    blanks();
    return i == line.size() || line[i] == ';' ? line.substr(begin, end - begin)
                                              : std::string_view{};
}

// The blocks of a profile run into the recorder; only what 9.1.2 allows, with a modal state of its
// own.
struct ProfileRun {
    Execution& x;  // of the profile
    cycles::ContourRecorder& recorder;
    FileId file;
    TextPosition from;
    std::uint32_t last_line;
    Contour &part, &blank;
    bool& has_blank;
    // G00 has ended the part: the blank begins with a motion
    bool after_separator = false;

    bool refuse(Alarm alarm, std::string detail) {
        if (!recorder.error)
            recorder.error = Diagnosis{
                alarm, {x.programs.files.path(file), x.core.at.line, 0, 0}, {}, std::move(detail)};
        return false;
    }
    // A corner that waits for its next block goes on.
    void settle() {
        x.core.begin_cycle(Core::CycleMoves::Plain);
        x.core.end_cycle();
    }
    void begin(const Execution& caller, Point start);
    bool next_line();
    void drop_idle_words();
    bool allowed(bool& separator);
    bool block();
    bool finish();
};

// Modal state, values and position of the caller, in coordinates without tool, scale and mirror.
void ProfileRun::begin(const Execution& caller, Point start) {
    x.ahead.reads_profile = true;
    x.values.take_values(caller.values);
    x.modal = caller.modal;
    x.modal.modal_call = {};
    x.modal.comp = 40;
    x.modal.feed_code = 94;
    x.modal.feed_minute = 1.0;
    x.modal.motion = 1;
    x.core.compensation_reset();
    PathState& path = x.core.path;
    path = caller.core.path;
    path.wanted = path.vector = path.shift = {};
    path.zones = {};
    path.second_limits = {};
    path.feed_mode = FeedMode::PerMinute;
    path.feed = 1.0;
    x.core.set_frame(Frame{});
    // G72 of an axis acts on what the cycle cuts, not on what is read
    path.factored = false;
    path.factor.fill(1.0);
    int p = -1, q = -1;
    x.core.plane_axes(p, q);
    AxisValues machine = path.machine;
    machine[static_cast<std::size_t>(p)] = start.z + path.zero[static_cast<std::size_t>(p)];
    machine[static_cast<std::size_t>(q)] = start.x + path.zero[static_cast<std::size_t>(q)];
    x.core.start_at_machine(machine);
    recorder.from(start);
    recorder.contour.start = {caller.core.path.programmed[static_cast<std::size_t>(p)],
                              caller.core.path.programmed[static_cast<std::size_t>(q)]};
    recorder.contour.first = start;
    CallFrame frame;
    frame.file = file;
    frame.maker = attribute_of(x, file, 'O');
    frame.begin = from;
    x.calls.start(frame);
    x.core.at = caller.core.at;
    has_blank = false;
}

// The next line of the profile, and the corner that stands alone behind it; false: there is none.
bool ProfileRun::next_line() {
    LineSource& source = x.calls.source();
    std::string_view line;
    if (source.next(line) != LineSource::Status::Line) return false;
    x.line.take(line);
    x.core.at.line = source.position().line;
    x.core.at.file = file;
    if (x.core.at.line > last_line) return false;
    const TextPosition behind = source.next_position();
    const bool more =
        source.next(line) == LineSource::Status::Line && source.position().line <= last_line;
    const std::string_view corner = more ? corner_alone(line) : std::string_view{};
    if (corner.empty()) {
        source.seek(behind);
        return true;
    }
    x.line.kept.erase(std::min(x.line.kept.find(';'), x.line.kept.size()));
    x.line.kept += ' ';
    x.line.kept += corner;
    x.line.text = x.line.kept;
    return true;
}

// F S T D M, G05 G07 G50: accepted and without effect.
void ProfileRun::drop_idle_words() {
    Block& block = x.line.block;
    for (unsigned k = 0; k < block.count;) {
        const Word& w = block.words[k];
        const bool idle = w.letter == 'F' || w.letter == 'S' || w.letter == 'T' ||
                          w.letter == 'D' || w.letter == 'M' ||
                          (w.letter == 'G' && (w.value == 5 || w.value == 7 || w.value == 50));
        if (!idle) {
            ++k;
            continue;
        }
        for (unsigned j = k + 1; j < block.count; ++j) block.words[j - 1] = block.words[j];
        --block.count;
    }
}

// The codes of the block. `separator`: G00, with which the blank begins.
bool ProfileRun::allowed(bool& separator) {
    static constexpr unsigned kAllowed[] = {0, 1, 2, 3, 6, 8, 9, 36, 39, 53, 70, 71, 90, 91, 93};
    constexpr unsigned kNone = 99;
    unsigned motion = kNone;
    for (unsigned k = 0; k < x.line.block.count; ++k) {
        const Word& w = x.line.block.words[k];
        if (w.letter != 'G') continue;
        bool known = false;
        for (const unsigned code : kAllowed) known = known || w.value == code;
        if (!known)
            return refuse(Alarm::FagorProfileBlock,
                          "G" + std::to_string(static_cast<int>(w.value)));
        separator = separator || w.value == 0;
        if (w.value <= 3 || w.value == 8 || w.value == 9) motion = static_cast<unsigned>(w.value);
    }
    if (after_separator && (motion == kNone || motion == 0))
        return refuse(Alarm::FagorProfileMotion, {});
    return true;
}

bool ProfileRun::block() {
    x.words.by_letter.fill(nullptr);
    x.line.fault.column = x.line.fault.length = 0;
    const BlockKind kind = x.parsers.reader.read(x.line.text, x.line.block);
    x.core.at.block = x.line.block.label;
    if (kind == BlockKind::Statement)
        return refuse(Alarm::FagorProfileBlock, std::string(x.line.text));
    if (kind == BlockKind::Fault)
        return refuse(x.parsers.reader.fault().alarm, x.parsers.reader.fault().detail);
    if (kind != BlockKind::Iso) return true;
    x.core.begin_block();
    drop_idle_words();
    bool separator = false;
    if (!allowed(separator)) return false;
    after_separator = false;
    if (separator) {
        if (has_blank) return refuse(Alarm::FagorProfileBlock, "G00");
        settle();
        part = recorder.contour;
        has_blank = after_separator = true;
    }
    if (!(classify(x) && check_words(x) && act_in_order(x))) {
        const Fault& fault = x.core.fault();
        if (!recorder.error)
            recorder.error = Diagnosis{fault.alarm,
                                       {x.programs.files.path(file), x.core.at.line,
                                        x.line.fault.column, x.line.fault.length},
                                       {fault.value0, fault.value1},
                                       fault.detail};
        return false;
    }
    if (x.core.reads_ahead() && !x.core.end_compensated_block(true, false, false))
        return refuse(x.core.fault().alarm, x.core.fault().detail);
    if (separator) {
        settle();
        const Point here = cycle_call_point(x);
        recorder.contour.elements.clear();
        recorder.contour.first = here;
        recorder.from(here);
    }
    return true;
}

bool ProfileRun::finish() {
    settle();
    if (after_separator) return refuse(Alarm::FagorProfileMotion, {});
    if (recorder.error) return false;
    if (recorder.foreign)
        return refuse(Alarm::FagorProfileBlock, "N" + std::to_string(recorder.foreign->block));
    (has_blank ? blank : part) = recorder.contour;
    if (part.elements.empty()) return refuse(Alarm::ContourEmpty, "Z");
    return true;
}

bool record_profile(ProfileRun run, const Execution& caller, Point start) {
    run.begin(caller, start);
    while (run.next_line())
        if (!run.block()) return false;
    return run.finish();
}

}  // namespace

bool read_profile(Execution& x, Contour& part, Contour& blank, bool& has_blank) {
    std::int64_t first = 0, last = 0, program = -1;
    if (!whole(x, *x.words.word('S'), first) || !whole(x, *x.words.word('E'), last)) return false;
    for (const char letter : {'S', 'E'})
        if (x.words.number(letter) > 9999) return x.fail(Alarm::FagorLabel, letter);
    if (x.words.has('Q') && !whole(x, *x.words.word('Q'), program)) return false;
    FileId file = x.calls.here().file;
    if (program >= 0) {
        const auto found = find_program(x, program);
        if (!found) return x.fail(Alarm::SubprogramMissing, 'Q', "P" + std::to_string(program));
        file = *found;
    }
    const auto from = find_label(x, file, first), to = find_label(x, file, last);
    if (!from || !to)
        return x.fail(Alarm::SequenceNumberMissing, from ? 'E' : 'S',
                      std::to_string(from ? last : first));
    if (from->line > to->line)
        return x.fail(Alarm::FagorLabelOrder, 'E',
                      "N" + std::to_string(first) + " N" + std::to_string(last));
    unsigned p = 0, q = 0;
    if (!plane_places(x, p, q)) return false;
    const Point start = cycle_point(x, 'Z', 'X');
    cycles::ContourRecorder recorder(p, q);
    Execution reader(x.core.view(), recorder, x.core.port(), x.programs.files);
    LineSource& source = x.programs.files.source(file);
    bool good = false;
    {
        const engine::KeepPosition keep(source);
        good = record_profile({reader, recorder, file, *from, to->line, part, blank, has_blank}, x,
                              start);
    }
    show_diameter(x);
    if (good) return true;
    if (recorder.error) {
        x.fail(recorder.error->alarm, 0, recorder.error->detail, recorder.error->values[0],
               recorder.error->values[1]);
        Fault fault = x.core.fault();
        BlockContext at = x.core.at;
        at.file = file;
        at.line = recorder.error->place.line;
        fault.block = at;
        fault.column = recorder.error->place.column;
        fault.length = recorder.error->place.length;
        x.core.set_fault(std::move(fault));
    }
    return false;
}

}  // namespace polyturn::channels::fagor
