// A store in memory with two turrets of twelve stations and operations on it, for tests.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/load_machine.hpp"
#include "ipc/model/machine/store/tool_fields.hpp"
#include "ipc/params/param_file.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/tools/places.hpp"
#include "toolmgmt/tools/search.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::test {

using toolmgmt::Json;

struct ToolRig {
    std::unique_ptr<toolmgmt::StoreValues> values = std::make_unique<toolmgmt::StoreValues>();
    std::unique_ptr<ToolPlaceTable> places = std::make_unique<ToolPlaceTable>();
    MachineConfig machine;
    Json answer;
    std::vector<toolmgmt::Fault> faults;
    std::string compensation_file;
    std::function<std::optional<double>(unsigned)> position;
    std::function<std::optional<toolmgmt::Touch>(unsigned)> touch;

    ToolRig() {
        toolmgmt::clear(*values);
        values->parameters = *load_machine_file({}).table;
        set("N2900=00000001");
        set("N2903=5");
        machine = derive_machine_config(values->parameters);
    }
    void set(const std::string& line) {
        const auto assignment = params::parse_assignment(line);
        ASSERT_TRUE(assignment) << line;
        ASSERT_TRUE(params::apply(values->parameters, {&*assignment, 1})) << line;
    }
    // True when it was done; what was changed is taken back otherwise, as the service does.
    bool run(const Json& request, UserLevel level = UserLevel::Maker) {
        toolmgmt::Work work{*values, machine, nullptr,  {level, 0, "tester"},
                            {},      {},      position, touch,
                            {},      {},      false,    {}};
        work.compensation_file = compensation_file;
        answer = toolmgmt::run_operation(request, work);
        for (const auto& act : work.after)
            if (const Result<void> done =
                    work.good() && !compensation_file.empty() ? act() : Result<void>{};
                !done)
                work.fault(done.diagnosis());
        faults = work.faults;
        if (!work.good() && !work.keep)
            for (auto at = work.changes.rbegin(); at != work.changes.rend(); ++at)
                toolmgmt::write_value(*values, at->key, at->before, at->text_before, at->is_text);
        return work.good();
    }
    std::string said() const {
        std::string out;
        for (const auto& fault : faults)
            out += "row " + std::to_string(fault.row) + " " + fault.column + ": " +
                   fault.diagnosis.text() + "\n";
        return out;
    }
    int add(const Json& fields, int magazine = 0, int pot = 0) {
        EXPECT_TRUE(
            run({{"do", "tools.add"}, {"fields", fields.is_null() ? Json::object() : fields}}))
            << said();
        const int tool = answer.value("tool", 0);
        if (magazine) {
            EXPECT_TRUE(
                run({{"do", "tools.load"}, {"tool", tool}, {"magazine", magazine}, {"pot", pot}}))
                << said();
        }
        return tool;
    }
    ToolAnswer call(ToolCallBy by, double value, std::string_view name = {}, unsigned channel = 1) {
        toolmgmt::derive_places(*values, *places);
        return toolmgmt::find_tool(*values, *places, {channel, by, value, name});
    }
    // The tool that answers, or minus the alarm.
    int found(ToolCallBy by, double value, std::string_view name = {}, unsigned channel = 1) {
        const ToolAnswer one = call(by, value, name, channel);
        return one.alarm < 0 ? one.tool : -one.alarm;
    }
};

}  // namespace polyturn::test
