// Parameters: groups, search by number, name or meaning, bits with their meaning, unit, range,
// effect, what differs from the default or from the machine's file, who has changed what (the
// store's history); the compensation tables. A change counts when the store has it on its disk.
#pragma once
#include <QElapsedTimer>
#include <QJsonArray>
#include <QJsonObject>
#include <optional>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/live/changes.hpp"
#include "hmi/screens/machine/compensation_page.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::hmi {

class Parameters : public Screen {
public:
    explicit Parameters(Context& context);
    QString title() const override { return word("Parameters"); }
    Sign sign() const override { return Sign::Parameters; }
    const char* name() const override { return "parameters"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override {
        const int row = table_->row();
        file_.reset();
        readFile();
        search();
        table_->choose(row);
        if (page_ == Page::Compensation) compensation_->begin();
        if (page_ == Page::History) {
            history_ = {};
            historyAll_ = false;
            askHistory();
        }
    }
    bool key(QKeyEvent* event) override;
    bool typing() const override { return true; }
    QString state() const override;
    void restore(const QString& state) override;
    HelpTopic help() const override;
    std::vector<Sheet*> sheets() override;
    // the list, a parameter of bits, the history, the compensation tables: the first, straightness,
    // a grid
    int pages() const override { return 6; }
    void turnTo(int page) override;
    enum class Page : std::uint8_t { List, History, Compensation };
    void showPage(Page page);
    enum class Only : std::uint8_t { All, Changed, UnlikeFile };
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }
    CompensationPage& compensation() { return *compensation_; }
    int changes() const { return static_cast<int>(history_.size()); }  // that the history shows
    FreeSheet& detail() { return *detail_; }
    void find(const QString& text) {
        search_ = text;
        search();
    }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    struct Line {
        const params::Row* row;
        unsigned instance, element;
    };
    void layOut();
    void search();
    void composeDetail(Writer& w);
    const Line* chosen() const;
    double value(const Line& line) const;
    bool differs(const Line& line) const;
    bool unlikeFile(const Line& line) const;
    QString textIn(const params::Table& table, const Line& line) const;
    void readFile();  // of the machine, aside
    void takeFile();
    void setColumns();
    // The chosen parameter has bits: while nothing is typed they have the room of the keys.
    enum class Bits : std::uint8_t { None, Alone, Typed };
    Bits bitsLook() const;
    static params::Target targetOf(const Line& line);
    static QString textOf(const Line& line, double number);
    QString target(const Line& line) const;
    void put(const Line& line, double now);
    void turnBit(const Line& line, unsigned bit);
    void nextBit(const params::Row& row, int step);
    // What stands there, or is to: numbers are compared as numbers, whatever they are written like.
    struct Content {
        double number = 0;
        QString text;
        bool words = false;  // a parameter of text
    };
    using Undo = Changes<Line, Content>;
    Content contentOf(const Line& line) const;
    // written: another line than the whole value's
    void put(const Line& line, const Content& now, const QString& written = {});
    void askStore(const Line& line, QJsonObject entry, std::optional<Undo::Change> taken);
    void takeBack(const Undo::Change& change);
    void done(const Undo::Change& change, const Answer& answer, bool undone);
    void askText(const Line& line);
    FreeSheet *head_, *detail_;
    Table *groups_, *table_;
    NumberPad* pad_;
    // of groups as the table has them, and in the language; [0] all
    std::vector<QString> names_, titles_;
    int group_ = 0, listRow_ = 0;
    QString search_;
    Only only_ = Only::All;
    bool searching_ = false, onGroups_ = false;  // onGroups_: keys go to the groups
    unsigned bit_ = 0;                           // that keys turn over
    struct TouchedBit {                          // that the next touch of it turns over
        const params::Row* row = nullptr;
        unsigned instance = 0, element = 0, bit = 0;
        QElapsedTimer since;
    } touched_;
    Page page_ = Page::List;
    Bits bits_ = Bits::None;
    CompensationPage* compensation_;
    Aside<std::shared_ptr<params::Table>> reading_;
    std::shared_ptr<params::Table> file_;
    QJsonArray history_;
    QString historyOf_;  // empty: of all parameters
    bool historyAsked_ = false, historyAll_ = false;
    void askHistory();
    std::vector<Line> lines_;
    Undo undo_;
};

}  // namespace polyturn::hmi
