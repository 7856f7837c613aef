// One number of a parameter as it is entered at a screen: absolute or incremental; the answer has
// the value before and after.
//
//   {"do":"parameters.set","target":"N1600 L1","delta":0.5}
//   {"do":"parameters.set","target":"N1600 L1","value":2.5,"expected":3}
//                              refused when it has another value by now
//
// Lines of whole files are sent by the supervisor (StoreRequestKind::Parameter): they are
// done together or not at all.
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ipc/model/machine/shortest_text.hpp"
#include "ipc/requests/store_requests.hpp"
#include "ipc/params/export.hpp"
#include "ipc/params/param_file.hpp"
#include "ipc/params/registry.hpp"
#include "toolmgmt/apply_request.hpp"
#include "toolmgmt/operations/operation.hpp"

namespace polyturn::toolmgmt {
namespace {

struct OneNumber {
    std::string name;  // as a line has it
    const params::Row* row = nullptr;
    std::size_t slot = 0;
};

// Nothing: a fault says why.
std::optional<OneNumber> one_number(const Json& request, Work& work) {
    const std::string text = read_text(request, "target");
    const Result<params::Target> read = params::parse_target(text);
    if (!read) {
        work.fault(read.diagnosis(), 0, "target");
        return std::nullopt;
    }
    const params::Row& row = *read->row;
    const bool instance =
        read->instance != params::Target::kEveryInstance || params::instances(row.scope) == 1;
    const bool element = read->element != params::Target::kEveryElement || row.array == 1;
    if (!instance || !element || read->axis != 0 || read->bit != params::Target::kWhole ||
        row.type == params::Type::Text) {
        work.fault(Alarm::StoreRequestBad,
                   text.substr(0, 60) + ": one number of a parameter is wanted", 0, "target");
        return std::nullopt;
    }
    const std::size_t which =
        read->instance == params::Target::kEveryInstance ? 0 : read->instance - 1;
    const auto part = static_cast<std::size_t>(std::max(read->element, 0));
    return OneNumber{params::target_text(*read), &row, row.first_slot + which * row.array + part};
}

Json enter_number(const Json& request, Work& work) {
    const auto target = one_number(request, work);
    if (!target) return {};
    const auto& [name, named, slot] = *target;
    const params::Row& row = *named;
    const double before = work.values.parameters.numbers[slot];
    if (row.type == params::Type::Bits &&
        (request.contains("delta") || request.contains("incremental"))) {
        work.fault(Alarm::StoreRequestBad, name + ": nothing is added to bits", 0, "delta");
        return Json();
    }
    double value = 0;
    if (!read_entry(request, before, name, value, work)) return {};
    const bool bits =
        row.type == params::Type::Bits && value >= 0 && value <= 255 && value == std::trunc(value);
    std::string digits = shortest_text(value);
    if (bits) digits.clear();
    for (unsigned bit = 8; bits && bit-- > 0;)
        digits += static_cast<unsigned>(value) >> bit & 1u ? '1' : '0';
    StoreRequest line = parameter_request(name + "=" + digits);
    line.level = static_cast<std::uint32_t>(work.caller.level);
    if (const auto low = level_refusal(line)) {
        work.fault(*low);
        return Json();
    }
    Result<Applied> applied = apply_request(line, Origin::Operator, work.machine, work.values);
    if (!applied) {
        work.fault(applied.diagnosis(), 0, request.contains("delta") ? "delta" : "value");
        return Json();
    }
    for (Change& change : applied->changes) work.changes.push_back(std::move(change));
    return {{"what", name}, {"old", before}, {"new", work.values.parameters.numbers[slot]}};
}

}  // namespace

Json parameter_operation(std::string_view what, const Json& request, Work& work) {
    if (what == "set") return enter_number(request, work);
    work.fault(Alarm::StoreRequestBad, "parameters." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
