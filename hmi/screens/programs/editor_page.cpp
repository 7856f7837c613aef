#include "hmi/screens/programs/editor_page.hpp"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QKeyEvent>
#include <QProcess>
#include <QRegularExpression>
#include <QScroller>
#include <QTextBlock>
#include <algorithm>

#include "hmi/machine/programs/program_unit.hpp"
#include "hmi/screens/programs/contour_page.hpp"
#include "hmi/screens/programs/cycle_form_page.hpp"
#include "hmi/text/retold.hpp"
#include "hmi/widgets/finger_bars.hpp"
#include "hmi/widgets/number_cells.hpp"

namespace polyturn::hmi {
namespace {

constexpr int kPauseMs = 500;  // no letter for so long: it is checked

}  // namespace

EditorPage::EditorPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      edit_(new QPlainTextEdit(this)),
      numbers_(new FreeSheet(this)),
      line_(new FreeSheet(this)),
      pad_(new TextPad(this)),
      form_(new CycleFormPage(context, this)),
      contour_(new ContourPage(context, this)) {
    for (EditorOverlay* one :
         {static_cast<EditorOverlay*>(form_), static_cast<EditorOverlay*>(contour_)})
        layOver(one);
    edit_->setFrameShape(QFrame::NoFrame);
    edit_->setLineWrapMode(QPlainTextEdit::NoWrap);
    edit_->setTabChangesFocus(true);
    QScroller::grabGesture(edit_->viewport(), QScroller::TouchGesture);
    pad_->capitals = true;
    pad_->onText = [this](const QString& text) { edit_->insertPlainText(text); };
    pad_->onBackspace = [this] { edit_->textCursor().deletePreviousChar(); };
    pad_->onEnter = [this] { edit_->insertPlainText("\n"); };
    wait_.setSingleShot(true);
    QObject::connect(&wait_, &QTimer::timeout, this, [this] { check(); });
    QObject::connect(edit_, &QPlainTextEdit::textChanged, this, [this] {
        if (!file_.isEmpty()) wait_.start(kPauseMs);
    });
    QObject::connect(edit_, &QPlainTextEdit::cursorPositionChanged, this, [this] {
        line_->refresh();
        numbers_->refresh();
    });
    // The numbers by which alarms, faults and restarts name the lines, beside those that are seen.
    QObject::connect(edit_, &QPlainTextEdit::updateRequest, this,
                     [this](const QRect&, int) { numbers_->refresh(); });
    numbers_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, numbers_->width(), numbers_->height()), t.window);
        const int here = edit_->textCursor().blockNumber();
        for (QTextBlock block = edit_->cursorForPosition({0, 0}).block(); block.isValid();
             block = block.next()) {
            const QRect at = edit_->cursorRect(QTextCursor(block));
            if (at.top() > edit_->viewport()->height()) break;
            const bool chosen = block.blockNumber() == here;
            w.data(QRectF(0, at.top(), numbers_->width() - px(10), at.height()),
                   QString::number(block.blockNumber() + 1 + part_.line),
                   lettering(14, chosen, Face::Program), chosen ? t.text : t.dim, kRight);
        }
    };
    line_->onCompose = [this](Writer& w) {
        const Theme& t = theme();
        w.fill(QRectF(0, 0, line_->width(), line_->height()), t.window);
        w.fill(QRectF(0, px(4), line_->width(), line_->height() - px(4)), t.card, px(6));
        if (!filling_.isEmpty()) {
            w.sign(QRectF(px(10), px(11), px(22), px(22)), Sign::Wait, t.wait);
            w.data(QRectF(px(42), px(4), line_->width() - px(300), line_->height() - px(4)),
                   word("%1 is being opened").arg(QFileInfo(wanted_).fileName()), lettering(15),
                   t.text);
            w.bar(QRectF(line_->width() - px(240), px(20), px(220), px(8)),
                  static_cast<double>(filled_) / static_cast<double>(filling_.size()), t.wait,
                  t.raised);
            return;
        }
        if (opening() || saving()) {
            const qint64 all = progress_->all, done = progress_->done;
            w.sign(QRectF(px(10), px(11), px(22), px(22)), Sign::Wait, t.wait);
            const QString name = QFileInfo(opening() ? wanted_ : file_).fileName();
            w.data(QRectF(px(42), px(4), line_->width() - px(300), line_->height() - px(4)),
                   opening() ? word("%1 is being read: the place answers slowly").arg(name)
                             : word("%1 is being written: the place answers slowly").arg(name),
                   lettering(15), t.text);
            w.bar(QRectF(line_->width() - px(240), px(20), px(220), px(8)),
                  all > 0 ? static_cast<double>(done) / static_cast<double>(all) : 0, t.wait,
                  t.raised);
            return;
        }
        const int here = edit_->textCursor().blockNumber() + 1;
        const Fault* shown = nullptr;  // that of this line, else the first one
        for (const Fault& one : faults_)
            if (!shown || (one.line == here && shown->line != here)) shown = &one;
        const QRectF place(line_->width() - px(200), px(4), px(190), line_->height() - px(4));
        w.text(place,
               word("line %1, column %2")
                   .arg(here + part_.line)
                   .arg(edit_->textCursor().positionInBlock() + 1),
               lettering(14), t.dim, Qt::AlignRight | Qt::AlignVCenter);
        if (!part_.whole()) {
            w.sign(QRectF(px(10), px(11), px(22), px(22)), Sign::Note, t.accent);
            w.data(QRectF(px(42), px(4), place.left() - px(52), line_->height() - px(4)),
                   word("A part of a long program: lines %1 to %2, %3 % of it. «Check, waits» "
                        "looks for faults in all of it.")
                       .arg(part_.line + 1)
                       .arg(part_.line + edit_->document()->blockCount())
                       .arg(100.0 * static_cast<double>(part_.to - part_.from) /
                                static_cast<double>(std::max<qint64>(1, part_.all)),
                            0, 'f', 1),
                   lettering(15), t.text);
            return;
        }
        const Sign sign = !failure_.isEmpty() ? Sign::Warning
                          : checking()        ? Sign::Wait
                          : !shown            ? Sign::Good
                          : shown->error      ? Sign::Alarm
                                              : Sign::Warning;
        const QColor colour = !failure_.isEmpty() ? t.warn
                              : checking()        ? t.wait
                              : !shown            ? t.good
                              : shown->error      ? t.bad
                                                  : t.warn;
        w.sign(QRectF(px(10), px(11), px(22), px(22)), sign, colour);
        w.data(QRectF(px(42), px(4), place.left() - px(52), line_->height() - px(4)),
               !failure_.isEmpty() ? failure_
               : shown             ? (shown->line > 0
                                          ? QString("%1:%2  ").arg(shown->line).arg(shown->column)
                                          : QString()) +  // of another program: its text names the place
                             shown->number +
                             "  " + shown->text
               : checking() ? word("The program is being read")
                            : word("No faults found"),
               lettering(15), t.text);
    };
}

EditorPage::~EditorPage() {
    // taking the colours off counts as a change of the text
    edit_->disconnect(this);
    colours_.reset();
    if (process_) {
        process_->disconnect();
        process_->kill();
        process_.release()->deleteLater();
    }
    // Whoever comes late removes it, even when this page is gone.
    if (!temporary_.isEmpty())
        dropping_.start(
            [copy = temporary_](const std::atomic<bool>&) { return QFile::remove(copy); });
}

std::vector<Sheet*> EditorPage::sheets() {
    if (over_) return over_->sheets();
    return keyboard_ ? std::vector<Sheet*>{line_, pad_} : std::vector<Sheet*>{line_};
}

// A copy beside the program, so that its subprograms are found; elsewhere when nothing may be
// written there.
void EditorPage::check() {
    if (file_.isEmpty()) return;
    // the one that runs ends first
    if (process_ || copying_.busy()) return wait_.start(kPauseMs);
    if (changed()) keepDraft(draft().written());
    if (!part_.whole()) return line_->refresh();  // half a program has faults that it has not
    const QFileInfo info(file_);                  // the path alone: nothing asks the disk
    const QString name =
        QString("/.check-%1-%2").arg(QCoreApplication::applicationPid()).arg(info.fileName());
    const QStringList places{info.absolutePath() + name, QDir::tempPath() + name};
    copying_.start([places, bytes = bytes(), program = info.absoluteFilePath(),
                    known = job_](const std::atomic<bool>& stop) {
        for (const QString& place : places) {
            QFile copy(place);
            const bool written =
                copy.open(QIODevice::WriteOnly) && copy.write(bytes) == bytes.size();
            copy.close();
            if (written && !stop) return Checked{place, jobOfProgram(program, known)};
            QFile::remove(place);
        }
        return Checked();
    });
    if (const auto copy = copying_.take()) startCheck(*copy);
    line_->refresh();
}

void EditorPage::drop(const QString& copy) {
    if (!copy.isEmpty())
        dropping_.start([copy](const std::atomic<bool>&) { return QFile::remove(copy); }, 0);
}

void EditorPage::startCheck(const Checked& what) {
    temporary_ = what.copy;
    if (!what.job.program.isEmpty()) job_ = what.job;
    if (temporary_.isEmpty()) return void(failure_ = word("The program cannot be checked here."));
    out_.clear();
    process_ = std::make_unique<QProcess>();
    process_->setStandardErrorFile(QProcess::nullDevice());
    QObject::connect(process_.get(), &QProcess::readyReadStandardOutput, this,
                     [this] { out_ += process_->readAllStandardOutput(); });
    QObject::connect(process_.get(), &QProcess::finished, this, [this] {
        out_ += process_->readAllStandardOutput();
        finish();
    });
    QObject::connect(process_.get(), &QProcess::errorOccurred, this,
                     [this](QProcess::ProcessError error) {
                         if (error == QProcess::FailedToStart) {
                             failure_ = word("The program polyturn is not beside the HMI.");
                             finish();
                         }
                     });
    QStringList arguments{"check", "--quiet"};
    if (what.job.job.isEmpty()) {
        const unsigned channel = channelOfFile();
        arguments << QString("%1=%2").arg(channel).arg(temporary_);
        if (!language_.isEmpty())
            arguments << "--language" << QString("%1=%2").arg(channel).arg(language_);
    } else {  // waits and spindles of the other channels count
        arguments << what.job.job << "--instead" << file_ + "=" + temporary_;
    }
    if (context_.live.connected())
        arguments << "--like" << QString::fromStdString(context_.live.instance());
    process_->start(QCoreApplication::applicationDirPath() + "/polyturn", arguments);
    line_->refresh();
}

// Of a program that no job beside it has: in which it is selected, else that of the keys.
unsigned EditorPage::channelOfFile() const {
    const auto selected = [&](unsigned channel) {
        const auto& programs = context_.live.view(channel).programs;
        return !programs.empty() &&
               QFileInfo(QString::fromStdString(programs[0])).absoluteFilePath() ==
                   QFileInfo(file_).absoluteFilePath();
    };
    if (!context_.live.connected() || selected(context_.channel)) return context_.channel;
    for (const unsigned channel : context_.live.channels())
        if (selected(channel)) return channel;
    return context_.channel;
}

void EditorPage::finish() {
    if (!process_) return;
    process_.release()->deleteLater();
    drop(temporary_);
    const QString name = QFileInfo(temporary_).fileName();
    temporary_.clear();
    faults_.clear();
    for (const QByteArray& line : out_.split('\n')) {
        const QJsonObject event = QJsonDocument::fromJson(line).object();
        if (event.value("ev").toString() != "alarm" || faults_.size() >= 200) continue;
        const bool own = QFileInfo(event.value("file").toString()).fileName() == name;
        const QString number = event.value("number").isString()
                                   ? event.value("number").toString()
                                   : QString::number(event.value("number").toInt());
        Fault fault{own ? event.value("line").toInt() : 0, event.value("column").toInt(),
                    event.value("severity").toString() != "warning", number,
                    retold(number, event.value("text").toString()).text};
        if (!own && event.contains("file"))
            fault.text = QString("%1:%2  ")
                             .arg(QFileInfo(event.value("file").toString()).fileName())
                             .arg(event.value("line").toInt()) +
                         fault.text;
        faults_.push_back(fault);
    }
    // other programs of the job come behind
    std::stable_partition(faults_.begin(), faults_.end(),
                          [](const Fault& one) { return one.line > 0; });
    mark();
    if (context_.keysChanged) context_.keysChanged();
}

// A wavy line under the word at the column; without a column under the whole line.
void EditorPage::mark() {
    QList<QTextEdit::ExtraSelection> marks;
    for (const Fault& fault : faults_) {
        const QTextBlock block = edit_->document()->findBlockByNumber(fault.line - 1);
        if (fault.line < 1 || !block.isValid()) continue;
        QTextEdit::ExtraSelection one;
        one.cursor = QTextCursor(block);
        const QString text = block.text();
        const int from =
            fault.column > 0 ? std::min<int>(fault.column - 1, static_cast<int>(text.size())) : 0;
        int to = from + 1;
        while (to < text.size() && fault.column > 0 && !text[to].isSpace() && !text[to].isLetter())
            ++to;
        if (fault.column <= 0) to = static_cast<int>(text.size());
        one.cursor.setPosition(block.position() + from);
        one.cursor.setPosition(block.position() + std::min<int>(to, static_cast<int>(text.size())),
                               QTextCursor::KeepAnchor);
        one.format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        one.format.setUnderlineColor(fault.error ? theme().bad : theme().warn);
        one.format.setBackground(QColor(fault.error ? theme().bad.red() : theme().warn.red(),
                                        fault.error ? theme().bad.green() : theme().warn.green(),
                                        fault.error ? theme().bad.blue() : theme().warn.blue(),
                                        50));
        marks.push_back(one);
    }
    edit_->setExtraSelections(marks);
    line_->refresh();
}

void EditorPage::goToFault(int step) {
    const int here = edit_->textCursor().blockNumber() + 1;
    const Fault* next = nullptr;
    for (const Fault& one : faults_)
        if (one.line > 0 && (step > 0 ? one.line > here && (!next || one.line < next->line)
                                      : one.line < here && (!next || one.line > next->line)))
            next = &one;
    for (const Fault& one : faults_)
        if (!next && one.line > 0) next = &one;
    if (!next) return;
    QTextCursor cursor(edit_->document()->findBlockByNumber(next->line - 1));
    cursor.movePosition(QTextCursor::Right, QTextCursor::MoveAnchor, std::max(0, next->column - 1));
    edit_->setTextCursor(cursor);
    edit_->centerCursor();
}

void EditorPage::refresh() {
    const Theme& t = theme();
    take();
    QPalette colours = edit_->palette();
    // white may be the palette's own from the start
    if (!dressed_ || colours.color(QPalette::Base) != t.card) {
        dressed_ = true;
        colours.setColor(QPalette::Base, t.card);
        colours.setColor(QPalette::Text, t.text);
        colours.setColor(QPalette::Highlight, t.accent);
        colours.setColor(QPalette::HighlightedText, t.onAccent);
        edit_->setPalette(colours);
        edit_->setFont(lettering(17, false, Face::Program));
        setFingerBars(*edit_);
    }
    if (colours_) {
        const QWidget* seen = edit_->viewport();
        colours_->see(edit_->cursorForPosition({0, 0}).blockNumber(),
                      edit_->cursorForPosition({0, seen->height() - 1}).blockNumber());
    }
    for (Sheet* one : sheets()) one->refresh();
}

void EditorPage::layOver(EditorOverlay* over) {
    over->hide();
    over->onClose = [this] { show(nullptr); };
    // As typed: it can be taken back in one step.
    over->onWrite = [this](const std::vector<forms::LineChange>& changes) {
        QTextCursor cursor(edit_->document());
        cursor.beginEditBlock();
        int moved = 0;
        for (const forms::LineChange& one : changes) {
            const QTextBlock block = edit_->document()->findBlockByNumber(one.at + moved);
            cursor.setPosition(block.isValid() ? block.position()
                                               : edit_->document()->characterCount() - 1);
            if (one.inserts) {
                const bool behind = !block.isValid();
                cursor.insertText(behind ? "\n" + QString::fromStdString(one.text)
                                         : QString::fromStdString(one.text) + "\n");
                ++moved;
            } else if (one.removes) {
                cursor.movePosition(QTextCursor::NextBlock, QTextCursor::KeepAnchor);
                cursor.removeSelectedText();
                --moved;
            } else {
                cursor.movePosition(QTextCursor::EndOfBlock, QTextCursor::KeepAnchor);
                cursor.insertText(QString::fromStdString(one.text));
            }
        }
        cursor.endEditBlock();
        if (!changes.empty())
            edit_->setTextCursor(
                QTextCursor(edit_->document()->findBlockByNumber(changes.front().at)));
    };
}

void EditorPage::show(EditorOverlay* over) {
    if (over_) over_->hide();
    over_ = over;
    if (over_) {
        layOut();
        over_->show();
        over_->raise();
        over_->refresh();
    } else
        edit_->setFocus();
    if (context_.keysChanged) context_.keysChanged();
}

void EditorPage::openForm() {
    const QStringList lines = edit_->toPlainText().split('\n');
    const int cursor = edit_->textCursor().blockNumber();
    forms::Dialect dialect = formDialect(context_.live, context_.channel, language_);
    if (countsInches(context_.live, context_.channel, language_, lines, cursor))
        dialect.count_inches();
    if (form_->open(lines, cursor, dialect))
        show(form_);
    else
        context_.tell(word("This language has no cycles."), Told::Refused);
}

void EditorPage::openContour() {
    const QStringList lines = edit_->toPlainText().split('\n');
    const int cursor = edit_->textCursor().blockNumber();
    contour::Writing writing = contourWriting(context_.live, context_.channel, language_);
    if (countsInches(context_.live, context_.channel, language_, lines, cursor)) {
        writing.inch = true;
        writing.decimals = std::min(writing.decimals + 1, 6);
    }
    contour_->open(lines, cursor, writing);
    show(contour_);
}

void EditorPage::showSample(int number, bool keys) {
    const char* const kPlaces[] = {"G71", "G0", "(CONTOUR DIA", "G71"};
    const QTextCursor found = edit_->document()->find(kPlaces[std::clamp(number, 0, 3)]);
    edit_->setTextCursor(found.isNull() ? QTextCursor(edit_->document()) : found);
    keyboard_ = keys;
    layOut();
    if (number == 3) return show(nullptr);
    if (number == 2) return openContour();
    openForm();
    if (number == 0) form_->table().choose(4);
}

bool EditorPage::key(QKeyEvent* event) {
    // nothing reaches the text below
    if (over_) {
        over_->key(event);
        return true;
    }
    if (event->modifiers() & Qt::ControlModifier && event->key() == Qt::Key_S) {
        save();
        return true;
    }
    if (opening() && event->key() == Qt::Key_Escape) {
        stop();
        return true;
    }
    if (!edit_->hasFocus()) {
        edit_->setFocus();
        QCoreApplication::sendEvent(edit_, event);
        return true;
    }
    return false;  // the editor takes it itself
}

void EditorPage::resizeEvent(QResizeEvent*) { layOut(); }

void EditorPage::layOut() {
    const int edge = px(8), line = px(44), pad = keyboard_ ? px(260) : 0;
    const int numbers = px(64);
    numbers_->setGeometry(edge, 0, numbers, height() - line - pad - edge);
    edit_->setGeometry(edge + numbers, 0, width() - 2 * edge - numbers,
                       height() - line - pad - edge);
    line_->setGeometry(edge, height() - line - pad - edge, width() - 2 * edge, line);
    pad_->setGeometry(edge, height() - pad, width() - 2 * edge, std::max(0, pad - edge));
    pad_->setVisible(keyboard_);
    form_->setGeometry(rect());
    contour_->setGeometry(rect());
}

void EditorPage::addKeys(std::vector<SoftKey>& keys) {
    if (over_) return over_->addKeys(keys);
    bool runs = false;  // this very file is in use
    for (const unsigned channel : context_.live.channels()) {
        const auto state = static_cast<ChannelState>(context_.live.channel(channel).state);
        if (state != ChannelState::Running && state != ChannelState::Held &&
            state != ChannelState::Waiting)
            continue;
        for (const std::string& one : context_.live.view(channel).programs)
            runs |=
                QString::fromStdString(one) == file_ || QString::fromStdString(one) == canonical_;
    }
    bool faults = false;
    for (const Fault& one : faults_) faults |= one.line > 0;
    if (opening() || saving())
        return keys.push_back({word("Stop"), [this] { stop(); }, Sign::Stop});
    keys.push_back({word("Save"),
                    [this] { save(); },
                    Sign::Good,
                    changed(),
                    false,
                    false,
                    runs ? word("It runs now: press again") : QString(),
                    {},
                    file_,
                    file_.section('/', -1)});
    keys.push_back({word("Undo"), [this] { edit_->undo(); }, Sign::Undo,
                    edit_->document()->isUndoAvailable()});
    keys.push_back({word("Redo"), [this] { edit_->redo(); }, Sign::Right,
                    edit_->document()->isRedoAvailable()});
    if (part_.whole()) {
        keys.push_back({word("Next fault"), [this] { goToFault(1); }, Sign::Warning, faults});
    } else {
        keys.push_back({word("Part before"), [this] { otherPart(part_.from - kPartBytes); },
                        Sign::Up, part_.from > 0 && !changed()});
        keys.push_back({word("Next part"), [this] { otherPart(part_.to); }, Sign::Down,
                        part_.to < part_.all && !changed()});
    }
    keys.push_back({word("Cycle form"), [this] { openForm(); }, Sign::Tools, true});
    if (part_.whole())
        keys.push_back({word("Contour"), [this] { openContour(); }, Sign::Graphics, true});
    keys.push_back({word("Keyboard"),
                    [this] {
                        keyboard_ = !keyboard_;
                        layOut();
                    },
                    Sign::Key, true, keyboard_});
}

}  // namespace polyturn::hmi
