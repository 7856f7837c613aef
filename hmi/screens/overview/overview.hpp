// All channels side by side: what each does, where its axes are, what runs, what it waits for, what
// a start still needs, its parts.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/programs/program_text.hpp"

namespace polyturn::hmi {

class Overview : public Screen {
public:
    explicit Overview(Context& context);
    QString title() const override { return word("Overview"); }
    Sign sign() const override { return Sign::Overview; }
    const char* name() const override { return "overview"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override;
    bool key(QKeyEvent* event) override;
    HelpTopic help() const override;
    std::vector<Sheet*> sheets() override;
    QString state() const override;
    void restore(const QString& state) override;
    int pages() const override;
    void turnTo(int page) override;
    // Of many channels the chosen one has room for all its lines, the others are beside it.
    void enlarge(bool on);
    bool enlarged() const { return enlarged_; }

protected:
    void resizeEvent(QResizeEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void layOut();
    bool canEnlarge() const { return cards_.size() > kMostFull; }
    SoftKey endWithPartKey();
    void addControlKeys(std::vector<SoftKey>& keys, bool there);
    bool takesMachineLock() const;
    static constexpr std::size_t kMostFull = 3;  // channels whose cards leave nothing out
    // turned: narrow cards show the other columns of their axes
    bool enlarged_ = false, turned_ = false;
    unsigned laidFor_ = 0;  // the channel that is enlarged
    bool takesRetrace() const;
    enum class Keys : std::uint8_t { Channels, Control, MoreControl, All };
    void showKeys(Keys keys) {
        page_ = keys;
        if (context_.keysChanged)
            context_.keysChanged();
        else
            void();
    }
    // of the soft keys: of program control there are more than one page has room for
    Keys page_ = Keys::Channels;
    std::vector<FreeSheet*> cards_;
    FreeSheet* empty_;
    ProgramText programs_;
};

}  // namespace polyturn::hmi
