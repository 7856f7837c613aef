// A program as text: the words of its language in colours, faults under the text as one types
// (`polyturn check` beside the machine), saved whole or not at all. The machine goes on with the
// program that it has read.
//
// Nothing here takes longer than a part of a frame, however long the program is: it is read aside,
// put into the editor piece by piece, and coloured where it is seen. Of a program of more than some
// megabytes a part is edited at a time; saving puts it back into its place.
#pragma once
#include <QJsonObject>
#include <QPlainTextEdit>
#include <memory>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/programs/file_text.hpp"
#include "hmi/machine/programs/job_of_program.hpp"
#include "hmi/screens/programs/program_colours.hpp"
#include "hmi/widgets/text_pad.hpp"

class QProcess;

namespace polyturn::hmi {

class ContourPage;
class CycleFormPage;
class EditorOverlay;

class EditorPage : public QWidget {
public:
    EditorPage(Context& context, QWidget* parent);
    ~EditorPage() override;
    // Read aside: what takes longer than a frame shows how far it is and can be stopped. False: it
    // cannot be opened, as has been reported.
    bool open(const QString& file, const QString& language);
    // that part, with the cursor there
    bool open(const QString& file, const QString& language, qint64 at, int position);
    void goToLine(int line);  // when it has been read, where that is still being done
    bool opening() const { return reading_.busy() || !filling_.isEmpty(); }
    bool saving() const { return writing_.busy(); }
    void stop();                        // the reading or writing
    void follow() { take(); }           // each frame, shown or not
    std::function<void()> onNotOpened;  // what was being read is no text, or was stopped
    bool changed() const { return edit_->document()->isModified(); }
    const QString& file() const { return file_; }
    const FilePart& part() const { return part_; }  // of the file: that is edited
    Draft draft() const;
    void openDraft(const Draft& draft);  // as if it had been typed just now
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
    // The contour whose description is at the cursor, or a new one.
    void openContour();
    // for pictures: 0 a form, 1 the list of cycles, 2 the contour, 3 the text, with keys for a
    // finger
    void showSample(int number, bool keys = false);
    bool covered() const { return over_ != nullptr; }
    CycleFormPage& form() { return *form_; }
    ContourPage& contour() { return *contour_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    struct Saved {
        FileOutcome outcome;
        FilePart part;  // where it is now
    };
    void layOut();
    void check();
    void take();  // what workers have done
    bool opened(const FileText& read);
    void begin(const QString& text);  // to put it into the editor
    void fill();                      // as much of it as a frame has time for
    void filled();
    void otherPart(qint64 at);
    QByteArray bytes() const;  // the text as the file has it
    void keepDraft(const QByteArray& bytes);
    void saved(const Saved& done);
    // What is checked: a copy of the text, in the place of its file in the job that has it.
    struct Checked {
        QString copy;
        JobOfProgram job;
    };
    void startCheck(const Checked& what);
    void drop(const QString& copy);  // removes it, aside
    unsigned channelOfFile() const;
    void finish();
    void mark();
    void goToFault(int step);
    void show(EditorOverlay* over);  // null: the text
    void layOver(EditorOverlay* over);

    Context& context_;
    QPlainTextEdit* edit_;
    bool dressed_ = false;  // in the colours and the face of the screens
    FreeSheet *numbers_, *line_;
    TextPad* pad_;
    CycleFormPage* form_;
    ContourPage* contour_;
    EditorOverlay* over_ = nullptr;  // what lies over the text
    std::unique_ptr<ProgramColours> colours_;
    QString file_, language_, temporary_;
    bool keyboard_ = false;
    QTimer wait_;  // after the last letter
    std::unique_ptr<QProcess> process_;
    QByteArray out_;
    std::vector<Fault> faults_;
    QString failure_;
    // what is being read; the open file without links
    QString wanted_, canonical_;
    Aside<FileText> reading_;
    Aside<Saved> writing_;
    // what is being put into the editor; empty: nothing
    QString filling_;
    qsizetype filled_ = 0;  // so much of it is there
    int position_ = 0;      // of the cursor, then
    int lineAt_ = 0;        // or its line; 0: the position
    bool typed_ = false;    // it is no file's: not saved yet
    // of a program that is too long to be edited at once
    static constexpr qint64 kPartBytes = 2'000'000;
    FilePart part_;
    bool dos_ = false;
    Aside<bool> keeping_;     // the draft
    bool kept_ = false;       // one is on the disk
    Aside<Checked> copying_;  // for the check
    JobOfProgram job_;        // as the last check has found it
    Aside<bool> dropping_;
    std::shared_ptr<FileProgress> progress_ = std::make_shared<FileProgress>();
    int savedRevision_ = 0;
};

}  // namespace polyturn::hmi
