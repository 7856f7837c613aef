#include "hmi/screens/graphics.hpp"

#include <QDateTime>
#include <QDir>
#include <QLinearGradient>
#include <QPainterPath>
#include <algorithm>
#include <cmath>

#include "hmi/machine/channel_words.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::size_t kFewChannels = 4;   // whose legend leaves room for a note

constexpr std::size_t kMostPoints = 20'000;
constexpr double kLeastWay = 0.02;     // mm
constexpr qint64 kStockEveryMs = 250;   // the part as it is cut; paths and tips move with each frame
constexpr double kFurthest = 400;      // mm from the zero: beyond it nothing is of interest

QColor colourOf(unsigned channel) {
    static const QColor kDark[] = {"#4ea6ff", "#ff9d5c", "#42c883", "#e57bd8"}, kLight[] = {"#0a63bd", "#b84e00", "#127c3e", "#9a2d8d"};
    return (theme().dark ? kDark : kLight)[(channel - 1) % 4];
}

}  // namespace

void TurnedStock::begin(double diameter, double bore, double length, double face) {
    outer_ = diameter / 2, bore_ = bore / 2;
    left_ = -length;
    const auto count = static_cast<std::size_t>(std::clamp((length + face) / kStep, 0.0, 50'000.0));
    radius_.assign(count, outer_);
}

void TurnedStock::cut(double z0, double x0, double z1, double x1) {
    if (radius_.empty()) return;
    if (z0 > z1) std::swap(z0, z1), std::swap(x0, x1);
    const double first = (z0 - left_) / kStep, last = (z1 - left_) / kStep;
    const auto from = static_cast<long>(std::floor(std::max(first, 0.0)));
    const auto to = std::min(static_cast<long>(std::floor(last)), static_cast<long>(radius_.size()) - 1);
    for (long i = from; i <= to; ++i) {
        const double part = z1 - z0 < 1e-9 ? 0.0 : std::clamp((left_ + static_cast<double>(i) * kStep - z0) / (z1 - z0), 0.0, 1.0);
        const double x = z1 - z0 < 1e-9 ? std::min(std::abs(x0), std::abs(x1)) : std::abs(x0 + (x1 - x0) * part);
        auto& radius = radius_[static_cast<std::size_t>(i)];
        radius = std::max(std::min(radius, x), bore_);
    }
    // A facing cut takes what stands in front of it.
    if (z1 - z0 < 1e-9 && std::min(std::abs(x0), std::abs(x1)) < 1.0)
        for (long i = std::max(0L, from); i < static_cast<long>(radius_.size()); ++i) radius_[static_cast<std::size_t>(i)] = bore_;
}

double TurnedStock::radiusAt(double z) const {
    const double at = (z - left_) / kStep;
    return at < 0 || at >= static_cast<double>(radius_.size()) ? 0.0 : radius_[static_cast<std::size_t>(at)];
}

Graphics::Graphics(Desk& desk) : Screen(desk), head_(new FreeSheet(this)) {
    setFocusPolicy(Qt::StrongFocus);
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.text(QRectF(px(14), 0, px(200), head_->height()), word("Graphics"), lettering(20, true), t.text);
        double x = px(230);
        const std::size_t count = desk_.live.channels().size();
        const double step = std::min<double>(px(84), (head_->width() - px(240)) / static_cast<double>(std::max<std::size_t>(1, count)));
        for (const unsigned channel : desk_.live.channels()) {
            const double stroke = step < px(80) ? px(12) : px(26);
            w.fill(QRectF(x, head_->height() / 2.0 - px(3), stroke, px(6)), colourOf(channel), px(3));
            w.text(QRectF(x + stroke + px(5), 0, step - stroke - px(8), head_->height()), QString("L%1").arg(channel), lettering(15, true), t.text);
            x += step;
        }
        if (count <= kFewChannels) w.text(QRectF(x + px(8), 0, head_->width() - x - px(20), head_->height()), word("Since the start of these screens; tips as points, without width and radius"), lettering(13.5), t.dim, Qt::AlignRight | Qt::AlignVCenter);
    };
}

void Graphics::resizeEvent(QResizeEvent*) { head_->setGeometry(0, 0, width(), px(46)), changed_ = true; }

void Graphics::forget() {
    trails_.clear();
    stock_ = {};
    program_.clear();
    changed_ = true;
}

// The job beside the running program that names it: its stock.
void Graphics::findJob() {
    for (const unsigned channel : desk_.live.channels()) {
        const auto& programs = desk_.live.view(channel).programs;
        if (programs.empty()) continue;
        if (programs[0] == program_) return;
        program_ = programs[0];
        stock_ = {};
        const QDir folder(QFileInfo(QString::fromStdString(program_)).absolutePath());
        for (const QFileInfo& file : folder.entryInfoList({"*.job.toml"}, QDir::Files)) {
            const auto job = text::load_job(file.filePath().toStdString());
            if (!job || !job->stock) continue;
            for (const auto& [number, one] : job->programs)
                if (QFileInfo(QString::fromStdString(one.file)).canonicalFilePath() == QFileInfo(QString::fromStdString(program_)).canonicalFilePath()) {
                    stock_.begin(job->stock->diameter, job->stock->bore, job->stock->length, job->stock->face);
                    return;
                }
        }
        return;
    }
}

void Graphics::follow() {
    const Live& live = desk_.live;
    if (!live.connected()) return;
    findJob();
    for (const unsigned channel : live.channels()) {
        Trail& trail = trails_[channel];
        const ChannelStatus& status = live.channel(channel);
        if (status.cycle_s < trail.cycle && status.cycle_s < 0.5) {   // another part begins
            trail = {};
            changed_ = true;
            if (channel == live.channels().front()) program_.clear();
        }
        trail.cycle = status.cycle_s;
        const AxisConfig* x = find_axis(live.config(), channel, PlaneRole::BasicX);
        const AxisConfig* z = find_axis(live.config(), channel, PlaneRole::BasicZ);
        if (!x || !z || x->slot == kNoSlot || z->slot == kNoSlot) continue;
        double at_x = 0, at_z = 0;
        const bool known = live.workpiece(channel, x->slot, live.status().axes[x->number - 1u].act, at_x) && live.workpiece(channel, z->slot, live.status().axes[z->number - 1u].act, at_z);
        const auto state = static_cast<ChannelState>(status.state);
        if (!known || (state != ChannelState::Running && state != ChannelState::Held) || std::abs(at_x) > kFurthest || std::abs(at_z) > kFurthest) {
            trail.open = false;
            continue;
        }
        const Point now{at_z, at_x, live.view(channel).rapid, !trail.open};
        if (trail.open) {
            const Point& last = trail.points.back();
            if (std::hypot(now.z - last.z, now.x - last.x) < kLeastWay) continue;
            if (!now.rapid) stock_.cut(last.z, last.x, now.z, now.x), cut_ = true;
        }
        trail.points.push_back(now);
        if (trail.points.size() > kMostPoints) trail.points.pop_front(), trail.drawn -= trail.drawn > 0;
        trail.open = true;
    }
}

void Graphics::refresh() {
    head_->refresh();
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    const qreal ratio = devicePixelRatioF();
    if (changed_ || picture_.size() != (QSizeF(size()) * ratio).toSize() || (cut_ && now - painted_ >= kStockEveryMs)) {
        painted_ = now;
        changed_ = cut_ = false;
        for (auto& [channel, trail] : trails_) trail.drawn = 0;
        picture_ = QPixmap((QSizeF(size()) * ratio).toSize());
        picture_.setDevicePixelRatio(ratio);
        drawRoom();
        update(0, head_->height(), width(), height() - head_->height());
        return;
    }
    // What has been added since the last frame, and the tips where they were and where they are.
    QPainter p(&picture_);
    p.setRenderHint(QPainter::Antialiasing);
    unsigned index = 0;
    for (auto& [channel, trail] : trails_) {
        const unsigned number = index++;
        if (trail.drawn == trail.points.size()) continue;
        const QRectF before = tipBox(trail);
        const QRectF added = drawTrail(p, number, channel, trail);
        update((before | added | tipBox(trail)).toAlignedRect());
    }
}

QPointF Graphics::place(double z, double x) const {
    const double from = stock_.any() ? stock_.left() - 30 : -120, to = stock_.any() ? stock_.right() + 20 : 40, top = head_->height();
    const double half = stock_.any() ? (stock_.outer() + 30) : 60;
    const double scale = std::min((width() - px(60)) / (to - from), (height() - top - px(60)) / (2 * half)) * zoom_;
    return {width() / 2.0 + (z - (from + to) / 2) * scale, top + (height() - top) / 2 - x * scale};
}

QRectF Graphics::tipBox(const Trail& trail) const { return QRectF(trail.tip, QSizeF(0, 0)).adjusted(-px(20), -px(44), px(110), px(44)); }

// From the last point that is in the picture on. Every second channel is drawn below the spindle axis: all cut the same workpiece.
QRectF Graphics::drawTrail(QPainter& p, unsigned index, unsigned channel, Trail& trail) {
    const double side = index % 2 ? -1.0 : 1.0;
    if (trail.points.empty()) return {};
    const auto at = [&](std::size_t i) { return place(trail.points[i].z, side * trail.points[i].x); };
    std::size_t i = std::max<std::size_t>(1, trail.drawn);
    QPainterPath cut, rapid;
    for (QPointF last = at(i - 1); i < trail.points.size(); ++i) {
        const Point& point = trail.points[i];
        const QPointF now = at(i);
        QPainterPath& path = point.rapid ? rapid : cut;
        if (!point.begins) path.moveTo(last), path.lineTo(now);
        last = now;
    }
    const QColor colour = colourOf(channel);
    p.setBrush(Qt::NoBrush);
    p.setPen(QPen(colour, 1, Qt::DotLine));
    p.drawPath(rapid);
    p.setPen(QPen(colour, px(1.6)));
    p.drawPath(cut);
    trail.drawn = trail.points.size();
    trail.tip = at(trail.points.size() - 1);
    return (cut.boundingRect() | rapid.boundingRect()).adjusted(-px(4), -px(4), px(4), px(4));
}

// The tips over the picture, where something has changed.
void Graphics::paintEvent(QPaintEvent* event) {
    const Theme& t = theme();
    QPainter p(this);
    p.setClipRegion(event->region());
    p.setRenderHint(QPainter::Antialiasing);
    if (picture_.isNull()) return p.fillRect(rect(), t.window);
    p.drawPixmap(0, 0, picture_);
    unsigned index = 0;
    for (const auto& [channel, trail] : trails_) {
        const double side = index++ % 2 ? -1.0 : 1.0;
        if (trail.points.empty() || !event->region().intersects(tipBox(trail).toAlignedRect())) continue;
        p.setPen(QPen(t.window, 1));
        p.setBrush(colourOf(channel));
        const double size = px(13);
        const QPointF tip = trail.tip;
        p.drawPolygon(QPolygonF({tip, tip + QPointF(size * 0.35, -side * size), tip + QPointF(size, -side * size * 0.35)}));
        p.setPen(t.text);
        p.setFont(lettering(15, true));
        const ChannelView& view = desk_.live.view(channel);
        p.drawText(tip + QPointF(px(16), -side * px(16)), view.known && view.picture.tool > 0 ? QString("L%1 T%2").arg(channel).arg(view.picture.tool) : QString("L%1").arg(channel));
    }
}

void Graphics::drawRoom() {
    const Theme& t = theme();
    QPainter p(&picture_);
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(rect(), t.window);
    const QRectF area(px(8), head_->height(), width() - px(16), height() - head_->height() - px(8));
    p.setPen(Qt::NoPen);
    p.setBrush(t.card);
    p.drawRoundedRect(area, px(8), px(8));
    p.setClipRect(area);
    const double left = stock_.any() ? stock_.left() : -120;
    if (stock_.any()) {
        // the blank as it was, the part as it is
        const double outer = stock_.outer();
        p.setBrush(t.raised);
        p.drawRect(QRectF(place(left, outer), place(stock_.right(), -outer)));
        QPainterPath part(place(left, 0));
        for (double z = left; z < stock_.right(); z += 2 * TurnedStock::kStep) part.lineTo(place(z, stock_.radiusAt(z)));
        part.lineTo(place(stock_.right(), 0));
        for (double z = stock_.right() - TurnedStock::kStep; z > left; z -= 2 * TurnedStock::kStep) part.lineTo(place(z, -stock_.radiusAt(z)));
        part.closeSubpath();
        QLinearGradient steel(place(0, outer), place(0, -outer));
        const QColor bright = t.dark ? QColor("#8fa3b5") : QColor("#dfe6ec"), dull = t.dark ? QColor("#3c4a57") : QColor("#8d9aa6");
        steel.setColorAt(0, dull), steel.setColorAt(0.35, bright), steel.setColorAt(0.55, bright), steel.setColorAt(1, dull);
        p.setBrush(steel);
        p.setPen(QPen(t.edge, 1));
        p.drawPath(part);
        // jaws
        p.setBrush(t.edge);
        p.setPen(Qt::NoPen);
        for (const double side : {1.0, -1.0}) p.drawRect(QRectF(place(left - 22, side * (outer + 16)), place(left + 14, side * outer)).normalized());
        p.drawRect(QRectF(place(left - 34, outer + 26), place(left - 20, -outer - 26)).normalized());
    }
    p.setPen(QPen(t.faint, 1, Qt::DashDotLine));
    p.drawLine(place(left - 40, 0), place((stock_.any() ? stock_.right() : 40) + 30, 0));
    unsigned index = 0;
    for (auto& [channel, trail] : trails_) drawTrail(p, index++, channel, trail);
    if (desk_.live.channels().size() > kFewChannels) {   // no room for it on top
        p.setPen(t.dim);
        p.setFont(lettering(13.5));
        p.drawText(area.adjusted(px(16), 0, 0, -px(10)), Qt::AlignLeft | Qt::AlignBottom, word("Since the start of these screens; tips as points, without width and radius"));
    }
    if (trails_.empty() || !stock_.any()) {
        p.setPen(t.dim);
        p.setFont(lettering(15));
        p.drawText(area.adjusted(0, 0, -px(16), -px(10)), Qt::AlignRight | Qt::AlignBottom, stock_.any() ? QString() : word("No job names the stock of the running program"));
    }
}

std::vector<SoftKey> Graphics::keys() {
    return {{word("Larger"), [this] { zoom_ = std::min(zoom_ * 1.25, 8.0), changed_ = true; }}, {word("Smaller"), [this] { zoom_ = std::max(zoom_ / 1.25, 0.3), changed_ = true; }},
            {word("All"), [this] { zoom_ = 1, changed_ = true; }}, {word("Clear"), [this] { forget(); }}};
}

}  // namespace polyturn::hmi
