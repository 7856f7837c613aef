// A store that has lost data: the alarm leads to the backups, the page says what is gone, and a
// maker confirms it there, asked once more.
#include <QDir>
#include <QFile>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/screens/machine/alarms.hpp"
#include "hmi/screens/machine/system.hpp"
#include "tests/unit/hmi/tasks.hpp"

namespace polyturn::hmi {
namespace {

class StoreLoss : public ::testing::Test {
protected:
    QString file(const QString& name) const { return controller.folder.filePath("store/" + name); }
    // Something is acknowledged, and then an older file stands in the store's place: what was
    // acknowledged since is gone.
    void lose(bool users = false) {
        controller.stop();
        const QStringList parts{"store.sqlite", "store.sqlite-wal"};
        for (const QString& one : parts) {
            QFile::remove(file("old." + one));
            QFile::copy(file(one), file("old." + one));
        }
        controller.start();
        if (users) { ASSERT_TRUE(withPassword({"login", "boss"})); }
        ASSERT_TRUE(controller.set("offset L1 6 geometry X=9"));
        if (users) controller.run({"logout", "--instance", controller.name});
        controller.stop();
        for (const QString& one : parts) {
            QFile::remove(file(one));
            QFile::rename(file("old." + one), file(one));
        }
        controller.start();
    }
    bool withPassword(QStringList words) {
        QProcess one;
        one.start(QString(kProgramFolder) + "/polyturn", words << "--instance" << controller.name);
        one.write("topsecret\n");
        one.closeWriteChannel();
        return one.waitForFinished(20'000) && one.exitStatus() == QProcess::NormalExit &&
               one.exitCode() == 0;
    }
    void show() {
        Choices choices;
        choices.instance = controller.name.toStdString();
        choices.language = "en";
        choices.theme = "dark";
        window = std::make_unique<MainWindow>(choices);
        window->resize(1280, 800);
        window->show();
        ASSERT_TRUE(waitFor([&] {
            frames(*window, 20);
            return storeHasLost(window->context().live);
        }));
    }
    bool lost() { return storeHasLost(window->context().live); }
    System& system() {
        for (Screen* one : window->screens())
            if (auto* found = dynamic_cast<System*>(one)) return *found;
        throw std::runtime_error("no such screen");
    }
    const SoftKey* key(const QString& text) {
        frames(*window);
        for (const SoftKey& one : window->softKeys().keys())
            if (one.text == text) return &one;
        return nullptr;
    }
    Controller controller;
    std::unique_ptr<MainWindow> window;
};

TEST_F(StoreLoss, IsConfirmedByAMakerWhereBackupsAreRestored) {
    lose();
    show();
    Operator hand(*window);
    system().showPage(System::Page::Users);
    hand.screen("alarms");
    hand.soft("To the backups");
    ASSERT_EQ(QString(window->screen()->name()), "system");
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return system().notice().isVisible();
    })) << "it shows the backups, whatever it showed before";
    EXPECT_TRUE(standsOn({&system().notice()}, "The machine has lost data: no program starts"));
    EXPECT_TRUE(standsOn({&system().notice()}, "Lost: "));
    for (const DisplayLanguage display_language :
         {DisplayLanguage::Russian, DisplayLanguage::Czech, DisplayLanguage::Hungarian,
          DisplayLanguage::English}) {
        window->setDisplayLanguage(display_language);
        ASSERT_TRUE(waitFor([&] {
            frames(*window, 20);
            return system().notice().isVisible();
        }));
        frames(*window, 300);
        noWordIsShortened(*window);
    }
    hand.soft("Confirm the loss");
    frames(*window, 500);
    EXPECT_TRUE(lost()) << "one press confirms nothing";
    hand.soft("Confirm the loss");
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return !lost();
    }));
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return !system().notice().isVisible() && !key("Confirm the loss");
    })) << "there is nothing to confirm any more";
    EXPECT_TRUE(controller.set("offset L1 7 geometry X=1")) << "and the store keeps again";
}

TEST_F(StoreLoss, IsNoOneElsesToConfirm) {
    ASSERT_TRUE(withPassword({"users", "add", "boss", "maker"}));
    lose(true);
    show();
    Operator hand(*window);
    hand.screen("alarms");
    hand.soft("To the backups");
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return key("Confirm the loss") != nullptr;
    }));
    EXPECT_FALSE(key("Confirm the loss")->enabled);
    EXPECT_TRUE(standsOn({&system().notice()}, "Only a maker can confirm"));
    hand.soft("Users");
    hand.type("boss");
    hand.key(Qt::Key_Tab);
    hand.type("topsecret");
    hand.key(Qt::Key_Return);
    frames(*window, 500);
    hand.soft("Backups");
    ASSERT_TRUE(waitFor([&] {
        frames(*window, 20);
        return key("Confirm the loss") && key("Confirm the loss")->enabled;
    }));
    EXPECT_FALSE(standsOn({&system().notice()}, "Only a maker can confirm"));
    hand.soft("Confirm the loss");
    hand.soft("Confirm the loss");
    EXPECT_TRUE(waitFor([&] {
        frames(*window, 20);
        return !lost();
    }));
}

}  // namespace
}  // namespace polyturn::hmi
