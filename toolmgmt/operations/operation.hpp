// What operator, screens and command line ask of the store beyond single values: one JSON object
// in, one out.
//
//   {"do":"tools.set","tool":5,"fields":{"life":"100"}}
//       ->  {"ok":true, ...}
//           {"ok":false,"faults":[{"number","text","remedy","row","column"}]}
//
// An operation changes the values as it goes and notes every change. When something is wrong it
// names all faults it can find, and everything is taken back: all of it or nothing. What it changed
// is on disk before the answer says ok.
#pragma once

#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "ipc/diagnosis/diagnosis.hpp"
#include "ipc/model/machine/machine_config.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/store_values.hpp"

namespace polyturn::toolmgmt {

using Json = nlohmann::json;

struct Fault {
    Diagnosis diagnosis;
    int row = 0;  // of a table, from 1; 0 none
    std::string column;
};

struct Caller {
    UserLevel level = UserLevel::Maker;
    std::uint32_t user = 0;
    std::string name;  // for the history
};

// Where a setter was touched last, as the kernel reports.
struct Touch {
    unsigned axis = 0;      // machine axis, from 1; 0: it has not
    bool negative = false;  // it travelled in the axis' negative direction
    // 1, 2: the tool setter of this spindle; 3, 4: the workpiece setter of spindle 1, 2
    unsigned setter = 1;
    bool workpiece() const { return setter > 2; }
    unsigned spindle() const { return workpiece() ? setter - 2 : setter; }
    double at = 0;                // machine coordinate, X as a radius
    std::int32_t plc_offset = 0;  // CP_OFFSNO
    double slide_at = 0;          // an inclined X slide at that moment, its own coordinate
};

// Wrong log-ins cost their sender time, and nobody else: a password is hashed only now and then,
// the others are refused at once.
class LoginLimit {
public:
    using Clock = std::chrono::steady_clock;
    // Seconds to wait; 0: the password may be looked at. `user`: 0 for a name that does not exist.
    double wait(std::int32_t user, Clock::time_point now) const;
    void wrong(std::int32_t user, Clock::time_point now);
    void forget(std::int32_t user) { tries_.erase(user); }

private:
    struct Try {
        int count = 0;
        Clock::time_point next{};
    };
    std::map<std::int32_t, Try> tries_;
    Clock::time_point next_{};
};

// One operation in progress.
struct Work {
    StoreValues& values;
    const MachineConfig& machine;
    Database* disk;  // nullptr: nothing is kept
    Caller caller;
    // files that a backup takes along; empty: none
    std::string machine_folder;
    std::string instance;
    // machine coordinate now (X as a radius) of an axis from 1
    std::function<std::optional<double>(unsigned axis)> position;
    // nothing: the kernel does not answer
    std::function<std::optional<Touch>(unsigned channel)> touch;
    std::vector<Change> changes;
    std::vector<Fault> faults;
    // what changed stays though the answer is a refusal (failed logins)
    bool keep = false;
    std::vector<std::function<Result<void>()>> after;  // once the changes are on disk
    // of measured errors; empty: the machine has no folder, or stays as it is
    std::string compensation_file = {};
    LoginLimit* logins = nullptr;  // nullptr: every password is looked at
    // what was lost is no longer missed once the changes are on disk
    bool confirms = false;

    void fault(Diagnosis diagnosis, int row = 0, std::string column = {}) {
        faults.push_back({std::move(diagnosis), row, std::move(column)});
    }
    void fault(Alarm alarm, std::string detail, int row = 0, std::string column = {}) {
        fault(Diagnosis{alarm, {}, {}, std::move(detail)}, row, std::move(column));
    }
    bool good() const { return faults.empty(); }
};

// A request as an object, or why it is none: too long, nested too deeply, no JSON.
Result<Json> parse_request(std::string_view text);
inline constexpr std::size_t kLargestRequest = std::size_t{4} << 20;
inline constexpr int kDeepestRequest = 32;

// The answer without "ok". Faults are in work.faults.
Json run_operation(const Json& request, Work& work);
// The answer as text.
std::string answer_text(const Json& answer, const std::vector<Fault>& faults);

// Its parts, by the first word of "do".
Json tool_operation(std::string_view what, const Json& request, Work& work);
Json life_operation(std::string_view what, const Json& request, Work& work);
Json table_operation(std::string_view what, const Json& request, Work& work);
Json offset_operation(std::string_view what, const Json& request, Work& work);
Json zero_operation(std::string_view what, const Json& request, Work& work);
Json part_operation(std::string_view what, const Json& request, Work& work);
Json alarm_operation(std::string_view what, const Json& request, Work& work);
Json stop_operation(std::string_view what, const Json& request, Work& work);
Json user_operation(std::string_view what, const Json& request, Work& work);
Json parameter_operation(std::string_view what, const Json& request, Work& work);
Json pallet_operation(std::string_view what, const Json& request, Work& work);
Json compensation_operation(std::string_view what, const Json& request, Work& work);
Json backup_operation(std::string_view what, const Json& request, Work& work);
Json store_operation(std::string_view what, const Json& request, Work& work);

// "what" or a fault that says which key is missing or of the wrong kind.
bool read_whole(const Json& request, const char* key, std::int64_t& out, Work& work,
                bool needed = true);
bool read_real(const Json& request, const char* key, double& out, Work& work, bool needed = true);
std::string read_text(const Json& request, const char* key);
// Missing is false; anything but true and false is a fault.
bool read_flag(const Json& request, const char* key, Work& work);
// Missing is an empty object; anything but an object is a fault.
Json read_object(const Json& request, const char* key, Work& work);

// What is entered: «value», or «delta» on top of `present` (and «value» with «incremental»),
// whoever wrote `present` in between. With «expected» it is refused when something else stands
// there. False: a fault tells why. Rounded to a billionth, so that 0.8 and 0.4 are 1.2.
bool read_entry(const Json& request, double present, const std::string& what, double& out,
                Work& work);
// Its half: «expected», where it is said, is what stands there.
bool as_expected(const Json& request, double present, const std::string& what, Work& work);

// What has been computed, for people: to a millionth of its unit.
inline double rounded(double value) { return std::round(value * 1e6) / 1e6; }

}  // namespace polyturn::toolmgmt
