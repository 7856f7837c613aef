// Cycle forms and the contour calculator over the editor, by touch and keys, without a machine; and
// that every field has its place in the picture.
#include <QFile>

#include "hmi/screens/programs/contour_page.hpp"
#include "hmi/screens/programs/cycle_form_page.hpp"
#include "hmi/screens/programs/programs.hpp"
#include "tests/places.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

constexpr const char* kProgram =
    "O0007 (shaft)\n"
    "N10 G99 G97 S900 M3\n"
    "G0 X62. Z2.\n"
    "G71 U2. R0.5 (roughing)\n"
    "G71 P100 Q200 U0.4 W0.1 F0.25 M8\n"
    "N100 G0 X20.\n"
    "G1 Z-20. F0.1\n"
    "N200 X62.\n"
    "M30\n";

class Forms : public ::testing::Test {
protected:
    void SetUp() override {
        QFile file(path());
        ASSERT_TRUE(file.open(QIODevice::WriteOnly));
        file.write(kProgram);
        file.close();
        Choices choices;
        choices.instance = "hmi-test-nobody";
        choices.language = "en";
        choices.theme = "dark";
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        for (Screen* one : window->screens())
            if (auto* found = dynamic_cast<Programs*>(one)) programs = found;
        ASSERT_TRUE(programs);
        programs->restore("0|" + path());
        hand = std::make_unique<Operator>(*window);
        hand->screen("programs");
        hand->soft("Edit");
        ASSERT_EQ(editor().file(), path());
    }
    void TearDown() override {
        waitFor([this] { return !editor().checking(); });
    }
    QString path() const { return folder.filePath("O0007.nc"); }
    // Screens are made anew with each language: asked for each time.
    EditorPage& editor() const {
        for (Screen* one : window->screens())
            if (auto* found = dynamic_cast<Programs*>(one)) return found->editor();
        throw std::runtime_error("no such screen");
    }
    QString text() const { return editor().edit().toPlainText(); }
    void cursor(int line) const {
        editor().edit().setTextCursor(
            QTextCursor(editor().edit().document()->findBlockByNumber(line)));
    }

    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
    Programs* programs = nullptr;
    std::unique_ptr<Operator> hand;
};

// What is written into the program is in the program's unit, and named so, whatever the screens
// show: here G20 stands above.
TEST_F(Forms, CountInchesWhereTheProgramDoes) {
    const auto unitOf = [&](int row) { return editor().form().table().cell(row, 3).text; };
    cursor(4);
    hand->soft("Cycle form");
    EXPECT_EQ(unitOf(0), "mm");
    hand->soft("Back to the text");
    QString inches = text();
    editor().edit().setPlainText(inches.replace("N10 G99", "N10 G20 G99 (G21)")
                                     .replace("U2. R0.5", "U.08 R.02")
                                     .replace("U0.4 W0.1 F0.25", "U.016 W.004 F.01"));
    cursor(4);
    hand->soft("Cycle form");
    CycleFormPage& form = editor().form();
    ASSERT_TRUE(form.cycle());
    EXPECT_EQ(unitOf(0), "inch");
    EXPECT_EQ(form.table().cell(0, 2).text, "0.08");
    hand->touchCell(form.table(), 0, 2);
    hand->type("0.0625");
    hand->key(Qt::Key_Return);
    hand->soft("Write into the program");
    EXPECT_TRUE(text().contains("U.0625 R.02") || text().contains("U0.0625 R.02"))
        << text().toStdString();
    // What a new form proposes is no millimetre either.
    cursor(8);
    hand->soft("Cycle form");
    for (int row = 0; row < form.table().rows(); ++row)
        if (form.table().cell(row, 0).text == "G71") {
            form.choose(row);
            break;
        }
    ASSERT_TRUE(form.cycle());
    ASSERT_TRUE(form.cycle()->values[0].set);
    EXPECT_LT(form.cycle()->values[0].number, 0.2);
    hand->soft("Back to the text");
    cursor(8);
    hand->soft("Contour");
    const ContourPage& contour = editor().contour();
    bool inch = false, mm = false;
    for (const Item& item : const_cast<ContourPage&>(contour).data().items()) {
        inch |= item.text.contains("inch");
        mm |= item.text.contains(" mm");
    }
    EXPECT_TRUE(inch);
    EXPECT_FALSE(mm);
}

TEST_F(Forms, ACycleIsReadChangedAndWrittenBack) {
    cursor(4);
    hand->soft("Cycle form");
    CycleFormPage& form = editor().form();
    ASSERT_TRUE(form.cycle());
    EXPECT_EQ(form.cycle()->form->code, "G71");
    EXPECT_TRUE(form.hintText(2).isEmpty()) << form.hintText(2).toStdString();
    hand->touchCell(form.table(), 3, 2);
    hand->type("300");
    hand->key(Qt::Key_Return);
    EXPECT_TRUE(form.hintText(3).contains("N300")) << "no such block";
    hand->touchCell(form.table(), 3, 2);
    hand->type("200");
    hand->key(Qt::Key_Return);
    if (form.table().row() != 4) hand->touchCell(form.table(), 4, 2);  // U of the second block
    hand->type("0.6");
    hand->key(Qt::Key_Return);
    EXPECT_DOUBLE_EQ(form.cycle()->values[4].number, 0.6);
    EXPECT_EQ(form.table().row(), 5) << "the next field is chosen";
    hand->key(Qt::Key_Delete);  // no allowance along Z
    hand->soft("Write into the program");
    EXPECT_EQ(text(), QString(kProgram).replace("U0.4 W0.1 F0.25 M8", "U0.6 F0.25 M8"));
    hand->soft("Undo");
    EXPECT_EQ(text(), kProgram) << "one step back";
    noWordIsShortened(*window);
}

TEST_F(Forms, AFaultStandsAtItsFieldAndIsNotWritten) {
    cursor(3);
    hand->soft("Cycle form");
    CycleFormPage& form = editor().form();
    hand->touchCell(form.table(), 0, 2);
    hand->type("0");
    hand->key(Qt::Key_Return);
    EXPECT_FALSE(form.faultText(0).isEmpty());
    frames(*window, 60);
    for (const SoftKey& key : window->softKeys().keys())
        EXPECT_FALSE(key.text == "Write into the program" && key.enabled);
    hand->type("50/20");
    hand->key(Qt::Key_Return);
    EXPECT_TRUE(form.faultText(0).isEmpty());
    hand->soft("Write into the program");
    EXPECT_TRUE(text().contains("G71 U2.5 R0.5 (roughing)\n"));
}

TEST_F(Forms, ANewCycleComesFromTheList) {
    cursor(8);  // before M30
    hand->soft("Cycle form");
    CycleFormPage& form = editor().form();
    ASSERT_TRUE(form.choosing());
    for (int row = 0; row < 30 && form.choosing(); ++row) {
        form.table().choose(row);
        // chosen already: the second touch
        if (form.table().cell(row, 0).text == "G76") hand->touchCell(form.table(), row, 1);
    }
    ASSERT_FALSE(form.choosing());
    hand->soft("Write into the program");
    EXPECT_EQ(text(),
              QString(kProgram).replace(
                  "M30\n", "G76 P021060 Q50 R0.02\nG76 X17.55 Z-20. P1227 Q300 F2.\nM30\n"));
    EXPECT_TRUE(waitFor([&] { return !editor().checking(); }));
    EXPECT_TRUE(editor().faults().empty())
        << (editor().faults().empty() ? "" : editor().faults()[0].text.toStdString());
}

TEST_F(Forms, ACallInBracketsIsAFormToo) {
    const QString holes =
                      "G17 G95 S900 M3 F0.1\nMCALL CYCLE82(10, 0, 2, -20, , 0.5) ;why so\n"
                      "HOLES2(0, 0, 20, 0, 0, 6)\nMCALL\nM30\n",
                  place = folder.filePath("HOLES.MPF");
    QFile file(place);
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(holes.toUtf8());
    file.close();
    ASSERT_TRUE(editor().open(place, "sinumerik"));
    CycleFormPage& form = editor().form();
    const auto allFits = [&form, this] {
        frames(*window, 60);  // drawn with the next frame
        for (Sheet* one : form.sheets())
            for (const QString& text : one->shortened()) ADD_FAILURE() << text.toStdString();
    };
    cursor(1);
    hand->soft("Cycle form");
    ASSERT_TRUE(form.cycle());
    EXPECT_EQ(form.cycle()->form->code, "MCALL CYCLE82");
    EXPECT_EQ(form.code(), "CYCLE82") << "what help is about";
    allFits();
    hand->touchCell(form.table(), 3, 2);
    hand->type("-25");
    hand->key(Qt::Key_Return);
    hand->soft("Write into the program");
    EXPECT_EQ(text(), QString(holes).replace("-20", "-25"));
    cursor(2);
    hand->soft("Cycle form");
    ASSERT_TRUE(form.cycle());
    EXPECT_EQ(form.cycle()->form->picture, forms::Picture::HoleCircle);
    allFits();
    hand->soft("Another cycle");
    form.table().choose(form.table().rows() - 1);  // the calls stand at the end of the list
    allFits();
}

TEST_F(Forms, ADescribedContourOpensInAFreshPage) {
    ASSERT_TRUE(editor().open(QString(kSourceFolder) + "/examples/programs/O0050.nc", "fanuc"));
    const int at = static_cast<int>(text().left(text().indexOf("(CONTOUR DIA")).count('\n'));
    cursor(at + 1);
    hand->soft("Contour");
    const ContourPage& page = editor().contour();
    EXPECT_GT(page.description().contour.elements.size(), 2u);
    EXPECT_EQ(page.solved().states.size(), page.description().contour.elements.size());
    EXPECT_TRUE(page.solved().complete());
}

TEST_F(Forms, AContourIsEnteredChosenWrittenAndReadBack) {
    cursor(8);
    hand->soft("Contour");
    ContourPage& page = editor().contour();
    const auto datum = [&](const char* name, const char* value) {
        const int row = page.rowOf(name);
        ASSERT_GE(row, 0) << name;
        page.data().choose(row);
        hand->type(value);
        hand->key(Qt::Key_Return);
    };
    datum("X", "20");  // the start: a diameter
    datum("G", "1");
    hand->soft("Add a line");
    datum("A", "180");
    EXPECT_EQ(page.solved().states[0], contour::State::Open);
    hand->soft("Add an arc G2");
    datum("R", "8");
    datum("Z", "-30");
    datum("X", "32");
    datum("T", "1");
    ASSERT_TRUE(page.solved().complete());
    ASSERT_EQ(page.solved().choices.size(), 1u);
    const auto before = page.solved().pieces.back().centre;
    const auto place = page.picture().placeOf(0, 1);
    ASSERT_TRUE(place);
    QTest::mouseClick(&page.picture(), Qt::LeftButton, {}, place->toPoint());
    EXPECT_GT(std::abs(page.solved().pieces.back().centre.z - before.z), 1.0)
        << "the other solution";
    hand->soft("Write into the program");
    const QString written = text();
    EXPECT_TRUE(written.startsWith(QString(kProgram).left(QString(kProgram).indexOf("M30"))));
    EXPECT_TRUE(written.endsWith("(CONTOUR END)\nM30\n")) << written.toStdString();
    EXPECT_TRUE(written.contains(
        "(CONTOUR DIA Z0 X20 G1)\n(LINE A180)\n(CW T Z-30 X32 R8 SOL1)\n(BLOCKS)\nG1 X20. Z0.\n"))
        << written.toStdString();
    EXPECT_TRUE(written.contains("G2 X32. Z-30. R8.\n")) << written.toStdString();
    EXPECT_TRUE(waitFor([&] { return !editor().checking(); }));
    EXPECT_TRUE(editor().faults().empty())
        << (editor().faults().empty() ? "" : editor().faults()[0].text.toStdString());
    // Read back from one of its blocks, and taken further.
    cursor(static_cast<int>(written.left(written.indexOf("G2 X32")).count('\n')));
    hand->soft("Contour");
    ASSERT_EQ(page.description().contour.elements.size(), 2u);
    EXPECT_EQ(page.description().contour.elements[1].solution, 1);
    page.elements().choose(2);
    hand->soft("Add a line");
    datum("dZ", "-5");
    datum("dX", "0");
    hand->soft("Write into the program");
    EXPECT_TRUE(text().contains("G2 X32. Z-30. R8.\nG1 Z-35.\n(CONTOUR END)\nM30\n"))
        << text().toStdString();
    EXPECT_EQ(text().count("CONTOUR END"), 1);
    noWordIsShortened(*window);
}

// The bright plate of the chosen field covers no letter of another one.
TEST(CyclePictures, NoLetterIsCovered) {
    for (const QSize size : {QSize(352, 312), QSize(440, 390)})
        for (const auto table :
             {forms::fanuc_forms(), forms::fagor_forms(), forms::sinumerik_forms()})
            for (const forms::Form& form : table) {
                CyclePicture picture(nullptr);
                picture.resize(size);
                picture.show(&form);
                for (int field = -1; field < static_cast<int>(form.fields.size()); ++field) {
                    picture.point(field, "-12.34");
                    picture.grab();
                    const auto& plates = picture.plates();
                    for (std::size_t i = 0; i < plates.size(); ++i)
                        for (std::size_t j = 0; j < i; ++j)
                            EXPECT_FALSE(plates[i].intersects(plates[j]))
                                << std::string(form.code) << " field " << field << ": " << j
                                << " and " << i;
                }
            }
}

TEST(CyclePictures, HaveAPlaceForEveryField) {
    for (const auto table : {forms::fanuc_forms(), forms::fagor_forms(), forms::sinumerik_forms()})
        for (const forms::Form& form : table) {
            const Scene scene = sceneOf(form.picture);
            EXPECT_FALSE(scene.part.isEmpty() || scene.paths.empty()) << form.code;
            for (const forms::Field& field : form.fields) {
                const bool found =
                    field.mark == forms::Mark::None ||
                    std::any_of(scene.dims.begin(), scene.dims.end(),
                                [&](const SceneDim& dim) { return dim.mark == field.mark; });
                EXPECT_TRUE(found) << form.title << ": " << field.address << ' ' << field.meaning;
            }
            for (const SceneDim& dim : scene.dims)
                for (const QPointF p : {dim.from, dim.to})
                    EXPECT_TRUE(p.x() >= 0 && p.x() <= kSceneWidth && p.y() >= 0 &&
                                p.y() <= kSceneHeight)
                        << form.title;
        }
}

}  // namespace
}  // namespace polyturn::hmi
