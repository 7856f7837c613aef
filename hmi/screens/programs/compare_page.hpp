// Two programs side by side: what is not the same is marked, and the next place is one key away.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/programs/text_difference.hpp"

namespace polyturn::hmi {

class ComparePage : public QWidget {
public:
    ComparePage(Context& context, QWidget* parent);
    void compare(const QString& left, const QString& right);
    void refresh();
    bool key(QKeyEvent* event);
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {view_}; }
    bool busy() const { return work_.busy(); }
    const Difference& difference() const { return difference_; }
    static QStringList pieces(const QString& text, int letters);  // of a line: never empty
    int first() const { return first_; }
    const QString& left() const { return left_; }
    const QString& right() const { return right_; }

protected:
    void resizeEvent(QResizeEvent*) override {
        view_->setGeometry(px(8), 0, width() - px(16), height() - px(8));
        view_->refresh();
    }

private:
    void compose(Writer& w);
    void go(int step);  // to the next or the last place that differs
    void scroll(int by);
    // lines of text that have room
    int room() const { return std::max(1, (view_->height() - px(76)) / px(22)); }
    int letters() const;                 // of one line of text on a side
    int rowsOf(std::size_t line) const;  // a long one goes on below itself, on both sides at once
    int lastFirst() const;               // with which the end is seen
    Context& context_;
    FreeSheet* view_;
    QString left_, right_;
    Aside<Difference> work_;
    Difference difference_;
    int first_ = 0, place_ = -1;
};

}  // namespace polyturn::hmi
