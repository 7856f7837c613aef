// A cycle of the program as a form with a picture: filled from the block at the cursor, or new from
// the list of the language's cycles. What is written changes only the words that were changed
// (ipc/model/languages). It lies over the editor and speaks to it by functions.
#pragma once
#include "hmi/screens/programs/editor_overlay.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/pictures/cycle_picture.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

// How the channel's programs are written (F3401, F0001, least increment).
forms::Dialect formDialect(const Live& live, unsigned channel, const QString& language);

class CycleFormPage : public EditorOverlay {
public:
    CycleFormPage(Context& context, QWidget* parent);
    // The program and where the cursor is (line from 0). False: this language has no cycles.
    bool open(const QStringList& lines, int cursor, const forms::Dialect& dialect);
    void refresh() override;
    bool key(QKeyEvent* event) override;
    void addKeys(std::vector<SoftKey>& keys) override;
    std::vector<Sheet*> sheets() override;
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }
    const std::optional<forms::CycleBlock>& cycle() const { return now_; }
    bool choosing() const { return !now_; }
    // of the form, or of the cycle that is chosen in the list; without MCALL
    QString code() const;
    // a cycle of the list: its form
    void choose(int row);
    QString faultText(int field) const;  // empty: the value is good
    // what is good but will not do yet: a block that is not there
    QString hintText(int field) const;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    enum Column { kAddress, kMeaning, kValue, kUnit };
    void showForm(forms::CycleBlock cycle);
    void showList();
    void point();
    int field() const;
    void input(double value);
    void erase();
    void write();
    Table::Cell cell(int row, int column) const;
    QString valueText(int field) const;
    void composeNote(Writer& w);

    Context& context_;
    Table* table_;
    CyclePicture* picture_;
    NumberPad* pad_;
    FreeSheet* note_;
    std::vector<std::string> lines_;
    int cursor_ = 0;
    forms::Dialect dialect_;
    std::vector<const forms::Form*> list_;
    // now_: the form; before_: what is in the program
    std::optional<forms::CycleBlock> before_, now_;
    std::vector<forms::FieldFault> faults_;
};

}  // namespace polyturn::hmi
