// What the shop needs rarely: backups (save, see what a restore would change, restore), users with
// their levels, the computer's settings.
#pragma once
#include <QFileInfo>
#include <QJsonArray>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/programs/file_work.hpp"
#include "hmi/screens/machine/settings_page.hpp"
#include "hmi/widgets/table.hpp"
#include "hmi/widgets/text_pad.hpp"

namespace polyturn::hmi {

class System : public Screen {
public:
    explicit System(Context& context);
    QString title() const override { return word("System"); }
    Sign sign() const override { return Sign::Key; }
    const char* name() const override { return "system"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override {
        lookAt_ = 0;
        preview_ = {};
        previewOf_.clear();
    }
    bool key(QKeyEvent* event) override;
    bool typing() const override { return page_ == Page::Users; }
    QString state() const override {
        return QString("%1|%2").arg(static_cast<int>(page_)).arg(folder_);
    }
    void restore(const QString& state) override;
    std::vector<Sheet*> sheets() override;
    int pages() const override { return 3; }
    HelpTopic help() const override {
        return {"setup.md",
                page_ == Page::Settings ? QString("9. Panel computer")
                : page_ == Page::Users  ? QString("8. Users")
                                        : QString("7. Backup and restore"),
                {}};
    }
    void turnTo(int page) override { showPage(static_cast<Page>(page)); }

    enum class Page : std::uint8_t { Backups, Users, Settings };
    void showPage(Page page);
    void readFolder(const QString& folder);
    Table& files() { return *files_; }
    Table& right() { return *right_; }
    FreeSheet& form() { return *form_; }
    FreeSheet& notice() { return *notice_; }
    TextPad& pad() { return *pad_; }
    SettingsPage& settings() { return *settings_; }
    const QString& note() const { return note_; }

protected:
    void resizeEvent(QResizeEvent*) override;
    void showEvent(QShowEvent*) override;

private:
    // A store that has lost data, as it says itself.
    struct Loss {
        bool unfit = false, readable = true;
        QString missing, backup;
    };
    struct User {
        QString name, level;
        bool locked = false;
    };
    void layOut();
    void fill();
    void composeHead(Writer& w);
    void composeForm(Writer& w);
    void open();
    void look();
    void lookAtStore();
    void confirmLoss();
    void composeNotice(Writer& w);
    void save();
    void bringBack(bool preview);
    void logIn();
    void type(const QString& text);
    void backspace();
    QString chosenFile() const;
    QString levelWord(const QString& level) const;

    Page page_ = Page::Backups;
    FreeSheet *head_, *form_, *notice_;
    Table *files_, *right_;
    TextPad* pad_;
    SettingsPage* settings_;
    QString folder_, previewOf_, note_;
    bool noteGood_ = false;
    void takeFolder();
    std::vector<QFileInfo> entries_;
    Aside<std::vector<QFileInfo>> reading_;
    QString wanted_;  // to be chosen when the folder has been read
    QJsonArray preview_;
    Loss loss_;
    std::vector<User> users_;
    bool usersHidden_ = false;  // from who has not logged in
    void sayWhyNoUsers();
    QString who_, whoLevel_, name_, password_;
    bool inPassword_ = false;
    int newLevel_ = 0;  // of the next new user
    qint64 lookAt_ = 0;
};

}  // namespace polyturn::hmi
