// The log of stops: when, how long, which channel, why; beside it the sum of each cause as a picture, and the stops over the period.
#pragma once
#include "hmi/app/screen.hpp"
#include "hmi/machine/stop_book.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class StopsPage : public QWidget {
public:
    StopsPage(Desk& desk, QWidget* parent);
    void refresh();
    void rebuilt() { book_.forget(); }
    bool key(QKeyEvent* event) { return table_->key(event); }
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {table_, picture_}; }
    StopBook& book() { return book_; }
    Table& table() { return *table_; }
    QString title() const;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void composePicture(Writer& w);
    Desk& desk_;
    StopBook book_;
    Table* table_;
    FreeSheet* picture_;
};

}  // namespace polyturn::hmi
