// TOML beyond its limits never reaches the library; within them nothing is refused.
#include "ipc/model/files/toml_limits.hpp"

#include <gtest/gtest.h>

#include "ipc/model/files/job.hpp"
#include "ipc/model/files/scenario.hpp"
#include "ipc/model/files/setup.hpp"

namespace polyturn::text {
namespace {

std::string repeated(std::string_view piece, std::size_t times) {
    std::string out;
    for (std::size_t i = 0; i < times; ++i) out += piece;
    return out;
}

TEST(TomlLimits, WhatPeopleWritePasses) {
    for (const std::string& text :
         {std::string("a.b.c = 1\n[channel.1.tool.1.edge.1]\nDP1 = 500\n"),
          // a dot in each number, none of a name
          "values = [" + repeated("1.25, ", 20'000) + "]\n",
          "text = \"" + repeated("a.b.", 1000) + "\" # " + repeated("c.d.", 1000) + "\n",
          "text = '''\n" + repeated("[[[[ { = .\n", 1000) + "'''\nb = \"\"\"\\\"\"\"\"\n",
          repeated("[[at]]\nt = 1.5\n", 5000), std::string("a = \"not closed\n[b]\n"),
          std::string()})
        EXPECT_FALSE(beyond_toml_limits(text)) << text.substr(0, 60);
}

TEST(TomlLimits, TheFirstPlaceBeyondThemIsNamed) {
    struct Row {
        std::string text;
        std::uint32_t line;
        const char* says;
    };
    for (const Row& row : {Row{"a = 1\n" + repeated("k.", 50'000) + "k = 1\n", 2, "parts"},
                           Row{"[" + repeated("k.", 50'000) + "k]\n", 1, "parts"},
                           Row{"[" + repeated("\"k\" . ", 20) + "k]\n", 1, "parts"},
                           Row{"a = " + repeated("[", 40) + repeated("]", 40), 1, "brackets"},
                           Row{"a = " + repeated("{b=", 100'000), 1, "brackets"},
                           Row{"\n\n# " + repeated("x", 300'000), 3, "line"},
                           Row{"a = \"" + repeated("x", 300'000) + "\"\n", 1, "line"},
                           Row{repeated(" ", 300'000), 1, "line"}}) {
        const auto excess = beyond_toml_limits(row.text);
        ASSERT_TRUE(excess) << row.text.substr(0, 40);
        EXPECT_EQ(excess->line, row.line) << row.text.substr(0, 40);
        EXPECT_NE(excess->what.find(row.says), std::string::npos) << excess->what;
    }
}

// Seen before: the stack of whoever reads it is full (50 000 tables in each other).
TEST(TomlLimits, HoldForEveryReader) {
    for (const std::string& text :
         {repeated("k.", 50'000) + "k = 1\n", "[" + repeated("k.", 50'000) + "k]\nx = 1\n"}) {
        std::vector<Diagnosis> job, setup, scenario;
        (void)parse_job(text, "a.job.toml", job);
        (void)parse_setup(text, "setup.toml", setup);
        (void)parse_scenario(text, "scenario.toml", scenario);
        for (const auto* diagnoses : {&job, &setup, &scenario}) {
            ASSERT_EQ(diagnoses->size(), 1u);
            EXPECT_EQ(diagnoses->front().alarm, Alarm::TextTooDeep);
            EXPECT_EQ(diagnoses->front().place.line, 1u);
        }
    }
}

}  // namespace
}  // namespace polyturn::text
