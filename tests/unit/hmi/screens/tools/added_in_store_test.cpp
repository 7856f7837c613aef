// What is typed with + is added by the store. Between the picture of a value and the key somebody
// else writes it: what he wrote stays.
#include "hmi/screens/machine/parameters.hpp"
#include "hmi/screens/tools/offsets.hpp"
#include "hmi/screens/tools/tools.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class AddedInStore : public Tasks {
protected:
    // By another way than the screens; no frame is drawn meanwhile.
    void elsewhere(QStringList words) {
        words << "--instance" << g_controller->name;
        ASSERT_TRUE(g_controller->run(words)) << words.join(' ').toStdString();
    }
    double number(const char* row, unsigned instance) const {
        return live().table().numbers[params::find(row)->first_slot + instance - 1];
    }
};

TEST_F(AddedInStore, AParameterAndItsUndo) {
    elsewhere({"params", "set", "N1600 L1=2"});
    Operator hand(*window);
    hand.screen("parameters");
    auto& page = screenOf<Parameters>();
    page.find("N1600");
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return page.table().rows() >= 1 && number("N1600", 1) == 2;
    }));
    hand.touchCell(page.table(), 0, 2);
    frames(*window);
    hand.type("+0.5");
    elsewhere({"params", "set", "N1600 L1=4"});
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return number("N1600", 1) == 4.5;
    })) << number("N1600", 1);
    // What was added is taken back, and nothing that came after it.
    hand.soft("Undo");
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return number("N1600", 1) == 4;
    })) << number("N1600", 1);
    hand.type("+1");
    hand.key(Qt::Key_Return);
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return number("N1600", 1) == 5;
    }));
    elsewhere({"params", "set", "N1600 L1=7"});
    page.keys()[7].act();  // Undo, before anybody has seen the 7
    frames(*window, 500);
    EXPECT_EQ(number("N1600", 1), 7);
}

// One bit is turned: its neighbour is another panel's.
TEST_F(AddedInStore, ABitAlone) {
    elsewhere({"params", "set", "N1414 L1=00000000"});
    Operator hand(*window);
    hand.screen("parameters");
    auto& page = screenOf<Parameters>();
    page.find("N1414");
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return page.table().rows() >= 1 && number("N1414", 1) == 0;
    }));
    hand.touchCell(page.table(), 0, 2);
    frames(*window);
    hand.touch(&page.detail(), 1);  // chosen
    elsewhere({"params", "set", "N1414#1 L1=1"});
    hand.touch(&page.detail(), 1);  // turned
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return number("N1414", 1) == 3;
    })) << number("N1414", 1);
}

TEST_F(AddedInStore, TheLifeOfATool) {
    elsewhere({"tools", "add", "7", "name=ADDED", "type=7", "life_kind=pieces", "life=100",
               "counter=10"});
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return live().tools().rows[6].used;
    }));
    Operator hand(*window);
    hand.screen("tools");
    Tools& tools = screenOf<Tools>();
    hand.touchCell(tools.list(), tools.rowOf(7), 1);
    hand.soft("Tool data");
    ASSERT_EQ(tools.table().cell(7, 0).text, "Used up");
    tools.table().choose(7);
    frames(*window);
    hand.type("+5");
    elsewhere({"tools", "set", "7", "counter=30"});  // the machine has counted
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return live().tools().rows[6].counter == 35;
    })) << live().tools().rows[6].counter;
    elsewhere({"tools", "delete", "7"});
}

TEST_F(AddedInStore, ATolerance) {
    Operator hand(*window);
    hand.screen("offsets");
    Offsets& offsets = screenOf<Offsets>();
    offsets.showParts(true);
    frames(*window);
    PartsPage& parts = offsets.parts();
    hand.soft("New dimension");
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return parts.dimensions().size() == 1;
    }));
    const QString number = QString::number(parts.dimensions()[0].value("dimension").toInt());
    hand.touchCell(parts.table(), 0, PartsPage::kUpper);
    frames(*window);
    hand.type("+0.01");
    elsewhere({"parts", "set", number, "upper=0.05"});
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 50);
        return !parts.dimensions().empty() &&
               std::abs(parts.dimensions()[0].value("upper").toDouble() - 0.06) < 1e-9;
    })) << parts.dimensions()[0].value("upper").toDouble();
    elsewhere({"parts", "delete", number});
}

}  // namespace
}  // namespace polyturn::hmi
