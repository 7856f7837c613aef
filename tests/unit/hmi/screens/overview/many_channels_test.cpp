// Machines with more channels than a panel has room for at first sight: every screen still fits, in
// every language, and each channel is reached.
#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/graphics/graphics.hpp"
#include "hmi/screens/overview/channel_card.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/many_machine.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

class ManyChannels : public ::testing::TestWithParam<int> {};

// Where the lowest letter of a line ends, written in the middle of its box as a sheet writes it.
double lowestInk(const Item& item) {
    const QFontMetricsF letters(item.font);
    return item.box.center().y() - letters.height() / 2 + letters.ascent() +
           letters.tightBoundingRect(item.text).bottom();
}

TEST_P(ManyChannels, FitOnAPanel) {
    QTemporaryDir folder;
    QFile file(folder.filePath("many.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(GetParam()));
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(waitFor([&] {
        return window.context().live.connected() &&
               window.context().live.channels().size() == static_cast<std::size_t>(GetParam());
    }));
    frames(window, 300);
    noWordIsShortened(window);
    window.showScreen(0);
    frames(window, 30);
    for (Sheet* card : window.screen()->sheets())
        for (const Item& item : card->items()) {  // letters with feet lose them in a low line
            if (item.kind != Item::Kind::Text || item.wraps || item.text.isEmpty()) continue;
            EXPECT_LE(lowestInk(item), item.box.bottom() + 0.5) << item.text.toStdString();
        }
    // each is touched in the overview
    for (const unsigned channel : window.context().live.channels()) {
        window.showScreen(0);
        const auto sheets = window.screen()->sheets();
        ASSERT_EQ(sheets.size(), static_cast<std::size_t>(GetParam()));
        Sheet* card = sheets[channel - 1];
        QTest::mouseClick(card, Qt::LeftButton, {}, card->rect().center());
        EXPECT_EQ(window.context().channel, channel);
    }
}

// Of many channels a card leaves lines out: a second touch, or Enter, gives the chosen one the room
// for all of them; the others stay beside it.
TEST(ManyChannelsCard, IsEnlargedByATouchAndByAKey) {
    QTemporaryDir folder;
    QFile file(folder.filePath("many.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(8));
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(waitFor([&] {
        return window.context().live.connected() && window.context().live.channels().size() == 8;
    }));
    window.showScreen(0);
    const auto says = [&](unsigned channel, const QString& text) {
        for (const Item& item : window.screen()->sheets()[channel - 1]->items())
            if (item.text == text) return true;
        return false;
    };
    const auto touch = [&](unsigned channel) {
        Sheet* card = window.screen()->sheets()[channel - 1];
        QTest::mouseClick(card, Qt::LeftButton, {}, card->rect().center());
    };
    Operator hand(window);
    // all the turrets that were copied stand at one place: their names do not lie upon each other
    for (Screen* one : window.screens())
        if (auto* graphics = dynamic_cast<Graphics*>(one)) {
            window.showScreen(6);
            graphics->turnTo(1);  // the whole machine
            ASSERT_TRUE(waitFor([&] { return graphics->labels().size() >= 8; }));
            const auto labels = graphics->labels();
            for (std::size_t i = 0; i < labels.size(); ++i)
                for (std::size_t j = 0; j < i; ++j)
                    EXPECT_FALSE(labels[i].intersects(labels[j])) << i << " " << j;
            graphics->turnTo(0);
            window.showScreen(0);
        }
    touch(6);
    EXPECT_EQ(window.context().channel, 6u);
    EXPECT_TRUE(says(6, "Parts") && says(6, "Mean")) << "figures without a heading";
    EXPECT_TRUE(says(6, "Lag")) << "the following error, under a word that fits";
    EXPECT_FALSE(says(6, "Follow. error"));
    touch(6);
    for (const char* line : {"Follow. error", "Remaining", "Workpiece", "Machine", "To go"})
        EXPECT_TRUE(says(6, line)) << line;
    // an upright panel leaves nothing out either
    window.resize(768, 1024);
    frames(window, 60);
    for (const char* line : {"Follow. error", "Remaining", "Workpiece", "Machine", "To go"})
        EXPECT_TRUE(says(6, line)) << line;
    for (unsigned channel = 1; channel <= 8; ++channel)
        EXPECT_TRUE(says(channel, "Machine")) << channel;
    window.resize(1280, 800);
    frames(window, 60);
    for (unsigned channel = 1; channel <= 8; ++channel)
        EXPECT_TRUE(window.rect().contains(window.screen()->sheets()[channel - 1]->geometry()))
            << channel;
    hand.key(Qt::Key_Left);  // the one before
    EXPECT_TRUE(says(5, "Follow. error"));
    EXPECT_FALSE(says(6, "Follow. error"));
    touch(2);
    EXPECT_TRUE(says(2, "Follow. error"));
    hand.key(Qt::Key_Return);
    EXPECT_FALSE(says(2, "Follow. error"));
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(says(2, "Follow. error"));
    hand.key(Qt::Key_Escape);
    EXPECT_FALSE(says(2, "Follow. error"));
    // Keys of channels keep their signs on Manual.
    for (std::size_t i = 0; i < window.screens().size(); ++i)
        if (QString(window.screens()[i]->name()) == "manual")
            window.showScreen(static_cast<int>(i));
    int signs = 0;
    for (const Item& item : window.screen()->sheets()[0]->items())
        signs += item.kind == Item::Kind::Sign && item.box.bottom() <= 42;
    EXPECT_GE(signs, 8);
}
// A small card says what a whole one does, each on a line of its own: mode, program, running block,
// codes, tool and offset, what it waits for.
TEST(ManyChannelsCard, OfSixteenTellsModeBlockCodesToolAndWait) {
    QTemporaryDir folder;
    QFile file(folder.filePath("many.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(16));
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(waitFor([&] {
        return window.context().live.connected() && window.context().live.channels().size() == 16;
    }));
    ASSERT_TRUE(controller.press("machine_on"));
    QFile program(folder.filePath("O7.nc"));
    ASSERT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("O7\nN10 G0 T0303\nN20 M503 P47 (meets the fourth)\nN30 M30\n");
    program.close();
    ASSERT_TRUE(controller.press("select L7=" + program.fileName()));
    ASSERT_TRUE(controller.press("reference all"));
    ASSERT_TRUE(waitFor([&] { return window.context().live.channel(7).start_missing == 0; }));
    ASSERT_TRUE(controller.press("cycle_start L7"));
    ASSERT_TRUE(waitFor([&] {
        return static_cast<ChannelState>(window.context().live.channel(7).state) ==
               ChannelState::Waiting;
    }));
    window.showScreen(0);
    frames(window, 200);
    const auto says = [&](unsigned channel, const QString& text) {
        for (const Item& item : window.screen()->sheets()[channel - 1]->items())
            if (item.text.contains(text)) return true;
        return false;
    };
    for (const char* words : {"L7", "Automatic", "Waits", "M503", "L4", "meets the fourth", "O7.nc",
                              "G0", "T3", "Offset 3", "F 0"})
        EXPECT_TRUE(says(7, words)) << words;
    EXPECT_TRUE(says(9, "no program"));
    // where each axis is, in both systems, what it still has to go, how far it is behind
    for (unsigned channel = 1; channel <= 16; ++channel)
        for (const char* head : {"Workpiece", "Machine", "To go", "Lag"})
            EXPECT_TRUE(says(channel, head)) << channel << " " << head;
    noWordIsShortened(window);
    window.showScreen(0);
    // Beside a large card two columns have room: a touch, or the arrows, turn them to the other
    // two, in all of them.
    Operator hand(window);
    window.context().choose(7);
    hand.key(Qt::Key_Return);
    frames(window, 100);
    for (const char* line : {"Workpiece", "Machine", "To go", "Follow. error", "N20 M503 P47",
                             "N10 G0", "N30 M30", "T3", "Remaining"})
        EXPECT_TRUE(says(7, line)) << line;
    EXPECT_TRUE(says(9, "Workpiece") && says(9, "To go"));
    EXPECT_FALSE(says(9, "Machine"));
    Sheet* card = window.screen()->sheets()[8];
    hand.touch(card, kTurnAxesHit);
    EXPECT_EQ(window.context().channel, 7u) << "and chooses no other channel";
    for (const unsigned channel : {1u, 9u, 16u})
        EXPECT_TRUE(says(channel, "Machine") && says(channel, "Lag") && !says(channel, "To go"))
            << channel;
    const QString kept = window.screen()->state();
    hand.key(Qt::Key_Up);
    EXPECT_TRUE(says(9, "To go"));
    window.screen()->restore(kept);
    frames(window, 60);
    EXPECT_TRUE(says(9, "Lag")) << "kept over a restart";
    noWordIsShortened(window);
    for (const QSize size : {QSize(1024, 768), QSize(768, 1024)}) {
        window.resize(size);
        frames(window, 60);
        noWordIsShortened(window);
        window.showScreen(0);
        frames(window, 60);
        for (unsigned channel = 1; channel <= 16; ++channel)
            EXPECT_TRUE(says(channel, "Machine")) << channel << " on " << size.width();
    }
}

// N0000: which channels form a machine is seen in their cards, and each group has keys of its own
// where all channels have theirs otherwise.
TEST(MachineGroups, HaveKeysOfTheirOwnForTheGroupOfTheChosenChannel) {
    QTemporaryDir folder;
    QFile file(folder.filePath("groups.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(4, 3));  // L3 and L4 are a machine of their own
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    const Live& live = window.context().live;
    ASSERT_TRUE(waitFor([&] { return live.connected() && live.channels().size() == 4; }));
    ASSERT_TRUE(controller.press("machine_on"));
    ASSERT_TRUE(controller.press("reference all"));
    QFile program(folder.filePath("O1.nc"));
    ASSERT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("O1\nN10 G4 X30.\nM30\n");
    program.close();
    for (const char* channel : {"L1", "L2", "L3"})
        ASSERT_TRUE(controller.press(QString("select %1=%2").arg(channel, program.fileName())));
    ASSERT_TRUE(waitFor(
        [&] { return live.channel(1).start_missing == 0 && live.channel(3).start_missing == 0; }));
    const auto state = [&](unsigned channel) {
        return static_cast<ChannelState>(live.channel(channel).state);
    };
    const auto says = [&](unsigned channel, const QString& text) {
        for (const Item& item : window.screen()->sheets()[channel - 1]->items())
            if (item.text == text) return true;
        return false;
    };
    Operator hand(window);
    hand.screen("overview");
    frames(window, 100);
    for (unsigned channel = 1; channel <= 4; ++channel)
        EXPECT_TRUE(says(channel, channel < 3 ? "Group 1" : "Group 2")) << channel;
    hand.key(Qt::Key_3, Qt::ControlModifier);
    hand.soft("Start group 2");
    frames(window, 300);
    EXPECT_EQ(state(3), ChannelState::Reset) << "one press starts no program";
    hand.soft("Start group 2");
    ASSERT_TRUE(waitFor([&] { return state(3) == ChannelState::Running; }));
    frames(window, 200);
    EXPECT_EQ(state(1), ChannelState::Reset);
    EXPECT_EQ(state(4), ChannelState::Reset);
    EXPECT_TRUE(standsOn(window.ownSheets(), "L4: no program is selected"));
    hand.soft("Hold group 2");
    ASSERT_TRUE(waitFor([&] { return state(3) == ChannelState::Held; }));
    hand.soft("Single block group 2");
    ASSERT_TRUE(waitFor([&] {
        return (live.channel(3).keys & kKeySingleBlock) && (live.channel(4).keys & kKeySingleBlock);
    }));
    EXPECT_FALSE(live.channel(1).keys & kKeySingleBlock);
    hand.soft("Reset group 2");
    frames(window, 300);
    EXPECT_EQ(state(3), ChannelState::Held) << "one press ends no program";
    hand.soft("Reset group 2");
    ASSERT_TRUE(waitFor([&] { return state(3) == ChannelState::Reset; }));
    hand.soft("All channels");  // on a page of their own
    hand.soft("Start all");
    hand.soft("Start all");
    ASSERT_TRUE(waitFor([&] {
        return state(1) == ChannelState::Running && state(2) == ChannelState::Running &&
               state(3) == ChannelState::Running;
    }));
    hand.soft("Hold all");
    ASSERT_TRUE(
        waitFor([&] { return state(1) == ChannelState::Held && state(2) == ChannelState::Held; }));
    window.showScreen(0);
    noWordIsShortened(window);
}

// The channel reads as far ahead as its ring has room, and each block of the loop has other codes
// than the one before.
TEST(ManyChannelsCard, TellsToolAndCodesOfALoopThatIsReadFarAhead) {
    QTemporaryDir folder;
    Controller controller;
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    const Live& live = window.context().live;
    ASSERT_TRUE(waitFor([&] { return live.connected(); }));
    ASSERT_TRUE(controller.press("machine_on"));
    ASSERT_TRUE(controller.press("reference all"));
    QFile program(folder.filePath("O1.nc"));
    ASSERT_TRUE(program.open(QIODevice::WriteOnly));
    program.write("O1\nT0101\nN10 G98 G1 X50. F3000.\nG0 X51.\nG1 X50. F2900.\nG0 X51.\nGOTO 10\n");
    program.close();
    ASSERT_TRUE(controller.press("select L1=" + program.fileName()));
    ASSERT_TRUE(waitFor([&] { return live.channel(1).start_missing == 0; }));
    ASSERT_TRUE(controller.press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] { return live.channel(1).record > 30; }));
    frames(window, 1000);  // long enough for the channel to be far ahead
    int known = 0;
    for (int look = 0; look < 40; ++look) {
        frames(window, 30);
        known += live.view(1).known && live.view(1).picture.tool == 1;
    }
    EXPECT_EQ(known, 40);
    ASSERT_TRUE(controller.press("reset"));
}

// State and cause are the most important words of a card: an alarm, a wait with its partner and
// what a start lacks, on every panel.
class CardsInTrouble : public ::testing::TestWithParam<int> {};

TEST_P(CardsInTrouble, TellStateAndCauseWhole) {
    QTemporaryDir folder;
    QFile file(folder.filePath("many.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(GetParam()));
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en";
    choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    const Live& live = window.context().live;
    const auto last = static_cast<unsigned>(GetParam());
    ASSERT_TRUE(waitFor([&] { return live.connected() && live.channels().size() == last; }));
    ASSERT_TRUE(controller.press("machine_on") && controller.press("reference all"));
    const auto write = [&](const char* name, const char* text) {
        QFile program(folder.filePath(name));
        EXPECT_TRUE(program.open(QIODevice::WriteOnly));
        program.write(text);
        return program.fileName();
    };
    ASSERT_TRUE(controller.press("select L1=" + write("O1.nc", "O1\nN10 M98 P9876\nN20 M30\n")));
    ASSERT_TRUE(controller.press("select L2=" +
                                 write("O2.nc", "O2\nN10 M503 P12 (meets the first)\nN20 M30\n")));
    ASSERT_TRUE(waitFor(
        [&] { return live.channel(1).start_missing == 0 && live.channel(2).start_missing == 0; }));
    ASSERT_TRUE(controller.press("cycle_start L2") && controller.press("cycle_start L1"));
    ASSERT_TRUE(waitFor([&] {
        return static_cast<ChannelState>(live.channel(1).state) == ChannelState::Interrupted &&
               static_cast<ChannelState>(live.channel(2).state) == ChannelState::Waiting;
    }));
    for (const QSize size : {QSize(1280, 800), QSize(768, 1024), QSize(1920, 1080)}) {
        window.resize(size);
        frames(window, 100);
        noWordIsShortened(window);
        for (const DisplayLanguage display_language : kDisplayLanguages) {
            window.setDisplayLanguage(display_language);
            window.showScreen(0);
            frames(window, 30);
            for (unsigned channel = 1; channel <= std::min(last, 3u); ++channel) {
                const QString state = stateWords(live.channel(channel)).text;
                const auto& items = window.screen()->sheets()[channel - 1]->items();
                const auto told = std::find_if(items.begin(), items.end(),
                                               [&](const Item& one) { return one.text == state; });
                ASSERT_NE(told, items.end()) << channel;
                EXPECT_LE(QFontMetricsF(told->font).horizontalAdvance(state), told->box.width() + 1)
                    << size.width() << "x" << size.height() << " " << codeOf(display_language)
                    << " L" << channel << ": " << state.toStdString();
            }
        }
        window.setDisplayLanguage(DisplayLanguage::English);
    }
    // A machine of which a program is broken off is not told to be ready, in green.
    ASSERT_TRUE(controller.press("reset L2"));
    ASSERT_TRUE(waitFor(
        [&] { return static_cast<ChannelState>(live.channel(2).state) == ChannelState::Reset; }));
    frames(window, 100);
    EXPECT_FALSE(standsOn({window.ownSheets()[0]}, "ready")) << "L1 is interrupted";
}

INSTANTIATE_TEST_SUITE_P(Panel, CardsInTrouble, ::testing::Values(2, 3, 16));
INSTANTIATE_TEST_SUITE_P(Panel, ManyChannels, ::testing::Values(3, 4, 8, 16));

}  // namespace
}  // namespace polyturn::hmi
