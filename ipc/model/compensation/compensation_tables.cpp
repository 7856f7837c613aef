#include "ipc/model/compensation/compensation_tables.hpp"

#include <charconv>
#include <cmath>
#include <filesystem>

#include "ipc/params/registry.hpp"
#include "ipc/model/files/read_file.hpp"

namespace polyturn {
namespace {

using namespace params;
constexpr std::array kGridAxis{n2700_1st_axis_of_3d_compensation, n2701_2nd_axis_of_3d_compensation,
                               n2702_3rd_axis_of_3d_compensation};
constexpr std::array kGridPoints{n2703_no_of_points_on_1st_axis, n2704_no_of_points_on_2nd_axis,
                                 n2705_no_of_points_on_3rd_axis};
constexpr std::array kGridZero{n2706_point_no_of_machine_zero_on_1st_axis,
                               n2707_point_no_of_machine_zero_on_2nd_axis,
                               n2708_point_no_of_machine_zero_on_3rd_axis};
constexpr std::array kGridInterval{n2709_comp_interval_on_1st_axis, n2710_comp_interval_on_2nd_axis,
                                   n2711_comp_interval_on_3rd_axis};
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// One line, read from the left.
class Line {
public:
    explicit Line(std::string_view text) : text_(text) {}
    void blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == ','))
            ++at_;
    }
    bool ended() {
        blanks();
        return at_ == text_.size() || text_[at_] == ';';
    }
    bool take(std::string_view word) {
        blanks();
        if (text_.substr(at_, word.size()) != word) return false;
        at_ += word.size();
        return true;
    }
    template <class T>
    bool number(T& out) {
        blanks();
        if (at_ < text_.size() && text_[at_] == '+') ++at_;
        const auto [end, error] =
            std::from_chars(text_.data() + at_, text_.data() + text_.size(), out);
        if (error != std::errc{}) return false;
        at_ = static_cast<std::size_t>(end - text_.data());
        return true;
    }
    std::uint32_t column() const { return static_cast<std::uint32_t>(at_) + 1; }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

Diagnosis fault(std::string_view file, std::uint32_t line, std::uint32_t column,
                std::string detail) {
    Diagnosis out;
    out.alarm = Alarm::CompensationTable;
    out.place = Place{std::string(file), line, column, 0};
    out.detail = std::move(detail);
    return out;
}

// "" or what is wrong with the line.
std::string take_cell(Line& line, CompensationTables& tables) {
    std::int64_t number = 0;
    float value = 0;
    if (!line.number(number) || !line.take("=") || !line.number(value))
        return "a line reads CELL=VALUE or 3D LCHANNEL POINT=X Y Z";
    if (number < kFirstCell || number > kLastCell)
        return "no cell of the table: " + std::to_string(number);
    if (!std::isfinite(value)) return "not a number";
    float& cell = tables.cells[static_cast<std::size_t>(number - kFirstCell)];
    if (!std::isnan(cell)) return "cell " + std::to_string(number) + " has a value already";
    cell = value;
    return {};
}

std::string take_point(Line& line, CompensationTables& tables) {
    unsigned channel = 0;
    std::int64_t point = 0;
    std::array<float, 3> value{};
    if (!line.take("L") || !line.number(channel) || !line.number(point) || !line.take("=") ||
        !line.number(value[0]) || !line.number(value[1]) || !line.number(value[2]))
        return "a line reads 3D LCHANNEL POINT=X Y Z";
    if (channel < 1 || channel > kMaxChannels) return "no such channel";
    if (point < 0 || point >= kMostGridPoints) return "no such point";
    auto& points = tables.points[channel - 1];
    if (points.size() <= static_cast<std::size_t>(point))
        points.resize(static_cast<std::size_t>(point) + 1, {kNone, kNone, kNone});
    if (!std::isnan(points[static_cast<std::size_t>(point)][0]))
        return "point " + std::to_string(point) + " has a value already";
    points[static_cast<std::size_t>(point)] = value;
    return {};
}

}  // namespace

std::int64_t CompensationGrid::points() const {
    std::int64_t all = described() ? 1 : 0;
    for (const std::int64_t one : count) {
        if (one > kMostGridPoints) return 0;
        all *= one;
        if (all > kMostGridPoints) return 0;
    }
    return all;
}

CompensationGrid compensation_grid(const Table& t, unsigned channel) {
    CompensationGrid out;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto axis = get(t, kGridAxis[i], channel);
        if (axis < 1 || axis > static_cast<std::int64_t>(kMaxAxes)) continue;
        out.axis[i] = static_cast<unsigned>(axis);
        out.count[i] = std::max<std::int64_t>(1, get(t, kGridPoints[i], channel));
        out.zero[i] = get(t, kGridZero[i], channel);
        out.interval[i] = get(t, kGridInterval[i], channel);
    }
    return out;
}

std::string compensation_file_of(std::string_view params_file) {
    if (params_file.empty()) return {};
    return std::filesystem::path(params_file).replace_extension(".compensation").string();
}

CompensationLine compensation_line(std::string_view text) {
    Line line(text);
    CompensationLine out;
    if (line.take("3D")) {
        if (!line.take("L") || !line.number(out.channel) || !line.number(out.point) ||
            !line.take("="))
            out = {};
    } else if (!line.number(out.cell) || !line.take("=")) {
        out = {};
    }
    return out;
}

CompensationTables parse_compensation(std::string_view content, std::string_view filename,
                                      std::vector<Diagnosis>& diagnoses) {
    CompensationTables tables;
    tables.measured = true;
    tables.cells.assign(static_cast<std::size_t>(kLastCell - kFirstCell + 1), kNone);
    std::uint32_t row = 0;
    while (!content.empty()) {
        ++row;
        const std::size_t end = std::min(content.find('\n'), content.size());
        std::string_view text = content.substr(0, end);
        content.remove_prefix(std::min(content.size(), end + 1));
        if (!text.empty() && text.back() == '\r') text.remove_suffix(1);
        Line line(text);
        if (line.ended()) continue;
        const std::string why =
            line.take("3D") ? take_point(line, tables) : take_cell(line, tables);
        if (!why.empty())
            diagnoses.push_back(fault(filename, row, line.column(), why));
        else if (!line.ended())
            diagnoses.push_back(
                fault(filename, row, line.column(), "something stands behind the value"));
    }
    return tables;
}

CompensationTables load_compensation(const std::string& path, std::vector<Diagnosis>& diagnoses) {
    std::error_code error;
    if (path.empty() || !std::filesystem::exists(path, error)) return {};
    const Result<std::string> content = text::read_text_file(path);
    if (content) return parse_compensation(*content, path, diagnoses);
    diagnoses.push_back(content.diagnosis());
    return {};
}

void check_compensation_tables(const Table& t, const CompensationTables& tables,
                               std::string_view filename, std::vector<Diagnosis>& diagnoses) {
    if (!tables.measured) return;
    const auto gaps = [&](std::int64_t first, std::int64_t last, const std::string& whose) {
        for (std::int64_t n = std::max(first, kFirstCell); n <= std::min(last, kLastCell); ++n)
            if (std::isnan(tables.cells[static_cast<std::size_t>(n - kFirstCell)]))
                return diagnoses.push_back(
                    fault(filename, 0, 0, whose + ": cell " + std::to_string(n) + " has no value"));
    };
    for (unsigned a = 1; a <= kMaxAxes; ++a) {
        const std::string axis = "A" + std::to_string(a);
        const auto first = get(t, n2503_primary_smallest_cell_no, a),
                   last = get(t, n2504_primary_largest_cell_no, a),
                   zero = get(t, n2502_cell_no_of_mach_zero, a);
        if (bit(t, n2500_pitch_comp_contr, a, 0)) {
            gaps(first, last, axis);
            const bool both = bit(t, n2500_pitch_comp_contr, a, 1);
            const auto second = get(t, n2505_primary_smallest_cell_no_both_dir, a);
            if (both) gaps(second, second + last - first, axis + " (negative direction)");
            // What a turn ends with it must begin with, or each turn moves the axis a little
            // further.
            if (bit(t, n2500_pitch_comp_contr, a, 2) &&
                std::fabs(tables.cell(zero) - tables.cell(last)) > 1e-9)
                diagnoses.push_back(fault(filename, 0, 0,
                                          axis + ": cyclic, but cell " + std::to_string(last) +
                                              " differs from cell " + std::to_string(zero) +
                                              " at machine zero"));
        }
        if (bit(t, n2500_pitch_comp_contr, a, 3))
            gaps(get(t, n2508_secondary_smallest_cell_no, a),
                 get(t, n2509_secondary_largest_cell_no, a), axis + " (periodic)");
    }
    for (unsigned l = 1; l <= kMaxChannels; ++l) {
        const bool simple = bit(t, n2600_straightness_comp_contr, l, 0);
        for (unsigned g = 1; g <= 6 && !simple; ++g) {
            const auto moving = get(t, nth(n2601_no_of_moving_axis_1, g), l);
            if (moving < 1 || moving > static_cast<std::int64_t>(kMaxAxes)) continue;
            const auto m = static_cast<unsigned>(moving);
            const auto first = get(t, nth(n2613_smallest_cell_no_of_moving_axis_1, g), l);
            gaps(first,
                 first + get(t, n2504_primary_largest_cell_no, m) -
                     get(t, n2503_primary_smallest_cell_no, m),
                 "L" + std::to_string(l) + " pair " + std::to_string(g));
        }
        const CompensationGrid grid = compensation_grid(t, l);
        const std::int64_t count = grid.points();
        if (count == 0) continue;
        const auto& points = tables.points[l - 1];
        // Machine zero is where it is: its point corrects nothing.
        const std::int64_t zero = grid.number(grid.zero);
        if (zero >= 0 && zero < static_cast<std::int64_t>(points.size()))
            for (const float value : points[static_cast<std::size_t>(zero)])
                if (value != 0 && !std::isnan(value)) {
                    diagnoses.push_back(fault(filename, 0, 0,
                                              "L" + std::to_string(l) + ": point " +
                                                  std::to_string(zero) +
                                                  " is machine zero and must be 0 0 0"));
                    break;
                }
        for (std::int64_t n = 0; n < count; ++n)
            if (n >= static_cast<std::int64_t>(points.size()) ||
                std::isnan(points[static_cast<std::size_t>(n)][0])) {
                diagnoses.push_back(fault(filename, 0, 0,
                                          "L" + std::to_string(l) + ": point " + std::to_string(n) +
                                              " of the grid has no value"));
                break;
            }
    }
}

}  // namespace polyturn
