// What the screen of graphics shows again after a restart: the view of the work area, the paths of
// the running part, the run that was played.
#include <QStringList>
#include <algorithm>
#include <cmath>

#include "hmi/screens/graphics/graphics.hpp"
#include "hmi/screens/graphics/kept_paths.hpp"

namespace polyturn::hmi {
namespace {

constexpr auto kOfRun = KeptPieces::Span::Lasting;
constexpr auto kOfPaths = KeptPieces::Span::Passing;
// what is kept may be a little newer than the status that is read first
constexpr double kSameCycle_s = 0.5;

}  // namespace

// The whole machine or the part, how large and where; of a run, at what time it stands (while it is
// played: about).
QString Graphics::state() const {
    QStringList out{machine_ ? "machine" : "part", QString::number(zoom_),
                    QString::number(moved_.x()), QString::number(moved_.y())};
    if (dry_)
        out << QString::number(runBack_   ? *runBack_
                               : playing_ ? std::floor(dryTime_ / 5) * 5
                                          : dryTime_);
    return out.join(' ');
}

void Graphics::restore(const QString& state) {
    const QStringList parts = state.split(' ');
    look(parts[0] == "machine");
    if (parts.size() < 4) return;
    zoom_ = std::clamp(parts[1].toDouble(), 0.2, 12.0);
    moved_ = {parts[2].toDouble(), parts[3].toDouble()};
    if (parts.size() > 4) runBack_ = std::max(0.0, parts[4].toDouble());
}

void Graphics::keepPaths() {
    if (dry_ && !runBack_ && !dryRun_.running() && keptVersion_ != dryRun_.version()) {
        keptVersion_ = dryRun_.version();
        context_.kept.put("graphics-run", dryRun_.record(), kOfRun);
    }
    if (pathsBack_ || !context_.live.connected() || job_.program.empty()) return;
    KeptPaths out;
    out.machineRun = context_.live.machineRun();
    out.program = job_.program;
    out.radii = live_.stock.radii();
    out.holes = live_.stock.holes();
    for (const auto& [number, trail] : live_.trails) {
        const ChannelStatus& now = context_.live.channel(number);
        const auto zero = zeroZ_.find(number);
        out.channels[number] = {now.cycles, now.cycle_s, zero == zeroZ_.end() ? 0.0 : zero->second,
                                zero != zeroZ_.end() && !zeroDue_.count(number), trail.points};
    }
    QByteArray bytes = out.written();
    if (bytes != context_.kept.get("paths", kOfPaths))
        context_.kept.put("paths", std::move(bytes), kOfPaths);
}

void Graphics::bringBack() {
    bringBackPaths();
    // the blank and its zero are the job's
    if (!runBack_ || dry_ || job_.program.empty() || finding_.busy()) return;
    const auto piece = context_.kept.get("graphics-run", kOfRun);
    if (!piece) return;  // it is still being read
    dryRun_.replay(*piece);
    if (!dryRun_.any() && !dryRun_.running()) return runBack_.reset();
    keptVersion_ = dryRun_.running() ? 0 : dryRun_.version();
    dry_ = true;
    playing_ = false;
    dryTime_ = 0;
    dryFrom_ = now_;
    dryAt_.clear();
    clock_.start();
    if (context_.keysChanged) context_.keysChanged();
}

// When the job of the running program is known, and with it the blank.
void Graphics::bringBackPaths() {
    if (!pathsBack_ || job_.program.empty() || finding_.busy() || !room_.room()) return;
    const auto piece = context_.kept.get("paths", kOfPaths);
    if (!piece) return;
    pathsBack_ = false;
    const KeptPaths kept = KeptPaths::read(*piece);
    if (kept.machineRun == 0 || kept.machineRun != context_.live.machineRun() ||
        kept.program != job_.program)
        return;
    bool samePart = false;
    const std::map<unsigned, Trail> since = live_.trails;  // since these screens have come
    for (const auto& [number, one] : kept.channels) {
        const auto& all = context_.live.channels();
        if (std::find(all.begin(), all.end(), number) == all.end()) continue;
        const ChannelStatus& now = context_.live.channel(number);
        const auto state = static_cast<ChannelState>(now.state);
        const bool works = state == ChannelState::Running || state == ChannelState::Held ||
                           state == ChannelState::Waiting || state == ChannelState::ProgramStop;
        // it may have come to its end meanwhile
        if (one.cycles != now.cycles && (works || one.cycles + 1 != now.cycles)) continue;
        if (one.cycle_s > now.cycle_s + kSameCycle_s) continue;
        if (one.zeroKnown) zeroZ_.emplace(number, one.zeroZ);
        live_.addBefore(number, one.points);
        samePart |= number == all.front();
    }
    if (samePart) {
        beginStock(live_);  // with the zeros as they are known now
        live_.stock.cutTo(kept.radii, kept.holes);
        live_.cutAgain(since);
    }
    redraw_ = true;
}

}  // namespace polyturn::hmi
