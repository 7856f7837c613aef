// Going on in the middle of a program: where each channel was last, where its tool came, and the
// block at which it restarts. The control reads there without moving; the first start shows the
// approach, the second one cuts (docs/operator.md).
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/programs/program_text.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

// The block's number of a line that calls a tool: T of a text or a comment calls none.
std::optional<std::int64_t> toolCallOf(const QString& line);

class RestartPage : public QWidget {
public:
    RestartPage(Context& context, QWidget* parent);
    void follow();  // each frame: where the programs are
    void refresh();
    bool key(QKeyEvent* event);
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {table_, note_, pad_}; }
    Table& table() { return *table_; }
    NumberPad& pad() { return *pad_; }
    std::int64_t wanted(unsigned channel) const { return at(channel).wanted; }
    std::int64_t stood(unsigned channel) const { return at(channel).block; }
    void keep();  // the places, over a restart of the screens

protected:
    void resizeEvent(QResizeEvent*) override;

private:
    struct Stood {
        std::string program;
        std::uint32_t line = 0;
        std::int64_t block = -1;   // executed last in the main program
        std::int64_t wanted = -1;  // -1: this channel does not restart
        // What toolBlock() has found, looking back from a line of a text of so many lines.
        struct {
            std::uint32_t from = 0, line = 0;
            int count = -1;
            std::int64_t block = -1;
        } tool = {};
    };
    std::int64_t toolBlock(Stood& stood);  // the last T before it; -1 none
    bool bringBack();
    Stood& at(unsigned channel) { return stood_[channel - 1]; }
    const Stood& at(unsigned channel) const { return stood_[channel - 1]; }
    void restart();
    void followSearch();
    std::optional<unsigned> chosen() const;

    Context& context_;
    Table* table_;
    FreeSheet* note_;
    NumberPad* pad_;
    ProgramText texts_;
    std::array<Stood, kMaxChannels> stood_{};
    // A restart whose outcome has not been reported: its channels (bit 0 is channel 1), who of them
    // was seen to search, since when.
    std::uint32_t searched_ = 0, seen_ = 0;
    qint64 searchedAt_ = 0;
    bool back_ = false;  // what was kept has been read
    QByteArray kept_;
    qint64 keepAt_ = 0;
};

}  // namespace polyturn::hmi
