#include "hmi/screens/machine/system.hpp"

#include <QDateTime>
#include <QDir>
#include <QJsonObject>
#include <QKeyEvent>
#include <QStandardPaths>
#include <algorithm>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/portrait.hpp"
#include "ipc/diagnosis/details.hpp"

namespace polyturn::hmi {
namespace {

constexpr const char* kLevels[] = {"operator", "setter", "maker"};
enum FormHit { kNameHit = 1, kPasswordHit };

}  // namespace

System::System(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      form_(new FreeSheet(this)),
      notice_(new FreeSheet(this)),
      files_(new Table(this)),
      right_(new Table(this)),
      pad_(new TextPad(this)),
      settings_(new SettingsPage(context, this)) {
    setFocusPolicy(Qt::StrongFocus);
    head_->onCompose = [this](Writer& w) { composeHead(w); };
    form_->onCompose = [this](Writer& w) { composeForm(w); };
    notice_->onCompose = [this](Writer& w) { composeNotice(w); };
    form_->onTouched = [this](int number) {
        inPassword_ = number == kPasswordHit;
        form_->refresh();
    };
    pad_->onText = [this](const QString& text) { type(text); };
    pad_->onBackspace = [this] { backspace(); };
    pad_->onEnter = [this] { logIn(); };
    folder_ = QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation))
                  .filePath("polyturn-backups");
    showPage(Page::Backups);
}

void System::restore(const QString& state) {
    const int bar = static_cast<int>(state.indexOf('|'));
    if (bar < 0) return;
    if (state.mid(bar + 1).startsWith('/')) folder_ = state.mid(bar + 1);
    showPage(static_cast<Page>(
        std::clamp(state.left(bar).toInt(), 0, static_cast<int>(Page::Settings))));
}

QString System::levelWord(const QString& level) const {
    return level == "maker"      ? word("maker")
           : level == "setter"   ? word("setter")
           : level == "operator" ? word("operator")
                                 : word("nobody");
}

std::vector<Sheet*> System::sheets() {
    if (page_ == Page::Backups)
        return loss_.unfit ? std::vector<Sheet*>{head_, notice_, files_, right_}
                           : std::vector<Sheet*>{head_, files_, right_};
    if (page_ == Page::Settings) {
        std::vector<Sheet*> out = settings_->sheets();
        out.push_back(head_);
        return out;
    }
    return {head_, files_, form_, pad_};
}

void System::showPage(Page page) {
    page_ = page;
    lookAt_ = 0;
    note_.clear();
    name_.clear();
    password_.clear();
    right_->setVisible(page == Page::Backups);
    form_->setVisible(page == Page::Users);
    pad_->setVisible(page == Page::Users);
    notice_->setVisible(page == Page::Backups && loss_.unfit);
    files_->setVisible(page != Page::Settings);
    settings_->setVisible(page == Page::Settings);
    if (page == Page::Settings)
        settings_->begin();
    else
        fill();
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

void System::fill() {
    files_->ofMachine = page_ == Page::Users;
    if (page_ == Page::Users) {
        files_->columns = {{word("User"), 2}, {word("Level"), 1.4}};
        sayWhyNoUsers();
        files_->rows = [this] { return static_cast<int>(users_.size()); };
        files_->cell = [this](int row, int column) -> Table::Cell {
            const User& one = users_[static_cast<std::size_t>(row)];
            if (column == 0)
                return {one.name, one.locked ? theme().bad : theme().text,
                        one.locked         ? Sign::Lock
                        : one.name == who_ ? Sign::Good
                                           : Sign::Key,
                        one.name == who_};
            return {levelWord(one.level), theme().dim};
        };
        files_->onChosen = [this] {
            if (files_->row() < static_cast<int>(users_.size())) {
                name_ = users_[static_cast<std::size_t>(files_->row())].name;
                inPassword_ = true;
            }
            form_->refresh();
        };
        files_->onActivated = [this] { logIn(); };
        return;
    }
    files_->columns = {{word("Backup"), 3}, {word("Size"), 0.9, kRight}};
    files_->nothing = word("There is no backup in this folder.");
    files_->rows = [this] { return static_cast<int>(entries_.size()); };
    files_->cell = [this](int row, int column) -> Table::Cell {
        const QFileInfo& one = entries_[static_cast<std::size_t>(row)];
        if (column == 1)
            return {one.isDir()
                        ? QString()
                        : QString("%1 %2").arg((one.size() + 1023) / 1024).arg(unitWord("kB")),
                    theme().dim};
        if (row == 0 && isAbove(one, folder_)) return {word("Up"), theme().accent, Sign::Up};
        return {one.isDir() ? one.fileName() + "/" : one.fileName(),
                one.isDir() ? theme().dim : theme().text,
                one.isDir() ? Sign::None : Sign::Programs};
    };
    files_->onChosen = [this] {
        if (previewOf_ != chosenFile()) {
            preview_ = {};
            previewOf_.clear();
            note_.clear();
        }
    };
    files_->onActivated = [this] { open(); };
    right_->columns = {
        {word("What would change"), 3}, {word("Now"), 1.3, kRight}, {word("Then"), 1.3, kRight}};
    right_->rowUnits = 30;
    right_->nothing = word(
        "Choose a backup: «What would change» compares it with the machine, and nothing is changed yet.");
    right_->rows = [this] { return static_cast<int>(preview_.size()); };
    right_->cell = [this](int row, int column) -> Table::Cell {
        const QJsonObject one = preview_.at(row).toObject();
        return {one.value(column == 0   ? "what"
                          : column == 1 ? "old"
                                        : "new")
                    .toString(),
                column == 2 ? theme().accent : theme().text, Sign::None, column == 2,
                Face::Condensed};
    };
    readFolder(folder_);
}

// Aside: the folder may lie on a network.
void System::readFolder(const QString& folder) {
    if (wanted_.isEmpty()) wanted_ = chosenFile();
    folder_ = QDir(folder).absolutePath();
    reading_.start([folder = folder_](const std::atomic<bool>&) {
        return folderInfos(folder, {"*.ptb"}, QDir::DirsFirst | QDir::Time);
    });
    takeFolder();
}

void System::takeFolder() {
    auto made = reading_.take();
    if (!made) return;
    entries_ = std::move(*made);
    const QString wanted = std::exchange(wanted_, QString());
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].absoluteFilePath() == wanted) return files_->choose(static_cast<int>(i));
    files_->choose(0);
}

QString System::chosenFile() const {
    if (page_ != Page::Backups || files_->row() >= static_cast<int>(entries_.size())) return {};
    const QFileInfo& one = entries_[static_cast<std::size_t>(files_->row())];
    return one.isDir() ? QString() : one.absoluteFilePath();
}

void System::open() {
    if (files_->row() >= static_cast<int>(entries_.size())) return;
    const QFileInfo one = entries_[static_cast<std::size_t>(files_->row())];
    if (one.isDir())
        readFolder(one.absoluteFilePath());
    else
        bringBack(true);
}

void System::save() {  // the store makes the folder: it may lie on a network
    const QString file =
        QDir(folder_).filePath(QString("%1-%2.ptb")
                                   .arg(QString::fromStdString(context_.live.instance()),
                                        QDateTime::currentDateTime().toString("yyyyMMdd-HHmmss")));
    context_.requests.store(
        {{"do", "backup.to"}, {"file", file}, {"with", QJsonArray{}}, {"make_folder", true}},
        [this, file](const Answer& answer) {
            if (!answer.ok) return;
            context_.tell(word("Saved: %1").arg(QFileInfo(file).fileName()), Told::Good);
            wanted_ = file;
            readFolder(folder_);
        });
}

// The same request with and without `preview`: what is shown is what will be done.
void System::bringBack(bool preview) {
    const QString file = chosenFile();
    if (file.isEmpty()) return;
    context_.requests.store(
        {{"do", "restore.from"}, {"file", file}, {"preview", preview}},
        [this, file, preview](const Answer& answer) {
            noteGood_ = answer.ok;
            if (!answer.ok) return void(note_ = answer.text);
            const int total = answer.object.value("total").toInt() +
                              static_cast<int>(answer.object.value("files").toArray().size());
            preview_ = preview ? answer.object.value("changes").toArray() : QJsonArray();
            for (const auto& one : answer.object.value("files").toArray())
                if (preview)
                    preview_.append(QJsonObject{{"what", one.toString()}, {"new", word("file")}});
            previewOf_ = preview ? file : QString();
            note_ = !preview ? word("Restored values and files: %1").arg(total)
                    : total  ? word("Values and files that would change: %1").arg(total)
                             : word("Nothing would change");
            if (!preview) context_.tell(note_, Told::Good);
            refresh();
            if (context_.keysChanged) context_.keysChanged();
        });
}

void System::look() {
    lookAt_ = QDateTime::currentMSecsSinceEpoch() + 2'000;
    context_.requests.ask(
        {{"do", "who"}},
        [this](const Answer& answer) {
            who_ = answer.object.value("name").toString();
            whoLevel_ = answer.object.value("level").toString();
        },
        true);
    context_.requests.store(
        {{"do", "users.list"}},
        [this](const Answer& answer) {
            users_.clear();
            usersHidden_ = !answer.ok;
            if (page_ == Page::Users) sayWhyNoUsers();
            for (const auto& one : answer.object.value("users").toArray())
                users_.push_back({one.toObject().value("name").toString(),
                                  one.toObject().value("level").toString(),
                                  one.toObject().value("locked").toBool()});
        },
        true);
}

// The list is refused to who has not logged in: there are users then, and not everybody may do
// everything.
void System::sayWhyNoUsers() {
    files_->nothing =
        usersHidden_
            ? word("Log in to see the users.")
            : word(
                  "There are no users: everybody may do everything. The first one must be a maker.");
}

void System::logIn() {
    if (name_.isEmpty()) return;
    const QString password = std::exchange(password_, QString());
    context_.requests.store({{"do", "users.login"}, {"name", name_}, {"password", password}},
                            [this](const Answer& answer) {
                                if (!answer.ok) return;
                                context_.requests.setToken(answer.object.value("token").toString());
                                context_.tell(word("%1 is logged in").arg(name_), Told::Good);
                                lookAt_ = 0;
                            });
    form_->refresh();
}

void System::type(const QString& text) {
    QString& to = inPassword_ ? password_ : name_;
    if (to.size() < 31) to += text;
    form_->refresh();
}

void System::backspace() {
    (inPassword_ ? password_ : name_).chop(1);
    form_->refresh();
}

void System::resizeEvent(QResizeEvent*) { layOut(); }

void System::layOut() {
    const int head = px(46), edge = px(8), half = static_cast<int>(width() * 0.42), pad = px(330);
    head_->setGeometry(0, 0, width(), head);
    const int loss = page_ == Page::Backups && loss_.unfit ? px(200) : 0, top = head + loss;
    notice_->setGeometry(edge, head, width() - 2 * edge, std::max(0, loss - edge));
    settings_->setGeometry(0, head, width(), height() - head);
    const Parted all = parted(*this, QRect(edge, top, width() - 2 * edge, height() - top - edge),
                              width() - half - 2 * edge, (height() - top) * 64 / 100, edge);
    files_->setGeometry(all.main);
    right_->setGeometry(all.side);
    form_->setGeometry(all.side.adjusted(0, 0, 0, -pad - edge));
    pad_->setGeometry(all.side.left(), all.side.bottom() + 1 - pad, all.side.width(), pad);
    for (Sheet* one : sheets()) one->refresh();
}

void System::composeHead(Writer& w) {
    const Theme& t = theme();
    w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
    w.text(QRectF(px(14), 0, px(210), head_->height()),
           page_ == Page::Backups ? word("Backups")
           : page_ == Page::Users ? word("Users")
                                  : word("Panel computer"),
           lettering(20, true), t.text);
    if (page_ == Page::Backups) {
        w.data(QRectF(px(224), 0, head_->width() * 0.42, head_->height()), folder_, lettering(14),
               t.dim);
        if (!note_.isEmpty())
            w.sign(QRectF(head_->width() * 0.66, px(12), px(22), px(22)),
                   noteGood_ ? Sign::Good : Sign::Alarm, noteGood_ ? t.good : t.bad);
        w.data(QRectF(head_->width() * 0.66 + px(30), 0, head_->width() * 0.34 - px(42),
                      head_->height()),
               note_, lettering(15, true), noteGood_ ? t.good : t.bad);
    } else if (page_ == Page::Users) {
        w.data(QRectF(head_->width() * 0.44, 0, head_->width() * 0.56 - px(14), head_->height()),
               who_.isEmpty()
                   ? word("Nobody is logged in. Without a login: %1").arg(levelWord(whoLevel_))
                   : word("Logged in: %1, %2").arg(who_, levelWord(whoLevel_)),
               lettering(15), t.accent, kRight);
    }
}

// Who has lost data comes here from the alarm: this is where they are brought back.
void System::showEvent(QShowEvent* event) {
    Screen::showEvent(event);
    if (page_ != Page::Backups && storeHasLost(context_.live)) showPage(Page::Backups);
}

void System::lookAtStore() {
    lookAt_ = QDateTime::currentMSecsSinceEpoch() + 2'000;
    context_.requests.ask(
        {{"do", "who"}},
        [this](const Answer& answer) {
            who_ = answer.object.value("name").toString();
            whoLevel_ = answer.object.value("level").toString();
        },
        true);
    context_.requests.store(
        {{"do", "store.state"}},
        [this](const Answer& answer) {
            const QJsonObject& told = answer.object;
            const bool was = loss_.unfit;
            loss_ = {answer.ok && told.value("unfit").toBool(), told.value("readable").toBool(true),
                     told.value("missing").toString(), told.value("backup").toString()};
            if (loss_.unfit != was && page_ == Page::Backups) {
                showPage(Page::Backups);
                refresh();
            }
        },
        true);
}

void System::confirmLoss() {
    context_.requests.store({{"do", "store.confirm"}}, [this](const Answer& answer) {
        if (answer.ok)
            context_.tell(word("Confirmed: production goes on with what is left"), Told::Good);
        lookAt_ = 0;
    });
}

// What is gone, and the two ways on.
void System::composeNotice(Writer& w) {
    const Theme& t = theme();
    const double wide = notice_->width(), high = notice_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    if (!loss_.unfit) return;
    w.frame(QRectF(0, 0, wide, high), t.bad, px(8), px(2));
    w.sign(QRectF(px(14), px(10), px(26), px(26)), Sign::Alarm, t.bad);
    w.text(QRectF(px(50), px(8), wide - px(64), px(30)),
           word("The machine has lost data: no program starts"), lettering(18, true), t.bad);
    double y = px(42);
    const auto line = [&](const QString& told, double tall, const QColor& colour,
                          bool name = false) {
        Item& item = w.text(QRectF(px(50), y, wide - px(64), tall), told, lettering(15), colour,
                            Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        item.data = name;
        y += tall;
    };
    line(word("Lost: %1")
             .arg(QString::fromStdString(detail_in(loss_.missing.toStdString(), spoken()))),
         px(24), t.text, true);
    line(loss_.backup.isEmpty()
             ? word("There is no backup beside the store: choose one from a stick or the network.")
             : word("The newest backup: %1").arg(loss_.backup),
         px(24), t.text, true);
    line(loss_.readable
             ? word("«Restore» brings everything back as it was then. «Confirm the loss» keeps "
                    "what is left: the newest changes of parameters, offsets, zeros, tools, "
                    "lives and users are gone for good. Look through them before the first part.")
             : word("«Restore» brings everything back as it was then. The file cannot be read "
                    "whole: «Confirm the loss» may leave parameters, offsets, zeros, tools and "
                    "users as on the first day. Look through them before the first part."),
         px(64), t.text);
    if (whoLevel_ != "maker")
        line(word("Only a maker can confirm: log in on the page «Users»."), px(24), t.warn);
}

void System::composeForm(Writer& w) {
    const Theme& t = theme();
    const double wide = form_->width();
    w.fill(QRectF(0, 0, wide, form_->height()), t.window);
    w.fill(QRectF(0, 0, wide, form_->height()), t.card, px(8));
    const auto field = [&](double y, const QString& title, const QString& text, bool here,
                           int hit) {
        w.text(QRectF(px(16), y, wide * 0.3, px(44)), title, lettering(16), t.dim);
        const QRectF box(wide * 0.32, y, wide * 0.68 - px(16), px(44));
        w.field(box, text, QString(), here, hit);
    };
    field(px(16), word("User"), name_, !inPassword_, kNameHit);
    field(px(70), word("Password"), QString(password_.size(), QChar(0x2022)), inPassword_,
          kPasswordHit);
    Item& item =
        w.text(QRectF(px(16), px(124), wide - px(32), px(70)),
               word("Enter logs in. A new user gets this name, this password and the level %1.")
                   .arg(levelWord(kLevels[newLevel_])),
               lettering(15), t.dim, Qt::AlignLeft | Qt::AlignTop);
    item.wraps = true;
}

void System::refresh() {
    if (page_ == Page::Users && context_.live.connected() &&
        QDateTime::currentMSecsSinceEpoch() > lookAt_)
        look();
    if (page_ == Page::Backups) {
        takeFolder();
        if (context_.live.connected() && (storeHasLost(context_.live) || loss_.unfit) &&
            QDateTime::currentMSecsSinceEpoch() > lookAt_)
            lookAtStore();
    }
    if (page_ == Page::Settings) settings_->refresh();
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<SoftKey> System::keys() {
    const bool there = context_.live.connected();
    std::vector<SoftKey> keys{
        {word("Backups"), [this] { showPage(Page::Backups); }, Sign::None, true,
         page_ == Page::Backups},
        {word("Users"), [this] { showPage(Page::Users); }, Sign::None, true, page_ == Page::Users},
        {word("Panel computer"), [this] { showPage(Page::Settings); }, Sign::None, true,
         page_ == Page::Settings}};
    if (page_ == Page::Settings) {
        settings_->addKeys(keys);
        return keys;
    }
    if (page_ == Page::Backups) {
        const bool file = !chosenFile().isEmpty();
        keys.push_back({word("Save now"), [this] { save(); }, Sign::Good, there});
        keys.push_back({word("Open folder"), [this] { open(); }, Sign::Right,
                        !file && files_->row() < static_cast<int>(entries_.size())});
        keys.push_back(
            {word("What would change"), [this] { bringBack(true); }, Sign::None, there && file});
        keys.push_back({word("Restore"),
                        [this] { bringBack(false); },
                        Sign::Left,
                        there && file && previewOf_ == chosenFile(),
                        false,
                        true,
                        word("Everything becomes as then: press again"),
                        {},
                        chosenFile(),
                        chosenFile().section('/', -1)});
        if (loss_.unfit)
            keys.push_back({word("Confirm the loss"),
                            [this] { confirmLoss(); },
                            Sign::Warning,
                            there && whoLevel_ == "maker",
                            false,
                            true,
                            word("What is lost stays lost: press again"),
                            {},
                            loss_.missing});
        return keys;
    }
    const bool named = there && !name_.isEmpty();
    const QString name = name_;
    const auto told = [this](const Answer& answer) {
        if (answer.ok) {
            context_.tell(word("Written"), Told::Good);
            password_.clear();
            lookAt_ = 0;
        }
    };
    keys.push_back({word("Log in"), [this] { logIn(); }, Sign::Good, named});
    keys.push_back({word("Log out"),
                    [this] {
                        context_.requests.ask({{"do", "logout"}}, [this](const Answer&) {
                            context_.requests.setToken({});
                            lookAt_ = 0;
                        });
                    },
                    Sign::None, there});
    keys.push_back({word("New user"),
                    [this, name, told] {
                        context_.requests.store({{"do", "users.add"},
                                                 {"name", name},
                                                 {"level", kLevels[newLevel_]},
                                                 {"password", password_}},
                                                told);
                    },
                    Sign::None, named && !password_.isEmpty()});
    keys.push_back({word("Other level"),
                    [this] {
                        newLevel_ = (newLevel_ + 1) % 3;
                        refresh();
                    },
                    Sign::None, true});
    keys.push_back({word("Give this level"),
                    [this, name, told] {
                        context_.requests.store(
                            {{"do", "users.level"}, {"name", name}, {"level", kLevels[newLevel_]}},
                            told);
                    },
                    Sign::None, named});
    keys.push_back({word("Delete user"),
                    [this, name, told] {
                        context_.requests.store({{"do", "users.delete"}, {"name", name}}, told);
                    },
                    Sign::Bin,
                    named,
                    false,
                    true,
                    word("It is gone: press again"),
                    {},
                    name,
                    name});
    return keys;
}

bool System::key(QKeyEvent* event) {
    if (page_ == Page::Settings) return settings_->key(event);
    if (page_ == Page::Backups) {
        if (event->key() == Qt::Key_Backspace && !entries_.empty()) {
            files_->choose(0);
            open();
            return true;
        }
        return files_->key(event);
    }
    if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab) {
        inPassword_ = !inPassword_;
        form_->refresh();
        return true;
    }
    if (event->key() == Qt::Key_Backspace) {
        backspace();
        return true;
    }
    if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
        if (inPassword_ || name_.isEmpty())
            logIn();
        else
            void(inPassword_ = true);
        form_->refresh();
        return true;
    }
    if (const QString text = event->text();
        text.size() == 1 && text[0].isPrint() &&
        !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
        type(text);
        return true;
    }
    return files_->key(event);
}

}  // namespace polyturn::hmi
