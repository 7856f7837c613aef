#include "hmi/screens/graphics/graphics.hpp"

#include <QDateTime>
#include <QDir>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/graphics/graphics_look.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/set_words.hpp"

namespace polyturn::hmi {
namespace {

// the part as it is cut; paths and tips move with each frame
constexpr qint64 kStockEveryMs = 250;
// mm from the workpiece zero: beyond it no path is of interest
constexpr double kFurthest = 400;
constexpr int kArcParts = 24;
constexpr double kOnePoint = 1e-5;  // mm: what is nearer is the same point
constexpr qint64 kKeepEveryMs = 2'000;
constexpr double kSlowest = 1, kFastest = 64;

}  // namespace

Graphics::Graphics(Context& context) : Screen(context), head_(new FreeSheet(this)) {
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_OpaquePaintEvent);
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.text(QRectF(px(14), 0, px(200), head_->height()), word("Graphics"), lettering(20, true),
               t.text);
        double x = px(230);
        const std::size_t count = context_.live.channels().size();
        const double room = dry_ ? px(600) : px(240);
        const double step = std::min<double>(
            px(84), (head_->width() - room) / static_cast<double>(std::max<std::size_t>(1, count)));
        for (const unsigned channel : context_.live.channels()) {
            const bool dense = step < px(48);  // sixteen on a portrait panel
            const double stroke = dense           ? px(6)
                                  : step < px(80) ? px(12)
                                                  : px(26),
                         gap = px(dense ? 3 : 5);
            w.fill(QRectF(x, head_->height() / 2.0 - px(3), stroke, px(6)), colourOf(channel),
                   px(3));
            w.text(QRectF(x + stroke + gap, 0, step - stroke - gap - px(dense ? 1 : 3),
                          head_->height()),
                   QString("L%1").arg(channel),
                   dense ? lettering(12.5, true, Face::Condensed) : lettering(15, true), t.text);
            x += step;
        }
        const QRectF rest(x + px(8), 0, head_->width() - x - px(20), head_->height());
        if (dry_) {
            const QString words = dryWords();
            const QFont large = lettering(15, true);
            const double most = rest.width() - px(60),
                         wide = std::clamp(wordsWidth(words, large) + px(60),
                                           std::min<double>(px(290), most), most);
            const QRectF box(rest.right() - wide, px(6), wide, head_->height() - px(12));
            w.fill(box, t.mark, px(6));
            w.sign(QRectF(box.left() + px(10), box.center().y() - px(10), px(20), px(20)),
                   dryRun_.running() ? Sign::Wait
                   : playing_        ? Sign::Run
                                     : Sign::Hold,
                   t.accent);
            const QRectF inside = box.adjusted(px(38), 0, -px(10), 0);
            QFont font = large;
            // why there is nothing to simulate: on two lines
            if (wordsWidth(words, font) > inside.width())
                font = letteringThatFits(words, inside.size(), 13, 11.5, Face::Condensed);
            Item& line = w.text(inside, wordsCutTo(words, font, inside.size()), font, t.text);
            line.wraps = true;
            line.data = true;
            // how fast it is played
            w.text(QRectF(box.left() - px(60), 0, px(50), head_->height()),
                   QString::fromUtf8("× %1").arg(drySpeed_, 0, 'f', 0), lettering(15, true), t.dim,
                   kRight);
        } else if (count <= kFewChannels) {
            w.text(rest, word("Paths since these screens started; tips drawn as points"),
                   lettering(13.5), t.dim, Qt::AlignRight | Qt::AlignVCenter);
        }
    };
}

// Position of the simulation; nothing to simulate: why.
QString Graphics::dryWords() const {
    if (dryRun_.running())
        return word("The simulation is being computed: %1 so far").arg(timeText(dryRun_.end()));
    const auto& all = dryRun_.channels();  // an M code takes a moment too
    if (dryRun_.end() >= 1 || std::any_of(all.begin(), all.end(), [](const auto& one) {
            return !one.second.moves.empty();
        }))
        return word("Simulation: %1 of %2").arg(timeText(dryTime_), timeText(dryRun_.end()));
    for (const RunFault& fault : dryRun_.faults())
        if (fault.error)
            return word("Nothing to simulate: %1")
                .arg((fault.place.isEmpty() ? QString() : fault.place + "  ") + fault.number +
                     "  " + fault.text);
    return word("Nothing to simulate: %1")
        .arg(dryRun_.failure().isEmpty() ? word("the program takes no time") : dryRun_.failure());
}

void Graphics::resizeEvent(QResizeEvent*) {
    head_->setGeometry(0, 0, width(), px(46));
    redraw_ = true;
}

void Graphics::forget() {
    live_.clear();
    drySide_.clear();
    job_ = {};
    dry_ = playing_ = wanted_ = false;
    dryRun_.stop();
    redraw_ = true;
}

void Graphics::rebuilt() {
    forget();
    zeroZ_.clear();
    zeroDue_.clear();
    cycle_.clear();
    inWork_.clear();
    inRun_.clear();
}

// The job beside the running program that names it: its stock. Looked for aside: the folder may lie
// on a network.
void Graphics::findJob() {
    if (const auto found = finding_.take()) {
        job_ = *found;
        beginStock(live_);
        live_.cutAgain(live_.trails);  // it has been cut while the job was looked for
        if (wanted_) startDry();
    }
    if (finding_.busy()) return;
    for (const unsigned channel : context_.live.channels()) {
        const auto& programs = context_.live.view(channel).programs;
        if (programs.empty()) continue;
        if (programs[0] == job_.program) return;
        live_.clear();
        finding_.start([program = programs[0], channel](const std::atomic<bool>& stop) {
            FoundJob out{program, {}, {}, {}, channel};
            const QString wanted = QFileInfo(QString::fromStdString(program)).canonicalFilePath();
            const QDir folder(QFileInfo(QString::fromStdString(program)).absolutePath());
            for (const QFileInfo& file : folder.entryInfoList({"*.job.toml"}, QDir::Files)) {
                if (stop) break;
                const auto job = text::load_job(file.filePath().toStdString());
                if (!job) continue;
                for (const auto& [number, one] : job->programs)
                    if (QFileInfo(QString::fromStdString(one.file)).canonicalFilePath() == wanted)
                        out.file = file.filePath().toStdString();
                if (out.file.empty()) continue;
                out.stock = job->stock;
                for (const auto& [of, systems] : job->zeros)
                    if (const auto g54 = systems.find("G54"); g54 != systems.end())
                        if (const auto z = g54->second.find("Z"); z != g54->second.end())
                            out.zeros[of] = z->second;
                break;
            }
            return out;
        });
        return;
    }
}

// Where the workpiece zero of a channel is in the work area. Of the machine: as its running block
// has it. Of a dry run: as the run has reported it, else by the job's G54, with which it begins,
// else as the machine has it. Where it is not known, the blank touches its chuck.
CuttingScene::Zero Graphics::zeroOf(unsigned channel, bool dryRun) const {
    CuttingScene::Zero zero;
    const Room* room = room_.room();
    if (!room) return zero;
    const AxisConfig* z = find_axis(context_.live.config(), channel, PlaneRole::BasicZ);
    const auto axis = z ? room->axes.find(z->number) : room->axes.end();
    if (axis != room->axes.end() && std::abs(axis->second.direction.z) > 0.5)
        zero.sense = axis->second.direction.z < 0 ? -1 : 1;
    const unsigned spindle =
        job_.stock
            ? static_cast<unsigned>(std::strtoul(job_.stock->spindle.c_str() + 1, nullptr, 10))
            : 1;
    const auto chuck = room->chucks.find(spindle);
    if (chuck != room->chucks.end()) zero.x = chuck->second.origin.x;
    const auto known = zeroZ_.find(channel);
    const auto job = job_.zeros.find(channel);
    const bool told = job != job_.zeros.end() && axis != room->axes.end();
    const auto run = dryRun_.channels().find(channel);
    if (dryRun && run != dryRun_.channels().end() && run->second.zero && axis != room->axes.end())
        zero.z = axis->second.origin.z + zero.sense * *run->second.zero;
    else if (known != zeroZ_.end() && !(dryRun && told))
        zero.z = known->second;
    else if (told)
        // with which a dry run of the job begins
        zero.z = axis->second.origin.z + zero.sense * job->second;
    else if (chuck != room->chucks.end())
        zero.z = chuck->second.origin.z + zero.sense * (job_.stock ? job_.stock->length : 100);
    return zero;
}

void Graphics::beginStock(CuttingScene& scene) {
    if (!context_.live.channels().empty() && job_.stock)
        scene.begin(*job_.stock, zeroOf(context_.live.channels().front(), &scene == &drySide_));
    redraw_ = true;
}

void Graphics::followZero(unsigned channel, double tipZ) {
    const AxisConfig* z = find_axis(context_.live.config(), channel, PlaneRole::BasicZ);
    double at = 0;
    if (!z || z->slot == kNoSlot ||
        !context_.live.fromZero(channel, z->slot, now_.axes[z->number - 1u], at))
        return;
    const double zero = tipZ - zeroOf(channel).sense * at;
    const auto known = zeroZ_.find(channel);
    const bool first = zeroDue_.erase(channel) > 0 || known == zeroZ_.end();
    // a shift of the program is no other chucking
    if (!first && std::abs(known->second - zero) < 0.5) return;
    zeroZ_[channel] = zero;
    if (first && channel == context_.live.channels().front()) {
        live_.place(zeroOf(channel));
        redraw_ = true;
    }
}

void Graphics::followLive() {
    const Live& live = context_.live;
    for (const unsigned channel : live.channels()) {
        const ChannelStatus& status = live.channel(channel);
        if (status.cycle_s < cycle_[channel] && status.cycle_s < 0.5) {  // another part begins
            live_.trails.erase(channel);
            live_.changed = true;
            // the blank lies at the first zero that the part uses, not at the last one of the part
            // before
            zeroDue_.insert(channel);
            if (channel == live.channels().front()) beginStock(live_);
        }
        cycle_[channel] = status.cycle_s;
        const RoomBodies::Turret& tool = now_.turrets[channel - 1];
        RoomBodies::Vector at;
        const auto state = static_cast<ChannelState>(status.state);
        if (!room_.carrier(channel, now_, at) || !live.view(channel).known ||
            (state != ChannelState::Running && state != ChannelState::Held)) {
            live_.lift(channel);
            continue;
        }
        if (tool.tip_known) {
            at.x += tool.tip.x;
            at.z += tool.tip.z;
        }
        // before, the picture may be that of the program's end
        if (status.blocks > 0) followZero(channel, at.z);
        const CuttingScene::Zero zero = zeroOf(channel);
        if (std::abs(at.z - zero.z) > kFurthest || std::abs(at.x - zero.x) > kFurthest)
            live_.lift(channel);
        else
            live_.add(channel, at.z, at.x, live.view(channel).rapid, toolInWork(channel));
    }
}

// Asked for in every frame: looked up when it is another one, or its data are.
const CuttingTool& Graphics::toolInWork(unsigned channel) {
    const BlockPicture& picture = context_.live.view(channel).picture;
    const CalledTool called{static_cast<std::int32_t>(std::max<std::int64_t>(0, picture.tool)),
                            context_.live.channel(channel).tool, picture.geometry, picture.edge};
    return lookedUp(inWork_[channel], channel, called);
}

const CuttingTool& Graphics::lookedUp(LookedUp& known, unsigned channel, const CalledTool& called) {
    const std::uint64_t tools = context_.live.toolsVersion(), store = context_.live.storeVersion();
    if (!(known.called == called) || known.tools != tools || known.store != store)
        known = {called, tools, store, cuttingTool(context_.live, channel, called)};
    return known.tool;
}

void Graphics::follow() {
    if (!context_.live.connected()) return;
    if (room_.follow(context_.live)) {
        if (live_.trails.empty()) beginStock(live_);
        redraw_ = true;
    }
    findJob();
    now_ = room_.now(context_.live);
    bringBack();
    followLive();
    if (dry_) followDry();
    if (const qint64 time = QDateTime::currentMSecsSinceEpoch(); time >= keepAt_) {
        keepAt_ = time + kKeepEveryMs;
        keepPaths();
    }
}

// The job of the running program, else that program alone; on a copy of this machine's offsets and
// zeros.
void Graphics::startDry() {
    wanted_ = false;
    runBack_.reset();
    const QString file = QString::fromStdString(job_.file.empty() ? job_.program : job_.file);
    if (file.isEmpty()) return context_.tell(word("No program is selected."), Told::Refused);
    DryRun::Wanted run{file};
    if (job_.file.empty() && job_.channel) {
        run.channel = job_.channel;
        run.languages[job_.channel] = context_.live.programLanguage(job_.channel);
    }
    dryRun_.start(DryRun::How::Drive, run, QString::fromStdString(context_.live.instance()));
    dry_ = playing_ = true;
    dryTime_ = 0;
    dryFrom_ = now_;
    playTo(-1);
    clock_.start();
    if (context_.keysChanged) context_.keysChanged();
}

void Graphics::followDry() {
    const double passed = static_cast<double>(clock_.restart()) / 1000;
    if (dryRun_.running()) return;
    if (runBack_) return playTo(*std::exchange(runBack_, std::nullopt));
    if (!dryRun_.failure().isEmpty() && playing_) {
        playing_ = false;
        context_.tell(dryRun_.failure(), Told::Refused);
    }
    playTo(playing_ ? std::min(dryTime_ + passed * drySpeed_, dryRun_.end()) : dryTime_);
    if (playing_ && dryTime_ >= dryRun_.end()) {
        playing_ = false;
        if (context_.keysChanged) context_.keysChanged();
    }
}

// Where a channel comes from: events tell ends, so before its first one it stands where the machine
// stood when the simulation began.
RunMove Graphics::comesFrom(unsigned channel, const RunChannel& run, std::size_t move) const {
    if (move) return run.moves[move - 1];
    RunMove out = run.moves[0];
    const MachineConfig& config = context_.live.config();
    for (std::size_t i = 0;
         i < std::min<std::size_t>(static_cast<std::size_t>(run.axes.size()), out.machine.size());
         ++i)
        for (const std::uint16_t number : config.channel(channel).axis_numbers()) {
            const AxisConfig& axis = config.axis(number);
            if (QLatin1String(axis.name) != run.axes[static_cast<qsizetype>(i)]) continue;
            const double way = out.machine[i] - dryFrom_.axes[number - 1u];
            out.machine[i] -= way;
            if (&axis == find_axis(config, channel, PlaneRole::BasicX))
                out.x -= axis.diameter ? 2 * way : way;
            if (&axis == find_axis(config, channel, PlaneRole::BasicZ)) out.z -= way;
        }
    return out;
}

// What the channels have done until then; backwards it begins anew. Carriers stand where the run's
// axes stand.
void Graphics::playTo(double seconds) {
    if (seconds < dryTime_ || dryAt_.empty()) {
        dryAt_.clear();
        drySide_.clear();
        beginStock(drySide_);
    }
    dryTime_ = std::max(0.0, seconds);
    const MachineConfig& config = context_.live.config();
    for (const auto& [channel, run] : dryRun_.channels()) {
        const CuttingScene::Zero zero = zeroOf(channel, true);
        const AxisConfig* xAxis = find_axis(config, channel, PlaneRole::BasicX);
        const Room* room = room_.room();
        const auto xPlace = xAxis && room ? room->axes.find(xAxis->number)
                                          : std::map<unsigned, RoomPlace>::const_iterator{};
        const bool down =
            xAxis && room && xPlace != room->axes.end() && xPlace->second.direction.x < 0;
        const double share = xAxis && xAxis->diameter ? 0.5 : 1.0, side = down ? -1.0 : 1.0;
        const auto put = [&](const RunMove& of, double x, double z, bool rapid) {
            drySide_.add(channel, zero.z + zero.sense * z, zero.x + side * x, rapid,
                         lookedUp(inRun_[channel], channel, {of.tool, 0, of.offset, of.edge}));
        };
        Played& at = dryAt_[channel];
        const auto partOf = [&](const RunMove& move) {
            return move.end > move.t
                       ? std::clamp((dryTime_ - move.t) / (move.end - move.t), 0.0, 1.0)
                       : 1.0;
        };
        for (; at.move < run.moves.size() && run.moves[at.move].t <= dryTime_;
             ++at.move, at.part = 0) {
            const RunMove& move = run.moves[at.move];
            const RunMove from = comesFrom(channel, run, at.move);
            const double part = partOf(move), x0 = from.x * share, x1 = move.x * share;
            if (part > at.part && move.arc) {
                const double radius = std::hypot(x0 - move.centreX, from.z - move.centreZ),
                             begins = std::atan2(x0 - move.centreX, from.z - move.centreZ);
                const double turn =
                    arcTurn(std::atan2(x1 - move.centreX, move.z - move.centreZ) - begins,
                            move.clockwise, std::hypot(x1 - x0, move.z - from.z) < kOnePoint);
                const int first = static_cast<int>(at.part * kArcParts) + 1,
                          last = static_cast<int>(part * kArcParts);
                for (int i = first; i <= last; ++i) {
                    const double angle = begins + turn * i / kArcParts;
                    put(move, move.centreX + radius * std::sin(angle),
                        move.centreZ + radius * std::cos(angle), false);
                }
            } else if (part > at.part) {
                put(move, x0 + (x1 - x0) * part, from.z + (move.z - from.z) * part, move.rapid);
            }
            at.part = part;
            if (part < 1) break;
        }
        if (run.moves.empty()) continue;
        // Where its axes stand then.
        const std::size_t here = std::min(at.move, run.moves.size() - 1);
        const RunMove& move = run.moves[here];
        const RunMove from = comesFrom(channel, run, here);
        const double part = partOf(move);
        now_.turrets[channel - 1].station = now_.turrets[channel - 1].stands_at =
            static_cast<std::uint32_t>(std::max(move.tool, 0));
        for (std::size_t i = 0; i < std::min<std::size_t>(static_cast<std::size_t>(run.axes.size()),
                                                          move.machine.size());
             ++i)
            for (const std::uint16_t number : config.channel(channel).axis_numbers())
                if (QLatin1String(config.axis(number).name) == run.axes[static_cast<qsizetype>(i)])
                    now_.axes[number - 1u] =
                        from.machine[i] + (move.machine[i] - from.machine[i]) * part;
        // The tip is where the path is; from there to the carrier's point it is the tool.
        RoomBodies::Vector carrier;
        const auto trail = drySide_.trails.find(channel);
        if (trail == drySide_.trails.end() || trail->second.points.empty() ||
            !room_.carrier(channel, now_, carrier))
            continue;
        now_.turrets[channel - 1].tip_known = true;
        now_.turrets[channel - 1].tip = {trail->second.points.back().x - carrier.x,
                                         trail->second.points.back().z - carrier.z};
    }
}

bool Graphics::key(QKeyEvent* event) {
    switch (event->key()) {
        case Qt::Key_Left:
            moved_.rx() += 0.1;
            break;
        case Qt::Key_Right:
            moved_.rx() -= 0.1;
            break;
        case Qt::Key_Up:
            moved_.ry() += 0.1;
            break;
        case Qt::Key_Down:
            moved_.ry() -= 0.1;
            break;
        default:
            return false;
    }
    return redraw_ = true;
}

void Graphics::mouseMoveEvent(QMouseEvent* event) {
    if (!(event->buttons() & Qt::LeftButton)) return;
    const QPointF way = event->position() - drag_;
    drag_ = event->position();
    moved_ += QPointF(way.x() / width(), way.y() / height());
    redraw_ = true;
}

void Graphics::look(bool machine) {
    machine_ = machine;
    zoom_ = 1;
    moved_ = {};
    redraw_ = true;
}

void Graphics::turnTo(int page) {
    look(page == 1);
    if (page == 2) {
        if (job_.program.empty()) return;
        startDry();
        drySpeed_ = kFastest;
    } else if (dry_) {
        dry_ = playing_ = false;
        dryRun_.stop();
        redraw_ = true;
    }
}

void Graphics::refresh() {
    // of a run: its axes were set when it was played; those it does not move stay where they are
    bodies_ = room_.bodies(now_);
    head_->refresh();
    if (std::vector<ShownStroke> strokes = shownStrokes(context_.live, room_, now_);
        !(strokes == strokes_)) {
        strokes_ = std::move(strokes);
        redraw_ = true;
    }
    CuttingScene& scene = shown();
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    const qreal ratio = devicePixelRatioF();
    if (redraw_ || scene.changed || picture_.size() != (QSizeF(size()) * ratio).toSize() ||
        (scene.cut && now - painted_ >= kStockEveryMs)) {
        painted_ = now;
        redraw_ = scene.changed = scene.cut = false;
        for (auto& [channel, trail] : scene.trails) trail.drawn = 0;
        picture_ = QPixmap((QSizeF(size()) * ratio).toSize());
        picture_.setDevicePixelRatio(ratio);
        measure();
        drawRoom();
        takeLooks();
        update(0, head_->height(), width(), height() - head_->height());
        return;
    }
    // What has been added since the last frame, and what moves, where it was and where it is.
    QRegion changed = takeLooks();
    QPainter p(&picture_);
    p.setRenderHint(QPainter::Antialiasing);
    p.setClipRect(
        QRectF(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8)));
    for (auto& [channel, trail] : scene.trails)
        if (trail.drawn != trail.points.size()) {
            const QRectF drawn = drawTrail(p, channel, trail);
            changed |= (drawn | drawNames(p, drawn)).toAlignedRect();
        }
    if (!changed.isEmpty()) update(changed);
}

std::vector<SoftKey> Graphics::keys() {
    const auto zoom = [this](double factor) {
        zoom_ = std::clamp(zoom_ * factor, 0.2, 12.0);
        redraw_ = true;
    };
    std::vector<SoftKey> keys{{word("Larger"), [zoom] { zoom(1.25); }},
                              {word("Smaller"), [zoom] { zoom(0.8); }}};
    keys.push_back({word("Whole machine"),
                    [this] {
                        look(!machine_);
                        if (context_.keysChanged)
                            context_.keysChanged();
                        else
                            void();
                    },
                    Sign::None, true, machine_});
    keys.push_back({word("Simulation"),
                    [this] {
                        if (dry_) {
                            dry_ = playing_ = false;
                            runBack_.reset();
                            dryRun_.stop();
                            redraw_ = true;
                        } else if (job_.program.empty())
                            context_.tell(word("No program is selected."), Told::Refused);
                        else
                            startDry();
                        if (context_.keysChanged) context_.keysChanged();
                    },
                    Sign::Graphics, context_.live.connected() || dry_, dry_});
    if (!dry_) {
        keys.push_back({word("Clear"), [this] { forget(); }});
        return keys;
    }
    if (dryRun_.running()) {
        keys.push_back({word("Stop"),
                        [this] {
                            dryRun_.cancel();
                            if (context_.keysChanged)
                                context_.keysChanged();
                            else
                                void();
                        },
                        Sign::Stop});
        return keys;
    }
    keys.push_back({playing_ ? word("Pause") : word("Play"),
                    [this] {
                        if (!playing_ && dryTime_ >= dryRun_.end()) playTo(-1);
                        playing_ = !playing_;
                        clock_.restart();
                        if (context_.keysChanged) context_.keysChanged();
                    },
                    playing_ ? Sign::Hold : Sign::Right});
    keys.push_back({word("Slower"), [this] { drySpeed_ = std::max(drySpeed_ / 2, kSlowest); }});
    keys.push_back({word("Faster"), [this] { drySpeed_ = std::min(drySpeed_ * 2, kFastest); }});
    return keys;
}

}  // namespace polyturn::hmi
