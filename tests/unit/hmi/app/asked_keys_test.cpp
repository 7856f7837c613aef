// What a key asks before it acts is the most important text on the screen while it asks: all of it
// is seen, in every language, on every panel.
#include <QRegularExpression>

#include "hmi/widgets/soft_keys.hpp"
#include "tests/unit/hmi/screen_checks.hpp"

namespace polyturn::hmi {
namespace {

// Every question of the sources, with its longest names.
QStringList questions(DisplayLanguage display_language) {
    QFile file(QString("%1/hmi/translations/polyturn_%2.ts")
                   .arg(QString(kSourceFolder), display_language == DisplayLanguage::English
                                                    ? QString("ru")
                                                    : QString(codeOf(display_language))));
    EXPECT_TRUE(file.open(QIODevice::ReadOnly));
    const QString all = QString::fromUtf8(file.readAll());
    static const QRegularExpression kBoth(
        "<source>([^<]*)</source>\\s*<translation>([^<]*)</translation>");
    QStringList out;
    for (auto found = kBoth.globalMatch(all); found.hasNext();) {
        const auto one = found.next();
        if (!one.captured(1).endsWith("press again")) continue;
        QString text =
            display_language == DisplayLanguage::English ? one.captured(1) : one.captured(2);
        out << text.replace("&apos;", "'")
                   .replace("&quot;", "\"")
                   .replace("&lt;", "<")
                   .replace("&gt;", ">")
                   .replace("&amp;", "&")
                   .replace("%1", "L16")
                   .replace("%2", "T12");
    }
    return out;
}

TEST(AskedKeys, AreSeenWholeInEveryLanguageOnEveryPanel) {
    for (const QSize size : {QSize(1280, 800), QSize(1920, 1080), QSize(1024, 768),
                             QSize(768, 1024), QSize(1080, 1920)}) {
        MainWindow window({"hmi-test-nobody", "en", "dark", {}, {}});
        window.resize(size);
        window.show();
        SoftKeyBar& bar = window.softKeys();
        for (const DisplayLanguage display_language : kDisplayLanguages) {
            window.setDisplayLanguage(display_language);
            const QStringList all = questions(display_language);
            ASSERT_GE(all.size(), 20);
            for (const QString& text : all)
                for (const char* object : {"", "ROUGH_80"}) {
                    bar.show({});
                    bar.show({SoftKey{
                        "key", [] {}, Sign::Run, true, true, true, text, {}, "subject", object}});
                    bar.press(0);
                    ASSERT_EQ(bar.asked(), 0);
                    EXPECT_TRUE(bar.shortened().empty())
                        << size.width() << "x" << size.height() << " " << codeOf(display_language)
                        << ": " << text.toStdString() << " " << object;
                    EXPECT_TRUE(bar.overlapping().empty())
                        << size.width() << "x" << size.height() << " " << codeOf(display_language)
                        << ": " << ::testing::PrintToString(bar.overlapping());
                }
        }
        window.setDisplayLanguage(DisplayLanguage::English);
    }
}

// That the checks of every page ask the keys too: a question that cannot fit is found.
TEST(AskedKeys, OfAPageAreAskedByTheCheckOfItsWords) {
    MainWindow window({"hmi-test-nobody", "en", "dark", {}, {}});
    window.resize(1280, 800);
    window.show();
    std::vector<QString> found;
    askEach(window.softKeys(),
            {SoftKey{"Reset", [] { FAIL() << "asking acts"; }, Sign::Reset, false, false, true,
                     QString("a question without end ").repeated(12)}},
            [&](const QString& text) { found.push_back(text); });
    EXPECT_EQ(found.size(), 1u);
    EXPECT_EQ(window.softKeys().asked(), -1);
}

}  // namespace
}  // namespace polyturn::hmi
