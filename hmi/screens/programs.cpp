#include "hmi/screens/programs.hpp"

#include <QDateTime>
#include <QDir>
#include <QProcess>
#include <algorithm>

#include "hmi/machine/channel_words.hpp"
#include "hmi/machine/setup_sheet.hpp"
#include "ipc/text/job.hpp"
#include "ipc/text/machine_path.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kRight = Qt::AlignRight | Qt::AlignVCenter;

bool isJob(const QFileInfo& one) { return text::is_job_file(one.filePath().toStdString()); }

}  // namespace

Programs::Programs(Desk& desk) : Screen(desk), files_(new Table(this)), head_(new FreeSheet(this)), preview_(new FreeSheet(this)), view_(new FreeSheet(this)), restart_(new RestartPage(desk, this)), editor_(new EditorPage(desk, this)) {
    setFocusPolicy(Qt::StrongFocus);
    files_->columns = {{word("Name"), 5}, {word("Changed"), 2.2}, {word("Size"), 1.2, kRight}};
    files_->rowUnits = 40;
    files_->textUnits = 16;
    files_->nothing = word("This folder is empty.");
    files_->rows = [this] { return static_cast<int>(entries_.size()); };
    files_->cell = [this](int row, int column) -> Table::Cell {
        const QFileInfo& one = entries_[static_cast<std::size_t>(row)];
        const Theme& t = theme();
        const bool up = one.fileName() == "..", job = isJob(one);
        if (column == 0) return {up ? word("Up") : job ? one.fileName().chopped(9) : one.fileName(), one.isDir() ? t.accent : job ? t.text : t.dim, up ? Sign::Up : one.isDir() ? Sign::Right : job ? Sign::Overview : Sign::Programs, job};
        if (up || (one.isDir() && column == 2)) return {};
        if (column == 1) return {one.lastModified().toString("dd.MM.yy HH:mm"), t.dim};
        return {QString("%1 kB").arg((one.size() + 1023) / 1024), t.dim};
    };
    files_->onChosen = [this] { preview(); };
    files_->onActivated = [this] { open(); };
    head_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, head_->width(), head_->height()), t.window);
        const QString title = page_ == Page::Files ? word("Programs and jobs") : page_ == Page::Together ? word("Synchronised view") : page_ == Page::Time ? word("Timeline") : page_ == Page::Restart ? word("Restart in the middle") : word("Editor");
        w.text(QRectF(px(14), 0, head_->width() * 0.4, head_->height()), title, lettering(20, true), t.text);
        w.data(QRectF(head_->width() * 0.42, 0, head_->width() * 0.58 - px(12), head_->height()), page_ == Page::Files ? desk_.folder : page_ == Page::Restart ? QString() : page_ == Page::Edit ? editor_->file() + (editor_->changed() ? " *" : "") : QFileInfo(dry_.job()).fileName(), lettering(15), t.dim, kRight);
    };
    preview_->onCompose = [this](Writer& w) { composePreview(w); };
    view_->onCompose = [this](Writer& w) { page_ == Page::Time ? composeTime(w) : composeTogether(w); };
    if (desk_.folder.isEmpty() || !QDir(desk_.folder).exists()) desk_.folder = QDir::currentPath();
    readFolder(desk_.folder);
}

void Programs::restore(const QString& state) {
    const QStringList parts = state.split('|');
    if (parts.size() == 2 && QFileInfo(parts[1]).exists()) readFolder(QFileInfo(parts[1]).absolutePath(), QFileInfo(parts[1]).fileName());
}

QString Programs::chosenPath() const {
    const int row = files_->row();
    return row >= 0 && row < static_cast<int>(entries_.size()) ? entries_[static_cast<std::size_t>(row)].absoluteFilePath() : QString();
}

void Programs::readFolder(const QString& folder, const QString& choose) {
    const QDir dir(folder);
    desk_.folder = dir.absolutePath();
    lookedMs_ = QDateTime::currentMSecsSinceEpoch();
    entries_.clear();
    if (!dir.isRoot()) entries_.emplace_back(desk_.folder + "/..");
    const QFileInfoList all = dir.entryInfoList(QDir::AllDirs | QDir::Files | QDir::NoDotAndDotDot, QDir::DirsFirst | QDir::Name);
    for (const QFileInfo& one : all)
        if (one.isDir()) entries_.push_back(one);
    for (const QFileInfo& one : all)
        if (!one.isDir() && isJob(one)) entries_.push_back(one);
    for (const QFileInfo& one : all)
        if (!one.isDir() && !isJob(one)) entries_.push_back(one);
    int row = 0;
    for (std::size_t i = 0; i < entries_.size(); ++i)
        if (entries_[i].fileName() == choose) row = static_cast<int>(i);
    if (choose.isEmpty())   // the first job is what a folder is opened for
        for (std::size_t i = entries_.size(); i-- > 0;)
            if (!entries_[i].isDir() && isJob(entries_[i])) row = static_cast<int>(i);
    files_->choose(row);
}

void Programs::open() {
    const int row = files_->row();
    if (row < 0 || row >= static_cast<int>(entries_.size())) return;
    const QFileInfo one = entries_[static_cast<std::size_t>(row)];
    if (!one.isDir()) return;
    const QString left = QDir(desk_.folder).dirName();
    readFolder(QDir::cleanPath(one.filePath()), one.fileName() == ".." ? left : QString());
}

void Programs::preview() {
    job_.reset();
    jobFault_.clear();
    const QString path = chosenPath();
    if (path.isEmpty() || !isJob(QFileInfo(path))) return;
    const auto job = text::load_job(path.toStdString());
    if (job) job_ = std::make_unique<text::Job>(*job);
    else jobFault_ = QString::fromStdString(text_in(job.diagnosis(), spoken()));
}

void Programs::select() {
    const QString path = chosenPath(), name = QFileInfo(path).fileName();
    if (path.isEmpty() || QFileInfo(path).isDir()) return;
    const bool job = isJob(QFileInfo(path));
    desk_.requests.press(job ? "select " + path : QString("select L%1=%2").arg(desk_.channel).arg(path), [this, name, job](const Answer& answer) {
        if (answer.ok) desk_.tell(job ? word("%1 is selected in its channels").arg(name) : word("%1 is selected in L%2").arg(name).arg(desk_.channel), Told::Good);
    });
}

// As a file beside the job, and to the printer where the computer has one.
void Programs::print() {
    if (!job_) return;
    const QString file = chosenPath().chopped(9) + "-setup.pdf";
    if (!printSheet(desk_.live, *job_, file)) return desk_.tell(word("Cannot be written: %1").arg(file), Told::Refused);
    const bool printer = QProcess::startDetached("lp", {file});
    desk_.tell(printer ? word("Printed: %1").arg(QFileInfo(file).fileName()) : word("Saved: %1").arg(QFileInfo(file).fileName()), Told::Good);
}

// In the language of the channel that runs it, or of the job beside it that names it; else of the channel that keys speak to.
void Programs::edit() {
    const QString path = chosenPath();
    if (!QFileInfo(path).isFile()) return;
    if (editor_->file() == path && editor_->changed()) return show(Page::Edit);   // goes on where it was left
    std::string language(params::get_text(desk_.live.table(), params::pt_language, desk_.channel));
    for (const QFileInfo& one : entries_)
        if (!one.isDir() && isJob(one))
            if (const auto job = text::load_job(one.filePath().toStdString()))
                for (const auto& [channel, program] : job->programs)
                    if (QFileInfo(QString::fromStdString(program.file)) == QFileInfo(path) && !program.language.empty()) language = program.language;
    if (editor_->open(path, QString::fromStdString(language))) show(Page::Edit);
}

void Programs::look(DryRun::How how) {
    const QString path = chosenPath();
    if (QFileInfo(path).isFile()) wanted_ = path;
    if (wanted_.isEmpty()) return;
    dry_.start(how, wanted_, desk_.live.connected() ? QString::fromStdString(desk_.live.instance()) : QString());
    show(how == DryRun::How::Check ? Page::Together : Page::Time);
}

void Programs::show(Page page) {
    page_ = page;
    scroll_ = 0;
    layOut();
    refresh();
}

// For pictures of all of it; the editor's are those of a program of the examples.
void Programs::turnTo(int page) {
    if (page == 0) return show(Page::Files);
    if (page == 3) return show(Page::Restart);
    if (page < 3) return look(page == 1 ? DryRun::How::Check : DryRun::How::Drive);
    const QString sample = QString::fromStdString(text::share_folder()) + "/examples/programs/O0050.nc";
    if (!QFileInfo::exists(sample) || !editor_->open(sample, "fanuc")) return show(Page::Files);
    show(Page::Edit);
    editor_->showSample(page - 4);
}

void Programs::resizeEvent(QResizeEvent*) { layOut(); }

void Programs::layOut() {
    const int top = px(46), edge = px(8), half = static_cast<int>(width() * 0.5);
    const bool files = page_ == Page::Files;
    head_->setGeometry(0, 0, width(), top);
    files_->setGeometry(edge, top, half - 2 * edge, height() - top - edge);
    preview_->setGeometry(half, top, width() - half - edge, height() - top - edge);
    view_->setGeometry(edge, top, width() - 2 * edge, height() - top - edge);
    restart_->setGeometry(0, top, width(), height() - top);
    editor_->setGeometry(0, top, width(), height() - top);
    editor_->setVisible(page_ == Page::Edit);
    const bool restart = page_ == Page::Restart || page_ == Page::Edit;
    files_->setVisible(files), preview_->setVisible(files), view_->setVisible(!files && !restart), restart_->setVisible(page_ == Page::Restart);
}

std::vector<Sheet*> Programs::sheets() {
    if (page_ == Page::Files) return {head_, files_, preview_};
    if (page_ == Page::Restart || page_ == Page::Edit) {
        std::vector<Sheet*> out = page_ == Page::Edit ? editor_->sheets() : restart_->sheets();
        out.push_back(head_);
        return out;
    }
    return {head_, view_};
}

void Programs::composePreview(Writer& w) {
    const Theme& t = theme();
    const double wide = preview_->width(), high = preview_->height();
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const QString path = chosenPath();
    const QFileInfo one(path);
    if (path.isEmpty() || one.isDir()) {
        w.text(QRectF(px(20), px(20), wide - px(40), px(30)), word("Choose a job or a program"), lettering(16), t.dim, Qt::AlignCenter);
        return;
    }
    double y = px(12);
    if (!jobFault_.isEmpty()) {
        w.sign(QRectF(px(16), y + px(4), px(22), px(22)), Sign::Alarm, t.bad);
        Item& item = w.text(QRectF(px(48), y, wide - px(60), px(90)), jobFault_, lettering(16), t.text, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true, item.data = true;
        return;
    }
    if (!job_) {
        w.data(QRectF(px(16), y, wide - px(32), px(28)), one.fileName(), lettering(18, true), t.text);
        y += px(34);
        const std::string file = path.toStdString();
        if (!texts_.readable(file)) {
            w.text(QRectF(px(16), y, wide - px(32), px(26)), word("It cannot be shown."), lettering(15), t.dim);
            return;
        }
        for (int line = 1; line <= texts_.count(file) && y + px(20) < high; ++line, y += px(20)) {
            w.text(QRectF(px(8), y, px(40), px(20)), QString::number(line), lettering(12), t.faint, kRight);
            w.data(QRectF(px(58), y, wide - px(70), px(20)), texts_.line(file, static_cast<std::uint32_t>(line)), lettering(13.5, false, Face::Program), t.text);
        }
        return;
    }
    w.data(QRectF(px(16), y, wide - px(32), px(34)), QString::fromStdString(job_->name), lettering(24, true), t.text);
    y += px(42);
    const auto headline = [&](const QString& text) {
        w.text(QRectF(px(16), y, wide - px(32), px(22)), text, lettering(13, false, Face::Condensed), t.dim);
        y += px(24);
    };
    headline(word("Programs"));
    for (const auto& [channel, program] : job_->programs) {
        const QFileInfo file(QString::fromStdString(program.file));
        w.text(QRectF(px(16), y, px(50), px(26)), QString("L%1").arg(channel), lettering(17, true), t.accent);
        w.data(QRectF(px(66), y, wide * 0.5, px(26)), file.fileName(), lettering(17), t.text);
        w.data(QRectF(wide * 0.62, y, wide * 0.38 - px(16), px(26)), QString::fromStdString(program.language), lettering(14), t.dim, kRight);
        if (!file.exists()) w.sign(QRectF(wide * 0.55, y + px(3), px(20), px(20)), Sign::Alarm, t.bad);
        y += px(30);
    }
    if (job_->stock) {
        y += px(8);
        headline(word("Stock"));
        const text::JobStock& stock = *job_->stock;
        w.text(QRectF(px(16), y, wide - px(32), px(26)), QString::fromUtf8("⌀ %1 × %2 mm").arg(stock.diameter).arg(stock.length) + (stock.bore > 0 ? QString::fromUtf8("   %1 ⌀ %2 mm").arg(word("bore")).arg(stock.bore) : QString()) +
                                                                             "   " + QString::fromStdString(stock.spindle), lettering(17), t.text);
        y += px(30);
    }
    if (job_->parts_wanted) {
        y += px(8);
        headline(word("Parts"));
        w.text(QRectF(px(16), y, wide - px(32), px(26)), QString::number(job_->parts_wanted), lettering(17), t.text);
        y += px(30);
    }
    if (!job_->tools.empty()) {
        y += px(8);
        headline(word("Tools that it needs"));
        for (const SheetTool& tool : compareTools(desk_.live, *job_)) {   // wanted against mounted
            if (y + px(26) > high) break;
            const bool same = tool.match == SheetTool::Match::Same, unknown = tool.match == SheetTool::Match::Unknown;
            const bool usable = same && tool.state.sign != Sign::Alarm && tool.state.sign != Sign::Lock && tool.state.sign != Sign::Stop;
            w.text(QRectF(px(16), y, px(120), px(24)), QString("L%1   T%2").arg(tool.channel).arg(tool.station), lettering(15, true), t.text);
            w.data(QRectF(px(140), y, wide * 0.34, px(24)), tool.wanted, lettering(15), t.text);
            w.sign(QRectF(wide * 0.34 + px(150), y + px(3), px(18), px(18)), unknown ? Sign::None : usable ? Sign::Good : same ? tool.state.sign : Sign::Warning, usable ? t.good : same ? t.bad : t.warn);
            w.data(QRectF(wide * 0.34 + px(176), y, wide * 0.66 - px(190), px(24)), same && !usable ? tool.state.text : matchText(tool), lettering(14.5), usable || unknown ? t.dim : t.text);
            y += px(26);
        }
    }
}

// Faults of the check, under the picture.
void Programs::composeFaults(Writer& w, const QRectF& box) {
    const Theme& t = theme();
    double y = box.top();
    const auto line = [&](Sign sign, const QColor& colour, const QString& text) {
        if (y + px(24) > box.bottom()) return;
        w.sign(QRectF(box.left() + px(8), y + px(3), px(18), px(18)), sign, colour);
        w.data(QRectF(box.left() + px(34), y, box.width() - px(42), px(24)), text, lettering(14.5), t.text);
        y += px(25);
    };
    if (!dry_.failure().isEmpty()) return line(Sign::Alarm, t.bad, dry_.failure());
    if (dry_.running()) return line(Sign::Wait, t.wait, dry_.how() == DryRun::How::Check ? word("The programs are being read") : word("The job is being driven in virtual time"));
    if (dry_.faults().empty()) return line(Sign::Good, t.good, word("No faults found"));
    for (const RunFault& fault : dry_.faults())
        line(fault.error ? Sign::Alarm : Sign::Warning, fault.error ? t.bad : t.warn,
             (fault.channel ? QString("L%1  ").arg(fault.channel) : QString()) + fault.place + "  " + fault.number + "  " + fault.text);
}

void Programs::refresh() {
    if (page_ == Page::Edit) editor_->refresh();
    for (Sheet* one : sheets()) one->refresh();
}

std::vector<SoftKey> Programs::keys() {
    const bool there = desk_.live.connected(), file = QFileInfo(chosenPath()).isFile(), job = file && isJob(QFileInfo(chosenPath()));
    const bool can = page_ == Page::Files ? file : !wanted_.isEmpty();
    bool runs = false;
    for (const unsigned channel : desk_.live.channels()) {
        const auto state = static_cast<ChannelState>(desk_.live.channel(channel).state);
        runs |= state == ChannelState::Running || state == ChannelState::Held || state == ChannelState::Waiting || state == ChannelState::ProgramStop;
    }
    std::vector<SoftKey> keys{
        {word("Files"), [this] { show(Page::Files); }, Sign::Programs, true, page_ == Page::Files},
        {word("Check, waits"), [this] { look(DryRun::How::Check); }, Sign::Overview, can, page_ == Page::Together},
        {word("Dry run, timeline"), [this] { look(DryRun::How::Drive); }, Sign::Graphics, can, page_ == Page::Time},
        {word("Restart in the middle"), [this] { show(Page::Restart); }, Sign::Left, there, page_ == Page::Restart},
        {word("Open folder"), [this] { open(); }, Sign::Right, page_ == Page::Files && QFileInfo(chosenPath()).isDir()},
        {word("Read again"), [this] { readFolder(desk_.folder, QFileInfo(chosenPath()).fileName()); }, Sign::None, page_ == Page::Files},
        {job || !file ? word("Select job") : word("Select in L%1").arg(desk_.channel), [this] { select(); }, Sign::Good, there && file && !runs && page_ == Page::Files},
        {word("Start all"), [this] { desk_.requests.press("cycle_start"), desk_.show(0); }, Sign::Run, there},
    };
    if (page_ == Page::Restart) restart_->addKeys(keys);
    if (page_ == Page::Files && job_) keys.push_back({word("Print setup sheet"), [this] { print(); }, Sign::Programs, true});
    else if (page_ == Page::Files) keys.push_back({word("Edit"), [this] { edit(); }, Sign::Programs, file && !job});
    if (page_ == Page::Edit) {
        keys.resize(3);
        editor_->addKeys(keys);
    }
    return keys;
}

bool Programs::key(QKeyEvent* event) {
    if (page_ == Page::Files) {
        if (event->key() == Qt::Key_Backspace && !entries_.empty() && entries_.front().fileName() == "..") return files_->choose(0), open(), true;
        return files_->key(event);
    }
    if (page_ == Page::Edit) return event->key() == Qt::Key_Escape && !editor_->changed() && !editor_->covered() ? show(Page::Files), true : editor_->key(event);
    if (page_ == Page::Restart) return event->key() == Qt::Key_Escape && restart_->pad().text().isEmpty() ? show(Page::Files), true : restart_->key(event);
    switch (event->key()) {
        case Qt::Key_Up: scroll_ -= 1; break;
        case Qt::Key_Down: scroll_ += 1; break;
        case Qt::Key_PageUp: scroll_ -= 15; break;
        case Qt::Key_PageDown: scroll_ += 15; break;
        case Qt::Key_Home: scroll_ = 0; break;
        case Qt::Key_Escape: show(Page::Files); return true;
        default: return false;
    }
    scroll_ = std::max(0, scroll_);
    refresh();
    return true;
}

}  // namespace polyturn::hmi
