#include "hmi/screens/tools/presetter_page.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QJsonArray>
#include <QJsonDocument>
#include <QKeyEvent>
#include <QProcess>
#include <QStandardPaths>
#include <QTimer>
#include <algorithm>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/machine/tools/edge_words.hpp"
#include "hmi/text/dates.hpp"
#include "hmi/widgets/number_cells.hpp"
#include "hmi/widgets/painted.hpp"
#include "hmi/widgets/portrait.hpp"

namespace polyturn::hmi {
namespace {

// Where dark and bright meet, half-way between the darkest and the brightest pixel: rows, then
// columns, so that slopes of any angle count.
std::vector<QPoint> outlineOf(const QImage& image) {
    std::vector<QPoint> out;
    int low = 255, high = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x) {
            low = std::min<int>(low, image.constScanLine(y)[x]);
            high = std::max<int>(high, image.constScanLine(y)[x]);
        }
    const int half = (low + high) / 2;
    for (int y = 1; y < image.height(); ++y) {
        const uchar *line = image.constScanLine(y), *above = image.constScanLine(y - 1);
        for (int x = 1; x < image.width(); ++x)
            if ((line[x] > half) != (line[x - 1] > half) || (line[x] > half) != (above[x] > half))
                out.push_back({x, y});
    }
    return out;
}

}  // namespace

PresetterPage::PresetterPage(Context& context, QWidget* parent)
    : QWidget(parent),
      context_(context),
      files_(new Table(this)),
      values_(new Table(this)),
      result_(new FreeSheet(this)),
      pad_(new NumberPad(this)) {
    files_->columns = {{word("Picture"), 1}};
    files_->rowUnits = 34;
    files_->ofMachine = false;
    files_->nothing = word("No pictures (PGM, BMP, PNG) in this folder.");
    files_->rows = [this] { return static_cast<int>(entries_.size()); };
    files_->cell = [this](int row, int) -> Table::Cell {
        const QFileInfo& one = entries_[static_cast<std::size_t>(row)];
        const QString name = one.fileName();
        if (row == 0 && isAbove(one, folder_)) return {word("Up"), theme().accent, Sign::Up};
        return {one.isDir() ? name + "/" : name, one.isDir() ? theme().dim : theme().text,
                one.isDir() ? Sign::None : Sign::Graphics};
    };
    files_->onChosen = [this] {
        onValues_ = false;
        look();
    };
    files_->onActivated = [this] { open(); };
    values_->columns = {{word("For the offset and the gauge pin"), 2.2}, {"", 1, kRight}};
    values_->rowUnits = 34;
    values_->rows = [this] { return usesEdges(context_.live, context_.channel) ? 5 : 4; };
    values_->cell = [this](int row, int column) -> Table::Cell {
        static constexpr const char* kTitles[] = {
            WORD("Offset number"), WORD("Diameter of the pin"), WORD("X of its end, radius"),
            WORD("Z of its end"), WORD("Edge D")};
        const Value which = valueOf(row);
        const bool whole = which == kOffset || which == kEdge;
        if (column == 0)
            return {which == kOffset && usesEdges(context_.live, context_.channel)
                        ? word("Tool number")
                        : word(kTitles[which])};
        if (!whole && number_[kPinDiameter] <= 0)
            return {QString::fromUtf8("–"), theme().dim, Sign::None, true};
        return {whole ? lengthText(number_[which], 0)
                      : context_.live.unit(context_.channel).text(number_[which], 3),
                theme().text, Sign::None, true};
    };
    values_->onChosen = [this] {
        onValues_ = true;
        pad_->clear();
    };
    pad_->field = [this]() -> std::optional<NumberPad::Field> {
        const int row = values_->row();
        const Value which = valueOf(row);
        if (which == kOffset || which == kEdge)
            return NumberPad::Field{
                values_->cell(row, 0).text, {}, number_[which], 0u, false, 1, false};
        const LengthUnit unit = context_.live.unit(context_.channel);
        return NumberPad::Field{values_->cell(row, 0).text,
                                unit.name(),
                                number_[which],
                                unit.digits(3),
                                false,
                                unit.size()};
    };
    pad_->onInput = [this](double value) {
        const Value which = valueOf(values_->row());
        number_[which] = which == kOffset ? std::clamp(std::round(value), 1.0, 999.0)
                         : which == kEdge ? std::clamp(std::round(value), 1.0,
                                                       static_cast<double>(kMostEdgesOfTool))
                                          : value;
        values_->refresh();
        if (context_.keysChanged) context_.keysChanged();
    };
    result_->onCompose = [this](Writer& w) { composeResult(w); };
    readFolder(context.folder.isEmpty() ? QDir::homePath() : context.folder);
}

PresetterPage::~PresetterPage() {
    if (!process_) return;
    process_->disconnect();
    process_->kill();
}

// The presetter makes its folder when it writes it.
QString PresetterPage::calibrationFile() const {
    return QStandardPaths::writableLocation(QStandardPaths::GenericConfigLocation) +
           "/polyturn/presetter-" + QString::fromStdString(context_.live.instance()) + ".json";
}

// Of this computer, and not at each frame.
void PresetterPage::lookForCalibration() {
    const qint64 now = QDateTime::currentMSecsSinceEpoch();
    if (now < lookAt_) return;
    lookAt_ = now + 2'000;
    calibratedOn_ = QFileInfo(calibrationFile()).lastModified();
}

// The edges of a tool are those of each channel that has it.
bool PresetterPage::inUse() const {
    const auto number = static_cast<std::int32_t>(number_[kOffset]),
               edge = static_cast<std::int32_t>(number_[kEdge]);
    const bool edges = usesEdges(context_.live, context_.channel);
    const auto& all = context_.live.channels();
    return std::any_of(all.begin(), all.end(), [&](unsigned channel) {
        const ChannelView& view = context_.live.view(channel);
        if (!works(context_.live.channel(channel)) || !view.known ||
            (!edges && channel != context_.channel))
            return false;
        return edges ? view.picture.tool == number && view.picture.edge == edge
                     : view.picture.geometry == number || view.picture.wear == number;
    });
}

// Aside: the folder may lie on a network.
void PresetterPage::readFolder(const QString& folder) {
    folder_ = QDir(folder).absolutePath();
    answer_ = {};
    failure_.clear();
    pictureOf_.clear();
    picture_ = {};
    outline_.clear();
    reading_.start([folder = folder_](const std::atomic<bool>&) {
        return folderInfos(folder, {"*.pgm", "*.bmp", "*.png"}, QDir::DirsFirst | QDir::Name);
    });
    takeFolder();
}

void PresetterPage::takeFolder() {
    auto made = reading_.take();
    if (!made) return;
    entries_ = std::move(*made);
    int first = 0;  // the first picture
    while (first < static_cast<int>(entries_.size()) &&
           entries_[static_cast<std::size_t>(first)].isDir())
        ++first;
    files_->choose(first < static_cast<int>(entries_.size()) ? first : 0);
}

QString PresetterPage::chosen() const {
    const int row = files_->row();
    return row < static_cast<int>(entries_.size()) &&
                   entries_[static_cast<std::size_t>(row)].isFile()
               ? entries_[static_cast<std::size_t>(row)].absoluteFilePath()
               : QString();
}

void PresetterPage::open() {
    const int row = files_->row();
    if (row >= static_cast<int>(entries_.size())) return;
    const QFileInfo entry = entries_[static_cast<std::size_t>(row)];
    if (entry.isDir())
        readFolder(entry.absoluteFilePath());
    else
        measure(false);
}

void PresetterPage::look() {
    const QString file = chosen();
    if (file == pictureOf_) return;
    pictureOf_ = file;
    answer_ = {};
    failure_.clear();
    written_ = false;
    calibrated_ = false;
    picture_ = {};
    outline_.clear();
    reader_.forget();
    if (!file.isEmpty())
        reader_.start([file](const std::atomic<bool>&) {
            Shadow out{file, QImage(file).convertToFormat(QImage::Format_Grayscale8), {}};
            out.outline = outlineOf(out.picture);
            return out;
        });
    take();
    update(room_);
    result_->refresh();
    if (context_.keysChanged) context_.keysChanged();
}

void PresetterPage::take() {
    if (auto shadow = reader_.take(); shadow && shadow->file == pictureOf_) {
        picture_ = std::move(shadow->picture);
        outline_ = std::move(shadow->outline);
        update(room_);
    }
}

// The command line measures and proposes; with --yes it enters. One at a time; nothing here waits
// for it.
void PresetterPage::run(QStringList arguments, bool written) {
    if (process_) return;
    failure_.clear();
    answer_ = {};
    answerFor_.clear();
    out_.clear();
    errors_.clear();
    written_ = false;
    calibrated_ = false;
    process_ = std::make_unique<QProcess>();
    QObject::connect(process_.get(), &QProcess::readyReadStandardOutput, this,
                     [this] { out_ += process_->readAllStandardOutput(); });
    QObject::connect(process_.get(), &QProcess::readyReadStandardError, this,
                     [this] { errors_ += process_->readAllStandardError(); });
    const auto over = [this, written, calibration = arguments.contains("calibrate")](bool ran) {
        if (!process_) return;
        if (ran) {
            out_ += process_->readAllStandardOutput();
            errors_ += process_->readAllStandardError();
        }
        process_.release()->deleteLater();
        answer_ = QJsonDocument::fromJson(out_).object();
        if (!ran)
            failure_ = word("The program polyturn is not beside the HMI.");
        else if (answer_.isEmpty())
            failure_ = QString::fromUtf8(errors_).simplified();
        written_ = written && !answer_.isEmpty();
        calibrated_ = calibration && !answer_.isEmpty();
        if (written_) context_.tell(word("The offset is written"), Told::Good);
        lookAt_ = 0;
        refresh();
        if (context_.keysChanged) context_.keysChanged();
    };
    QObject::connect(process_.get(), &QProcess::finished, this, [over] { over(true); });
    QObject::connect(process_.get(), &QProcess::errorOccurred, this,
                     [over](QProcess::ProcessError error) {
                         if (error == QProcess::FailedToStart) over(false);
                     });
    arguments << "--calibration" << calibrationFile() << "--instance"
              << QString::fromStdString(context_.live.instance()) << "--json";
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    environment.insert("LANG", QString("%1_XX.UTF-8").arg(codeOf(spoken())));
    process_->setProcessEnvironment(environment);
    process_->start(QCoreApplication::applicationDirPath() + "/polyturn", arguments);
}

void PresetterPage::measure(bool write) {
    if (chosen().isEmpty() || process_) return;
    QStringList arguments{"presetter", "measure", chosen(), QString("L%1").arg(context_.channel),
                          target()};
    if (write) arguments << "--yes";
    run(arguments, write);
    answerFor_ = place();
}

PresetterPage::Value PresetterPage::valueOf(int row) const {
    if (!usesEdges(context_.live, context_.channel)) return static_cast<Value>(row);
    return row == 0 ? kOffset : row == 1 ? kEdge : static_cast<Value>(row - 1);
}

QString PresetterPage::target() const {
    const QString number = QString::number(number_[kOffset], 'f', 0);
    return usesEdges(context_.live, context_.channel)
               ? QString("T%1.D%2").arg(number).arg(number_[kEdge], 0, 'f', 0)
               : number;
}

QString PresetterPage::place() const {
    return QString("L%1 %2").arg(context_.channel).arg(target());
}

// What has been measured for one offset says nothing of another.
void PresetterPage::forgetOther() {
    if (process_ || answerFor_.isEmpty() || answerFor_ == place()) return;
    answer_ = {};
    failure_.clear();
    answerFor_.clear();
    written_ = false;
    result_->refresh();
}

void PresetterPage::calibrate() {
    if (chosen().isEmpty()) return;
    run({"presetter", "calibrate", chosen(),
         QString("diameter=%1").arg(number_[kPinDiameter], 0, 'f', 6),
         QString("x=%1").arg(number_[kPinX], 0, 'f', 6),
         QString("z=%1").arg(number_[kPinZ], 0, 'f', 6)},
        false);
}

QString PresetterPage::pin() const {
    return QString("%1/%2/%3")
        .arg(number_[kPinDiameter], 0, 'g', 12)
        .arg(number_[kPinX], 0, 'g', 12)
        .arg(number_[kPinZ], 0, 'g', 12);
}

void PresetterPage::setPin(const QString& kept) {
    const QStringList parts = kept.split('/');
    for (int i = 0; parts.size() == 3 && i < 3; ++i)
        number_[kPinDiameter + i] = parts[i].toDouble();
}

void PresetterPage::resizeEvent(QResizeEvent*) {
    const int edge = px(8), left = px(270), right = px(340), pad = px(350);
    if (upright(*this)) {
        const int result = px(206), below = height() - pad - edge,
                  wide = width() - right - 3 * edge;
        files_->setGeometry(edge, 0, left, below - edge);
        room_ = QRect(left + 2 * edge, 0, width() - left - 3 * edge, below - edge);
        result_->setGeometry(edge, below, wide, result);
        values_->setGeometry(edge, below + result + edge, wide, pad - result - edge);
        pad_->setGeometry(width() - right - edge, below, right, pad);
        return;
    }
    files_->setGeometry(edge, 0, left, height() - edge);
    const int middle = width() - left - right - 4 * edge, result = px(206);
    room_ = QRect(left + 2 * edge, 0, middle, height() - result - 2 * edge);
    result_->setGeometry(left + 2 * edge, height() - result - edge, middle, result);
    values_->setGeometry(width() - right - edge, 0, right, height() - pad - 2 * edge);
    pad_->setGeometry(width() - right - edge, height() - pad - edge, right, pad);
}

void PresetterPage::refresh() {
    takeFolder();
    take();
    forgetOther();
    lookForCalibration();
    files_->focused = !onValues_;
    values_->focused = onValues_;
    for (Sheet* one : sheets()) one->refresh();
}

void PresetterPage::paintEvent(QPaintEvent*) {
    const Theme& t = theme();
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    p.fillRect(rect(), t.window);
    p.setPen(Qt::NoPen);
    p.setBrush(t.card);
    p.drawRoundedRect(room_, px(8), px(8));
    if (picture_.isNull()) {
        p.setPen(t.dim);
        p.setFont(lettering(15));
        paintWords(p, room_, Qt::AlignCenter | Qt::TextWordWrap,
                   word("Choose a picture of the tool's shadow"));
        return;
    }
    const QRectF inside = QRectF(room_).adjusted(px(10), px(10), -px(10), -px(10));
    const double scale =
        std::min(inside.width() / picture_.width(), inside.height() / picture_.height());
    const QSizeF size(picture_.width() * scale, picture_.height() * scale);
    const QRectF box(inside.center() - QPointF(size.width(), size.height()) / 2, size);
    p.setRenderHint(QPainter::SmoothPixmapTransform);
    p.drawImage(box, picture_);
    p.setBrush(t.accent);
    const double dot = std::max<double>(1.5, scale);
    for (const QPoint& at : outline_)
        p.fillRect(QRectF(box.left() + at.x() * scale - dot / 2,
                          box.top() + at.y() * scale - dot / 2, dot, dot),
                   t.accent);
}

void PresetterPage::composeResult(Writer& w) {
    const Theme& t = theme();
    const double wide = result_->width(), high = result_->height();
    w.fill(QRectF(0, 0, wide, high), t.window);
    w.fill(QRectF(0, 0, wide, high), t.card, px(8));
    const auto sentence = [&](Sign sign, const QColor& colour, const QString& text,
                              bool from_outside) {
        w.sign(QRectF(px(12), px(12), px(22), px(22)), sign, colour);
        Item& item = w.text(QRectF(px(44), px(10), wide - px(56), high - px(20)), text,
                            lettering(14.5), t.text, Qt::AlignLeft | Qt::AlignTop);
        item.wraps = true;
        item.data = from_outside;
    };
    if (process_) return sentence(Sign::Wait, t.wait, word("Measures ..."), false);
    if (!failure_.isEmpty()) return sentence(Sign::Alarm, t.bad, failure_, true);
    if (calibrated_)
        return sentence(Sign::Good, t.good,
                        word("Calibrated: %1 µm a pixel, tilted by %2°")
                            .arg(answer_.value("um_per_pixel").toDouble(), 0, 'f', 3)
                            .arg(answer_.value("tilt_deg").toDouble(), 0, 'f', 3),
                        false);
    if (answer_.isEmpty() && calibratedOn_.isValid())
        return sentence(
            Sign::Note, t.dim,
            word("«Measure» finds the tip and shows what would be entered. Camera calibrated: %1.")
                .arg(momentText(calibratedOn_, "HH:mm")),
            false);
    if (answer_.isEmpty())
        return sentence(
            Sign::Note, t.dim,
            word("«Measure» finds the tip and shows what would be entered. The gauge pin "
                 "calibrates the camera first."),
            false);
    double y = px(6);
    const LengthUnit unit = context_.live.unit(context_.channel);
    for (const char* name : {"X", "Z", "R"}) {
        w.text(QRectF(px(12), y, px(26), px(22)), name, lettering(15, true), t.dim);
        w.text(QRectF(px(40), y, wide * 0.4, px(22)), unit.text(answer_.value(name).toDouble(), 4),
               lettering(16, true), t.text, kRight);
        w.text(QRectF(wide * 0.55, y, wide * 0.45 - px(12), px(22)),
               QString::fromUtf8("± %1 %2").arg(
                   unit.text(answer_.value(QString(name) + "_error").toDouble(), 4),
                   *name == 'X' ? unit.radius() : unit.name()),
               lettering(14), t.dim, kRight);
        y += px(22);
    }
    w.text(QRectF(px(12), y, wide - px(24), px(22)),
           QString::fromUtf8("%1 %2     %3°")
               .arg(word("Tip"))
               .arg(answer_.value("T").toInt())
               .arg(answer_.value("included_deg").toDouble(), 0, 'f', 2),
           lettering(15), t.text);
    y += px(24);
    w.sign(QRectF(px(12), y + px(2), px(18), px(18)), written_ ? Sign::Good : Sign::Note,
           written_ ? t.good : t.accent);
    w.text(QRectF(px(36), y, wide - px(48), px(22)),
           written_ ? word("It is entered") : word("Would be entered"), lettering(14.5, true),
           written_ ? t.good : t.accent);
    y += px(22);
    for (const auto& one : answer_.value("entries").toArray()) {
        const QJsonObject entry = one.toObject();
        const QString what = entry.value("what").toString(), title = cellTitle(what);
        const unsigned decimals = what.endsWith(" T") || what.endsWith(" DP2") ? 0 : 4;  // the tip
        const QStringList cell = what.split(' ');  // «L1 offset 3 geometry X»
        const AxisConfig* axis =
            cell.size() == 5 && cell[1] == "offset" && QString("XYZ").contains(cell[4])
                ? find_axis(context_.live.config(), context_.channel,
                            cell[4] == "X"   ? PlaneRole::BasicX
                            : cell[4] == "Y" ? PlaneRole::BasicY
                                             : PlaneRole::BasicZ)
                : nullptr;
        const bool diameter = axis && axis->offset_diameter && !axis->rotary;
        const auto number = [&](const char* name) {
            return decimals ? unit.text(entry.value(name).toDouble(), decimals)
                            : lengthText(entry.value(name).toDouble(), 0);
        };
        w.data(QRectF(px(12), y, wide - px(24), px(20)),
               QString::fromUtf8("%1: %2 → %3 %4")
                   .arg(title, number("old"), number("new"),
                        decimals ? unit.name() + (diameter ? QString::fromUtf8(" ⌀") : QString())
                                 : QString()),
               lettering(13.5, false, Face::Condensed), t.text);
        y += px(20);
    }
}

bool PresetterPage::key(QKeyEvent* event) {
    if (event->key() == Qt::Key_Tab || event->key() == Qt::Key_Backtab) {
        onValues_ = !onValues_;
        refresh();
        return true;
    }
    if (pad_->key(event)) return true;
    return onValues_ ? values_->key(event) : files_->key(event);
}

void PresetterPage::addKeys(std::vector<SoftKey>& keys) {
    const bool ready = !chosen().isEmpty() && !process_ && context_.live.connected();
    forgetOther();
    const QString offset = place();
    keys.push_back({word("Measure"), [this] { measure(false); }, Sign::None, ready});
    keys.push_back({word("Enter it"),
                    [this] { measure(true); },
                    Sign::Good,
                    ready && answer_.contains("entries") && !written_,
                    false,
                    false,
                    inUse() ? word("A program works with it: press again")
                            : word("Writes the offset: press again"),
                    {},
                    QString("%1 %2").arg(offset, chosen()),
                    offset});
    keys.push_back({word("Calibrate"),
                    [this] { calibrate(); },
                    Sign::None,
                    ready && number_[kPinDiameter] > 0,
                    false,
                    false,
                    word("It is the gauge pin: press again"),
                    {},
                    QString("%1 %2").arg(pin(), chosen()),
                    chosen().section('/', -1)});
}

}  // namespace polyturn::hmi
