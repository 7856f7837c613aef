// Programs and jobs: folders, what is in a job and in a program, selecting for all channels; the synchronised view (channels aligned
// at their waits) and the timeline of a dry run beside the live machine.
#pragma once
#include <QFileInfo>

#include "hmi/app/screen.hpp"
#include "hmi/machine/dry_run.hpp"
#include "hmi/machine/program_text.hpp"
#include "hmi/screens/editor_page.hpp"
#include "hmi/screens/restart_page.hpp"
#include "hmi/widgets/table.hpp"
#include "ipc/text/job.hpp"

namespace polyturn::hmi {

class Programs : public Screen {
public:
    explicit Programs(Desk& desk);
    QString title() const override { return word("Programs"); }
    Sign sign() const override { return Sign::Programs; }
    const char* name() const override { return "programs"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void follow() override { restart_->follow(); }
    bool key(QKeyEvent* event) override;
    QString state() const override { return QString::number(static_cast<int>(page_)) + "|" + chosenPath(); }
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;
    int pages() const override { return job_ || (page_ != Page::Files && page_ != Page::Restart) ? 7 : 1; }
    HelpTopic help() const override { return page_ == Page::Restart ? HelpTopic{"operator.md", "Beginning in the middle", {}} : page_ == Page::Together ? HelpTopic{"programmer.md", "Waiting", {}} : HelpTopic{"operator.md", "Programs:", {}}; }
    void turnTo(int page) override;
    bool busy() const override { return dry_.running() || (page_ == Page::Edit && editor_->checking()); }
    Table& files() { return *files_; }
    EditorPage& editor() { return *editor_; }
    RestartPage& restartPage() { return *restart_; }
    const DryRun& dryRun() const { return dry_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    enum class Page : std::uint8_t { Files, Together, Time, Restart, Edit };
    void layOut();
    void readFolder(const QString& folder, const QString& choose = {});
    QString chosenPath() const;
    void open();
    void select();
    void edit();
    void print();
    void preview();
    void composePreview(Writer& w);
    void composeTogether(Writer& w);
    void composeTime(Writer& w);
    void composeFaults(Writer& w, const QRectF& box);
    void show(Page page);
    void look(DryRun::How how);

    Page page_ = Page::Files;
    Table* files_;
    FreeSheet *head_, *preview_, *view_;
    RestartPage* restart_;
    EditorPage* editor_;
    std::vector<QFileInfo> entries_;
    std::unique_ptr<text::Job> job_;         // of the chosen file, when it is one
    QString jobFault_, wanted_;              // wanted_: of a check or dry run
    ProgramText texts_;
    DryRun dry_;
    int scroll_ = 0;
    qint64 lookedMs_ = 0;
};

}  // namespace polyturn::hmi
