// The machine builder's messages: the built-in PLC's in four languages, and files that add to them.
#include "ipc/model/files/builder_messages.hpp"

#include <gtest/gtest.h>

namespace polyturn::text {
namespace {

TEST(BuilderMessages, OfTheBuiltInPlcHaveFourLanguagesCauseAndRemedy) {
    const BuilderMessages messages;
    for (int number = 1; number <= 14; ++number) {
        SCOPED_TRACE(number);
        const BuilderMessage* message = messages.find(number);
        ASSERT_NE(message, nullptr);
        for (const std::string& text : message->text) EXPECT_FALSE(text.empty());
        for (const auto* all : {&message->cause, &message->remedy})
            for (std::size_t i = 0; i < all->size(); ++i) {
                EXPECT_FALSE((*all)[i].empty()) << i;
                if (i) { EXPECT_NE((*all)[i], (*all)[0]); }
            }
    }
    EXPECT_EQ(messages.find(15), nullptr);
    EXPECT_EQ(messages.explain(15), "");
}

TEST(BuilderMessages, OfAFileReplaceAndAdd) {
    BuilderMessages messages;
    EXPECT_TRUE(messages
                    .add("number,en,ru,cs,hu,cause,remedy\n3,\"no pocket, no tool\",,,,,Load it.\n"
                         "# remark\n101,hot,,horko,,,\n",
                         "m.csv")
                    .empty());
    EXPECT_EQ(messages.explain(3), ": no pocket, no tool. Load it.");
    EXPECT_EQ(messages.find(101)->in(MessageLanguage::Czech), "horko");
    EXPECT_TRUE(
        messages.add("102,cold,,zima,,frost,Heat it.,,mráz,,,Zatopte.,\n", "m.csv").empty());
    EXPECT_EQ(messages.explain(102, MessageLanguage::Czech), ": zima; příčina: mráz. Zatopte.");
    EXPECT_EQ(messages.explain(102, MessageLanguage::Russian, false), ": cold; причина: frost");
    EXPECT_EQ(messages.find(101)->in(MessageLanguage::Hungarian), "hot")
        << "what is not translated is said in English";
}

TEST(BuilderMessages, ThatWereToldInOneLanguageAreReadInAnother) {
    BuilderMessages messages;
    ASSERT_TRUE(
        messages
            .add("101,oil,масло,olej,olaj,,\n102,oil is hot,масло горячее,olej je horký,az olaj "
                 "forró,the cooler,Clean it.,холодильник,chladič,hűtő,Очистите.,Vyčistěte.,"
                 "Tisztítsa.\n",
                 "m.csv")
            .empty());
    const std::string english = "message 102 of the machine builder" + messages.explain(102);
    EXPECT_EQ(messages.told_in(english, MessageLanguage::Russian),
              "message 102 of the machine builder: масло горячее; причина: холодильник. Очистите.");
    EXPECT_EQ(messages.told_in("hlášení 102" + messages.explain(102, MessageLanguage::Czech, false),
                               MessageLanguage::Hungarian),
              "hlášení 102: az olaj forró; ok: hűtő");
    EXPECT_EQ(messages.told_in("message 101" + messages.explain(101), MessageLanguage::Czech),
              "message 101: olej");
    EXPECT_EQ(messages.told_in("message 103 of the machine builder", MessageLanguage::Czech),
              "message 103 of the machine builder")
        << "nobody explains it";
}

TEST(BuilderMessages, WrongLinesAreToldAndTheOthersCount) {
    BuilderMessages messages;
    const auto faults = messages.add(
        "x,a,,,,,\n102,b,,,,\n103,\"c,,,,,\n104,,,,,,\n0,z,,,,,\n105,good,,,,,\n", "m.csv");
    ASSERT_EQ(faults.size(), 5u);
    for (std::size_t i = 0; i < faults.size(); ++i) {
        EXPECT_EQ(faults[i].alarm, Alarm::BuilderMessageLine);
        EXPECT_EQ(faults[i].place.line, i + 1);
    }
    EXPECT_NE(messages.find(105), nullptr);
}

}  // namespace
}  // namespace polyturn::text
