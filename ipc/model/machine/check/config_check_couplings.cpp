// Contradictions between coupled axes (nct_parameters_part2 22): rings of masters, slaves that are
// masters without N2102 SYM, exchanges that have no drive or two partners, balance cuts that one
// side knows nothing of; and barriers of a negative size.
#include <array>

#include "ipc/model/machine/angular_axes.hpp"
#include "ipc/model/machine/check/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

std::size_t existing(const Report& report, std::int64_t number) {
    if (number < 1 || number > static_cast<std::int64_t>(kMaxAxes)) return 0;
    return report.machine.axis(static_cast<std::size_t>(number)).exists()
               ? static_cast<std::size_t>(number)
               : 0;
}

std::size_t synchronous_master(const Report& report, std::size_t a) {
    return existing(report, get(report.table, n2101_synchronous_master, static_cast<unsigned>(a)));
}
std::size_t superimposed_master(const Report& report, std::size_t a) {
    return existing(report, get(report.table, n2107_superimposed_master, static_cast<unsigned>(a)));
}

// Does a way from master to master lead from `from` back to `a`? Both kinds count: they may act at
// the same time.
bool reaches(const Report& report, std::size_t from, std::size_t a, unsigned depth = 0) {
    if (from == 0 || depth > kMaxAxes) return false;
    return from == a || reaches(report, synchronous_master(report, from), a, depth + 1) ||
           reaches(report, superimposed_master(report, from), a, depth + 1);
}

void check_rings(Report& report, std::size_t a) {
    const auto number = static_cast<unsigned>(a);
    if (const std::size_t m = synchronous_master(report, a); m && m != a && reaches(report, m, a))
        report.add(Alarm::ConfigCoupling, report.line(n2101_synchronous_master, number) + ": A" +
                                              std::to_string(m) + " follows A" + std::to_string(a) +
                                              " in turn");
    if (const std::size_t m = superimposed_master(report, a); m && m != a && reaches(report, m, a))
        report.add(Alarm::ConfigCoupling, report.line(n2107_superimposed_master, number) + ": A" +
                                              std::to_string(m) + " follows A" + std::to_string(a) +
                                              " in turn");
}

void check_synchronous(Report& report, std::size_t a) {
    const auto number = static_cast<unsigned>(a);
    const std::size_t m = synchronous_master(report, a);
    if (!m || m == a) return;
    const std::string line = report.line(n2101_synchronous_master, number);
    if (synchronous_master(report, m) &&
        !bit(report.table, n2102_synchron_config, static_cast<unsigned>(m), 2))
        report.add(Alarm::ConfigCoupling, line + ": A" + std::to_string(m) +
                                              " is a slave itself and N2102#2 A" +
                                              std::to_string(m) + "=0");
    if (report.machine.axis(a).rotary != report.machine.axis(m).rotary)
        report.add(Alarm::ConfigCoupling,
                   line + ": one of the two axes is rotary, the other linear");
}

void check_exchange(Report& report, std::size_t a) {
    const auto number = static_cast<unsigned>(a);
    const std::size_t other = existing(report, get(report.table, n2104_composit_axis, number));
    if (!other || other == a) return;
    const AxisConfig &one = report.machine.axis(a), &two = report.machine.axis(other);
    const std::string line = report.line(n2104_composit_axis, number);
    if (one.hypothetical && two.hypothetical)
        report.add(Alarm::ConfigCoupling, line + ": neither of the two has a drive");
    if (one.rotary != two.rotary)
        report.add(Alarm::ConfigCoupling,
                   line + ": one of the two axes is rotary, the other linear");
}

// Both of a balance cut name each other.
void check_balance(Report& report, unsigned l) {
    const auto other = static_cast<unsigned>(get(report.table, pt_balance, l));
    if (other == 0) return;
    const std::string line = report.line(pt_balance, l);
    if (other == l || get(report.table, n0000_machine_group, other) == 0)
        report.add(Alarm::ConfigCoupling,
                   line + ": L" + std::to_string(other) + " is no other channel");
    else if (static_cast<unsigned>(get(report.table, pt_balance, other)) != l)
        report.add(Alarm::ConfigCoupling,
                   line + ": L" + std::to_string(other) + " does not name L" + std::to_string(l));
}

// F8200 (fanuc_lathe 10.5): an angle that no slide can have; and a path that goes through the
// inclined slide does not pass the marks of a balance cut, so that one of the two would be left out
// without a word.
void check_angular(Report& report, unsigned l) {
    if (!bit(report.table, f8200, l, 0)) return;
    unsigned count = 0;
    int x = -1, z = -1;
    for (const AxisConfig& axis : report.machine.axes) {
        if (!axis.exists() || axis.channel != l) continue;
        if (axis.role == PlaneRole::BasicX) x = static_cast<int>(count);
        if (axis.role == PlaneRole::BasicZ) z = static_cast<int>(count);
        ++count;
    }
    bool usable = true;
    (void)angular_axes(report.table, l, count, x, z, usable);
    if (!usable)
        report.add(Alarm::ParameterContradicts,
                   report.line(f8200, l) + " and " + report.line(f8210, l));
    else if (get(report.table, pt_balance, l) != 0)
        report.add(Alarm::ParameterContradicts, report.line(f8200, l) + " and " +
                                                    report.line(pt_balance, l) +
                                                    ": an inclined slide cuts in no balance");
}

// Barriers around chucks and tailstocks (20): sizes are sizes.
void check_barriers(Report& report, unsigned l) {
    constexpr std::array kSizes{n1901_l1_length_of_jaws,         n1902_w1_width_of_jaws,
                                n1903_l2_holding_length_of_jaws, n1904_w2_holding_width_of_jaws,
                                n1907_l1_length_of_tailstock,    n1908_d1_diameter_of_tailstock,
                                n1909_l2_length_of_tailstock,    n1910_d2_diameter_of_tailstock,
                                n1911_l3_length_of_tailstock,    n1912_d3_diameter_of_tailstock,
                                n1913_d4_diameter_of_tailstock};
    for (const auto& size : kSizes)
        if (!(get(report.table, size, l) >= 0))
            report.add(Alarm::GuardConfig, report.line(size, l) + ": a size below 0");
}

}  // namespace

void check_couplings(Report& report) {
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists()) continue;
        check_rings(report, x.number);
        check_synchronous(report, x.number);
        check_exchange(report, x.number);
    }
    for (unsigned l = 1; l <= kMaxChannels; ++l)
        if (get(report.table, n0000_machine_group, l) != 0) {
            check_balance(report, l);
            check_angular(report, l);
            check_barriers(report, l);
        }
}

}  // namespace polyturn::config
