// A list or table for touch and keys: rows as high as a finger, one row or cell chosen, scrolled by
// dragging, arrows and pages. What stands in it is asked of the model (two functions) for the
// visible rows only.
#pragma once
#include "hmi/widgets/sheet.hpp"

class QKeyEvent;

namespace polyturn::hmi {

class Table : public Sheet {
public:
    struct Column {
        QString title;
        double share = 1;  // of the width
        int align = Qt::AlignLeft | Qt::AlignVCenter;
        bool editable = false;  // cells can be chosen
    };
    struct Cell {
        QString text;
        QColor colour = {};  // invalid: that of texts
        Sign sign = Sign::None;
        bool bold = false;
        Face face = Face::Text;
        QColor behind = {};  // invalid: that of the row
        double units = 0;    // size of the letters; 0: the table's
        // 0 to 1: a bar along the foot of the cell, in the cell's colour
        double bar = -1;
    };
    explicit Table(QWidget* parent);

    std::vector<Column> columns;
    std::function<int()> rows;
    std::function<Cell(int row, int column)> cell;
    std::function<void()> onChosen;     // row or column is another one
    std::function<void()> onActivated;  // touched again, or Enter
    double rowUnits = 36, textUnits = 15;
    QString nothing;  // instead of rows, when there is none
    // without a controller it has nothing to show, and says so
    bool ofMachine = true;
    static inline QString noMachine;  // what it says then; empty: there is a controller
    QString whyEmpty() const { return ofMachine && !noMachine.isEmpty() ? noMachine : nothing; }
    bool isEmpty() const { return count() == 0; }
    bool byCell = false;
    // its row is bright: what is chosen stands in this list
    bool marked = true;
    bool focused = false;  // of several lists the one that keys go to: a frame

    int row() const { return row_; }
    int column() const { return column_; }
    void choose(int row, int column = -1);
    bool key(QKeyEvent* event);
    void forgetTouch() override {
        pressed_ = false;
        Sheet::forgetTouch();
    }
    int visibleRows() const;
    QRectF cellBox(int row, int column) const;  // empty: not visible

protected:
    void compose(Writer& w) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;

    int rowAt(const QPointF& point) const;  // -1: none

private:
    double head() const;
    QFont letteringOf(const Cell& one, double room) const;
    double left(int column) const;
    int count() const { return rows ? rows() : 0; }
    void scrollTo(double first);
    int nextColumn(int from, int step) const;

    int row_ = 0, column_ = -1;
    double first_ = 0;  // visible row at the top
    QPointF down_;
    double downFirst_ = 0;
    bool dragged_ = false, pressed_ = false;
};

}  // namespace polyturn::hmi
