// The paths of all channels in the machine's room, the stock that they leave, and what stands
// around it: chucks, tailstocks, turrets, protection zones, from the geometry that protection
// guards (machine/room_view.hpp), and how far the tips may go, from the stroke ranges that the
// kernel judges (machine/stroke_view.hpp). Of the running machine, or of a dry run of its job,
// played back. The tip is a point here: the width of a grooving tool and the radius of a nose are
// not drawn, and the screen says so.
#pragma once
#include <QElapsedTimer>
#include <QPixmap>
#include <QPointF>
#include <QRegion>
#include <memory>
#include <set>

#include "hmi/widgets/screen.hpp"
#include "hmi/machine/bodies/room_view.hpp"
#include "hmi/machine/bodies/stroke_view.hpp"
#include "hmi/machine/programs/dry_run.hpp"
#include "hmi/screens/graphics/cutting_scene.hpp"
#include "hmi/screens/graphics/path_names.hpp"

namespace polyturn::hmi {

class Graphics : public Screen {
public:
    explicit Graphics(Context& context);
    QString title() const override { return word("Graphics"); }
    Sign sign() const override { return Sign::Graphics; }
    const char* name() const override { return "graphics"; }
    std::vector<SoftKey> keys() override;
    void refresh() override;
    void rebuilt() override;
    bool key(QKeyEvent* event) override;
    QString state() const override;
    void restore(const QString& state) override;
    void leave() override { keepPaths(); }
    HelpTopic help() const override { return {"operator.md", "Graphics:", {}}; }
    int pages() const override { return 3; }  // the part, the whole machine, a dry run
    void turnTo(int page) override;
    bool busy() const override { return dry_ && dryRun_.running(); }
    std::vector<Sheet*> sheets() override { return {head_}; }
    // Each frame, whether the screen is shown or not: the paths go on.
    void follow() override;
    // For tests: what is drawn of the machine, and of which run.
    const std::vector<ShownBody>& bodies() const { return bodies_; }
    const std::vector<ShownStroke>& strokes() const { return strokes_; }
    const CuttingScene& scene() const { return dry_ ? drySide_ : live_; }
    double dryTime() const { return dryTime_; }
    const std::map<unsigned, PathNames>& pathNames() const { return names_; }
    std::vector<QRectF> labels() const;  // of tips and bodies
    QRectF legend() const;
    const std::vector<QRectF>& frames() const { return frames_; }  // of travel

protected:
    void resizeEvent(QResizeEvent*) override;
    void paintEvent(QPaintEvent*) override;
    void mousePressEvent(QMouseEvent* event) override { drag_ = event->position(); }
    void mouseMoveEvent(QMouseEvent* event) override;

private:
    struct FoundJob {
        // asked for, and of the job that names it; empty: none does
        std::string program, file;
        std::optional<text::JobStock> stock;
        std::map<unsigned, double> zeros;  // G54 Z of the job, by channel
        unsigned channel = 0;              // in which the program is selected
    };
    CuttingScene& shown() { return dry_ ? drySide_ : live_; }
    void forget();
    void findJob();
    void beginStock(CuttingScene& scene);
    CuttingScene::Zero zeroOf(unsigned channel, bool dryRun = false) const;
    void followZero(unsigned channel, double tipZ);
    void followLive();
    struct LookedUp {
        CalledTool called{};
        std::uint64_t tools = 0, store = 0;  // versions
        CuttingTool tool{};
    };
    const CuttingTool& toolInWork(unsigned channel);
    const CuttingTool& lookedUp(LookedUp& known, unsigned channel, const CalledTool& called);
    // graphics_kept.cpp
    void keepPaths();  // those of the running part, and a run that is over
    // what was there before a restart, as soon as it is known
    void bringBack();
    void bringBackPaths();
    QString dryWords() const;
    void startDry();
    void followDry();
    void playTo(double seconds);
    void look(bool machine);
    void turnPage(double z, double x);  // the picture moves by parts of its size
    // What is drawn of a body and of a tip: two that are equal are the same pixels.
    struct BodyLook {
        struct Filled {
            QRectF box;
            int opacity = 0;
            bool operator==(const Filled&) const = default;
        };
        std::vector<Filled> boxes;
        QColor colour, ink;
        bool carrier = false, hatched = false, broken = false, held = false;
        QRectF seat, label;  // null: none
        QPointF from, to;    // of the tool, where it has no box; equal: none
        QString text;
        bool operator==(const BodyLook&) const = default;
        double pen() const;
        QRegion pixels() const;
        QRegion differing(const BodyLook& before) const;  // all pixels that may be other ones
    };
    struct TipLook {
        QPointF at;
        double side = 1;
        QRectF label;
        QString text;
        bool operator==(const TipLook&) const = default;
        QRect pixels() const;
    };
    // graphics_picture.cpp
    QPointF place(double z, double x) const;
    QRectF boxOf(const RoomBodies::Box& box) const;
    void measure();   // what place() works with
    void drawRoom();  // the whole picture but for what moves
    void drawPart(QPainter& p);
    BodyLook lookOf(const ShownBody& body) const;
    TipLook lookOf(unsigned channel, const Trail& trail) const;
    QRegion takeLooks();  // positions of now; what must be painted again
    void drawBody(QPainter& p, const BodyLook& body);
    void drawNotes(QPainter& p, const QRegion& region);
    struct Notes {
        QString lines, none;
        bool two = false;  // lines of text
    };
    Notes notes() const;
    void drawStrokes(QPainter& p, const QRectF& area);
    QRectF drawTrail(QPainter& p, unsigned channel, Trail& trail);  // what is new in it; its place
    QRectF nameBox(unsigned channel, const QPointF& place) const;
    QRectF drawNames(QPainter& p, const QRectF& within);
    // to which side of the spindle axis its tip is drawn: 1 up, -1 down
    double aside(unsigned channel) const;
    QString nameOf(const ShownBody& body) const;

    FreeSheet* head_;
    CuttingScene live_, drySide_;
    RoomView room_;
    RoomNow now_, dryFrom_;  // dryFrom_: as a simulation has begun
    std::vector<ShownBody> bodies_;
    std::vector<ShownStroke> strokes_;
    std::map<unsigned, double> cycle_;             // of the parts, by channel
    std::map<unsigned, LookedUp> inWork_, inRun_;  // by channel
    // of the workpiece in the work area, as the running block has it
    std::map<unsigned, double> zeroZ_;
    // channels whose new part has not reported its zero yet: that of the part before is shown
    std::set<unsigned> zeroDue_;
    Aside<FoundJob> finding_;
    FoundJob job_;
    bool machine_ = false;                                 // the whole machine, not the part
    bool dry_ = false, playing_ = false, wanted_ = false;  // wanted_: a dry run has been asked for
    DryRun dryRun_;
    double dryTime_ = 0, drySpeed_ = 4;
    struct Played {
        std::size_t move = 0;
        double part = 0;  // of it
    };
    RunMove comesFrom(unsigned channel, const RunChannel& run, std::size_t move) const;
    std::map<unsigned, Played> dryAt_;
    QElapsedTimer clock_;
    QPixmap picture_;
    std::map<unsigned, PathNames> names_;  // of channels, on the paths of the picture
    std::vector<BodyLook> bodyLooks_;
    std::vector<QRectF> frames_;
    std::map<unsigned, TipLook> tipLooks_;
    bool redraw_ = true;
    double zoom_ = 1;
    QPointF moved_, drag_, centre_, origin_;  // moved_: parts of the picture
    double scale_ = 1;
    qint64 painted_ = 0;  // the picture as a whole
    qint64 keepAt_ = 0;
    std::uint64_t keptVersion_ = 0;  // of the run that is kept
    bool pathsBack_ = true;          // those of before a restart have not been looked for
    // the run of before a restart is to be shown, at this time
    std::optional<double> runBack_;
};

}  // namespace polyturn::hmi
