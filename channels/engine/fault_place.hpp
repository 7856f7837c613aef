// Where a fault lies, and how it is reported. A place is noted by the code that refuses, when it
// knows better than the letter in Fault says; the language looks the letter up in its words.
#pragma once
#include <cstdint>
#include <string>
#include <utility>

#include "channels/engine/block_run.hpp"
#include "channels/language.hpp"
#include "channels/program_files.hpp"
#include "channels/state/core.hpp"

namespace polyturn::channels::engine {

struct FaultPlace {
    std::uint32_t column = 0, length = 0;  // byte in the line, from 1; 0: by the letter
    std::uint32_t line = 0;                // another line of the file; 0: the line under way
};

// The alarm is told, and the program is over.
inline Step report(Core& core, BlockRun& run, const Diagnosis& diagnosis, const BlockContext& at) {
    core.sink().alarm(diagnosis, at);
    run.ended = true;
    return Step::Failed;
}

// A fault of another block than the one under way (Fault::block).
inline Step report_elsewhere(Core& core, BlockRun& run, const ProgramFiles& files, Fault fault) {
    const BlockContext at = *fault.block;
    return report(core, run,
                  {fault.alarm,
                   {files.path(at.file), at.line, fault.column, fault.length},
                   {fault.value0, fault.value1},
                   std::move(fault.detail)},
                  at);
}

}  // namespace polyturn::channels::engine
