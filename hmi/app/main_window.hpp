// The frame around the screens: what the machine is like (top), the screens (left), their soft keys
// (foot), a line for the operator.
//
//   F1..F10       soft keys              F11             language
//   Alt+1..9, 0   screens                F12             theme
//   Ctrl+1..9     channels               Ctrl+L          lock for cleaning
//   Ctrl+F        next field of text     Help or Ctrl+H  the manual
#pragma once
#include <QElapsedTimer>
#include <QSettings>
#include <QStackedWidget>
#include <QTimer>
#include <map>
#include <memory>

#include "hmi/app/cleaning_lock.hpp"
#include "hmi/app/dialogue_view.hpp"
#include "hmi/app/help_view.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/widgets/soft_keys.hpp"
#include "hmi/widgets/text_entry.hpp"
#include "ipc/model/files/builder_messages.hpp"

namespace polyturn::hmi {

struct Choices {
    std::string instance = "polyturn";
    std::string language;  // empty: as kept, or the machine's
    std::string theme;     // dark, light; empty: as kept
    QString keptIn;        // file of what is kept over a restart; empty: nothing is
    // the same, of what means nothing once the computer has been off; empty: beside the other
    QString passingIn;
};

class MainWindow : public QWidget {
public:
    explicit MainWindow(Choices choices);
    ~MainWindow() override;

    void frame();  // one look at the machine; the timer calls it
    std::uint64_t frames() const { return frames_; }
    void showScreen(int number);
    void setDisplayLanguage(DisplayLanguage display_language);
    void setDark(bool dark);
    const std::vector<Screen*>& screens() const { return screens_; }
    int shown() const { return shown_; }
    Screen* screen() const { return screens_[static_cast<std::size_t>(shown_)]; }
    Context& context() { return context_; }
    SoftKeyBar& softKeys() { return *bar_; }
    std::vector<Sheet*> ownSheets() const { return {top_, rail_, line_, bar_}; }
    bool locked() const { return locked_; }
    void lock(bool on);  // for cleaning
    CleaningLock& cleaning() { return *cover_; }
    HelpView& help() { return *help_; }
    DialogueView& dialogue() { return *dialogue_; }
    // a dialogue that has come up by itself takes no keys yet: they were meant for what was there
    static constexpr int kComesUpMs = 500;
    void showKeys();  // of the dialogue, or of the screen
    TextEntry& entry() { return *entry_; }
    void showHelp();  // or hides it
    // What lies over the screens, for pictures, costs and words of all of it; Screen hides them
    // all. False: there is no such thing now.
    enum class Over : std::uint8_t { Screen, Help, Lock, Letters, Dialogue };
    static constexpr std::pair<Over, const char*> kOvers[] = {{Over::Help, "help"},
                                                              {Over::Lock, "lock"},
                                                              {Over::Letters, "letters"},
                                                              {Over::Dialogue, "dialogue"}};
    bool showOver(Over over);
    std::vector<Sheet*> overSheets() const;

protected:
    void resizeEvent(QResizeEvent*) override;
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void build();  // screens, in the language of now
    void layOut();
    void paintBehind();
    void composeTop(Writer& w);
    void composeRail(Writer& w);
    void composeLine(Writer& w);
    void topTouched(int number);
    void tell(const QString& text, Told how);
    std::map<QString, QString> keepsake() const;  // what a restart shows again
    void keep();                                  // aside, when it is another one than before
    void nextField();
    bool typed() const;  // something is being typed, wherever
    void followDialogue();
    bool keyPressed(QKeyEvent* event);
    bool keyReleased(QKeyEvent* event);
    void nextChannel(int step);
    void readBuilderMessages();
    void sayWhyEmpty() const;  // what every table says that has nothing to show

    Choices choices_;
    std::unique_ptr<QSettings> kept_;  // as it was found
    std::map<QString, QString> keptLast_;
    Aside<bool> keeping_;
    Aside<text::BuilderMessages> builders_;  // the machine builder's, as they are being read
    qint64 keepAt_ = 0;
    Live live_;
    Requests requests_;
    AlarmLog alarms_;
    Context context_;
    QTimer timer_;
    FreeSheet *top_, *rail_, *line_;
    CleaningLock* cover_;
    SoftKeyBar* bar_;
    HelpView* help_;
    DialogueView* dialogue_;
    TextEntry* entry_;
    QElapsedTimer cameUp_;   // the dialogue, by itself
    std::size_t field_ = 0;  // that Ctrl+F went to last
    QStackedWidget* stack_;
    std::vector<Screen*> screens_;
    int shown_ = 0;
    bool dark_ = true, locked_ = false, ready_ = false;
    std::uint64_t generation_ = 0, frames_ = 0;
    QString told_;
    Told how_ = Told::Note;
    qint64 toldUntil_ = 0;
    QElapsedTimer unlocked_;           // by an alarm: the cloth may still be on the panel
    const QEvent* passing_ = nullptr;  // a key that a page may be handing on
};

std::vector<Screen*> makeScreens(Context& context);  // in the order of Alt+1, Alt+2 ...

}  // namespace polyturn::hmi
