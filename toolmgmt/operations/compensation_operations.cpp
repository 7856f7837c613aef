// Measured errors that an operator enters or imports: cells of pitch and straightness tables,
// points of a grid (nct_parameters_part2 26 to 28). They are kept in the machine's own file; the
// kernel takes it when all axes rest.
//
//   {"do":"compensation.set","cells":[[10500,0.0012]],"points":[[1,17,0,0.001]]}
//                            points: channel, point, component 0 to 2, value
//   {"do":"compensation.set","cells":[[10500,{"delta":0.001}]]}
//                            on top of what the file has; also with "expected"
//   {"do":"compensation.import","file":"/usb/measured.compensation"}
//                            whole; it must fit the parameters
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "ipc/model/compensation/compensation_cells.hpp"
#include "ipc/model/compensation/compensation_tables.hpp"
#include "ipc/model/files/read_file.hpp"
#include "ipc/model/files/replace_file.hpp"
#include "toolmgmt/cell_requests.hpp"
#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr double kLargestValue = static_cast<double>(std::numeric_limits<float>::max());
using PointKey = std::tuple<unsigned, std::int64_t, unsigned>;  // channel, number, component

// A row of numbers, so many of them; whole but for the last one, which is a value, or an entry:
// {"delta":0.001}.
bool read_row(const Json& row, std::size_t count, std::vector<double>& out, Work& work,
              const char* column) {
    out.clear();
    bool good = row.is_array() && row.size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
        if (i + 1 == count && row[i].is_object()) {
            out.push_back(0);
            continue;
        }
        good = row[i].is_number();
        if (good) out.push_back(row[i].get<double>());
        good = good && (i + 1 == count ? std::abs(out[i]) <= kLargestValue
                                       : out[i] == std::trunc(out[i]) && std::abs(out[i]) < 1e9);
    }
    if (!good)
        work.fault(Alarm::StoreRequestBad, std::string(column) + ": not a number", 0, column);
    return good;
}

// As people write it: 0.0012 and not what a float makes of it.
double written(float value) {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    double out = 0;
    std::from_chars(digits, end.ptr, out);
    return out;
}

// What is in the file, with what this request has entered so far.
class Present {
public:
    explicit Present(std::string_view content) {
        std::vector<Diagnosis> ignored;  // lines that cannot be read stay as they are
        tables_ = parse_compensation(content, {}, ignored);
    }
    double cell(std::int64_t number) const {
        const auto found = cells_.find(number);
        return found != cells_.end() ? found->second
                                     : written(static_cast<float>(tables_.cell(number)));
    }
    double point(const PointKey& key) const {
        if (const auto found = points_.find(key); found != points_.end()) return found->second;
        const auto& [channel, number, component] = key;
        const auto& all = tables_.points[channel - 1];
        const float value = static_cast<std::size_t>(number) < all.size()
                                ? all[static_cast<std::size_t>(number)][component]
                                : 0.0F;
        return std::isnan(value) ? 0.0 : written(value);
    }
    void enter(std::int64_t number, double value) { cells_[number] = value; }
    void enter(const PointKey& key, double value) { points_[key] = value; }

private:
    CompensationTables tables_;
    std::map<std::int64_t, double> cells_;
    std::map<PointKey, double> points_;
};

// The value of a row's last element; an entry is on top of `present`.
bool read_value(const Json& last, double present, const std::string& what, double& out,
                Work& work) {
    if (!last.is_object()) {
        out = last.get<double>();
        return true;
    }
    if (!read_entry(last, present, what, out, work)) return false;
    if (std::abs(out) <= kLargestValue) return true;
    work.fault(Alarm::StoreRequestBad, what + ": not a number");
    return false;
}

Json told_of(const std::string& what, double before, double value) {
    return {{"what", what}, {"old", before}, {"new", written(static_cast<float>(value))}};
}

void wrong_table(Work& work, std::string detail, const char* column) {
    work.fault(Diagnosis{Alarm::CompensationTable, {}, {}, std::move(detail)}, 0, column);
}

Json set_cells(const Json& request, Work& work) {
    std::vector<CellEntry> cells;
    std::vector<PointEntry> points;
    std::vector<double> row;
    const Json none = Json::array();
    if (work.compensation_file.empty()) {
        wrong_table(work, "the machine has no folder for it", "");
        return Json();
    }
    const Result<std::string> content = read_compensation(work.compensation_file);
    if (!content) {
        work.fault(content.diagnosis());
        return Json();
    }
    Present present(*content);
    Json entries = Json::array();
    for (const Json& one : request.contains("cells") ? request["cells"] : none) {
        if (!read_row(one, 2, row, work, "cells")) continue;
        const auto number = static_cast<std::int64_t>(row[0]);
        if (number < kFirstCell || number > kLastCell) {
            wrong_table(work, "no cell of the table: " + std::to_string(number), "cells");
            continue;
        }
        const std::string what = "cell " + std::to_string(number);
        const double before = present.cell(number);
        double value = 0;
        if (!read_value(one[1], before, what, value, work)) continue;
        cells.push_back({number, static_cast<float>(value)});
        present.enter(number, value);
        entries.push_back(told_of(what, before, value));
    }
    for (const Json& one : request.contains("points") ? request["points"] : none) {
        if (!read_row(one, 4, row, work, "points")) continue;
        const auto channel = static_cast<std::int64_t>(row[0]),
                   number = static_cast<std::int64_t>(row[1]),
                   component = static_cast<std::int64_t>(row[2]);
        if (channel < 1 || channel > static_cast<std::int64_t>(kMaxChannels) ||
            !work.machine.channel(static_cast<std::size_t>(channel)).exists()) {
            work.fault(Alarm::StoreRequestBad,
                       "channel L" + std::to_string(channel) + " does not exist", 0, "points");
            continue;
        }
        const CompensationGrid grid =
            compensation_grid(work.values.parameters, static_cast<unsigned>(channel));
        const std::string where = "L" + std::to_string(channel) + ": ";
        if (number < 0 || number >= grid.points() || component < 0 || component > 2 ||
            grid.axis[static_cast<std::size_t>(component)] == 0) {
            wrong_table(work, where + "the grid has no point " + std::to_string(number), "points");
            continue;
        }
        const PointKey key{static_cast<unsigned>(channel), number,
                           static_cast<unsigned>(component)};
        const std::string what =
            where + "point " + std::to_string(number) + " " + std::to_string(component);
        const double before = present.point(key);
        double value = 0;
        if (!read_value(one[3], before, what, value, work)) continue;
        if (number == grid.number(grid.zero) && value != 0) {
            wrong_table(
                work,
                where + "point " + std::to_string(number) + " is machine zero and must be 0 0 0",
                "points");
            continue;
        }
        points.push_back({std::get<0>(key), number, std::get<2>(key), static_cast<float>(value)});
        present.enter(key, value);
        entries.push_back(told_of(what, before, value));
    }
    if (work.good() && cells.empty() && points.empty())
        work.fault(Alarm::StoreRequestBad, "cells is missing", 0, "cells");
    if (!work.good()) return {};
    std::string text = with_cells(*content, work.values.parameters, cells, points, Gaps::Filled);
    Json answer = {{"cells", cells.size() + points.size()}, {"entries", std::move(entries)}};
    // Kept nevertheless: of a table that repeats, both ends have to change, one after the other.
    // The kernel goes on with what it has until the table is right.
    std::vector<Diagnosis> faults;
    check_compensation_tables(work.values.parameters, parse_compensation(text, {}, faults), {},
                              faults);
    if (!faults.empty()) {
        const Json told = Json::parse(answer_text({}, {Fault{faults.front(), 0, {}}}));
        answer["warning"] = told["text"];
        answer["warning_number"] = told["number"];
    }
    work.after.push_back([path = work.compensation_file, text = std::move(text)] {
        return text::replace_file(path, text);
    });
    return answer;
}

Json import_cells(const Json& request, Work& work) {
    const std::string file = read_text(request, "file");
    if (file.empty()) {
        work.fault(Alarm::StoreRequestBad, "file is missing", 0, "file");
        return Json();
    }
    if (work.compensation_file.empty()) {
        wrong_table(work, "the machine has no folder for it", "");
        return Json();
    }
    Result<std::string> text = text::read_text_file(file);
    if (!text) {
        work.fault(text.diagnosis());
        return Json();
    }
    std::vector<Diagnosis> faults;
    check_compensation_tables(work.values.parameters, parse_compensation(*text, file, faults), file,
                              faults);
    constexpr std::size_t kMostFaults = 20;
    for (std::size_t i = 0; i < std::min(faults.size(), kMostFaults); ++i)
        work.fault(faults[i], static_cast<int>(faults[i].place.line));
    if (!work.good()) return {};
    work.after.push_back([path = work.compensation_file, text = std::move(*text)] {
        return text::replace_file(path, text);
    });
    return {{"file", work.compensation_file}};
}

}  // namespace

Json compensation_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "set") return set_cells(request, work);
    if (what == "import") return import_cells(request, work);
    work.fault(Alarm::StoreRequestBad, "compensation." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
