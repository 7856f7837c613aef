// By keys alone: every page is walked; what a finger can touch there is reached by keys too, of
// several lists the one that keys go to is seen, and from everywhere the next screen is one key
// away. Fields of text have a test of their own (entry_test.cpp).
#include <set>

#include "hmi/screens/overview/hand_page.hpp"
#include "hmi/screens/overview/manual.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/pictures/magazine.hpp"
#include "hmi/widgets/soft_keys.hpp"
#include "hmi/widgets/table.hpp"
#include "hmi/widgets/text_pad.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

struct PressedKey {
    Qt::Key key;
    Qt::KeyboardModifiers with = {};
    const char* soft = nullptr;  // a soft key by its text
};

class KeysAlone : public Tasks {
protected:
    void SetUp() override {
        Tasks::SetUp();
        g_controller->run({"tools", "add", "1", "name=ROUGH_80", "type=1", "h=1", "--instance",
                           g_controller->name});
        g_controller->run({"tools", "load", "1", "1", "1", "--instance", g_controller->name});
    }
    void press(const PressedKey& one) {
        if (!one.soft) return QTest::keyClick(window.get(), one.key, one.with);
        window->softKeys().show(window->screen()->keys());
        const auto& keys = window->softKeys().keys();
        for (std::size_t i = 0; i < keys.size(); ++i)
            if (keys[i].text == one.soft && keys[i].enabled)
                return QTest::keyClick(window.get(),
                                       static_cast<Qt::Key>(Qt::Key_F1 + static_cast<int>(i)));
    }
    // What a sheet looks like, without its texts: some of them change by themselves.
    std::string look(Sheet* sheet) {
        window->screen()->refresh();
        sheet->refresh();
        std::string out;
        for (const Item& one : sheet->items())
            if (one.kind == Item::Kind::Fill || one.kind == Item::Kind::Frame)
                out += std::to_string(static_cast<int>(one.box.x())) + "," +
                       std::to_string(static_cast<int>(one.box.y())) +
                       one.colour.name().toStdString() + ";";
        return out;
    }
    std::vector<Sheet*> shown() const {
        std::vector<Sheet*> out;
        for (Sheet* one : window->screen()->sheets())
            if (one->isVisibleTo(window.get())) out.push_back(one);
        return out;
    }
    void goTo(std::size_t screen, int page) {
        QTest::keyClick(window.get(),
                        static_cast<Qt::Key>(Qt::Key_0 + static_cast<int>((screen + 1) % 10)),
                        Qt::AltModifier);
        ASSERT_EQ(window->shown(), static_cast<int>(screen)) << "no way out of the screen before";
        window->screen()->turnTo(page);
        QTest::qWait(20);
        window->screen()->refresh();
    }
    void walk(const std::function<void(const std::string& where)>& look) {
        for (std::size_t i = 0; i < window->screens().size(); ++i) {
            const QString name = window->screens()[i]->name();
            const int pages = name == "graphics" ? 2 : window->screens()[i]->pages();
            for (int page = 0; page < pages; ++page) {
                // dry runs: a picture, and soft keys
                if (name == "programs" && (page == 1 || page == 2)) continue;
                goTo(i, page);
                const std::string where = name.toStdString() + " " + std::to_string(page + 1);
                SCOPED_TRACE(where);
                look(where);
                press({Qt::Key_F, Qt::ControlModifier});  // and out of the letters of a field too
            }
            window->screens()[i]->turnTo(0);
        }
    }
};

TEST_F(KeysAlone, ReachEveryListAndShowWhichOneTheyGoTo) {
    int lists = 0;
    walk([&](const std::string&) {
        std::vector<Table*> all;
        for (Sheet* one : shown())
            if (auto* table = dynamic_cast<Table*>(one); table && table->rows && table->rows() > 1)
                all.push_back(table);
        for (Table* table : all) {
            ++lists;
            bool reached = false;
            for (int tabs = 0; tabs < 5 && !reached; ++tabs) {
                if (tabs) press({Qt::Key_Tab});
                for (const Qt::Key key :
                     {Qt::Key_Down, Qt::Key_Up, Qt::Key_PageDown, Qt::Key_PageUp}) {
                    const int before = table->row();
                    press({key});
                    window->screen()->refresh();
                    if (table->row() == before) continue;
                    reached = true;
                    break;
                }
            }
            EXPECT_TRUE(reached) << "no key goes to the list "
                                 << (table->columns.empty()
                                         ? ""
                                         : table->columns.back().title.toStdString());
            if (all.size() > 1 && reached) {
                EXPECT_TRUE(table->focused) << "it is not seen that keys go to the list "
                                            << table->columns.back().title.toStdString();
            }
        }
    });
    EXPECT_GE(lists, 15);
}

// What acts at once and not only chooses has its keys in tests of its own: AnAxisIsMovedByKeysAlone
// (jog, reference point, override), TheWheelTurnsAnAxisByKeysByTouchAndByTheDial,
// ABitIsTurnedOverByKeysAlone.
bool acts(const QString& screen, int hit) {
    if (screen == "manual")
        return hit < HandPage::kAxisHits ||
               (hit >= HandPage::kMinusHit && hit <= HandPage::kDialHit) ||
               (hit >= Manual::kOverrideHits && hit < Manual::kChannelHits);
    return screen == "parameters";
}

TEST_F(KeysAlone, ReachWhatAFingerCanTouch) {
    const PressedKey kKeys[] = {{Qt::Key_Left},
                                {Qt::Key_Right},
                                {Qt::Key_Up},
                                {Qt::Key_Down},
                                {Qt::Key_PageUp},
                                {Qt::Key_PageDown},
                                {Qt::Key_1, Qt::ControlModifier},
                                {Qt::Key_2, Qt::ControlModifier},
                                {Qt::Key_unknown, {}, "Factor"},
                                {Qt::Key_unknown, {}, "Filter"}};
    std::set<std::pair<std::string, int>> seen;
    walk([&](const std::string& where) {
        const QString screen = window->screen()->name();
        std::vector<std::pair<Sheet*, int>> all;
        for (Sheet* sheet : shown()) {
            // arrows, what is typed
            if (dynamic_cast<Table*>(sheet) || dynamic_cast<NumberPad*>(sheet) ||
                dynamic_cast<TextPad*>(sheet) || dynamic_cast<Magazine*>(sheet))
                continue;
            for (int n = 0; n < 3000; ++n)
                if (!sheet->boxOf(n).isEmpty() && !acts(screen, n) &&
                    std::none_of(sheet->fields().begin(), sheet->fields().end(),
                                 [&](const TextField& one) { return one.hit == n; }))
                    all.emplace_back(sheet, n);
        }
        const auto touch = [&](const std::pair<Sheet*, int>& one) {
            QTest::mouseClick(one.first, Qt::LeftButton, {},
                              one.first->boxOf(one.second).center().toPoint());
            QTest::qWait(5);
        };
        for (const auto& one : all) {
            if (!seen.insert({screen.toStdString(), one.second}).second) continue;
            touch(one);
            const std::string there = look(one.first);
            bool away = false, back = false;
            for (const auto& other : all) {
                if (back || other == one) continue;
                touch(other);
                if (look(one.first) == there) continue;
                away = true;
                for (const PressedKey& key : kKeys) {
                    for (int i = 0; i < 8 && !back; ++i) {
                        press(key);
                        QTest::qWait(2);
                        back = look(one.first) == there;
                    }
                    if (back) break;
                    touch(other);
                }
            }
            EXPECT_TRUE(away) << where << ": a touch on " << one.second << " changes nothing";
            EXPECT_TRUE(back || !away)
                << where << ": no key does what a touch on " << one.second << " does";
        }
    });
    EXPECT_GE(seen.size(), 20u);
}

// A key beyond the tenth would not be seen.
TEST_F(KeysAlone, HaveRoomForEverySoftKey) {
    walk([&](const std::string& where) {
        EXPECT_LE(window->screen()->keys().size(), static_cast<std::size_t>(SoftKeyBar::kKeys))
            << where;
    });
}

// 50/2 and +0.05 wherever a number is entered, on each page that has a pad.
TEST_F(KeysAlone, CalculateInEveryNumberField) {
    int pads = 0;
    walk([&](const std::string& where) {
        for (Sheet* sheet : shown()) {
            auto* pad = dynamic_cast<NumberPad*>(sheet);
            if (!pad || !pad->field || !pad->field()) continue;
            ++pads;
            for (const auto& [typed, value, added] : {std::tuple{"50/2", 25.0, false},
                                                      {"+0.05", 0.05, true},
                                                      {"-2*(3+1)", -8.0, false}}) {
                QTest::keyClicks(window.get(), typed);
                const auto entry = pad->entry();
                EXPECT_TRUE(entry && entry->value == value && entry->added == added)
                    << where << ": " << typed << " is " << pad->text().toStdString();
                pad->clear();
            }
        }
    });
    EXPECT_GE(pads, 5);
}

}  // namespace
}  // namespace polyturn::hmi
