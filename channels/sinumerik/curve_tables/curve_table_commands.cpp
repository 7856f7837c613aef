// CTABDEF ... CTABEND and the functions that read curve tables (sinumerik_part3 7.4, 9.3).
//
// The blocks between CTABDEF and CTABEND move nothing: each straight one that names the leading or
// the following axis is the table's next point; the first is where it begins. Tables live in two
// memories, SRAM (also where none is named) and DRAM; how many there is room for is this control's
// own: kTables and kSegments each. Polynomials are not built, none is ever in use.
#include "channels/sinumerik/curve_tables/curve_table_commands.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "channels/sinumerik/axes/axis_names.hpp"
#include "channels/sinumerik/axes/axis_words.hpp"
#include "channels/sinumerik/coupling/coupled_axes.hpp"
#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/variables/changes.hpp"
#include "channels/sinumerik/variables/variables.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr double kTables = 100, kMostNumber = 32000;
constexpr double kSegments = 5000;

// false: SRAM, true: DRAM; nothing: no memory has that name.
std::optional<bool> memory_named(const Call& c, std::size_t i) {
    if (!c.has(i)) return false;
    const std::string name = upper(c.value(i).text);
    if (name == "SRAM" || name == "DRAM") return name == "DRAM";
    return std::nullopt;
}

double tables_in(const CurveTables& tables, bool dynamic) {
    return static_cast<double>(std::ranges::count_if(
        tables, [dynamic](const auto& one) { return one.second.dynamic == dynamic; }));
}
double segments_in(const CurveTables& tables, bool dynamic) {
    std::size_t sum = 0;
    for (const auto& [number, table] : tables)
        sum += table.dynamic == dynamic ? table.segments() : 0;
    return static_cast<double>(sum);
}
double polynomials(const CurveTables&, bool) { return 0.0; }

const CurveTable* curve_table(Execution& x, const Call& c, std::size_t i) {
    const auto found = x.curve_tables.find(static_cast<int>(c.number(i)));
    if (found != x.curve_tables.end()) return &found->second;
    fail(x, Alarm::FunctionArgument, "CTAB", static_cast<double>(i + 1));
    return nullptr;
}

bool curve_sample(Execution& x, Call& c, std::size_t slope, const CurveTable::Sample& sample,
                  double value) {
    store(x, c.arguments[slope].reference, Value::of_real(sample.slope));
    c.result = Value::of_real(value);
    return true;
}

bool curve_extreme(Execution& x, Call& c, bool largest) {  // (n[, a, b])
    const CurveTable* table = curve_table(x, c, 0);
    if (!table) return false;
    c.result = Value::of_real(table->extreme(c.number(1, table->points.front().lead),
                                             c.number(2, table->points.back().lead), largest));
    return true;
}

// Of the table n: `facts` where it exists, -1 (CTABEXISTS: FALSE) where not.
bool curve_fact(Execution& x, Call& c, const std::function<double(const CurveTable&)>& fact) {
    const auto found = x.curve_tables.find(static_cast<int>(c.number(0)));
    c.result = Value::of_int(found == x.curve_tables.end() ? -1.0 : fact(found->second));
    return true;
}

// In a memory: how many tables, segments or polynomials are in use, free, and possible. -1: there
// is no such memory.
// of the memory for curve tables
enum class CurveFigure : std::uint8_t { Used, Free, Most };

bool curve_memory(Execution& x, Call& c, CurveFigure figure,
                  double (*used)(const CurveTables&, bool), double most) {
    const auto memory = memory_named(c, 0);
    if (!memory) {
        c.result = Value::of_int(-1);
        return true;
    }
    // of the segments, those that are polynomials
    if (c.has(1) && upper(c.value(1).text) == "P") {
        used = &polynomials;
        most = 0;
    }
    const double now = used(x.curve_tables, *memory);
    c.result = Value::of_int(figure == CurveFigure::Used   ? now
                             : figure == CurveFigure::Free ? most - now
                                                           : most);
    return true;
}

}  // namespace

// --- definition

bool p_ctabdef(Execution& x, Call& c) {  // (follow, lead, n, periodic[, memory])
    CurveDefinition made;
    if (x.modal.curve) return fail(x, Alarm::CodesContradict, "CTABDEF, CTABDEF");
    if (!axis_argument(x, c, 0, "CTABDEF", made.follows) ||
        !axis_argument(x, c, 1, "CTABDEF", made.leads))
        return false;
    if (made.follows == made.leads)
        return fail(x, Alarm::CodesContradict, axis_name(x, static_cast<int>(made.leads)));
    const double number = c.number(2), periodic = c.number(3);
    if (!(number >= 1 && number <= kMostNumber))
        return fail(x, Alarm::FunctionArgument, "CTABDEF", 3);
    if (!(periodic >= 0 && periodic <= 2)) return fail(x, Alarm::FunctionArgument, "CTABDEF", 4);
    const auto memory = memory_named(c, 4);
    if (!memory) return fail(x, Alarm::FunctionArgument, "CTABDEF", 5);
    if (x.core.compensating() || x.core.transformed())
        return fail(x, Alarm::CodesContradict, "CTABDEF, G41, TRANSMIT");
    if (const auto had = x.curve_tables.find(static_cast<int>(number));
        had != x.curve_tables.end() && had->second.locked)
        return fail(x, Alarm::CodesContradict, fmt::format("CTABDEF({:.0f}), CTABLOCK", number));
    if (is_coupled(x, static_cast<int>(number)))
        return fail(x, Alarm::CodesContradict, fmt::format("CTABDEF({:.0f}), LEADON", number));
    made.number = static_cast<int>(number);
    made.table.periodic = static_cast<int>(periodic);
    made.table.dynamic = *memory;
    x.modal.curve = std::move(made);
    x.modal.before_curve = x.core.path.programmed;
    x.run.state_changed = true;
    return true;
}

// A straight move while a table is defined.
bool curve_point(Execution& x, const AxisValues& target) {
    CurveDefinition& curve = *x.modal.curve;
    for (const Word& word : x.block.words)
        if (word.axis >= 0 && word.axis != static_cast<int>(curve.follows) &&
            word.axis != static_cast<int>(curve.leads))
            return fail_word(x, Alarm::AddressIllegal, word, axis_name(x, word.axis));
    const auto shown = [&](std::size_t i) {
        return counts_diameter(x, static_cast<unsigned>(i), false) ? target[i] * 2 : target[i];
    };
    curve.table.points.push_back({shown(curve.leads), shown(curve.follows)});
    x.core.path.programmed = target;  // increments count from the table's last point
    x.run.state_changed = true;
    return true;
}

bool p_ctabend(Execution& x, Call&) {
    if (!x.modal.curve) return fail(x, Alarm::CodesContradict, "CTABEND");
    CurveDefinition curve = std::move(*x.modal.curve);
    x.modal.curve.reset();
    x.core.path.programmed = x.modal.before_curve;
    x.run.state_changed = true;
    std::vector<CurveTable::Point>& points = curve.table.points;
    // it must go one way, from point to point
    if (points.size() < 2) return fail(x, Alarm::FunctionArgument, "CTABDEF", 2);
    if (points.back().lead < points.front().lead) std::ranges::reverse(points);
    for (std::size_t i = 1; i < points.size(); ++i)
        // it must go one way, from point to point
        if (!(points[i].lead > points[i - 1].lead))
            return fail(x, Alarm::FunctionArgument, "CTABDEF", 2);
    CurveTables after = x.curve_tables;
    const bool dynamic = curve.table.dynamic;
    after[curve.number] = std::move(curve.table);
    // no room for it
    if (tables_in(after, dynamic) > kTables || segments_in(after, dynamic) > kSegments)
        return fail(x, Alarm::FunctionArgument, "CTABDEF", 3);
    undo(x, [&x, before = x.curve_tables] { x.curve_tables = before; });
    x.curve_tables = std::move(after);
    return true;
}

// CTABDEL([n[, m[, memory]]]), CTABLOCK, CTABUNLOCK(n[, m]): tables n to m, n alone, or all of
// them.
bool p_ctab_each(Execution& x, Call& c) {
    const std::string_view name = x.block.procedures.front().first->name;
    const auto memory = memory_named(c, 2);
    if (!memory) return fail(x, Alarm::FunctionArgument, std::string(name), 3);
    const double from = c.number(0, 1), to = c.has(1) ? c.number(1) : c.has(0) ? from : kMostNumber;
    undo(x, [&x, before = x.curve_tables] { x.curve_tables = before; });
    for (auto one = x.curve_tables.begin(); one != x.curve_tables.end();) {
        const bool meant =
            one->first >= from && one->first <= to && (!c.has(2) || one->second.dynamic == *memory);
        if (meant && name == "CTABDEL" && is_coupled(x, one->first))
            return fail(x, Alarm::CodesContradict, fmt::format("CTABDEL({}), LEADON", one->first));
        if (meant && name == "CTABDEL" && one->second.locked)
            return fail(x, Alarm::CodesContradict,
                        fmt::format("CTABDEL({}), CTABLOCK", one->first));
        if (meant && name != "CTABDEL") one->second.locked = name == "CTABLOCK";
        one = meant && name == "CTABDEL" ? x.curve_tables.erase(one) : std::next(one);
    }
    return true;
}

// --- positions

bool f_ctab(Execution& x, Call& c) {  // (lead, n, VAR slope): following position
    const CurveTable* table = curve_table(x, c, 1);
    return table && curve_sample(x, c, 2, table->at(c.number(0)), table->at(c.number(0)).value);
}
bool f_ctabinv(Execution& x, Call& c) {  // (follow, about, n, VAR slope): leading position
    const CurveTable* table = curve_table(x, c, 2);
    if (!table) return false;
    const CurveTable::Sample sample = table->inverse(c.number(0), c.number(1));
    return curve_sample(x, c, 3, sample, sample.value);
}
// (lead, n, VAR slope): following position where its segment begins
bool f_ctabssv(Execution& x, Call& c) {
    const CurveTable* table = curve_table(x, c, 1);
    return table && curve_sample(x, c, 2, table->segment_start(c.number(0)),
                                 table->segment_start(c.number(0)).value);
}
bool f_ctabsev(Execution& x, Call& c) {  // and where it ends
    const CurveTable* table = curve_table(x, c, 1);
    return table && curve_sample(x, c, 2, table->segment_end(c.number(0)),
                                 table->segment_end(c.number(0)).value);
}
// (n, VAR slope): at the table's beginning and end, of the following (V) and the leading axis (P).
bool f_ctabtsv(Execution& x, Call& c) {
    const CurveTable* table = curve_table(x, c, 0);
    return table && curve_sample(x, c, 1, table->segment_start(table->points.front().lead),
                                 table->points.front().follow);
}
bool f_ctabtsp(Execution& x, Call& c) {
    const CurveTable* table = curve_table(x, c, 0);
    return table && curve_sample(x, c, 1, table->segment_start(table->points.front().lead),
                                 table->points.front().lead);
}
bool f_ctabtev(Execution& x, Call& c) {
    const CurveTable* table = curve_table(x, c, 0);
    return table && curve_sample(x, c, 1, table->last(), table->points.back().follow);
}
bool f_ctabtep(Execution& x, Call& c) {
    const CurveTable* table = curve_table(x, c, 0);
    return table && curve_sample(x, c, 1, table->last(), table->points.back().lead);
}

bool f_ctabtmin(Execution& x, Call& c) { return curve_extreme(x, c, false); }
bool f_ctabtmax(Execution& x, Call& c) { return curve_extreme(x, c, true); }

// --- what there is

bool f_ctabexists(Execution& x, Call& c) {
    c.result = Value::of_bool(x.curve_tables.contains(static_cast<int>(c.number(0))));
    return true;
}
bool f_ctabislock(Execution& x, Call& c) {  // 1 CTABLOCK, 2 LEADON, 3 both
    const bool coupled = is_coupled(x, static_cast<int>(c.number(0)));
    return curve_fact(x, c, [coupled](const CurveTable& t) {
        return (t.locked ? 1.0 : 0.0) + (coupled ? 2.0 : 0.0);
    });
}
bool f_ctabmemtyp(Execution& x, Call& c) {
    return curve_fact(x, c, [](const CurveTable& t) { return t.dynamic ? 1.0 : 0.0; });
}
bool f_ctabperiod(Execution& x, Call& c) {
    return curve_fact(x, c, [](const CurveTable& t) { return static_cast<double>(t.periodic); });
}
bool f_ctabsegid(Execution& x, Call& c) {  // (n, "L" or "P")
    const bool lines = !c.has(1) || upper(c.value(1).text) == "L";
    return curve_fact(x, c, [lines](const CurveTable& t) {
        return lines ? static_cast<double>(t.segments()) : 0.0;
    });
}
bool f_ctabpolid(Execution& x, Call& c) {
    return curve_fact(x, c, [](const CurveTable&) { return 0.0; });
}
bool f_ctabid(Execution& x, Call& c) {  // (p, memory): number of the p-th table there
    const auto memory = memory_named(c, 1);
    double left = c.number(0);
    for (const auto& [number, table] : x.curve_tables)
        if (memory && (!c.has(1) || table.dynamic == *memory) && --left == 0) {
            c.result = Value::of_int(number);
            return true;
        }
    c.result = Value::of_int(-1);
    return true;
}
bool f_ctabno(Execution& x, Call& c) {
    c.result = Value::of_int(static_cast<double>(x.curve_tables.size()));
    return true;
}

bool f_ctabnomem(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Used, &tables_in, kTables);
}
bool f_ctabfno(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Free, &tables_in, kTables);
}
bool f_ctabseg(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Used, &segments_in, kSegments);
}
bool f_ctabfseg(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Free, &segments_in, kSegments);
}
bool f_ctabmseg(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Most, &segments_in, kSegments);
}
bool f_ctabpol(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Used, &polynomials, 0);
}
bool f_ctabfpol(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Free, &polynomials, 0);
}
bool f_ctabmpol(Execution& x, Call& c) {
    return curve_memory(x, c, CurveFigure::Most, &polynomials, 0);
}

}  // namespace polyturn::channels::sinumerik
