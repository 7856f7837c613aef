// The picture of a magazine: a turret as a disc with its stations, a chain as a loop, a matrix as
// rows and columns. Each place tells its number, its tool, the tool's state by sign and colour, and
// what is left of its life. Touch, arrows, and dragging a tool to a place.
//
// A tool is carried (dragged, or picked up by a key) until it is put down; where it goes is asked
// of the store by whoever owns the picture.
#pragma once
#include "hmi/machine/tools/tool_words.hpp"
#include "hmi/widgets/sheet.hpp"

class QKeyEvent;

namespace polyturn::hmi {

class Magazine : public Sheet {
public:
    Magazine(const Live& live, QWidget* parent) : Sheet(parent), live_(live) {}

    void show(std::int32_t magazine);  // which one
    std::int32_t shown() const { return magazine_; }
    const ToolPlace* chosen() const;  // the bright place; nullptr: there is none
    void choose(std::int32_t pot);
    bool key(QKeyEvent* event);
    void forgetTouch() override {
        pressed_ = dragging_ = false;
        lifted_ = 0;
        Sheet::forgetTouch();
    }
    int placeHit(std::int32_t pot) const { return pot; }
    // Of the place under a point of this widget; nullptr: none.
    const ToolPlace* placeAt(const QPointF& point) const;

    std::int32_t carried = 0;  // tool that looks for a place; 0 none
    bool focused = false;      // arrows go here
    std::function<void()> onChosen;
    std::function<void()> onActivated;  // touched again, or Enter
    // dragging has begun
    std::function<void(std::int32_t tool)> onLifted;
    std::function<void(std::int32_t tool, const QPoint& global)> onDropped;  // and ended there

protected:
    void compose(Writer& w) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    struct Spot {
        const ToolPlace* place;
        QRectF box;
        bool round;
        // of those about the chosen place, drawn once more so that they can be read
        bool large = false;
    };
    QRectF arrange(std::vector<Spot>& out) const;
    void turret(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const;
    void chain(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const;
    void lens(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const;
    QRectF grid(std::vector<Spot>& out, const std::vector<const ToolPlace*>& places) const;
    void composeSpot(Writer& w, const Spot& spot) const;

    const Live& live_;
    std::int32_t magazine_ = 1, pot_ = 0;
    QPointF down_;
    std::int32_t lifted_ = 0;  // under the finger
    bool pressed_ = false, dragging_ = false;
};

}  // namespace polyturn::hmi
