// Programs and jobs: folders, what is in a job and in a program, selecting for all channels; the
// synchronised view (channels aligned at their waits) and the timeline of a dry run beside the live
// machine.
#pragma once
#include <QFileInfo>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/programs/aligned_job.hpp"
#include "hmi/machine/programs/dry_run.hpp"
#include "hmi/machine/programs/file_work.hpp"
#include "hmi/machine/programs/program_text.hpp"
#include "hmi/screens/overview/restart_page.hpp"
#include "hmi/screens/programs/compare_page.hpp"
#include "hmi/screens/programs/editor_page.hpp"
#include "hmi/screens/programs/files_page.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class Programs : public Screen {
public:
    explicit Programs(Context& context);
    ~Programs() override;
    QString title() const override { return word("Programs"); }
    Sign sign() const override { return Sign::Programs; }
    const char* name() const override { return "programs"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void follow() override {
        files_->follow();
        restart_->follow();
        editor_->follow();
        openPlace();
        lookSaved();
        takePrint();
        takeSelected();
        keepRun();
    }
    bool key(QKeyEvent* event) override;
    bool typing() const override {
        return page_ == Page::Edit || (page_ == Page::Files && files_->naming());
    }
    QString state() const override;
    void restore(const QString& state) override;
    void leave() override {
        context_.draft = editor_->draft();
        restart_->keep();
    }
    std::vector<Sheet*> sheets() override;
    int pages() const override {
        return files_->sheet() || (page_ != Page::Files && page_ != Page::Restart) ? 12 : 1;
    }
    HelpTopic help() const override;
    void turnTo(int page) override;
    bool busy() const override {
        return dry_.running() || compare_->busy() ||
               (page_ == Page::Edit && (editor_->opening() || editor_->checking()));
    }
    Table& files() { return files_->files(); }
    FilesPage& filesPage() { return *files_; }
    ComparePage& comparePage() { return *compare_; }
    EditorPage& editor() { return *editor_; }
    RestartPage& restartPage() { return *restart_; }
    const DryRun& dryRun() const { return dry_; }
    FreeSheet& picture() { return *view_; }   // the synchronised view, the timeline
    int firstRow() const { return scroll_; }  // of the synchronised view

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    enum class Page : std::uint8_t { Files, Together, Time, Restart, Edit, Compare };
    static constexpr double kTogetherRow = 24;
    void layOut();
    void select();
    void edit();
    void openPlace();  // that another screen has named, as soon as its folder is read
    void print();
    void takePrint();
    void takeSelected();
    // enters the zeros and offsets of the chosen job, or takes that back
    std::optional<SoftKey> jobEntriesKey();
    void enterJob(const JobSheet& sheet, const std::vector<JobEntry>& entries);
    void takeJobBack();
    void composeTogether(Writer& w);
    void composeTime(Writer& w);
    void composeFaults(Writer& w, const QRectF& box);
    void alignJob();
    QString waitName(unsigned channel, int code) const;
    // a run that is over; and brings back that of before a restart
    void keepRun();
    void show(Page page);
    void look(DryRun::How how);
    void lookSaved();
    DryRun::Wanted wantedHere() const;
    QString languageOf(const QString& program) const;

    Page page_ = Page::Files;
    FreeSheet *head_, *view_;
    FilesPage* files_;
    ComparePage* compare_;
    RestartPage* restart_;
    EditorPage* editor_;
    DryRun::Wanted wanted_;                 // of a check or dry run
    bool opensPlace_ = false;               // the folder of a place is being read
    std::optional<DryRun::How> afterSave_;  // that waits for the text to be written
    ProgramText texts_;
    Aside<FileOutcome> printing_;  // the setup sheet
    QString printed_;
    // what the job that has just been selected has otherwise, by its files as they are now
    Aside<JobSheet> selected_;
    // what has been entered so, and what stood there before
    std::vector<JobEntry> jobEntered_;
    std::shared_ptr<const JobSheet> jobEnteredOf_;  // of which job
    DryRun dry_;
    AlignedJob aligned_;
    std::uint64_t alignedVersion_ = ~0ull, timeVersion_ = ~0ull;  // of the run: that they show
    qint64 alignAt_ = 0;
    std::uint64_t keptVersion_ = 0;  // of the run that is kept
    bool back_ = false;              // the run of before a restart is to be shown
    int scroll_ = 0;
    double scrolled_ = 0;  // pixels of a finger that are no row yet
};

}  // namespace polyturn::hmi
