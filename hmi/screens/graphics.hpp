// The paths of all channels about one workpiece, as the machine drives them, and the stock that they leave. The tip is a point here: the
// width of a grooving tool and the radius of a nose are not drawn, and the screen says so.
#pragma once
#include <QPixmap>
#include <deque>
#include <map>

#include "hmi/app/screen.hpp"
#include "ipc/text/job.hpp"

namespace polyturn::hmi {

// What is left of a turned blank: its radius along Z. Pure.
class TurnedStock {
public:
    void begin(double diameter, double bore, double length, double face);
    bool any() const { return !radius_.empty(); }
    // The tip has cut from one point to the other; Z from the workpiece zero, X as a radius.
    void cut(double z0, double x0, double z1, double x1);
    double radiusAt(double z) const;
    double left() const { return left_; }
    double right() const { return left_ + static_cast<double>(radius_.size()) * kStep; }
    double outer() const { return outer_; }
    double bore() const { return bore_; }
    static constexpr double kStep = 0.1;   // mm

private:
    std::vector<double> radius_;
    double left_ = 0, outer_ = 0, bore_ = 0;
};

class Graphics : public Screen {
public:
    explicit Graphics(Desk& desk);
    QString title() const override { return word("Graphics"); }
    Sign sign() const override { return Sign::Graphics; }
    const char* name() const override { return "graphics"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override { forget(); }
    std::vector<Sheet*> sheets() override { return {head_}; }
    // Each frame, whether the screen is shown or not: the paths go on.
    void follow() override;

protected:
    void resizeEvent(QResizeEvent*) override;
    void paintEvent(QPaintEvent*) override;

private:
    struct Point {
        double z, x;
        bool rapid, begins;
    };
    struct Trail {
        std::deque<Point> points;
        bool open = false;
        double cycle = 0;
        std::size_t drawn = 0;         // points that are in the picture already
        QPointF tip;                   // where it is drawn
    };
    void forget();
    void findJob();
    QPointF place(double z, double x) const;
    void drawRoom();                   // the whole picture but for the tips
    QRectF drawTrail(QPainter& p, unsigned index, unsigned channel, Trail& trail);   // what is new in it; its place
    QRectF tipBox(const Trail& trail) const;

    FreeSheet* head_;
    std::map<unsigned, Trail> trails_;
    TurnedStock stock_;
    std::string program_;              // of the job whose stock it is
    bool changed_ = true, cut_ = false;   // changed_: the picture must be drawn anew; cut_: the stock is another one since
    QPixmap picture_;
    double zoom_ = 1;
    qint64 painted_ = 0;              // the picture as a whole
};

}  // namespace polyturn::hmi
