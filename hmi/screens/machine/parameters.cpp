#include "hmi/screens/machine/parameters.hpp"

#include <QDateTime>
#include <QJsonObject>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/text/dates.hpp"
#include "hmi/text/search.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/set_words.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/model/machine/load_machine.hpp"
#include "ipc/params/translations.hpp"
#include "ipc/params/unit.hpp"

namespace polyturn::hmi {
namespace {

constexpr double kBitLetter = 6.5;  // about so wide, in a bit's meaning
constexpr int kBitHits = 1;         // + number of the bit
constexpr int kTextHit = 100;
constexpr int kBitWaitsMs = 4'000;   // as long as a soft key waits for its second press
constexpr int kHistoryAtOnce = 300;  // rows: they are read within a frame

const char* effectWord(params::Effect effect) {
    switch (effect) {
        case params::Effect::Tick:
            return WORD("takes effect at once");
        case params::Effect::Barrier:
            return WORD("takes effect at the next preprocessing stop");
        case params::Effect::Restart:
            return WORD("takes effect after a restart of the controller");
    }
    return "";
}
const char* levelWord(params::Protection level) {
    switch (level) {
        case params::Protection::Operator:
            return WORD("operator");
        case params::Protection::Setter:
            return WORD("setter");
        case params::Protection::Maker:
            return WORD("maker");
    }
    return "";
}

// Found by a part of its number, or of its name, its meaning, the name or meaning of a bit: as
// people read them here, or in English, as builders' documents write them.
bool matches(const params::Row& row, const QString& searched) {
    const auto has = [&](std::string_view text) { return holds(fromView(text), searched); };
    if (searched.isEmpty() || has(row.number)) return true;
    for (const DisplayLanguage display_language : {spoken(), DisplayLanguage::English}) {
        const params::RowWords words = params::words_of(row, display_language);
        if (has(words.name) || has(words.meaning) ||
            std::any_of(words.bits.begin(), words.bits.end(), has))
            return true;
        if (spoken() == DisplayLanguage::English) break;
    }
    return std::any_of(row.bits.begin(), row.bits.end(),
                       [&](const params::Bit& bit) { return has(bit.name); });
}

// A value of the history: of a parameter of bits by its digits, as everywhere on this screen.
QString asShown(const QString& target, const QString& value) {
    static const QRegularExpression kEnd("[ \\[]");
    const params::Row* row = params::find(target.section(kEnd, 0, 0).toStdString());
    bool number = false;
    const unsigned bits = value.toUInt(&number);
    return row && row->type == params::Type::Bits && number && bits <= 255 && value.size() < 8
               ? bitDigits(bits)
               : value;
}

// A bit whose table gives its meaning for on has none for off where off is just that it does not;
// and the other way round.
QString bothMeanings(const QString& told) {
    static const QRegularExpression kOne("(^|[ ,;])1 "), kNone("(^|[ ,;])0 ");
    const bool one = told.contains(kOne), none = told.contains(kNone);
    return one == none ? told : word("%1; %2: not so").arg(told).arg(one ? 0 : 1);
}

}  // namespace

Parameters::Parameters(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      detail_(new FreeSheet(this)),
      groups_(new Table(this)),
      table_(new Table(this)),
      pad_(new NumberPad(this)),
      compensation_(new CompensationPage(context, this)) {
    compensation_->hide();
    undo_.present = [this](const Line& line) { return contentOf(line); };
    undo_.same = [](const Content& a, const Content& b) {
        return a.words ? a.text.trimmed() == b.text.trimmed()
                       : std::abs(a.number - b.number) <=
                             1e-9 * std::max({1.0, std::abs(a.number), std::abs(b.number)});
    };
    undo_.putBack = [this](const Undo::Change& change) { takeBack(change); };
    undo_.keep = [this](const Undo::Change& change, const Content& there) {
        context_.tell(word("%1 is %2 by now: it stays").arg(target(change.where), there.text),
                      Told::Refused);
    };
    setFocusPolicy(Qt::StrongFocus);
    names_ = {QString()};
    titles_ = {word("All groups")};
    for (const params::Row& row : params::rows()) {
        const QString group = fromView(row.group);
        if (std::find(names_.begin(), names_.end(), group) == names_.end()) {
            names_.push_back(group);
            titles_.push_back(word(row.group));
        }
    }
    groups_->columns = {{"", 1}};
    groups_->rowUnits = 34;
    groups_->textUnits = 14;
    groups_->rows = [this] { return static_cast<int>(names_.size()); };
    groups_->cell = [this](int row, int) -> Table::Cell {
        return {titles_[static_cast<std::size_t>(row)], row == group_ ? theme().text : theme().dim,
                Sign::None, row == group_};
    };
    groups_->onChosen = [this] {
        if (group_ == groups_->row()) return;
        group_ = groups_->row();
        search();
    };
    table_->rowUnits = 34;
    setColumns();
    table_->rows = [this] {
        return page_ == Page::History ? static_cast<int>(history_.size())
                                      : static_cast<int>(lines_.size());
    };
    table_->cell = [this](int row, int column) -> Table::Cell {
        if (page_ == Page::History) {
            const QJsonObject one = history_.at(row).toObject();
            if (column == 0)
                return {momentText(QDateTime::fromString(one.value("utc").toString(), Qt::ISODate)
                                       .toLocalTime(),
                                   "HH:mm:ss"),
                        theme().dim, Sign::None, false, Face::Condensed};
            static constexpr const char* kNames[] = {"what", "who", "old", "new"};
            const QString told = one.value(kNames[column - 1]).toString();
            return {column >= 3 ? asShown(one.value("what").toString(), told) : told,
                    column == 4 ? theme().accent : theme().text, Sign::None,
                    column == 4 || column == 1, column == 1 ? Face::Condensed : Face::Text};
        }
        const Line& line = lines_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const bool differ = differs(line);
        switch (column) {
            case 0:
                return {target(line), t.text, Sign::None, true, Face::Condensed};
            case 1:
                return {fromView(params::words_of(*line.row, spoken()).name),
                        line.row->acts == "yes" ? t.text : t.faint};
            case 2:
                return {textIn(context_.live.table(), line), differ ? t.accent : t.text, Sign::None,
                        differ};
            default:
                return {unitWord(params::unit_of(*line.row, context_.live.table(), line.instance)),
                        t.dim, Sign::None, false, Face::Condensed};
        }
    };
    table_->onChosen = [this] {
        touched_ = {};
        pad_->clear();
        detail_->refresh();
        if (bitsLook() != bits_)
            layOut();
        else
            void();
    };
    table_->onActivated = [this] {
        if (const Line* line = chosen()) askText(*line);
    };
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        const QString title =
            page_ == Page::Compensation ? word("Compensation tables")
            : page_ == Page::History
                ? word("Changes of %1")
                      .arg(historyOf_.isEmpty() ? word("all parameters") : historyOf_)
                : word("Parameters");
        w.data(QRectF(px(14), 0, page_ == Page::List ? px(240) : head_->width() - px(28),
                      head_->height()),
               title, lettering(20, true), t.text);
        if (page_ != Page::List) return;
        const QRectF box(head_->width() - px(460), px(6), px(452), head_->height() - px(10));
        w.field(box, search_, word("Search: number, name or meaning"), searching_, 1);
        w.text(QRectF(head_->width() - px(600), 0, px(130), head_->height()),
               (search_.isEmpty() ? word("values: %1") : word("Found: %1")).arg(lines_.size()),
               lettering(15), t.dim, kRight);
    };
    head_->onTouched = [this](int) {
        context_.ask({word("Search"), search_, [this](const QString& text) { find(text); }, {}});
    };
    detail_->onCompose = [this](Writer& w) { composeDetail(w); };
    detail_->onTouched = [this](int number) {
        const Line* line = chosen();
        if (line && number == kTextHit) return askText(*line);
        if (!line || line->row->type != params::Type::Bits || number < kBitHits) return;
        // One touch chooses, the next one turns it over: a touch that only looks must not change
        // the machine.
        const auto touched = static_cast<unsigned>(number - kBitHits);
        const bool again = touched_.row == line->row && touched_.instance == line->instance &&
                           touched_.element == line->element && touched_.bit == touched &&
                           touched_.since.elapsed() < kBitWaitsMs;
        bit_ = touched;
        if (again) return turnBit(*line, bit_);
        touched_ = {line->row, line->instance, line->element, touched, {}};
        touched_.since.start();
        context_.tell(word("Touch the bit again: it is turned over"), Told::Note);
        detail_->refresh();
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const Line* line = chosen();
        if (!line || line->row->type == params::Type::Text || !context_.live.connected())
            return std::nullopt;
        return NumberPad::Field{
            target(*line),
            unitWord(params::unit_of(*line->row, context_.live.table(), line->instance)),
            value(*line),
            line->row->type == params::Type::Real ? 4u : 0u,
            line->row->type == params::Type::Bits,
            1,
            line->row->type != params::Type::Bits};
    };
    pad_->onInput = [this](double now) {
        if (const Line* line = chosen()) put(*line, now);
    };
    pad_->onAdded = [this](double delta) {
        if (const Line* line = chosen()) askStore(*line, {{"delta", delta}}, {});
    };
    search();
}

// The group, the row of the list, the search; page and filter.
QString Parameters::state() const {
    return QString("%1|%2|%3|%4|%5")
        .arg(group_)
        .arg(page_ == Page::List ? table_->row() : listRow_)
        .arg(QString(search_).remove('|'))
        .arg(static_cast<int>(page_))
        .arg(static_cast<int>(only_));
}

void Parameters::restore(const QString& state) {
    if (state.count('|') < 2) return;
    if (page_ != Page::List) showPage(Page::List);
    group_ = std::clamp(state.section('|', 0, 0).toInt(), 0, static_cast<int>(names_.size()) - 1);
    search_ = state.section('|', 2, 2);
    only_ = static_cast<Only>(
        std::clamp(state.section('|', 4, 4).toInt(), 0, static_cast<int>(Only::UnlikeFile)));
    groups_->choose(group_);
    search();
    table_->choose(state.section('|', 1, 1).toInt());
    if (const int page = state.section('|', 3, 3).toInt();
        page > 0 && page <= static_cast<int>(Page::Compensation))
        showPage(static_cast<Page>(page));
}

// The instances that the machine has.
void Parameters::search() {
    const MachineConfig& machine = context_.live.config();
    touched_ = {};
    lines_.clear();
    if (context_.live.connected())
        for (const params::Row& row : params::rows()) {
            if (group_ > 0 && fromView(row.group) != names_[static_cast<std::size_t>(group_)])
                continue;
            if (!matches(row, search_)) continue;
            const unsigned count = params::instances(row.scope);
            for (unsigned instance = 1; instance <= count; ++instance) {
                if (row.scope == params::Scope::Channel && !machine.channel(instance).exists())
                    continue;
                if (row.scope == params::Scope::Axis && !machine.axis(instance).exists()) continue;
                if (row.scope == params::Scope::Spindle && !machine.spindle(instance).exists())
                    continue;
                if (row.scope == params::Scope::Group && machine.channels_of_group(instance) == 0)
                    continue;
                for (unsigned element = 0; element < row.array; ++element) {
                    const Line line{&row, instance, element};
                    if (only_ == Only::Changed      ? differs(line)
                        : only_ == Only::UnlikeFile ? unlikeFile(line)
                                                    : true)
                        lines_.push_back(line);
                }
            }
        }
    table_->choose(0);
    head_->refresh();
}

// The parameter's row: the manual of the machine is the list of its parameters.
HelpTopic Parameters::help() const {
    const Line* line = chosen();
    if (!line) return {"builder.md", "The machine is its parameters", {}};
    const params::Row& row = *line->row;
    const params::RowWords words = params::words_of(row, spoken());
    const QString unit = unitWord(params::unit_of(row, context_.live.table(), line->instance));
    return {
        "builder.md", "The machine is its parameters",
        QString("# %1 %2\n\n%3\n\n| | |\n| --- | --- |\n| %4 | %5 %6 |\n| %7 | %8 |\n| %9 | %10 |")
            .arg(fromView(row.number), fromView(words.name), fromView(words.meaning), word("Value"),
                 textIn(context_.live.table(), *line), unit)
            .arg(word("Effect"), word(effectWord(row.effect)), word("Level"),
                 word(levelWord(row.protection)))};
}

const Parameters::Line* Parameters::chosen() const {
    const int row = table_->row();
    return page_ == Page::List && row >= 0 && row < static_cast<int>(lines_.size())
               ? &lines_[static_cast<std::size_t>(row)]
               : nullptr;
}

double Parameters::value(const Line& line) const {
    if (line.row->type == params::Type::Text) return 0;
    return context_.live.table()
        .numbers[line.row->first_slot +
                 static_cast<std::size_t>(line.instance - 1) * line.row->array + line.element];
}

bool Parameters::differs(const Line& line) const {
    if (line.row->type == params::Type::Text)
        return params::text_at(context_.live.table(),
                               line.row->first_slot +
                                   static_cast<std::size_t>(line.instance - 1) * line.row->array +
                                   line.element) != line.row->default_text;
    return value(line) != line.row->default_number(line.element);
}

bool Parameters::unlikeFile(const Line& line) const {
    return file_ && textIn(*file_, line) != textIn(context_.live.table(), line);
}

QString Parameters::textIn(const params::Table& table, const Line& line) const {
    if (line.row->type == params::Type::Bits)
        return bitDigits(static_cast<unsigned>(
            table.numbers[line.row->first_slot +
                          static_cast<std::size_t>(line.instance - 1) * line.row->array +
                          line.element]));
    return QString::fromStdString(
        params::value_text(*line.row, table, line.instance, line.element));
}

// The file may lie on a network.
void Parameters::readFile() {
    if (!context_.live.connected()) return;
    reading_.start([base = context_.live.machineFolder()](
                       const std::atomic<bool>&) -> std::shared_ptr<params::Table> {
        if (base.empty()) return nullptr;
        LoadedMachine loaded = load_machine_file(base + ".params");
        return loaded.ok() ? std::shared_ptr<params::Table>(std::move(loaded.table)) : nullptr;
    });
    takeFile();
}

void Parameters::takeFile() {
    if (auto made = reading_.take()) {
        file_ = *made;
        if (only_ == Only::UnlikeFile) search();
        detail_->refresh();
    }
}

void Parameters::setColumns() {
    if (page_ == Page::History) {
        table_->columns = {{word("When"), 1.6},
                           {word("What"), 1.8},
                           {word("Who"), 1.6},
                           {word("Before"), 1.6, kRight},
                           {word("After"), 1.6, kRight}};
        table_->nothing = word("No changes recorded.");
    } else {
        table_->columns = {{word("Number"), 1.7},
                           {word("Name"), 3},
                           {word("Value"), 1.6, kRight},
                           {word("Unit"), 1.6}};
        table_->nothing = word("No parameter has this in its number, name or meaning.");
    }
}

std::vector<Sheet*> Parameters::sheets() {
    if (page_ == Page::List) {
        if (bits_ == Bits::Alone) return {head_, groups_, table_, detail_};
        return {head_, groups_, table_, detail_, pad_};
    }
    if (page_ == Page::History) return {head_, table_};
    std::vector<Sheet*> out = compensation_->sheets();
    out.push_back(head_);
    return out;
}

// The history tells of the parameter that was chosen when it was asked for.
void Parameters::showPage(Page page) {
    const Line* line = chosen();
    const QString about = line ? target(*line) : QString();
    const int row = table_->row();
    if (page_ == Page::List) listRow_ = row;
    page_ = page;
    touched_ = {};
    setColumns();
    history_ = {};
    historyOf_ = about;
    historyAll_ = false;
    if (page == Page::Compensation) compensation_->begin();
    if (page == Page::History) askHistory();
    table_->choose(page == Page::List ? listRow_ : 0);
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

// The newest, then what is older when the last row comes into sight.
void Parameters::askHistory() {
    QJsonObject request{{"do", "history.list"}, {"most", kHistoryAtOnce}};
    if (historyOf_.isEmpty())
        request.insert("kind", "parameters");
    else
        request.insert("of", historyOf_);
    if (!history_.isEmpty()) {
        request.insert("before_utc", history_.last().toObject().value("utc"));
        request.insert("before_id", history_.last().toObject().value("id"));
    }
    historyAsked_ = true;
    context_.requests.store(
        request, [this, of = historyOf_, after = history_.size()](const Answer& answer) {
            historyAsked_ = false;
            if (page_ != Page::History || historyOf_ != of || history_.size() != after) return;
            const QJsonArray more = answer.object.value("history").toArray();
            historyAll_ = !answer.ok || more.size() < kHistoryAtOnce;
            for (const auto& one : more) history_.append(one);
            refresh();
        });
}

void Parameters::turnTo(int page) {
    showPage(page == 2 ? Page::History : page >= 3 ? Page::Compensation : Page::List);
    if (page > 3)
        compensation_->chooseKind(page == 4 ? CompensationCurve::Kind::Straightness
                                            : CompensationCurve::Kind::Grid);
    if (page < 2) find(page == 1 ? "N0106" : QString());
}

Parameters::Bits Parameters::bitsLook() const {
    const Line* line = chosen();
    return !line || line->row->type != params::Type::Bits ? Bits::None
           : pad_->text().isEmpty()                       ? Bits::Alone
                                                          : Bits::Typed;
}

params::Target Parameters::targetOf(const Line& line) {
    params::Target target{line.row};
    if (line.row->scope != params::Scope::Global) target.instance = line.instance;
    if (line.row->array > 1) target.element = static_cast<int>(line.element);
    return target;
}

QString Parameters::target(const Line& line) const {
    return QString::fromStdString(params::target_text(targetOf(line)));
}

QString Parameters::textOf(const Line& line, double number) {
    // else the control says what is allowed
    const bool digits = line.row->type == params::Type::Bits && number >= 0 && number <= 255;
    return digits                                 ? bitDigits(static_cast<unsigned>(number))
           : line.row->type == params::Type::Real ? QString::number(number, 'g', 15)
                                                  : QString::number(std::llround(number));
}

void Parameters::put(const Line& line, double now) { put(line, Content{now, textOf(line, now)}); }

// Only this bit is written: another panel may have turned its neighbour.
void Parameters::turnBit(const Line& line, unsigned bit) {
    touched_ = {};
    const auto turned = static_cast<unsigned>(value(line)) ^ 1u << bit;
    params::Target one = targetOf(line);
    one.bit = static_cast<int>(bit);
    put(line, Content{static_cast<double>(turned), bitDigits(turned)},
        QString::fromStdString(params::target_text(one)) + (turned >> bit & 1u ? "=1" : "=0"));
}

void Parameters::nextBit(const params::Row& row, int step) {
    const auto at = std::find_if(row.bits.begin(), row.bits.end(),
                                 [this](const params::Bit& bit) { return bit.number == bit_; });
    touched_ = {};
    const auto here = at == row.bits.end() ? 0 : at - row.bits.begin() + step;
    if (row.bits.empty()) return;
    bit_ = row.bits[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(
                        here, 0, static_cast<std::ptrdiff_t>(row.bits.size()) - 1))]
               .number;
    detail_->refresh();
}

Parameters::Content Parameters::contentOf(const Line& line) const {
    return {value(line), textIn(context_.live.table(), line), line.row->type == params::Type::Text};
}

void Parameters::put(const Line& line, const Content& now, const QString& written) {
    undo_.asked();
    context_.requests.parameter(written.isEmpty() ? target(line) + "=" + now.text : written,
                                [this, change = Undo::Change{line, contentOf(line), now}](
                                    const Answer& answer) { done(change, answer, false); });
}

// The store adds, and takes back what still stands there: another panel or a program may have
// written since this was drawn.
void Parameters::askStore(const Line& line, QJsonObject entry, std::optional<Undo::Change> taken) {
    undo_.asked();
    entry.insert("do", "parameters.set");
    entry.insert("target", target(line));
    context_.requests.store(entry, [this, line, taken](const Answer& answer) {
        const auto content = [&](const char* name) {
            const double number = answer.object.value(name).toDouble();
            return Content{number, textOf(line, number)};
        };
        done(taken ? *taken : Undo::Change{line, content("old"), content("new")}, answer,
             taken.has_value());
    });
}

void Parameters::takeBack(const Undo::Change& change) {
    const Undo::Change back{change.where, change.now, change.old};
    if (!change.now.words)
        return askStore(change.where,
                        {{"value", change.old.number}, {"expected", change.now.number}}, back);
    undo_.asked();
    context_.requests.parameter(target(change.where) + "=" + change.old.text,
                                [this, back](const Answer& answer) { done(back, answer, true); });
}

void Parameters::done(const Undo::Change& change, const Answer& answer, bool undone) {
    if (!answer.ok) return undo_.refused();
    if (undone)
        undo_.takenBack(change);
    else
        undo_.entered(change);
    context_.tell(QString::fromUtf8("%1: %2 → %3")
                      .arg(target(change.where), change.old.text, change.now.text),
                  Told::Good);
    refresh();
}

void Parameters::askText(const Line& line) {
    if (!context_.live.connected() || line.row->type != params::Type::Text) return;
    context_.ask({target(line),
                  QString::fromStdString(params::value_text(*line.row, context_.live.table(),
                                                            line.instance, line.element)),
                  {},
                  [this, line](const QString& text) {
                      put(line, Content{0, text, true});
                  }});
}

void Parameters::resizeEvent(QResizeEvent*) { layOut(); }

void Parameters::layOut() {
    const int top = px(46), edge = px(8), groups = px(190), side = px(330), pad = px(346);
    head_->setGeometry(0, 0, width(), top);
    bits_ = bitsLook();
    // a finger must hit each of eight bits
    const Parted all = parted(*this, QRect(edge, top, width() - 2 * edge, height() - top - edge),
                              side, px(bits_ == Bits::None ? 420 : 540), edge);
    groups_->setGeometry(QRect(all.main.topLeft(), QSize(groups, all.main.height())));
    const bool list = page_ == Page::List;
    // Bits keep their room while a number is typed: the keys come beneath the list.
    const bool beneath = bits_ == Bits::Typed;
    const bool stacked = upright(*this);
    const Padded below = padded(*this, all.side, px(346), pad, edge);
    const QRect middle =
        all.main.adjusted(groups + edge, 0, 0, beneath && !stacked ? -pad - edge : 0);
    if (list)
        table_->setGeometry(middle);
    else
        table_->setGeometry(edge, top, width() - 2 * edge, height() - top - edge);
    detail_->setGeometry(bits_ == Bits::None || (beneath && stacked) ? below.rest : all.side);
    pad_->setGeometry(beneath && !stacked
                          ? QRect(middle.right() + 1 - side, height() - pad - edge, side, pad)
                          : below.pad);
    compensation_->setGeometry(0, top, width(), height() - top);
    groups_->setVisible(list);
    detail_->setVisible(list);
    pad_->setVisible(list && bits_ != Bits::Alone);
    table_->setVisible(page_ != Page::Compensation);
    compensation_->setVisible(page_ == Page::Compensation);
    for (Sheet* one : sheets()) one->refresh();
}

void Parameters::composeDetail(Writer& w) {
    const Theme& t = theme();
    const double wide = detail_->width(), high = detail_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const Line* line = chosen();
    if (!line) return;
    const params::Row& row = *line->row;
    const params::RowWords words = params::words_of(row, spoken());
    double y = px(8);
    w.data(QRectF(px(12), y, wide - px(24), px(24)), target(*line) + "  " + fromView(words.name),
           lettering(16, true), t.text);
    y += px(26);
    const bool bits = row.type == params::Type::Bits;
    const QFont meant = lettering(13.5);
    // what is not so is said below it
    const double most = px(bits || row.acts != "yes" ? 60 : 96);
    // what it leaves is the bits'
    const double meaning =
        bits ? std::min(most, setWords(fromView(words.meaning), meant, wide - px(24), true).height +
                                  px(4))
             : most;
    Item& text = w.text(QRectF(px(12), y, wide - px(24), meaning), fromView(words.meaning), meant,
                        t.dim, Qt::AlignLeft | Qt::AlignTop);
    text.wraps = true;
    text.data = true;
    y += meaning + px(2);
    // each bit with what it means on and off; a touch chooses it, the next one turns it over
    if (bits) {
        const auto now = static_cast<unsigned>(value(*line));
        // beneath: what is shown of every parameter
        const double facts = px(90 + (row.acts != "yes" ? 36 : 0));
        // Shares of the height by the lines of the texts, about so many letters each: three lines
        // must not be cut where others have one.
        const double letters = (wide - px(104)) / px(kBitLetter);
        const auto linesOf = [&](const params::Bit& bit) {
            return std::max(2.0,
                            std::ceil(static_cast<double>(
                                          bothMeanings(fromView(words.bits[bit.number])).size()) /
                                      letters));
        };
        double all = 0;
        for (const params::Bit& bit : row.bits) all += linesOf(bit);
        const double tall =
            std::min<double>(px(31), (high - y - px(10) - facts) / std::max(1.0, all));
        for (const params::Bit& bit : row.bits) {
            const bool on = now >> bit.number & 1u;
            const double each = tall * linesOf(bit);
            const QRectF box(px(8), y, wide - px(16), each - px(2));
            w.fill(box, on ? t.mark : t.raised, px(4));
            if (bit.number == bit_) w.frame(box, t.accent, px(4), px(2));
            w.sign(QRectF(box.left() + px(5), box.center().y() - px(8), px(16), px(16)),
                   on ? Sign::Good : Sign::None, t.good);
            w.data(QRectF(box.left() + px(26), box.top(), px(62), box.height()),
                   QString("#%1 %2").arg(bit.number).arg(fromView(bit.name)),
                   lettering(12.5, true, Face::Condensed), t.text);
            const QRectF room(box.left() + px(84), box.top(), box.width() - px(88), box.height());
            const QString both = bothMeanings(fromView(words.bits[bit.number]));
            // smaller where a language has a line more than there is room for
            QFont font = lettering(each < px(40) ? 12 : 13, false, Face::Condensed);
            for (const double units : {12.0, 11.0})
                if (setWords(both, font, room.width(), true).height > room.height())
                    font = lettering(units, false, Face::Condensed);
            Item& told =
                w.text(room, wordsCutTo(both, font, room.size()), font, on ? t.text : t.dim);
            told.wraps = told.data = true;
            w.hit(box, kBitHits + bit.number);
            y += each;
        }
        y += px(6);
    }
    const auto fact = [&](const QString& name, const QString& what, const QColor& colour) {
        if (y + px(20) > high) return;
        w.text(QRectF(px(12), y, px(96), px(20)), name, lettering(13), t.dim);
        w.data(QRectF(px(110), y, wide - px(122), px(20)), what, lettering(13.5, true), colour,
               kRight);
        y += px(19);  // five lines and the card's border
    };
    if (bits) {
        fact(word("Default"), bitDigits(static_cast<unsigned>(row.default_number(line->element))),
             t.text);
    } else if (row.type != params::Type::Text) {
        fact(word("Range"),
             QString::fromUtf8("%1 … %2").arg(row.min, 0, 'g', 9).arg(row.max, 0, 'g', 9), t.text);
        fact(word("Default"), QString::number(row.default_number(line->element), 'g', 12), t.text);
    } else {
        fact(word("Default"), fromView(row.default_text), t.text);
    }
    if (file_)
        fact(word("In the file"), textIn(*file_, *line), unlikeFile(*line) ? t.accent : t.text);
    fact(word("Level"), word(levelWord(row.protection)), t.text);
    w.text(QRectF(px(12), y, wide - px(24), px(20)), word(effectWord(row.effect)), lettering(13),
           t.dim);
    y += px(19);
    if (row.acts != "yes" && y + px(34) < high) {
        Item& why = w.text(QRectF(px(12), y, wide - px(24), px(36)),
                           word("Without effect:") + " " + fromView(words.acts), lettering(13),
                           t.warn, Qt::AlignLeft | Qt::AlignTop);
        why.wraps = true;
        why.data = true;
    }
    if (row.type == params::Type::Text)
        w.field(QRectF(px(10), high - px(50), wide - px(20), px(42)),
                QString::fromStdString(
                    params::value_text(row, context_.live.table(), line->instance, line->element)),
                word("Touch, or Enter: a text"), false, kTextHit);
}

void Parameters::refresh() {
    takeFile();
    undo_.goOn();
    if (page_ == Page::Compensation) {
        head_->refresh();
        return compensation_->refresh();
    }
    if (page_ == Page::History && !historyAll_ && !historyAsked_ && !history_.isEmpty() &&
        table_->row() + table_->visibleRows() >= history_.size())
        askHistory();
    if (page_ == Page::List && bitsLook() != bits_) layOut();
    groups_->focused = onGroups_;
    table_->focused = page_ == Page::List && !onGroups_;
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<SoftKey> Parameters::keys() {
    const bool ready = context_.live.connected() && pad_->ready() && chosen() &&
                       chosen()->row->type != params::Type::Text;
    const Undo::Change* last = undo_.newest();
    const Line* line = chosen();
    std::vector<SoftKey> keys{{word("Search"),
                               [this] {
                                   searching_ = !searching_;
                                   head_->refresh();
                               },
                               Sign::None, true, searching_},
                              {word("Clear search"),
                               [this] {
                                   search_.clear();
                                   searching_ = false;
                                   search();
                               },
                               Sign::None, !search_.isEmpty()},
                              {word("Changed only"),
                               [this] {
                                   only_ = only_ == Only::Changed ? Only::All : Only::Changed;
                                   search();
                               },
                               Sign::None, context_.live.connected(), only_ == Only::Changed},
                              {word("Differs from file"),
                               [this] {
                                   only_ = only_ == Only::UnlikeFile ? Only::All : Only::UnlikeFile;
                                   search();
                               },
                               Sign::None, file_ != nullptr, only_ == Only::UnlikeFile},
                              {word("Input"), [this] { pad_->enter(false); }, Sign::None, ready},
                              {word("+ Input"), [this] { pad_->enter(true); }, Sign::None, ready},
                              {word("Default value"),
                               [this] {
                                   if (const Line* now = chosen())
                                       put(*now, now->row->default_number(now->element));
                               },
                               Sign::None,
                               line && line->row->type != params::Type::Text && differs(*line),
                               false,
                               false,
                               word("Sets the default: press again"),
                               {},
                               line ? target(*line) : QString(),
                               line ? target(*line) : QString()},
                              {word("Undo"),
                               [this] { undo_.undo(); },
                               Sign::Undo,
                               last != nullptr,
                               false,
                               false,
                               {},
                               {},
                               {},
                               last ? target(last->where) : QString()}};
    if (page_ != Page::List) keys.assign(8, {});
    if (page_ == Page::Compensation) keys = compensation_->keys();
    const auto page = [this](Page wanted, const QString& text) {
        return SoftKey{text, [this, wanted] { showPage(page_ == wanted ? Page::List : wanted); },
                       page_ == wanted ? Sign::Left : Sign::None, context_.live.connected(),
                       page_ == wanted};
    };
    keys.push_back(page(Page::History, word("History")));
    keys.push_back(page(Page::Compensation, word("Compensation tables")));
    return keys;
}

bool Parameters::key(QKeyEvent* event) {
    if (page_ == Page::Compensation) return compensation_->key(event);
    if (page_ == Page::History) return table_->key(event);
    if (searching_) {
        if (event->key() == Qt::Key_Escape || event->key() == Qt::Key_Return ||
            event->key() == Qt::Key_Enter) {
            searching_ = false;
            head_->refresh();
        } else if (event->key() == Qt::Key_Backspace) {
            search_.chop(1);
            search();
        } else if (!event->text().isEmpty() && event->text()[0].isPrint()) {
            search_ += event->text();
            search();
        } else
            return table_->key(event);
        return true;
    }
    if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab) {
        onGroups_ = !onGroups_;
        refresh();
        return true;
    }
    if (const Line* line = chosen(); line && bitsLook() == Bits::Alone && !onGroups_) {
        if (event->key() == Qt::Key_Left || event->key() == Qt::Key_Right) {
            nextBit(*line->row, event->key() == Qt::Key_Right ? 1 : -1);
            return true;
        }
        if (event->key() == Qt::Key_Space) {
            turnBit(*line, bit_);
            return true;
        }
    }
    if (pad_->key(event)) return true;
    return (onGroups_ ? groups_ : table_)->key(event);
}

}  // namespace polyturn::hmi
