#include "hmi/screens/machine/settings_page.hpp"

#include <QDateTime>

#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kSetter = 2;
int levelNumber(const QString& level) {
    return level == "maker" ? 3 : level == "setter" ? 2 : level == "operator" ? 1 : 0;
}

QString exampleOf(const ComputerSetting& setting) {
    return setting.what == ComputerSetting::What::Synchronised ? word("yes") + ", " + word("no")
                                                               : QString(setting.example);
}

}  // namespace

SettingsPage::SettingsPage(Context& context, QWidget* parent)
    : QWidget(parent), context_(context), table_(new Table(this)), note_(new FreeSheet(this)) {
    table_->columns = {
        {word("Number"), 0.8}, {word("Setting"), 2.4}, {word("Value"), 2.2}, {"", 4.4}};
    table_->rowUnits = 36;
    table_->rows = [] { return static_cast<int>(computerSettings().size()) + 1; };
    table_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        if (row == static_cast<int>(computerSettings().size())) {
            if (column == 0) return {"N5109", t.dim, Sign::None, false, Face::Condensed};
            if (column == 1) return {word("Language of the screens")};
            return column == 2
                       ? Table::Cell{nameOf(spoken()), t.text, Sign::DisplayLanguage, true}
                       : Table::Cell{word("F11, or the key at the top: the next one"), t.dim};
        }
        const ComputerSetting& one = computerSettings()[static_cast<std::size_t>(row)];
        const QString why = computer_.whyNot(one.what);
        switch (column) {
            case 0:
                return {one.number, t.dim, Sign::None, false, Face::Condensed};
            case 1:
                return {word(one.title)};
            case 2: {
                const QString value = computer_.value(one.what);
                return {value.isEmpty() ? QString::fromUtf8("–") : value,
                        value.isEmpty() ? t.dim : t.text, Sign::None, true};
            }
            default:
                return {why.isEmpty() ? exampleOf(one) : why, why.isEmpty() ? t.faint : t.warn,
                        why.isEmpty() ? Sign::None : Sign::Lock};
        }
    };
    table_->onActivated = [this] { change(); };
    table_->onChosen = [this] { note_->refresh(); };
    note_->onCompose = [this](Writer& w) { composeNote(w); };
    note_->onTouched = [this](int) { change(); };
    computer_.changed = [this] {
        if (isVisible()) refresh();
    };
}

void SettingsPage::begin() {
    told_.clear();
    lookAt_ = 0;
    computer_.read();
}

const ComputerSetting* SettingsPage::chosen() const {
    const int row = table_->row();
    return row >= 0 && row < static_cast<int>(computerSettings().size())
               ? &computerSettings()[static_cast<std::size_t>(row)]
               : nullptr;
}

void SettingsPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), foot = px(64);
    const bool stands = upright(*this);  // what is said of a value wants the room there
    table_->columns = {{word("Number"), 0.8},
                       {word("Setting"), 2.4},
                       {word("Value"), stands ? 1.4 : 2.2},
                       {"", stands ? 5.4 : 4.4}};
    table_->setGeometry(edge, 0, width() - 2 * edge, height() - foot - 2 * edge);
    note_->setGeometry(edge, height() - foot - edge, width() - 2 * edge, foot);
}

void SettingsPage::refresh() {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (context_.live.connected() && now > lookAt_) {
        lookAt_ = now + 3'000;
        context_.requests.ask(
            {{"do", "who"}},
            [this](const Answer& answer) {
                if (answer.ok) level_ = levelNumber(answer.object.value("level").toString());
            },
            true);
    }
    for (Sheet* one : sheets()) one->refresh();
}

void SettingsPage::composeNote(Writer& w) {
    const Theme& t = theme();
    const double wide = note_->width(), high = note_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const ComputerSetting* one = chosen();
    w.sign(QRectF(px(14), high / 2 - px(10), px(20), px(20)),
           told_.isEmpty() ? Sign::Note
           : good_         ? Sign::Good
                           : Sign::Alarm,
           told_.isEmpty() ? t.dim
           : good_         ? t.good
                           : t.bad);
    Item& item = w.text(
        QRectF(px(44), px(4), wide * 0.62, high - px(8)),
        told_.isEmpty()
            ? word("The operating system keeps these values and says who may change them; Enter,"
                   " or a second touch, changes one.")
            : told_,
        lettering(15), t.text);
    item.wraps = true;
    item.data = !told_.isEmpty();
    if (one)
        w.field(QRectF(wide * 0.7, px(9), wide * 0.3 - px(10), high - px(18)),
                computer_.value(one->what), exampleOf(*one), false, 1);
}

void SettingsPage::change() {
    const ComputerSetting* one = chosen();
    if (!one) return;
    const auto tell = [this](bool good, const QString& text) {
        good_ = good;
        told_ = text;
        context_.tell(text, good ? Told::Good : Told::Refused);
        refresh();
    };
    const QString title = word(one->title);
    context_.ask({title,
                  computer_.value(one->what),
                  {},
                  [this, tell, title, what = one->what](const QString& text) {
                      if (const QString why = computer_.whyNot(what); !why.isEmpty())
                          return tell(false, title + ": " + why);
                      if (context_.live.connected() && level_ < kSetter)
                          return tell(false, word("This needs the level of a setter: log in"));
                      if (text == computer_.value(what)) return;
                      computer_.write(what, text, [tell, title, text](bool ok, const QString& why) {
                          tell(ok, ok ? QString("%1: %2").arg(title, text)
                                      : word("%1 was refused: %2").arg(title, why));
                      });
                  }});
}

void SettingsPage::addKeys(std::vector<SoftKey>& keys) {
    keys.push_back({word("Change"), [this] { change(); }, Sign::None,
                    chosen() && computer_.whyNot(chosen()->what).isEmpty()});
    keys.push_back(
        {word("Refresh"), [this] { begin(); }, computer_.busy() ? Sign::Wait : Sign::None});
}

}  // namespace polyturn::hmi
