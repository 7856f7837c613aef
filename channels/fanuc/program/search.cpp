#include "channels/fanuc/program/search.hpp"

#include "channels/fanuc/execution.hpp"

namespace polyturn::channels::fanuc {
namespace {

// Made when the first jump or call looks for something in the text.
const BlockIndex& index_of(Execution& x, FileId file) {
    if (x.text.indexes.size() <= file) x.text.indexes.resize(file + 1u);
    if (!x.text.indexes[file]) x.text.indexes[file] = std::make_unique<BlockIndex>();
    LineSource& source = x.files.source(file);
    if (x.text.indexes[file]->built()) return *x.text.indexes[file];
    // it moves the window
    if (&source == x.text.source) {
        x.text.kept_line = x.text.line;
        x.text.line = x.text.kept_line;
    }
    x.text.indexes[file]->build(source);
    return *x.text.indexes[file];
}

}  // namespace

// Block number `number` of the running program: forward from here, then from its beginning.
std::optional<TextPlace> find_block(Execution& x, std::int64_t number) {
    return index_of(x, x.calls.frames.back().file)
        .block(number, x.calls.frames.back().begin.offset, place_behind(x, x.text.behind).byte());
}

std::optional<TextPosition> find_program_in(Execution& x, FileId file, std::int64_t number) {
    return index_of(x, file).program(number);
}

TextPlace place_behind(const Execution& x, std::size_t column) {
    return x.text.line_left ? TextPlace(x.text.source->position(), column)
                            : TextPlace(x.text.source->next_position());
}

// The block there is the next to be read.
void go_on_at(Execution& x, const TextPlace& place) {
    x.text.source->seek(place);
    x.run.jumped = true;
    x.text.line_left =
        place.column != 0 && x.text.source->next(x.text.line) == LineSource::Status::Line;
    if (x.text.line_left) x.text.column = x.text.behind = place.column;
}

void go_to(Execution& x, const TextPlace& place) {
    // a loop asks the machine anew each time
    if (place.offset <= x.text.source->position().offset) x.run.fresh = false;
    go_on_at(x, place);
}

bool jump_to_block(Execution& x, std::int64_t number) {
    const auto found = find_block(x, number);
    if (!found) return x.core.fail(Alarm::SequenceNumberMissing, 'P', std::to_string(number));
    go_to(x, *found);
    return true;
}

}  // namespace polyturn::channels::fanuc
