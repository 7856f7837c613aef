// The setup sheet of a job: what it needs beside what is mounted, on the screen and on paper (PDF).
#pragma once
#include "hmi/machine/file_text.hpp"
#include "hmi/machine/tool_words.hpp"
#include "ipc/machine/job_differences.hpp"

namespace polyturn::hmi {

struct SheetTool {
    enum class Match : std::uint8_t { Unknown, Same, Other, Missing } match = Match::Unknown;   // Unknown: nothing is entered for this turret
    unsigned channel = 0, station = 0;
    QString wanted, mounted;
    std::int32_t tool = 0;             // data number of what is mounted
    StateWords state{};                // of it
};
std::vector<SheetTool> compareTools(const Live& live, const text::Job& job);
QString matchText(const SheetTool& tool);
// The zeros that the job names, beside those that are entered: selecting the job leaves them as they are.
std::vector<JobZero> compareZeros(const Live& live, const text::Job& job);
QString zeroText(const JobZero& zero);           // «-150.000», and beside it what is entered
// What stands on it, as HTML; then on paper, which may take as long as a network takes: by a worker.
QString sheetText(const Live& live, const text::Job& job);
FileOutcome writeSheet(const QString& html, const QString& title, const QString& file, FileProgress& progress, const std::atomic<bool>& stop);

}  // namespace polyturn::hmi
