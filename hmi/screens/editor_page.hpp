// A program as text: the words of its language in colours, faults under the text as one types (`polyturn check` beside the machine), saved
// whole or not at all. The machine goes on with the program that it has read.
#pragma once
#include <QJsonObject>
#include <QPlainTextEdit>
#include <QSyntaxHighlighter>
#include <memory>

#include "hmi/app/screen.hpp"
#include "hmi/machine/aside.hpp"
#include "hmi/machine/file_text.hpp"
#include "hmi/widgets/text_pad.hpp"

class QProcess;

namespace polyturn::hmi {

class ContourPage;
class CycleFormPage;
class EditorOverlay;

// Comments, block numbers, G and M words, tools, variables, words of the language, numbers.
class ProgramColours : public QSyntaxHighlighter {
public:
    ProgramColours(QTextDocument* document, QString language) : QSyntaxHighlighter(document), language_(std::move(language)) {}

protected:
    void highlightBlock(const QString& text) override;

private:
    QString language_;
};

class EditorPage : public QWidget {
public:
    EditorPage(Desk& desk, QWidget* parent);
    ~EditorPage() override;
    // Read aside: what takes longer than a frame shows how far it is and can be stopped. False: it cannot be opened, as has been told.
    bool open(const QString& file, const QString& language);
    bool opening() const { return reading_.busy(); }
    bool saving() const { return writing_.busy(); }
    void stop();                                   // the reading or writing
    void follow() { take(); }                      // each frame, shown or not
    std::function<void()> onNotOpened;             // what was being read is no text, or was stopped
    bool changed() const { return edit_->document()->isModified(); }
    const QString& file() const { return file_; }
    const QString& language() const { return language_; }
    void refresh();
    void addKeys(std::vector<SoftKey>& keys);
    bool key(QKeyEvent* event);
    std::vector<Sheet*> sheets();
    QPlainTextEdit& edit() { return *edit_; }
    struct Fault {
        int line = 0, column = 0;
        bool error = true;
        QString number, text;
    };
    const std::vector<Fault>& faults() const { return faults_; }
    bool checking() const { return process_ != nullptr || copying_.busy() || wait_.isActive(); }
    void save();
    // The cycle at the cursor as a form, or the list of cycles; it lies over the text.
    void openForm();
    // The contour whose description stands at the cursor, or a new one.
    void openContour();
    void showSample(int number);                   // for pictures: 0 a form, 1 the list of cycles, 2 the contour
    bool covered() const { return over_ != nullptr; }
    CycleFormPage& form() { return *form_; }
    ContourPage& contour() { return *contour_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    void check();
    void take();                                   // what workers have done
    bool opened(const FileText& read);
    void saved(const FileOutcome& outcome);
    void startCheck(const QString& copy);
    void drop(const QString& copy);                // removes it, aside
    void finish();
    void mark();
    void goToFault(int step);
    void show(EditorOverlay* over);   // null: the text
    void layOver(EditorOverlay* over);

    Desk& desk_;
    QPlainTextEdit* edit_;
    FreeSheet* line_;
    TextPad* pad_;
    CycleFormPage* form_;
    ContourPage* contour_;
    EditorOverlay* over_ = nullptr;                // what lies over the text
    std::unique_ptr<ProgramColours> colours_;
    QString file_, language_, temporary_;
    bool keyboard_ = false;
    QTimer wait_;                                  // after the last letter
    std::unique_ptr<QProcess> process_;
    QByteArray out_;
    std::vector<Fault> faults_;
    QString failure_;
    QString wanted_, canonical_;                   // what is being read; the open file without links
    Aside<FileText> reading_;
    Aside<FileOutcome> writing_;
    Aside<QString> copying_;                       // for the check
    Aside<bool> dropping_;
    std::shared_ptr<FileProgress> progress_ = std::make_shared<FileProgress>();
    int savedRevision_ = 0;
};

}  // namespace polyturn::hmi
