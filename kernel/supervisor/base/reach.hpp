// Which files somebody may name to a running controller. It reads them with its own rights, and
// what is wrong with a file is reported with the line at fault: without a limit an operator could
// have any file of the computer read out to him.
//
//   operator and below   program folders: where the controller was started, PT_PROGRAM_FOLDERS, the
//                        examples that come with it, USB sticks, the places of /etc/polyturn/places
//   setter               these, and the machine's folder
//   maker                every file that the controller can read
//
// A link counts as what it leads to. A folder is never a root if it is the whole computer.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

class Reach {
public:
    Reach() = default;
    // Folders that do not exist are no roots; they may come later, as sticks do: looked up at each
    // question.
    Reach(std::vector<std::filesystem::path> programs, std::vector<std::filesystem::path> machine)
        : programs_(std::move(programs)), machine_(std::move(machine)) {}

    // FileOutside when `level` does not reach the file. One that does not exist passes: opening it
    // will say so.
    Result<void> may_read(const std::string& file, UserLevel level) const;

private:
    std::vector<std::filesystem::path> programs_, machine_;
};

// PT_PROGRAM_FOLDERS as the table has it now; relative ones begin at the program and add nothing.
// `machine_folder`: may be empty.
Reach reach_of(const params::Table& table, const std::string& machine_folder);

// The paths in lines NAME=/PATH ; comment, as the screens' list of places has them.
std::vector<std::filesystem::path> places_in(std::string_view text);

}  // namespace polyturn::supervisor
