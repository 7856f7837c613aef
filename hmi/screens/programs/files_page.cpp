#include "hmi/screens/programs/files_page.hpp"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QKeyEvent>
#include <QRegularExpression>
#include <algorithm>
#include <utility>

#include "hmi/machine/programs/ordinary_file.hpp"
#include "hmi/text/dates.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/set_words.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kPreviewBytes = 1 << 16;

QString mounts() {
    QFile file("/proc/self/mounts");
    return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

constexpr int kNobody = 4;          // above every level
constexpr qint64 kWatchMs = 2'000;  // the folder that is shown is looked at again

// F3202 NE8 and NE9 (fanuc_lathe 8): programs O8000 to O8999, O9000 to O9999 are neither shown nor
// changed, whoever works here.
bool keptByParameter(const params::Table& table, const std::vector<unsigned>& channels,
                     const QString& name) {
    static const QRegularExpression kNumber("^[Oo]?0*([89])\\d{3}(?!\\d)");
    const auto number = kNumber.match(name);
    if (!number.hasMatch()) return false;
    const unsigned bit = number.captured(1) == "8" ? 0 : 4;
    return std::any_of(channels.begin(), channels.end(), [&](unsigned channel) {
        return params::bit(table, params::f3202, channel, bit);
    });
}

int levelNumber(const QString& level) {
    return level == "maker" ? 3 : level == "setter" ? 2 : level == "operator" ? 1 : 0;
}

}  // namespace

FilesPage::FilesPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      files_(new Table(this)),
      view_(new FreeSheet(this)),
      state_(new FreeSheet(this)),
      pad_(new TextPad(this)) {
    nameColumns();
    files_->rowUnits = 40;
    files_->textUnits = 16;
    files_->ofMachine = false;
    files_->rows = [this] {
        return static_cast<int>(placesShown_ ? places_.size() : entries_.size());
    };
    files_->cell = [this](int row, int column) -> Table::Cell {
        const Theme& t = theme();
        if (placesShown_) {
            const Place& place = places_[static_cast<std::size_t>(row)];
            if (column == 0) return {place.name, t.accent, Sign::Right, true};
            return column == 1 ? Table::Cell{place.kind == Place::Kind::Network ? word("Network")
                                             : place.kind == Place::Kind::Removable ? word("USB")
                                                                                    : word("Place"),
                                             t.dim}
                               : Table::Cell{};
        }
        const FileEntry& one = entries_[static_cast<std::size_t>(row)];
        if (column == 0) {
            const bool closed = one.readOnly || one.level > 0;
            return {one.up    ? word("Up")
                    : one.job ? one.name.chopped(9)
                              : one.name,
                    one.folder ? t.accent
                    : one.job  ? t.text
                               : t.dim,
                    one.up       ? Sign::Up
                    : closed     ? Sign::Lock
                    : one.folder ? Sign::Right
                    : one.job    ? Sign::Overview
                                 : Sign::Programs,
                    one.job};
        }
        if (one.up || (one.folder && column == 2)) return {};
        if (column == 1) return {momentText(one.changed, "HH:mm"), t.dim};
        return {QString("%1 %2").arg((one.size + 1023) / 1024).arg(unitWord("kB")), t.dim};
    };
    files_->onChosen = [this] { look(); };
    files_->onActivated = [this] { open(); };
    view_->onCompose = [this](Writer& w) { composePreview(w); };
    view_->onTouched = [this](int) { turnSheet(); };
    state_->onCompose = [this](Writer& w) { composeState(w); };
    pad_->onText = [this](const QString& text) {
        if (name_.size() < 120) {
            name_ += text;
            state_->refresh();
        }
    };
    pad_->onBackspace = [this] {
        name_.chop(1);
        state_->refresh();
    };
    pad_->onEnter = [this] { named(); };
    pad_->enterText = word("OK");
    pad_->national = true;
    pad_->hide();
}

const FileEntry* FilesPage::chosen() const {
    const int row = files_->row();
    return !placesShown_ && row >= 0 && row < static_cast<int>(entries_.size())
               ? &entries_[static_cast<std::size_t>(row)]
               : nullptr;
}

QString FilesPage::chosenPath() const {
    return chosen() ? QDir::cleanPath(context_.folder + "/" + chosen()->name) : QString();
}
QString FilesPage::where() const { return placesShown_ ? word("Places") : context_.folder; }

QString FilesPage::whyNotChanged() const {
    const FileEntry* one = chosen();
    if (!one || (!one->readOnly && one->level <= level_)) return {};
    if (one->level == kNobody) return word("%1 is protected by F3202").arg(one->name);
    return one->level > level_
               ? word("%1 is protected: a login of a higher level may change it").arg(one->name)
               : word("%1 is read-only").arg(one->name);
}

void FilesPage::readFolder(const QString& folder, const QString& choose) {
    placesShown_ = false;
    nameColumns();
    choose_ = choose;
    const bool other = QDir(folder).absolutePath() != context_.folder;
    context_.folder = QDir(folder).absolutePath();
    if (other) {
        entries_.clear();
        preview_ = {};
    }
    reader_.start(
        [folder = context_.folder](const std::atomic<bool>&) { return listFolder(folder); });
    take();
}

namespace {

bool sameOnDisk(const FileEntry& a, const FileEntry& b) {
    return a.name == b.name && a.folder == b.folder && a.readOnly == b.readOnly &&
           a.size == b.size && a.changed == b.changed;
}

}  // namespace

void FilesPage::watch() {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (auto list = watcher_.take();
        list && !placesShown_ && !reader_.busy() && list->folder == context_.folder &&
        !(list->readable == readable_ &&
          std::equal(entries_.begin(), entries_.end(), list->entries.begin(), list->entries.end(),
                     sameOnDisk))) {
        choose_ = chosen() ? chosen()->name : QString();
        // With another content the text beside the list is an old one; what a job shows is of its
        // other files too.
        const FileEntry* before = chosen();
        const bool kept =
            before && !before->job &&
            std::any_of(list->entries.begin(), list->entries.end(),
                        [&](const FileEntry& one) { return sameOnDisk(one, *before); });
        fill(std::move(*list), kept);
    }
    if (!isVisible()) {
        watchAt_ = 0;
        return;
    }
    if (placesShown_ || reader_.busy() || watcher_.busy() || now < watchAt_) return;
    watchAt_ = now + kWatchMs;
    watcher_.start(
        [folder = context_.folder](const std::atomic<bool>&) { return listFolder(folder); }, 0);
}

void FilesPage::fill(FolderList list, bool previewStays) {
    entries_ = std::move(list.entries);
    readable_ = list.readable;
    for (FileEntry& one : entries_)
        if (!one.folder &&
            keptByParameter(context_.live.table(), context_.live.channels(), one.name))
            one.level = kNobody;
    int row = 0;
    bool found = false;
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].name == choose_) {
            row = static_cast<int>(i);
            found = true;
        }
    if (!found && choose_.isEmpty())  // the first job is what a folder is opened for
        for (std::size_t i = entries_.size(); i-- > 0;)
            if (entries_[i].job) row = static_cast<int>(i);
    if (!previewStays) preview_ = {};
    files_->choose(row);
    look();
}

void FilesPage::take() {
    watch();
    if (auto list = reader_.take()) fill(std::move(*list), false);
    if (auto preview = looker_.take(); preview && preview->path == chosenPath()) {
        preview_ = std::move(*preview);
        if (context_.keysChanged) context_.keysChanged();
    }
    if (auto done = worker_.take()) {
        outcome_ = std::move(*done);
        told_ = true;
        const QString what =
            outcome_.kind == FileOutcome::Kind::Stopped ? word("Stopped: %1").arg(outcome_.what)
            : outcome_.kind == FileOutcome::Kind::Differs
                ? word("The copy of %1 was not what had been sent; what was there before stands")
                      .arg(outcome_.what)
            : outcome_.ok() ? doing_ + ": " + outcome_.what
                            : word("Not done: %1").arg(outcome_.told());
        context_.tell(what, outcome_.ok() ? Told::Good : Told::Refused);
        readFolder(context_.folder, outcome_.ok() && !placesShown_ ? outcome_.what
                                    : chosen()                     ? chosen()->name
                                                                   : QString());
        if (const QString path = std::exchange(created_, QString());
            !path.isEmpty() && outcome_.ok() && onCreated)
            onCreated(path);
        if (context_.keysChanged) context_.keysChanged();
    }
}

void FilesPage::nameColumns() {
    if (placesShown_)
        files_->columns = {{word("Name"), 5}, {word("Kind"), 2.2}, {QString(), 1.2, kRight}};
    else
        files_->columns = {{word("Name"), 5}, {word("Changed"), 2.2}, {word("Size"), 1.2, kRight}};
}

void FilesPage::showPlaces() {
    placesShown_ = true;
    nameColumns();
    places_ = places(mounts(), placeFiles());
    places_.insert(places_.begin(),
                   {word("Own folder"), QDir::homePath(), Place::Kind::Configured});
    preview_ = {};
    files_->choose(0);
    refresh();
}

void FilesPage::open() {
    const int row = files_->row();
    if (placesShown_) {
        if (row < static_cast<int>(places_.size()))
            readFolder(places_[static_cast<std::size_t>(row)].path);
        return;
    }
    const FileEntry* one = chosen();
    if (!one || !one->folder) return;
    const QString left = QDir(context_.folder).dirName();
    if (one->up)
        readFolder(QDir::cleanPath(context_.folder + "/.."), left);
    else
        readFolder(chosenPath());
}

FilesPage::Preview FilesPage::readPreview(const QString& path, bool job,
                                          DisplayLanguage display_language,
                                          const std::string& machine) {
    Preview out;
    out.path = path;
    if (job) {
        auto sheet = std::make_shared<JobSheet>(readJobSheet(path, machine, display_language));
        if (!sheet->fault.isEmpty()) {
            out.fault = sheet->fault;
            return out;
        }
        for (const auto& [channel, program] : sheet->job.programs)
            out.there.push_back(QFileInfo::exists(QString::fromStdString(program.file)));
        out.sheet = std::move(sheet);
        return out;
    }
    QFile file;
    out.readable = openOrdinary(file, path);
    const QByteArray bytes = out.readable ? file.read(kPreviewBytes) : QByteArray();
    out.readable &= !bytes.contains('\0');
    if (out.readable) out.lines = QString::fromUtf8(bytes).split('\n');
    return out;
}

void FilesPage::look() {
    const FileEntry* one = chosen();
    const QString path = chosenPath();
    if (preview_.path == path && !path.isEmpty()) return;
    preview_ = {};
    sheetPage_ = 0;
    if (!one || one->folder) return looker_.forget();
    looker_.start([path, job = one->job, display_language = spoken(),
                   machine = context_.live.machineFolder()](const std::atomic<bool>&) {
        return readPreview(path, job, display_language, machine);
    });
    take();
}

void FilesPage::resizeEvent(QResizeEvent*) { layOut(); }

void FilesPage::layOut() {
    const int edge = px(8), half = static_cast<int>(width() * 0.5), foot = px(52),
              letters = px(300);
    const Parted all = parted(*this, rect().adjusted(edge, 0, -edge, -edge), width() - half - edge,
                              height() * 56 / 100, edge);
    files_->setGeometry(all.main);
    const bool naming = naming_ != Naming::None, state = menu_ || naming;
    pad_->setVisible(naming);
    state_->setVisible(state);
    const int below = (state ? foot + edge : 0) + (naming ? letters + edge : 0);
    view_->setGeometry(all.side.adjusted(0, 0, 0, -below));
    state_->setGeometry(all.side.left(), height() - edge - below + edge, all.side.width(), foot);
    pad_->setGeometry(all.side.left(), height() - edge - letters, all.side.width(), letters);
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<Sheet*> FilesPage::sheets() {
    std::vector<Sheet*> out{files_, view_};
    if (menu_ || naming_ != Naming::None) out.push_back(state_);
    if (naming_ != Naming::None) out.push_back(pad_);
    return out;
}

void FilesPage::refresh() {
    take();
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
    files_->nothing = placesShown_     ? QString()
                      : reader_.busy() ? word("The folder is being read ...")
                      : readable_      ? word("This folder is empty.")
                                       : word("This folder cannot be read.");
    for (Sheet* one : sheets()) one->refresh();
}

void FilesPage::composePreview(Writer& w) {
    const Theme& t = theme();
    const double wide = view_->width(), high = view_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const FileEntry* one = chosen();
    if (placesShown_) {
        const int row = files_->row();
        w.data(QRectF(px(20), px(20), wide - px(40), px(30)),
               row < static_cast<int>(places_.size()) ? places_[static_cast<std::size_t>(row)].path
                                                      : QString(),
               lettering(16), t.text);
        Item& item = w.text(
            QRectF(px(20), px(60), wide - px(40), px(130)),
            word("USB sticks and network places appear when they are there. «Keep as place» "
                 "adds the folder that is shown; /etc/polyturn/places names those of the shop: "
                 "NAME=/FOLDER."),
            lettering(15), t.dim, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        return;
    }
    if (one && one->level == kNobody) {
        w.data(QRectF(px(20), px(20), wide - px(40), px(30)), whyNotChanged(), lettering(16), t.dim,
               Qt::AlignCenter);
        return;
    }
    if (!one || one->folder) {
        w.text(QRectF(px(20), px(20), wide - px(40), px(30)), word("Choose a job or a program"),
               lettering(16), t.dim, Qt::AlignCenter);
        return;
    }
    double y = px(12);
    if (looker_.busy()) {
        w.text(QRectF(px(16), y, wide - px(32), px(26)), word("The file is being read ..."),
               lettering(15), t.dim);
        return;
    }
    if (!preview_.fault.isEmpty()) {
        w.sign(QRectF(px(16), y + px(4), px(22), px(22)), Sign::Alarm, t.bad);
        Item& item = w.text(QRectF(px(48), y, wide - px(60), px(90)), preview_.fault, lettering(16),
                            t.text, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        item.data = true;
        return;
    }
    if (one->readOnly || one->level > 0) {
        w.sign(QRectF(wide - px(38), y + px(4), px(22), px(22)), Sign::Lock, t.warn);
        w.text(QRectF(wide * 0.5, y, wide * 0.5 - px(46), px(28)),
               one->level == 3   ? word("only makers")
               : one->level == 2 ? word("only setters")
                                 : word("read-only"),
               lettering(14), t.warn, kRight);
    }
    if (preview_.sheet) return composeJob(w, y);
    w.data(QRectF(px(16), y, wide * 0.5 - px(20), px(28)), one->name, lettering(18, true), t.text);
    y += px(34);
    if (!preview_.readable) {
        w.text(QRectF(px(16), y, wide - px(32), px(26)), word("It cannot be shown."), lettering(15),
               t.dim);
        return;
    }
    for (int line = 0; line < preview_.lines.size() && y + px(20) < high; ++line, y += px(20)) {
        w.text(QRectF(px(8), y, px(40), px(20)), QString::number(line + 1), lettering(12), t.faint,
               kRight);
        w.data(QRectF(px(58), y, wide - px(70), px(20)), preview_.lines[line],
               lettering(13.5, false, Face::Program), t.text);
    }
}

// What a job is made of; wanted against mounted tools, against zeros and offsets that are entered.
std::vector<FilesPage::SheetLine> FilesPage::sheetLines(Writer& w) {
    const Theme& t = theme();
    const double wide = view_->width(), middle = wide * 0.55;
    const text::Job& job = preview_.sheet->job;
    std::vector<SheetLine> out;
    const auto headline = [&](const QString& text, const QString& wanted = {},
                              const QString& found = {}) {
        out.push_back(
            {px(30),
             [=, &w, &t](double y) {
                 w.text(QRectF(px(16), y + px(6), wide * 0.3, px(22)), text,
                        lettering(13, false, Face::Condensed), t.dim);
                 if (!wanted.isEmpty())
                     w.text(QRectF(wide * 0.3, y + px(6), wide * 0.23, px(22)), wanted,
                            lettering(13, false, Face::Condensed), t.dim, kRight);
                 if (!found.isEmpty())
                     w.text(QRectF(middle + px(28), y + px(6), wide - middle - px(44), px(22)),
                            found, lettering(13, false, Face::Condensed), t.dim);
             },
             true});
    };
    // One line: of whom, what is wanted, and beside a sign what is there.
    // All values of an offset on one line: narrower letters before some of it is left out.
    const auto fitting = [](const QString& words, double size, double room) {
        return wordsWidth(words, lettering(size)) <= room
                   ? lettering(size)
                   : lettering(size - 1.5, false, Face::Condensed);
    };
    const auto compared = [&](const QString& whose, const QString& what, const QString& wanted,
                              Sign sign, const QColor& colour, const QString& found, bool plain) {
        out.push_back(
            {px(26),
             [=, &w, &t](double y) {
                 w.text(QRectF(px(16), y, px(50), px(24)), whose, lettering(15, true), t.text);
                 const double room = wanted.isEmpty() ? middle - px(74) : wide * 0.3 - px(66),
                              rest = wide - middle - px(44);
                 w.data(QRectF(px(66), y, room, px(24)), what, fitting(what, 15, room), t.text);
                 if (!wanted.isEmpty())
                     w.data(QRectF(wide * 0.3, y, wide * 0.23, px(24)), wanted, lettering(15),
                            t.text, kRight);
                 w.sign(QRectF(middle, y + px(3), px(18), px(18)), sign, colour);
                 w.data(QRectF(middle + px(28), y, rest, px(24)), found, fitting(found, 14.5, rest),
                        plain ? t.dim : t.text);
             },
             false});
    };
    const auto judged = [&](bool same) {
        return std::pair(same ? Sign::Good : Sign::Warning, same ? t.good : t.warn);
    };
    headline(word("Programs"));
    std::size_t number = 0;
    for (const auto& [channel, program] : job.programs) {
        const bool lost = number < preview_.there.size() && !preview_.there[number];
        ++number;
        out.push_back(
            {px(28),
             [=, &w, &t, channel = channel, program = program](double y) {
                 w.text(QRectF(px(16), y, px(50), px(26)), QString("L%1").arg(channel),
                        lettering(17, true), t.accent);
                 w.data(QRectF(px(66), y, middle - px(74), px(26)),
                        QString::fromStdString(program.file).section('/', -1), lettering(17),
                        t.text);
                 if (lost) w.sign(QRectF(middle, y + px(3), px(20), px(20)), Sign::Alarm, t.bad);
                 if (lost)
                     w.text(QRectF(middle + px(28), y, wide * 0.3, px(26)), word("it is not there"),
                            lettering(14.5), t.text);
                 w.data(QRectF(wide * 0.8, y, wide * 0.2 - px(16), px(26)),
                        QString::fromStdString(program.language), lettering(14), t.dim, kRight);
             },
             false});
    }
    if (job.stock || job.parts_wanted)
        out.push_back(
            {px(62),
             [=, this, &w, &t, &job](double y) {
                 if (job.stock) {
                     const text::JobStock& stock = *job.stock;
                     const LengthUnit unit = context_.live.commonUnit();
                     const auto size = [&](double mm) {
                         return numberText(unit.of(mm), unit.inch() ? 4 : 3);
                     };
                     w.text(QRectF(px(16), y + px(6), middle - px(24), px(22)), word("Stock"),
                            lettering(13, false, Face::Condensed), t.dim);
                     w.text(
                         QRectF(px(16), y + px(30), middle + px(4), px(26)),
                         QString::fromUtf8("⌀ %1 × %2 %3")
                                 .arg(size(stock.diameter), size(stock.length), unit.name()) +
                             (stock.bore > 0 ? QString::fromUtf8("   %1 ⌀ %2 %3")
                                                   .arg(word("bore"), size(stock.bore), unit.name())
                                             : QString()) +
                             "   " + QString::fromStdString(stock.spindle),
                         lettering(17), t.text);
                 }
                 if (!job.parts_wanted) return;
                 w.text(QRectF(middle + px(28), y + px(6), wide - middle - px(44), px(22)),
                        word("Parts"), lettering(13, false, Face::Condensed), t.dim);
                 w.text(QRectF(middle + px(28), y + px(30), wide - middle - px(44), px(26)),
                        QString::number(job.parts_wanted), lettering(17), t.text);
             },
             false});
    if (preview_.sheet->otherMachine) {
        headline(word("Machine"));
        compared({}, QFileInfo(QString::fromStdString(job.machine)).fileName(), {}, Sign::Warning,
                 t.warn, word("not this one"), false);
    }
    if (const std::vector<SheetTool> tools = compareTools(context_.live, job); !tools.empty()) {
        headline(word("Required tools"), {}, word("Mounted"));
        for (const SheetTool& tool : tools) {
            const bool alike = tool.match == SheetTool::Match::Alike,
                       same = alike || tool.match == SheetTool::Match::Same,
                       unknown = tool.match == SheetTool::Match::Unknown;
            const bool usable = same && tool.state.sign != Sign::Alarm &&
                                tool.state.sign != Sign::Lock && tool.state.sign != Sign::Stop;
            compared(QString("L%1").arg(tool.channel),
                     QString("T%1   %2").arg(tool.station).arg(tool.wanted), {},
                     unknown  ? Sign::None
                     : usable ? (alike ? Sign::Note : Sign::Good)
                     : same   ? tool.state.sign
                              : Sign::Warning,
                     usable ? (alike ? t.dim : t.good)
                     : same ? t.bad
                            : t.warn,
                     same && !usable ? tool.state.text : matchText(tool), usable || unknown);
        }
    }
    if (const auto zeros = compareZeros(context_.live, *preview_.sheet); !zeros.empty()) {
        headline(word("Zeros"), word("Wanted"), word("Entered"));
        for (const JobZero& one : zeros) {
            const auto [sign, colour] = judged(one.same());
            compared(QString("L%1").arg(one.channel),
                     QString::fromStdString(one.system + "  " + one.axis),
                     zeroWanted(context_.live, one), sign, colour, zeroText(context_.live, one),
                     one.same());
        }
    }
    if (const auto offsets = compareOffsets(context_.live, *preview_.sheet); !offsets.empty()) {
        headline(word("Offsets"), {}, word("Entered"));
        for (const JobOffset& one : offsets)  // of another one only the values that are otherwise
            for (const OffsetPart part : {OffsetPart::Geometry, OffsetPart::Wear}) {
                const QString wanted =
                    offsetText(context_.live, one, OffsetSide::Wanted, part, one.same());
                if (wanted.isEmpty()) continue;
                const auto [sign, colour] = judged(one.same());
                const QString what =
                    part == OffsetPart::Wear
                        ? QString("%1 %2   %3").arg(one.number).arg(word("Wear"), wanted)
                        : QString("%1   %2").arg(one.number).arg(wanted);
                compared(QString("L%1").arg(one.channel), what, {}, sign, colour,
                         one.same()
                             ? word("entered")
                             : offsetText(context_.live, one, OffsetSide::Entered, part, false),
                         one.same());
            }
    }
    if (const auto edges = compareEdges(context_.live, *preview_.sheet); !edges.empty()) {
        headline(word("Tool edges"), {}, word("Entered"));
        for (const JobEdge& one : edges)
            for (const OffsetPart part : {OffsetPart::Geometry, OffsetPart::Wear}) {
                const QString wanted =
                    edgeText(context_.live, one, OffsetSide::Wanted, part, one.same());
                if (wanted.isEmpty()) continue;
                const auto [sign, colour] = judged(one.same());
                const QString name = edgeTitle(context_.live, one.line),
                              what = part == OffsetPart::Wear
                                         ? QString("%1 %2   %3").arg(name, word("Wear"), wanted)
                                         : QString("%1   %2").arg(name, wanted);
                compared(QString("L%1").arg(one.channel), what, {}, sign, colour,
                         one.same()
                             ? word("entered")
                             : edgeText(context_.live, one, OffsetSide::Entered, part, false),
                         one.same());
            }
    }
    if (const QString fault = preview_.sheet->setupFault; !fault.isEmpty())
        out.push_back({px(52),
                       [=, &w, &t](double y) {
                           w.sign(QRectF(px(16), y + px(8), px(18), px(18)), Sign::Warning, t.warn);
                           Item& item =
                               w.text(QRectF(px(44), y + px(6), wide - px(60), px(44)), fault,
                                      lettering(14.5), t.text, Qt::AlignLeft | Qt::AlignTop);
                           item.wraps = item.data = true;
                       },
                       false});
    return out;
}

// Where it is longer than the sheet is high, its last line turns the page.
void FilesPage::composeJob(Writer& w, double y) {
    const Theme& t = theme();
    const double wide = view_->width(), turn = px(34);
    w.data(QRectF(px(16), y, wide * 0.5 - px(20), px(34)),
           QString::fromStdString(preview_.sheet->job.name), lettering(24, true), t.text);
    y += px(36);
    const std::vector<SheetLine> lines = sheetLines(w);
    double all = 0;
    for (const SheetLine& one : lines) all += one.high;
    const double room = view_->height() - y - px(6);
    std::vector<std::size_t> begins{0};
    if (all > room)
        for (std::size_t i = 0, first = 0; i < lines.size(); first = begins.back()) {
            double used = 0;
            for (i = first; i < lines.size() && used + lines[i].high <= room - turn; ++i)
                used += lines[i].high;
            if (i == lines.size()) break;
            while (i > first + 1 && lines[i - 1].head) --i;
            begins.push_back(std::max(i, first + 1));
        }
    sheetPages_ = begins.size();
    sheetPage_ %= sheetPages_;
    const std::size_t end = sheetPage_ + 1 < sheetPages_ ? begins[sheetPage_ + 1] : lines.size();
    for (std::size_t i = begins[sheetPage_]; i < end; ++i) {
        lines[i].write(y);
        y += lines[i].high;
    }
    if (sheetPages_ == 1) return;
    const QRectF key(px(8), view_->height() - turn - px(4), wide - px(16), turn);
    w.fill(key, t.raised, px(6));
    w.sign(QRectF(key.left() + px(10), key.center().y() - px(9), px(18), px(18)), Sign::Right,
           t.accent);
    w.text(key.adjusted(px(38), 0, -px(70), 0),
           end < lines.size() ? word("Next page") : word("From the beginning"), lettering(15),
           t.text);
    w.text(key.adjusted(0, 0, -px(10), 0), QString("%1 / %2").arg(sheetPage_ + 1).arg(sheetPages_),
           lettering(15), t.dim, kRight);
    w.hit(key, 1);
}

void FilesPage::turnSheet() {
    if (preview_.sheet && sheetPages_ > 1) {
        sheetPage_ = (sheetPage_ + 1) % sheetPages_;
        view_->refresh();
    }
}

// What is being done, what has been taken, or the name that is entered.
void FilesPage::composeState(Writer& w) {
    const Theme& t = theme();
    const double wide = state_->width(), high = state_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    if (naming_ != Naming::None) {
        w.text(QRectF(px(14), 0, wide * 0.3, high),
               naming_ == Naming::Rename    ? word("New name")
               : naming_ == Naming::Program ? word("New program")
                                            : word("New folder"),
               lettering(14), t.dim);
        const QRectF box(wide * 0.3, px(6), wide * 0.7 - px(8), high - px(12));
        w.field(box, name_, QString(), true, 1);
        return;
    }
    const QString taken = taken_.section('/', -1);
    if (worker_.busy() && progress_) {
        const double all = static_cast<double>(progress_->all),
                     done = static_cast<double>(progress_->done);
        w.data(QRectF(px(14), 0, wide - px(120), high - px(12)), doing_ + ": " + taken,
               lettering(15, true), t.text);
        w.text(QRectF(wide - px(104), 0, px(90), high - px(12)),
               all > 0 ? QString("%1 %").arg(100 * done / all, 0, 'f', 0) : QString(),
               lettering(15, true), t.text, kRight);
        w.bar(QRectF(px(14), high - px(14), wide - px(28), px(8)), all > 0 ? done / all : 0,
              t.accent, t.window);
        return;
    }
    const bool good = outcome_.ok();
    if (told_)
        w.sign(QRectF(px(14), high / 2 - px(10), px(20), px(20)), good ? Sign::Good : Sign::Alarm,
               good ? t.good : t.bad);
    w.data(QRectF(px(44), 0, wide - px(58), high),
           told_ ? (good ? doing_ + ": " : QString()) + outcome_.told() +
                       (good && outcome_.files > 1 ? "  " + word("files: %1").arg(outcome_.files)
                                                   : QString())
           : taken_.isEmpty() ? word("«Mark» chooses what is copied or compared")
                              : word("Marked: %1").arg(taken),
           lettering(15), told_ && !good ? t.bad : t.text);
}

void FilesPage::start(const QString& what,
                      std::function<FileOutcome(const std::atomic<bool>&)> work) {
    if (worker_.busy()) return;
    doing_ = what;
    told_ = false;
    worker_.start(std::move(work), 0);
    if (context_.keysChanged) context_.keysChanged();
}

// In the folder that is shown; beside itself under another name.
QString FilesPage::target() const {
    const QString name = taken_.section('/', -1);
    if (taken_.section('/', 0, -2) != context_.folder) return context_.folder + "/" + name;
    const int dot = static_cast<int>(name.indexOf('.'));
    const QString stem = dot > 0 ? name.left(dot) : name,
                  rest = dot > 0 ? name.mid(dot) : QString();
    for (int number = 2;; ++number) {
        const QString other = QString("%1-%2%3").arg(stem).arg(number).arg(rest);
        if (std::none_of(entries_.begin(), entries_.end(),
                         [&](const FileEntry& one) { return one.name == other; }))
            return context_.folder + "/" + other;
    }
}

void FilesPage::put() {
    const QString to = target(), name = to.section('/', -1);
    for (const FileEntry& one : entries_)
        if (one.name == name && (one.readOnly || one.level > level_))
            return context_.tell(word("%1 is protected").arg(name), Told::Refused);
    progress_ = std::make_shared<FileProgress>();
    start(word("Copied and compared"),
          [from = taken_, to, progress = progress_](const std::atomic<bool>& stop) {
              return transfer(from, to, *progress, stop);
          });
}

// Free, read-only, for setters, for makers: as far as the own level reaches.
void FilesPage::protectNext() {
    const FileEntry* one = chosen();
    if (!one || one->up || one->folder) return;
    if (one->level > level_) return context_.tell(whyNotChanged(), Told::Refused);
    int step = one->level == 3 ? 3 : one->level == 2 ? 2 : one->readOnly ? 1 : 0;
    step = (step + 1) % 4;
    if (step > 1 && step > level_) step = 0;
    start(step == 0 ? word("Free") : word("Protected"),
          [path = chosenPath(), step](const std::atomic<bool>&) {
              return protect(path, step > 0, step > 1 ? step : 0);
          });
}

void FilesPage::name(Naming what) {
    naming_ = what;
    name_ = what == Naming::Rename && chosen() ? chosen()->name : QString();
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

void FilesPage::named() {
    const Naming what = naming_;
    const QString name = name_.trimmed();
    if (what == Naming::Program) return create(name);
    this->name(Naming::None);
    if (name.isEmpty()) return;
    if (what == Naming::Folder)
        return start(word("New folder"),
                     [path = context_.folder + "/" + name](const std::atomic<bool>&) {
                         return makeFolder(path);
                     });
    start(word("Renamed"),
          [path = chosenPath(), name](const std::atomic<bool>&) { return rename(path, name); });
}

void FilesPage::newProgram(const QString& language) {
    language_ = language;
    name(naming_ == Naming::Program ? Naming::None : Naming::Program);
}

// A name that is refused stays, to be mended. Without an ending it gets the one that its language
// has.
void FilesPage::create(const QString& typed) {
    if (typed.isEmpty()) return name(Naming::None);
    const bool sinumerik = language_ == "sinumerik";
    const QString file = typed.contains('.') ? typed : typed + (sinumerik ? ".MPF" : ".nc");
    if (!mayBeName(file))
        return context_.tell(word("%1 cannot be the name of a program").arg(typed), Told::Refused);
    if (keptByParameter(context_.live.table(), context_.live.channels(), file) && level_ < kNobody)
        return context_.tell(word("%1 is protected by F3202").arg(file), Told::Refused);
    for (const FileEntry& one : entries_)
        if (one.name.compare(file, Qt::CaseInsensitive) == 0)
            return context_.tell(word("%1 is there already").arg(one.name), Told::Refused);
    name(Naming::None);
    created_ = context_.folder + "/" + file;
    start(word("New program"), [path = created_, text = emptyProgram(file, language_)](
                                   const std::atomic<bool>&) { return makeProgram(path, text); });
}

void FilesPage::showMenu(bool on) {
    menu_ = on;
    naming_ = Naming::None;
    told_ = false;
    layOut();
    if (context_.keysChanged) context_.keysChanged();
}

void FilesPage::addMenuKeys(std::vector<SoftKey>& keys) {
    const FileEntry* one = chosen();
    const bool real = one && !one->up, free = !worker_.busy() && naming_ == Naming::None;
    const QString file = chosenPath().section('/', -1);
    keys.push_back({word("Back"),
                    [this] {
                        if (naming_ != Naming::None)
                            name(Naming::None);
                        else
                            showMenu(false);
                    },
                    Sign::Left});
    keys.push_back({word("Mark"),
                    [this] {
                        taken_ = chosenPath();
                        told_ = false;
                        refresh();
                    },
                    Sign::None, real && free, !taken_.isEmpty() && taken_ == chosenPath()});
    const QString to = taken_.isEmpty() || placesShown_ ? QString() : target(),
                  name = to.section('/', -1);
    const bool exists = std::any_of(entries_.begin(), entries_.end(),
                                    [&](const FileEntry& entry) { return entry.name == name; });
    keys.push_back({word("Copy to here"),
                    [this] { put(); },
                    Sign::Good,
                    free && !to.isEmpty(),
                    false,
                    exists,
                    exists ? word("Replaces the one that is here: press again") : QString(),
                    {},
                    QString("%1 %2").arg(taken_, to),
                    name});
    keys.push_back({word("Compare"),
                    [this] {
                        if (onCompare) onCompare(taken_, chosenPath());
                    },
                    Sign::None, free && isFile() && !taken_.isEmpty() && taken_ != chosenPath()});
    keys.push_back({word("Protect"), [this] { protectNext(); }, Sign::Lock, free && isFile(),
                    one && (one->readOnly || one->level > 0)});
    const bool open = real && !one->readOnly && one->level <= level_;
    keys.push_back({word("Rename"),
                    [this] { this->name(Naming::Rename); },
                    Sign::None,
                    free && open,
                    naming_ == Naming::Rename,
                    false,
                    word("Other files may name it: press again"),
                    {},
                    chosenPath(),
                    file});
    keys.push_back({word("New folder"), [this] { this->name(Naming::Folder); }, Sign::None,
                    free && !placesShown_, naming_ == Naming::Folder});
    keys.push_back({word("Delete"),
                    [this] {
                        start(word("Deleted"),
                              [path = chosenPath(), level = level_](const std::atomic<bool>& stop) {
                                  return removeAll(path, level, stop);
                              });
                    },
                    Sign::Bin,
                    free && open,
                    false,
                    true,
                    word("It is gone for good: press again"),
                    {},
                    chosenPath(),
                    file});
    if (placesShown_) {
        const int row = files_->row();
        const bool own = row > 0 && row < static_cast<int>(places_.size()) &&
                         places_[static_cast<std::size_t>(row)].kind == Place::Kind::Configured;
        keys.push_back({word("Forget place"),
                        [this, row] {
                            keepPlace(placeFiles().back(),
                                      places_[static_cast<std::size_t>(row)].name, {});
                            showPlaces();
                        },
                        Sign::None, own});
    } else {
        keys.push_back({word("Keep as place"), [this] {
                            if (keepPlace(placeFiles().back(), QDir(context_.folder).dirName(),
                                          context_.folder))
                                context_.tell(word("Kept: %1").arg(context_.folder), Told::Good);
                        }});
    }
    if (worker_.busy())
        keys.push_back({word("Stop"), [this] { worker_.stop(); }, Sign::Stop, true, false, true});
    else
        keys.push_back({word("Refresh"),
                        [this] {
                            if (placesShown_)
                                showPlaces();
                            else
                                readAgain();
                        },
                        Sign::None, free});
}

bool FilesPage::key(QKeyEvent* event) {
    if (naming_ != Naming::None) {
        const QString text = event->text();
        if (event->key() == Qt::Key_Escape)
            name(Naming::None);
        else if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter)
            named();
        else if (event->key() == Qt::Key_Backspace) {
            name_.chop(1);
            state_->refresh();
        } else if (text.size() == 1 && text[0].isPrint() &&
                   !(event->modifiers() & (Qt::ControlModifier | Qt::AltModifier))) {
            name_ += text;
            state_->refresh();
        }
        return true;
    }
    if (event->key() == Qt::Key_Escape && menu_) {
        showMenu(false);
        return true;
    }
    if (event->key() == Qt::Key_Right && preview_.sheet) {
        turnSheet();
        return true;
    }
    if (event->key() == Qt::Key_Backspace && !placesShown_ && !entries_.empty() &&
        entries_.front().up) {
        files_->choose(0);
        open();
        return true;
    }
    return files_->key(event);
}

}  // namespace polyturn::hmi
