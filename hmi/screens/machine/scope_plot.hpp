// The graph of the scope: traces with their numbers and dashes at the line, values of the chosen
// one and the time at its edges. A column of pixels is one span of ScopeColumns, written straight
// into a picture: eight traces at each frame cost less than their digits beneath.
#pragma once
#include <QImage>
#include <QPainter>
#include <array>

#include "hmi/machine/bodies/scope_columns.hpp"

namespace polyturn::hmi {

QColor colourOfTrace(std::size_t trace);
// Where its line has ink, by the column's number: each trace has its own dashes, whatever the eye
// makes of the colours.
bool traceHasInk(std::size_t trace, std::int64_t column);

// What is shown of a record.
struct ScopeLook {
    std::array<bool, kScopeTraces> on{};
    std::size_t chosen = 0;              // the trace whose values stand at the edge
    QString title, unit;                 // of it
    double seconds = 1, tick_s = 0.001;  // how wide, how long a tick is
};

class ScopePlot {
public:
    // The newest of the record, into a graph of this size.
    void take(const ScopeRecord& record, const ScopeLook& look, QSize size);
    void paint(QPainter& p, const QRect& room);
    ScopeSpan span(std::size_t trace) const { return columns_.whole(trace); }
    bool drawn() const { return columns_.newest() >= 0; }
    const ScopeScale& scale(std::size_t trace) const { return scales_[trace]; }
    // as many digits as tell one division from the next
    static QString valueText(double value, double division);

private:
    QRectF box() const;  // of the traces, within the room
    double y(std::size_t trace, double value) const;
    // card, lines and figures: only when they are others than before
    void paintBehind();
    void draw(std::size_t trace);
    void paintNumbers(QPainter& p);
    void paintTrigger(QPainter& p);

    ScopeColumns columns_;
    std::array<ScopeScale, kScopeTraces> scales_{};
    ScopeLook look_;
    ScopeRecord::Trigger trigger_;
    std::int64_t triggeredAt_ = 0, end_ = 0;
    bool stands_ = false, armed_ = false, empty_ = true;
    QSize size_;
    QString behindKey_;
    QImage behind_, picture_;
};

}  // namespace polyturn::hmi
