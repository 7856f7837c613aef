// System variables of feeds, speeds and tool offsets that a program has set: $P_ and $PA_ as it is
// prepared, $AC_ and $AA_ as it is executed, which waits for a barrier (sinumerik_part1 6.8, 7.2,
// 8.1, 8.12).
#include "channels/sinumerik/variables/feed_variables.hpp"

#include <numbers>

#include "channels/sinumerik/execution.hpp"
#include "channels/sinumerik/faults.hpp"
#include "channels/sinumerik/flow/run.hpp"
#include "channels/sinumerik/geometry/units.hpp"

namespace polyturn::channels::sinumerik {
namespace {

constexpr PlaneRole kRoles[] = {PlaneRole::BasicX, PlaneRole::BasicY, PlaneRole::BasicZ};

// Does F count this axis?
bool feed_counts(const Execution& x, unsigned place) {
    const PlaneRole role = x.core.view().axes[place].role;
    const bool geometry =
        role == PlaneRole::BasicX || role == PlaneRole::BasicY || role == PlaneRole::BasicZ;
    return x.modal.feed_group_set ? (x.modal.feed_group >> place & 1u) != 0 : geometry;
}

}  // namespace

bool feed_value(Execution& x, const std::string& name, const std::vector<Value>& indices,
                const char* from, std::size_t length, Value& value, bool& known) {
    known = true;
    const bool live = name.starts_with("$AC_") || name.starts_with("$AA_");
    const std::size_t head = name.find('_');
    const std::string what = head == std::string::npos ? std::string() : name.substr(head + 1);
    const bool ours = live || name.starts_with("$P_") || name.starts_with("$PA_");
    const auto axis = [&]() -> int {
        const int place =
            indices.size() == 1 && indices[0].type == Type::Axis ? indices[0].place() : -1;
        return place >= 0 && place < static_cast<int>(x.core.view().axis_count) ? place : -1;
    };
    const auto spindle = [&]() -> double {
        if (indices.empty()) return x.modal.master_spindle;
        const double n =
            indices[0].type == Type::Axis ? indices[0].place() - kSpindleAxis : indices[0].number;
        return n == 0 ? x.modal.master_spindle : n;
    };
    const auto no_axis = [&] { return fail_at(x, Alarm::AxisArgumentMissing, from, length, name); };
    const auto no_element = [&](double n) {
        return fail_at(x, Alarm::ArrayIndexIllegal, from, length, name, n);
    };
    if (ours &&
        (what == "TOFFL" || what == "TOFF" || what == "TOFFR" || what == "FZ" || what == "F_TYPE" ||
         what == "SVC" || what == "S_TYPE" || what == "FGROUP" || what == "FGREF" ||
         what == "FGROUP_MASK" || name == "$AA_ACC" || name == "$P_GWPS")) {
        if (live && !need_fresh(x)) return false;
        if (what == "TOFFR") {
            value = Value::of_real(x.modal.toff.radius_mm / unit(x));
            return true;
        }
        if (what == "TOFFL") {
            const double n = indices.empty() ? 0.0 : indices[0].number;
            if (!(n >= 0 && n <= 3)) return no_element(n);
            const auto i = static_cast<std::size_t>(std::fmax(n, 1.0)) - 1;
            value =
                Value::of_real(x.modal.toff_by_axis ? 0.0 : x.modal.toff.length_mm[i] / unit(x));
            return true;
        }
        if (what == "TOFF") {
            if (axis() < 0) return no_axis();
            for (std::size_t i = 0; i < 3; ++i)
                if (x.core.view().axes[static_cast<std::size_t>(axis())].role == kRoles[i]) {
                    value = Value::of_real(
                        x.modal.toff_by_axis ? x.modal.toff.length_mm[i] / unit(x) : 0.0);
                    return true;
                }
            return no_axis();
        }
        if (what == "FZ") {
            value = Value::of_real(x.modal.feed_revolution ? x.modal.feed_per_tooth / feed_unit(x)
                                                           : 0.0);
            return true;
        }
        if (what == "F_TYPE") {
            const bool inch = !metric_technology(x);
            const int type = !x.modal.feed_revolution     ? (inch ? 2 : 0)
                             : x.modal.feed_per_tooth > 0 ? (inch ? 33 : 11)
                                                          : (inch ? 3 : 1);
            value = Value::of_int(type);
            return true;
        }
        if (what == "SVC" || what == "S_TYPE" || what == "GWPS") {
            const double n = spindle();
            if (!(n >= 1 && n <= kMaxSpindles)) return no_element(n);
            const auto s = static_cast<std::size_t>(n);
            if (what == "GWPS") {
                value = Value::of_bool(x.modal.wheel_speeds >> (s - 1) & 1u);
                return true;
            }
            const bool by_tool = x.modal.cutting_speeds >> (s - 1) & 1u;
            if (what == "SVC")
                value = Value::of_real(by_tool ? x.modal.cutting_speed_m_min[s] /
                                                     (metric_technology(x) ? 1.0 : 0.3048)
                                               : 0.0);
            else
                value = Value::of_int(by_tool ? 2 : 1);
            return true;
        }
        if (what == "FGROUP_MASK") {
            double mask = 0;
            for (unsigned i = 0; i < x.core.view().axis_count; ++i)
                if (feed_counts(x, i)) mask += std::ldexp(1.0, static_cast<int>(i));
            value = Value::of_int(mask);
            return true;
        }
        if (axis() < 0) return no_axis();
        const auto i = static_cast<std::size_t>(axis());
        if (what == "FGROUP") {
            value = Value::of_int(feed_counts(x, static_cast<unsigned>(i)) ? 1 : 0);
            return true;
        }
        if (what == "ACC") {
            value = Value::of_real(x.modal.acceleration[i] > 0 ? x.modal.acceleration[i] : 100.0);
            return true;
        }
        const double radius =
            x.modal.feed_radius[i] > 0 ? x.modal.feed_radius[i] : 180.0 / std::numbers::pi;
        value = Value::of_real(x.core.view().axes[i].rotary ? radius / unit(x) : 1.0);
        return true;
    }
    known = false;
    return true;
}

}  // namespace polyturn::channels::sinumerik
