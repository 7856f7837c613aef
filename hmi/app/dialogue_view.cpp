#include "hmi/app/dialogue_view.hpp"

#include <QKeyEvent>
#include <algorithm>
#include <cmath>
#include <memory>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/overview/operation_keys.hpp"

namespace polyturn::hmi {
namespace {

constexpr std::size_t kNote = 64, kKey = 32;
constexpr unsigned kDecimals = 4;

}  // namespace

DialogueView::DialogueView(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      head_(new FreeSheet(this)),
      place_(new FreeSheet(this)),
      table_(new Table(this)),
      pad_(new NumberPad(this)) {
    setAutoFillBackground(true);
    hide();
    table_->rowUnits = 46;
    table_->textUnits = 18;
    table_->rows = [this] {
        return static_cast<int>(asksValues() ? page_.field_count : pageKeys().size());
    };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        if (!asksValues()) {
            const Key key = pageKeys()[static_cast<std::size_t>(row)];
            return column == 0
                       ? Table::Cell{QString::number(key.number), t.accent, Sign::None, true}
                   : column == 1 ? Table::Cell{key.text}
                                 : Table::Cell{};
        }
        const DialogueField& field = page_.fields[static_cast<std::size_t>(row)];
        if (column == 0) return {QString::fromUtf8(field.variable.data()), t.dim};
        if (column == 1) return {QString::fromUtf8(field.name.data()), t.text};
        return {std::isfinite(field.value) ? lengthText(field.value, kDecimals)
                                           : QString::fromUtf8("–"),
                t.accent, Sign::None, true};
    };
    table_->onChosen = [this] { pad_->clear(); };
    table_->onActivated = [this] {
        const auto keys = pageKeys();
        if (!asksValues() && static_cast<std::size_t>(table_->row()) < keys.size())
            answer(keys[static_cast<std::size_t>(table_->row())].number);
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const auto row = static_cast<std::size_t>(std::max(0, table_->row()));
        if (!channel_ || row >= page_.field_count) return std::nullopt;
        const DialogueField& field = page_.fields[row];
        return NumberPad::Field{QString::fromUtf8(field.name.data()),
                                QString::fromUtf8(field.variable.data()),
                                std::isfinite(field.value) ? field.value : 0.0, kDecimals};
    };
    pad_->onInput = [this](double value) {
        const auto row = static_cast<std::size_t>(table_->row());
        if (row >= page_.field_count) return;
        context_.requests.press(QString("answer L%1 %2=%3")
                                    .arg(channel_)
                                    .arg(QString::fromUtf8(page_.fields[row].variable.data()))
                                    .arg(value, 0, 'g', 12));
        if (row + 1 < page_.field_count) table_->choose(static_cast<int>(row) + 1);
        refresh();
    };
    place_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, place_->width(), place_->height()), t.window);
        w.fill(QRectF(0, 0, place_->width(), place_->height()), t.card, px(8));
        if (!channel_) return;
        w.text(QRectF(px(14), px(6), place_->width() - px(28), px(20)), word("Workpiece"),
               lettering(13, false, Face::Condensed), t.dim, Qt::AlignRight | Qt::AlignVCenter);
        double y = px(28);
        const MachineConfig& config = context_.live.config();
        for (std::size_t i = 0; i < config.last_axis && y + px(28) <= place_->height(); ++i) {
            const AxisConfig& axis = config.axes[i];
            double workpiece = 0;
            if (!axis.exists() || axis.channel != channel_ || axis.slot == kNoSlot) continue;
            const bool known = context_.live.workpiece(
                channel_, axis.slot, context_.live.status().axes[i].act, workpiece);
            w.text(QRectF(px(14), y, px(60), px(28)), fromView(axis.name_text()),
                   lettering(17, true), t.dim);
            w.text(QRectF(px(74), y, place_->width() - px(90), px(28)),
                   known ? context_.live.unit(axis).text(shownPlace(axis, workpiece))
                         : QString::fromUtf8("–"),
                   lettering(17, true), t.text, Qt::AlignRight | Qt::AlignVCenter);
            y += px(29);
        }
    };
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.sign(QRectF(px(14), px(12), px(26), px(26)), Sign::Note, t.accent);
        w.data(QRectF(px(52), px(4), head_->width() * 0.45, px(42)), title(), lettering(22, true),
               t.text);
        w.text(QRectF(head_->width() * 0.5, px(4), head_->width() * 0.5 - px(12), px(42)),
               channel_ ? word("The program of L%1 waits for an answer").arg(channel_) : QString(),
               lettering(15.5), t.warn, Qt::AlignRight | Qt::AlignVCenter);
        double y = px(48);
        for (std::size_t i = 0; i < page_.note_count && y + px(22) < head_->height();
             ++i, y += px(22))
            w.data(QRectF(px(52), y, head_->width() - px(64), px(22)),
                   QString::fromUtf8(&page_.notes[i * kNote]), lettering(15), t.dim);
    };
}

std::vector<DialogueView::Key> DialogueView::pageKeys() const {
    std::vector<Key> out;
    for (std::size_t k = 0; k < page_.keys.size() / kKey; ++k)
        if (page_.keys[k * kKey])
            out.push_back({static_cast<int>(k + 1), QString::fromUtf8(&page_.keys[k * kKey])});
    return out;
}

bool DialogueView::follow() {
    unsigned found = 0;
    auto next = std::make_unique<Dialogue>();
    // The page that somebody answers stays, whoever else asks; another channel that is chosen
    // brings its own.
    const bool stays = isVisible() && context_.channel == chosen_;
    chosen_ = context_.channel;
    if (stays && channel_ && context_.live.dialogue(channel_, *next)) found = channel_;
    for (const unsigned channel : context_.live.channels())
        if (!(found && stays) && context_.live.dialogue(channel, *next) &&
            (!found || channel == context_.channel))
            found = channel;
    if (!found) {
        channel_ = 0;
        serial_ = 0;
        return false;
    }
    if (!context_.live.dialogue(found, *next)) return false;
    const bool fresh = found != channel_ || next->serial != serial_;
    page_ = *next;
    channel_ = found;
    serial_ = page_.serial;
    if (fresh || spoken_ != spoken()) {
        spoken_ = spoken();
        table_->columns =
            asksValues() ? std::vector<Table::Column>{{word("Variable"), 0.8},
                                                      {word("Name"), 1.6},
                                                      {word("Value"), 1.2,
                                                       Qt::AlignRight | Qt::AlignVCenter}}
                         : std::vector<Table::Column>{{word("Number"), 0.6}, {word("Name"), 3}};
    }
    if (fresh) {
        table_->choose(0);
        pad_->clear();
        layOut();
    }
    return fresh;
}

void DialogueView::answer(int key) {
    if (channel_) context_.requests.press(QString("answer L%1 key=%2").arg(channel_).arg(key));
}

void DialogueView::refresh() {
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<SoftKey> DialogueView::keys() {
    std::vector<SoftKey> out;
    for (const Key& key : pageKeys()) {
        if (out.size() == 9) break;  // the others stand in the list
        out.push_back(
            {key.text, [this, number = key.number] { answer(number); }, Sign::None, channel_ != 0});
    }
    // the other channels go on beneath it: at its place of all screens, if that is free
    const std::size_t hold = out.size() <= kHoldAllPlace ? kHoldAllPlace : 8;
    const bool room = out.size() < 9;
    out.resize(9);
    if (room) out[hold] = holdGroupKey(context_, 0);
    out.push_back({word("Later"),
                   [this] {
                       hide();
                       if (context_.keysChanged) context_.keysChanged();
                   },
                   Sign::Left, true});
    return out;
}

bool DialogueView::key(QKeyEvent* event) {
    if (asksValues() && pad_->key(event)) return true;
    if (event->key() == Qt::Key_Escape) {
        hide();
        if (context_.keysChanged) context_.keysChanged();
        return true;
    }
    // A pattern by its number.
    if (!asksValues() && event->text().size() == 1 && event->text()[0].isDigit()) {
        const auto keys = pageKeys();
        for (std::size_t i = 0; i < keys.size(); ++i)
            if (keys[i].number == event->text().toInt()) {
                table_->choose(static_cast<int>(i));
                refresh();
                return true;
            }
    }
    return table_->key(event);
}

std::vector<Sheet*> DialogueView::sheets() {
    if (asksValues()) return {head_, table_, pad_, place_};
    return {head_, table_, place_};
}

void DialogueView::resizeEvent(QResizeEvent*) { layOut(); }

// A page of keys alone has no field for figures: the axes stand at the top then.
void DialogueView::layOut() {
    const int edge = px(8), head = px(48 + 22 * 8), pad = px(350);
    const int top =
        page_.note_count ? px(48) + px(22) * static_cast<int>(page_.note_count) + edge : px(52);
    head_->setGeometry(0, 0, width(), std::min(head, top));
    table_->setGeometry(edge, top, width() - pad - 3 * edge, height() - top - edge);
    const int high = asksValues() ? std::min(px(400), height() - top - px(120)) : -edge;
    pad_->setVisible(asksValues());
    pad_->setGeometry(width() - pad - edge, top, pad, std::max(0, high));
    place_->setGeometry(width() - pad - edge, top + high + edge, pad,
                        height() - top - high - 2 * edge);
}

}  // namespace polyturn::hmi
