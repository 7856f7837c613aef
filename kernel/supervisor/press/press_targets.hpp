// What `press` and `set` name and say: numbers, on and off, inputs of the machine, drives that
// fail.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/image/commands.hpp"
#include "ipc/model/machine/machine_config.hpp"

namespace polyturn::supervisor {

// Between blanks and tabs.
std::vector<std::string_view> words_of(std::string_view line);
std::optional<double> number_of(std::string_view word);  // with or without a sign
std::optional<bool> on_off(std::string_view word);

// "input 5", "I5", "SKIP", "XAE L2": the number of an input, -1 when it is none.
int input_number(std::string_view words);

// "#1000 L1" to "#1031 L1", "$A_IN[1] L1" to "$A_IN[32] L1": an input of the program as it names
// it, one bit of CP_UIN (from 1).
struct ProgramInput {
    std::uint32_t slot = 0, bit = 0;
};
std::optional<ProgramInput> program_input(std::string_view words);

// "A3" or "S1" and fault, ok, or encoder (an axis).
Result<std::vector<Command>> drive_fault(std::string_view whom, std::string_view value,
                                         const MachineConfig& machine);

}  // namespace polyturn::supervisor
