#include "hmi/screens/tools/offsets.hpp"

#include <algorithm>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/screens/overview/channel_keys.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {

Offsets::Offsets(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      find_(new FreeSheet(this)),
      side_(new FreeSheet(this)),
      table_(new Table(this)),
      pad_(new NumberPad(this)),
      parts_(new PartsPage(context, this)),
      values_(context.live),
      entries_(context, values_),
      history_(context) {
    parts_->hide();
    history_.onCome = [this] { side_->refresh(); };
    entries_.onEntered = [this] {
        askHistory();
        refresh();
    };
    entries_.onEdge = [this] {
        pad_->clear();
        refresh();
    };
    setFocusPolicy(Qt::StrongFocus);
    table_->byCell = true;
    table_->rowUnits = 34;
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.text(QRectF(px(14), 0, head_->width() * 0.5, head_->height()),
               partsShown_       ? word("Measured parts")
               : zeros_          ? word("Work zeros")
               : values_.edged() ? word("Tool edges")
                                 : word("Tool offsets"),
               lettering(20, true), t.text);
        composeChannelKeys(w, context_, head_->size());
    };
    head_->onTouched = [this](int channel) {
        context_.choose(static_cast<unsigned>(channel));
        refresh();
    };
    find_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, find_->width(), find_->height()), t.window);
        const bool any = !values_.searched().isEmpty();
        const double count = any ? px(120) : 0;
        w.field(QRectF(0, px(1), find_->width() - count, find_->height() - px(7)),
                values_.searched(),
                zeros_            ? word("Search: a zero")
                : values_.edged() ? word("Search: number, tool, edge")
                                  : word("Search: number or tool"),
                any, kFindHit);
        if (any)
            w.data(QRectF(find_->width() - count, 0, count - px(4), find_->height() - px(6)),
                   QString("%1 / %2").arg(values_.shownCount()).arg(values_.rowsInAll()),
                   lettering(15), t.dim, kRight);
    };
    find_->onTouched = [this](int) {
        context_.ask(
            {word("Search"), values_.searched(), [this](const QString& text) { find(text); }, {}});
    };
    side_->onCompose = [this](Writer& w) { composeSide(w); };
    table_->onChosen = [this] {
        if (const int row = values_.at(table_->row()); row >= 0) wanted_ = row;
        pad_->clear();
        askHistory();
        side_->refresh();
    };
    table_->onActivated = [this] {};
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const auto value = chosen();
        if (!value) return std::nullopt;
        return NumberPad::Field{value->title, value->unitText(), value->present, value->decimals,
                                false,        value->unit.size()};
    };
    pad_->onInput = [this](double now) {
        if (const auto value = chosen()) entries_.put(*value, now);
    };
    pad_->onAdded = [this](double delta) {
        if (const auto value = chosen()) entries_.add(*value, delta);
    };
    build();
}

std::vector<Sheet*> Offsets::sheets() {
    if (!partsShown_) return {head_, find_, table_, side_, pad_};
    std::vector<Sheet*> out = parts_->sheets();
    out.push_back(head_);
    return out;
}

void Offsets::showParts(bool on) {
    partsShown_ = on;
    if (on) parts_->begin();
    table_->setVisible(!on);
    find_->setVisible(!on);
    side_->setVisible(!on);
    pad_->setVisible(!on);
    parts_->setVisible(on);
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

void Offsets::showZeros(bool zeros) {
    if (zeros_ == zeros) return;
    zeros_ = zeros;
    values_.search({});
    wanted_ = 0;
    build();
    table_->choose(0, values_.firstColumn());
}

// The page, the row and the column; base lengths of edges, what is searched.
QString Offsets::state() const {
    return QString("%1 %2 %3 %4 %5")
        .arg(partsShown_ ? 2
             : zeros_    ? 1
                         : 0)
        .arg(wanted_)
        .arg(table_->column())
        .arg(base_ ? 1 : 0)
        .arg(values_.searched());
}
void Offsets::restore(const QString& state) {
    const QStringList parts = state.split(' ');
    if (parts.size() < 3) return;
    showZeros(parts[0] == "1");
    showParts(parts[0] == "2");
    if (const bool base = parts.size() > 3 && parts[3] == "1"; std::exchange(base_, base) != base)
        build();
    values_.search(state.section(' ', 4));
    wanted_ = parts[1].toInt();
    table_->choose(table_->row(), parts[2].toInt());
    wanted_ = parts[1].toInt();
    filter();
}

void Offsets::find(const QString& text) {
    values_.search(text);
    filter();
    refresh();
}

void Offsets::filter() {
    values_.filter();
    table_->nothing = values_.nothing();
    chooseRow(wanted_);
}

// Where it is among those that are shown; if it is not, the next one is chosen, and what has
// been typed is for no other.
void Offsets::chooseRow(int row) {
    const int place = values_.placeOfRow(row), now = values_.at(place);
    if (place != table_->row())
        table_->choose(place, table_->column());
    else if (now >= 0 && now != row) {
        pad_->clear();
        askHistory();
    }
    wanted_ = now >= 0 ? now : row;
}

std::optional<OffsetValue> Offsets::chosen() const {
    return current() ? values_.value(table_->row(), table_->column()) : std::nullopt;
}

void Offsets::askHistory() { history_.ask(chosen()); }

void Offsets::build() {
    const EdgeLine before = values_.edgeAt(std::max(0, wanted_));
    values_.build(context_.channel, zeros_ ? OffsetTable::Kind::Zeros : OffsetTable::Kind::Offsets,
                  base_);
    table_->columns.clear();
    for (const OffsetTable::Column& one : values_.columns())
        table_->columns.push_back(
            {one.title, one.share,
             table_->columns.empty() ? Table::Column{}.align : static_cast<int>(kRight),
             one.value});
    table_->nothing = word("This channel has no offsets.");
    table_->rows = [this] { return values_.shownCount(); };
    if (!context_.live.connected() || context_.live.channels().empty()) return;
    if (values_.byEdges()) followEdge(before);
    filter();
    table_->cell = [this](int row, int column) { return cell(row, column); };
    if (table_->column() < (values_.byEdges() ? 2 : 1) ||
        table_->column() >= static_cast<int>(table_->columns.size()))
        table_->choose(table_->row(), values_.firstColumn());
}

Table::Cell Offsets::cell(int shown, int column) const {
    const Theme& t = theme();
    const int row = values_.at(shown);
    if (row < 0 || !current()) return {};
    const bool now = values_.active(row);
    if (values_.byEdges() && column < 2) return edgeName(shown, column);
    if (column == 0)
        return {values_.rowTitle(row), now ? t.good : t.dim, now ? Sign::Run : Sign::None, now};
    const auto value = values_.value(shown, column);
    if (!value) return {};
    double applied = 0, sum = 0;
    const bool pending =
        now && values_.appliedNow(*value, applied, sum) && std::abs(applied - sum) > 5e-7;
    const bool wear = !zeros_ && value->wear();
    return {value->text(value->present),
            pending               ? t.warn
            : value->present == 0 ? t.faint
            : wear                ? t.accent
                                  : t.text,
            pending ? Sign::Wait : Sign::None, now};
}

// The tool, once, and the number of the edge.
Table::Cell Offsets::edgeName(int shown, int column) const {
    const Theme& t = theme();
    const int row = values_.at(shown);
    const bool now = values_.active(row);
    const EdgeLine line = values_.edgeAt(row);
    if (column == 1) return {QString::number(line.edge), now ? t.good : t.dim, Sign::None, now};
    const ToolRow* tool = toolOf(context_.live, line.tool);
    if (!tool || (shown > 0 && values_.edgeAt(values_.at(shown - 1)).tool == line.tool))
        return {QString(), t.dim, now ? Sign::Run : Sign::None};
    QString name = QString("T%1  %2").arg(line.tool).arg(toolName(*tool, line.tool));
    if (tool->duplo > 1) name += QString(" (%1)").arg(tool->duplo);
    if (tool->magazine) name = placeText(context_.live, tool->magazine, tool->pot) + "  " + name;
    return {name, now ? t.good : t.text, now ? Sign::Run : Sign::None, now, Face::Condensed};
}

// The chosen one stays chosen, wherever it stands by now; what has been typed for one that is gone
// is for no other.
void Offsets::followEdge(const EdgeLine& before) {
    if (const int row = values_.rowOf(before); row >= 0) {
        wanted_ = row;
        return;
    }
    if (before.tool) pad_->clear();
    wanted_ = std::clamp(wanted_, 0, std::max(0, static_cast<int>(values_.edges().size()) - 1));
}

// Numbers of edges have no gaps: only the last one goes. Not the one that the running block works
// with.
bool Offsets::mayDelete() const {
    const auto value = chosen();
    if (!context_.live.connected() || !value || !value->ofEdge() ||
        !edgeOf(context_.live, value->edge))
        return false;
    const auto& edges = values_.edges();
    return std::none_of(edges.begin(), edges.end(),
                        [&](const EdgeLine& one) {
                            return one.tool == value->edge.tool && one.edge > value->edge.edge;
                        }) &&
           !values_.active(values_.at(table_->row()));
}

// What has been typed is taken along, and the field is free again.
void Offsets::measure() {
    const auto value = chosen();
    const auto typed = pad_->held();
    if (!value || !typed || zeros_ || value->place < 0) return;
    pad_->clear();
    entries_.measure(*value, *typed);
}

void Offsets::zeroHere() {
    const auto value = chosen();
    if (!value || !zeros_) return;
    const auto typed = pad_->held();
    pad_->clear();
    entries_.zeroHere(*value, typed.value_or(0.0));
}

void Offsets::touched() {
    const auto value = chosen();
    if (!value) return;
    const auto typed = zeros_ ? pad_->held() : std::nullopt;
    if (zeros_) pad_->clear();
    entries_.touched(*value, typed);
}

void Offsets::resizeEvent(QResizeEvent*) { layOut(); }

void Offsets::layOut() {
    const int top = px(46), edge = px(8), side = px(330), pad = px(380);
    head_->setGeometry(0, 0, width(), top);
    const Parted all = parted(*this, QRect(edge, top, width() - 2 * edge, height() - top - edge),
                              side, px(400), edge);
    const Padded right = padded(*this, all.side, px(346), pad, edge);
    const int search = px(44);
    find_->setGeometry(all.main.left(), all.main.top(), all.main.width(), search);
    table_->setGeometry(all.main.adjusted(0, search, 0, 0));
    side_->setGeometry(right.rest);
    pad_->setGeometry(right.pad);
    parts_->setGeometry(0, top, width(), height() - top);
    for (Sheet* one : sheets()) one->refresh();
}

void Offsets::composeSide(Writer& w) {
    const Theme& t = theme();
    const double wide = side_->width(), high = side_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    double y = px(8);
    const auto line = [&](const QString& name, const QString& value, const QColor& colour) {
        w.text(QRectF(px(12), y, wide * 0.5, px(22)), name, lettering(14), t.dim);
        w.text(QRectF(wide * 0.5, y, wide * 0.5 - px(12), px(22)), value, lettering(15, true),
               colour, kRight);
        y += px(23);
    };
    if (const auto value = chosen()) {
        double applied = 0, sum = 0;
        const ChannelView& view = context_.live.view(context_.channel);
        const BlockPicture& p = view.picture;
        if (value->ofEdge()) {
            const QString kind =
                kindText(static_cast<std::int32_t>(edgeValue(context_.live, value->edge, kDpType)));
            w.data(QRectF(px(12), y, wide - px(24), px(22)),
                   edgeTitle(context_.live, value->edge) +
                       (kind.isEmpty() ? QString() : QString::fromUtf8("  ·  ") + kind),
                   lettering(14, true), t.text);
            y += px(24);
        }
        // these act with each of the others
        const auto zeroActs = [&](std::size_t row) {
            return p.zero_row == static_cast<std::int32_t>(row) || row == kZeroExternal ||
                   row == kZeroShift;
        };
        const bool acts =
            zeros_ ? view.known && zeroActs(value->row) : values_.active(values_.at(table_->row()));
        if (acts && values_.appliedNow(*value, applied, sum)) {
            const bool same = std::abs(applied - sum) <= 5e-7;
            line(zeros_ ? word("All zeros together") : word("Geometry + wear"), value->text(sum),
                 t.text);
            line(word("Applied now"), value->text(applied), same ? t.good : t.warn);
            w.sign(QRectF(px(12), y + px(2), px(16), px(16)), same ? Sign::Good : Sign::Wait,
                   same ? t.good : t.warn);
            w.text(QRectF(px(34), y, wide - px(44), px(22)),
                   same              ? word("Active")
                   : zeros_          ? word("Active from the next blocks")
                   : value->ofEdge() ? word("Active at the next T or D")
                                     : word("Active at the next T"),
                   lettering(14), same ? t.good : t.warn);
        } else {
            w.text(QRectF(px(12), y, wide - px(24), px(22)),
                   word("Not in use by the running program"), lettering(14), t.dim);
        }
        y += px(28);
    }
    w.line(QPointF(px(12), y), QPointF(wide - px(12), y), t.edge, 1);
    y += px(4);
    w.text(QRectF(px(12), y, wide - px(24), px(20)), word("Who has changed this value"),
           lettering(12.5, false, Face::Condensed), t.dim);
    y += px(21);
    if (history_.lines().isEmpty() && chosen())
        w.text(QRectF(px(12), y, wide - px(24), px(44)), word("No changes recorded."),
               lettering(13, false, Face::Condensed), t.dim, Qt::AlignLeft | Qt::AlignTop)
            .wraps = true;
    for (auto entry = history_.lines().begin();
         entry != history_.lines().end() && y + px(20) < high; ++entry, y += px(20))
        w.data(QRectF(px(12), y, wide - px(24), px(20)), *entry,
               lettering(13, false, Face::Condensed), t.text);
}

// Another screen leads here.
void Offsets::goTo(std::int32_t tool, std::int32_t edge) {
    showParts(false);
    showZeros(false);
    if (!values_.isOf(context_.channel)) build();
    if (!values_.searched().isEmpty()) find({});
    const ToolRow* row = toolOf(context_.live, tool);
    const int wanted = values_.edged() ? values_.rowOf({tool, edge}) : row ? row->h_cell - 1 : -1;
    if (wanted >= 0 && wanted < values_.rowsInAll()) table_->choose(wanted, values_.firstColumn());
}

void Offsets::refresh() {
    entries_.goOn();
    if (const std::int32_t tool = std::exchange(context_.toolOfOffsets, 0))
        goTo(tool, context_.edgeOfOffsets);
    if (!values_.isOf(context_.channel))
        build();
    else if (values_.edgesOutdated()) {
        const EdgeLine before = values_.edgeAt(std::max(0, wanted_));
        values_.takeEdges();
        followEdge(before);
        filter();
    } else if (values_.outdated())
        filter();
    if (partsShown_) {
        head_->refresh();
        return parts_->refresh();
    }
    for (Sheet* one : sheets()) one->refresh();
}

bool Offsets::key(QKeyEvent* event) {
    if (partsShown_) return parts_->key(event);
    if (event->key() == Qt::Key_Escape && pad_->text().isEmpty() && !values_.searched().isEmpty()) {
        find({});
        return true;
    }
    if (event->key() == Qt::Key_Backspace && pad_->text().isEmpty() &&
        !values_.searched().isEmpty()) {
        find(values_.searched().chopped(1));
        return true;
    }
    if (pad_->key(event)) return true;
    return table_->key(event);
}

}  // namespace polyturn::hmi
