// Compensation tables of the machine: which there are, the points of the chosen one, and its graph. The cells are read aside from the file
// beside the machine's parameters, anew whenever the page is opened.
#pragma once
#include "hmi/app/screen.hpp"
#include "hmi/machine/aside.hpp"
#include "hmi/machine/compensation_curves.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class CompensationPage : public QWidget {
public:
    CompensationPage(Desk& desk, QWidget* parent);
    void begin();
    void refresh();
    bool key(QKeyEvent* event);
    std::vector<Sheet*> sheets() { return {curves_, points_, graph_}; }
    const std::vector<CompensationCurve>& all() const { return all_; }
    Table& curves() { return *curves_; }

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    const CompensationCurve* chosen() const;
    QString title(const CompensationCurve& curve) const;
    QString axisName(unsigned axis) const;
    QString unitOf(unsigned axis) const;
    void composeGraph(Writer& w);

    Desk& desk_;
    Table *curves_, *points_;
    FreeSheet* graph_;
    Aside<std::shared_ptr<CompensationTables>> reading_;
    std::shared_ptr<CompensationTables> cells_;
    std::vector<CompensationCurve> all_;
    bool onPoints_ = false;
};

}  // namespace polyturn::hmi
