// `params list --unused` of the machine's own groups (nct_parameters 2 to 14, 24, 25): what the
// specification itself calls unused, and a reviewed list of pure hardware addresses. A row that
// stops acting, or a new one that never did, fails here until it is reviewed.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "ipc/params/registry.hpp"

namespace polyturn::params {
namespace {

// Reserved in the specification.
constexpr std::string_view kReserved[] = {"N0204", "N0423", "N0539", "N0793", "N0794", "N0795",
                                          "N0796", "N0797", "N0798", "N0799", "N0800"};
// Cards and addresses of a bus: here the drive interface (kernel/drives/drive.h) takes their place.
constexpr std::string_view kHardware[] = {"N0004", "N0500", "N0501", "N0502",
                                          "N0600", "N0601", "N0602"};

bool of_the_machine(std::string_view number) {
    if (number.size() != 5 || number[0] != 'N') return false;
    const int n = std::stoi(std::string(number.substr(1)));
    return n < 1400 || (n >= 2300 && n < 2500);
}

TEST(Unused, ParametersOfTheMachineAreReviewed) {
    const auto listed = [](std::string_view number) {
        return std::ranges::find(kReserved, number) != std::end(kReserved) ||
               std::ranges::find(kHardware, number) != std::end(kHardware);
    };
    for (const Row& row : rows()) {
        if (!of_the_machine(row.number)) continue;
        EXPECT_TRUE(row.acts == "yes" || listed(row.number))
            << row.number << " " << row.name << ": " << row.acts;
    }
}

}  // namespace
}  // namespace polyturn::params
