// Contradictions between coupled axes (nct_parameters_part2 22): rings of masters, slaves that are masters without N2102 SYM,
// exchanges that have no drive or two partners.
#include "ipc/machine/config_report.hpp"

namespace polyturn::config {
namespace {

using namespace params;

std::size_t existing(const Report& report, std::int64_t number) {
    if (number < 1 || number > static_cast<std::int64_t>(kMaxAxes)) return 0;
    return report.machine.axis(static_cast<std::size_t>(number)).exists() ? static_cast<std::size_t>(number) : 0;
}

std::size_t synchronous_master(const Report& report, std::size_t a) { return existing(report, get(report.table, n2101_synchronous_master, static_cast<unsigned>(a))); }
std::size_t superimposed_master(const Report& report, std::size_t a) { return existing(report, get(report.table, n2107_superimposed_master, static_cast<unsigned>(a))); }

// Does a way from master to master lead from `from` back to `a`? Both kinds count: they may act at the same time.
bool reaches(const Report& report, std::size_t from, std::size_t a, unsigned depth = 0) {
    if (from == 0 || depth > kMaxAxes) return false;
    return from == a || reaches(report, synchronous_master(report, from), a, depth + 1) || reaches(report, superimposed_master(report, from), a, depth + 1);
}

void check_rings(Report& report, std::size_t a) {
    const auto number = static_cast<unsigned>(a);
    if (const std::size_t m = synchronous_master(report, a); m && m != a && reaches(report, m, a))
        report.add(Alarm::ConfigCoupling, report.line(n2101_synchronous_master, number) + ": A" + std::to_string(m) + " follows A" + std::to_string(a) + " in turn");
    if (const std::size_t m = superimposed_master(report, a); m && m != a && reaches(report, m, a))
        report.add(Alarm::ConfigCoupling, report.line(n2107_superimposed_master, number) + ": A" + std::to_string(m) + " follows A" + std::to_string(a) + " in turn");
}

void check_synchronous(Report& report, std::size_t a) {
    const auto number = static_cast<unsigned>(a);
    const std::size_t m = synchronous_master(report, a);
    if (!m || m == a) return;
    const std::string line = report.line(n2101_synchronous_master, number);
    if (synchronous_master(report, m) && !bit(report.table, n2102_synchron_config, static_cast<unsigned>(m), 2))
        report.add(Alarm::ConfigCoupling, line + ": A" + std::to_string(m) + " is a slave itself and N2102#2 A" + std::to_string(m) + "=0");
    if (report.machine.axis(a).rotary != report.machine.axis(m).rotary)
        report.add(Alarm::ConfigCoupling, line + ": one of the two axes is rotary, the other linear");
}

void check_exchange(Report& report, std::size_t a) {
    const auto number = static_cast<unsigned>(a);
    const std::size_t other = existing(report, get(report.table, n2104_composit_axis, number));
    if (!other || other == a) return;
    const AxisConfig &one = report.machine.axis(a), &two = report.machine.axis(other);
    const std::string line = report.line(n2104_composit_axis, number);
    if (one.hypothetical && two.hypothetical) report.add(Alarm::ConfigCoupling, line + ": neither of the two has a drive");
    if (one.rotary != two.rotary) report.add(Alarm::ConfigCoupling, line + ": one of the two axes is rotary, the other linear");
}

}  // namespace

void check_couplings(Report& report) {
    for (const AxisConfig& x : report.machine.axes) {
        if (!x.exists()) continue;
        check_rings(report, x.number);
        check_synchronous(report, x.number);
        check_exchange(report, x.number);
    }
}

}  // namespace polyturn::config
