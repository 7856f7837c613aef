// Alarms with cause, remedy and place: the active ones, and the history; the log of stops.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/screens/machine/stops_page.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class Alarms : public Screen {
public:
    explicit Alarms(Context& context);
    QString title() const override { return word("Alarms"); }
    Sign sign() const override { return Sign::Bell; }
    const char* name() const override { return "alarms"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    bool key(QKeyEvent* event) override;
    QString state() const override {
        return QString("%1 %2").arg(static_cast<int>(page_)).arg(table_->row());
    }
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;
    void rebuilt() override { stops_->rebuilt(); }
    int pages() const override { return 3; }
    HelpTopic help() const override;
    void turnTo(int page) override { showPage(static_cast<Page>(page)); }

    enum class Page : std::uint8_t { Standing, History, Stops };
    void showPage(Page page);
    StopsPage& stops() { return *stops_; }
    const std::vector<AlarmEntry>& rows() const { return rows_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    void fillAlarms();
    const AlarmEntry* chosen() const;  // nullptr: there is none
    void composeDetail(Writer& w);

    FreeSheet* head_;
    Table* table_;
    FreeSheet* detail_;
    StopsPage* stops_;
    Page page_ = Page::Standing;
    std::vector<AlarmEntry> rows_;  // copies: the log goes on
    std::uint64_t version_ = 0;
};

}  // namespace polyturn::hmi
