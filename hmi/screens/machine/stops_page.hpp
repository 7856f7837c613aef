// The log of stops: when, how long, which channel, why; next to it the sum of each cause as a
// picture, and the stops over the period.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/stop_log.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class StopsPage : public QWidget {
public:
    StopsPage(Context& context, QWidget* parent);
    void refresh();
    void rebuilt() { book_.forget(); }
    bool key(QKeyEvent* event) { return table_->key(event); }
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {table_, picture_}; }
    StopLog& book() { return book_; }
    Table& table() { return *table_; }
    QString title() const;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void composePicture(Writer& w);
    Context& context_;
    StopLog book_;
    Table* table_;
    FreeSheet* picture_;
};

}  // namespace polyturn::hmi
