// What a program asks: its page with named values and soft keys, over the screens while the
// machine's state stays in sight. It comes up when a dialogue is opened in the chosen channel and
// nobody types (MainWindow::followDialogue), else the line at the top brings it; Escape or another
// screen puts it away, the line at the top brings it back. The page is named in the image
// (ChannelSegment::dialogue); an answer is `press answer`.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class DialogueView : public QWidget {
public:
    DialogueView(Context& context, QWidget* parent);
    // Each frame. True: another dialogue than before is open, show it.
    bool follow();
    unsigned channel() const { return channel_; }  // that asks; 0: none does
    QString title() const { return QString::fromUtf8(page_.title.data()); }
    void refresh();
    std::vector<SoftKey> keys();
    bool key(QKeyEvent* event);
    std::vector<Sheet*> sheets();
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void layOut();
    DisplayLanguage spoken_ = DisplayLanguage::English;  // of the table's headings
    struct Key {
        int number;
        QString text;
    };
    std::vector<Key> pageKeys() const;
    bool asksValues() const { return page_.field_count > 0; }
    void answer(int key);

    Context& context_;
    FreeSheet *head_, *place_;  // place_: where the axes of its channel stand
    Table* table_;
    NumberPad* pad_;
    Dialogue page_{};
    unsigned channel_ = 0, chosen_ = 0;  // chosen_: of the context, at the last look
    std::uint64_t serial_ = 0;
};

}  // namespace polyturn::hmi
