// Users: named logins with a level. Passwords are kept as salted hashes (yescrypt of libxcrypt, the
// library of the system's own logins); too many wrong ones lock the login for a while, whoever
// asks. Without any user everybody whom the controller's socket lets in may do everything, as on
// the day of delivery.
#include <crypt.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <ctime>
#include <memory>
#include <nlohmann/json.hpp>

#include "polyturn/parameter_handles.hpp"
#include "toolmgmt/operations/operation.hpp"
#include "toolmgmt/tools/tool_requests.hpp"

namespace polyturn::toolmgmt {
namespace {

constexpr std::size_t kShortest = 6, kLongest = 200;
constexpr const char* kLevels[] = {"none", "operator", "setter", "maker"};

Key key_of(std::int32_t user, std::string name) {
    return {Kind::User, 0, user, 0, std::move(name)};
}
double number_of(const StoreValues& values, std::int32_t user, const char* name, double otherwise) {
    const Cell* cell = values.cell(key_of(user, name));
    return cell ? cell->number : otherwise;
}

std::int32_t find_user(const StoreValues& values, const std::string& name) {
    for (std::int32_t user = 1; user <= static_cast<std::int32_t>(kUsers); ++user)
        if (const Cell* cell = values.cell(key_of(user, "name")); cell && cell->text == name)
            return user;
    return 0;
}

// Empty: the library refuses.
std::string hash_of(const std::string& password, const char* setting) {
    const auto data = std::make_unique<crypt_data>();
    std::memset(data.get(), 0, sizeof *data);
    const char* hash = crypt_r(password.c_str(), setting, data.get());
    return hash && hash[0] != '*' ? std::string(hash) : std::string();
}

std::string fresh_hash(const std::string& password) {
    char setting[CRYPT_GENSALT_OUTPUT_SIZE];
    return crypt_gensalt_rn("$y$", 0, nullptr, 0, setting, sizeof setting)
               ? hash_of(password, setting)
               : std::string();
}

// Its time does not tell where the first difference lies.
bool equal(const std::string& a, const std::string& b) {
    unsigned char difference = a.size() == b.size() ? 0 : 1;
    for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i)
        difference = static_cast<unsigned char>(difference | (a[i] ^ b[i]));
    return difference == 0;
}

bool good_password(const std::string& password, Work& work) {
    if (password.size() >= kShortest && password.size() <= kLongest) return true;
    work.fault(Alarm::StoreRequestBad,
               "a password has " + std::to_string(kShortest) + " to " + std::to_string(kLongest) +
                   " characters",
               0, "password");
    return false;
}

bool set_password(Work& work, std::int32_t user, const std::string& password) {
    if (!good_password(password, work)) return false;
    const std::string hash = fresh_hash(password);
    if (work.logins) work.logins->forget(user);
    if (hash.empty()) {
        work.fault(Alarm::StoreRequestBad, "the password cannot be hashed");
        return false;
    }
    set_text(work.values, key_of(user, "hash"), hash, work.changes);
    set_value(work.values, key_of(user, "failures"), std::nan(""), work.changes);
    set_value(work.values, key_of(user, "locked_until"), std::nan(""), work.changes);
    return true;
}

// The number of the user whose name and password these are; 0 and a fault otherwise. Failures are
// counted on disk.
std::int32_t log_in(const Json& request, Work& work) {
    const std::int32_t user = find_user(work.values, read_text(request, "name"));
    const std::string password = read_text(request, "password");
    const Cell* hash = work.values.cell(key_of(user, "hash"));
    const double now = static_cast<double>(std::time(nullptr));
    if (user != 0)
        if (const double until = number_of(work.values, user, "locked_until", 0); until > now) {
            work.fault(Diagnosis{Alarm::LoginLocked, {}, {std::ceil(until - now), 0}, {}});
            return 0;
        }
    const auto moment = LoginLimit::Clock::now();
    if (work.logins)
        if (const double wait = work.logins->wait(user, moment); wait > 0) {
            work.fault(Diagnosis{Alarm::LoginLocked, {}, {std::ceil(wait), 0}, {}});
            return 0;
        }
    // A name that does not exist takes as long as a wrong password.
    static const std::string kNobody = fresh_hash("nobody at all");
    const std::string stored = hash ? hash->text : kNobody;
    const bool right = equal(hash_of(password.substr(0, kLongest), stored.c_str()), stored) && hash;
    work.keep = true;
    if (work.logins) {
        if (right)
            work.logins->forget(user);
        else
            work.logins->wrong(user, LoginLimit::Clock::now());
    }
    if (right) {
        set_value(work.values, key_of(user, "failures"), std::nan(""), work.changes);
        set_value(work.values, key_of(user, "locked_until"), std::nan(""), work.changes);
        return user;
    }
    if (user != 0) {
        const double failures = number_of(work.values, user, "failures", 0) + 1;
        const bool lock = failures >= params::get(work.values.parameters, params::pt_login_tries);
        set_value(work.values, key_of(user, "failures"), lock ? std::nan("") : failures,
                  work.changes);
        if (lock)
            set_value(work.values, key_of(user, "locked_until"),
                      now + params::get(work.values.parameters, params::pt_login_lock),
                      work.changes);
    }
    work.fault(Alarm::LoginWrong, "");
    return 0;
}

bool another_maker(const StoreValues& values, std::int32_t but) {
    for (std::int32_t user = 1; user <= static_cast<std::int32_t>(kUsers); ++user)
        if (user != but && values.cell(key_of(user, "name")) &&
            number_of(values, user, "level", 0) >= 3)
            return true;
    return false;
}

bool set_level(Work& work, std::int32_t user, const std::string& level) {
    const auto at = std::find(std::begin(kLevels) + 1, std::end(kLevels), level);
    if (at == std::end(kLevels)) {
        work.fault(Alarm::StoreRequestBad, "level " + level + ": operator, setter or maker", 0,
                   "level");
        return false;
    }
    set_value(work.values, key_of(user, "level"), static_cast<double>(at - std::begin(kLevels)),
              work.changes);
    return true;
}

}  // namespace

double LoginLimit::wait(std::int32_t user, Clock::time_point now) const {
    const auto at = tries_.find(user);
    const Clock::time_point until =
        std::max(next_, at == tries_.end() ? Clock::time_point{} : at->second.next);
    return until > now ? std::chrono::duration<double>(until - now).count() : 0.0;
}

// A hash takes some 50 ms of the store's time: five of them a second at the most, whoever asks. One
// user waits 1, 2, 4, … 32 s.
void LoginLimit::wrong(std::int32_t user, Clock::time_point now) {
    Try& one = tries_[user];
    one.next = now + std::chrono::seconds(1) * (1 << std::min(one.count++, 5));
    next_ = now + std::chrono::milliseconds(200);
}

Json user_operation(std::string_view what, const Json& request, Work& work) {
    StoreValues& values = work.values;
    const std::string name = read_text(request, "name");
    if (what == "login") {
        const std::int32_t user = log_in(request, work);
        if (!user) return {};
        return {{"user", user},
                {"name", name},
                {"level", static_cast<int>(number_of(values, user, "level", 0))},
                {"logout_min", params::get(values.parameters, params::pt_logout_time)}};
    }
    if (what == "list") {
        Json out = Json::array();
        for (std::int32_t user = 1; user <= static_cast<std::int32_t>(kUsers); ++user)
            if (const Cell* cell = values.cell(key_of(user, "name"))) {
                Json one = {
                    {"user", user},
                    {"name", cell->text},
                    {"level",
                     kLevels[static_cast<std::size_t>(number_of(values, user, "level", 0)) % 4]},
                    {"locked", number_of(values, user, "locked_until", 0) >
                                   static_cast<double>(std::time(nullptr))}};
                if (const double uid = number_of(values, user, "uid", -1); uid >= 0)
                    one["uid"] = static_cast<std::int64_t>(uid);
                out.push_back(std::move(one));
            }
        return {{"users", std::move(out)}};
    }
    if (what == "add") {
        if (name.empty() || name.size() > 31 ||
            name.find_first_of(" \t\n\"") != std::string::npos) {
            work.fault(Alarm::StoreRequestBad, "a name has 1 to 31 characters without blanks", 0,
                       "name");
            return Json();
        }
        if (find_user(values, name)) {
            work.fault(Alarm::StoreRequestBad, "the user " + name + " exists", 0, "name");
            return Json();
        }
        std::int32_t user = 1;
        while (user <= static_cast<std::int32_t>(kUsers) && values.cell(key_of(user, "name")))
            ++user;
        if (user > static_cast<std::int32_t>(kUsers)) {
            work.fault(Alarm::StoreRequestBad,
                       "there are " + std::to_string(kUsers) + " users already");
            return Json();
        }
        const std::string level = read_text(request, "level");
        set_text(values, key_of(user, "name"), name, work.changes);
        if (!set_level(work, user, level) ||
            !set_password(work, user, read_text(request, "password")))
            return {};
        // The first one must be able to make others: without a maker nobody could ever change users
        // again.
        if (level != "maker" && !another_maker(values, user)) {
            work.fault(Alarm::StoreRequestBad, "the first user must be a maker", 0, "level");
            return Json();
        }
        std::int64_t uid = -1;
        if (read_whole(request, "uid", uid, work, false))
            set_value(values, key_of(user, "uid"), static_cast<double>(uid), work.changes);
        return {{"user", user}, {"name", name}, {"level", level}};
    }
    if (what == "password") {  // one's own with the old password, anybody's as a maker
        const std::int32_t user = find_user(values, name);
        if (work.caller.level >= UserLevel::Maker) {
            if (!user) {
                work.fault(Alarm::LoginWrong, "");
                return Json();
            }
        } else if (!log_in(request, work)) {
            return {};
        }
        set_password(work, user, read_text(request, "new"));
        return {{"user", user}, {"name", name}};
    }
    const std::int32_t user = find_user(values, name);
    if (!user) {
        work.fault(Alarm::StoreRequestBad, "there is no user " + name, 0, "name");
        return Json();
    }
    if (what == "level") {
        if (read_text(request, "level") != "maker" && number_of(values, user, "level", 0) >= 3 &&
            !another_maker(values, user)) {
            work.fault(Alarm::StoreRequestBad, name + " is the only maker", 0, "level");
            return Json();
        }
        set_level(work, user, read_text(request, "level"));
        return {{"user", user}, {"name", name}};
    }
    if (what == "delete") {
        // Without any user everybody would be a maker: that is how a store begins, and it never
        // comes back to it.
        if (number_of(values, user, "level", 0) >= 3 && !another_maker(values, user)) {
            work.fault(Alarm::StoreRequestBad, name + " is the only maker", 0, "name");
            return Json();
        }
        for (const char* column : {"level", "failures", "locked_until", "uid"})
            set_value(values, key_of(user, column), std::nan(""), work.changes);
        for (const char* column : {"name", "hash"})
            set_text(values, key_of(user, column), {}, work.changes);
        return {{"user", user}, {"name", name}};
    }
    work.fault(Alarm::StoreRequestBad, "users." + std::string(what));
    return Json();
}

}  // namespace polyturn::toolmgmt
