// Seeds of random tests. Each of them runs with its fixed seed, with each one that tests/seeds.txt
// has for it (what once failed), and with a new one. All are printed; POLYTURN_SEED=n repeats one
// alone.
//
//     std::mt19937 random(test_seed(7));          7: its fixed one
//     PROPERTY(Frames, TheInverseTakesAnyPointBack, ()) { … }     instead of RC_GTEST_PROP
//
// PROPERTY: tests/property.hpp.
// A test that asked for a seed is run again by a process of its own (tests/test_main.cpp), so
// nothing of the first run is left.
#pragma once
#include <cstdint>

// The seed to use where the fixed one stands: itself in the first run, one that is mixed from both
// in the others.
std::uint64_t test_seed(std::uint64_t fixed);

// Runs all tests, then those again that asked for a seed; the exit status of the program.
int run_tests_with_seeds();
