#include "hmi/machine/setup_sheet.hpp"

#include <QBuffer>
#include <QDateTime>
#include <QFileInfo>
#include <QPdfWriter>
#include <QTextDocument>
#include <cmath>

#include "polyturn/parameter_handles.hpp"

namespace polyturn::hmi {

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

std::vector<JobZero> compareZeros(const Live& live, const text::Job& job) {
    return job_zeros(job, live.config(), [&](unsigned channel) { return live.connected() ? &live.store(channel) : nullptr; });
}

QString zeroText(const JobZero& zero) {
    if (std::isnan(zero.entered)) return word("the machine does not have it");
    return zero.same() ? word("entered") : word("entered: %1").arg(zero.entered, 0, 'f', 3);
}

QString sheetText(const Live& live, const text::Job& job) {
    QString html = QString("<h1>%1</h1><p>%2 &nbsp; %3</p>").arg(QString::fromStdString(job.name).toHtmlEscaped(), QString::fromStdString(live.instance()), QDateTime::currentDateTime().toString("dd.MM.yyyy HH:mm"));
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
    if (const auto zeros = compareZeros(live, job); !zeros.empty()) {
        html += headline(word("Zeros"));
        rows.clear();
        for (const JobZero& one : zeros) rows += cells({QString("L%1").arg(one.channel), QString::fromStdString(one.system + " " + one.axis), QString::number(one.wanted, 'f', 3), zeroText(one)}, "td");
        html += table(rows);
    }
    html += headline(word("Tools that it needs"));
    rows = cells({word("Channel"), word("Station"), word("Wanted"), word("Mounted"), word("State")}, "th");
    for (const SheetTool& one : compareTools(live, job)) rows += cells({QString("L%1").arg(one.channel), QString::number(one.station), one.wanted, matchText(one), one.state.text}, "td");
    html += table(rows);
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
