// The presetter: pictures of a tool's shadow, the outline found in the one that is chosen, what
// `polyturn presetter measure` says of it, and what would be entered in the offset. Nothing is
// written before it is confirmed.
#pragma once
#include <QDateTime>
#include <QFileInfo>
#include <QImage>
#include <QJsonObject>
#include <memory>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/live/aside.hpp"
#include "hmi/machine/programs/file_work.hpp"
#include "hmi/widgets/number_pad.hpp"
#include "hmi/widgets/table.hpp"

class QProcess;

namespace polyturn::hmi {

class PresetterPage : public QWidget {
public:
    PresetterPage(Context& context, QWidget* parent);
    ~PresetterPage() override;
    void refresh();
    bool key(QKeyEvent* event);
    void addKeys(std::vector<SoftKey>& keys);
    std::vector<Sheet*> sheets() { return {files_, result_, values_, pad_}; }
    Table& files() { return *files_; }
    Table& values() { return *values_; }
    void readFolder(const QString& folder);
    void propose() { measure(false); }  // writes nothing
    QString pin() const;                // its diameter and end, to be kept over a restart
    void setPin(const QString& kept);
    const QJsonObject& answer() const { return answer_; }
    const QString& failure() const { return failure_; }
    bool busy() const { return process_ != nullptr; }

protected:
    void resizeEvent(QResizeEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    enum Value : std::uint8_t { kOffset, kPinDiameter, kPinX, kPinZ, kEdge };
    void open();
    void look();  // reads the chosen picture
    void take();
    void run(QStringList arguments, bool written);
    void measure(bool write);
    void calibrate();
    void composeResult(Writer& w);
    QString chosen() const;
    QString place() const;   // the offset or edge that is written: «L1 3», «L1 T3.D1»
    QString target() const;  // the same as the command line reads it
    // of a channel that uses edges the tool and its edge stand in place of the offset
    Value valueOf(int row) const;
    void forgetOther();
    QString calibrationFile() const;
    bool inUse() const;  // a running program works with what would be written
    void lookForCalibration();

    Context& context_;
    Table *files_, *values_;
    FreeSheet* result_;
    NumberPad* pad_;
    QString folder_, failure_, pictureOf_;
    void takeFolder();
    std::vector<QFileInfo> entries_;
    Aside<std::vector<QFileInfo>> reading_;
    struct Shadow {
        QString file;
        QImage picture;
        std::vector<QPoint> outline;  // of the shadow, pixels of the picture
    };
    Aside<Shadow> reader_;
    QImage picture_;
    std::vector<QPoint> outline_;
    QRect room_;
    double number_[5] = {1, 0, 0, 0, 1};  // no gauge pin is known before somebody has entered it
    QJsonObject answer_;
    QString answerFor_;  // which place() it is of
    QByteArray out_, errors_;
    std::unique_ptr<QProcess> process_;
    QDateTime calibratedOn_;  // invalid: the camera is not calibrated
    qint64 lookAt_ = 0;
    bool written_ = false, calibrated_ = false, onValues_ = false;
};

}  // namespace polyturn::hmi
