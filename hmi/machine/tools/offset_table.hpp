// The tables of tool offsets, tool edges and work zeros of a channel, as they are before anybody
// draws them: which rows and columns there are and which of them a search leaves, what a value is
// called in a request, what the store holds of it and what the machine works with now. A channel
// that speaks sinumerik has no numbered offsets: in their place are the edges of its tools.
#pragma once
#include <QString>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "hmi/machine/live/live.hpp"
#include "hmi/machine/tools/edge_words.hpp"

namespace polyturn::hmi {

// One value of a table: how it is called in a request, and where it is.
struct OffsetValue {
    QString words;  // «offset L1 3 wear X»
    QString title;
    double present = 0;     // as the store holds it
    unsigned decimals = 3;  // shown; 0 a whole number
    LengthUnit unit;
    bool angle = false, diameter = false;
    int place = -1;  // of its axis in the channel; -1 none
    EdgeLine edge;   // of a tool; tool 0: no edge
    int dp = 0;      // and which value of it
    // a whole edge that was deleted: what it had
    std::vector<std::pair<int, double>> gone = {};
    // Where it is in the store: the row of the zeros, or the number of the offset and the letter of
    // its field, wear in lower case.
    unsigned channel = 0;
    bool zero = false;
    std::size_t row = 0;
    char field = 0;

    bool ofEdge() const { return edge.tool != 0; }
    bool wear() const { return ofEdge() ? is_edge_wear(dp) : words.contains(" wear "); }
    QString text(double held) const;
    QString unitText() const;
};
double presentOf(const Live& live, const OffsetValue& value);

class OffsetTable {
public:
    enum class Kind : std::uint8_t { Offsets, Zeros };
    struct Column {
        QString title;
        double share = 1;
        bool value = false;  // a number that can be chosen; else what names the row
    };
    explicit OffsetTable(const Live& live) : live_(live) {}

    // All of it anew. base: of edges the base lengths, in the place of their wear.
    void build(unsigned channel, Kind kind, bool base);
    // the channel, and whether it has edges, are still those
    bool isOf(unsigned channel) const;
    unsigned channel() const { return channel_; }
    bool zeros() const { return kind_ == Kind::Zeros; }
    bool edged() const { return edged_; }
    bool byEdges() const { return edged_ && !zeros(); }
    const std::vector<Column>& columns() const { return columns_; }
    // Where keys go to at the beginning: of an edge its first length, not its type.
    int firstColumn() const;

    // only rows with it: a number, a tool, a name of a tool or a zero
    const QString& searched() const { return search_; }
    void search(const QString& text) { search_ = text; }
    void filter();
    // tools have come or gone since names were looked at
    bool outdated() const;
    QString nothing() const;  // what an empty table says
    int shownCount() const { return static_cast<int>(rows_.size()); }
    int rowsInAll() const;
    int at(int shown) const;          // the row that is shown there; -1: none
    int placeOfRow(int row) const;       // where it is shown, or the next one
    QString rowTitle(int row) const;  // of an offset or a zero

    // Edges come and go with the tools.
    bool edgesOutdated() const;
    void takeEdges();
    const std::vector<EdgeLine>& edges() const { return edges_; }
    EdgeLine edgeAt(int row) const;         // tool 0: there is none
    int rowOf(const EdgeLine& edge) const;  // -1: there is none

    std::optional<OffsetValue> value(int shown, int column) const;
    bool active(int row) const;  // the running block works with it
    // What the running block works with, and what the table comes to now, both as the table shows
    // it.
    bool appliedNow(const OffsetValue& value, double& applied, double& sum) const;

private:
    bool found(int row) const;
    void addEdgeColumns(bool base);
    void addOffsetColumns();
    void addZeroColumns();
    std::optional<OffsetValue> zeroValue(std::size_t zero, int place) const;
    std::optional<OffsetValue> edgeCell(const EdgeLine& edge, int dp) const;
    OffsetValue offsetValue(int row, char field) const;

    const Live& live_;
    unsigned channel_ = 0;
    Kind kind_ = Kind::Offsets;
    bool edged_ = false;
    QString search_;
    std::vector<Column> columns_;
    std::vector<int> rows_;       // that are shown
    std::uint64_t foundFor_ = 0;  // Live::toolsVersion() that names were looked at
    std::uint64_t edgesOf_ = 0;   // Live::toolsVersion() that they were taken from
    std::vector<EdgeLine> edges_;
    std::vector<std::size_t> zeroRows_;
    // letter of each column of offsets: X Z R T, wear in lower case
    std::vector<char> fields_;
    std::vector<int> parameters_;  // $TC_DPx of each column of edges
};

}  // namespace polyturn::hmi
