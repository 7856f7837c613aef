// One screen of the HMI, and what all screens share. A screen shows (refresh), offers soft keys
// (keys), takes keys of its own.
#pragma once
#include <QKeyEvent>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

#include "hmi/machine/bodies/kept_pieces.hpp"
#include "hmi/machine/live/alarm_log.hpp"
#include "hmi/machine/live/live.hpp"
#include "hmi/machine/live/requests.hpp"
#include "hmi/machine/programs/draft.hpp"
#include "hmi/text/display_languages.hpp"
#include "hmi/widgets/sheet.hpp"
#include "hmi/widgets/text_entry.hpp"

namespace polyturn::hmi {

struct SoftKey {
    QString text;  // empty: no key here
    std::function<void()> act;
    Sign sign = Sign::None;
    bool enabled = true;
    bool on = false;  // a switch that is on
    bool danger = false;
    QString confirm = {};  // not empty: the first press shows this, the second one acts
    std::function<void()> release = {};  // acts while it is held: this ends it
    // what a key with a question acts on, whole: with another one the first press asked something
    // else
    QString subject = {};
    // of it, what the question shows; of a key without one, what is next to its sign
    QString object = {};
};

// What the help key opens: a page of the manual, the words there, and what can be told of the field
// itself (markdown).
struct HelpTopic {
    QString page, find, intro;
    bool code = false;  // find a word of a program: whole, and as it is written
};

// Context::show(): their places in screen_list.cpp
inline constexpr int kProgramsScreen = 2, kOffsetsScreen = 3;

enum class Told : std::uint8_t { Note, Good, Warning, Refused };

// What every screen may use.
struct Context {
    Live& live;
    Requests& requests;
    AlarmLog& alarms;
    unsigned channel = 1;                                 // the one that keys speak to
    std::function<void(const QString&, Told)> tell = {};  // a line for the operator
    std::function<void()> keysChanged = {};
    std::function<void(int)> show = {};          // another screen, by its number
    std::function<void(TextQuestion)> ask = {};  // a text, by touch or keyboard
    QString folder = {};                         // of the programs shown last
    // what an editor that is gone has left
    Draft draft = {};
    QString draftFile = {};  // where it is kept; empty: nowhere
    // whose line the screen of offsets goes to when it is shown next; 0: none
    std::int32_t toolOfOffsets = 0, edgeOfOffsets = 0;
    // what the editor opens when the screen of programs is shown next; no file: nothing
    struct ProgramPlace {
        QString file;
        int line = 0;
    };
    ProgramPlace placeToEdit = {};
    KeptPieces kept = {};  // of what screens show
    // the channel, if there is such a one
    void choose(unsigned wanted);
};

// One request for all channels of a machine group (0: of the machine); who has nothing to begin is
// named, and left alone.
void startGroup(Context& context, unsigned group);

class Screen : public QWidget {
public:
    explicit Screen(Context& context) : context_(context) {}
    virtual QString title() const = 0;
    virtual Sign sign() const = 0;
    virtual const char* name() const = 0;  // in what is kept over a restart
    virtual std::vector<SoftKey> keys() = 0;
    virtual void refresh() = 0;  // each frame while it is shown
    virtual void follow() {}     // each frame, shown or not
    virtual void rebuilt() {}    // another machine, or none
    virtual bool key(QKeyEvent*) { return false; }
    // of keys that act as long as they are held
    virtual bool keyReleased(QKeyEvent*) { return false; }
    // of everything that is held: the panel is locked
    virtual void letGo() {}
    // digits and letters belong to a field now
    virtual bool typing() const { return false; }
    virtual QString state() const { return {}; }  // where in the screen, to be kept
    virtual void restore(const QString&) {}
    // it will be made anew: what state() does not hold goes to the context
    virtual void leave() {}
    virtual int pages() const { return 1; }  // for pictures of all of it
    virtual void turnTo(int /*page*/) {}
    virtual HelpTopic help() const { return {"operator.md", title(), {}}; }  // of what is chosen
    virtual bool busy() const { return false; }  // what it shows is still being made
    // for the test that looks for shortened words
    virtual std::vector<Sheet*> sheets() { return {}; }

protected:
    Context& context_;
};

}  // namespace polyturn::hmi
