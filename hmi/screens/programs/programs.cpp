#include "hmi/screens/programs/programs.hpp"

#include <QDateTime>
#include <QDir>
#include <QProcess>
#include <QTextBlock>
#include <QTimer>
#include <algorithm>
#include <cmath>
#include <utility>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/programs/code_help.hpp"
#include "hmi/machine/programs/setup_sheet.hpp"
#include "hmi/screens/overview/operation_keys.hpp"
#include "hmi/screens/programs/contour_page.hpp"
#include "hmi/screens/programs/cycle_form_page.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "ipc/model/files/job.hpp"
#include "ipc/model/files/machine_path.hpp"

namespace polyturn::hmi {
namespace {
constexpr int kPrinterTimeout_ms = 30'000;  // a print server that is away for longer is not there
}

Programs::Programs(Context& context)
    : Screen(context),
      head_(new FreeSheet(this)),
      view_(new FreeSheet(this)),
      files_(new FilesPage(context, this)),
      compare_(new ComparePage(context, this)),
      restart_(new RestartPage(context, this)),
      editor_(new EditorPage(context, this)) {
    setFocusPolicy(Qt::StrongFocus);
    files_->onCompare = [this](const QString& left, const QString& right) {
        compare_->compare(left, right);
        show(Page::Compare);
    };
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        const QString title = page_ == Page::Files      ? word("Programs and jobs")
                              : page_ == Page::Together ? word("Synchronised view")
                              : page_ == Page::Time     ? word("Timeline")
                              : page_ == Page::Restart  ? word("Restart in the middle")
                              : page_ == Page::Compare  ? word("Comparison")
                                                        : word("Editor");
        w.text(QRectF(px(14), 0, head_->width() * 0.4, head_->height()), title, lettering(20, true),
               t.text);
        w.data(QRectF(head_->width() * 0.42, 0, head_->width() * 0.58 - px(12), head_->height()),
               page_ == Page::Files                               ? files_->where()
               : page_ == Page::Restart || page_ == Page::Compare ? QString()
               : page_ == Page::Edit ? editor_->file() + (editor_->changed() ? " *" : "")
                                     : QFileInfo(dry_.job()).fileName(),
               lettering(15), t.dim, kRight);
    };
    files_->onCreated = [this](const QString& path) {
        // what is typed there stays: the new one is chosen in the list
        if (editor_->changed()) return;
        if (editor_->open(path, languageOf(path))) show(Page::Edit);
    };
    editor_->onNotOpened = [this] {
        if (page_ == Page::Edit) show(Page::Files);
    };
    view_->onScroll = [this](double pixels) {
        if (page_ != Page::Together) return;
        scrolled_ += pixels / px(kTogetherRow);
        const double rows = std::trunc(scrolled_);
        scrolled_ -= rows;
        scroll_ = std::max(0, scroll_ + static_cast<int>(rows));
        if (rows != 0) view_->refresh();
    };
    view_->onCompose = [this](Writer& w) {
        if (page_ == Page::Time)
            composeTime(w);
        else
            composeTogether(w);
    };
    // where what is selected lies: the running job is found without a search
    for (const unsigned channel : context_.live.channels())
        if (const auto& programs = context_.live.view(channel).programs;
            context_.folder.isEmpty() && !programs.empty() && !programs[0].empty())
            context_.folder = QFileInfo(QString::fromStdString(programs[0])).absolutePath();
    if (context_.folder.isEmpty()) context_.folder = QDir::currentPath();
    files_->readFolder(context_.folder);
}

// Page and what is chosen in the folder; of the editor its program, language, part and the cursor's
// place; what is compared.
QString Programs::state() const {
    const QString chosen = files_->chosenPath();
    // the line «Up» is a place in this folder, too
    const bool within = chosen.size() > context_.folder.size();
    QStringList out{QString::number(static_cast<int>(page_)),
                    within ? chosen : context_.folder + "/."};
    if (!editor_->file().isEmpty())
        out << editor_->file() << editor_->language() << QString::number(editor_->part().from)
            << QString::number(editor_->edit().textCursor().position());
    if (page_ == Page::Compare) out << compare_->left() << compare_->right();
    return out.join('|');
}

// A draft comes back on whatever page: what has been typed is not lost.
void Programs::restore(const QString& state) {
    QStringList parts = state.split('|');
    if (parts.size() < 2) parts = {"0", {}};
    if (parts[1].startsWith('/'))
        files_->readFolder(parts[1].section('/', 0, -2) + "/", parts[1].section('/', -1));
    const auto page = static_cast<Page>(parts[0].toInt());
    if (const Draft draft = std::exchange(context_.draft, {}); !draft.file.isEmpty()) {
        editor_->openDraft(draft);
        if (page == Page::Edit) show(Page::Edit);
    } else if (page == Page::Edit && parts.size() == 6 &&
               editor_->open(parts[2], parts[3], parts[4].toLongLong(), parts[5].toInt())) {
        show(Page::Edit);
    }
    if (page == Page::Restart) show(Page::Restart);
    if (page == Page::Compare && parts.size() >= 4) {
        compare_->compare(parts[parts.size() - 2], parts.back());
        show(Page::Compare);
    }
    if (page == Page::Together || page == Page::Time) {
        back_ = true;
        keepRun();
    }
}

void Programs::keepRun() {
    constexpr auto kLasting = KeptPieces::Span::Lasting;
    if (back_) {
        const auto piece = context_.kept.get("run", kLasting);
        if (!piece) return;  // it is still being read
        back_ = false;
        if (!piece->isEmpty()) {
            dry_.replay(*piece);
            wanted_ = dry_.wanted();
            show(dry_.how() == DryRun::How::Check ? Page::Together : Page::Time);
        }
        keptVersion_ = dry_.running() ? 0 : dry_.version();
    }
    if (dry_.running() || keptVersion_ == dry_.version() || !dry_.any()) return;
    keptVersion_ = dry_.version();
    context_.kept.put("run", dry_.record(), kLasting);
}

void Programs::select() {
    const QString path = files_->chosenPath(), name = QFileInfo(path).fileName();
    if (!files_->isFile()) return;
    const bool job = files_->isJob();
    context_.requests.press(
        job ? "select " + path : QString("select L%1=%2").arg(context_.channel).arg(path),
        [this, name, path, job](const Answer& answer) {
            if (!answer.ok) return;
            if (job)
                selected_.start(
                    [path, display_language = spoken(),
                     machine = context_.live.machineFolder()](const std::atomic<bool>&) {
                        return readJobSheet(path, machine, display_language);
                    });
            context_.tell(job ? word("%1 is selected in its channels").arg(name)
                              : word("%1 is selected in L%2").arg(name).arg(context_.channel),
                          Told::Good);
            takeSelected();
        });
}

void Programs::takeSelected() {
    const auto sheet = selected_.take();
    // the controller has read it: its answer counts
    if (!sheet || !sheet->fault.isEmpty()) return;
    const QString differs = jobDiffers(context_.live, *sheet);
    if (!differs.isEmpty())
        context_.tell(
            word("%1 is selected").arg(QFileInfo(sheet->path).fileName()) + ".  " + differs,
            Told::Warning);
}

// What a job brings is not measured: it is entered when somebody asks for it twice, each value by a
// request of its own, with the old value for undo.
std::optional<SoftKey> Programs::jobEntriesKey() {
    const JobSheet* sheet = files_->sheet();
    if (!sheet || !context_.live.connected()) return std::nullopt;
    const auto& all = context_.live.channels();
    const bool rests = std::none_of(
        all.begin(), all.end(), [&](unsigned one) { return works(context_.live.channel(one)); });
    std::vector<JobEntry> other;
    QStringList values;
    for (const JobEntry& one : jobEntries(context_.live, *sheet)) {
        if (one.same()) continue;
        other.push_back(one);
        values << QString("%1=%2 %3")
                      .arg(one.name)
                      .arg(one.wanted, 0, 'g', 12)
                      .arg(one.entered, 0, 'g', 12);
    }
    // the sheet beside it names them all
    if (!other.empty())
        return SoftKey{
            word("Enter zeros, offsets"),
            [this, other, sheet = *sheet] { enterJob(sheet, other); },
            Sign::Offsets,
            rests,
            false,
            false,
            word("Replaces what is entered: press again"),
            {},
            values.join(' '),
            other.size() == 1
                ? other.front().name
                : QString::fromUtf8("%1 … %2").arg(other.front().name).arg(other.size())};
    if (jobEntered_.empty() || !jobEnteredOf_ || jobEnteredOf_->path != sheet->path)
        return std::nullopt;
    return SoftKey{word("Undo zeros, offsets"), [this] { takeJobBack(); }, Sign::Undo, rests};
}

void Programs::enterJob(const JobSheet& sheet, const std::vector<JobEntry>& entries) {
    jobEntered_.clear();
    jobEnteredOf_ = std::make_shared<JobSheet>(sheet);
    for (const JobEntry& one : entries)
        context_.requests.set(one.request(one.wanted), [this, one, of = jobEnteredOf_,
                                                        count =
                                                            entries.size()](const Answer& answer) {
            // a refusal is reported; what was entered before it can be taken back
            if (!answer.ok || of != jobEnteredOf_) return;
            jobEntered_.push_back(one);
            if (jobEntered_.size() == count)
                context_.tell(
                    word("Zeros and offsets of %1 are entered").arg(QFileInfo(of->path).fileName()),
                    Told::Good);
            if (context_.keysChanged) context_.keysChanged();
        });
}

// Only where the job's value is still there: what has been measured since stays.
void Programs::takeJobBack() {
    QStringList stay;
    const auto now = jobEntries(context_.live, *jobEnteredOf_);
    for (const JobEntry& one : std::exchange(jobEntered_, {})) {
        const auto here = std::find_if(now.begin(), now.end(), [&](const JobEntry& entry) {
            return entry.words == one.words;
        });
        if (here != now.end() && here->same())
            context_.requests.set(one.request(one.entered));
        else
            stay << one.name;
    }
    if (!stay.isEmpty())
        context_.tell(word("%1: another value stands there by now, it stays").arg(stay.join(", ")),
                      Told::Refused);
    else
        context_.tell(word("Zeros and offsets stand as before"), Told::Good);
}

// A print server that does not answer is left behind, and there is no one left to notify.
Programs::~Programs() {
    for (QProcess* one : findChildren<QProcess*>()) {
        one->disconnect();
        one->kill();
        one->waitForFinished(200);
    }
}

// As a file beside the job, and to the printer where the computer has one.
void Programs::print() {
    if (!files_->sheet() || printing_.busy()) return;
    printed_ = files_->chosenPath().chopped(9) + "-setup.pdf";
    printing_.start([html = sheetText(context_.live, *files_->sheet()),
                     title = QString::fromStdString(files_->sheet()->job.name),
                     file = printed_](const std::atomic<bool>& stop) {
        FileProgress progress;
        return writeSheet(html, title, file, progress, stop);
    });
    if (printing_.busy())
        context_.tell(word("%1 is being written: the place answers slowly")
                          .arg(QFileInfo(printed_).fileName()),
                      Told::Note);
    takePrint();
    if (context_.keysChanged) context_.keysChanged();
}

void Programs::takePrint() {
    const auto done = printing_.take();
    if (!done) return;
    if (context_.keysChanged) context_.keysChanged();
    if (!done->ok())
        return context_.tell(word("Cannot be written: %1").arg(done->told()), Told::Refused);
    // lp answers at once: with the number of the print job, or with why there is none (no printer
    // is set up, the server does not answer).
    auto* lp = new QProcess(this);
    const QString name = QFileInfo(printed_).fileName();
    connect(lp, &QProcess::finished, this, [this, lp, name](int status, QProcess::ExitStatus how) {
        const QString why =
            QString::fromLocal8Bit(lp->readAllStandardError()).section('\n', 0, 0).trimmed();
        if (how == QProcess::NormalExit && status == 0)
            context_.tell(word("Printed: %1").arg(name), Told::Good);
        else
            context_.tell(
                word("Saved: %1").arg(name) + ".  " + word("The printer refused it: %1").arg(why),
                Told::Note);
        lp->deleteLater();
    });
    connect(lp, &QProcess::errorOccurred, this, [this, lp, name](QProcess::ProcessError error) {
        if (error != QProcess::FailedToStart) return;  // finished notifies the others
        context_.tell(word("Saved: %1").arg(name), Told::Good);
        lp->deleteLater();
    });
    QTimer::singleShot(kPrinterTimeout_ms, lp, [lp] { lp->kill(); });
    lp->start("lp", {printed_});
    lp->closeWriteChannel();
}

// In the language that the job beside it names, or of the channel in which it is selected; else of
// the channel that keys speak to.
QString Programs::languageOf(const QString& program) const {
    for (const FileEntry& one : files_->entries())
        if (!one.language.isEmpty() && QDir::cleanPath(context_.folder + "/" + one.name) == program)
            return one.language;
    for (const unsigned channel : context_.live.channels()) {
        const auto& own = context_.live.view(channel).programs;
        if (!own.empty() && QString::fromStdString(own.front()) == program)
            return fromView(language_name(context_.live.programLanguage(channel)));
    }
    return fromView(language_name(context_.live.panelLanguage(context_.channel)));
}

void Programs::edit() {
    const QString path = files_->chosenPath();
    if (!files_->isFile()) return;
    if (const QString why = files_->whyNotChanged(); !why.isEmpty())
        return context_.tell(why, Told::Refused);
    // goes on where it was left
    if (editor_->file() == path && editor_->changed()) return show(Page::Edit);
    if (editor_->open(path, languageOf(path))) show(Page::Edit);
}

void Programs::openPlace() {
    if (!isVisible() || context_.placeToEdit.file.isEmpty()) return;
    const Context::ProgramPlace place = context_.placeToEdit;
    const QFileInfo file(place.file);
    if (!opensPlace_) {
        opensPlace_ = true;
        show(Page::Files);
        files_->showMenu(false);
        files_->readFolder(file.absolutePath(), file.fileName());
    }
    if (files_->reading()) return;
    opensPlace_ = false;
    context_.placeToEdit = {};
    if (files_->chosenPath() != QDir::cleanPath(file.absoluteFilePath()))
        return context_.tell(word("%1 is not there any more").arg(file.fileName()), Told::Refused);
    if (editor_->changed() && editor_->file() != files_->chosenPath())
        return context_.tell(word("The editor holds a text that is not saved"), Told::Refused);
    edit();
    if (page_ == Page::Edit && place.line > 0) editor_->goToLine(place.line);
}

// The chosen file; from the editor the job beside it that has the program, else the program alone
// in its language.
DryRun::Wanted Programs::wantedHere() const {
    if ((page_ == Page::Together || page_ == Page::Time) && !wanted_.file.isEmpty()) return wanted_;
    const QString path = page_ == Page::Edit ? editor_->file()
                         : files_->isFile()  ? files_->chosenPath()
                                             : QString();
    if (path.isEmpty()) return {};
    const auto entryOf = [&](const QString& file) -> const FileEntry* {
        for (const FileEntry& one : files_->entries())
            if (!one.folder && QDir::cleanPath(context_.folder + "/" + one.name) == file)
                return &one;
        return nullptr;
    };
    const FileEntry* entry = entryOf(path);
    if (page_ == Page::Edit && entry && !entry->ofJob.isEmpty())
        return {entry->ofJob, 0,
                entryOf(entry->ofJob) ? entryOf(entry->ofJob)->languages
                                      : std::map<unsigned, Dialect>()};
    if (entry && entry->job) return {path, 0, entry->languages};
    DryRun::Wanted alone{path, context_.channel};
    if (const Dialect language = dialect_of(
            (page_ == Page::Edit ? editor_->language() : languageOf(path)).toStdString());
        language != Dialect::Polyturn)
        alone.languages[context_.channel] = language;
    return alone;
}

// Of the text in the editor, not of what its file has been.
void Programs::look(DryRun::How how) {
    if (page_ == Page::Edit && editor_->changed()) {
        afterSave_ = how;
        return editor_->save();
    }
    wanted_ = wantedHere();
    if (wanted_.file.isEmpty()) return;
    back_ = false;
    context_.kept.put("run", {}, KeptPieces::Span::Lasting);  // not shown any more
    dry_.start(
        how, wanted_,
        context_.live.connected() ? QString::fromStdString(context_.live.instance()) : QString());
    show(how == DryRun::How::Check ? Page::Together : Page::Time);
}

void Programs::lookSaved() {
    if (!afterSave_ || editor_->saving()) return;
    const DryRun::How how = *std::exchange(afterSave_, std::nullopt);
    // else it could not be written, as has been reported
    if (page_ == Page::Edit && !editor_->changed()) look(how);
}

// In the editor the manual's line of the word at the cursor.
HelpTopic Programs::help() const {
    if (page_ == Page::Edit && editor_->contour().isVisible())
        return {"operator.md", "Cycles as forms", {}};
    if (page_ == Page::Edit && editor_->form().isVisible()) {
        if (const CodePlace place = placeOfCode(editor_->form().code(), editor_->language());
            !place.page.isEmpty())
            return {place.page, place.find, {}, place.code};
    } else if (page_ == Page::Edit) {
        const QTextCursor at = editor_->edit().textCursor();
        if (const CodePlace place =
                placeOfCode(wordAt(at.block().text(), at.positionInBlock()), editor_->language());
            !place.page.isEmpty())
            return {place.page, place.find, {}, place.code};
    }
    if (page_ == Page::Restart) return {"operator.md", "Beginning in the middle", {}};
    if (page_ == Page::Together) return {"programmer.md", "Waiting", {}};
    return {"operator.md",
            files_->menu() || page_ == Page::Compare ? QString("Files") : QString("Programs:"),
            {}};
}

void Programs::show(Page page) {
    page_ = page;
    back_ = false;
    scroll_ = 0;
    scrolled_ = 0;
    timeVersion_ = ~0ull;
    layOut();
    refresh();
}

// For pictures of all of it; the editor's are those of a program of the examples. Behind them what
// is done with files, a comparison of the folder's first two programs, the editor's text without
// and with keys, the places.
void Programs::turnTo(int page) {
    constexpr int kMenu = 7, kCompare = 8, kText = 9, kKeys = 10, kPlaces = 11;
    if (files_->atPlaces()) files_->readAgain();
    files_->showMenu(page == kMenu);
    if (page == kCompare) {
        QStringList two;
        for (const FileEntry& one : files_->entries())
            if (!one.folder && !one.job && one.name.endsWith(".nc") && two.size() < 2)
                two << context_.folder + "/" + one.name;
        if (two.size() == 2) {
            compare_->compare(two[0], two[1]);
            return show(Page::Compare);
        }
    }
    if (page == kPlaces) {
        show(Page::Files);
        return files_->showPlaces();
    }
    const bool text = page == kText || page == kKeys;
    if (page == 0 || (page > 6 && !text)) return show(Page::Files);
    if (page == 3) return show(Page::Restart);
    if (page < 3) return look(page == 1 ? DryRun::How::Check : DryRun::How::Drive);
    const QString sample =
        QString::fromStdString(text::share_folder()) + "/examples/programs/O0050.nc";
    if (!QFileInfo::exists(sample) || !editor_->open(sample, "fanuc")) return show(Page::Files);
    show(Page::Edit);
    editor_->showSample(text ? 3 : page - 4, page == kKeys);
}

void Programs::resizeEvent(QResizeEvent*) { layOut(); }

void Programs::layOut() {
    const int top = px(46), edge = px(8);
    head_->setGeometry(0, 0, width(), top);
    view_->setGeometry(edge, top, width() - 2 * edge, height() - top - edge);
    QWidget* const pages[] = {files_, restart_, editor_, compare_};
    QWidget* const here = page_ == Page::Files     ? static_cast<QWidget*>(files_)
                          : page_ == Page::Restart ? restart_
                          : page_ == Page::Edit    ? editor_
                          : page_ == Page::Compare ? static_cast<QWidget*>(compare_)
                                                   : nullptr;
    for (QWidget* one : pages) {
        one->setGeometry(0, top, width(), height() - top);
        one->setVisible(one == here);
    }
    view_->setVisible(!here);
}

std::vector<Sheet*> Programs::sheets() {
    std::vector<Sheet*> out{view_};
    if (page_ == Page::Files) out = files_->sheets();
    if (page_ == Page::Compare) out = compare_->sheets();
    if (page_ == Page::Edit) out = editor_->sheets();
    if (page_ == Page::Restart) out = restart_->sheets();
    out.push_back(head_);
    return out;
}

// Faults of the check, under the picture.
void Programs::composeFaults(Writer& w, const QRectF& box) {
    const Theme& t = theme();
    double y = box.top();
    const auto line = [&](Sign sign, const QColor& colour, const QString& text) {
        if (y + px(24) > box.bottom()) return;
        const QFont font = lettering(14.5);
        const double wide = box.width() - px(42);
        // on a narrow panel
        const int lines =
            y + px(46) <= box.bottom() && QFontMetricsF(font).horizontalAdvance(text) > wide ? 2
                                                                                             : 1;
        w.sign(QRectF(box.left() + px(8), y + px(3), px(18), px(18)), sign, colour);
        w.data(QRectF(box.left() + px(34), y, wide, px(lines == 2 ? 44 : 24)), text, font, t.text)
            .wraps = lines == 2;
        y += px(lines == 2 ? 46 : 25);
    };
    if (!dry_.failure().isEmpty()) return line(Sign::Alarm, t.bad, dry_.failure());
    if (dry_.running())
        return line(Sign::Wait, t.wait,
                    dry_.how() == DryRun::How::Check ? word("The programs are being read")
                                                     : word("The job is being simulated"));
    if (dry_.faults().empty()) return line(Sign::Good, t.good, word("No faults found"));
    for (const RunFault& fault : dry_.faults())
        line(fault.error ? Sign::Alarm : Sign::Warning, fault.error ? t.bad : t.warn,
             (fault.channel ? QString("L%1  ").arg(fault.channel) : QString()) + fault.place +
                 "  " + fault.number + "  " + fault.text);
}

void Programs::refresh() {
    if (page_ == Page::Edit) editor_->refresh();
    if (page_ == Page::Compare) compare_->refresh();
    files_->refresh();  // a transfer goes on behind the other pages
    for (Sheet* one : sheets()) {
        // a hundred thousand moves: written when there are others
        if (one == view_ && page_ == Page::Time &&
            std::exchange(timeVersion_, dry_.version()) == dry_.version())
            continue;
        one->refresh();
    }
}

std::vector<SoftKey> Programs::keys() {
    const bool there = context_.live.connected(), file = files_->isFile(), job = files_->isJob();
    std::vector<SoftKey> own;
    if (page_ == Page::Files && files_->menu()) {
        files_->addMenuKeys(own);
        return own;
    }
    if (page_ == Page::Compare) {
        own.push_back({word("Back"), [this] { show(Page::Files); }, Sign::Left});
        compare_->addKeys(own);
        return own;
    }
    const bool can = page_ == Page::Files  ? file
                     : page_ == Page::Edit ? !editor_->file().isEmpty()
                                           : !wanted_.file.isEmpty();
    const QString saves = page_ == Page::Edit && editor_->changed()
                              ? word("Saves the text first: press again")
                              : QString();
    const auto& all = context_.live.channels();
    const bool runs = std::any_of(all.begin(), all.end(),
                                  [&](unsigned one) { return works(context_.live.channel(one)); });
    SoftKey start = startGroupKey(context_, groupOf(context_.live, context_.channel));
    start.act = [this, act = start.act] {
        act();
        context_.show(0);
    };
    std::vector<SoftKey> keys{
        {word("Files"), [this] { show(Page::Files); }, Sign::Programs, true, page_ == Page::Files},
        {word("Check, waits"),
         [this] { look(DryRun::How::Check); },
         Sign::Overview,
         can,
         page_ == Page::Together,
         false,
         saves,
         {},
         page_ == Page::Edit ? editor_->file() : QString()},
        {word("Simulation, timeline"),
         [this] { look(DryRun::How::Drive); },
         Sign::Graphics,
         can,
         page_ == Page::Time,
         false,
         saves,
         {},
         page_ == Page::Edit ? editor_->file() : QString()},
        {word("Restart in the middle"), [this] { show(Page::Restart); }, Sign::None, there,
         page_ == Page::Restart},
        std::move(start),
        {job || !file ? word("Select job") : word("Select in L%1").arg(context_.channel),
         [this] { select(); }, Sign::Good, there && file && !runs && page_ == Page::Files},
        {word("New program"),
         [this] {
             files_->newProgram(
                 fromView(language_name(context_.live.panelLanguage(context_.channel))));
         },
         Sign::None, page_ == Page::Files && !files_->atPlaces() && !files_->working(),
         files_->naming()},
        {word("Places"), [this] { files_->showPlaces(); }, Sign::None, page_ == Page::Files},
    };
    // of a job whose zeros or offsets are others
    if (auto entries = page_ == Page::Files ? jobEntriesKey() : std::nullopt)
        keys[6] = std::move(*entries);
    if (page_ == Page::Restart) restart_->addKeys(keys);
    if ((page_ == Page::Together || page_ == Page::Time) && dry_.running())
        keys.push_back({word("Stop"),
                        [this] {
                            dry_.cancel();
                            refresh();
                            if (context_.keysChanged)
                                context_.keysChanged();
                            else
                                void();
                        },
                        Sign::Stop});
    if (page_ == Page::Files && printing_.busy())
        keys.push_back({word("Stop"),
                        [this] {
                            // the worker sees it before its next piece, and takes away what it has
                            // written
                            printing_.forget();
                            context_.tell(word("The setup sheet is not written: stopped."),
                                          Told::Note);
                            if (context_.keysChanged) context_.keysChanged();
                        },
                        Sign::Stop});
    else if (page_ == Page::Files && files_->sheet())
        keys.push_back({word("Print setup sheet"), [this] { print(); }, Sign::Programs, true});
    else if (page_ == Page::Files && files_->isFolder())
        keys.push_back({word("Open folder"), [this] { files_->open(); }, Sign::Right});
    else if (page_ == Page::Files)
        keys.push_back({word("Edit"),
                        [this] { edit(); },
                        Sign::Programs,
                        file && !job,
                        false,
                        false,
                        editor_->changed() && editor_->file() != files_->chosenPath()
                            ? word("Unsaved text goes: press again")
                            : QString(),
                        {},
                        files_->chosenPath()});
    if (page_ == Page::Files)
        keys.push_back({word("Copy, delete ..."), [this] { files_->showMenu(true); }, Sign::Right});
    if (page_ == Page::Edit) {
        if (editor_->opening())
            keys.clear();
        else
            keys.resize(3);
        editor_->addKeys(keys);
    }
    return keys;
}

bool Programs::key(QKeyEvent* event) {
    if (page_ == Page::Files) return files_->key(event);
    if (page_ == Page::Compare)
        return event->key() == Qt::Key_Escape ? show(Page::Files), true : compare_->key(event);
    if (page_ == Page::Edit)
        return event->key() == Qt::Key_Escape && !editor_->changed() && !editor_->covered()
               ? show(Page::Files),
               true : editor_->key(event);
    if (page_ == Page::Restart)
        return event->key() == Qt::Key_Escape && restart_->pad().text().isEmpty()
               ? show(Page::Files),
               true : restart_->key(event);
    switch (event->key()) {
        case Qt::Key_Up:
            scroll_ -= 1;
            break;
        case Qt::Key_Down:
            scroll_ += 1;
            break;
        case Qt::Key_PageUp:
            scroll_ -= 15;
            break;
        case Qt::Key_PageDown:
            scroll_ += 15;
            break;
        case Qt::Key_Home:
            scroll_ = 0;
            break;
        case Qt::Key_Escape:
            show(Page::Files);
            return true;
        default:
            return false;
    }
    scroll_ = std::max(0, scroll_);
    refresh();
    return true;
}

}  // namespace polyturn::hmi
