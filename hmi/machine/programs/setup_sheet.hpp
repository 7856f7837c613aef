// The setup sheet of a job: what it needs besides what is mounted and entered, on the screen and on
// paper (PDF).
#pragma once
#include "hmi/machine/programs/file_text.hpp"
#include "hmi/machine/tools/edge_words.hpp"
#include "hmi/machine/tools/tool_words.hpp"
#include "ipc/model/machine/store/job_differences.hpp"

namespace polyturn::hmi {

struct SheetTool {
    // Unknown: nothing is entered for this turret
    enum class Match : std::uint8_t { Unknown, Same, Alike, Other, Missing } match = Match::Unknown;
    unsigned channel = 0, station = 0;
    QString wanted, mounted;
    std::int32_t tool = 0;  // data number of what is mounted
    StateWords state{};     // of it
};
// People write the same tool in more than one way: «roughing 80°», ROUGH_80. The same stem of a
// word, and no other number.
bool alikeNames(const QString& wanted, const QString& mounted);
std::vector<SheetTool> compareTools(const Live& live, const text::Job& job);
QString matchText(const SheetTool& tool);
// A job as its files have it now. Reading them may take as long as a network takes: by a worker.
struct JobSheet {
    QString path, fault;  // fault: the job cannot be read, nothing else is said
    text::Job job;
    text::Setup setup;          // empty where the job names none
    QString setupFault;         // why its setup file cannot be read; empty: it can
    bool otherMachine = false;  // it names another one than that of the controller
};
JobSheet readJobSheet(const QString& path, const std::string& machine,
                      DisplayLanguage display_language);
// The zeros and offsets that the job and its setup file name, beside those that are entered:
// selecting the job leaves them as they are.
std::vector<JobZero> compareZeros(const Live& live, const JobSheet& sheet);
QString zeroWanted(const Live& live, const JobZero& zero);  // «-150.000», in the unit of its axis
QString zeroText(const Live& live, const JobZero& zero);    // and what is entered
std::vector<JobOffset> compareOffsets(const Live& live, const JobSheet& sheet);
enum class OffsetSide : std::uint8_t { Wanted, Entered };
enum class OffsetPart : std::uint8_t { Geometry, Wear };
// «X 38.12  Z 27.05»; not all: only what is otherwise
QString offsetText(const Live& live, const JobOffset& offset, OffsetSide side, OffsetPart part,
                   bool all);
// One value that the job brings, and that one request enters.
struct JobEntry {
    QString name;   // «L1 G54 Z»
    QString words;  // of the request, as `polyturn set` has them, without the value
    double wanted = 0, entered = 0;
    QString request(double value) const;
    bool same() const;
};
// Its zeros and offsets, those that this machine has.
std::vector<JobEntry> jobEntries(const Live& live, const JobSheet& sheet);

// An edge of a tool that the setup file names ($TC_DPx), beside the one that the channel's tools
// have.
struct JobEdge {
    struct Value {
        int dp = 0;
        double wanted = 0, entered = 0;
    };
    unsigned channel = 0;
    EdgeLine line;
    std::vector<Value> values;
    bool same() const;
};
std::vector<JobEdge> compareEdges(const Live& live, const JobSheet& sheet);
QString edgeText(const Live& live, const JobEdge& edge, OffsetSide side, OffsetPart part, bool all);
// in one line; empty: nothing
QString jobDiffers(const Live& live, const JobSheet& sheet);
// Its content, as HTML; then on paper.
QString sheetText(const Live& live, const JobSheet& sheet);
FileOutcome writeSheet(const QString& html, const QString& title, const QString& file,
                       FileProgress& progress, const std::atomic<bool>& stop);

}  // namespace polyturn::hmi
