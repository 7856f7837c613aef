#include "hmi/machine/live/lengths.hpp"

#include <QRegularExpression>
#include <algorithm>
#include <functional>

#include "hmi/machine/live/channel_words.hpp"
#include "hmi/text/display_languages.hpp"

namespace polyturn::hmi {
namespace {

LengthUnit unitWith(bool inch, unsigned decimals) {
    LengthUnit out{inch ? LengthUnit::Kind::Inch : LengthUnit::Kind::Millimetre, 3};
    out.decimals = out.digits(std::clamp(decimals, 1u, 6u));
    return out;
}

}  // namespace

QString LengthUnit::text(double held) const { return lengthText(of(held), decimals); }
QString LengthUnit::text(double held, unsigned ofMillimetres) const {
    return lengthText(of(held), digits(ofMillimetres));
}
QString LengthUnit::name() const {
    return kind == Kind::Degree ? QString(QChar(0xB0)) : unitWord(nameKey());
}
QString LengthUnit::radius() const { return inch() ? word("inch, radius") : word("mm, radius"); }
QString LengthUnit::diameter() const {
    return inch() ? word("inch, diameter") : word("mm, diameter");
}
QString LengthUnit::perMinute() const { return unitWord(perMinuteKey()); }
QString LengthUnit::perRevolution() const { return unitWord(inch() ? "inch/rev" : "mm/rev"); }
QString LengthUnit::surfaceName() const { return unitWord(inch() ? "ft/min" : "m/min"); }
QString LengthUnit::speed(double perMinute) const {
    return QString::number(of(perMinute), 'f', inch() ? 1 : 0);
}

namespace {

QString replacedNumbers(const QString& text, const QRegularExpression& number,
                        const std::function<QString(const QRegularExpressionMatch&)>& other) {
    QString out;
    qsizetype done = 0;
    for (auto found = number.globalMatch(text); found.hasNext();) {
        const auto one = found.next();
        out += text.mid(done, one.capturedStart() - done) + other(one);
        done = one.capturedEnd();
    }
    return out + text.mid(done);
}

QString shortNumber(double value, int decimals) {
    QString out = QString::number(value, 'f', decimals);
    while (out.contains('.') && (out.endsWith('0') || out.endsWith('.'))) out.chop(1);
    return out;
}

}  // namespace

QString retoldLengths(const QString& text, const LengthUnit& unit) {
    if (!unit.inch()) return text;
    static const QRegularExpression kLength(
        QString::fromUtf8("(-?\\d+(?:\\.\\d+)?) (?:mm|мм)(?![\\w/])"),
        QRegularExpression::UseUnicodePropertiesOption);
    return replacedNumbers(text, kLength, [&](const QRegularExpressionMatch& one) {
        return shortNumber(unit.of(one.captured(1).toDouble()), 4) + " " + unit.name();
    });
}

QString scaledNumbers(const QString& text, double factor) {
    static const QRegularExpression kNumber("-?(?:\\d+\\.?\\d*|\\.\\d+)");
    return replacedNumbers(text, kNumber, [&](const QRegularExpressionMatch& one) {
        return shortNumber(one.captured().toDouble() * factor, 5);
    });
}

LengthUnit lengthUnit(const MachineConfig& machine, unsigned channel) {
    if (channel < 1 || channel > kMaxChannels) return {};
    const ChannelConfig& config = machine.channel(channel);
    return unitWith(config.inch, config.decimals());
}

LengthUnit lengthUnit(const MachineConfig& machine, const AxisConfig& axis) {
    LengthUnit out = lengthUnit(machine, axis.channel);
    if (axis.rotary) out = {LengthUnit::Kind::Degree, out.inch() ? out.decimals - 1 : out.decimals};
    return out;
}

LengthUnit commonUnit(const MachineConfig& machine) {
    bool any = false, all = true;
    for (unsigned channel = 1; channel <= machine.last_channel; ++channel)
        if (machine.channel(channel).exists()) {
            any = true;
            all = all && machine.channel(channel).inch;
        }
    return unitWith(any && all, 3);
}

}  // namespace polyturn::hmi
