// Folders, USB and network places: their content, what is in a job or a program, and what is
// done with files: copied with a checksum, compared, protected, renamed, deleted. Reading and
// writing is done by workers; the screen only shows how far they are.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/programs/file_work.hpp"
#include "hmi/machine/programs/setup_sheet.hpp"
#include "hmi/widgets/table.hpp"
#include "hmi/widgets/text_pad.hpp"

namespace polyturn::hmi {

class FilesPage : public QWidget {
public:
    FilesPage(Context& context, QWidget* parent);
    void refresh();
    bool key(QKeyEvent* event);
    void addMenuKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets();
    Table& files() { return *files_; }
    TextPad& pad() { return *pad_; }

    void follow() { take(); }  // what was read or done aside has come, whatever screen is shown
    void readFolder(const QString& folder, const QString& choose = {});
    void readAgain() { readFolder(context_.folder, chosen() ? chosen()->name : QString()); }
    void showPlaces();
    bool atPlaces() const { return placesShown_; }
    void open();                      // the chosen folder or place
    const FileEntry* chosen() const;  // nullptr: nothing, or places are shown
    QString chosenPath() const;
    bool isFile() const { return chosen() && !chosen()->folder; }
    bool isFolder() const { return placesShown_ || (chosen() && chosen()->folder); }
    bool isJob() const { return chosen() && chosen()->job; }
    const std::vector<FileEntry>& entries() const { return entries_; }
    // of the chosen job; nullptr: it is being read, or is none
    const JobSheet* sheet() const { return preview_.sheet.get(); }
    // the chosen file is protected; empty: it may be edited
    QString whyNotChanged() const;
    QString where() const;  // for the head

    bool menu() const { return menu_; }
    void showMenu(bool on);
    bool working() const { return worker_.busy(); }
    bool reading() const { return reader_.busy(); }
    const FileOutcome& outcome() const { return outcome_; }
    bool naming() const { return naming_ != Naming::None; }
    std::function<void(const QString& left, const QString& right)> onCompare;
    void newProgram(const QString& language);  // its name is asked for; pressed again it is not
    std::function<void(const QString& path)> onCreated;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    enum class Naming : std::uint8_t { None, Rename, Folder, Program };
    struct Preview {
        QString path, fault;
        std::shared_ptr<JobSheet> sheet;  // of a job that can be read
        std::vector<bool> there;          // of its programs
        QStringList lines;
        bool readable = true;
    };
    static Preview readPreview(const QString& path, bool job, DisplayLanguage display_language,
                               const std::string& machine);
    void nameColumns();
    void layOut();
    void take();  // what workers have brought
    void fill(FolderList list, bool previewStays);
    void watch();  // the folder may change behind the screens: a stick, a saving, another computer
    void look();   // at the chosen file
    void composePreview(Writer& w);
    void composeJob(Writer& w, double y);
    // of the setup sheet: how high it is, and what writes it there
    struct SheetLine {
        int high = 0;
        std::function<void(double y)> write;
        bool head = false;  // not the last one of a page
    };
    std::vector<SheetLine> sheetLines(Writer& w);
    void turnSheet();  // to the page behind, from the last to the first
    void composeState(Writer& w);
    void start(const QString& what, std::function<FileOutcome(const std::atomic<bool>&)> work);
    void put();
    QString target() const;  // where the taken file goes
    void protectNext();
    void name(Naming what);
    void named();
    void create(const QString& typed);

    Context& context_;
    Table* files_;
    FreeSheet *view_, *state_;
    TextPad* pad_;
    std::vector<FileEntry> entries_;
    std::vector<Place> places_;
    bool placesShown_ = false, menu_ = false, readable_ = true;
    QString choose_, taken_, doing_, name_;
    QString language_, created_;  // of a new program; its path while it is being made
    Naming naming_ = Naming::None;
    Preview preview_;
    std::size_t sheetPage_ = 0, sheetPages_ = 1;
    Aside<FolderList> reader_, watcher_;
    qint64 watchAt_ = 0;
    Aside<Preview> looker_;
    Aside<FileOutcome> worker_;
    std::shared_ptr<FileProgress> progress_;
    FileOutcome outcome_;
    bool told_ = false;
    int level_ = 3;  // of who works here
    qint64 lookAt_ = 0;
};

}  // namespace polyturn::hmi
