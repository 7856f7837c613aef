// Properties (RapidCheck) with a seed that is fixed in the first run and new in the second: see
// tests/seeds.hpp.
#pragma once
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <string>
#include <utility>

#include "tests/seeds.hpp"

// As RC_GTEST_PROP, which is not used: its seed would be another one each time and kept nowhere.
#define PROPERTY(Suite, Name, Arguments)                      \
    void property_##Suite##_##Name Arguments;                 \
    TEST(Suite, Name) {                                       \
        test_seed(2026);                                      \
        ::rc::detail::checkGTest(&property_##Suite##_##Name); \
    }                                                         \
    void property_##Suite##_##Name Arguments

// As rc::check, within a test: false when a counterexample was found.
template <typename Property>
bool holds(const std::string& what, Property&& property) {
    test_seed(2026);
    return rc::check(what, std::forward<Property>(property));
}
