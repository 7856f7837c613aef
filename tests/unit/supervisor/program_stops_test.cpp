// A programmed stop that is overlooked would be answered at another tick each time, so every
// spelling counts.
#include "kernel/supervisor/check/program_stops.hpp"

#include <gtest/gtest.h>

namespace polyturn::supervisor {
namespace {

TEST(ProgramStops, AreFoundInEverySpelling) {
    for (const char* text :
         {"M0", "M00", "M1\n", "N10 M01", "G0X1M0Z5", "m0", "M=1", "M 0", "M#101", "M[#1+0]"})
        EXPECT_TRUE(text_holds_program_stop(text)) << text;
    for (const char* text : {"", "M3", "M30", "M10", "M08", "M100", "M002", "G0 X1.", "M0.5"})
        EXPECT_FALSE(text_holds_program_stop(text)) << text;
}

TEST(ProgramStops, SoAreStartsOfOtherPrograms) {
    for (const char* text : {"START(2)", "N10 start (2,3)\n", "x\nSTART(\"LOWER\")"})
        EXPECT_TRUE(text_starts_programs(text)) << text;
    for (const char* text : {"", "START", "RESTART=1", "STARTS(1)", "S TART(2)"})
        EXPECT_FALSE(text_starts_programs(text)) << text;
}

}  // namespace
}  // namespace polyturn::supervisor
