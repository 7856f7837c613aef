// Tool offsets and work zeros of a channel: the table's value beside what the machine works with
// now, input, +input, measured input, relative input, zero here, what a setter has touched, undo,
// who has changed it; measured parts. A value counts when the store has answered: it is on disk
// then. A channel that speaks sinumerik has no numbered offsets: in their place are the edges of
// its tools.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/tools/offset_table.hpp"
#include "hmi/screens/tools/offset_entries.hpp"
#include "hmi/screens/tools/parts_page.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class Offsets : public Screen {
public:
    explicit Offsets(Context& context);
    QString title() const override { return word("Offsets"); }
    Sign sign() const override { return Sign::Offsets; }
    const char* name() const override { return "offsets"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override { build(); }
    bool key(QKeyEvent* event) override;
    bool typing() const override { return true; }
    QString state() const override;
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;

    int pages() const override { return 3; }
    HelpTopic help() const override {
        return {"setup.md",
                partsShown_ ? QString("6. Correct from a measured part")
                : zeros_    ? QString("Offsets and zeros")
                            : QString("3. Measure"),
                {}};
    }
    void turnTo(int page) override {
        showParts(page == 2);
        showZeros(page == 1);
    }
    void showParts(bool on);
    PartsPage& parts() { return *parts_; }
    void showZeros(bool zeros);
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }
    // only rows with it: a number, a tool, a name of a tool or a zero
    void find(const QString& text);
    static constexpr int kFindHit = 5000;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    void build();
    void filter();
    void chooseRow(int row);
    void followEdge(const EdgeLine& before);
    void goTo(std::int32_t tool, std::int32_t edge);
    // the table is of the channel that keys speak to
    bool current() const { return values_.channel() == context_.channel; }
    std::optional<OffsetValue> chosen() const;
    Table::Cell cell(int shown, int column) const;
    Table::Cell edgeName(int shown, int column) const;
    void composeSide(Writer& w);
    void askHistory();
    void measure();
    void zeroHere();
    void touched();
    bool mayDelete() const;  // the chosen edge
    void addEdgeKeys(std::vector<SoftKey>& keys);
    void addPatternKey(std::vector<SoftKey>& keys);

    FreeSheet *head_, *find_, *side_;
    Table* table_;
    NumberPad* pad_;
    PartsPage* parts_;
    OffsetTable values_;
    OffsetEntries entries_;
    OffsetHistory history_;  // of the chosen value
    // base_: of edges the base lengths, in the place of their wear
    bool zeros_ = false, partsShown_ = false, base_ = false;
    int wanted_ = 0;  // the row that is chosen, whether it is shown or not
};

}  // namespace polyturn::hmi
