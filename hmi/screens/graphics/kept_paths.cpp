#include "hmi/screens/graphics/kept_paths.hpp"

#include <QDataStream>
#include <QIODevice>
#include <QString>
#include <cstring>

namespace polyturn::hmi {
namespace {

constexpr quint32 kMark = 0x50545032;  // PTP2: another layout is another mark
constexpr quint32 kMostOfAList = 1'000'000;
constexpr qsizetype kPoint = 9;  // bytes: z, x, how

// Points as one block: eight channels have 160 000 points, and a turn of the screens must not end
// with them.
void writeBlock(QDataStream& out, const std::deque<TrailPoint>& points) {
    QByteArray block(static_cast<qsizetype>(points.size()) * kPoint, Qt::Uninitialized);
    char* at = block.data();
    for (const TrailPoint& point : points) {
        const float place[2] = {static_cast<float>(point.z), static_cast<float>(point.x)};
        std::memcpy(at, place, sizeof place);
        at[8] = static_cast<char>(point.rapid | point.begins << 1);
        at += kPoint;
    }
    out << block;
}

bool readBlock(QDataStream& in, std::deque<TrailPoint>& points) {
    QByteArray block;
    in >> block;
    if (in.status() != QDataStream::Ok || block.size() % kPoint ||
        block.size() / kPoint > kMostOfAList)
        return false;
    for (const char* at = block.constData(); at != block.constData() + block.size(); at += kPoint) {
        float place[2];
        std::memcpy(place, at, sizeof place);
        points.push_back({place[0], place[1], (at[8] & 1) != 0, (at[8] & 2) != 0, {}});
    }
    return true;
}

}  // namespace

QByteArray KeptPaths::written() const {
    QByteArray bytes;
    QDataStream out(&bytes, QIODevice::WriteOnly);
    // a thousandth of a millimetre is no pixel
    out.setFloatingPointPrecision(QDataStream::SinglePrecision);
    out << kMark << static_cast<quint64>(machineRun) << QString::fromStdString(program)
        << static_cast<quint32>(channels.size());
    for (const auto& [number, one] : channels) {
        out << static_cast<quint32>(number) << static_cast<quint64>(one.cycles) << one.cycle_s
            << one.zeroZ << one.zeroKnown;
        writeBlock(out, one.points);
    }
    for (const auto* wall : {&radii, &holes}) {
        out << static_cast<quint32>(wall->size());
        for (const double radius : *wall) out << radius;
    }
    return bytes;
}

KeptPaths KeptPaths::read(const QByteArray& bytes) {
    KeptPaths read;
    QDataStream in(bytes);
    in.setFloatingPointPrecision(QDataStream::SinglePrecision);
    quint32 mark = 0, count = 0, size = 0;
    quint64 run = 0;
    QString program;
    in >> mark;
    if (mark != kMark) return {};
    in >> run >> program >> count;
    for (quint32 i = 0; i < count && in.status() == QDataStream::Ok; ++i) {
        quint32 number = 0;
        quint64 cycles = 0;
        Channel one;
        in >> number >> cycles >> one.cycle_s >> one.zeroZ >> one.zeroKnown;
        one.cycles = cycles;
        if (!readBlock(in, one.points)) return {};
        read.channels.emplace(number, std::move(one));
    }
    for (auto* wall : {&read.radii, &read.holes}) {
        in >> size;
        if (size > kMostOfAList) return {};
        for (quint32 k = 0; k < size && in.status() == QDataStream::Ok; ++k)
            in >> wall->emplace_back();
    }
    if (in.status() != QDataStream::Ok) return {};
    read.machineRun = run;
    read.program = program.toStdString();
    return read;
}

}  // namespace polyturn::hmi
