// Tools: the magazines as pictures, all tools as a list with filters, one tool's data, life and
// forecast, pallets, and what the presetter has measured. A tool is loaded, moved and unloaded by
// dragging it or by keys; it is there when the store confirms it.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/tools/edge_words.hpp"
#include "hmi/screens/tools/presetter_page.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/pictures/magazine.hpp"
#include "hmi/widgets/table.hpp"
#include "hmi/widgets/text_pad.hpp"

namespace polyturn::hmi {

// The list; a row that is pulled to the left is lifted out of it.
class ToolList : public Table {
public:
    using Table::Table;
    std::function<std::int32_t(int row)> toolAt;
    std::function<void(std::int32_t tool)> onLifted;
    std::function<void(std::int32_t tool, const QPoint& global)> onDropped;
    void forgetTouch() override {
        out_ = false;
        lifted_ = 0;
        Table::forgetTouch();
    }

protected:
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    QPointF from_;
    std::int32_t lifted_ = 0;
    bool out_ = false;
};

class Tools : public Screen {
public:
    explicit Tools(Context& context);
    QString title() const override { return word("Tools"); }
    Sign sign() const override { return Sign::Tools; }
    const char* name() const override { return "tools"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override;
    bool key(QKeyEvent* event) override;
    void letGo() override { picture_->carried = 0; }
    bool typing() const override { return true; }
    // The search comes last: it may have blanks. A dash: no pin.
    QString state() const override {
        return QString("%1 %2 %3 %4 %5 ")
                   .arg(static_cast<int>(page_))
                   .arg(picture_->shown())
                   .arg(presetter_->pin().isEmpty() ? QString("-") : presetter_->pin())
                   .arg(tool_)
                   .arg(static_cast<int>(filter_)) +
               search_;
    }
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;
    // the other magazines, what the presetter proposes
    int pages() const override {
        return kPages + std::max(0, static_cast<int>(magazines().size()) - 1) + 1;
    }
    bool busy() const override { return page_ == Page::Presetter && presetter_->busy(); }
    HelpTopic help() const override {
        static constexpr const char* kFind[] = {"2. Enter tools and load them",
                                                "2. Enter tools and load them", "4. Set the life",
                                                "Pallets", "Measure in the presetter"};
        return {"setup.md", kFind[static_cast<std::size_t>(page_)], {}};
    }
    void turnTo(int page) override;

    enum class Page : std::uint8_t { Magazine, Data, Life, Pallets, Presetter };
    enum class Filter : std::uint8_t { All, Here, Nowhere, Replace };
    void showPage(Page page);
    Magazine& picture() { return *picture_; }
    ToolList& list() { return *list_; }
    Table& table() { return *table_; }
    PresetterPage& presetter() { return *presetter_; }
    FreeSheet& head() { return *head_; }
    std::int32_t tool() const { return tool_; }
    int rowOf(std::int32_t tool) const;  // in the list; -1: filtered away
    static int magazineHit(std::int32_t magazine) { return 1000 + magazine; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    bool followPlace();
    void fillList();
    void fillData();
    void takeEdgeRows();
    Table::Cell edgeCell(std::size_t row, int column) const;
    static int shownFields();  // rows before those of edges
    // the chosen one is of an edge, or names the offset
    bool rowOfOffsets() const;
    void toOffsets();
    void fillLife();
    void fillPallets();
    void askProgram();
    void look();  // asks for the report or the pallets again
    void composeHead(Writer& w);
    void composeDetail(Writer& w);
    void composeSide(Writer& w);
    void chooseTool(std::int32_t tool);
    void carry(std::int32_t tool);
    void putDown(const ToolPlace* place);
    void dropped(std::int32_t tool, const QPoint& global);
    void unload();
    void newInsert();
    unsigned channelOf(const ToolRow& row) const;
    struct Shown;
    static const Shown kShown[];
    void setField(const char* field, const QString& value);
    void addToField(const Shown& one, double delta);
    void fieldActivated();
    void addTool();
    void nextFilter();
    bool passes(std::int32_t number, const ToolRow& tool) const;
    static constexpr int kPages = 5;
    std::vector<std::int32_t> magazines() const;
    void showMagazine(std::int32_t magazine);
    const ToolRow* chosen() const { return toolOf(context_.live, tool_); }
    // it has just been made: its row is still on the way to the screens
    bool awaited() const { return tool_ && tool_ == added_; }
    bool textField() const;

    Page page_ = Page::Magazine;
    FreeSheet *head_, *detail_, *side_;
    Magazine* picture_;
    ToolList* list_;
    Table* table_;  // of the other pages
    NumberPad* pad_;
    TextPad* letters_;  // for a finger, while a text is entered
    PresetterPage* presetter_;
    Filter filter_ = Filter::All;
    QString search_, typed_;
    std::vector<std::int32_t> rows_;
    std::int32_t tool_ = 0, added_ = 0;  // added_: by «New tool», the last one
    std::uint64_t version_ = 0;
    struct LifeLine {
        std::int32_t tool = 0;  // 0: the line of a group
        QString group, unit;
        double left = -1, parts = -1, minutes = -1;
        bool first = false;  // it stops the machine first
    };
    std::vector<LifeLine> life_;
    std::vector<std::pair<EdgeLine, int>> edgeRows_;  // of the chosen tool: edge and $TC_DPx
    QString firstToStop_;
    struct Pallet {
        int row = 0;
        QString station, program;
        double number = 0;
    };
    std::vector<Pallet> pallets_;
    QString whyNoPallets_;
    int taken_ = 0;  // row of the pallet that changes places
    qint64 lookAt_ = 0;
};

}  // namespace polyturn::hmi
