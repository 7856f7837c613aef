// Machines with more channels than a panel has room for at first sight: every screen still fits, in every language, and each channel is reached.
#include <QFile>
#include <QRegularExpression>

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
    ASSERT_TRUE(waitFor([&] { return window.desk().live.connected() && window.desk().live.channels().size() == static_cast<std::size_t>(GetParam()); }, 60));
    QTest::qWait(300);
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
INSTANTIATE_TEST_SUITE_P(Panel, ManyChannels, ::testing::Values(3, 8, 16));

}  // namespace
}  // namespace polyturn::hmi
