#include "hmi/screens/compensation_page.hpp"

#include <QKeyEvent>
#include <algorithm>
#include <array>
#include <cmath>

#include "hmi/machine/channel_words.hpp"
#include "hmi/machine/round_step.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/upright.hpp"

namespace polyturn::hmi {
namespace {

using Kind = CompensationCurve::Kind;

double largest(const CompensationCurve& curve) {
    double out = 0;
    for (const auto& point : curve.points) out = std::max(out, std::abs(point.value));
    return out;
}

}  // namespace

CompensationPage::CompensationPage(Desk& desk, QWidget* parent) : QWidget(parent), desk_(desk), curves_(new Table(this)), points_(new Table(this)), graph_(new FreeSheet(this)) {
    curves_->columns = {{word("Table"), 2.8}, {word("Points"), 0.9, kRight}, {word("Largest"), 1.7, kRight}};
    curves_->rowUnits = 36;
    curves_->nothing = word("No compensation table is described (N2500 to N2808).");
    curves_->rows = [this] { return static_cast<int>(all_.size()); };
    curves_->cell = [this](int row, int column) -> Table::Cell {
        const CompensationCurve& curve = all_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        if (column == 0) return {title(curve), curve.on ? t.text : t.dim, curve.on ? Sign::Good : Sign::Off, curve.on};
        if (column == 1) return {QString::number(curve.points.size()), t.dim};
        return {lengthText(largest(curve), desk_.live.unit(desk_.live.config().axis(curve.corrected ? curve.corrected : curve.moving)).digits(4)), t.text};
    };
    curves_->onChosen = [this] { points_->choose(0), refresh(); };
    points_->columns = {{word("No."), 1, kRight}, {word("Position"), 1.6, kRight}, {word("Correction"), 1.6, kRight}};
    points_->rowUnits = 30;
    points_->rows = [this] { return chosen() ? static_cast<int>(chosen()->points.size()) : 0; };
    points_->cell = [this](int row, int column) -> Table::Cell {
        const auto& point = chosen()->points[static_cast<std::size_t>(row)];
        const bool letters = chosen()->points.size() == 4 && point.number < 4;   // A to D
        if (column == 0) return {letters ? QString(QChar('A' + static_cast<int>(point.number))) : QString::number(point.number), theme().dim};
        const LengthUnit unit = desk_.live.unit(desk_.live.config().axis(column == 1 || !chosen()->corrected ? chosen()->moving : chosen()->corrected));
        return {lengthText(column == 1 ? point.at : point.value, unit.digits(column == 1 ? 3 : 4)), column == 1 ? theme().text : theme().accent};
    };
    points_->onChosen = [this] { graph_->refresh(); };
    graph_->onCompose = [this](Writer& w) { composeGraph(w); };
}

void CompensationPage::begin() {
    cells_.reset(), all_.clear();
    reading_.start([base = desk_.live.machineFolder()](const std::atomic<bool>&) {
        std::vector<Diagnosis> ignored;   // said by who started the controller
        return std::make_shared<CompensationTables>(base.empty() ? CompensationTables() : load_compensation(base + ".compensation", ignored));
    });
    refresh();
}

void CompensationPage::refresh() {
    if (auto made = reading_.take()) {
        cells_ = *made;
        all_ = compensationCurves(desk_.live.table(), desk_.live.config(), *cells_);
        curves_->choose(0);
    }
    curves_->focused = !onPoints_, points_->focused = onPoints_;
    for (Sheet* one : sheets()) one->refresh();
}

const CompensationCurve* CompensationPage::chosen() const {
    const auto row = static_cast<std::size_t>(std::max(0, curves_->row()));
    return row < all_.size() ? &all_[row] : nullptr;
}

QString CompensationPage::axisName(unsigned axis) const { return QString("A%1 %2").arg(axis).arg(fromView(desk_.live.config().axis(axis).name_text())); }

// As it is stored: in the unit of the axis, X as a radius.
QString CompensationPage::unitOf(unsigned axis) const {
    const AxisConfig& config = desk_.live.config().axis(axis);
    const LengthUnit unit = desk_.live.unit(config);
    return config.diameter && !config.rotary ? unit.radius() : unit.name();
}

QString CompensationPage::title(const CompensationCurve& curve) const {
    switch (curve.kind) {
        case Kind::Pitch: return word("%1: pitch").arg(axisName(curve.moving));
        case Kind::PitchBack: return word("%1: pitch, negative direction").arg(axisName(curve.moving));
        case Kind::Periodic: return word("%1: periodic").arg(axisName(curve.moving));
        case Kind::Gradient: return word("%1: gradient").arg(axisName(curve.moving));
        case Kind::Straightness: return word("%1 by %2: straightness").arg(axisName(curve.corrected), axisName(curve.moving));
        case Kind::Grid: break;
    }
    return word("L%1: volume along %2").arg(curve.channel).arg(axisName(curve.moving));
}

bool CompensationPage::key(QKeyEvent* event) {
    if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab) return onPoints_ = !onPoints_, true;
    return (onPoints_ ? points_ : curves_)->key(event);
}

void CompensationPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), left = static_cast<int>(width() * 0.4), top = static_cast<int>(height() * 0.44);
    if (upright(*this)) {
        const int half = (width() - 3 * edge) / 2;
        curves_->setGeometry(edge, 0, half, top - edge), points_->setGeometry(half + 2 * edge, 0, half, top - edge);
        graph_->setGeometry(edge, top, width() - 2 * edge, height() - top - edge);
    } else {
        curves_->setGeometry(edge, 0, left - edge, top - edge);
        points_->setGeometry(edge, top, left - edge, height() - top - edge);
        graph_->setGeometry(left + edge, 0, width() - left - 2 * edge, height() - edge);
    }
    for (Sheet* one : sheets()) one->refresh();
}

// Straight between the points, as the kernel corrects.
void CompensationPage::composeGraph(Writer& w) {
    const Theme& t = theme();
    const double wide = graph_->width(), high = graph_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const CompensationCurve* curve = chosen();
    if (!curve) return;
    w.text(QRectF(px(14), px(8), wide - px(28), px(26)), title(*curve), lettering(16, true), t.text);
    w.text(QRectF(px(14), px(34), wide - px(28), px(22)), curve->on ? word("Active") : word("Switched off"), lettering(13.5), curve->on ? t.good : t.warn);
    const auto [first, last] = std::minmax_element(curve->points.begin(), curve->points.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    const double from = first->at, span = std::max(1e-9, last->at - from);
    const double division = roundStep(std::max(largest(*curve), 1e-4) * 1.05 / 4), most = 4 * division;
    const double left = px(84), right = wide - px(36), top = px(94), bottom = high - px(62), middle = (top + bottom) / 2;
    const auto place = [&](const CompensationCurve::Point& point) { return QPointF(left + (right - left) * (point.at - from) / span, middle - (bottom - top) / 2 * point.value / most); };
    w.text(QRectF(px(14), px(60), wide - px(28), px(22)), QString("%1 (%2)").arg(word("Correction"), unitOf(curve->corrected ? curve->corrected : curve->moving)), lettering(13.5), t.dim);
    for (int i = -4; i <= 4; ++i) {
        const double y = middle - (bottom - top) / 2 * i / 4;
        w.line({left, y}, {right, y}, i == 0 ? t.dim : t.edge, 1);
        w.text(QRectF(px(4), y - px(10), left - px(12), px(20)), lengthText(division * i, desk_.live.unit(desk_.live.config().axis(curve->corrected ? curve->corrected : curve->moving)).digits(4)), lettering(12.5), t.dim, kRight);
    }
    const double apart = roundStep(span / 6);
    for (double at = std::ceil(from / apart - 1e-6) * apart; at <= last->at + 1e-6 * apart; at += apart) {
        const double x = left + (right - left) * (at - from) / span;
        w.line({x, top}, {x, bottom}, t.edge, 1);
        w.text(QRectF(x - px(40), bottom + px(6), px(80), px(20)), lengthText(std::round(at / apart) * apart + 0.0, apart < 1 ? 3 : 0), lettering(12.5), t.dim, Qt::AlignCenter);
    }
    w.text(QRectF(left, bottom + px(30), right - left, px(22)), QString("%1 %2 (%3)").arg(word("Position"), axisName(curve->moving), unitOf(curve->moving)), lettering(13.5), t.dim, kRight);
    // A graph has some hundred places; of tables with thousands of points the least and greatest of each place are drawn.
    const std::size_t count = curve->points.size(), step = std::max<std::size_t>(1, count / 400);
    QPointF before = place(curve->points.front());
    for (std::size_t i = step; i < count; i += step) {
        const auto begin = curve->points.begin() + static_cast<std::ptrdiff_t>(i - step + 1), end = curve->points.begin() + static_cast<std::ptrdiff_t>(i + 1);
        const auto [low, top_one] = std::minmax_element(begin, end, [](const auto& a, const auto& b) { return a.value < b.value; });
        for (const auto* point : low->at < top_one->at ? std::array{&*low, &*top_one} : std::array{&*top_one, &*low}) {
            const QPointF now = place(*point);
            w.line(before, now, t.accent, px(2)), before = now;
        }
    }
    w.line(before, place(curve->points.back()), t.accent, px(2));
    const auto row = static_cast<std::size_t>(std::max(0, points_->row()));
    if (row < count) {
        const QPointF at = place(curve->points[row]);
        w.fill(QRectF(at.x() - px(5), at.y() - px(5), px(10), px(10)), t.warn, px(5));
    }
}

}  // namespace polyturn::hmi
