#include "hmi/screens/machine/alarms.hpp"

#include <algorithm>
#include <optional>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/overview/operation_keys.hpp"
#include "hmi/text/dates.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kSystemScreen = 9;       // its place in screen_list.cpp
constexpr std::size_t kOpenPlace = 5;  // of the key that opens the program at the fault

Sign signOf(Severity severity) {
    return severity == Severity::Error     ? Sign::Alarm
           : severity == Severity::Warning ? Sign::Warning
                                           : Sign::Note;
}
QColor colourOf(Severity severity) {
    const Theme& t = theme();
    return severity == Severity::Error ? t.bad : severity == Severity::Warning ? t.warn : t.accent;
}

}  // namespace

Alarms::Alarms(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      table_(new Table(this)),
      detail_(new FreeSheet(this)),
      stops_(new StopsPage(context, this)) {
    setFocusPolicy(Qt::StrongFocus);
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        static constexpr const char* kTitles[] = {WORD("Active alarms"), WORD("History"),
                                                  WORD("Log of stops")};
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        w.text(QRectF(px(14), 0, head_->width() * 0.6, head_->height()),
               word(kTitles[static_cast<std::size_t>(page_)]), lettering(20, true), t.text);
    };
    detail_->onCompose = [this](Writer& w) { composeDetail(w); };
    table_->onChosen = [this] {
        detail_->refresh();
        if (context_.keysChanged) context_.keysChanged();
    };
    showPage(Page::Standing);
}

void Alarms::restore(const QString& state) {
    const int page = state.section(' ', 0, 0).toInt();
    if (page < 0 || page > static_cast<int>(Page::Stops)) return;
    showPage(static_cast<Page>(page));
    table_->choose(state.section(' ', 1, 1).toInt());
}

std::vector<Sheet*> Alarms::sheets() {
    if (page_ != Page::Stops) return {head_, table_, detail_};
    std::vector<Sheet*> out = stops_->sheets();
    out.push_back(head_);
    return out;
}

void Alarms::showPage(Page page) {
    page_ = page;
    const bool stops = page == Page::Stops;
    table_->setVisible(!stops);
    detail_->setVisible(!stops);
    stops_->setVisible(stops);
    version_ = 0;
    table_->nothing.clear();
    fillAlarms();
    table_->choose(0);
    layOut();
    refresh();
}

void Alarms::resizeEvent(QResizeEvent*) { layOut(); }

void Alarms::layOut() {
    const int top = px(46), edge = px(8), foot = px(196);
    head_->setGeometry(0, 0, width(), top);
    table_->setGeometry(edge, top, width() - 2 * edge, height() - top - foot - edge);
    stops_->setGeometry(0, top, width(), height() - top);
    detail_->setGeometry(edge, height() - foot, width() - 2 * edge, foot - edge);
}

void Alarms::fillAlarms() {
    const bool all = page_ == Page::History;
    table_->columns = {{word("Time"), 1.5}, {"", 0.55}, {word("Number"), 1.1}, {word("Text"), 8}};
    table_->rowUnits = 38;
    table_->nothing =
        all ? word("No alarm and no message is known yet.") : word("No active alarms.");
    const auto read = chosen() ? std::optional(*chosen()) : std::nullopt;
    rows_.clear();
    for (auto entry = context_.alarms.all().rbegin(); entry != context_.alarms.all().rend();
         ++entry)
        if (all || entry->standing) rows_.push_back(*entry);
    // What has stopped the machine, before what has come of it.
    if (!all)
        std::stable_partition(rows_.begin(), rows_.end(), [](const AlarmEntry& one) {
            return one.severity == Severity::Error;
        });
    if (all)
        rows_.insert(rows_.end(), context_.alarms.earlier().begin(),
                     context_.alarms.earlier().end());
    table_->rows = [this] { return static_cast<int>(rows_.size()); };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const AlarmEntry& entry = rows_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        switch (column) {
            case 0:
                return {pastMomentText(entry.when.toLocalTime(), QDate::currentDate()), t.dim,
                        Sign::None, false, Face::Condensed};
            case 1:
                return {entry.channel ? QString("L%1").arg(entry.channel) : QString(), t.text,
                        Sign::None, true};
            case 2:
                return {entry.number.isEmpty() ? word("Message") : entry.number,
                        colourOf(entry.severity), signOf(entry.severity), entry.standing};
            default:
                return {entry.text, entry.standing || page_ == Page::Standing ? t.text : t.dim};
        }
    };
    version_ = context_.alarms.version();
    // Who reads one goes on reading it when another comes above it.
    if (!read) return;
    const auto same = std::find_if(rows_.begin(), rows_.end(), [&](const AlarmEntry& one) {
        return one.channel == read->channel && one.number == read->number &&
               one.seconds == read->seconds;
    });
    if (same != rows_.end()) table_->choose(static_cast<int>(same - rows_.begin()));
}

const AlarmEntry* Alarms::chosen() const {
    const int row = table_->row();
    return row >= 0 && row < static_cast<int>(rows_.size()) ? &rows_[static_cast<std::size_t>(row)]
                                                            : nullptr;
}

void Alarms::composeDetail(Writer& w) {
    const Theme& t = theme();
    const double wide = detail_->width(), high = detail_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, px(6), wide, high - px(6)), t.card, px(8));
    const AlarmEntry* found = chosen();
    if (!found) {
        Item& item = w.text(
            QRectF(px(20), px(20), wide - px(40), px(60)),
            page_ == Page::Standing
                ? word("What was told before stands in «History», what the machine stood still "
                       "for in «Log of stops».")
                : QString(),
            lettering(15), t.dim, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        return;
    }
    const AlarmEntry& entry = *found;
    w.fill(QRectF(0, px(6), px(5), high - px(6)), colourOf(entry.severity), px(2));
    w.sign(QRectF(px(16), px(12), px(26), px(26)), signOf(entry.severity),
           colourOf(entry.severity));
    w.text(QRectF(px(52), px(10), px(300), px(30)),
           entry.number.isEmpty() ? word("Message") : entry.number, lettering(18, true),
           colourOf(entry.severity));
    const auto line = [&](double top, double tall, const QString& name, const QString& told,
                          const QFont& font, const QColor& colour) {
        w.text(QRectF(px(52), top, px(106), px(24)), name, lettering(14), t.dim);
        Item& text = w.text(QRectF(px(164), top, wide - px(180), tall), told, font, colour,
                            Qt::AlignLeft | Qt::AlignTop);
        text.wraps = true;
        text.data = true;
    };
    line(px(42), px(48), word("Cause"), entry.text, lettering(17, true), t.text);
    line(px(94), px(46), word("Remedy"),
         entry.remedy.isEmpty() ? word("None is known.") : entry.remedy, lettering(16),
         entry.remedy.isEmpty() ? t.dim : t.text);
    w.text(QRectF(px(52), px(144), px(106), px(24)), word("Place"), lettering(14), t.dim);
    const QString channel = entry.channel ? QString("L%1").arg(entry.channel) : word("the machine");
    w.data(QRectF(px(164), px(144), wide - px(180), px(24)),
           QString("%1   %2   %3")
               .arg(channel, entry.place,
                    word("%1 s after the start of the controller").arg(entry.seconds, 0, 'f', 3)),
           lettering(15), t.dim);
}

void Alarms::refresh() {
    if (page_ == Page::Stops) {
        head_->refresh();
        return stops_->refresh();
    }
    // of the days before
    if (page_ == Page::History &&
        table_->row() + table_->visibleRows() >= static_cast<int>(rows_.size()))
        context_.alarms.askEarlier();
    if (version_ != context_.alarms.version()) fillAlarms();
    head_->refresh();
    table_->refresh();
    detail_->refresh();
}

std::vector<SoftKey> Alarms::keys() {
    const auto page = [this](Page wanted, const QString& text) {
        return SoftKey{text, [this, wanted] { showPage(wanted); }, Sign::None, true,
                       page_ == wanted};
    };
    std::vector<SoftKey> keys{page(Page::Standing, word("Active alarms")),
                              page(Page::History, word("History")), resetKey(context_),
                              page(Page::Stops, word("Log of stops"))};
    if (page_ == Page::Stops)
        stops_->addKeys(keys);
    else if (storeHasLost(context_.live))
        keys.push_back(
            {word("To the backups"), [this] { context_.show(kSystemScreen); }, Sign::Right});
    keys.resize(std::max(keys.size(), kResetAllPlace + 1));
    if (page_ != Page::Stops) {
        const AlarmEntry* entry = chosen();
        const Context::ProgramPlace place =
            entry ? Context::ProgramPlace{entry->file, static_cast<int>(entry->line)}
                  : Context::ProgramPlace{};
        keys[kOpenPlace] = {word("Open the program"),
                            [this, place] {
                                context_.placeToEdit = place;
                                context_.show(kProgramsScreen);
                            },
                            Sign::Programs, !place.file.isEmpty()};
    }
    keys[kResetAllPlace] = resetGroupKey(context_, groupOf(context_.live, context_.channel));
    return keys;
}

// Of the chosen alarm: what it says and what to do, then how alarms are read.
HelpTopic Alarms::help() const {
    if (page_ == Page::Stops) return {"operator.md", "Log of stops", {}};
    if (!chosen()) return {"operator.md", "Reading an alarm", {}};
    const AlarmEntry& entry = *chosen();
    return {"operator.md", "Reading an alarm",
            QString("# %1\n\n**%2:** %3\n\n**%4:** %5\n\n**%6:** %7")
                .arg(entry.number.isEmpty() ? word("Message") : entry.number, word("Cause"),
                     entry.text, word("Remedy"),
                     entry.remedy.isEmpty() ? word("None is known.") : entry.remedy, word("Place"),
                     (entry.channel ? QString("L%1").arg(entry.channel) : word("the machine")) +
                         "   " + entry.place)};
}

bool Alarms::key(QKeyEvent* event) {
    return page_ == Page::Stops ? stops_->key(event) : table_->key(event);
}

}  // namespace polyturn::hmi
