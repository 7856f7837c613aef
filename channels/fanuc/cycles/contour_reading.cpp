#include "channels/fanuc/cycles/contour_reading.hpp"

#include <utility>

#include "channels/cycles/contour.hpp"
#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/grammar/word_values.hpp"
#include "channels/fanuc/motion/targets.hpp"
#include "channels/fanuc/program/reading.hpp"
#include "channels/fanuc/program/search.hpp"

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

// Interprets block P to block Q; false: reader.core.fault() says why.
bool read_contour_blocks(cycles::ContourRecorder& recorder, Execution& reader, ContourText& text) {
    Core& core = reader.core;
    const auto z_place = static_cast<unsigned>(core.view().axis_by_role(PlaneRole::BasicZ)),
               x_place = static_cast<unsigned>(core.view().axis_by_role(PlaneRole::BasicX));
    const auto here = [&] {
        return cycles::Point{core.path.programmed[z_place], core.path.programmed[x_place]};
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
    const std::size_t depth = reader.calls.frames.size();
    for (int blocks = 0; blocks < kMostContourBlocks; ++blocks) {
        const Step step = fanuc::step(reader);
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
        if (step == Step::AtBarrier || reader.modal.drilling || reader.calls.frames.size() < depth)
            return fail_in(Alarm::ContourCodeIllegal, core.at, {});
        if (step != Step::Continue) break;  // the program ends before Q
        if (blocks == 0) {
            cycles::Contour& contour = recorder.contour;
            contour.first_block = core.at;
            for (unsigned k = 0; k < reader.words.axis_count; ++k) {
                AxisValues ignored{};
                AxisSet named = 0;
                (void)axis_word(reader, reader.block.words[reader.words.axes[k]], ignored, named);
                contour.first_names_z = contour.first_names_z || (named >> z_place & 1u);
                contour.first_names_x = contour.first_names_x || (named >> x_place & 1u);
            }
            const bool coded = reader.words.has(GGroup::Motion);
            if (!coded || reader.modal.motion->tenths > 10 ||
                !(contour.first_names_z || contour.first_names_x))
                return fail_in(Alarm::ContourFirstBlock, core.at, {});
            contour.approach_rapid = reader.modal.motion->tenths == 0;
            contour.first = here();
            contour.elements.clear();
        }
        if (core.at.block == text.last && reader.calls.frames.size() == depth) {
            text.behind = place_behind(reader, reader.text.column);
            return true;
        }
    }
    core.fail(Alarm::ContourMissing, 'Q', std::to_string(text.last));
    return false;
}

}  // namespace

bool read_contour(Execution& x, cycles::Contour& contour, ContourText& text) {
    // a contour whose end is missing would read itself, and so on
    if (x.reading.contour) return x.core.fail(Alarm::ContourCodeIllegal, 'G');
    std::int64_t first = 0;
    if (!x.block.has('P') || !x.block.has('Q'))
        return x.core.fail(Alarm::CycleWordMissing, 'G', x.block.has('P') ? "Q" : "P");
    if (!whole_number(x, 'P', first) || !whole_number(x, 'Q', text.last)) return false;
    if (x.text.line_left && !is_empty(x.text.line.substr(x.scanner.stopped_at())))
        return x.core.fail(Alarm::NotBuilt, 'G', "blocks behind a contour cycle in its line");
    const TextPosition here = x.text.source->next_position();
    x.words.culprit.line = x.core.at.line;  // the search leaves the line
    const std::uint32_t own_line = x.core.at.line;
    const auto found = find_block(x, first);
    x.words.culprit.line = own_line;
    if (!found) return x.core.fail(Alarm::ContourMissing, 'P', std::to_string(first));
    text.first = *found;
    text.directly = found->offset >= here.offset;
    std::string_view line;
    x.text.source->seek(here);
    for (int skipped = 0; text.directly && x.text.source->next_position().offset < found->offset;
         ++skipped)
        if (skipped > 100 || x.text.source->next(line) != LineSource::Status::Line ||
            !is_empty(line))
            text.directly = false;

    const MachineView& view = x.core.view();
    const int z_place = view.axis_by_role(PlaneRole::BasicZ),
              x_place = view.axis_by_role(PlaneRole::BasicX);
    bool good = z_place >= 0 && x_place >= 0;
    if (!good) x.core.fail(Alarm::PlaneAxisMissing, 'G');
    if (good) {
        cycles::ContourRecorder recorder(static_cast<unsigned>(z_place),
                                         static_cast<unsigned>(x_place));
        Execution reader(x.core.view(), recorder, x.core.port(), x.files, x.make_settings);
        reader.core.path = x.core.path;
        reader.core.at = x.core.at;
        reader.modal = x.modal;
        reader.modal.cycles.finishing = {};
        reader.settings = x.settings;
        reader.calls.frames = x.calls.frames;
        reader.calls.loops = x.calls.loops;
        reader.macro.variables.take_values(x.macro.variables);
        reader.macro.names = x.macro.names;
        reader.macro.variables.undo().enable(true);
        reader.macro.variables.begin_block(1);
        reader.reading.contour = true;
        reader.text.source = x.text.source;
        go_on_at(reader, text.first);
        good = read_contour_blocks(recorder, reader, text);
        if (!good) x.core.set_fault(reader.core.fault());
        reader.macro.variables.undo().back_to(0);
        contour = std::move(recorder.contour);
    }
    x.text.source->seek(here);
    return good;
}

// Where the program goes on behind a roughing cycle: fanuc behind the contour, nct with the contour
// itself unless SKP says otherwise (N1611#1).
void after_contour(Execution& x, const ContourText& text) {
    const bool skips =
        x.settings.policy.cycles.goes_on_with_contour
            ? text.directly && params::bit(x.core.view().table(), params::n1611_turning_cyc_config,
                                           x.core.view().channel, 1)
            : text.first.offset >= x.text.source->next_position().offset;
    if (!skips) return;
    go_on_at(x, text.behind);
}

}  // namespace polyturn::channels::fanuc
