// Which programs run, and where in their texts. Each level is a program or a section that REPEAT
// runs; the last one reads its blocks from `source`. An index of labels and structures is made of
// a text when it is first asked for.
#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "channels/program_files.hpp"
#include "channels/sinumerik/flow/text_index.hpp"
#include "channels/sinumerik/modal.hpp"

namespace polyturn::channels::sinumerik {

// A program level: main program, subprogram, or a section that REPEAT runs.
struct Level {
    FileId file = 0;
    TextPosition begin;                        // first block
    std::uint64_t end = ~std::uint64_t{0};     // sections: byte behind their last line
    TextPosition call, resume;                 // block of the caller, and where it goes on
    std::int64_t repeats = 0;                  // runs still to come after this one
    bool section = false, block_only = false;  // REPEAT, REPEATB
    bool modal_call = false;                   // called by MCALL
    std::shared_ptr<const HolePattern> holes;  // called at a hole, others are to come
    bool interrupt = false;       // called by an interrupt: the block behind it is read again
    AxisValues begin_of_block{};  // its increments count from here
    bool save = false;            // PROC ... SAVE: modal state comes back
    bool hides_steps = false;     // PROC ... SBLOF: single block does not stop in it
    std::string name;
    std::shared_ptr<Scope> scope;
    std::shared_ptr<const Modal> saved;
};

struct CallState {
    std::vector<Level> levels;
    LineSource* source = nullptr;
    std::map<FileId, TextIndex> indices;
};

}  // namespace polyturn::channels::sinumerik
