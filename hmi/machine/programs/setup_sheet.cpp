#include "hmi/machine/programs/setup_sheet.hpp"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QPdfWriter>
#include <QRegularExpression>
#include <QTextDocument>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

#include "hmi/text/dates.hpp"
#include "hmi/text/search.hpp"
#include "ipc/model/machine/store/work_zeros.hpp"
#include "polyturn/parameter_handles.hpp"

namespace polyturn::hmi {
namespace {

StoreOf storesOf(const Live& live) {
    return [&live](unsigned channel) { return live.connected() ? &live.store(channel) : nullptr; };
}

}  // namespace

bool alikeNames(const QString& wanted, const QString& mounted) {
    static const QRegularExpression kWords("\\p{L}{3,}"), kNumbers("\\d+(?:[.,]\\d+)?");
    const auto all = [](const QString& text, const QRegularExpression& what) {
        QStringList out;
        for (auto found = what.globalMatch(text); found.hasNext();)
            out << found.next().captured().replace(',', '.');
        return out;
    };
    const auto stem = [](const QString& a, const QString& b) {
        const auto letters = std::min<qsizetype>({a.size(), b.size(), 4});
        return a.left(letters) == b.left(letters) && (letters == 4 || a.size() == b.size());
    };
    const QString one = withoutAccents(wanted).toLower(), other = withoutAccents(mounted).toLower();
    const QStringList numbers = all(one, kNumbers), others = all(other, kNumbers);
    if (!numbers.isEmpty() && !others.isEmpty() && numbers.first() != others.first()) return false;
    const QStringList words = all(other, kWords);
    for (const QString& a : all(one, kWords))
        if (std::any_of(words.begin(), words.end(), [&](const QString& b) { return stem(a, b); }))
            return true;
    return false;
}

std::vector<SheetTool> compareTools(const Live& live, const text::Job& job) {
    std::vector<SheetTool> out;
    for (const text::JobTool& wanted : job.tools) {
        SheetTool one;
        one.channel = static_cast<unsigned>(wanted.channel);
        one.station = static_cast<unsigned>(wanted.station);
        one.wanted = QString::fromStdString(wanted.name);
        const auto magazine = live.connected() && one.channel >= 1 && one.channel <= kMaxChannels
                                  ? static_cast<std::int32_t>(params::get(
                                        live.table(), params::pt_turret_magazine, one.channel))
                                  : 0;
        bool entered = false;  // any tool in this turret
        for (std::size_t i = 0; magazine && i < live.places().count; ++i)
            entered |=
                live.places().places[i].magazine == magazine && live.places().places[i].tool != 0;
        const ToolPlace* place =
            magazine ? placeOf(live, magazine, static_cast<std::int32_t>(one.station)) : nullptr;
        if (const ToolRow* tool = place ? toolOf(live, place->tool) : nullptr) {
            one.tool = place->tool;
            one.mounted = toolName(*tool, place->tool);
            one.state = toolWords(*tool);
            one.match = one.mounted.compare(one.wanted, Qt::CaseInsensitive) == 0
                            ? SheetTool::Match::Same
                        : alikeNames(one.wanted, one.mounted) ? SheetTool::Match::Alike
                                                              : SheetTool::Match::Other;
        } else if (entered) {
            one.match = SheetTool::Match::Missing;
        }
        out.push_back(std::move(one));
    }
    return out;
}

QString matchText(const SheetTool& tool) {
    switch (tool.match) {
        case SheetTool::Match::Same:
            return word("mounted");
        case SheetTool::Match::Alike:
            return word("other name: %1").arg(tool.mounted);
        case SheetTool::Match::Other:
            return word("another tool: %1").arg(tool.mounted);
        case SheetTool::Match::Missing:
            return word("the place is empty");
        case SheetTool::Match::Unknown:
            break;
    }
    return word("not entered");
}

JobSheet readJobSheet(const QString& path, const std::string& machine,
                      DisplayLanguage display_language) {
    JobSheet out;
    out.path = path;
    auto read = text::load_job(path.toStdString());
    if (!read) {
        out.fault = QString::fromStdString(text_in(read.diagnosis(), display_language));
        return out;
    }
    out.job = std::move(*read);
    out.otherMachine = for_another_machine(out.job, machine);
    if (out.job.setup.empty()) return out;
    auto setup = text::load_setup(out.job.setup);
    if (setup)
        out.setup = std::move(*setup);
    else
        out.setupFault = QString::fromStdString(text_in(setup.diagnosis(), display_language));
    return out;
}

std::vector<JobZero> compareZeros(const Live& live, const JobSheet& sheet) {
    return job_zeros(sheet.job, sheet.setup, live.config(), storesOf(live));
}
std::vector<JobOffset> compareOffsets(const Live& live, const JobSheet& sheet) {
    return job_offsets(sheet.setup, live.config(), storesOf(live));
}

QString JobEntry::request(double value) const {
    return words + "=" + QString::number(value, 'f', 9);
}

bool JobEntry::same() const { return std::abs(wanted - entered) <= 5e-7; }

std::vector<JobEntry> jobEntries(const Live& live, const JobSheet& sheet) {
    std::vector<JobEntry> out;
    for (const JobZero& one : compareZeros(live, sheet)) {
        if (std::isnan(one.entered)) continue;
        const auto row = work_zero_row(one.system);
        const QString system = QString::fromStdString(one.system),
                      axis = QString::fromStdString(one.axis);
        out.push_back({QString("L%1 %2 %3").arg(one.channel).arg(system, axis),
                       QString("zero L%1 %2 %3")
                           .arg(one.channel)
                           .arg(row ? QString::fromStdString(work_zero_name(*row)) : system, axis),
                       one.wanted, one.entered});
    }
    for (const JobOffset& offset : compareOffsets(live, sheet))
        for (const JobOffset::Value& one : offset.values) {
            if (std::isnan(one.entered)) continue;
            const QString field = fromView(one.name);
            out.push_back({QString("L%1 %2 %3%4")
                               .arg(offset.channel)
                               .arg(offset.number)
                               .arg(one.wear ? word("Wear") + " " : QString(), field),
                           QString("offset L%1 %2 %3 %4")
                               .arg(offset.channel)
                               .arg(offset.number)
                               .arg(QString(one.wear ? "wear" : "geometry"), field),
                           one.wanted, one.entered});
        }
    return out;
}

namespace {

QString zeroNumber(const Live& live, const JobZero& zero, double held) {
    const AxisConfig* axis = zero.channel >= 1 && zero.channel <= kMaxChannels
                                 ? find_axis(live.config(), zero.channel, zero.axis)
                                 : nullptr;
    return (axis ? live.unit(*axis) : live.unit(zero.channel)).text(held, 3);
}

// $TC_DP12 of the setup file's «DP12»; 0: it is none that is shown.
int parameterOf(const std::string& name) {
    int dp = 0, used = 0;
    return std::sscanf(name.c_str(), "DP%d%n", &dp, &used) == 1 &&
                   static_cast<std::size_t>(used) == name.size() && dp >= 1 && dp <= 35
               ? dp
               : 0;
}

}  // namespace

QString zeroWanted(const Live& live, const JobZero& zero) {
    return zeroNumber(live, zero, zero.wanted);
}

QString zeroText(const Live& live, const JobZero& zero) {
    if (std::isnan(zero.entered)) return word("the machine does not have it");
    return zero.same() ? word("entered")
                       : word("entered: %1").arg(zeroNumber(live, zero, zero.entered));
}

bool JobEdge::same() const {
    return std::all_of(values.begin(), values.end(), [](const Value& one) {
        return std::fabs(one.wanted - one.entered) <= 1e-6;
    });
}

// Without tool management programs begin with the edges of the setup file: there is nothing to
// compare them with.
std::vector<JobEdge> compareEdges(const Live& live, const JobSheet& sheet) {
    std::vector<JobEdge> out;
    if (!live.connected() || !toolsManaged(live)) return out;
    for (const auto& [channel, own] : sheet.setup.channels)
        for (const auto& [number, tool] : own.tools)
            for (const auto& [edge, values] : tool.edges) {
                JobEdge one{
                    static_cast<unsigned>(channel), {static_cast<std::int32_t>(number), edge}, {}};
                for (const auto& [name, wanted] : values)
                    if (const int dp = parameterOf(name))
                        one.values.push_back({dp, wanted,
                                              edgeOf(live, one.line)
                                                  ? edgeValue(live, one.line, dp)
                                                  : std::numeric_limits<double>::quiet_NaN()});
                std::sort(one.values.begin(), one.values.end(),
                          [](const auto& a, const auto& b) { return a.dp < b.dp; });
                if (!one.values.empty()) out.push_back(std::move(one));
            }
    return out;
}

QString edgeText(const Live& live, const JobEdge& edge, OffsetSide side, OffsetPart part,
                 bool all) {
    QStringList out;
    for (const JobEdge::Value& one : edge.values) {
        const bool wear = is_edge_wear(one.dp), same = std::fabs(one.wanted - one.entered) <= 1e-6;
        if (wear != (part == OffsetPart::Wear) || (same && (!all || (wear && one.wanted == 0))))
            continue;
        const double value = side == OffsetSide::Wanted ? one.wanted : one.entered;
        if (std::isnan(value)) return word("the machine does not have it");
        const QString title = wear && isLength(one.dp)
                                  ? edgeParameterTitle(kDpLength + lengthOf(one.dp))
                                  : edgeParameterTitle(one.dp);
        out << title + " " +
                   (one.dp == kDpType || one.dp == kDpTip ? QString::number(value, 'f', 0)
                                                          : live.unit(edge.channel).text(value, 3));
    }
    return out.join("  ");
}

// A tip's direction has no fraction; wear that is 0 on both sides need not be shown.
QString offsetText(const Live& live, const JobOffset& offset, OffsetSide side, OffsetPart part,
                   bool all) {
    QStringList out;
    for (const JobOffset::Value& one : offset.values) {
        if (one.wear != (part == OffsetPart::Wear) ||
            (one.same() && (!all || (one.wear && one.wanted == 0))))
            continue;
        const double value = side == OffsetSide::Wanted ? one.wanted : one.entered;
        if (std::isnan(value)) return word("the machine does not have it");
        out << (one.name == "T" ? word("Tip") : fromView(one.name)) + " " +
                   (one.name == "T" ? QString::number(value, 'f', 0)
                                    : live.unit(offset.channel).text(value, 3));
    }
    return out.join("  ");
}

QString jobDiffers(const Live& live, const JobSheet& sheet) {
    QStringList zeros, offsets, out;
    for (const JobZero& one : compareZeros(live, sheet))
        if (!one.same())
            zeros << QString("L%1 %2 %3")
                         .arg(one.channel)
                         .arg(QString::fromStdString(one.system), QString::fromStdString(one.axis));
    unsigned channel = 0;
    for (const JobOffset& one : compareOffsets(live, sheet)) {
        if (one.same()) continue;
        offsets << (one.channel == channel ? QString::number(one.number)
                                           : QString("L%1 %2").arg(one.channel).arg(one.number));
        channel = one.channel;
    }
    if (sheet.otherMachine)
        out << word("The job is for another machine: %1")
                   .arg(QFileInfo(QString::fromStdString(sheet.job.machine)).fileName());
    if (!zeros.isEmpty()) out << word("Other zeros than the job's hold: %1").arg(zeros.join(", "));
    if (!offsets.isEmpty())
        out << word("Other offsets than the job's hold: %1").arg(offsets.join(", "));
    QStringList edges;
    for (const JobEdge& one : compareEdges(live, sheet))
        if (!one.same())
            edges << QString("L%1 T%2 D%3").arg(one.channel).arg(one.line.tool).arg(one.line.edge);
    if (!edges.isEmpty()) out << word("Other edges than the job's hold: %1").arg(edges.join(", "));
    if (!sheet.setupFault.isEmpty()) out << sheet.setupFault;
    return out.join(".  ");
}

QString sheetText(const Live& live, const JobSheet& sheet) {
    const text::Job& job = sheet.job;
    QString html = QString("<h1>%1</h1><p>%2 &nbsp; %3</p>")
                       .arg(QString::fromStdString(job.name).toHtmlEscaped(),
                            QString::fromStdString(live.instance()),
                            momentText(QDateTime::currentDateTime(), "HH:mm"));
    const auto cells = [](const QStringList& texts, const char* tag) {
        QString out = "<tr>";
        for (const QString& one : texts)
            out += QString("<%1 align='left'>%2</%1>").arg(tag, one.toHtmlEscaped());
        return out + "</tr>";
    };
    const auto headline = [](const QString& text) {
        return "<h2 style='margin-top:22px; margin-bottom:6px'>" + text + "</h2>";
    };
    // a table has no room of its own below
    const auto table = [](const QString& rows) {
        return "<table border='1' cellspacing='0' cellpadding='5' width='100%'>" + rows +
               "</table><p style='margin:0; font-size:4pt'>&nbsp;</p>";
    };
    html += headline(word("Programs"));
    QString rows;
    for (const auto& [channel, program] : job.programs)
        rows += cells({QString("L%1").arg(channel),
                       QFileInfo(QString::fromStdString(program.file)).fileName(),
                       QString::fromStdString(program.language)},
                      "td");
    html += table(rows);
    if (job.stock)
        html += headline(word("Stock")) + "<p>" +
                QString::fromUtf8("⌀ %1 × %2 %3   %4")
                    .arg(numberText(live.commonUnit().of(job.stock->diameter), 4),
                         numberText(live.commonUnit().of(job.stock->length), 4),
                         live.commonUnit().name(), QString::fromStdString(job.stock->spindle)) +
                "</p>";
    if (sheet.otherMachine)
        html += headline(word("Machine")) + "<p>" +
                QFileInfo(QString::fromStdString(job.machine)).fileName().toHtmlEscaped() + ": " +
                word("not this one") + "</p>";
    if (const auto zeros = compareZeros(live, sheet); !zeros.empty()) {
        html += headline(word("Zeros"));
        rows = cells({word("Channel"), word("Zero"), word("Wanted"), word("Entered")}, "th");
        for (const JobZero& one : zeros)
            rows += cells({QString("L%1").arg(one.channel),
                           QString::fromStdString(one.system + " " + one.axis),
                           zeroWanted(live, one), zeroText(live, one)},
                          "td");
        html += table(rows);
    }
    html += headline(word("Required tools"));
    rows = cells({word("Channel"), word("Station"), word("Wanted"), word("Mounted"), word("State")},
                 "th");
    for (const SheetTool& one : compareTools(live, job))
        rows += cells({QString("L%1").arg(one.channel), QString::number(one.station), one.wanted,
                       matchText(one), one.state.text},
                      "td");
    html += table(rows);
    if (const auto offsets = compareOffsets(live, sheet); !offsets.empty()) {
        html += headline(word("Offsets"));
        rows = cells({word("Channel"), word("No."), word("Wanted"), word("Entered")}, "th");
        for (const JobOffset& one : offsets)
            for (const OffsetPart part : {OffsetPart::Geometry, OffsetPart::Wear}) {
                const QString wanted = offsetText(live, one, OffsetSide::Wanted, part, true),
                              entered = offsetText(live, one, OffsetSide::Entered, part, false);
                const QString number = part == OffsetPart::Wear
                                           ? QString("%1 %2").arg(one.number).arg(word("Wear"))
                                           : QString::number(one.number);
                if (!wanted.isEmpty())
                    rows += cells({QString("L%1").arg(one.channel), number, wanted,
                                   entered.isEmpty() ? word("entered") : entered},
                                  "td");
            }
        html += table(rows);
    }
    if (const auto edges = compareEdges(live, sheet); !edges.empty()) {
        html += headline(word("Tool edges"));
        rows = cells({word("Channel"), word("Tool"), word("Wanted"), word("Entered")}, "th");
        for (const JobEdge& one : edges)
            for (const OffsetPart part : {OffsetPart::Geometry, OffsetPart::Wear}) {
                const QString wanted = edgeText(live, one, OffsetSide::Wanted, part, true),
                              entered = edgeText(live, one, OffsetSide::Entered, part, false);
                const QString name = edgeTitle(live, one.line);
                if (!wanted.isEmpty())
                    rows += cells(
                        {QString("L%1").arg(one.channel),
                         part == OffsetPart::Wear ? QString("%1 %2").arg(name, word("Wear")) : name,
                         wanted, entered.isEmpty() ? word("entered") : entered},
                        "td");
            }
        html += table(rows);
    }
    if (!sheet.setupFault.isEmpty()) html += "<p>" + sheet.setupFault.toHtmlEscaped() + "</p>";
    if (job.parts_wanted)
        html += headline(word("Parts")) + QString("<p>%1</p>").arg(job.parts_wanted);
    return html;
}

FileOutcome writeSheet(const QString& html, const QString& title, const QString& file,
                       FileProgress& progress, const std::atomic<bool>& stop) {
    QBuffer page;
    page.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&page);
        writer.setPageSize(QPageSize(QPageSize::A4));
        writer.setTitle(title);
        QTextDocument document;
        document.setHtml(html);
        document.print(&writer);
    }
    return writeWhole(file, page.data(), progress, stop);
}

}  // namespace polyturn::hmi
