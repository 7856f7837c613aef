// All channels side by side: what each does, where its axes are, what runs, what it waits for, what a start still needs, its parts.
#pragma once
#include "hmi/app/screen.hpp"
#include "hmi/machine/program_text.hpp"

namespace polyturn::hmi {

class Overview : public Screen {
public:
    explicit Overview(Desk& desk);
    QString title() const override { return word("Overview"); }
    Sign sign() const override { return Sign::Overview; }
    const char* name() const override { return "overview"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override;
    bool key(QKeyEvent* event) override;
    HelpTopic help() const override;
    std::vector<Sheet*> sheets() override;

protected:
    void resizeEvent(QResizeEvent*) override;
    void hideEvent(QHideEvent*) override;

private:
    void layOut();
    void addControlKeys(std::vector<SoftKey>& keys, bool there);
    bool takesMachineLock() const;
    bool control_ = false;                 // keys of program control
    std::vector<FreeSheet*> cards_;
    FreeSheet* empty_;
    ProgramText programs_;
};

}  // namespace polyturn::hmi
