#include "hmi/machine/setup_sheet.hpp"
#include "hmi/text/dates.hpp"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QPdfWriter>
#include <QTextDocument>
#include <cmath>

#include "polyturn/parameter_handles.hpp"

namespace polyturn::hmi {
namespace {

StoreOf storesOf(const Live& live) {
    return [&live](unsigned channel) { return live.connected() ? &live.store(channel) : nullptr; };
}

}  // namespace

std::vector<SheetTool> compareTools(const Live& live, const text::Job& job) {
    std::vector<SheetTool> out;
    for (const text::JobTool& wanted : job.tools) {
        SheetTool one;
        one.channel = static_cast<unsigned>(wanted.channel), one.station = static_cast<unsigned>(wanted.station), one.wanted = QString::fromStdString(wanted.name);
        const auto magazine = live.connected() && one.channel >= 1 && one.channel <= kMaxChannels ? static_cast<std::int32_t>(params::get(live.table(), params::pt_turret_magazine, one.channel)) : 0;
        bool entered = false;          // any tool in this turret
        for (std::size_t i = 0; magazine && i < live.places().count; ++i) entered |= live.places().places[i].magazine == magazine && live.places().places[i].tool != 0;
        const ToolPlace* place = magazine ? placeOf(live, magazine, static_cast<std::int32_t>(one.station)) : nullptr;
        if (const ToolRow* tool = place ? toolOf(live, place->tool) : nullptr) {
            one.tool = place->tool, one.mounted = toolName(*tool, place->tool), one.state = toolWords(*tool);
            one.match = one.mounted.compare(one.wanted, Qt::CaseInsensitive) == 0 ? SheetTool::Match::Same : SheetTool::Match::Other;
        } else if (entered) {
            one.match = SheetTool::Match::Missing;
        }
        out.push_back(std::move(one));
    }
    return out;
}

QString matchText(const SheetTool& tool) {
    switch (tool.match) {
        case SheetTool::Match::Same: return word("mounted");
        case SheetTool::Match::Other: return tool.mounted;
        case SheetTool::Match::Missing: return word("the place is empty");
        case SheetTool::Match::Unknown: break;
    }
    return word("not entered");
}

JobSheet readJobSheet(const QString& path, const std::string& machine, Tongue tongue) {
    JobSheet out;
    out.path = path;
    auto read = text::load_job(path.toStdString());
    if (!read) return out.fault = QString::fromStdString(text_in(read.diagnosis(), tongue)), out;
    out.job = std::move(*read);
    out.otherMachine = for_another_machine(out.job, machine);
    if (out.job.setup.empty()) return out;
    auto setup = text::load_setup(out.job.setup);
    if (setup) out.setup = std::move(*setup);
    else out.setupFault = QString::fromStdString(text_in(setup.diagnosis(), tongue));
    return out;
}

std::vector<JobZero> compareZeros(const Live& live, const JobSheet& sheet) { return job_zeros(sheet.job, sheet.setup, live.config(), storesOf(live)); }
std::vector<JobOffset> compareOffsets(const Live& live, const JobSheet& sheet) { return job_offsets(sheet.setup, live.config(), storesOf(live)); }

QString zeroText(const JobZero& zero) {
    if (std::isnan(zero.entered)) return word("the machine does not have it");
    return zero.same() ? word("entered") : word("entered: %1").arg(zero.entered, 0, 'f', 3);
}

// A tip's direction has no fraction; wear that is 0 on both sides need not be told.
QString offsetText(const JobOffset& offset, OffsetSide side, OffsetPart part, bool all) {
    QStringList out;
    for (const JobOffset::Value& one : offset.values) {
        if (one.wear != (part == OffsetPart::Wear) || (one.same() && (!all || (one.wear && one.wanted == 0)))) continue;
        const double value = side == OffsetSide::Wanted ? one.wanted : one.entered;
        if (std::isnan(value)) return word("the machine does not have it");
        out << fromView(one.name) + " " + QString::number(value, 'f', one.name == "T" ? 0 : 3);
    }
    return out.join("  ");
}

QString jobDiffers(const Live& live, const JobSheet& sheet) {
    QStringList zeros, offsets, out;
    for (const JobZero& one : compareZeros(live, sheet))
        if (!one.same()) zeros << QString("L%1 %2 %3").arg(one.channel).arg(QString::fromStdString(one.system), QString::fromStdString(one.axis));
    unsigned channel = 0;
    for (const JobOffset& one : compareOffsets(live, sheet)) {
        if (one.same()) continue;
        offsets << (one.channel == channel ? QString::number(one.number) : QString("L%1 %2").arg(one.channel).arg(one.number));
        channel = one.channel;
    }
    if (sheet.otherMachine) out << word("The job is for another machine: %1").arg(QFileInfo(QString::fromStdString(sheet.job.machine)).fileName());
    if (!zeros.isEmpty()) out << word("Other zeros than the job's hold: %1").arg(zeros.join(", "));
    if (!offsets.isEmpty()) out << word("Other offsets than the job's hold: %1").arg(offsets.join(", "));
    if (!sheet.setupFault.isEmpty()) out << sheet.setupFault;
    return out.join(".  ");
}

QString sheetText(const Live& live, const JobSheet& sheet) {
    const text::Job& job = sheet.job;
    QString html = QString("<h1>%1</h1><p>%2 &nbsp; %3</p>").arg(QString::fromStdString(job.name).toHtmlEscaped(), QString::fromStdString(live.instance()), momentText(QDateTime::currentDateTime(), "HH:mm"));
    const auto cells = [](const QStringList& texts, const char* tag) {
        QString out = "<tr>";
        for (const QString& one : texts) out += QString("<%1 align='left'>%2</%1>").arg(tag, one.toHtmlEscaped());
        return out + "</tr>";
    };
    const auto headline = [](const QString& text) { return "<h2 style='margin-top:22px; margin-bottom:6px'>" + text + "</h2>"; };
    const auto table = [](const QString& rows) { return "<table border='1' cellspacing='0' cellpadding='5' width='100%'>" + rows + "</table><p style='margin:0; font-size:4pt'>&nbsp;</p>"; };   // a table has no room of its own below
    html += headline(word("Programs"));
    QString rows;
    for (const auto& [channel, program] : job.programs) rows += cells({QString("L%1").arg(channel), QFileInfo(QString::fromStdString(program.file)).fileName(), QString::fromStdString(program.language)}, "td");
    html += table(rows);
    if (job.stock) html += headline(word("Stock")) + "<p>" + QString::fromUtf8("⌀ %1 × %2 %3   %4").arg(job.stock->diameter).arg(job.stock->length).arg(unitWord("mm"), QString::fromStdString(job.stock->spindle)) + "</p>";
    if (sheet.otherMachine) html += headline(word("Machine")) + "<p>" + QFileInfo(QString::fromStdString(job.machine)).fileName().toHtmlEscaped() + ": " + word("not this one") + "</p>";
    if (const auto zeros = compareZeros(live, sheet); !zeros.empty()) {
        html += headline(word("Zeros"));
        rows = cells({word("Channel"), word("Zero"), word("Wanted"), word("Entered")}, "th");
        for (const JobZero& one : zeros) rows += cells({QString("L%1").arg(one.channel), QString::fromStdString(one.system + " " + one.axis), QString::number(one.wanted, 'f', 3), zeroText(one)}, "td");
        html += table(rows);
    }
    html += headline(word("Required tools"));
    rows = cells({word("Channel"), word("Station"), word("Wanted"), word("Mounted"), word("State")}, "th");
    for (const SheetTool& one : compareTools(live, job)) rows += cells({QString("L%1").arg(one.channel), QString::number(one.station), one.wanted, matchText(one), one.state.text}, "td");
    html += table(rows);
    if (const auto offsets = compareOffsets(live, sheet); !offsets.empty()) {
        html += headline(word("Offsets"));
        rows = cells({word("Channel"), word("No."), word("Wanted"), word("Entered")}, "th");
        for (const JobOffset& one : offsets)
            for (const OffsetPart part : {OffsetPart::Geometry, OffsetPart::Wear}) {
                const QString wanted = offsetText(one, OffsetSide::Wanted, part, true), entered = offsetText(one, OffsetSide::Entered, part, false);
                const QString number = part == OffsetPart::Wear ? QString("%1 %2").arg(one.number).arg(word("Wear")) : QString::number(one.number);
                if (!wanted.isEmpty()) rows += cells({QString("L%1").arg(one.channel), number, wanted, entered.isEmpty() ? word("entered") : entered}, "td");
            }
        html += table(rows);
    }
    if (!sheet.setupFault.isEmpty()) html += "<p>" + sheet.setupFault.toHtmlEscaped() + "</p>";
    if (job.parts_wanted) html += headline(word("Parts")) + QString("<p>%1</p>").arg(job.parts_wanted);
    return html;
}

FileOutcome writeSheet(const QString& html, const QString& title, const QString& file, FileProgress& progress, const std::atomic<bool>& stop) {
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
