// `polyturn check` or `polyturn run --virtual` beside the live machine, on a copy of its offsets,
// zeros and parameters (--like): what
// the programs of a job will do. The process works; here its events are only collected, a piece at
// a time.
#pragma once
#include <QJsonObject>
#include <QProcess>
#include <QStringList>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "ipc/diagnosis/languages.hpp"

namespace polyturn::hmi {

struct RunLine {  // one block, or a part of it
    std::string file;
    std::uint32_t line = 0;
};
struct RunWait {
    int code = 0;
    std::vector<unsigned> channels;
    RunLine at;
    std::size_t before = 0;  // blocks of the channel before it
    double from = -1, to = -1;
};
struct RunSpan {
    enum class Kind : std::uint8_t { Cutting, Rapid, Dwell } kind = Kind::Cutting;
    double from = 0, to = 0;
    std::uint32_t line = 0;
};
struct RunMove {
    double t = 0, end = 0;
    bool rapid = false, arc = false, clockwise = false;
    // in the workpiece system that the channel begins with: x as the program has it, the centre as
    // a radius
    double x = 0, z = 0, centreX = 0, centreZ = 0;
    std::array<double, 6> machine{};  // of RunChannel::axes, true millimetres
    int tool = 0, offset = 0, edge = 0;
};
struct RunChannel {
    QStringList axes;            // names of those that RunMove::machine has
    std::vector<RunMove> moves;  // of a drive: those with X and Z
    // machine Z of that system's zero, where a move without tool offset has given it; mm
    std::optional<double> zero;
    // in the order in which they are executed; a block after itself counts once
    std::vector<RunLine> blocks;
    std::vector<RunWait> waits;
    std::vector<RunSpan> spans;
    double end = 0;
    double programmedZ = 0, shift = 0, zeroMoved = 0;  // while it is read: of the last move
    QString offset;                                    // with which shift holds
};
struct RunFault {
    unsigned channel = 0;
    bool error = true;
    QString number, text, place;
    RunLine at;
};

class DryRun {
public:
    enum class How : std::uint8_t { Check, Drive };
    struct Wanted {
        QString file;  // a job, or a program
        // that drives a program alone; 0: the first one
        unsigned channel = 0;
        std::map<unsigned, Dialect> languages = {};  // of the channels for which one is named
    };
    ~DryRun();
    void start(How how, Wanted wanted, const QString& like);
    void stop();
    // by somebody: what there is until now stays, and that it is not all
    void cancel();
    // What it has told, as it came; and told again from there, a piece in each turn of the event
    // loop. Empty: too much to be kept.
    QByteArray record() const;
    void replay(const QByteArray& record);
    bool running() const { return process_ != nullptr || !again_.isEmpty(); }
    bool any() const { return !channels_.empty() || !faults_.empty(); }
    const Wanted& wanted() const { return wanted_; }
    const QString& job() const { return wanted_.file; }
    // In which the program of the channel is written; `machine`: where nothing else is said.
    Dialect language(unsigned channel, Dialect machine) const;
    How how() const { return how_; }
    const QString& failure() const { return failure_; }  // the program could not be run at all
    const std::map<unsigned, RunChannel>& channels() const { return channels_; }
    const std::vector<RunFault>& faults() const { return faults_; }
    double end() const;
    std::uint64_t version() const { return version_; }

private:
    void begin(How how, Wanted wanted);
    void read();
    void take(const QByteArray& line);
    void takeMove(RunChannel& own, const QJsonObject& event, double t, double end);
    void finish();
    void replayPiece();
    void meet();

    std::unique_ptr<QProcess> process_;
    QByteArray in_;
    QByteArray told_, again_;  // all lines; those that are to be reported again
    qsizetype againAt_ = 0;
    QObject turns_;  // the turns that are still to come belong to it
    QString failure_;
    How how_ = How::Check;
    Wanted wanted_;
    std::map<unsigned, RunChannel> channels_;
    std::vector<RunFault> faults_;
    std::uint64_t version_ = 0;
};

}  // namespace polyturn::hmi
