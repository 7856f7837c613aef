#include "hmi/machine/programs/program_unit.hpp"

#include <QRegularExpression>
#include <algorithm>

namespace polyturn::hmi {
namespace {

struct UnitCodes {
    const char *inches, *millimetres;
};
// G70 is a cycle of the fanuc family but in its code system C.
UnitCodes codesOf(const Live& live, unsigned channel, const QString& language) {
    if (language == "fagor") return {"70", "71"};
    if (language == "sinumerik") return {"70|700", "71|710"};
    const bool system_c =
        language == "fanuc" && params::bit(live.table(), params::f3401, channel, 7);
    return system_c ? UnitCodes{"70", "71"} : UnitCodes{"20", "21"};
}

bool beginsWithInches(const Live& live, unsigned channel, const QString& language) {
    const params::Table& t = live.table();
    if (language == "fagor") return params::get(t, params::fg_inches, channel) != 0;
    if (language == "sinumerik") {
        // of group 13: G70, G71, G700, G710
        const int code = static_cast<int>(params::get(t, params::md20150, channel, 12));
        return code == 1 || code == 3;
    }
    return language != "mefi" && params::bit(t, params::n1300_defaultg1, channel, 3);
}

}  // namespace

bool countsInches(const Live& live, unsigned channel, const QString& language,
                  const QStringList& lines, int cursor) {
    const UnitCodes codes = codesOf(live, channel, language);
    const QRegularExpression code(
        QString("(?<![A-Z_$])G0*(?:(%1)|(%2))(?![0-9.])").arg(codes.inches, codes.millimetres),
        QRegularExpression::CaseInsensitiveOption);
    static const QRegularExpression kFamilyComment("\\([^)]*\\)?"),
        kOtherComment(";.*|\"[^\"]*\"?");
    for (int at = std::min(cursor, static_cast<int>(lines.size()) - 1); at >= 0; --at) {
        QString bare = lines[at];
        bare.remove(language == "sinumerik" ? kOtherComment : kFamilyComment);
        QRegularExpressionMatch last;
        for (auto found = code.globalMatch(bare); found.hasNext();) last = found.next();
        if (last.hasMatch()) return !last.captured(1).isEmpty();
    }
    return beginsWithInches(live, channel, language);
}

}  // namespace polyturn::hmi
