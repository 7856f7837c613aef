// What may come through the socket: which lines are understood, which are refused, and that nothing
// of a hostile line reaches a parser that recurses.
#include "kernel/supervisor/start/request.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "tests/places.hpp"

namespace polyturn::supervisor {
namespace {

std::string nested(std::size_t depth) {
    return R"({"do":"store","op":{"do":"tools.list","x":)" + std::string(depth, '[') +
           std::string(depth, ']') + "}}";
}

TEST(Request, EachVerbIsDecoded) {
    const auto press = decode_request(
        R"({"do":"press","folder":"/programs","words":"feed_hold L2","token":"abc"})");
    ASSERT_TRUE(press) << press.diagnosis().text();
    EXPECT_EQ(press->verb, RequestVerb::Press);
    EXPECT_EQ(press->rank, RequestClass::Stop);
    EXPECT_EQ(press->words, "feed_hold L2");
    EXPECT_EQ(press->folder, "/programs");
    EXPECT_EQ(press->token, "abc");
    const auto lines =
        decode_request(R"({"do":"parameters","lines":["N1600 L1=2","N1601 L1=3"],"import":true})");
    ASSERT_TRUE(lines) << lines.diagnosis().text();
    EXPECT_TRUE(lines->import);
    EXPECT_EQ(lines->rank, RequestClass::Files) << "an import checks the whole machine";
    EXPECT_EQ(lines->lines.size(), 2u);
    const auto store =
        decode_request(R"({"do":"store","op":{"do":"tools.set","tool":1,"fields":{"h":"3"}}})");
    ASSERT_TRUE(store) << store.diagnosis().text();
    EXPECT_EQ(store->operation, "tools.set");
    EXPECT_NE(store->operation_text.find("fields"), std::string::npos);
    const auto alarms = decode_request(R"({"do":"alarms","since":18446744073709551615})");
    ASSERT_TRUE(alarms);
    EXPECT_EQ(alarms->since, 18446744073709551615u);
    EXPECT_EQ(decode_request(R"({"do":"press","words":"select L1=O1.nc"})")->rank,
              RequestClass::Files);
    EXPECT_EQ(decode_request(R"({"do":"press","words":"cycle_start"})")->rank,
              RequestClass::Machine);
    for (const char* line : {R"({"do":"who"})", R"({"do":"logout","token":"x"})", R"({"do":"end"})",
                             R"({"do":"set","words":"I5=1"})", R"({"do":"release","words":"I5"})"})
        EXPECT_TRUE(decode_request(line)) << line;
}

TEST(Request, WhatIsNoneIsRefused) {
    for (const char* line : {"",
                             "x",
                             "3",
                             "[]",
                             "null",
                             "\"press\"",
                             "{",
                             R"({"do":1})",
                             R"({"words":"reset"})",
                             R"({"do":"press"})",
                             R"({"do":"press","words":1})",
                             R"({"do":"press","words":["reset"]})",
                             R"({"do":"press","words":"reset","spell":1})",
                             R"({"do":"press","words":"a\u0000b"})",
                             R"({"do":"parameters","lines":[],"import":"x"})",
                             R"({"do":"parameters","lines":[1]})",
                             R"({"do":"parameters"})",
                             R"({"do":"parameters","lines":{"a":1}})",
                             R"({"do":"store"})",
                             R"({"do":"store","op":"x"})",
                             R"({"do":"store","op":{}})",
                             R"({"do":"store","op":{"do":1}})",
                             R"({"do":"alarms","since":-1})",
                             R"({"do":"alarms","since":1.5})",
                             R"({"do":"who","token":1})",
                             "{\"do\":\"press\",\"words\":\"\xff\"}"}) {
        const auto read = decode_request(line);
        ASSERT_FALSE(read) << line;
        EXPECT_EQ(read.diagnosis().alarm, Alarm::RequestBad) << line;
    }
    EXPECT_EQ(decode_request(R"({"do":"unheard of"})").diagnosis().alarm, Alarm::PressUnknown);
}

TEST(Request, LimitsAreLookedAtBeforeAParserIs) {
    EXPECT_TRUE(decode_request(nested(kDeepest - 2)));  // the request and `op` are two
    EXPECT_FALSE(decode_request(nested(kDeepest - 1)));
    EXPECT_FALSE(decode_request(nested(500'000))) << "without recursion";
    EXPECT_FALSE(decode_request(std::string(1'000'000, '[')));
    EXPECT_TRUE(decode_request(R"({"do":"press","words":")" + std::string(500, '[') + "\"}"))
        << "brackets in a text are text";
    EXPECT_TRUE(
        decode_request(R"({"do":"press","words":"\"[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[[["})"));
    EXPECT_FALSE(decode_request(R"({"do":"press","words":")" + std::string(5'000, 'x') + "\"}"))
        << "longer than the field";
    const auto lines = [](std::size_t count, const char* import) {
        std::string out = R"({"do":"parameters","lines":["N1=2")";
        for (std::size_t i = 1; i < count; ++i) out += ",\"N1=2\"";
        return out + "]" + import + "}";
    };
    EXPECT_TRUE(decode_request(lines(4'000, "")));
    EXPECT_FALSE(decode_request(lines(kMostValues + 1, "")));
    EXPECT_TRUE(decode_request(lines(100'000, ",\"import\":true")));
    EXPECT_FALSE(decode_request(lines(10'000, ",\"import\":false")));
    EXPECT_FALSE(decode_request(R"({"do":"store","op":{"do":"tools.list","x":")" +
                                std::string(kLongestLine, 'x') + "\"}}"));
    EXPECT_TRUE(decode_request(R"({"do":"store","op":{"do":"tools.import","text":")" +
                               std::string(kLongestLine, 'x') + "\"}}"));
    EXPECT_FALSE(decode_request(R"({"do":"store","op":{"do":"tools.import","text":")" +
                                std::string(kLongestImport, 'x') + "\"}}"));
}

TEST(Request, AStopIsSeenAtALook) {
    for (const char* line :
         {R"({"do":"press","words":"feed_hold"})",
          R"({"do":"press","folder":"/a \"b\"","token":"t","words":"feed_hold L2"})",
          R"( { "words" : " emergency_stop" , "do" : "press" } )",
          R"({"do":"press","words":"reset L1 L2"})"}) {
        EXPECT_TRUE(is_stop(line)) << line;
        ASSERT_TRUE(decode_request(line)) << line;
        EXPECT_EQ(decode_request(line)->rank, RequestClass::Stop) << line;
    }
    for (const char* line :
         {"", "{", "{}", R"({"do":"press","words":"cycle_start"})",
          R"({"do":"set","words":"reset"})", R"({"do":"press","words":"resets"})",
          R"({"do":"press","words":"mode L1=auto reset"})", R"({"do":"press","words":"reset")",
          R"({"do":"press","words":["reset"]})", R"({"do":"press","words":"reset\)",
          R"({"x":[{"do":"press","words":"reset"}]})"})
        EXPECT_FALSE(is_stop(line)) << line;
    EXPECT_FALSE(is_stop(R"({"do":"press","folder":")" + std::string(kStopLine, 'x') +
                         R"(","words":"reset"})"))
        << "it acts in its turn";
}

// docs/shop.md has the table as it is; in the other languages its names.
TEST(Request, TheManualHasEachRequest) {
    const auto page = [](const char* name) {
        std::ifstream file(std::string(kSourceFolder) + "/docs/" + name);
        return std::string(std::istreambuf_iterator<char>(file), {});
    };
    const std::string table = describe_requests();
    EXPECT_NE(page("shop.md").find(table), std::string::npos) << table;
    for (const char* name : {"shop.ru.md", "shop.cs.md", "shop.hu.md"}) {
        const std::string text = page(name);
        for (std::size_t at = table.find("| `"); at != std::string::npos;
             at = table.find("\n| `", at + 1)) {
            const std::size_t begin = table.find('`', at);
            EXPECT_NE(text.find("| " + table.substr(begin, table.find('`', begin + 1) - begin + 1)),
                      std::string::npos)
                << name;
        }
    }
}

}  // namespace
}  // namespace polyturn::supervisor
