#include "channels/fanuc/program/faults.hpp"

#include <cmath>
#include <utility>

#include "channels/fanuc/execution.hpp"
#include "channels/fanuc/program/fault_place.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Where what went wrong names no letter: the centre or radius of an arc that does not fit;
// otherwise the code that moves, the last G word or the first word of the block.
const Word* word_at_fault(const Execution& x, Alarm alarm) {
    if (x.block.count == 0 || x.text.line.empty()) return nullptr;
    if (alarm == Alarm::ArcRadiusDiffers || alarm == Alarm::CompArcCentre)
        for (const char letter : {'R', 'I', 'J', 'K'})
            if (x.block.has(letter)) return &x.block.word(letter);
    const Word* found = nullptr;
    for (std::size_t k = 0; k < x.block.count; ++k) {  // it may not have been classified yet
        const Word& word = x.block.words[k];
        if (word.address == 'N' || word.address == 'O') continue;
        if (word.address == 'G') {
            if (const GCode* row = x.vocabulary.table.find(
                    static_cast<std::uint32_t>(std::lround(std::fabs(word.value) * 10.0)));
                row && row->group == GGroup::Motion)
                return &word;
            found = &word;
        }
        if (!found) found = &word;
    }
    return found;
}

// The source's position is unchanged afterwards; the line that was read last is no longer there.
LinePlace place_in_file(Execution& x, FileId file, std::uint32_t wanted, char letter) {
    LineSource& source = x.files.source(file);
    const TextPosition back = source.next_position();
    source.seek({0, 1});
    std::string_view line;
    LinePlace place;
    while (source.next(line) == LineSource::Status::Line) {
        if (source.position().line < wanted) continue;
        if (source.position().line == wanted)
            place = place_in_line(line, x.vocabulary.table, letter);
        if (place.column) place.column = character_column(line, place.column);
        break;
    }
    source.seek(back);
    x.text.line = {};
    return place;
}

}  // namespace

void blame(Execution& x, const Word& word) {
    x.words.culprit.column = word.column;
    x.words.culprit.length = word.length;
}

Step report_at(Execution& x, Alarm alarm, std::uint32_t column, std::uint32_t length,
               std::string detail, double v0, double v1) {
    Diagnosis diagnosis;
    diagnosis.alarm = alarm;
    diagnosis.place = {x.files.path(x.calls.frames.back().file),
                       x.words.culprit.line ? x.words.culprit.line : x.text.source->position().line,
                       column ? character_column(x.text.line, column) : 0, length};
    // another line than the one at hand is at fault
    if (!column && diagnosis.alarm != Alarm::FileUnreadable &&
        diagnosis.alarm != Alarm::LineTooLong) {
        const LinePlace place =
            place_in_file(x, x.calls.frames.back().file, diagnosis.place.line, 0);
        diagnosis.place.column = place.column;
        diagnosis.place.length = place.length;
    }
    diagnosis.values = {v0, v1};
    diagnosis.detail = std::move(detail);
    x.core.sink().alarm(diagnosis, x.core.at);
    x.run.ended = true;
    return Step::Failed;
}

Step report(Execution& x, Fault fault) {
    // An inner chamfer or corner R that is smaller than the nose (fanuc_lathe 3.16).
    if ((fault.alarm == Alarm::CompInterference || fault.alarm == Alarm::CompNoIntersection) &&
        x.corners.count) {
        const std::uint32_t line = fault.block ? fault.block->line : x.core.at.line;
        for (std::size_t k = 0; k < x.corners.lines.size(); ++k) {
            if (x.corners.lines[k] != line) continue;
            fault.alarm = Alarm::CompCornerElement;
            if (!fault.column && !fault.letter) fault.letter = x.corners.letters[k];
        }
    }
    if (fault.block) {  // an earlier block of the program
        const BlockContext& at = *fault.block;
        if (!fault.column) {
            const LinePlace place = place_in_file(x, at.file, at.line, fault.letter);
            fault.column = place.column;
            fault.length = place.length;
        }
        x.core.sink().alarm({fault.alarm,
                             {x.files.path(at.file), at.line, fault.column, fault.length},
                             {fault.value0, fault.value1},
                             std::move(fault.detail)},
                            at);
        x.run.ended = true;
        return Step::Failed;
    }
    std::uint32_t column = x.words.culprit.column, length = x.words.culprit.length;
    if (!column && fault.letter >= 'A' && fault.letter <= 'Z' && x.block.has(fault.letter)) {
        const Word& word = x.block.word(fault.letter);
        column = word.column;
        length = word.length;
    }
    if (!column && !x.words.culprit.line) {
        if (const Word* word = word_at_fault(x, fault.alarm)) {
            column = word->column;
            length = word->length;
        }
    }
    return report_at(x, fault.alarm, column, length, std::move(fault.detail), fault.value0,
                     fault.value1);
}

}  // namespace polyturn::channels::fanuc
