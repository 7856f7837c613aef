// What is known of the program files: where labels and subroutines stand, as far as they have been
// looked for, and the files of programs that were written by this program and run since. It only
// grows; nothing of it is taken back when blocks are discarded.
#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "channels/program_files.hpp"
#include "channels/text/line_source.hpp"
#include "ipc/diagnosis/diagnosis.hpp"

namespace polyturn::channels::fagor {

struct KnownPrograms {
    ProgramFiles& files;
    std::map<std::pair<FileId, std::int64_t>, TextPosition> labels;
    std::map<std::int64_t, std::pair<FileId, TextPosition>> subroutines;
    std::set<std::int64_t> looked_twice;        // by defined_twice()
    std::optional<Diagnosis> definition_fault;  // of a SUB of the main program
    // of written programs that were run: their files read these texts
    std::deque<std::shared_ptr<const std::string>> texts;
    std::map<const std::string*, FileId> text_files;
};

}  // namespace polyturn::channels::fagor
