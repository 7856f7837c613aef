// The main function of all test programs without screens.
#include <gtest/gtest.h>

#include "tests/seeds.hpp"

int main(int argc, char** argv) {
    ::testing::InitGoogleTest(&argc, argv);
    return run_tests_with_seeds();
}
