// The pallet table (nct part 2, 34): a row for the pallet in the working area, one for the loading
// station where there is one (N3300 MNT), one for each place of the pool (N3301). Each pallet has
// its number, its program and free columns (N3302).
#include <algorithm>
#include <bitset>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/shortest_text.hpp"
#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

struct Layout {
    bool on = false, loading = false, by_path = false;
    std::int32_t rows = 0, columns = 0;
};
Layout layout_of(const StoreValues& values) {
    namespace p = params;
    Layout out;
    out.on = p::bit(values.parameters, p::n3300_pallet_contr, 0);
    out.loading = p::bit(values.parameters, p::n3300_pallet_contr, 1);
    out.by_path = p::bit(values.parameters, p::n3300_pallet_contr, 3);
    out.rows = 1 + (out.loading ? 1 : 0) +
               static_cast<std::int32_t>(p::get(values.parameters, p::n3301_pallet_pool_length));
    out.columns =
        static_cast<std::int32_t>(p::get(values.parameters, p::n3302_no_of_custom_columns));
    return out;
}

std::string station(const Layout& layout, std::int32_t row) {
    if (row == 1) return "working area";
    if (layout.loading && row == 2) return "loading station";
    return "pool " + std::to_string(row - (layout.loading ? 2 : 1));
}

Key key_of(std::int32_t row, std::string name) {
    return {Kind::Pallet, 0, row, 0, std::move(name)};
}

Json row_json(const StoreValues& values, const Layout& layout, std::int32_t row) {
    const auto number = [&](const std::string& name) {
        const Cell* cell = values.cell(key_of(row, name));
        return cell ? cell->number : 0.0;
    };
    const Cell* program = values.cell(key_of(row, "program"));
    Json out = {{"row", row},
                {"station", station(layout, row)},
                {"pallet", number("pallet")},
                {"program", program ? program->text : std::string()}};
    for (std::int32_t k = 1; k <= layout.columns; ++k)
        out["custom" + std::to_string(k)] = number("custom" + std::to_string(k));
    if (layout.columns > 0)
        out["custom1"] = std::bitset<8>(static_cast<unsigned long>(number("custom1"))).to_string();
    return out;
}

void set_row(Work& work, const Layout& layout, std::int32_t row, const Json& fields) {
    for (const auto& [name, value] : fields.items()) {
        const std::string text = read_text(fields, name.c_str());
        if (name == "program") {
            const bool digits =
                !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
            if (!text.empty() && !layout.by_path &&
                !(digits && (text.size() == 4 || text.size() == 8)))
                work.fault(Alarm::StoreRequestBad,
                           "program " + text + ": 4 or 8 digits (N3300 PRI = 0)", row, name);
            else if (text.size() > 500)
                work.fault(Alarm::StoreRequestBad, "program: the path is too long", row, name);
            else
                set_text(work.values, key_of(row, "program"), text, work.changes);
            continue;
        }
        double real = 0;
        const bool custom = name.rfind("custom", 0) == 0 && name.size() == 7 && name[6] >= '1' &&
                            name[6] - '0' <= layout.columns;
        if (name != "pallet" && !custom) {
            work.fault(Alarm::StoreRequestBad, "there is no column " + name, row, name);
            continue;
        }
        // eight bits, bit 7 first
        if (name == "custom1" && text.size() == 8 &&
            text.find_first_not_of("01") == std::string::npos)
            real = static_cast<double>(std::stoul(text, nullptr, 2));
        else if (!read_real(fields, name.c_str(), real, work))
            continue;
        const bool whole = name == "pallet" || name == "custom1";
        const double most = name == "custom1" ? 255 : name == "pallet" ? 9999 : 1e9;
        if ((whole && (real < 0 || real != std::trunc(real))) || std::fabs(real) > most)
            work.fault(Alarm::StoreRequestBad,
                       name + "=" + text + ": " + (whole ? "a whole number from 0" : "") + " to " +
                           shortest_text(most),
                       row, name);
        else
            set_value(work.values, key_of(row, name), real == 0 ? std::nan("") : real,
                      work.changes);
    }
    // One pallet in two places cannot be.
    for (std::int32_t other = 1; other <= layout.rows; ++other) {
        const Cell *a = work.values.cell(key_of(row, "pallet")),
                   *b = work.values.cell(key_of(other, "pallet"));
        if (other != row && a && b && a->number == b->number)
            work.fault(Alarm::StoreRequestBad,
                       "pallet " + shortest_text(a->number) + " stands in " +
                           station(layout, other) + " too",
                       row, "pallet");
    }
}

}  // namespace

Json pallet_operation(std::string_view what, const Json& request, Work& work) {
    const Layout layout = layout_of(work.values);
    if (!layout.on) {
        work.fault(Alarm::StoreRequestBad, "this machine has no pallets (N3300 PAL)");
        return Json();
    }
    if (what == "list") {
        Json out = Json::array();
        for (std::int32_t row = 1; row <= layout.rows; ++row)
            out.push_back(row_json(work.values, layout, row));
        return {{"pallets", std::move(out)}};
    }
    std::int64_t row = 0, to = 0;
    const auto read_row = [&](const char* key, std::int64_t& out) {
        if (!read_whole(request, key, out, work)) return false;
        if (out >= 1 && out <= layout.rows) return true;
        work.fault(Alarm::StoreRequestBad,
                   std::string(key) + " " + std::to_string(out) + ": the table has " +
                       std::to_string(layout.rows) + " rows (N3300, N3301)",
                   0, key);
        return false;
    };
    if (!read_row("row", row)) return {};
    if (what == "set") {
        set_row(work, layout, static_cast<std::int32_t>(row), read_object(request, "fields", work));
        return row_json(work.values, layout, static_cast<std::int32_t>(row));
    }
    if (what == "exchange") {  // whole rows: what stands there goes along with its program
        if (!read_row("with", to)) return {};
        for (const char* name : {"pallet", "program", "custom1", "custom2", "custom3", "custom4"}) {
            const Key from = key_of(static_cast<std::int32_t>(row), name),
                      into = key_of(static_cast<std::int32_t>(to), name);
            const Cell* first = work.values.cell(from);
            const Cell* second = work.values.cell(into);
            const bool text = std::string_view(name) == "program";
            const Cell a = first ? *first : Cell{std::nan(""), {}, text},
                       b = second ? *second : Cell{std::nan(""), {}, text};
            if (text) {
                set_text(work.values, from, b.text, work.changes);
                set_text(work.values, into, a.text, work.changes);
            } else {
                set_value(work.values, from, b.number, work.changes);
                set_value(work.values, into, a.number, work.changes);
            }
        }
        return {{"row", row}, {"with", to}};
    }
    work.fault(Alarm::StoreRequestBad, "pallets." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
