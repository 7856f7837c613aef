// CTABDEF ... CTABEND and the functions that read curve tables (sinumerik_part3 7.4, 9.3).
//
// The blocks between CTABDEF and CTABEND move nothing: each straight one that names the leading or
// the following axis is the table's next point; the first is where it begins. Tables live in two
// memories, SRAM (also where none is named) and DRAM; how many there is room for is this control's
// own: kTables and kSegments each. Polynomials are not built, none is ever in use.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "channels/sinumerik/interpreter.hpp"

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

}  // namespace

// --- definition

bool Interpreter::p_ctabdef(Call& c) {  // (follow, lead, n, periodic[, memory])
    CurveDefinition made;
    if (modal_.curve) return fail(Alarm::CodesContradict, "CTABDEF, CTABDEF");
    if (!axis_argument(c, 0, "CTABDEF", made.follows) ||
        !axis_argument(c, 1, "CTABDEF", made.leads))
        return false;
    if (made.follows == made.leads)
        return fail(Alarm::CodesContradict, axis_name(static_cast<int>(made.leads)));
    const double number = c.number(2), periodic = c.number(3);
    if (!(number >= 1 && number <= kMostNumber)) return fail(Alarm::FunctionArgument, "CTABDEF", 3);
    if (!(periodic >= 0 && periodic <= 2)) return fail(Alarm::FunctionArgument, "CTABDEF", 4);
    const auto memory = memory_named(c, 4);
    if (!memory) return fail(Alarm::FunctionArgument, "CTABDEF", 5);
    if (core_.compensating() || core_.transformed())
        return fail(Alarm::CodesContradict, "CTABDEF, G41, TRANSMIT");
    if (const auto had = curve_tables_.find(static_cast<int>(number));
        had != curve_tables_.end() && had->second.locked)
        return fail(Alarm::CodesContradict, fmt::format("CTABDEF({:.0f}), CTABLOCK", number));
    if (is_coupled(static_cast<int>(number)))
        return fail(Alarm::CodesContradict, fmt::format("CTABDEF({:.0f}), LEADON", number));
    made.number = static_cast<int>(number);
    made.table.periodic = static_cast<int>(periodic);
    made.table.dynamic = *memory;
    modal_.curve = std::move(made);
    modal_.before_curve = core_.path.programmed;
    state_changed_ = true;
    return true;
}

// A straight move while a table is defined.
bool Interpreter::curve_point(const AxisValues& target) {
    CurveDefinition& curve = *modal_.curve;
    for (const Word& word : block_.words)
        if (word.axis >= 0 && word.axis != static_cast<int>(curve.follows) &&
            word.axis != static_cast<int>(curve.leads))
            return fail_word(Alarm::AddressIllegal, word, axis_name(word.axis));
    const auto shown = [&](std::size_t i) {
        return counts_diameter(static_cast<unsigned>(i), false) ? target[i] * 2 : target[i];
    };
    curve.table.points.push_back({shown(curve.leads), shown(curve.follows)});
    core_.path.programmed = target;  // increments count from the table's last point
    state_changed_ = true;
    return true;
}

bool Interpreter::p_ctabend(Call&) {
    if (!modal_.curve) return fail(Alarm::CodesContradict, "CTABEND");
    CurveDefinition curve = std::move(*modal_.curve);
    modal_.curve.reset();
    core_.path.programmed = modal_.before_curve;
    state_changed_ = true;
    std::vector<CurveTable::Point>& points = curve.table.points;
    // it must go one way, from point to point
    if (points.size() < 2) return fail(Alarm::FunctionArgument, "CTABDEF", 2);
    if (points.back().lead < points.front().lead) std::ranges::reverse(points);
    for (std::size_t i = 1; i < points.size(); ++i)
        // it must go one way, from point to point
        if (!(points[i].lead > points[i - 1].lead))
            return fail(Alarm::FunctionArgument, "CTABDEF", 2);
    CurveTables after = curve_tables_;
    const bool dynamic = curve.table.dynamic;
    after[curve.number] = std::move(curve.table);
    // no room for it
    if (tables_in(after, dynamic) > kTables || segments_in(after, dynamic) > kSegments)
        return fail(Alarm::FunctionArgument, "CTABDEF", 3);
    undo([this, before = curve_tables_] { curve_tables_ = before; });
    curve_tables_ = std::move(after);
    return true;
}

// CTABDEL([n[, m[, memory]]]), CTABLOCK, CTABUNLOCK(n[, m]): tables n to m, n alone, or all of
// them.
bool Interpreter::p_ctab_each(Call& c) {
    const std::string_view name = block_.procedures.front().first->name;
    const auto memory = memory_named(c, 2);
    if (!memory) return fail(Alarm::FunctionArgument, std::string(name), 3);
    const double from = c.number(0, 1), to = c.has(1) ? c.number(1) : c.has(0) ? from : kMostNumber;
    undo([this, before = curve_tables_] { curve_tables_ = before; });
    for (auto one = curve_tables_.begin(); one != curve_tables_.end();) {
        const bool meant =
            one->first >= from && one->first <= to && (!c.has(2) || one->second.dynamic == *memory);
        if (meant && name == "CTABDEL" && is_coupled(one->first))
            return fail(Alarm::CodesContradict, fmt::format("CTABDEL({}), LEADON", one->first));
        if (meant && name == "CTABDEL" && one->second.locked)
            return fail(Alarm::CodesContradict, fmt::format("CTABDEL({}), CTABLOCK", one->first));
        if (meant && name != "CTABDEL") one->second.locked = name == "CTABLOCK";
        one = meant && name == "CTABDEL" ? curve_tables_.erase(one) : std::next(one);
    }
    return true;
}

// --- positions

const CurveTable* Interpreter::curve_table(const Call& c, std::size_t i) {
    const auto found = curve_tables_.find(static_cast<int>(c.number(i)));
    if (found != curve_tables_.end()) return &found->second;
    fail(Alarm::FunctionArgument, "CTAB", static_cast<double>(i + 1));
    return nullptr;
}

bool Interpreter::curve_sample(Call& c, std::size_t slope, const CurveTable::Sample& sample,
                               double value) {
    store(c.arguments[slope].reference, Value::of_real(sample.slope));
    c.result = Value::of_real(value);
    return true;
}

bool Interpreter::f_ctab(Call& c) {  // (lead, n, VAR slope): following position
    const CurveTable* table = curve_table(c, 1);
    return table && curve_sample(c, 2, table->at(c.number(0)), table->at(c.number(0)).value);
}
bool Interpreter::f_ctabinv(Call& c) {  // (follow, about, n, VAR slope): leading position
    const CurveTable* table = curve_table(c, 2);
    if (!table) return false;
    const CurveTable::Sample sample = table->inverse(c.number(0), c.number(1));
    return curve_sample(c, 3, sample, sample.value);
}
// (lead, n, VAR slope): following position where its segment begins
bool Interpreter::f_ctabssv(Call& c) {
    const CurveTable* table = curve_table(c, 1);
    return table && curve_sample(c, 2, table->segment_start(c.number(0)),
                                 table->segment_start(c.number(0)).value);
}
bool Interpreter::f_ctabsev(Call& c) {  // and where it ends
    const CurveTable* table = curve_table(c, 1);
    return table && curve_sample(c, 2, table->segment_end(c.number(0)),
                                 table->segment_end(c.number(0)).value);
}
// (n, VAR slope): at the table's beginning and end, of the following (V) and the leading axis (P).
bool Interpreter::f_ctabtsv(Call& c) {
    const CurveTable* table = curve_table(c, 0);
    return table && curve_sample(c, 1, table->segment_start(table->points.front().lead),
                                 table->points.front().follow);
}
bool Interpreter::f_ctabtsp(Call& c) {
    const CurveTable* table = curve_table(c, 0);
    return table && curve_sample(c, 1, table->segment_start(table->points.front().lead),
                                 table->points.front().lead);
}
bool Interpreter::f_ctabtev(Call& c) {
    const CurveTable* table = curve_table(c, 0);
    return table && curve_sample(c, 1, table->last(), table->points.back().follow);
}
bool Interpreter::f_ctabtep(Call& c) {
    const CurveTable* table = curve_table(c, 0);
    return table && curve_sample(c, 1, table->last(), table->points.back().lead);
}
bool Interpreter::curve_extreme(Call& c, bool largest) {  // (n[, a, b])
    const CurveTable* table = curve_table(c, 0);
    if (!table) return false;
    c.result = Value::of_real(table->extreme(c.number(1, table->points.front().lead),
                                             c.number(2, table->points.back().lead), largest));
    return true;
}
bool Interpreter::f_ctabtmin(Call& c) { return curve_extreme(c, false); }
bool Interpreter::f_ctabtmax(Call& c) { return curve_extreme(c, true); }

// --- what there is

// Of the table n: `facts` where it exists, -1 (CTABEXISTS: FALSE) where not.
bool Interpreter::curve_fact(Call& c, const std::function<double(const CurveTable&)>& fact) {
    const auto found = curve_tables_.find(static_cast<int>(c.number(0)));
    c.result = Value::of_int(found == curve_tables_.end() ? -1.0 : fact(found->second));
    return true;
}
bool Interpreter::f_ctabexists(Call& c) {
    c.result = Value::of_bool(curve_tables_.contains(static_cast<int>(c.number(0))));
    return true;
}
bool Interpreter::f_ctabislock(Call& c) {  // 1 CTABLOCK, 2 LEADON, 3 both
    const bool coupled = is_coupled(static_cast<int>(c.number(0)));
    return curve_fact(c, [coupled](const CurveTable& t) {
        return (t.locked ? 1.0 : 0.0) + (coupled ? 2.0 : 0.0);
    });
}
bool Interpreter::f_ctabmemtyp(Call& c) {
    return curve_fact(c, [](const CurveTable& t) { return t.dynamic ? 1.0 : 0.0; });
}
bool Interpreter::f_ctabperiod(Call& c) {
    return curve_fact(c, [](const CurveTable& t) { return static_cast<double>(t.periodic); });
}
bool Interpreter::f_ctabsegid(Call& c) {  // (n, "L" or "P")
    const bool lines = !c.has(1) || upper(c.value(1).text) == "L";
    return curve_fact(c, [lines](const CurveTable& t) {
        return lines ? static_cast<double>(t.segments()) : 0.0;
    });
}
bool Interpreter::f_ctabpolid(Call& c) {
    return curve_fact(c, [](const CurveTable&) { return 0.0; });
}
bool Interpreter::f_ctabid(Call& c) {  // (p, memory): number of the p-th table there
    const auto memory = memory_named(c, 1);
    double left = c.number(0);
    for (const auto& [number, table] : curve_tables_)
        if (memory && (!c.has(1) || table.dynamic == *memory) && --left == 0) {
            c.result = Value::of_int(number);
            return true;
        }
    c.result = Value::of_int(-1);
    return true;
}
bool Interpreter::f_ctabno(Call& c) {
    c.result = Value::of_int(static_cast<double>(curve_tables_.size()));
    return true;
}

// In a memory: how many tables, segments or polynomials are in use, free, and possible. -1: there
// is no such memory.
bool Interpreter::curve_memory(Call& c, CurveFigure figure,
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
    const double now = used(curve_tables_, *memory);
    c.result = Value::of_int(figure == CurveFigure::Used   ? now
                             : figure == CurveFigure::Free ? most - now
                                                           : most);
    return true;
}
bool Interpreter::f_ctabnomem(Call& c) {
    return curve_memory(c, CurveFigure::Used, &tables_in, kTables);
}
bool Interpreter::f_ctabfno(Call& c) {
    return curve_memory(c, CurveFigure::Free, &tables_in, kTables);
}
bool Interpreter::f_ctabseg(Call& c) {
    return curve_memory(c, CurveFigure::Used, &segments_in, kSegments);
}
bool Interpreter::f_ctabfseg(Call& c) {
    return curve_memory(c, CurveFigure::Free, &segments_in, kSegments);
}
bool Interpreter::f_ctabmseg(Call& c) {
    return curve_memory(c, CurveFigure::Most, &segments_in, kSegments);
}
bool Interpreter::f_ctabpol(Call& c) { return curve_memory(c, CurveFigure::Used, &polynomials, 0); }
bool Interpreter::f_ctabfpol(Call& c) {
    return curve_memory(c, CurveFigure::Free, &polynomials, 0);
}
bool Interpreter::f_ctabmpol(Call& c) {
    return curve_memory(c, CurveFigure::Most, &polynomials, 0);
}

}  // namespace polyturn::channels::sinumerik
