// Parameters: groups, search by number, name or meaning, bits with their meaning, unit, range, effect, what differs from the default.
// A change counts when the store has it on its disk.
#pragma once
#include "hmi/app/screen.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn::hmi {

class Parameters : public Screen {
public:
    explicit Parameters(Desk& desk);
    QString title() const override { return word("Parameters"); }
    Sign sign() const override { return Sign::Parameters; }
    const char* name() const override { return "parameters"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override { search(); }
    bool key(QKeyEvent* event) override;
    bool typing() const override { return true; }
    QString state() const override { return QString("%1|%2").arg(group_).arg(search_); }
    void restore(const QString& state) override;
    HelpTopic help() const override;
    std::vector<Sheet*> sheets() override { return {head_, groups_, table_, detail_, pad_}; }
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }
    FreeSheet& detail() { return *detail_; }
    void find(const QString& text) { search_ = text, search(); }

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
    QString target(const Line& line) const;
    void put(const Line& line, double now);
    void put(const Line& line, const QString& written);
    void askText(const Line& line);
    void undo();

    struct Change {
        QString target;
        QString old, now;
        bool undone = false;
    };
    FreeSheet *head_, *detail_;
    Table *groups_, *table_;
    NumberPad* pad_;
    std::vector<QString> names_, titles_;   // of groups as the table has them, and in the language; [0] all
    int group_ = 0;
    QString search_;
    bool changedOnly_ = false, searching_ = false;
    std::vector<Line> lines_;
    std::vector<Change> changes_;
};

}  // namespace polyturn::hmi
