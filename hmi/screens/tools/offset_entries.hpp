// What is entered into the tables of offsets and zeros, and taken back: typed values, what was
// measured or touched, where the axes stand, edges that come and go. A value counts when the store
// has answered: it is on disk then.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/changes.hpp"
#include "hmi/machine/tools/offset_table.hpp"

namespace polyturn::hmi {

class OffsetEntries {
public:
    using Undo = Changes<OffsetValue, double>;
    OffsetEntries(Context& context, const OffsetTable& table);

    std::function<void()> onEntered;  // a value is another one
    std::function<void()> onEdge;     // an edge is gone, or there again

    void put(const OffsetValue& value, double now);
    void add(const OffsetValue& value, double delta);  // to what the store has by then
    void measure(const OffsetValue& value, double typed);
    void zeroHere(const OffsetValue& value, double typed);
    // takes what the tool setter or the workpiece setter has answered
    void touched(const OffsetValue& value, std::optional<double> typed);
    int probe() const;
    void relativeZero();                           // the relative counter begins to count here
    void relativeInput(const OffsetValue& value);  // and what it says goes into the offset
    void newEdge(const OffsetValue& value);
    void deleteEdge(const OffsetValue& value);

    const Undo::Change* newest() const { return undo_.newest(); }
    void undo() { undo_.undo(); }
    void goOn() { undo_.goOn(); }  // each frame

private:
    void takeBack(const OffsetValue& value, double old, double there);  // there: entered
    void enterInStore(const OffsetValue& value, QJsonObject entry,
                      const std::function<void(const Answer&)>& done);
    void askStore(const OffsetValue& value, QJsonObject request,
                  const std::function<void(const Answer&)>& done);
    void entered(const OffsetValue& value, const Answer& answer);
    void tellEntered(const OffsetValue& value, double old, double now);
    // all values of an edge at once: none, or those that it had
    void setEdge(const OffsetValue& value, bool undone);
    const AxisConfig& axisOf(const OffsetValue& value) const;

    Context& context_;
    const OffsetTable& table_;
    Undo undo_;
};

// Who has changed a value before, since the store was begun: as lines.
class OffsetHistory {
public:
    explicit OffsetHistory(Context& context) : context_(context) {}
    std::function<void()> onCome;
    void ask(const std::optional<OffsetValue>& value);
    const QStringList& lines() const { return lines_; }

private:
    Context& context_;
    QString of_;  // which value
    QStringList lines_;
};

}  // namespace polyturn::hmi
