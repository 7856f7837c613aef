// G70 to G73: the words of stock removal, and the contour between the blocks P and Q.
//
// A contour is read by a second interpreter with the state of this one and a recorder for a sink:
// variables, arcs, axis words and diagnoses are those of the language, and nothing of it leaves a
// trace. G70 drives the blocks themselves.
#include <cmath>

#include "channels/cycles/stock_removal.hpp"
#include "channels/fanuc/interpreter.hpp"

namespace polyturn::channels::fanuc {
namespace {

constexpr int kMostContourBlocks = 20'000;

bool is_empty(std::string_view line) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i] == '(') {
            i = line.find(')', i);
            if (i == std::string_view::npos) return false;
        } else if (line[i] != ' ' && line[i] != '\t' && line[i] != ';') {
            return false;
        }
    }
    return true;
}

}  // namespace

// A milling channel uses some of these numbers for drilling (N1611#0).
bool Interpreter::turning_cycles_available(const GCode& row) {
    const bool milling =
        core_.view().machine.channel(core_.view().channel).kind == ChannelKind::Mill;
    if (milling && !params::bit(core_.view().table(), params::n1611_turning_cyc_config,
                                core_.view().channel, 0))
        return core_.fail(Alarm::NotBuilt, 'G', std::string(row.name));
    return true;
}

// A length of the first block. Fanuc: it replaces the parameter from now on; nct: for the cycle
// that follows.
void Interpreter::keep_word(std::optional<double>& kept, char letter) {
    if (block_.has(letter))
        kept = radius_length(letter);
    else if (settings_.nct)
        kept.reset();
}

// U, W of the cycle block: a length along an axis, X as a diameter where the axis is one.
double Interpreter::shift_word(char letter, PlaneRole role) const {
    if (!block_.has(letter)) return 0.0;
    const MachineView& view = core_.view();
    const int place = view.axis_by_role(role);
    const bool diameter = place >= 0 && view.axes[static_cast<std::size_t>(place)].diameter;
    return length(block_.word(letter), place) * (diameter ? 0.5 : 1.0);
}

// D of series 15 counts the least increment and takes no point (fanuc_lathe 8.4).
bool Interpreter::series15_count(char letter, double& value) {
    const Word& word = block_.word(letter);
    if (word.has_point && !word.from_expression)
        return core_.fail(Alarm::PointForbidden, letter, std::string(1, letter));
    value = word.value;
    return true;
}

bool Interpreter::read_contour(cycles::Contour& contour, ContourText& text) {
    // a contour whose end is missing would read itself, and so on
    if (reads_contour_) return core_.fail(Alarm::ContourCodeIllegal, 'G');
    std::int64_t first = 0;
    if (!block_.has('P') || !block_.has('Q'))
        return core_.fail(Alarm::CycleWordMissing, 'G', block_.has('P') ? "Q" : "P");
    if (!whole('P', first) || !whole('Q', text.last)) return false;
    if (line_left_ && !is_empty(line_.substr(scanner_.stopped_at())))
        return core_.fail(Alarm::NotBuilt, 'G', "blocks behind a contour cycle in its line");
    const TextPosition here = source_->next_position();
    fault_line_ = core_.at.line;  // the search leaves the line
    const std::uint32_t own_line = core_.at.line;
    const auto found = find_block(first);
    fault_line_ = own_line;
    if (!found) return core_.fail(Alarm::ContourMissing, 'P', std::to_string(first));
    text.first = *found;
    text.directly = found->offset >= here.offset;
    std::string_view line;
    source_->seek(here);
    for (int skipped = 0; text.directly && source_->next_position().offset < found->offset;
         ++skipped)
        if (skipped > 100 || source_->next(line) != LineSource::Status::Line || !is_empty(line))
            text.directly = false;

    const MachineView& view = core_.view();
    const int z = view.axis_by_role(PlaneRole::BasicZ), x = view.axis_by_role(PlaneRole::BasicX);
    bool good = z >= 0 && x >= 0;
    if (!good) core_.fail(Alarm::PlaneAxisMissing, 'G');
    if (good) {
        cycles::ContourRecorder recorder(static_cast<unsigned>(z), static_cast<unsigned>(x));
        Interpreter reader(core_.view(), recorder, core_.port(), *files_, make_settings_);
        reader.core_.path = core_.path;
        reader.core_.at = core_.at;
        reader.modal() = modal();
        reader.finishing_ = {};
        reader.settings_ = settings_;
        reader.frames_ = frames_;
        reader.loops_ = loops_;
        reader.variables_.take_values(variables_);
        reader.names_ = names_;
        reader.variables_.undo().enable(true);
        reader.variables_.begin_block(1);
        reader.reads_contour_ = true;
        reader.source_ = source_;
        reader.go_on_at(text.first);
        good = read_contour_blocks(recorder, reader, text);
        if (!good) core_.set_fault(reader.core_.fault());
        reader.variables_.undo().back_to(0);
        contour = std::move(recorder.contour);
    }
    source_->seek(here);
    return good;
}

// Interprets block P to block Q; false: reader.core_.fault() says why.
bool Interpreter::read_contour_blocks(cycles::ContourRecorder& recorder, Interpreter& reader,
                                      ContourText& text) {
    Core& core = reader.core_;
    const auto z = static_cast<unsigned>(core.view().axis_by_role(PlaneRole::BasicZ)),
               x = static_cast<unsigned>(core.view().axis_by_role(PlaneRole::BasicX));
    const auto here = [&] {
        return cycles::Point{core.path.programmed[z], core.path.programmed[x]};
    };
    const auto fail_in = [&](Alarm alarm, const BlockContext& at, std::string detail) {
        core.fail(alarm, 0, std::move(detail));
        Fault fault = core.fault();
        fault.block = at;
        core.set_fault(std::move(fault));
        return false;
    };
    recorder.contour.start = here();
    recorder.from(here());
    const std::size_t depth = reader.frames_.size();
    for (int blocks = 0; blocks < kMostContourBlocks; ++blocks) {
        const Step step = reader.step();
        if (recorder.error) {
            const Diagnosis& why = *recorder.error;
            core.fail(why.alarm, 0, why.detail, why.values[0], why.values[1]);
            Fault fault = core.fault();
            fault.block = core.at;
            fault.block->line = why.place.line;
            fault.column = why.place.column;
            fault.length = why.place.length;
            core.set_fault(std::move(fault));
            return false;
        }
        if (recorder.foreign) return fail_in(Alarm::ContourCodeIllegal, *recorder.foreign, {});
        if (step == Step::AtBarrier || reader.drilling_ || reader.frames_.size() < depth)
            return fail_in(Alarm::ContourCodeIllegal, core.at, {});
        if (step != Step::Continue) break;  // the program ends before Q
        if (blocks == 0) {
            cycles::Contour& contour = recorder.contour;
            contour.first_block = core.at;
            for (unsigned k = 0; k < reader.axis_word_count_; ++k) {
                AxisValues ignored{};
                AxisSet named = 0;
                (void)reader.axis_word(reader.block_.words[reader.axis_words_[k]], ignored, named);
                contour.first_names_z = contour.first_names_z || (named >> z & 1u);
                contour.first_names_x = contour.first_names_x || (named >> x & 1u);
            }
            const bool coded = (reader.coded_groups_ >> static_cast<unsigned>(GGroup::Motion)) & 1u;
            if (!coded || reader.motion_->tenths > 10 ||
                !(contour.first_names_z || contour.first_names_x))
                return fail_in(Alarm::ContourFirstBlock, core.at, {});
            contour.approach_rapid = reader.motion_->tenths == 0;
            contour.first = here();
            contour.elements.clear();
        }
        if (core.at.block == text.last && reader.frames_.size() == depth) {
            text.behind = reader.place_behind(reader.column_);
            return true;
        }
    }
    core.fail(Alarm::ContourMissing, 'Q', std::to_string(text.last));
    return false;
}

// Where the program goes on behind a roughing cycle: fanuc behind the contour, nct with the contour
// itself unless SKP says otherwise (N1611#1).
void Interpreter::after_contour(const ContourText& text) {
    const bool skips =
        settings_.nct
            ? text.directly && params::bit(core_.view().table(), params::n1611_turning_cyc_config,
                                           core_.view().channel, 1)
            : text.first.offset >= source_->next_position().offset;
    if (!skips) return;
    go_on_at(text.behind);
}

bool Interpreter::g_stock_removal(const GCode& row) {
    if (!turning_cycles_available(row)) return false;
    const params::Table& table = core_.view().table();
    const unsigned l = core_.view().channel;
    const bool facing = row.tenths == (settings_.system == kC ? 740 : 720);
    const char depth_letter = facing ? 'W' : 'U';
    if (first_of_two() && !settings_.series15) {
        // Here already: in the second block the letter is the allowance's.
        if (block_.has(depth_letter) && block_.value(depth_letter) == 0)
            return core_.fail(Alarm::CycleValueIllegal, depth_letter, std::string(1, depth_letter));
        keep_word(cycle_data_.depth, depth_letter);
        keep_word(cycle_data_.escape, 'R');
        return true;
    }
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    cycles::StockRemoval cycle;
    cycle.facing = facing;
    cycle.depth = std::fabs(
        cycle_data_.depth.value_or(params::get(table, params::n1600_depth_of_cut, l) * unit));
    cycle.depth_letter = depth_letter;
    if (block_.has('D')) {
        double count = 0.0;
        if (!settings_.series15) return core_.fail(Alarm::AddressIllegal, 'D', "D");
        if (!series15_count('D', count)) return false;
        cycle.depth = std::fabs(radius_length('D'));
        cycle.depth_letter = 'D';
    }  // I, K have no effect in the series 15 format (fanuc_lathe 8.4), and no meaning elsewhere: they are left out
    cycle.escape =
        std::fabs(cycle_data_.escape.value_or(params::get(table, params::n1601_escape, l) * unit));
    cycle.allowance = {shift_word('W', PlaneRole::BasicZ), shift_word('U', PlaneRole::BasicX)};
    cycle.roughing_tolerance =
        params::get(table, params::n1613_tolerance_along_roughing_axis, l) * unit;
    cycle.cutting_tolerance =
        params::get(table, params::n1614_tolerance_along_cutting_axis, l) * unit;
    cycle.first_pocket_first =
        !settings_.nct || params::bit(table, params::n1611_turning_cyc_config, l, 2);
    // parts of an arc: its radius at the start counts
    cycle.arc_tolerance = 2 * settings_.arc_tolerance + 0.001;
    cycles::Contour contour;
    ContourText text;
    if (!read_contour(contour, text)) return false;
    cycle.pockets = contour.first_names_z && contour.first_names_x;
    core_.at.cycle = row.name;
    if (!cycles::remove_stock(core_, contour, cycle)) return false;
    after_contour(text);
    return true;
}

bool Interpreter::g_pattern(const GCode& row) {
    if (!turning_cycles_available(row)) return false;
    const params::Table& table = core_.view().table();
    const unsigned l = core_.view().channel;
    if (first_of_two() && !settings_.series15) {
        keep_word(cycle_data_.relief_x, 'U');
        keep_word(cycle_data_.relief_z, 'W');
        if (block_.has('R')) {
            // Fanuc counts divisions in whole numbers or, on older controls, in thousandths with a
            // point.
            const Word& word = block_.word('R');
            if (word.value < 1 && !(word.value > 0 && word.has_point && !settings_.nct))
                return core_.fail(Alarm::CycleValueIllegal, 'R', "R", word.value);
            cycle_data_.divisions = word.value < 1 ? word.value * 1000.0 : word.value;
        } else if (settings_.nct) {
            cycle_data_.divisions.reset();
        }
        return true;
    }
    // relief and divisions of the series 15 format (fanuc_lathe 8.4): without them other passes are
    // cut
    for (const char foreign : {'I', 'K', 'D'})
        if (!settings_.series15 && block_.has(foreign))
            return core_.fail(Alarm::AddressIllegal, foreign, std::string(1, foreign));
    const double unit = params::bit(table, params::n0104_unit_of_measure, l, 0) ? 25.4 : 1.0;
    cycles::Pattern cycle;
    cycle.relief = {
        cycle_data_.relief_z.value_or(params::get(table, params::n1602_relief_ax1, l) * unit),
        cycle_data_.relief_x.value_or(params::get(table, params::n1603_relief_ax2, l) * unit)};
    double passes = cycle_data_.divisions.value_or(
        static_cast<double>(params::get(table, params::n1604_numb_of_div, l)));
    if (settings_.series15) {
        if (block_.has('I')) cycle.relief.x = radius_length('I');
        if (block_.has('K')) cycle.relief.z = radius_length('K');
        if (block_.has('D') && !series15_count('D', passes)) return false;
    }
    if (!(passes >= 1 && passes <= cycles::kMostPasses))
        return core_.fail(Alarm::CycleValueIllegal, settings_.series15 ? 'D' : 'R',
                          settings_.series15 ? "D" : "R", passes);
    cycle.passes = static_cast<int>(std::lround(passes));
    // Fanuc: the last pass has no relief left; nct divides by the number itself and leaves the same
    // (nct part 2 17.3).
    cycle.divisor = settings_.nct || cycle.passes == 1 ? cycle.passes : cycle.passes - 1;
    cycle.allowance = {shift_word('W', PlaneRole::BasicZ), shift_word('U', PlaneRole::BasicX)};
    cycle.arc_tolerance = 2 * settings_.arc_tolerance + 0.001;
    cycles::Contour contour;
    ContourText text;
    if (!read_contour(contour, text)) return false;
    core_.at.cycle = row.name;
    if (!cycles::repeat_pattern(core_, contour, cycle)) return false;
    after_contour(text);
    return true;
}

// G70: the blocks P to Q as they stand, then back to where it was called.
bool Interpreter::g_finishing(const GCode& row) {
    if (!turning_cycles_available(row)) return false;
    if (finishing_.active) return core_.fail(Alarm::ContourCodeIllegal, 'G');
    cycles::Contour contour;  // read once before the tool moves: a mistake in it stops here
    ContourText text;
    if (!read_contour(contour, text)) return false;
    finishing_ = {
        true, row.name, text.last, source_->next_position(), frames_.size(), core_.path.programmed};
    go_on_at(text.first);
    return true;
}

// The return is the cycle's own and no part of the contour: as in G90 the nose leaves the contour
// at its last normal, and compensation begins again with the next block. As an element of the
// contour it would be an inner corner that most last blocks are too short for.
bool Interpreter::end_finishing() {
    core_.at.cycle = finishing_.name;
    core_.begin_cycle(Core::CycleMoves::Plain);
    const bool driven = core_.rapid(finishing_.start);
    core_.end_cycle();
    if (!driven) return false;
    finishing_.active = false;
    go_on_at(finishing_.resume);
    return true;
}

}  // namespace polyturn::channels::fanuc
