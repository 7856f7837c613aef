// libs: polyturn_toolmgmt
//
// Whatever is asked of the store as an operation ends in an answer or in
// faults that say what is wrong and what to do; refused, it has changed nothing. Lines of any text,
// and lines made of the words that operations know.
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "ipc/model/machine/load_machine.hpp"
#include "ipc/params/param_file.hpp"
#include "tests/fuzz/draw.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace {
using namespace polyturn;
using namespace polyturn::toolmgmt;
using Draw = polyturn::channels::fuzz::Draw;

constexpr const char* kVerbs[] = {
    "tools.list",       "tools.show",          "tools.places",     "tools.answers",
    "tools.fields",     "tools.export",        "tools.import",     "tools.load",
    "tools.unload",     "tools.move",          "tools.add",        "tools.set",
    "tools.delete",     "tools.place",         "life.report",      "life.reset",
    "offsets.list",     "offsets.set",         "offsets.measure",  "offsets.touch",
    "offsets.preset",   "offsets.origin",      "offsets.relative", "offsets.undo",
    "offsets.history",  "history.list",        "zeros.list",       "zeros.set",
    "zeros.here",       "zeros.touch",         "parts.list",       "parts.add",
    "parts.set",        "parts.measure",       "parts.accept",     "parts.delete",
    "parameters.set",   "pallets.list",        "pallets.set",      "pallets.exchange",
    "compensation.set", "compensation.import", "users.list",       "users.add",
    "users.level",      "users.delete",        "users.login",      "backup.to",
    "restore.from",     "store.state",         "store.confirm",    "stops.note",
    "stops.list",       "alarms.note",         "alarms.list",      "x"};
constexpr const char* kKeys[] = {
    "tool",       "tools",     "fields",   "channel",     "number",    "table",       "field",
    "value",      "delta",     "expected", "incremental", "edge",      "dp",          "plane",
    "magazine",   "pot",       "locked",   "place_type",  "dimension", "row",         "with",
    "cells",      "points",    "file",     "text",        "format",    "preview",     "name",
    "level",      "password",  "uid",      "zero",        "length",    "zero_at",     "offset",
    "target",     "type",      "of",       "kind",        "about",     "who",         "most",
    "before_utc", "before_id", "events",   "utc",         "cause",     "seconds",     "X",
    "Y",          "Z",         "R",        "T",           "counter",   "make_folder", "with_plc",
    "since"};
constexpr const char* kWords[] = {"X",
                                  "Z",
                                  "C",
                                  "G54",
                                  "shift",
                                  "G54.1 P300",
                                  "wear",
                                  "geometry",
                                  "second",
                                  "N1600 L1",
                                  "N0104 L1",
                                  "N2900",
                                  "PT_PROGRAM_FOLDERS L1",
                                  "life",
                                  "counter",
                                  "D1.DP6",
                                  "D9.DP35",
                                  "h",
                                  "custom1",
                                  "minutes",
                                  "outline",
                                  "1e999",
                                  "-0",
                                  "0x10",
                                  " 5",
                                  "5 ",
                                  "maker",
                                  "anna",
                                  "nominal",
                                  "upper",
                                  "axis",
                                  "pallet",
                                  "program",
                                  "sinumerik",
                                  "csv",
                                  "2026-01-31T12:00:00Z",
                                  "tool,name,life\n1,A,5\n",
                                  "$TC_TP2[1]=\"A\"\n$TC_DP6[1,1]=3\n",
                                  "/dev/null",
                                  "/",
                                  "..",
                                  "\xff\xfe",
                                  "N99999999999"};

Json value_of(Draw& draw, int depth);

Json object_of(Draw& draw, int depth) {
    Json out = Json::object();
    for (unsigned n = draw.below(5); n-- > 0;) {
        const bool field = draw.below(3) == 0;
        out[field ? kWords[draw.below(std::size(kWords))] : kKeys[draw.below(std::size(kKeys))]] =
            value_of(draw, depth + 1);
    }
    return out;
}

Json value_of(Draw& draw, int depth) {
    switch (draw.below(depth > 5 ? 6 : 9)) {
        case 0:
            return draw.below(2) == 0;
        case 1:
            return static_cast<int>(draw.byte()) - 8;
        case 2:
            return draw.length();
        case 3:
            return kWords[draw.below(std::size(kWords))];
        case 4:
            return std::to_string(draw.byte());
        case 5:
            return draw.below(2) ? 1e300 : static_cast<double>(1 + draw.byte()) * 1e8;
        case 6:
            return object_of(draw, depth);
        case 7:
            return Json{{draw.below(2) ? "delta" : "value", value_of(draw, depth + 1)},
                        {"expected", value_of(draw, depth + 1)}};
        default: {
            Json out = Json::array();
            for (unsigned n = draw.below(5); n-- > 0;) out.push_back(value_of(draw, depth + 1));
            return out;
        }
    }
}

struct Store {
    std::unique_ptr<StoreValues> values = std::make_unique<StoreValues>();
    MachineConfig machine;
    LoginLimit logins;
    std::string compensation;

    Store() {
        clear(*values);
        values->parameters = *load_machine_file({}).table;
        for (const char* line : {"N2900=00000001", "N2903=5", "N3300=3", "N3301=4", "N3302=2",
                                 "N2700 L1=1", "N2701 L1=2", "N2703 L1=3", "N2704 L1=4"}) {
            const auto assignment = params::parse_assignment(line);
            if (!assignment || !params::apply(values->parameters, {&*assignment, 1})) std::abort();
        }
        machine = derive_machine_config(values->parameters);
        compensation = "/tmp/operation-fuzz-" + std::to_string(getpid()) + ".compensation";
        ask(R"({"do":"tools.add","fields":{"name":"A","type":1,"h":3,)"
            R"("life":60,"life_kind":"minutes","D1.DP1":500,"D1.DP6":0.8}})",
            UserLevel::Maker);
        ask(R"({"do":"parts.add","fields":{"nominal":30,"upper":0.02,)"
            R"("lower":-0.02,"tool":1,"channel":1}})",
            UserLevel::Maker);
    }
    void ask(std::string_view text, UserLevel level) {
        Work work{*values, machine, nullptr, {level, 1, "fuzz"}, {}, {}, {}, {}, {}, {}, false, {}};
        work.position = [](unsigned axis) -> std::optional<double> { return axis * 1.5; };
        work.touch = [](unsigned channel) -> std::optional<Touch> {
            return Touch{channel, false, channel, 12.5, 3, 0.0};
        };
        work.compensation_file = compensation;
        work.logins = &logins;
        Json answer;
        const Result<Json> parsed = parse_request(text);
        if (!parsed) {
            work.fault(parsed.diagnosis());
        } else {
            try {  // as the service does: what nobody has thought of is refused, and taken back
                answer = run_operation(*parsed, work);
            } catch (const std::exception& wrong) { work.fault(Alarm::RequestBad, wrong.what()); }
        }
        for (const Fault& fault : work.faults)
            if (fault.diagnosis.text().empty() || fault.diagnosis.remedy().empty()) std::abort();
        const std::string told = answer_text(answer, work.faults);
        const Json read = Json::parse(told, nullptr, false);
        if (!read.is_object() || !read.contains("ok") || read["ok"] != work.faults.empty())
            std::abort();
        for (const Change& change : work.changes)  // each can be written, and taken back
            if (change.is_text ? change.text_after.size() > 100'000 : std::isinf(change.after))
                std::abort();
        for (auto at = work.changes.rbegin(); at != work.changes.rend(); ++at)
            if (!work.good() || keep_nothing)
                write_value(*values, at->key, at->before, at->text_before, at->is_text);
    }
    bool keep_nothing = false;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Store store;
    store.keep_nothing = true;
    if (size < 2) return 0;
    const auto level = static_cast<UserLevel>(data[0] % 4);
    if (data[0] & 4) {
        store.ask({reinterpret_cast<const char*>(data) + 1, size - 1}, level);
        return 0;
    }
    Draw draw(data + 1, size - 1);
    Json request = object_of(draw, 0);
    for (unsigned n = draw.below(6); n-- > 0;)
        request[kKeys[draw.below(std::size(kKeys))]] = value_of(draw, 1);
    request["do"] = kVerbs[draw.below(std::size(kVerbs))];
    // A hash takes 50 ms; what is tried here is what stands before it.
    if (request.value("do", "").rfind("users.", 0) == 0 && request.contains("password"))
        request["password"] = "short";
    store.ask(request.dump(-1, ' ', false, Json::error_handler_t::replace), level);
    return 0;
}
