#include "tests/seeds.hpp"

#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/places.hpp"

namespace {

constexpr const char* kVariable = "POLYTURN_SEED";
constexpr const char* kFound = "/tests/seeds.txt";

std::uint64_t given() {
    const char* text = std::getenv(kVariable);
    return text ? std::strtoull(text, nullptr, 10) : 0;
}

// splitmix64: neighbouring seeds give sequences that have nothing in common.
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

std::set<std::string>& asked() {
    static std::set<std::string> names;
    return names;
}

std::string current_name() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    return info ? std::string(info->test_suite_name()) + "." + info->name() : std::string();
}

// Runs these tests of this program with this seed; its exit status.
int run_again(const std::string& filter, std::uint64_t seed) {
    std::printf("random tests once more: %s=%llu\n", kVariable,
                static_cast<unsigned long long>(seed));
    std::fflush(nullptr);
    ::setenv(kVariable, std::to_string(seed).c_str(), 1);
    ::unsetenv("RC_PARAMS");
    std::string only = "--gtest_filter=" + filter, program = "/proc/self/exe";
    char* words[] = {program.data(), only.data(), nullptr};
    ::pid_t child = 0;
    const int refused = ::posix_spawn(&child, "/proc/self/exe", nullptr, nullptr, words, environ);
    ::unsetenv(kVariable);
    int status = 1;
    if (refused != 0) {
        std::printf("%s does not start again: error %d\n", filter.c_str(), refused);
        return 1;
    }
    while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return 0;
    std::printf(
        "%s=%llu found a fault; repeat it with that variable and\n"
        "    --gtest_filter=%s\nand write \"SUITE.TEST %llu\" into tests%s: then it is tried in "
        "each run\n",
        kVariable, static_cast<unsigned long long>(seed), filter.c_str(),
        static_cast<unsigned long long>(seed), kFound + 6);
    return 1;
}

}  // namespace

std::uint64_t test_seed(std::uint64_t fixed) {
    const std::uint64_t base = given();
    if (const std::string name = current_name(); !name.empty() && asked().insert(name).second) {
        if (base != 0)
            std::printf("seed %llu (%s)\n", static_cast<unsigned long long>(base), kVariable);
        else
            std::printf("seed %llu, its fixed one\n", static_cast<unsigned long long>(fixed));
    }
    if (base == 0) return fixed;
    return mixed(base + mixed(fixed)) & 0xffff'ffffu;  // 32 bits: for every engine of the library
}

int run_tests_with_seeds() {
    // RapidCheck reads its settings at the first property.
    const std::uint64_t base = given();
    ::setenv("RC_PARAMS", ("seed=" + std::to_string(base != 0 ? base : 2026)).c_str(), 0);
    int status = RUN_ALL_TESTS();
    if (status != 0 || base != 0 || asked().empty()) return status;

    std::string all;
    for (const std::string& name : asked()) all += (all.empty() ? "" : ":") + name;
    std::ifstream found(std::string(kSourceFolder) + kFound);
    for (std::string line; std::getline(found, line);) {
        std::istringstream words(line);
        std::string name;
        std::uint64_t seed = 0;
        if (words >> name >> seed && asked().count(name)) status |= run_again(name, seed);
    }
    std::random_device fresh;
    return status | run_again(all, 1 + fresh() % 999'999'999);
}
