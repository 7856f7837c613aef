// The scope: eight signals at tick rate, chosen from everything that the machine can report, with
// trigger and export; and the circularity plot of the circle that was driven last, from the first
// four traces.
#pragma once
#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/programs/file_text.hpp"
#include "hmi/screens/machine/scope_plot.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

namespace polyturn::hmi {

class ScopePage : public QWidget {
public:
    ScopePage(Context& context, QWidget* parent);
    void follow();  // each frame, shown or not: takes the samples
    void refresh();
    void rebuilt();
    bool key(QKeyEvent* event);
    std::vector<SoftKey> keys(std::function<void()> back);
    std::vector<Sheet*> sheets();
    bool circle() const { return circle_; }
    // nothing has been said yet of what was driven
    bool judging() const { return circle_ && !judged_ && !record_.samples().empty(); }
    void showCircle(bool on);
    const ScopeRecord& record() const { return record_; }
    Table& traces() { return *traces_; }
    Table& chooser() { return *chooser_; }
    bool choosing() const { return choosing_; }
    const QString& exported() const { return exported_; }
    const std::optional<Roundness>& roundness() const { return round_; }
    const ScopePlot& plot() const { return plot_; }
    bool missed() const { return missed_; }  // ticks that it should have recorded
    // For pictures and costs of all of it: the list of signals, the pad of the trigger's level.
    void showChooser(bool on);
    void showLevel(bool on);

protected:
    void resizeEvent(QResizeEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    struct Choice {
        QString words;  // «measured A1», as press scope takes it
        // english: of a signal, for who searches by a builder's document
        QString title, unit, english{};
    };
    void layOut();
    void fillChoices();
    void choose(const QString& words);
    void takeValues();  // of the table
    void paintCircle(QPainter& p);
    bool choseCircle() const;  // traces 1 to 4 are two axes, commanded and measured
    void setCircle();          // traces 1 to 4 become those of the channel's two axes
    void save();
    void takeExport();
    QString titleOf(std::size_t trace, QString* unit = nullptr) const;
    double windowTicks() const;

    Context& context_;
    Table *traces_, *chooser_;
    NumberPad* pad_;
    FreeSheet* note_;
    ScopeRecord record_;
    ScopeChoice choice_{};
    std::uint64_t next_ = 0;
    bool choosing_ = false, circle_ = false, judged_ = false, missed_ = false, level_ = false;
    QString search_, exported_, exporting_;
    Aside<FileOutcome> writing_;
    std::vector<Choice> all_, found_;
    int base_ = 3;  // of the time bases
    qint64 valuesMs_ = 0, roundMs_ = 0;
    struct Values {
        QString now, least, most, division;
    };
    std::array<Values, kScopeTraces> values_{};
    ScopePlot plot_;
    QRect room_;
    std::optional<Roundness> round_;
    Aside<std::optional<Roundness>> judging_;
    void forgetCircle() {
        judging_.forget();
        round_.reset();
    }
};

}  // namespace polyturn::hmi
