// Measured parts: dimensions with nominal, tolerance and the tool that makes them, what was
// measured, the proposed correction, the trend as a curve. Accepting writes the wear; nothing is
// written before.
#pragma once
#include <QJsonObject>

#include "hmi/widgets/screen.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class PartsPage : public QWidget {
public:
    PartsPage(Context& context, QWidget* parent);
    void begin() { lookAt_ = 0; }
    void refresh();
    bool key(QKeyEvent* event) { return pad_->key(event) || table_->key(event); }
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {table_, curve_, pad_}; }
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }
    const std::vector<QJsonObject>& dimensions() const { return all_; }
    enum Column : std::uint8_t {
        kNumber,
        kName,
        kAxis,
        kTool,
        kNominal,
        kUpper,
        kLower,
        kMeasured,
        kDeviation,
        kProposal
    };

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    void look();
    void composeCurve(Writer& w);
    const QJsonObject* chosen() const;
    QString columnTitle(int column) const;
    LengthUnit unitOf(const QJsonObject& dimension) const;
    void entered(double value);
    void added(double delta);
    void changeText();
    void set(const QString& field, const QString& value);
    void ask(QJsonObject operation, const QString& good);
    Context& context_;
    Table* table_;
    FreeSheet* curve_;
    NumberPad* pad_;
    std::vector<QJsonObject> all_;
    qint64 lookAt_ = 0;
    int wanted_ = 0;  // dimension to choose when the list comes
};

}  // namespace polyturn::hmi
