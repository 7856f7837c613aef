// The rest of manual operation: the handwheel on the screen, a tool called from its station, the
// spindle, and a part passed to the counter spindle step by step with the functions of the built-in
// lathe PLC. Each sends what a program would say, as a block by hand.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/programs/transfer_steps.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class HandPage : public QWidget {
public:
    HandPage(Context& context, QWidget* parent);
    void refresh();
    bool key(QKeyEvent* event);
    void letGo() { dialing_ = false; }  // the panel is locked
    std::vector<SoftKey> keys(std::function<void()> back);
    std::vector<Sheet*> sheets() { return {handwheel_, tools_, steps_, state_}; }
    FreeSheet& wheel() { return *handwheel_; }
    Table& tools() { return *tools_; }
    Table& steps() { return *steps_; }
    unsigned axis() const;      // that the handwheel turns; 0 none
    void turn(int clicks);      // as often as the factor says
    QString toolBlock() const;  // «T0303» in the channel's language
    // «M5», or «G97 S300 M3» where it is stopped; empty: the channel has none
    QString spindleBlock() const;
    static constexpr int kAxisHits = 100, kFactorHits = 300, kMinusHit = 400, kPlusHit = 401,
                         kDialHit = 402;

protected:
    void resizeEvent(QResizeEvent*) override;
    bool eventFilter(QObject* object, QEvent* event) override;  // the dial is turned by a finger

private:
    struct Station {
        int number = 0;
        std::int32_t tool = 0;
    };
    void composeWheel(Writer& w);
    void composeState(Writer& w);
    void fillTools();
    void start(unsigned channel, const QString& block);
    void callTool();
    const TransferStep* chosenStep() const;  // none: no counter spindle
    void doStep();
    bool idle(unsigned channel) const;
    unsigned spindleOf(unsigned channel) const {
        return context_.live.config().channel(channel).default_spindle;
    }

    Context& context_;
    FreeSheet *handwheel_, *state_;
    Table *tools_, *steps_;
    std::vector<Station> stations_;
    std::vector<TransferStep> transfer_;
    std::uint64_t generation_ = ~0ull;         // of the machine that transfer_ is of
    unsigned place_ = 0;                       // of the axis in the channel
    int factor_ = 1, focus_ = 0, turned_ = 0;  // focus: 0 handwheel, 1 tools, 2 steps
    bool dialing_ = false;
    double lastAngle_ = 0, angleLeft_ = 0;
};

}  // namespace polyturn::hmi
