// G66, G68, G69: the blocks of a profile are read as geometry, then cut (fagor_8037t part 2, 9.1 to
// 9.3).
#include <algorithm>
#include <cmath>

#include "channels/cycles/contour_offset.hpp"
#include "channels/cycles/profile_roughing.hpp"
#include "channels/cycles/tool_closing.hpp"
#include "channels/fagor/interpreter.hpp"
#include "channels/fagor/motion/contour_loops.hpp"

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

}  // namespace

bool Interpreter::read_profile(Contour& part, Contour& blank, bool& has_blank) {
    std::int64_t first = 0, last = 0, program = -1;
    if (!whole(*word('S'), first) || !whole(*word('E'), last)) return false;
    for (const char letter : {'S', 'E'})
        if (number(letter) > 9999) return core_.fail(Alarm::FagorLabel, letter);
    if (has('Q') && !whole(*word('Q'), program)) return false;
    FileId file = frames_.back().file;
    if (program >= 0) {
        const auto found = find_program(program);
        if (!found) return core_.fail(Alarm::SubprogramMissing, 'Q', "P" + std::to_string(program));
        file = *found;
    }
    const auto from = find_label(file, first), to = find_label(file, last);
    if (!from || !to)
        return core_.fail(Alarm::SequenceNumberMissing, from ? 'E' : 'S',
                          std::to_string(from ? last : first));
    if (from->line > to->line)
        return core_.fail(Alarm::FagorLabelOrder, 'E',
                          "N" + std::to_string(first) + " N" + std::to_string(last));
    unsigned p = 0, q = 0;
    if (!plane_places(p, q)) return false;
    const Point start = cycle_point('Z', 'X');
    cycles::ContourRecorder recorder(p, q);
    Interpreter reader(core_.view(), recorder, core_.port(), *files_);
    LineSource& source = files_->source(file);
    const TextPosition back = source.next_position();
    const bool good = reader.record_profile(*this, file, *from, to->line, start, recorder, part,
                                            blank, has_blank);
    source.seek(back);
    show_diameter();
    if (good) return true;
    if (recorder.error) {
        core_.fail(recorder.error->alarm, 0, recorder.error->detail, recorder.error->values[0],
                   recorder.error->values[1]);
        Fault fault = core_.fault();
        BlockContext at = core_.at;
        at.file = file;
        at.line = recorder.error->place.line;
        fault.block = at;
        fault.column = recorder.error->place.column;
        fault.length = recorder.error->place.length;
        core_.set_fault(std::move(fault));
    }
    return false;
}

// Runs the blocks of a profile into the recorder; only what 9.1.2 allows, with a modal state of its
// own.
bool Interpreter::record_profile(const Interpreter& caller, FileId file, TextPosition from,
                                 std::uint32_t last_line, Point start,
                                 cycles::ContourRecorder& recorder, Contour& part, Contour& blank,
                                 bool& has_blank) {
    reads_profile_ = true;
    values_.take_values(caller.values_);
    modal_ = caller.modal_;
    modal_.modal_call = {};
    modal_.comp = 40;
    modal_.feed_code = 94;
    modal_.feed_minute = 1.0;
    modal_.motion = 1;
    core_.compensation_reset();
    core_.path = caller.core_.path;
    core_.path.wanted = core_.path.vector = core_.path.shift = {};
    core_.path.zones = {};
    core_.path.second_limits = {};
    core_.path.feed_mode = FeedMode::PerMinute;
    core_.path.feed = 1.0;
    core_.set_frame(Frame{});
    // G72 of an axis acts on what the cycle cuts, not on what is read
    core_.path.factored = false;
    core_.path.factor.fill(1.0);
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    AxisValues machine = core_.path.machine;
    machine[static_cast<std::size_t>(p)] = start.z + core_.path.zero[static_cast<std::size_t>(p)];
    machine[static_cast<std::size_t>(q)] = start.x + core_.path.zero[static_cast<std::size_t>(q)];
    core_.start_at_machine(machine);
    recorder.from(start);
    recorder.contour.start = caller_point(caller);
    recorder.contour.first = start;
    CallFrame frame;
    frame.file = file;
    frame.maker = attribute_of(file, 'O');
    frames_.assign(1, frame);
    source_ = &files_->source(file);
    source_->seek(from);
    core_.at = caller.core_.at;
    bool after_separator = false;
    const auto refuse = [&](Alarm alarm, std::string detail) {
        if (!recorder.error)
            recorder.error =
                Diagnosis{alarm, {files_->path(file), core_.at.line, 0, 0}, {}, std::move(detail)};
        return false;
    };
    const auto settle = [this] {
        // a corner that waits for its next block goes on
        core_.begin_cycle(Core::CycleMoves::Plain);
        core_.end_cycle();
    };
    has_blank = false;
    for (;;) {
        std::string_view line;
        if (source_->next(line) != LineSource::Status::Line) break;
        line_storage_.assign(line);
        line_ = line_storage_;
        core_.at.line = source_->position().line;
        core_.at.file = file;
        if (core_.at.line > last_line) break;
        const TextPosition behind = source_->next_position();
        const bool more = source_->next(line) == LineSource::Status::Line &&
                          source_->position().line <= last_line;
        if (const std::string_view corner = more ? corner_alone(line) : std::string_view{};
            !corner.empty()) {
            line_storage_.erase(std::min(line_storage_.find(';'), line_storage_.size()));
            line_storage_ += ' ';
            line_storage_ += corner;
            line_ = line_storage_;
        } else {
            source_->seek(behind);
        }
        by_letter_.fill(nullptr);
        fault_column_ = fault_length_ = 0;
        const BlockKind kind = reader_.read(line_, block_);
        core_.at.block = block_.label;
        if (kind == BlockKind::Statement)
            return refuse(Alarm::FagorProfileBlock, std::string(line_));
        if (kind == BlockKind::Fault) return refuse(reader_.fault().alarm, reader_.fault().detail);
        if (kind == BlockKind::Iso) {
            core_.begin_block();
            for (unsigned k = 0; k < block_.count;) {  // accepted and without effect
                const Word& w = block_.words[k];
                const bool idle =
                    w.letter == 'F' || w.letter == 'S' || w.letter == 'T' || w.letter == 'D' ||
                    w.letter == 'M' ||
                    (w.letter == 'G' && (w.value == 5 || w.value == 7 || w.value == 50));
                if (!idle) {
                    ++k;
                    continue;
                }
                for (unsigned j = k + 1; j < block_.count; ++j)
                    block_.words[j - 1] = block_.words[j];
                --block_.count;
            }
            bool separator = false;
            unsigned motion = 99;
            for (unsigned k = 0; k < block_.count; ++k) {
                const Word& w = block_.words[k];
                if (w.letter != 'G') continue;
                static constexpr unsigned kAllowed[] = {0,  1,  2,  3,  6,  8,  9, 36,
                                                        39, 53, 70, 71, 90, 91, 93};
                bool allowed = false;
                for (const unsigned code : kAllowed) allowed = allowed || w.value == code;
                if (!allowed)
                    return refuse(Alarm::FagorProfileBlock,
                                  "G" + std::to_string(static_cast<int>(w.value)));
                separator = separator || w.value == 0;
                if (w.value <= 3 || w.value == 8 || w.value == 9)
                    motion = static_cast<unsigned>(w.value);
            }
            if (after_separator && (motion == 99 || motion == 0))
                return refuse(Alarm::FagorProfileMotion, {});
            after_separator = false;
            if (separator) {
                if (has_blank) return refuse(Alarm::FagorProfileBlock, "G00");
                settle();
                part = recorder.contour;
                has_blank = after_separator = true;
            }
            if (!(classify() && check_words() && act())) {
                const Fault& fault = core_.fault();
                if (!recorder.error)
                    recorder.error =
                        Diagnosis{fault.alarm,
                                  {files_->path(file), core_.at.line, fault_column_, fault_length_},
                                  {fault.value0, fault.value1},
                                  fault.detail};
                return false;
            }
            if (core_.reads_ahead() && !core_.end_compensated_block(true, false, false))
                return refuse(core_.fault().alarm, core_.fault().detail);
            if (separator) {
                settle();
                const Point here{core_.path.programmed[static_cast<std::size_t>(p)],
                                 core_.path.programmed[static_cast<std::size_t>(q)]};
                recorder.contour.elements.clear();
                recorder.contour.first = here;
                recorder.from(here);
            }
        }
    }
    settle();
    if (after_separator) return refuse(Alarm::FagorProfileMotion, {});
    if (recorder.error) return false;
    if (recorder.foreign)
        return refuse(Alarm::FagorProfileBlock, "N" + std::to_string(recorder.foreign->block));
    (has_blank ? blank : part) = recorder.contour;
    if (part.elements.empty()) return refuse(Alarm::ContourEmpty, "Z");
    return true;
}

Point Interpreter::caller_point(const Interpreter& caller) {
    int p = -1, q = -1;
    core_.plane_axes(p, q);
    return {caller.core_.path.programmed[static_cast<std::size_t>(p)],
            caller.core_.path.programmed[static_cast<std::size_t>(q)]};
}

bool Interpreter::g_profile(const GCode& row) {
    if (!begin_cycle_block() || !cycle_needs(row.number == 66 ? "XZICSE" : "XZCSE") ||
        !cycle_not_zero("C") || !cycle_not_negative("CDKFHI"))
        return false;
    if (distance('C') <= 0) return core_.fail(Alarm::FagorCycleZero, 'C', "C");
    drop_compensation();
    Contour part, blank;
    bool has_blank = false;
    if (!read_profile(part, blank, has_blank)) return false;
    bool closed = false;
    part = close_for_tool(part, row.number == 69, closed);
    if (distance('H') > 0) close_for_nose(part, row.number != 69, closed);
    if (closed)
        core_.sink().alarm({Alarm::FagorProfileHollow,
                            {files_->path(frames_.back().file), core_.at.line, 0, 0},
                            {},
                            {}},
                           core_.at);
    const Point call = cycle_call_point();
    part.start = call;
    const double l = std::fabs(distance('L')), m = has('M') ? std::fabs(distance('M')) : l;
    const bool square = !(number('L') < 0 || number('M') < 0);
    const double finishing = distance('H');
    bool good = true;
    if (row.number == 66) {
        good = repeat_passes(part, call, l, m, square, finishing);
    } else {
        const bool facing = row.number == 69;
        // Outside the part, farther away than the allowances.
        Point least = part.first, most = part.first;
        const double sx = call.x >= part.first.x ? 1.0 : -1.0,
                     sz = call.z >= part.first.z ? 1.0 : -1.0;
        for (const cycles::Element& e : part.elements) {
            least = {std::fmin(least.z, e.to.z), std::fmin(least.x, e.to.x)};
            most = {std::fmax(most.z, e.to.z), std::fmax(most.x, e.to.x)};
        }
        // Along the infeed on the side of the call point, along the passes on either side of the
        // profile.
        const double x_above = call.x - most.x, x_below = least.x - call.x,
                     z_above = call.z - most.z, z_below = least.z - call.z;
        const double x_room = facing ? std::fmax(x_above, x_below) : sx > 0 ? x_above : x_below;
        const double z_room = !facing ? std::fmax(z_above, z_below) : sz > 0 ? z_above : z_below;
        if (x_room < l - 1e-6 || z_room < m - 1e-6)
            return core_.fail(Alarm::FagorCyclePosition, 'G', std::string(cycle_name(row.number)));
        const int side = cycles::side_towards(part, call, !facing);
        Contour allowed = part;
        if (has('M'))
            allowed = cycles::translated(part, {sz * m, sx * l});
        else if (l > 0)
            allowed = cycles::equidistant(part, l, side);
        if (allowed.elements.empty()) return core_.fail(Alarm::ContourEmpty, 'L');
        cycles::ProfileRoughing cycle;
        cycle.facing = facing;
        cycle.depth = distance('C');
        cycle.safety = distance('D');
        cycle.retract = !has('D')          ? cycles::Retract::Along
                        : cycle.safety > 0 ? cycles::Retract::Oblique
                                           : cycles::Retract::Same;
        cycle.plunge_feed = distance('K');
        cycle.semi_feed = distance('F');
        cycle.finishing_feed = finishing;
        cycle.finishing_square = square;
        cycle.arc_tolerance = settings_.arc_tolerance;
        good = cycles::rough_profile(core_, part, allowed, has_blank ? &blank : nullptr, cycle);
        if (good && cycle.semi_feed > 0 && finishing <= 0) keep_feed(cycle.semi_feed);
    }
    if (good && finishing > 0) keep_feed(finishing);
    modal_.motion = 0;
    modal_.absolute = true;
    return good;
}

// The feed that the cycle has used last stays (9.0.6).
void Interpreter::keep_feed(double feed) {
    (modal_.feed_code == 94   ? modal_.feed_minute
     : modal_.feed_code == 95 ? modal_.feed_revolution
                              : modal_.feed_inverse) = feed;
}

bool Interpreter::repeat_passes(const Contour& part, Point call, double l, double m, bool square,
                                double finishing) {
    // Along X, unless A or the longer dimension of the tool says otherwise.
    bool along_x = true;
    if (has('A')) {
        if (number('A') != 0 && number('A') != 1)
            return core_.fail(Alarm::FagorValueRange, 'A', "A", number('A'));
        along_x = number('A') == 0;
    } else {
        int p = -1, q = -1;
        core_.plane_axes(p, q);
        const AxisValues& tool = core_.path.wanted;
        along_x = !(std::fabs(tool[static_cast<std::size_t>(p)]) >
                    std::fabs(tool[static_cast<std::size_t>(q)]));
    }
    const double stock = distance('I'), step = distance('C'), allowance = along_x ? l : m;
    const double sx = call.x >= part.first.x ? 1.0 : -1.0, sz = call.z >= part.first.z ? 1.0 : -1.0;
    double outermost = -1e12;
    const auto look = [&](Point p) {
        outermost = std::fmax(outermost, along_x ? sx * p.x : sz * p.z);
    };
    look(part.first);
    for (const cycles::Element& e : part.elements) look(e.to);
    if ((along_x ? sx * call.x : sz * call.z) < outermost + stock - 1e-6)
        return core_.fail(Alarm::FagorCyclePosition, 'G', "G66");
    cycles::ProfileRepeat cycle;
    cycle.along_x = along_x;
    cycle.finishing_feed = finishing;
    cycle.finishing_square = square;
    cycle.arc_tolerance = settings_.arc_tolerance;
    const int side = cycles::side_towards(part, call, along_x);
    // An arc or a slope at the end is not cut beyond the largest coordinate that is programmed
    // (9.1.1).
    const cycles::Element& last = part.elements.back();
    const bool oblique_end =
        last.form != cycles::Element::Form::Line ||
        (std::fabs(last.to.z - last.from.z) > 1e-6 && std::fabs(last.to.x - last.from.x) > 1e-6);
    if (!(finishing > 0 && stock <= allowance)) {
        const int passes = static_cast<int>(std::ceil((stock - allowance) / step - 1e-9));
        if (passes > 10'000) return core_.fail(Alarm::CycleValueIllegal, 'C', "C", step);
        for (int k = 1; k <= passes; ++k) {
            const double d = std::fmax(stock - k * step, allowance);
            if (!has('M')) {
                Contour pass = d > 0 ? cycles::equidistant(part, d, side) : part;
                if (oblique_end)
                    pass = cycles::without_end_beyond(pass, along_x, along_x ? sx : sz, outermost);
                if (!pass.elements.empty()) cycle.passes.push_back(std::move(pass));
                continue;
            }
            const double more = d - allowance;
            cycle.passes.push_back(cycles::translated(
                part, {sz * (m + (along_x ? 0.0 : more)), sx * (l + (along_x ? more : 0.0))}));
        }
    }
    return cycles::repeat_profile(core_, part, cycle);
}

// The finishing pass is compensated: what the nose does not fit into is closed before anything is
// cut (9.1.5).
void Interpreter::close_for_nose(Contour& part, bool infeed_in_x, bool& closed) {
    // elements that are looked at together, as in 8.2.5 of part 1
    constexpr std::size_t kWindow = 50;
    const Nose nose{std::fabs(core_.path.tool.nose_radius) / modal_.scale,
                    cycles::side_towards(part, cycle_call_point(), infeed_in_x), outer_corner()};
    const auto loops = find_loops(part.elements, nose, kWindow);
    if (loops.empty()) return;
    part.elements = without_loops(std::move(part.elements), loops);
    closed = true;
}

// Cutter angle NOSEA and cutting angle CUTA, in ten-thousandths of a degree; a tool without them
// reaches everything.
Contour Interpreter::close_for_tool(const Contour& part, bool facing, bool& closed) {
    const ToolState& tool = core_.path.tool;
    const std::int64_t number = settings_.geometry_by_offset ? tool.ref.offset : tool.ref.number;
    closed = false;
    if (number <= 0) return part;
    const auto n = static_cast<std::size_t>(number) % kTools;
    const double cutter = values_.tool(ToolField::NoseAngle, n) / 10'000.0,
                 cutting = values_.tool(ToolField::CutAngle, n) / 10'000.0;
    if (cutter <= 0 || cutting <= 0) return part;
    const Point call = cycle_call_point();
    const auto along = [facing](Point p) { return facing ? p.x : p.z; };
    const auto up = [facing](Point p) { return facing ? p.z : p.x; };
    const double s_sign = along(part.end()) > along(call) ? 1.0 : -1.0,
                 h_sign = up(call) >= up(part.first) ? 1.0 : -1.0;
    return cycles::closed_for(part, facing, s_sign, h_sign, {180.0 - cutting - cutter, cutting},
                              closed);
}

}  // namespace polyturn::channels::fagor
