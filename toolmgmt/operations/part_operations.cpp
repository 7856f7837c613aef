// Measured parts: dimensions with nominal and tolerance and the tool that makes them. A measured
// value proposes a correction of that tool's wear; it is written only when somebody accepts it.
//
//   deviation   measured - nominal, of each part since the last correction
//   proposal    (middle of the tolerance - mean of the newest `average` deviations) * share, at
//               most `limit` up or down; added to the wear of the axis (of an offset, or of an edge
//               of the tool); half of it where that is a radius and the axis shows diameters. The
//               nominal itself may be a limit (30 h6): brought there, every second part is scrap.
//   trend       straight line through the deviations since the last correction: mm a part, and
//               after how many more parts the dimension leaves its tolerance at that rate
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/model/machine/store/edge_lengths.hpp"
#include "ipc/params/registry.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/operations/offset_rules.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr int kKept = 50;  // measured values of a dimension

struct Column {
    const char* name;
    double least, most, fallback;
    bool needed;
};
constexpr Column kColumns[] = {
    {"nominal", -1e5, 1e5, 0, true},
    {"upper", -1e3, 1e3, 0, true},
    {"lower", -1e3, 1e3, 0, true},
    {"tool", 1, 1000, 0, false},
    {"channel", 1, 16, 1, false},
    {"offset", 1, 999, 0, false},
    {"edge", 0, kMostEdgesOfTool, 0, false},
    {"factor", -10, 10, 1, false},
    {"limit", 0, 10, 0.05, false},
    {"share", 0, 100, 100, false},
    {"average", 1, 20, 1, false},
};

Key dimension_key(std::int32_t number, std::string name) {
    return {Kind::Dimension, 0, number, 0, std::move(name)};
}
double value_of(const StoreValues& values, std::int32_t number, const char* name,
                double otherwise) {
    const Cell* cell = values.cell(dimension_key(number, name));
    return cell && !cell->is_text ? cell->number : otherwise;
}
std::string text_of(const StoreValues& values, std::int32_t number, const char* name) {
    const Cell* cell = values.cell(dimension_key(number, name));
    return cell ? cell->text : std::string();
}
bool exists(const StoreValues& values, std::int32_t number) {
    return values.cell(dimension_key(number, "nominal")) != nullptr;
}

std::vector<double> deviations(const StoreValues& values, std::int32_t number) {
    std::vector<double> out;
    const auto count = static_cast<int>(value_of(values, number, "count", 0));
    const double nominal = value_of(values, number, "nominal", 0);
    for (int i = std::max(0, count - kKept); i < count; ++i)
        out.push_back(value_of(values, number, ("m" + std::to_string(i % kKept)).c_str(), nominal) -
                      nominal);
    return out;
}

int axis_of(const StoreValues& values, std::int32_t number) {
    const std::string axis = text_of(values, number, "axis");
    return axis == "Z" ? 2 : axis == "Y" ? 1 : 0;
}

std::int32_t cell_of(const StoreValues& values, std::int32_t number) {
    if (const auto offset = static_cast<std::int32_t>(value_of(values, number, "offset", 0)))
        return offset;
    const ToolRow* row =
        values.tool(static_cast<std::int64_t>(value_of(values, number, "tool", 0)));
    return row && row->used ? row->h_cell : 0;
}

// D of the dimension's tool that it corrects; 0: an offset is corrected. Where neither was said,
// the language of the channel decides.
std::int32_t edge_of(const StoreValues& values, std::int32_t number) {
    const auto tool = static_cast<std::int32_t>(value_of(values, number, "tool", 0)),
               said = static_cast<std::int32_t>(value_of(values, number, "edge", 0));
    const ToolRow* row = values.tool(tool);
    if (!row || !row->used || value_of(values, number, "offset", 0) != 0) return 0;
    if (said) return said;
    const auto channel = static_cast<unsigned>(value_of(values, number, "channel", 1));
    const bool by_edges =
        row->h_cell == 0 ||
        params::get_text(values.parameters, params::pt_language, channel) == "sinumerik";
    return by_edges && find_edge(values, tool, 1) ? 1 : 0;
}

// How much of a deviation is added to the wear: where positions of the axis are diameters, a table
// of radii takes half.
double share_of(const StoreValues& values, const MachineConfig& machine, std::int32_t number) {
    const auto channel = static_cast<std::size_t>(value_of(values, number, "channel", 1));
    constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};
    const AxisConfig* axis = find_axis(machine, channel, kRoles[axis_of(values, number)]);
    return !axis ? 1.0 : edge_of(values, number) ? share_in_edges(*axis) : share_in_offsets(*axis);
}

// Millimetres a part; 0 from less than two.
double slope(const std::vector<double>& y) {
    const auto n = static_cast<double>(y.size());
    if (n < 2) return 0;
    double sx = 0, sy = 0, sxy = 0, sxx = 0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const auto x = static_cast<double>(i);
        sx += x;
        sy += y[i];
        sxy += x * y[i];
        sxx += x * x;
    }
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

Json dimension(const Work& work, std::int32_t number) {
    const StoreValues& values = work.values;
    Json out = {{"dimension", number},
                {"name", text_of(values, number, "name")},
                {"axis", std::string(1, "XYZ"[axis_of(values, number)])},
                {"cell", cell_of(values, number)}};
    for (const Column& column : kColumns)
        out[column.name] = value_of(values, number, column.name, column.fallback);
    out["edge"] = edge_of(values, number);  // that it corrects
    const auto all = deviations(values, number);
    const double upper = value_of(values, number, "upper", 0),
                 lower = value_of(values, number, "lower", 0);
    out["measured"] = all.size();
    if (all.empty()) return out;
    const double last = all.back();
    // since the last correction, the newest last
    for (const double one : all) out["deviations"].push_back(rounded(one));
    out["last"] = rounded(last + value_of(values, number, "nominal", 0));
    out["deviation"] = rounded(last);
    out["verdict"] = last > upper ? "too large" : last < lower ? "too small" : "good";
    const auto window =
        std::min(all.size(), static_cast<std::size_t>(value_of(values, number, "average", 1)));
    double mean = 0;
    for (std::size_t i = all.size() - window; i < all.size(); ++i)
        mean += all[i] / static_cast<double>(window);
    const double limit = value_of(values, number, "limit", 0.05);
    const double wanted = ((upper + lower) / 2 - mean) * value_of(values, number, "share", 100) /
                          100.0 * value_of(values, number, "factor", 1) *
                          share_of(values, work.machine, number);
    out["mean"] = rounded(mean);
    out["proposal"] = rounded(std::clamp(wanted, -limit, limit));
    out["limited"] = std::fabs(wanted) > limit;
    const double rate = slope(all);
    out["trend"] = rounded(rate);
    const double way = rate > 0 ? upper - last : rate < 0 ? last - lower : 0;
    if (std::fabs(rate) > 1e-9 && all.size() >= 3)
        out["parts_to_limit"] = std::max(0.0, std::floor(way / std::fabs(rate) + 1e-6));
    return out;
}

// A column's value may be an entry: {"delta":0.01} is added to what stands there.
bool read_column(Work& work, const Json& fields, std::int32_t number, const Column& column,
                 double& out) {
    const Json& value = fields[column.name];
    if (!value.is_object()) return read_real(fields, column.name, out, work);
    const std::string what = "dimension " + std::to_string(number) + " " + column.name;
    return read_entry(value, value_of(work.values, number, column.name, column.fallback), what, out,
                      work);
}

bool read_fields(Work& work, const Json& request, std::int32_t number, bool fresh) {
    const Json fields = read_object(request, "fields", work);
    for (const auto& [name, value] : fields.items()) {
        if (name == "name" || name == "axis") {
            const std::string text = read_text(fields, name.c_str());
            if (name == "axis" && text != "X" && text != "Y" && text != "Z")
                work.fault(Alarm::StoreRequestBad, "axis=" + text + ": X, Y or Z", 0, name);
            else if (text.size() > 60)
                work.fault(Alarm::StoreRequestBad, "name: at most 60 characters", 0, name);
            else
                set_text(work.values, dimension_key(number, name), text, work.changes);
            continue;
        }
        const auto* column =
            std::find_if(std::begin(kColumns), std::end(kColumns),
                         [&, wanted = name](const Column& c) { return wanted == c.name; });
        double real = 0;
        if (column == std::end(kColumns))
            work.fault(Alarm::StoreRequestBad, "there is no column " + name, 0, name);
        else if (read_column(work, fields, number, *column, real)) {
            if (real < column->least || real > column->most)
                work.fault(Alarm::StoreRequestBad,
                           name + "=" + shortest_text(real) + ": " + shortest_text(column->least) +
                               " to " + shortest_text(column->most),
                           0, name);
            else
                set_value(work.values, dimension_key(number, name), real, work.changes);
        }
    }
    if (fresh)
        for (const Column& column : kColumns)
            if (column.needed && !fields.contains(column.name))
                work.fault(Alarm::StoreRequestBad, std::string(column.name) + " is missing", 0,
                           column.name);
    if (value_of(work.values, number, "upper", 0) < value_of(work.values, number, "lower", 0))
        work.fault(Alarm::StoreRequestBad, "upper lies below lower", 0, "upper");
    return work.good();
}

void forget(Work& work, std::int32_t number) {
    for (int i = 0; i < kKept; ++i)
        set_value(work.values, dimension_key(number, "m" + std::to_string(i)), std::nan(""),
                  work.changes);
    set_value(work.values, dimension_key(number, "count"), std::nan(""), work.changes);
}

}  // namespace

Json part_operation(std::string_view what, const Json& request, Work& work) {
    StoreValues& values = work.values;
    if (what == "list") {
        Json out = Json::array();
        for (std::int32_t n = 1; n <= 999; ++n)
            if (exists(values, n)) out.push_back(dimension(work, n));
        return {{"dimensions", std::move(out)}};
    }
    std::int64_t asked = 0;
    if (what == "add" && !request.contains("dimension"))
        for (asked = 1; asked <= 999 && exists(values, static_cast<std::int32_t>(asked));) ++asked;
    else if (!read_whole(request, "dimension", asked, work))
        return {};
    if (asked < 1 || asked > 999) {
        work.fault(Alarm::StoreRequestBad, "dimensions are 1 to 999", 0, "dimension");
        return Json();
    }
    const auto number = static_cast<std::int32_t>(asked);
    if (what == "add") {
        if (exists(values, number)) {
            work.fault(Alarm::StoreRequestBad, "dimension " + std::to_string(number) + " exists");
            return Json();
        }
        if (!read_fields(work, request, number, true)) return {};
        return dimension(work, number);
    }
    if (!exists(values, number)) {
        work.fault(Alarm::StoreRequestBad, "there is no dimension " + std::to_string(number));
        return Json();
    }
    if (what == "set") {
        read_fields(work, request, number, false);
    } else if (what == "delete") {
        for (const Column& column : kColumns)
            set_value(values, dimension_key(number, column.name), std::nan(""), work.changes);
        for (const char* name : {"name", "axis"})
            set_text(values, dimension_key(number, name), {}, work.changes);
        forget(work, number);
        return {{"dimension", number}};
    } else if (what == "measure") {
        double value = 0;
        if (!read_real(request, "value", value, work)) return {};
        const double nominal = value_of(values, number, "nominal", 0);
        if (std::fabs(value - nominal) > 10.0) {
            work.fault(Alarm::StoreRequestBad,
                       shortest_text(value) + " is more than 10 mm from the nominal " +
                           shortest_text(nominal) + ": another dimension or unit?");
            return Json();
        }
        const double count = value_of(values, number, "count", 0);
        set_value(values,
                  dimension_key(number, "m" + std::to_string(static_cast<int>(count) % kKept)),
                  value, work.changes);
        set_value(values, dimension_key(number, "count"), count + 1, work.changes);
    } else if (what == "accept") {
        const Json now = dimension(work, number);
        double correction = 0;
        if (!now.contains("proposal") || !read_real(now, "proposal", correction, work)) {
            work.fault(Alarm::StoreRequestBad, "nothing was measured since the last correction");
            return Json();
        }
        // «expected»: the proposal that somebody has seen; «delta»: more or less than it, whatever
        // was measured meanwhile.
        if ((request.contains("value") || request.contains("delta")) &&
            !read_entry(request, correction, "the proposal", correction, work))
            return {};
        if (!request.contains("value") && !request.contains("delta") &&
            request.contains("expected") && !as_expected(request, correction, "the proposal", work))
            return {};
        const double limit = value_of(values, number, "limit", 0.05);
        if (std::fabs(correction) > limit) {
            work.fault(Alarm::StoreRequestBad,
                       "a correction of " + shortest_text(correction) + " mm: at most " +
                           shortest_text(limit),
                       0, "value");
            return Json();
        }
        const auto channel = static_cast<std::int32_t>(value_of(values, number, "channel", 1));
        if (const std::int32_t edge = edge_of(values, number)) {
            const auto tool = static_cast<std::int32_t>(value_of(values, number, "tool", 0));
            const int dp = edge_parameter(work, channel, tool, edge, 1, axis_of(values, number));
            if (dp < 0) {
                work.fault(Alarm::StoreRequestBad,
                           "tool " + std::to_string(tool) + " D" + std::to_string(edge) +
                               " has no length along " +
                               std::string(1, "XYZ"[axis_of(values, number)]));
                return Json();
            }
            const ToolEdge* found = find_edge(values, tool, edge);
            const double before = found ? found->dp[static_cast<std::size_t>(dp)] : 0.0;
            if (!enter_edge(work, channel, tool, edge, dp, rounded(before + correction))) return {};
            forget(work, number);
            return {{"what", describe(Key{Kind::Edge, tool, edge, dp, {}})},
                    {"old", before},
                    {"new", rounded(before + correction)}};
        }
        const std::int32_t cell = cell_of(values, number);
        if (cell == 0) {
            work.fault(Alarm::StoreRequestBad, "dimension " + std::to_string(number) +
                                                   " names neither an offset nor a tool with one");
            return Json();
        }
        const int axis = axis_of(values, number);
        const Key key = offset_key(work, channel, cell, 1, axis);
        const double* wear = number_at(values, key);
        const double before = wear ? *wear : 0;
        if (!enter_offset(work, channel, cell, 1, axis, rounded(before + correction))) return {};
        // what was measured before the correction says nothing about the next part
        forget(work, number);
        return {{"what", describe(key)}, {"old", before}, {"new", rounded(before + correction)}};
    } else {
        work.fault(Alarm::StoreRequestBad, "parts." + std::string(what));
        return Json();
    }
    return dimension(work, number);
}

}  // namespace polyturn::toolmgmt
