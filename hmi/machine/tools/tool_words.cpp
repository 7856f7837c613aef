#include "hmi/machine/tools/tool_words.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace polyturn::hmi {

namespace {

constexpr double kLittleLeft = 0.1;  // of a life, where no warning limit is given

// The store warns while it counts; a life that is entered may be short from the beginning.
bool nearlyOver(const ToolRow& tool) {
    const double left = lifeLeft(tool);
    return left >= 0 &&
           (tool.warning > 0 ? tool.life - tool.counter <= tool.warning : left < kLittleLeft);
}

}  // namespace

StateWords toolWords(const ToolRow& tool) {
    if (tool.state & kToolBroken) return {word("Broken"), Sign::Alarm, Tone::Bad};
    if (tool.state & kToolLocked) return {word("Locked"), Sign::Lock, Tone::Bad};
    if (tool.state & kToolWorn) return {word("Worn"), Sign::Stop, Tone::Bad};
    if (!(tool.state & kToolEnabled)) return {word("Not enabled"), Sign::Off, Tone::Quiet};
    if (tool.state & kToolWarned || nearlyOver(tool))
        return {word("Life nearly over"), Sign::Warning, Tone::Warning};
    if (tool.state & kToolActive) return {word("Works"), Sign::Run, Tone::Good};
    return {word("Ready"), Sign::Good, Tone::Good};
}

QString toolName(const ToolRow& tool, std::int32_t number) {
    const QString name = QString::fromUtf8(
        tool.name.data(), static_cast<int>(::strnlen(tool.name.data(), tool.name.size())));
    return name.isEmpty() ? word("tool %1").arg(number) : name;
}

double lifeLeft(const ToolRow& tool) {
    if (tool.life <= 0 || tool.life_kind == 0) return -1;
    return std::clamp((tool.life - tool.counter) / tool.life, 0.0, 1.0);
}

QString lifeUnit(unsigned kind) {
    switch (static_cast<LifeKind>(kind)) {
        case LifeKind::Minutes:
            return word("min");
        case LifeKind::Pieces:
            return word("pcs");
        case LifeKind::Uses:
            return word("uses");
        case LifeKind::Metres:
            return QString("m");
        case LifeKind::Wear:
            return unitWord("mm");
        case LifeKind::None:
            break;
    }
    return {};
}

QString numberText(double value, int decimals) {
    QString out = QString::number(value, 'f', decimals);
    while (out.contains('.') && (out.endsWith('0') || out.endsWith('.'))) {
        const bool point = out.endsWith('.');
        out.chop(1);
        if (point) break;
    }
    return out == "-0" ? QString("0") : out;
}

QString lifeText(const ToolRow& tool) {
    if (lifeLeft(tool) < 0) return {};
    const auto one = [](double value) { return numberText(std::round(value * 10) / 10); };
    return QString("%1 / %2 %3")
        .arg(one(std::max(0.0, tool.life - tool.counter)), one(tool.life),
             lifeUnit(tool.life_kind));
}

Tone lifeTone(const ToolRow& tool) {
    const double left = lifeLeft(tool);
    if (left <= 0) return Tone::Bad;
    return tool.state & kToolWarned || nearlyOver(tool) ? Tone::Warning : Tone::Good;
}

QString placeText(const Live& live, std::int32_t magazine, std::int32_t pot) {
    if (magazine == 0) return {};
    const ToolPlace* place = placeOf(live, magazine, pot);
    const auto kind = place ? static_cast<PlaceKind>(place->kind) : PlaceKind::Chain;
    if (kind == PlaceKind::Spindle) return QString("S%1").arg(magazine / 10);
    if (kind == PlaceKind::Arm) return word("arm S%1").arg(magazine / 10);
    // as the magazines are named above the picture: no fraction
    return QString("M%1 / %2").arg(magazine).arg(pot);
}

QString kindText(std::int32_t kind) {
    struct Row {
        std::int32_t first, last;
        const char* text;
    };
    static constexpr Row kRows[] = {
        {100, 199, WORD("milling tool")},   {200, 299, WORD("drill")},
        {400, 499, WORD("grinding wheel")}, {500, 500, WORD("roughing tool")},
        {510, 510, WORD("finishing tool")}, {520, 529, WORD("grooving tool")},
        {530, 539, WORD("parting tool")},   {540, 549, WORD("threading tool")},
        {550, 559, WORD("button tool")},    {560, 569, WORD("turning drill")},
        {580, 589, WORD("probe")},          {700, 999, WORD("special tool")}};
    for (const Row& row : kRows)
        if (kind >= row.first && kind <= row.last) return word(row.text);
    return {};
}

const ToolPlace* placeOf(const Live& live, std::int32_t magazine, std::int32_t pot) {
    const ToolPlaceTable& places = live.places();
    for (std::size_t i = 0; i < places.count; ++i)
        if (places.places[i].magazine == magazine && places.places[i].pot == pot)
            return &places.places[i];
    return nullptr;
}

}  // namespace polyturn::hmi
