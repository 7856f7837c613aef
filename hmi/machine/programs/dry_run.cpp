#include "hmi/machine/programs/dry_run.hpp"

#include <QCoreApplication>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QTimer>
#include <cmath>

#include "hmi/text/display_languages.hpp"
#include "hmi/text/retold.hpp"
#include "ipc/model/files/job.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::size_t kMostBlocks = 200'000;
// bytes: of a run that is kept; in one turn, some milliseconds
constexpr qsizetype kMostTold = 48 << 20, kReplayed = 48 << 10;
// mm: what the zero must have moved by; less is wear or rounding
constexpr double kOtherZero = 0.01;

}  // namespace

DryRun::~DryRun() { stop(); }

void DryRun::stop() {
    again_.clear();
    if (!process_) return;
    process_->disconnect();
    process_->kill();
    process_.release()->deleteLater();
}

void DryRun::cancel() {
    if (!running()) return;
    stop();
    failure_ = word("It was stopped.");
    meet();
}

void DryRun::begin(How how, Wanted wanted) {
    how_ = how;
    wanted_ = std::move(wanted);
    in_.clear();
    told_.clear();
    failure_.clear();
    channels_.clear();
    faults_.clear();
    ++version_;
}

// A line of what it was, then its events.
QByteArray DryRun::record() const {
    if (running() || !any() || told_.size() > kMostTold) return {};
    QJsonObject languages;
    for (const auto& [channel, language] : wanted_.languages)
        languages.insert(QString::number(channel), fromView(language_name(language)));
    return QJsonDocument(QJsonObject{{"job", wanted_.file},
                                     {"channel", static_cast<int>(wanted_.channel)},
                                     {"drive", how_ == How::Drive},
                                     {"languages", languages}})
               .toJson(QJsonDocument::Compact) +
           '\n' + told_;
}

void DryRun::replay(const QByteArray& record) {
    stop();
    const auto first = record.indexOf('\n');
    const QJsonObject about =
        QJsonDocument::fromJson(record.left(std::max<qsizetype>(0, first))).object();
    Wanted wanted{about.value("job").toString(),
                  static_cast<unsigned>(about.value("channel").toInt())};
    const QJsonObject named = about.value("languages").toObject();
    for (auto one = named.begin(); one != named.end(); ++one)
        wanted.languages[one.key().toUInt()] = dialect_of(one.value().toString().toStdString());
    begin(about.value("drive").toBool() ? How::Drive : How::Check, std::move(wanted));
    if (first < 0 || wanted_.file.isEmpty()) return;
    again_ = record.mid(first + 1);
    againAt_ = 0;
    replayPiece();
}

void DryRun::replayPiece() {
    const qsizetype last = againAt_ + kReplayed;
    while (againAt_ < std::min(again_.size(), last)) {
        const auto end = again_.indexOf('\n', againAt_);
        if (end < 0) break;
        take(again_.mid(againAt_, end - againAt_));
        againAt_ = end + 1;
    }
    ++version_;
    if (againAt_ >= last && againAt_ < again_.size())
        return QTimer::singleShot(0, &turns_, [this] {
            if (!again_.isEmpty()) replayPiece();
        });
    again_.clear();
    meet();
}

Dialect DryRun::language(unsigned channel, Dialect machine) const {
    const auto named = wanted_.languages.find(channel);
    return named == wanted_.languages.end() ? machine : named->second;
}

void DryRun::start(How how, Wanted wanted, const QString& like) {
    stop();
    begin(how, std::move(wanted));
    process_ = std::make_unique<QProcess>();
    process_->setStandardErrorFile(QProcess::nullDevice());
    QStringList arguments =
        how == How::Check ? QStringList{"check"} : QStringList{"run", "--virtual"};
    // a job says itself what its programs are
    const bool alone = !text::is_job_file(wanted_.file.toStdString());
    arguments << (alone && wanted_.channel
                      ? QString("L%1=%2").arg(wanted_.channel).arg(wanted_.file)
                      : wanted_.file);
    if (alone)
        for (const auto& [channel, language] : wanted_.languages)
            arguments << "--language"
                      << QString("%1=%2").arg(channel).arg(fromView(language_name(language)));
    if (!like.isEmpty()) arguments << "--like" << like;
    QObject::connect(process_.get(), &QProcess::readyReadStandardOutput, [this] { read(); });
    QObject::connect(process_.get(), &QProcess::finished,
                     [this] { QTimer::singleShot(0, process_.get(), [this] { finish(); }); });
    QObject::connect(process_.get(), &QProcess::errorOccurred,
                     [this](QProcess::ProcessError error) {
                         if (error == QProcess::FailedToStart) {
                             failure_ = word("The program polyturn is not beside the HMI.");
                             finish();
                         }
                     });
    process_->start(QCoreApplication::applicationDirPath() + "/polyturn", arguments);
}

void DryRun::read() {
    in_ += process_->readAllStandardOutput();
    int from = 0;
    for (int end = static_cast<int>(in_.indexOf('\n')); end >= 0;
         end = static_cast<int>(in_.indexOf('\n', from))) {
        take(in_.mid(from, end - from));
        from = end + 1;
    }
    in_.remove(0, from);
    ++version_;
}

void DryRun::take(const QByteArray& line) {
    if (told_.size() <= kMostTold) {
        told_ += line;
        told_ += '\n';
    }
    const QJsonObject event = QJsonDocument::fromJson(line).object();
    const QString what = event.value("ev").toString();
    const auto channel = static_cast<unsigned>(event.value("ch").toInt());
    const RunLine at{event.value("file").toString().toStdString(),
                     static_cast<std::uint32_t>(event.value("line").toInt())};
    if (what == "alarm") {
        const QJsonValue number = event.value("number");
        const QString written = alarmNumberText(number.isDouble() ? QString::number(number.toInt())
                                                                  : number.toString());
        const QString place = at.line
                                  ? QString("%1:%2")
                                        .arg(QFileInfo(event.value("file").toString()).fileName())
                                        .arg(at.line)
                                  : QString();
        // that the one part which is simulated is made is no fault
        if (written == fromView(alarm_number(Alarm::PartsDone, Dialect::Polyturn))) return;
        faults_.push_back({channel, event.value("severity").toString() != "warning", written,
                           retold(written, event.value("text").toString()).text, place, at});
        return;
    }
    if (channel == 0) return;
    RunChannel& own = channels_[channel];
    if (at.line && own.blocks.size() < kMostBlocks &&
        (own.blocks.empty() || own.blocks.back().line != at.line ||
         own.blocks.back().file != at.file))
        own.blocks.push_back(at);
    const double t = event.value("t").toDouble(-1), end = event.value("end").toDouble(t);
    own.end = std::max(own.end, end);
    if (what == "wait") {
        RunWait wait;
        wait.code = event.value("code").toInt();
        for (const auto& one : event.value("channels").toArray())
            wait.channels.push_back(static_cast<unsigned>(one.toInt()));
        wait.at = at;
        wait.before = own.blocks.size();
        wait.from = t;
        wait.to = end;
        own.waits.push_back(wait);
    } else if ((what == "move" || what == "dwell") && t >= 0) {
        const RunSpan::Kind kind = what == "dwell" ? RunSpan::Kind::Dwell
                                   : event.value("kind").toString() == "rapid"
                                       ? RunSpan::Kind::Rapid
                                       : RunSpan::Kind::Cutting;
        if (own.spans.size() < kMostBlocks) own.spans.push_back({kind, t, end, at.line});
        if (what == "move") takeMove(own, event, t, end);
    }
}

void DryRun::takeMove(RunChannel& own, const QJsonObject& event, double t, double end) {
    if (own.moves.size() >= kMostBlocks) return;
    const QJsonObject pos = event.value("pos").toObject(),
                      machine = event.value("machine").toObject(),
                      centre = event.value("centre").toObject();
    // what an event does not name stays where it is
    RunMove move = own.moves.empty() ? RunMove{} : own.moves.back();
    const QString kind = event.value("kind").toString();
    move.t = t;
    move.end = end;
    move.rapid = kind == "rapid" || kind == "reference";
    move.arc = (kind == "cw" || kind == "ccw") && !centre.isEmpty();
    move.clockwise = kind == "cw";
    move.x = pos.value("X").toDouble(move.x);
    own.programmedZ = pos.value("Z").toDouble(own.programmedZ);
    // The machine's coordinate less the programmed one is the workpiece zero with the tool's
    // offset. While the offset stays, a jump is another zero (G55 after G54, a shift): the path
    // goes on in the system that it began in. What a tool change adds belongs to the tool.
    const QJsonObject tool = event.value("tool").toObject();
    if (pos.contains("Z") && machine.contains("Z")) {
        const double shift = machine.value("Z").toDouble() - own.programmedZ;
        const QString offset = QString("%1 %2 %3")
                                   .arg(tool.value("number").toInt())
                                   .arg(tool.value("offset").toInt())
                                   .arg(tool.value("edge").toInt());
        if (offset == own.offset && std::abs(shift - own.shift) > kOtherZero)
            own.zeroMoved += shift - own.shift;
        own.shift = shift;
        own.offset = offset;
        if (!own.zero && tool.value("offset").toInt() == 0 && tool.value("edge").toInt() == 0)
            own.zero = shift - own.zeroMoved;
    }
    move.z = own.programmedZ + own.zeroMoved;
    move.centreX = centre.value("X").toDouble();
    move.centreZ = centre.value("Z").toDouble() + own.zeroMoved;
    for (auto one = machine.begin(); one != machine.end(); ++one) {
        auto place = own.axes.indexOf(one.key());
        if (place < 0) {
            place = own.axes.size();
            own.axes << one.key();
        }
        if (place < static_cast<qsizetype>(move.machine.size()))
            move.machine[static_cast<std::size_t>(place)] = one.value().toDouble();
    }
    move.tool = tool.value("number").toInt(move.tool);
    move.offset = tool.value("offset").toInt();
    move.edge = tool.value("edge").toInt();
    own.moves.push_back(move);
}

void DryRun::finish() {
    if (!process_) return;
    read();
    if (channels_.empty() && faults_.empty() && failure_.isEmpty())
        failure_ = word("It gave no result.");
    process_->disconnect();
    process_.release()->deleteLater();
    meet();
}

// When it is over.
void DryRun::meet() {
    // All channels of a wait leave it when the last one has come.
    std::map<std::pair<int, std::vector<unsigned>>, std::vector<std::vector<RunWait*>>> meetings;
    for (auto& [number, channel] : channels_) {
        std::map<std::pair<int, std::vector<unsigned>>, std::size_t> count;
        for (RunWait& wait : channel.waits) {
            auto& list = meetings[{wait.code, wait.channels}];
            const std::size_t turn = count[{wait.code, wait.channels}]++;
            if (list.size() <= turn) list.resize(turn + 1);
            list[turn].push_back(&wait);
        }
    }
    for (auto& [key, list] : meetings)
        for (auto& meeting : list) {
            double last = 0;
            for (const RunWait* wait : meeting) last = std::max(last, wait->from);
            for (RunWait* wait : meeting) wait->to = std::max(wait->to, last);
        }
    ++version_;
}

double DryRun::end() const {
    double out = 0;
    for (const auto& [number, channel] : channels_) out = std::max(out, channel.end);
    return out;
}

}  // namespace polyturn::hmi
