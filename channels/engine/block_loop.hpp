// One step of a program: the stations between two blocks, in the order that all languages keep. A
// language is a type of static functions over its execution, so that a step costs what one written
// by hand would.
//
//   gate -> goes_on -> before_line -> serial, note_block -> next_line -> block
//                      '---------- not for a block read again ---------'
//
// The serial grows before a line is read, for blank lines and the end of the text too: the resume
// point of block n is noted before n is known.
#pragma once
#include <concepts>
#include <optional>

#include "channels/engine/block_edges.hpp"
#include "channels/engine/block_run.hpp"
#include "channels/language.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::engine {

// What a language gives. Execution has `Core core` and `BlockRun run` (or references to them).
// Where an optional Step is given, nothing means: go on with the next station.
template <class L>
concept BlockLanguage = requires(typename L::Execution& x, const Fault& fault) {
    // The second half of a block whose barrier has been passed.
    { L::goes_on(x) } -> std::same_as<std::optional<Step>>;
    // What comes to its end before the next block is read.
    { L::before_line(x) } -> std::same_as<std::optional<Step>>;
    // Block `run.serial` begins here: its resume point.
    { L::note_block(x) } -> std::same_as<void>;
    // The next line is kept, or what is left of the last one. A step: there is none, or it cannot
    // be read.
    { L::next_line(x) } -> std::same_as<std::optional<Step>>;
    // The block of the line that was kept.
    { L::block(x) } -> std::same_as<Step>;
    // Reports it with its place.
    { L::fault(x, fault) } -> std::same_as<Step>;
};

// The next block, or the same one once more.
template <BlockLanguage L>
Step read_block(typename L::Execution& x) {
    if (!x.run.reread) {
        if (const auto done = L::before_line(x)) return *done;
        x.core.at.serial = ++x.run.serial;
        L::note_block(x);
        if (const auto done = L::next_line(x)) return *done;
    }
    x.run.reread = false;
    return L::block(x);
}

template <BlockLanguage L>
Step step(typename L::Execution& x) {
    switch (gate(x.core, x.run)) {
        case Gate::Barrier:
            return Step::AtBarrier;
        case Gate::Fault:
            return L::fault(x, x.core.fault());
        case Gate::Ended:
            return Step::Ended;
        case Gate::Open:
            break;
    }
    if (const auto done = L::goes_on(x)) return *done;
    return read_block<L>(x);
}

}  // namespace polyturn::channels::engine
