// Who asks, and what may he do? Everybody whom the socket lets in has a level: that of his login,
// that of the key switch, or what the machine allows without a login (PT_LEVEL_OUT), whichever is
// highest. As long as there is no user at all it is the highest: a new machine has nobody yet who
// could log in.
//
// The login itself is judged by the store, which alone knows the hashes; here a login becomes a
// token that the caller sends along. It ends by logout, by PT_LOGOUT_TIME without a request, or
// with the controller.
#pragma once
#include <chrono>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "polyturn/image_structs.hpp"

namespace polyturn::supervisor {

// of UserLevel, in requests and answers
inline constexpr const char* kLevelWords[] = {"none", "operator", "setter", "maker"};

struct Who {
    UserLevel level = UserLevel::None;
    std::uint32_t user = 0;
    std::string name;
};

class Access {
public:
    using Clock = std::chrono::steady_clock;
    struct Machine {
        const UserTable* users;
        int key_position;     // 0 to 3
        UserLevel level_out;  // PT_LEVEL_OUT
    };
    // `uid`: of the process that asks (SO_PEERCRED). A user with that uid is logged in without a
    // password.
    Who who(const Machine& machine, const std::string& token, std::int64_t uid,
            Clock::time_point now);
    // A new login; empty when the system gives no random numbers.
    std::string open(std::uint32_t user, UserLevel level, std::string name, double logout_min,
                     Clock::time_point now);
    bool close(const std::string& token) { return logins_.erase(token) > 0; }

private:
    struct Login {
        std::uint32_t user;
        UserLevel level;
        std::string name;
        std::chrono::duration<double> timeout;
        Clock::time_point last;
    };
    std::map<std::string, Login> logins_;
};

// Folder and file in which the command line keeps its token; only its owner can read it.
std::string token_file(const std::string& instance);
std::string kept_token(const std::string& instance);
bool keep_token(const std::string& instance, const std::string& token);  // empty: forget it

}  // namespace polyturn::supervisor
