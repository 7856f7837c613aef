// Compensation tables of the machine: which there are, the points of the chosen one, its graph, and
// the parameters that describe it. A value is entered beside the graph; a cell or a grid point goes
// to the store, which keeps the file beside the machine's parameters, one of four positions to its
// parameter. The file is read aside, again whenever somebody has changed it. What stood there when
// the page was opened stays visible in the graph and beside the values.
//
//   +--------+-----------------+------------+
//   | tables | rows of a grid  | parameters |
//   +--------+ graph           +------------+
//   | points |                 | number pad |
//   +--------+-----------------+------------+
#pragma once
#include <QElapsedTimer>
#include <filesystem>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/bodies/compensation_curves.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/live/changes.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class CompensationPage : public QWidget {
public:
    using Kind = CompensationCurve::Kind;
    CompensationPage(Context& context, QWidget* parent);
    void begin();
    void refresh();
    bool key(QKeyEvent* event);
    std::vector<SoftKey> keys();
    std::vector<Sheet*> sheets() { return {curves_, points_, graph_, settings_, pad_}; }
    const std::vector<CompensationCurve>& all() const { return all_; }
    // the first table of that kind, as soon as the tables are known
    void chooseKind(Kind kind);
    bool ready() const { return cells_ != nullptr; }
    // of a grid the chosen row
    const CompensationCurve* chosen() const { return shown_ ? &*shown_ : nullptr; }
    const GridRow& row() const { return row_; }
    Table& curves() { return *curves_; }
    Table& points() { return *points_; }
    Table& settings() { return *settings_; }
    FreeSheet& graph() { return *graph_; }
    NumberPad& pad() { return *pad_; }

    // What can be touched in the graph's head, of a grid: + the number of its axis.
    static constexpr int kCorrectedHit = 10, kAlongHit = 20, kBackHit = 30, kOnHit = 40;

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    // The parameter of a value.
    struct Place {
        enum class Kind : std::uint8_t { Cell, Point, Parameter } kind = Kind::Cell;
        std::int64_t number = 0;  // of the cell, of the point
        unsigned channel = 0;
        std::size_t component = 0;
        ParameterPlace parameter = {};
    };
    using Undo = Changes<Place, double>;
    struct Stamp {
        std::filesystem::file_time_type when{};
        std::uintmax_t size = 0;
        bool there = false;
        bool operator==(const Stamp&) const = default;
    };
    struct Read {
        Stamp stamp;
        std::shared_ptr<CompensationTables> cells;  // nothing: as before
    };
    enum class Focus : std::uint8_t { Curves, Points, Settings };

    void read(int wait_ms);
    void take();  // what has been read, or what parameters say by now
    void build();
    void show();  // the chosen table anew
    bool parametersChanged();
    const CompensationCurve* table() const;
    std::optional<Place> placeAt(int row, int column) const;
    std::optional<Place> target() const;  // of what is typed
    double present(const Place& place) const;
    bool bits(const Place& place) const;
    QString nameOf(const Place& place) const;
    QString textOf(const Place& place, double value) const;
    void put(const Place& place, double now);
    void add(const Place& place, double delta);
    void takeBack(const Undo::Change& change);
    void askStore(const Place& place, const QJsonValue& entry,
                  const std::optional<Undo::Change>& known, bool undone);
    void answered(const Undo::Change& change, const Answer& answer, bool undone);
    void taken(const Place& place, double now);
    void askImport();
    void turn(std::size_t axis, int step);
    // the axis of the grid that the row can be moved along; 3: none
    std::size_t beside(int which) const;
    std::optional<double> before(const CompensationCurve::Point& point) const;
    QString title(const CompensationCurve& curve) const;
    QString axisName(unsigned axis) const;
    QString unitOf(unsigned axis) const;
    QString lengthOf(unsigned axis, double value, unsigned digits) const;
    double composeRow(Writer& w, double y);
    void composeGraph(Writer& w);

    Context& context_;
    Table *curves_, *points_, *settings_;
    FreeSheet* graph_;
    NumberPad* pad_;
    Aside<Read> reading_;
    Stamp stamp_;
    QElapsedTimer since_;  // the last look at the file
    // of the store: what is read meanwhile may be older than the answer
    int asked_ = 0;
    std::shared_ptr<CompensationTables> cells_;
    std::vector<double> parameters_;  // that the curves were made of
    std::vector<CompensationCurve> all_;
    std::vector<ParameterPlace> describedBy_;
    // the chosen one now, and when the page was opened
    std::optional<CompensationCurve> shown_, opened_;
    std::vector<CompensationCurve> neighbours_;
    std::shared_ptr<CompensationTables> openedCells_;
    std::vector<CompensationCurve> openedAll_;
    GridRow row_;
    unsigned rowOf_ = 0;  // the channel whose grid it belongs to; 0: none yet
    std::optional<Kind> wanted_;
    bool everything_ = false, building_ = false;
    Focus focus_ = Focus::Curves;
    Undo undo_;
};

}  // namespace polyturn::hmi
