// Collects contradictions while config_check looks through the table; used by its parts only.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/registry.hpp"
#include "ipc/params/table.hpp"

namespace polyturn::config {

class Report {
public:
    Report(const params::Table& parameters, const MachineConfig& derived)
        : table(parameters), machine(derived) {}
    const params::Table& table;
    const MachineConfig& machine;
    std::vector<Diagnosis> diagnoses;

    void add(Alarm alarm, std::string detail) {
        diagnoses.push_back(Diagnosis{alarm, {}, {}, std::move(detail)});
    }

    // "N0002 A7=3": the parameter as a line that sets it, so that it can be found and corrected.
    template <params::Scope kScope, params::Type kType>
    std::string line(params::Handle<kScope, kType> handle, unsigned instance = 1) const {
        const params::Row& row = params::rows()[handle.row];
        std::string text(row.number);
        if (const char letter = params::scope_letter(kScope))
            text += std::string(" ") + letter + std::to_string(instance);
        return text + "=" + params::value_text(row, table, instance);
    }
};

// "A7" with its name where it has one: "A7 (X)".
inline std::string axis_text(const AxisConfig& axis) {
    std::string text = "A" + std::to_string(axis.number);
    if (!axis.name_text().empty()) text += " (" + std::string(axis.name_text()) + ")";
    return text;
}

void check_channels(Report& report);
void check_axes(Report& report);
void check_axis_references(Report& report);
void check_couplings(Report& report);
void check_drives(Report& report);
void check_spindles(Report& report);
void check_pitch_tables(Report& report);
void check_compensation(Report& report);
void check_codes(Report& report);
void check_values(Report& report);
void check_switches(Report& report);
void check_kinds(Report& report);
void check_together(Report& report);
void check_effects(Report& report);

}  // namespace polyturn::config
