// What the machine is like inside: signals by name, axes and drives, couplings and since when,
// variables of the channels, timers and counters, processes with the computing time of ticks, the
// scope and the circularity plot.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/live_totals.hpp"
#include "hmi/screens/machine/scope_page.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class Diagnosis : public Screen {
public:
    explicit Diagnosis(Context& context);
    QString title() const override { return word("Diagnosis"); }
    Sign sign() const override { return Sign::Diagnosis; }
    const char* name() const override { return "diagnosis"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void follow() override;
    void rebuilt() override;
    bool key(QKeyEvent* event) override;
    bool typing() const override {
        return page_ == Page::Signals || page_ == Page::Variables || page_ == Page::Scope;
    }
    QString state() const override {
        return QString("%1 %2 %3").arg(static_cast<int>(page_)).arg(table_->row()).arg(search_);
    }
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;
    // behind the pages the circularity plot, the scope's list of signals, its trigger level
    int pages() const override { return 10; }
    HelpTopic help() const override;
    void turnTo(int page) override;
    bool busy() const override { return page_ == Page::Scope && scope_->judging(); }

    enum class Page : std::uint8_t {
        Signals,
        Axes,
        Couplings,
        Variables,
        Counters,
        Processes,
        Scope
    };
    void showPage(Page page);
    void find(const QString& text);  // signals or variables with it in their name or meaning
    Table& table() { return *table_; }
    ScopePage& scope() { return *scope_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    void fillSignals();
    void fillAxes();
    Table::Cell spindleCell(std::uint32_t number, int column) const;
    void fillCouplings();
    void fillVariables();
    void fillCounters();
    void fillProcesses();
    void composeHead(Writer& w);
    void composeTicks(Writer& w);

    FreeSheet* head_;
    Table* table_;
    FreeSheet* detail_;
    ScopePage* scope_;
    Page page_ = Page::Signals;
    struct SignalLine {
        QString name;
        QString meaning, english;  // in the language shown, and as builders' documents have it
        std::uint32_t slot;
        bool plc, isRegister;
    };
    std::vector<SignalLine> signals_, found_;
    QString search_;
    qint64 ticksAt_ = 0;  // the histogram is written anew
    LiveTotals totals_;
};

}  // namespace polyturn::hmi
