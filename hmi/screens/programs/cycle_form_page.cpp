#include "hmi/screens/programs/cycle_form_page.hpp"

#include <QKeyEvent>
#include <QRegularExpression>
#include <cmath>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

using forms::Unit;

QString addressText(const forms::Field& field, const forms::Value& value) {
    return value.address.empty() ? fromView(field.address) : QString::fromStdString(value.address);
}

// Lengths as the program counts them, whatever the screens show.
QString unitText(Unit unit, bool inch) {
    switch (unit) {
        case Unit::Length:
        case Unit::Fine:
            return unitWord(inch ? "inch" : "mm");
        case Unit::Diameter:
            return inch ? word("inch, diameter") : word("mm, diameter");
        case Unit::Degrees:
        case Unit::Rotary:
        case Unit::Thousandth:
            return QString::fromUtf8("°");
        case Unit::Milliseconds:
            return unitWord("ms");
        case Unit::Hundredths:
            return word("1/100 s");
        case Unit::Seconds:
            return unitWord("s");
        case Unit::FeedRate:
            return word("feed");
        case Unit::Lead:
            return unitWord(inch ? "inch/rev" : "mm/rev");
        case Unit::Tenths:
            return word("1/10 lead");
        case Unit::Label:
            return "N";
        case Unit::Speed:
            return unitWord("1/min");
        default:
            return {};
    }
}

}  // namespace

forms::Dialect formDialect(const Live& live, unsigned channel, const QString& language) {
    const params::Table& t = live.table();
    const char system = params::bit(t, params::f3401, channel, 7)   ? 'C'
                        : params::bit(t, params::f3401, channel, 6) ? 'B'
                                                                    : 'A';
    const double increment =
        live.connected()
            ? std::pow(10.0, -static_cast<double>(live.config().channel(channel).decimals()))
            : 0.001;
    return forms::dialect_of(language.toStdString(), system,
                             params::bit(t, params::f0001, channel, 1),
                             params::bit(t, params::f3401, channel, 0), increment);
}

CycleFormPage::CycleFormPage(Context& context, QWidget* parent)
    : EditorOverlay(parent),
      context_(context),
      table_(new Table(this)),
      picture_(new CyclePicture(this)),
      pad_(new NumberPad(this)),
      note_(new FreeSheet(this)) {
    table_->rowUnits = 40;
    table_->textUnits = 16;
    table_->rows = [this] { return static_cast<int>(now_ ? now_->values.size() : list_.size()); };
    table_->cell = [this](int row, int column) { return cell(row, column); };
    table_->onChosen = [this] {
        pad_->clear();
        point();
        note_->refresh();
    };
    table_->onActivated = [this] {
        if (!now_) choose(table_->row());
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const int i = field();
        if (i < 0) return std::nullopt;
        const forms::Field& f = now_->form->fields[static_cast<std::size_t>(i)];
        const forms::Value& v = now_->values[static_cast<std::size_t>(i)];
        return NumberPad::Field{addressText(f, v) + "  " + word(f.meaning),
                                unitText(f.unit, dialect_.inch),
                                v.expression.empty() ? v.number : 0.0,
                                static_cast<unsigned>(forms::decimals_of(f, dialect_))};
    };
    pad_->onInput = [this](double value) { input(value); };
    note_->onCompose = [this](Writer& w) { composeNote(w); };
}

bool CycleFormPage::open(const QStringList& lines, int cursor, const forms::Dialect& dialect) {
    lines_.clear();
    for (const QString& line : lines) lines_.push_back(line.toStdString());
    cursor_ = cursor;
    dialect_ = dialect;
    list_.clear();
    forms::each_form(dialect, [this](const forms::Form& form) { list_.push_back(&form); });
    if (!dialect.speaks) list_.clear();
    if (list_.empty()) return false;
    before_ = forms::read_cycle(lines_, cursor, dialect);
    if (before_)
        showForm(*before_);
    else
        showList();
    return true;
}

void CycleFormPage::showList() {
    now_.reset();
    table_->columns = {{word("Cycle"), 0.6}, {word("What it does"), 2.3}};
    table_->choose(0);
    point();
    resizeEvent(nullptr);
    refresh();
}

void CycleFormPage::showForm(forms::CycleBlock cycle) {
    now_ = std::move(cycle);
    faults_ = forms::check_cycle(*now_);
    table_->columns = {{word("Word"), 0.5},
                       {word("Meaning"), 3.2},
                       {word("Value"), 1.3, Qt::AlignRight | Qt::AlignVCenter},
                       {word("Unit"), 1.1}};
    picture_->show(now_->form);
    table_->choose(0);
    pad_->clear();
    point();
    resizeEvent(nullptr);
    refresh();
}

void CycleFormPage::choose(int row) {
    if (row < 0 || row >= static_cast<int>(list_.size())) return;
    forms::CycleBlock fresh = forms::new_cycle(*list_[static_cast<std::size_t>(row)], dialect_);
    before_ = forms::CycleBlock{fresh.form, fresh.values, {-1, -1}};
    showForm(std::move(fresh));
    if (context_.keysChanged) context_.keysChanged();
}

QString CycleFormPage::code() const {
    const auto row = static_cast<std::size_t>(std::max(0, table_->row()));
    const QString all = now_                 ? fromView(now_->form->code)
                        : row < list_.size() ? fromView(list_[row]->code)
                                             : QString();
    return all.section(' ', -1);  // MCALL CYCLE82
}

int CycleFormPage::field() const {
    return now_ && table_->row() < static_cast<int>(now_->values.size()) ? table_->row() : -1;
}

void CycleFormPage::point() {
    if (now_) return picture_->point(field(), field() < 0 ? QString() : valueText(field()));
    const auto row = static_cast<std::size_t>(std::max(0, table_->row()));
    picture_->show(row < list_.size() ? list_[row] : nullptr);
}

QString CycleFormPage::valueText(int i) const {
    const auto k = static_cast<std::size_t>(i);
    const forms::Value& v = now_->values[k];
    if (!v.set) return {};
    if (!v.expression.empty()) return QString::fromStdString(v.expression);
    QString text =
        QString::number(v.number, 'f', forms::decimals_of(now_->form->fields[k], dialect_));
    while (text.contains('.') && (text.endsWith('0') || text.endsWith('.'))) {
        const bool point = text.endsWith('.');
        text.chop(1);
        if (point) break;
    }
    return text;
}

QString CycleFormPage::faultText(int i) const {
    if (!now_ || i < 0 || static_cast<std::size_t>(i) >= faults_.size()) return {};
    const forms::FieldFault& fault = faults_[static_cast<std::size_t>(i)];
    switch (fault.kind) {
        case forms::FieldFault::Missing:
            return word("A value is needed here.");
        case forms::FieldFault::TooSmall:
            return word("Too small: at least %1.").arg(fault.limit);
        case forms::FieldFault::TooLarge:
            return word("Too large: at most %1.").arg(fault.limit);
        case forms::FieldFault::NotWhole:
            return word("Only a whole number is possible.");
        case forms::FieldFault::NoNumber:
            return word("This is no number.");
        case forms::FieldFault::None:
            break;
    }
    return {};
}

QString CycleFormPage::hintText(int i) const {
    if (!now_ || i < 0) return {};
    const forms::Field& f = now_->form->fields[static_cast<std::size_t>(i)];
    const forms::Value& v = now_->values[static_cast<std::size_t>(i)];
    const bool other_program = dialect_.speaks == forms::kFagor && f.address == "Q";
    if (f.unit != Unit::Label || other_program || !v.set || !v.expression.empty()) return {};
    // the contour is in the program Q
    if (dialect_.speaks == forms::kFagor && now_->values.back().set) return {};
    const QRegularExpression block(
        QString("^\\s*(?:/\\d?\\s*)?N0*%1(?!\\d)").arg(static_cast<long>(v.number)),
        QRegularExpression::CaseInsensitiveOption);
    for (const std::string& line : lines_)
        if (QString::fromStdString(line).contains(block)) return {};
    return word("There is no block N%1 in this program yet.").arg(static_cast<long>(v.number));
}

Table::Cell CycleFormPage::cell(int row, int column) const {
    const Theme& t = theme();
    const auto i = static_cast<std::size_t>(row);
    if (!now_) {
        if (i >= list_.size()) return {};
        return column == 0 ? Table::Cell{fromView(list_[i]->code), t.accent, Sign::None, true}
                           : Table::Cell{word(list_[i]->title)};
    }
    const forms::Field& f = now_->form->fields[i];
    const forms::Value& v = now_->values[i];
    const bool changed = before_ && !(before_->values[i] == v);
    switch (column) {
        case kAddress: {
            const QString name = addressText(f, v);
            return {now_->form->two_blocks()
                        ? name + (f.block ? QString::fromUtf8(" ②") : QString::fromUtf8(" ①"))
                        : name,
                    t.accent, Sign::None, true};
        }
        case kMeaning:
            return {word(f.meaning), f.needed || v.set ? t.text : t.dim};
        case kValue: {
            const bool good = i >= faults_.size() || faults_[i].kind == forms::FieldFault::None;
            const bool missing = good && !hintText(row).isEmpty();
            if (missing) return {valueText(row), t.warn, Sign::Note, true, Face::Text};
            return {v.set ? valueText(row) : QString::fromUtf8("–"),
                    good ? (changed ? t.accent
                            : v.set ? t.text
                                    : t.faint)
                         : t.bad,
                    good ? Sign::None : Sign::Warning, changed || !good, Face::Text};
        }
        default:
            return {
                unitText(f.unit, dialect_.inch), t.dim, Sign::None, false, Face::Text, {}, 13.5};
    }
}

void CycleFormPage::input(double value) {
    const int i = field();
    if (i < 0) return;
    forms::Value& v = now_->values[static_cast<std::size_t>(i)];
    const double step = std::pow(
        10.0, -forms::decimals_of(now_->form->fields[static_cast<std::size_t>(i)], dialect_));
    const bool whole = now_->form->fields[static_cast<std::size_t>(i)].whole();
    v.set = true;
    v.expression.clear();
    v.number = whole ? value : std::round(value / step) * step;
    faults_ = forms::check_cycle(*now_);
    if (const QString fault = faultText(i); !fault.isEmpty())
        context_.tell(fault, Told::Refused);
    else if (i + 1 < static_cast<int>(now_->values.size()))
        table_->choose(i + 1);
    point();
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void CycleFormPage::erase() {
    const int i = field();
    if (i < 0) return;
    forms::Value& v = now_->values[static_cast<std::size_t>(i)];
    const std::string address = v.address;
    v = {};
    v.address = address;
    pad_->clear();
    faults_ = forms::check_cycle(*now_);
    point();
    refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void CycleFormPage::write() {
    if (!now_ || !forms::is_good(faults_) || !onWrite) return;
    const auto changes = forms::write_cycle(lines_, *before_, *now_, cursor_, dialect_);
    onWrite(changes);
    if (onClose) onClose();
}

void CycleFormPage::composeNote(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, note_->width(), note_->height()), t.window);
    w.fill(QRectF(0, px(6), note_->width(), note_->height() - px(6)), t.card, px(8));
    if (!now_) {
        w.text(QRectF(px(14), px(6), note_->width() - px(28), note_->height() - px(6)),
               word("Choose a cycle: touch it twice, or Enter."), lettering(15.5), t.text);
        return;
    }
    w.text(QRectF(px(14), px(10), note_->width() - px(28), px(26)),
           fromView(now_->form->code) + "   " + word(now_->form->title), lettering(17, true),
           t.text);
    const QString fault = faultText(field());
    double y = px(38);
    if (!fault.isEmpty()) {
        w.sign(QRectF(px(14), y + px(3), px(20), px(20)), Sign::Warning, t.bad);
        w.text(QRectF(px(42), y, note_->width() - px(56), px(26)), fault, lettering(15.5), t.bad);
        return;
    }
    if (const QString hint = hintText(field()); !hint.isEmpty()) {
        w.sign(QRectF(px(14), y + px(3), px(20), px(20)), Sign::Note, t.warn);
        w.text(QRectF(px(42), y, note_->width() - px(56), px(26)), hint, lettering(15.5), t.warn);
        return;
    }
    // As it will stand in the program.
    for (const forms::LineChange& change :
         forms::write_cycle(lines_, *before_, *now_, cursor_, dialect_)) {
        if (y + px(24) > note_->height()) break;
        w.data(QRectF(px(14), y, note_->width() - px(28), px(24)),
               QString::fromStdString(change.text), lettering(16, false, Face::Program), t.accent);
        y += px(25);
    }
    if (y < px(40))
        w.text(QRectF(px(14), y, note_->width() - px(28), px(26)),
               word("Nothing has been changed."), lettering(15), t.dim);
}

void CycleFormPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), right = px(440), foot = px(98), pad = px(350);
    if (upright(*this)) {
        const int below = now_ ? pad : px(300), y = height() - foot - below - 2 * edge,
                  beside = width() - 2 * edge - px(346) - edge;
        table_->setGeometry(edge, 0, width() - 2 * edge, y - edge);
        picture_->setGeometry(edge, y, now_ ? beside : width() - 2 * edge, below);
        pad_->setGeometry(width() - px(346) - edge, y, px(346), pad);
        note_->setGeometry(edge, height() - foot - edge, width() - 2 * edge, foot);
        return pad_->setVisible(now_.has_value());
    }
    table_->setGeometry(edge, 0, width() - right - 3 * edge, height() - foot - edge);
    note_->setGeometry(edge, height() - foot - edge, width() - right - 3 * edge, foot);
    const int left = width() - right - edge;
    picture_->setGeometry(left, 0, right, now_ ? height() - pad - 2 * edge : px(300));
    pad_->setGeometry(left, height() - pad - edge, right, pad);
    pad_->setVisible(now_.has_value());
}

std::vector<Sheet*> CycleFormPage::sheets() {
    return now_ ? std::vector<Sheet*>{table_, note_, pad_} : std::vector<Sheet*>{table_, note_};
}

void CycleFormPage::refresh() {
    for (Sheet* one : sheets()) one->refresh();
}

bool CycleFormPage::key(QKeyEvent* event) {
    if (now_ && pad_->key(event)) return true;
    if (event->key() == Qt::Key_Delete && now_) {
        erase();
        return true;
    }
    if (event->key() == Qt::Key_Escape) {
        if (onClose) onClose();
        return true;
    }
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && now_) {
        table_->choose(std::min(table_->row() + 1, static_cast<int>(now_->values.size()) - 1));
        refresh();
        return true;
    }
    return table_->key(event);
}

void CycleFormPage::addKeys(std::vector<SoftKey>& keys) {
    const bool changed =
        now_ && !forms::write_cycle(lines_, *before_, *now_, cursor_, dialect_).empty();
    keys.push_back({word("Write into the program"), [this] { write(); }, Sign::Good,
                    changed && forms::is_good(faults_)});
    keys.push_back({word("Empty the field"), [this] { erase(); }, Sign::None,
                    field() >= 0 && now_->values[static_cast<std::size_t>(field())].set});
    keys.push_back({word("Another cycle"),
                    [this] {
                        showList();
                        if (context_.keysChanged) context_.keysChanged();
                    },
                    Sign::Overview, now_.has_value()});
    keys.push_back({word("Back to the text"),
                    [this] {
                        if (onClose) onClose();
                    },
                    Sign::Left, true});
}

}  // namespace polyturn::hmi
