// How a program comes into the editor and goes back to its file, and what is kept of it meanwhile
// (see EditorPage).
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QTextBlock>
#include <algorithm>

#include "hmi/screens/programs/editor_overlay.hpp"
#include "hmi/screens/programs/editor_page.hpp"

namespace polyturn::hmi {
namespace {

constexpr qint64 kMostBytes = 4'000'000;   // is edited at once
constexpr qsizetype kFillLetters = 8'192;  // put into the editor at a time
constexpr int kFillMs = 8;                 // of a frame

}  // namespace

bool EditorPage::open(const QString& file, const QString& language) {
    return open(file, language, 0, 0);
}

bool EditorPage::open(const QString& file, const QString& language, qint64 at, int position) {
    if (writing_.busy()) {
        context_.tell(word("The last program is still being written."), Told::Refused);
        return false;
    }
    wanted_ = file;
    file_.clear();
    canonical_.clear();
    filling_.clear();
    language_ = language;
    position_ = position;
    lineAt_ = 0;
    typed_ = false;
    faults_.clear();
    failure_.clear();
    edit_->clear();
    edit_->document()->setModified(false);
    edit_->setReadOnly(true);
    show(nullptr);
    keepDraft({});
    progress_ = std::make_shared<FileProgress>();
    reading_.start([file, at, progress = progress_](const std::atomic<bool>& stop) {
        return readPart(file, kMostBytes, kPartBytes, at, *progress, stop);
    });
    if (const auto read = reading_.take()) return opened(*read);
    line_->refresh();
    if (context_.keysChanged) context_.keysChanged();
    return true;
}

void EditorPage::goToLine(int line) {
    if (opening()) {
        lineAt_ = line;
        return;
    }
    QTextCursor cursor(edit_->document()->findBlockByNumber(
        std::clamp(line - 1, 0, edit_->document()->blockCount() - 1)));
    edit_->setTextCursor(cursor);
    edit_->centerCursor();
}

bool EditorPage::opened(const FileText& read) {
    edit_->setReadOnly(false);
    if (read.kind != FileText::Kind::Read) {
        if (read.kind == FileText::Kind::NoText)
            context_.tell(word("It is no text in UTF-8: it cannot be edited without a loss."),
                          Told::Refused);
        else if (read.kind != FileText::Kind::Stopped)
            context_.tell(word("It cannot be shown."), Told::Refused);
        return false;
    }
    canonical_ = read.path;
    part_ = read.part;
    dos_ = read.dos;
    begin(read.text);
    return true;
}

void EditorPage::begin(const QString& text) {
    colours_.reset();
    edit_->clear();
    colours_ = std::make_unique<ProgramColours>(edit_->document(), language_);
    edit_->document()->setUndoRedoEnabled(false);
    edit_->setReadOnly(true);
    filling_ = text;
    filled_ = 0;
    if (text.isEmpty()) return filled();
    fill();
}

void EditorPage::fill() {
    QElapsedTimer time;
    time.start();
    QTextCursor end(edit_->document());
    while (filled_ < filling_.size() && time.elapsed() < kFillMs) {
        const qsizetype to = std::min(filled_ + kFillLetters, filling_.size());
        end.movePosition(QTextCursor::End);
        end.insertText(filling_.mid(filled_, to - filled_));
        filled_ = to;
    }
    if (filled_ == filling_.size())
        filled();
    else
        line_->refresh();
}

void EditorPage::filled() {
    filling_.clear();
    QTextCursor cursor(edit_->document());
    cursor.setPosition(
        std::clamp(position_, 0, std::max(0, edit_->document()->characterCount() - 1)));
    edit_->setTextCursor(cursor);
    if (position_ > 0) edit_->centerCursor();
    edit_->document()->setUndoRedoEnabled(true);
    edit_->document()->setModified(typed_);
    edit_->setReadOnly(false);
    file_ = wanted_;
    if (const int line = std::exchange(lineAt_, 0)) goToLine(line);
    refresh();
    if (!over_) edit_->setFocus();
    check();
    if (context_.keysChanged) context_.keysChanged();
}

// Where a part ends the next one begins; of the one before only its size is known.
void EditorPage::otherPart(qint64 at) {
    const QString file = file_, language = language_;
    open(file, language, std::clamp<qint64>(at, 0, part_.all - 1), 0);
}

QByteArray EditorPage::bytes() const {
    QString text = edit_->toPlainText();
    if (dos_) text.replace("\n", "\r\n");
    return text.toUtf8();
}

Draft EditorPage::draft() const {
    Draft out;
    if (file_.isEmpty() || !changed()) return out;
    out.file = file_;
    out.canonical = canonical_;
    out.language = language_;
    out.text = edit_->toPlainText();
    out.part = part_;
    out.dos = dos_;
    out.position = edit_->textCursor().position();
    return out;
}

void EditorPage::openDraft(const Draft& draft) {
    reading_.forget();
    wanted_ = draft.file;
    canonical_ = draft.canonical;
    language_ = draft.language;
    part_ = draft.part;
    dos_ = draft.dos;
    position_ = draft.position;
    typed_ = true;
    kept_ = true;
    file_.clear();
    faults_.clear();
    failure_.clear();
    show(nullptr);
    begin(draft.text);
}

// Empty: there is none any more. Aside, for the disk may be slow; the next one comes with the next
// letters.
void EditorPage::keepDraft(const QByteArray& bytes) {
    if (context_.draftFile.isEmpty() || (bytes.isEmpty() && !kept_)) return;
    kept_ = !bytes.isEmpty();
    keeping_.start(
        [file = context_.draftFile, bytes](const std::atomic<bool>& stop) {
            FileProgress progress;
            return bytes.isEmpty() ? QFile::remove(file)
                                   : writeWhole(file, bytes, progress, stop).ok();
        },
        0);
}

void EditorPage::stop() {
    if (opening()) {
        reading_.forget();  // whatever it waits for, it waits alone
        filling_.clear();
        edit_->clear();
        edit_->document()->setUndoRedoEnabled(true);
        edit_->setReadOnly(false);
        if (onNotOpened) onNotOpened();
    } else if (writing_.busy()) {
        // the file that was there stays, unless its last piece has been written
        writing_.forget();
        context_.tell(word("Not saved: stopped. The file is as it was."), Told::Refused);
    }
    if (context_.keysChanged) context_.keysChanged();
}

void EditorPage::save() {
    if (writing_.busy() || file_.isEmpty()) return;
    savedRevision_ = edit_->document()->revision();
    progress_ = std::make_shared<FileProgress>();
    writing_.start([file = file_, bytes = bytes(), part = part_,
                    progress = progress_](const std::atomic<bool>& stop) {
        Saved out{{}, part};
        out.outcome = writePart(file, bytes, out.part, *progress, stop);
        return out;
    });
    take();
    if (context_.keysChanged) context_.keysChanged();
}

// What has been typed since the saving began is not saved.
void EditorPage::saved(const Saved& done) {
    if (!done.outcome.ok())
        return context_.tell(word("Cannot be written: %1").arg(done.outcome.told()), Told::Refused);
    part_ = done.part;
    if (edit_->document()->revision() == savedRevision_) {
        edit_->document()->setModified(false);
        keepDraft({});
    }
    context_.tell(word("Saved: %1").arg(QFileInfo(file_).fileName()), Told::Good);
}

void EditorPage::take() {
    bool any = false;
    if (const auto read = reading_.take()) {
        any = true;
        if (!opened(*read) && onNotOpened) onNotOpened();
    } else if (!filling_.isEmpty()) {
        fill();
    }
    if (keeping_.busy()) (void)keeping_.take();
    if (const auto done = writing_.take()) {
        any = true;
        saved(*done);
    }
    if (const auto copy = copying_.take()) {
        any = true;
        startCheck(*copy);
    }
    (void)dropping_.take();
    if (any && context_.keysChanged) context_.keysChanged();
}

}  // namespace polyturn::hmi
