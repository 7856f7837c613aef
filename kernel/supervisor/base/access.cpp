#include "kernel/supervisor/base/access.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>

namespace polyturn::supervisor {

namespace {
constexpr std::size_t kMostLogins = 64;
}

Who Access::who(const Machine& machine, const std::string& token, std::int64_t uid,
                Clock::time_point now) {
    const UserTable& users = *machine.users;
    if (users.count == 0) return {UserLevel::Maker, 0, {}};
    Who out;
    out.level =
        std::max(machine.level_out, static_cast<UserLevel>(std::clamp(machine.key_position, 0, 3)));
    const auto take = [&](std::uint32_t user, UserLevel level, std::string_view name) {
        out.user = user;
        out.name = name;
        out.level = std::max(out.level, level);
    };
    if (const auto login = logins_.find(token); login != logins_.end()) {
        // Whoever was deleted meanwhile, or has another level now, is what the table says.
        const UserRow* row = nullptr;
        for (std::size_t i = 0; i < std::min<std::size_t>(users.count, kUsers); ++i)
            if (users.rows[i].number == login->second.user &&
                login->second.name == users.rows[i].name.data())
                row = &users.rows[i];
        if (!row || (login->second.timeout.count() > 0 &&
                     now - login->second.last > login->second.timeout)) {
            logins_.erase(login);
        } else {
            login->second.last = now;
            take(row->number, static_cast<UserLevel>(row->level), row->name.data());
            return out;
        }
    }
    for (std::size_t i = 0; i < std::min<std::size_t>(users.count, kUsers); ++i)
        if (uid >= 0 && users.rows[i].uid == uid)
            take(users.rows[i].number, static_cast<UserLevel>(users.rows[i].level),
                 users.rows[i].name.data());
    return out;
}

std::string Access::open(std::uint32_t user, UserLevel level, std::string name, double logout_min,
                         Clock::time_point now) {
    unsigned char bytes[24];
    if (getrandom(bytes, sizeof bytes, 0) != static_cast<ssize_t>(sizeof bytes)) return {};
    std::string token;
    for (const unsigned char b : bytes) {
        token += "0123456789abcdef"[b >> 4];
        token += "0123456789abcdef"[b & 15];
    }
    if (logins_.size() >= kMostLogins)
        logins_.erase(std::min_element(
            logins_.begin(), logins_.end(),
            [](const auto& a, const auto& b) { return a.second.last < b.second.last; }));
    logins_[token] = {user, level, std::move(name),
                      std::chrono::duration<double>(logout_min * 60.0), now};
    return token;
}

std::string token_file(const std::string& instance) {
    const char* runtime = std::getenv("XDG_RUNTIME_DIR");
    const std::string folder = runtime && *runtime ? std::string(runtime) + "/polyturn"
                                                   : "/tmp/polyturn-" + std::to_string(geteuid());
    return folder + "/" + instance + ".token";
}

std::string kept_token(const std::string& instance) {
    const int fd = ::open(token_file(instance).c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW);
    if (fd < 0) return {};
    struct stat about {};
    char text[128];
    const bool own = fstat(fd, &about) == 0 && about.st_uid == geteuid();
    const auto got = own ? ::read(fd, text, sizeof text) : 0;
    ::close(fd);
    return got > 0 ? std::string(text, static_cast<std::size_t>(got)) : std::string();
}

bool keep_token(const std::string& instance, const std::string& token) {
    const std::string file = token_file(instance);
    if (token.empty()) return ::unlink(file.c_str()) == 0;
    const std::string folder = file.substr(0, file.rfind('/'));
    ::mkdir(folder.c_str(), 0700);
    struct stat about {};
    // somebody else's trap
    if (lstat(folder.c_str(), &about) != 0 || !S_ISDIR(about.st_mode) || about.st_uid != geteuid())
        return false;
    const int fd =
        ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC | O_NOFOLLOW, 0600);
    if (fd < 0) return false;
    const bool good = ::write(fd, token.data(), token.size()) == static_cast<ssize_t>(token.size());
    ::close(fd);
    return good;
}

}  // namespace polyturn::supervisor
