// Every field of text is reached and edited by touch alone, and by keys alone: all screens, all
// pages are walked. A field is what Writer::field draws; that none is drawn in another way is seen
// in the sources.
#include <QDirIterator>
#include <QFile>
#include <QTemporaryDir>

#include "hmi/screens/machine/diagnosis.hpp"
#include "hmi/screens/machine/parameters.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "hmi/screens/tools/tools.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class Entry : public Tasks {
protected:
    // The fields of what is on the screen now, with the text in each; that of the overlay is no
    // field of a screen.
    std::vector<std::pair<Sheet*, TextField>> fields() const {
        std::vector<std::pair<Sheet*, TextField>> out;
        window->screen()->refresh();
        for (Sheet* sheet : window->screen()->sheets()) {
            if (!sheet->isVisibleTo(window.get())) continue;
            sheet->refresh();
            for (const TextField& one : sheet->fields()) out.emplace_back(sheet, one);
        }
        return out;
    }
    TextPad* pad() const {
        if (window->entry().isVisible()) return &window->entry().pad();
        for (Sheet* sheet : window->screen()->sheets())
            if (auto* found = dynamic_cast<TextPad*>(sheet); found && found->isVisible())
                return found;
        return nullptr;
    }
    // What the letter has changed: the overlay's text or the field's own.
    QString text(std::size_t field) const {
        return window->entry().isVisible() ? window->entry().text()
               : field < fields().size()   ? fields()[field].second.text
                                           : QString();
    }
    void leave() {
        window->entry().shut(false);
        if (dynamic_cast<Programs*>(window->screen())) return;
        QTest::keyClick(window.get(), Qt::Key_Backspace);
    }
    int walked = 0;
    void walk(const std::string& where) {
        const std::size_t count = fields().size();
        for (std::size_t i = 0; i < count; ++i) {
            SCOPED_TRACE(where + ", field " + std::to_string(i + 1) + " of " +
                         std::to_string(count));
            ++walked;
            // by touch alone
            auto [sheet, field] = fields()[i];
            QTest::mouseClick(sheet, Qt::LeftButton, {}, field.box.center().toPoint());
            ASSERT_NE(pad(), nullptr) << "touched, and no letters for a finger come";
            QString before = text(i);
            const QRectF key = pad()->boxOf(pad()->hitOf('w'));
            ASSERT_FALSE(key.isEmpty());
            EXPECT_GE(key.height(), px(40)) << "a finger is wider";
            QTest::mouseClick(pad(), Qt::LeftButton, {}, key.center().toPoint());
            EXPECT_EQ(text(i).size(), before.size() + 1) << "the letter has not come";
            leave();
            // by keys alone
            bool reached = false;
            for (std::size_t step = 0; step < count && !reached; ++step) {
                QTest::keyClick(window.get(), Qt::Key_F, Qt::ControlModifier);
                before = text(i);
                QTest::keyClick(window.get(), Qt::Key_W);
                reached = text(i).size() == before.size() + 1;
                leave();
            }
            EXPECT_TRUE(reached) << "no way to it by keys";
        }
    }
};

TEST_F(Entry, EveryFieldIsEditedByTouchAloneAndByKeysAlone) {
    g_controller->run({"params", "set", "N3300=3", "--instance", g_controller->name});
    for (std::size_t i = 0; i < window->screens().size(); ++i) {
        window->showScreen(static_cast<int>(i));
        const bool starts = QString(window->screen()->name()) == "programs";
        for (int page = 0; page < (starts ? 1 : window->screen()->pages()); ++page) {
            if (!starts) window->screen()->turnTo(page);
            frames(*window, 120);
            walk(std::string(window->screen()->name()) + " " + std::to_string(page + 1));
        }
    }
    EXPECT_GE(walked, 6) << "search of parameters, signals, variables, tools; MDI; user, password";
    // What only appears when it is asked for.
    auto& diagnosis = screenOf<Diagnosis>();
    Operator hand(*window);
    hand.screen("diagnosis");
    diagnosis.turnTo(static_cast<int>(Diagnosis::Page::Scope));
    hand.soft("Choose signal");
    walk("scope");
    hand.screen("programs");
    hand.soft("Copy, delete ...");
    hand.soft("New folder");
    walk("name of a folder");
}

// A text among the parameters: its field, the overlay, Enter, and it is on disk.
TEST_F(Entry, ATextOfAParameterIsChangedByTouch) {
    Operator hand(*window);
    hand.screen("parameters");
    auto& parameters = screenOf<Parameters>();
    parameters.find("PT_PROGRAM_FOLDERS");
    ASSERT_TRUE(waitFor([&] { return parameters.table().rows() >= 1; }));
    parameters.refresh();
    ASSERT_EQ(parameters.detail().fields().size(), 1u);
    hand.touch(&parameters.detail(), parameters.detail().fields()[0].hit);
    for (const char letter : {'s', 'u', 'b'})
        hand.touch(&window->entry().pad(), window->entry().pad().hitOf(letter));
    hand.key(Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] {
        return params::get_text(live().table(), params::pt_program_folders, 1) == "sub";
    })) << params::get_text(live().table(), params::pt_program_folders, 1);
}

// Each bit is touched, on an upright panel too.
TEST_F(Entry, BitsAreAsHighAsAFinger) {
    window->resize(768, 1024);
    Operator hand(*window);
    hand.screen("parameters");
    for (const DisplayLanguage display_language :
         {DisplayLanguage::Russian, DisplayLanguage::English}) {
        window->setDisplayLanguage(display_language);
        auto& now = screenOf<Parameters>();
        now.find("N0106");
        frames(*window);
        for (int bit = 0; bit < 8; ++bit)
            EXPECT_GE(now.detail().boxOf(1 + bit).height(), px(34)) << bit;
    }
    window->resize(1280, 800);
}

// MSG("..."), $AA_IM, >= are written by touch too: shift gives the keys of digits and signs another
// one, which stands on them.
TEST_F(Entry, SignsOfProgramsAreTypedByTouch) {
    for (const bool capitals : {false, true}) {
        QString typed;
        TextQuestion question{"x", {}, [&](const QString& text) { typed = text; }, {}};
        question.capitals = capitals;
        window->context().ask(question);
        TextPad& pad = window->entry().pad();
        Operator hand(*window);
        for (const char key : {'2', '4', '5', '<', '1', '7', '8', '/', '3'}) {
            hand.touch(&pad, TextPad::kShift);
            hand.touch(&pad, pad.hitOf(key));
        }
        hand.touch(&pad, pad.hitOf('2'));
        for (const char* sign : {"\"", "$", "%", ">", "!", "&", "'", "?", "@"})
            EXPECT_TRUE(standsOn({&pad}, sign)) << sign;
        EXPECT_TRUE(pad.overlapping().empty());
        hand.key(Qt::Key_Return);
        EXPECT_EQ(typed, QString("\"$%>!&'?@2"));
    }
}

// Words are searched for in the language of the screens; blocks and names of programs have Latin
// letters.
TEST_F(Entry, LettersOfTheLanguageAndACaretThatMoves) {
    window->setDisplayLanguage(DisplayLanguage::Russian);
    QString typed;
    Operator hand(*window);
    window->context().ask({"x", {}, [&](const QString& text) { typed = text; }, {}});
    TextPad& pad = window->entry().pad();
    for (const QChar key : QString::fromUtf8("ось")) hand.touch(&pad, pad.hitOf(key));
    hand.touch(&pad, TextPad::kLetters);
    EXPECT_LT(pad.hitOf(QChar(u'ж')), 0);
    hand.touch(&pad, pad.hitOf('x'));
    hand.touch(&pad, TextPad::kLeft);
    hand.touch(&pad, TextPad::kLeft);
    hand.touch(&pad, pad.hitOf('1'));
    EXPECT_EQ(typed, QString::fromUtf8("ос1ьx"));
    hand.key(Qt::Key_Right);
    hand.key(Qt::Key_Backspace);
    EXPECT_EQ(typed, QString::fromUtf8("ос1x"));
    EXPECT_TRUE(pad.overlapping().empty());
    hand.key(Qt::Key_Escape);
    TextQuestion block{"x", {}, [&](const QString& text) { typed = text; }, {}};
    block.capitals = true;
    window->context().ask(block);
    EXPECT_TRUE(pad.boxOf(TextPad::kLetters).isEmpty());
    hand.touch(&pad, pad.hitOf('g'));
    EXPECT_EQ(typed, "G");
    hand.key(Qt::Key_Escape);
    for (const auto& [display_language, letters] :
         {std::pair{DisplayLanguage::Czech, "ěščřžýáíéúůďťňó"},
          {DisplayLanguage::Hungarian, "áéíóöőúüű"}}) {
        window->setDisplayLanguage(display_language);
        window->context().ask({"x", {}, {}, {}});
        for (const QChar one : QString::fromUtf8(letters))
            EXPECT_GE(window->entry().pad().hitOf(one), 0) << QString(one).toStdString();
        window->entry().shut(false);
    }
    window->setDisplayLanguage(DisplayLanguage::English);
}

TEST(EntrySources, NoFieldIsDrawnByHand) {
    for (QDirIterator files(QString(kSourceFolder) + "/hmi", {"*.cpp"}, QDir::Files,
                            QDirIterator::Subdirectories);
         files.hasNext();) {
        QFile file(files.next());
        ASSERT_TRUE(file.open(QIODevice::ReadOnly));
        // the last: a cell of the table, with letters beneath it
        const bool widget = file.fileName().endsWith("/sheet.cpp") ||
                            file.fileName().endsWith("/number_pad.cpp") ||
                            file.fileName().endsWith("/tools_tables.cpp");
        EXPECT_EQ(file.readAll().contains("\u258f"), widget)
            << file.fileName().toStdString() << ": a cursor; use Writer::field";
    }
}

}  // namespace
}  // namespace polyturn::hmi
