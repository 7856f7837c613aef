// Tool offsets and work zeros of a channel: the table's value beside what the machine works with
// now, input, +input, measured input, relative input, zero here, what a setter has touched, undo,
// who has changed it; measured parts. A value counts when the store has answered: it is on disk
// then. A channel that speaks sinumerik has no numbered offsets: in their place are the edges of
// its tools.
#pragma once
#include "hmi/app/screen.hpp"
#include "hmi/machine/live/changes.hpp"
#include "hmi/machine/tools/edge_words.hpp"
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
    // One value of a table: how it is called in a request, and where it is.
    struct Value {
        QString words;  // «offset L1 3 wear X»
        QString title;
        double present = 0;     // as the store holds it
        unsigned decimals = 3;  // shown; 0 a whole number
        LengthUnit unit;
        bool angle = false, diameter = false;
        int place = -1;  // of its axis in the channel; -1 none
        EdgeLine edge;   // of a tool; tool 0: no edge
        int dp = 0;      // and which value of it
        // a whole edge that was deleted: what it had
        std::vector<std::pair<int, double>> gone = {};
        bool ofEdge() const { return edge.tool != 0; }
        bool wear() const { return ofEdge() ? is_edge_wear(dp) : words.contains(" wear "); }
        QString text(double held) const;
        QString unitText() const;
        // Where it is in the store: the row of the zeros, or the number of the offset and the
        // letter of its field, wear in lower case.
        unsigned channel = 0;
        bool zero = false;
        std::size_t row = 0;
        char field = 0;
    };
    using Undo = Changes<Value, double>;
    void layOut();
    void build();
    void composeSide(Writer& w);
    std::optional<Value> valueAt(int row, int column) const;
    std::optional<Value> chosen() const { return valueAt(table_->row(), table_->column()); }
    void put(const Value& value, double now);
    void add(const Value& value, double delta);                   // to what the store has by then
    void takeBack(const Value& value, double old, double there);  // there: what has been entered
    void enterInStore(const Value& value, QJsonObject entry,
                      const std::function<void(const Answer&)>& done);
    void tellEntered(const Value& value, double old, double now);
    double presentOf(const Value& value) const;
    void measure();
    void zeroHere();
    int probe() const;
    // takes what the tool setter or the workpiece setter has answered
    void touched();
    void relativeZero();   // the relative counter begins to count here
    void relativeInput();  // and what it says goes into the offset
    void entered(const Value& value, const Answer& answer);
    void askHistory();
    void enter(bool added);
    bool appliedNow(const Value& value, double& applied, double& tableSum) const;

    FreeSheet *head_, *find_, *side_;
    Table* table_;
    NumberPad* pad_;
    PartsPage* parts_;
    void askStore(const Value& value, QJsonObject request,
                  const std::function<void(const Answer&)>& done);
    void takeEdges();  // the rows of edges, as tools come and go
    void goTo(std::int32_t tool, std::int32_t edge);
    void newEdge();
    // the chosen edge: the last one of its tool, and not the one in work
    bool mayDelete() const;
    void deleteEdge();
    // all values of an edge at once: none, or those that it had
    void setEdge(const Value& value, bool undone);
    // Which rows of the table are shown, and where the chosen one is among them.
    void filter();
    int rowsInAll() const;
    bool found(int row) const;
    int at(int shown) const {
        return shown >= 0 && shown < static_cast<int>(rows_.size())
                   ? rows_[static_cast<std::size_t>(shown)]
                   : -1;
    }
    void chooseRow(int row);
    bool byEdges() const { return edged_ && !zeros_; }
    int firstColumn() const;
    bool active(int row) const;  // the running block works with it
    // base_: of edges the base lengths, in the place of their wear
    bool zeros_ = false, partsShown_ = false, edged_ = false, base_ = false;
    QString search_;
    std::vector<int> rows_;       // that are shown
    int wanted_ = 0;              // the row that is chosen, whether it is shown or not
    std::uint64_t foundFor_ = 0;  // Live::toolsVersion() that names were looked at
    unsigned built_ = 0;
    std::uint64_t edgesOf_ = 0;  // Live::toolsVersion() that they were taken from
    std::vector<EdgeLine> edges_;
    std::vector<std::size_t> zeroRows_;
    // letter of each column of offsets: X Z R T, wear in lower case
    std::vector<char> fields_;
    std::vector<int> parameters_;  // $TC_DPx of each column of edges
    Undo undo_;
    QString historyOf_;
    QStringList history_;  // of the chosen value, as lines
};

}  // namespace polyturn::hmi
