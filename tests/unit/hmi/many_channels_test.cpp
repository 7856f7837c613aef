// Machines with more channels than a panel has room for at first sight: every screen still fits, in every language, and each channel is reached.
#include <QFile>
#include <QRegularExpression>

#include "hmi/screens/graphics.hpp"
#include "tests/unit/hmi/controller.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

// The demonstration machine with further channels, each with X and Z like those of its second one.
QByteArray machineWith(int channels) {
    QFile file(QString(POLYTURN_SOURCE_DIR) + "/examples/machines/twin-turret/machine.params");
    if (!file.open(QIODevice::ReadOnly)) return {};
    const QString text = QString::fromUtf8(file.readAll());
    QString out = text;
    const QRegularExpression row("^(\\w+) (A3|A4|L2)=([^;\\s]+)", QRegularExpression::MultilineOption);
    int axis = 7;
    for (int channel = 3; channel <= channels; ++channel, axis += 2) {
        out += QString("\nN0000 L%1=1\n").arg(channel);
        for (auto found = row.globalMatch(text); found.hasNext();) {
            const auto one = found.next();
            const QString name = one.captured(1), scope = one.captured(2);
            QString value = one.captured(3);
            if (scope == "L2") {
                if (name == "N0000" || name == "N0687" || name == "PT_TURRET_MAGAZINE") continue;
                out += QString("%1 L%2=%3\n").arg(name).arg(channel).arg(value);
                continue;
            }
            const int number = axis + (scope == "A4");
            if (name == "N0002") value = QString::number(channel);
            if (name == "N0501" || name == "N0503") value = QString::number(number);
            out += QString("%1 A%2=%3\n").arg(name).arg(number).arg(value);
        }
    }
    return out.toUtf8();
}

class ManyChannels : public ::testing::TestWithParam<int> {};

TEST_P(ManyChannels, FitOnAPanel) {
    QTemporaryDir folder;
    QFile file(folder.filePath("many.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(GetParam()));
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en", choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(waitFor([&] { return window.desk().live.connected() && window.desk().live.channels().size() == static_cast<std::size_t>(GetParam()); }));
    frames(window, 300);
    noWordIsShortened(window);
    for (const unsigned channel : window.desk().live.channels()) {   // each is touched in the overview
        window.showScreen(0);
        const auto sheets = window.screen()->sheets();
        ASSERT_EQ(sheets.size(), static_cast<std::size_t>(GetParam()));
        Sheet* card = sheets[channel - 1];
        QTest::mouseClick(card, Qt::LeftButton, {}, card->rect().center());
        EXPECT_EQ(window.desk().channel, channel);
    }
}

// Of many channels a card leaves lines out: a second touch, or Enter, gives the chosen one the room for all of them; the others stay beside it.
TEST(ManyChannelsCard, IsEnlargedByATouchAndByAKey) {
    QTemporaryDir folder;
    QFile file(folder.filePath("many.params"));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(machineWith(8));
    file.close();
    Controller controller(file.fileName());
    Choices choices;
    choices.instance = controller.name.toStdString();
    choices.language = "en", choices.theme = "dark";
    MainWindow window(choices);
    window.resize(1280, 800);
    window.show();
    ASSERT_TRUE(waitFor([&] { return window.desk().live.connected() && window.desk().live.channels().size() == 8; }));
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
    for (Screen* one : window.screens())   // all the turrets that were copied stand at one place: their names do not lie upon each other
        if (auto* graphics = dynamic_cast<Graphics*>(one)) {
            window.showScreen(6);
            graphics->turnTo(1);   // the whole machine
            ASSERT_TRUE(waitFor([&] { return graphics->labels().size() >= 8; }));
            const auto labels = graphics->labels();
            for (std::size_t i = 0; i < labels.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(labels[i].intersects(labels[j])) << i << " " << j;
            graphics->turnTo(0);
            window.showScreen(0);
        }
    touch(6);
    EXPECT_EQ(window.desk().channel, 6u);
    EXPECT_TRUE(says(6, "Parts") && says(6, "Mean")) << "figures without a heading";
    EXPECT_TRUE(says(6, "Lag")) << "the following error, under a word that fits";
    EXPECT_FALSE(says(6, "Follow. error"));
    touch(6);
    for (const char* line : {"Follow. error", "Remaining", "Workpiece", "Machine", "To go"}) EXPECT_TRUE(says(6, line)) << line;
    for (unsigned channel = 1; channel <= 8; ++channel)
        EXPECT_TRUE(window.rect().contains(window.screen()->sheets()[channel - 1]->geometry())) << channel;
    hand.key(Qt::Key_Left);                                       // the one before
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
        if (QString(window.screens()[i]->name()) == "manual") window.showScreen(static_cast<int>(i));
    int signs = 0;
    for (const Item& item : window.screen()->sheets()[0]->items()) signs += item.kind == Item::Kind::Sign && item.box.bottom() <= 42;
    EXPECT_GE(signs, 8);
}
INSTANTIATE_TEST_SUITE_P(Panel, ManyChannels, ::testing::Values(3, 8, 16));

}  // namespace
}  // namespace polyturn::hmi
