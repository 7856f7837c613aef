#include "ipc/text/builder_messages.hpp"

#include <charconv>
#include <fstream>
#include <sstream>

namespace polyturn::text {
namespace {

// Numbers: kernel/plc/lathe/lathe_plc.hpp.
constexpr std::string_view kBuiltIn = R"(number,en,ru,cs,hu,cause,remedy
1,the chuck must not open while the spindle turns,патрон нельзя открыть при вращении шпинделя,sklíčidlo se nesmí otevřít za otáčení vřetena,a tokmány forgó orsónál nem nyitható,M11 before the spindle was stopped,"Program M5 before M11."
2,the spindle must not turn with an open chuck,шпиндель нельзя включить при открытом патроне,vřeteno se nesmí otáčet s otevřeným sklíčidlem,az orsó nyitott tokmánnyal nem foroghat,"M3, M4 or M19 while the chuck is open","Clamp the workpiece with M10 first."
3,the turret has no such station,в револьверной головке нет такой позиции,revolverová hlava nemá tuto pozici,a revolverfejnek nincs ilyen állása,the T word names a station beyond PT_TURRET_STATIONS,"Correct the T word."
4,no spindle is selected,шпиндель не выбран,není zvoleno žádné vřeteno,nincs kiválasztott orsó,the channel has no spindle of its own and no driven tool,"Set N0604 or PT_DRIVEN_SPINDLE, or select a spindle."
5,the spindle did not come to rest or into position,шпиндель не остановился или не вышел в позицию,vřeteno se nezastavilo nebo nedosáhlo polohy,az orsó nem állt meg vagy nem ért pozícióba,it took longer than 15 s,"Look at the drive, the brake and the encoder."
6,the spindle is a C axis now,шпиндель сейчас работает как ось C,vřeteno je nyní osou C,az orsó most C tengely,"M3, M4 or M19 while PT_M_C_AXIS holds","Switch back to the spindle first."
7,the door is open,дверь открыта,dveře jsou otevřené,az ajtó nyitva van,the input PT_IN_DOOR is off,"Close the door."
8,the tailstock must not go back while the spindle turns,пиноль нельзя отвести при вращении шпинделя,koník nesmí odjet za otáčení vřetena,a szegnyereg forgó orsónál nem mehet vissza,the workpiece would lose its centre,"Program M5 first."
9,no clamping pressure,нет давления зажима,chybí upínací tlak,nincs szorítónyomás,the input PT_IN_CHUCK is off,"Look at the hydraulics."
10,the bar is used up,пруток закончился,tyč je spotřebovaná,a rúd elfogyott,the input PT_IN_BAR is off,"Load a new bar."
11,the chuck must not clamp while its spindle turns by itself,патрон нельзя зажать пока его шпиндель вращается сам по себе,sklíčidlo nesmí upnout dokud se jeho vřeteno otáčí samo,a tokmány nem foghat amíg az orsója magában forog,M10 before the spindle was synchronous with the one that holds the part,"Couple the spindles first (PT_M_FOLLOW) or stop them."
12,the spindle did not become synchronous with its master,шпиндель не вошёл в синхронизацию с ведущим,vřeteno se nesynchronizovalo s řídicím,az orsó nem került szinkronba a vezetőjével,it took longer than 15 s,"Look at PT_SPINDLE_MASTER, the ramps of both and their speeds."
13,the axis did not leave its fixed stop,ось не отошла от упора,osa neopustila pevný doraz,a tengely nem hagyta el az ütközőt,the torque limit was taken away and it still pressed,"Look at the stop and at PT_STOP_WINDOW."
14,the axes were not coupled or exchanged,оси не были связаны или переключены,osy nebyly spřaženy ani zaměněny,a tengelyek nem kapcsolódtak össze vagy nem cseréltek,one of them moved longer than PT_COUPLE_TIMEOUT or another request contradicts,"Enclose the M code by waiting codes in both channels; end the other coupling first."
)";

// Cells of one line; a quoted one may hold commas and doubled quotes. false: a quote is not closed.
bool cells_of(std::string_view line, std::vector<std::string>& cells) {
    cells.assign(1, {});
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') cells.back() += '"', ++i;
        else if (c == '"') quoted = !quoted;
        else if (c == ',' && !quoted) cells.emplace_back();
        else if (c != '\r') cells.back() += c;
    }
    return !quoted;
}

}  // namespace

BuilderMessages::BuilderMessages() { (void)add(kBuiltIn, "built-in PLC"); }

std::vector<Diagnosis> BuilderMessages::add_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    std::ostringstream content;
    content << file.rdbuf();
    return add(content.str(), path);
}

std::vector<Diagnosis> BuilderMessages::add(std::string_view content, const std::string& name) {
    std::vector<Diagnosis> faults;
    std::vector<std::string> cells;
    std::uint32_t number_of_line = 0;
    while (!content.empty()) {
        const auto end = content.find('\n');
        const std::string_view line = content.substr(0, end);
        content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
        ++number_of_line;
        if (line.find_first_not_of(" \t\r") == std::string_view::npos || line.front() == '#' || (number_of_line == 1 && line.starts_with("number"))) continue;
        int number = 0;
        const bool whole = cells_of(line, cells);
        const auto read = std::from_chars(cells[0].data(), cells[0].data() + cells[0].size(), number);
        const char* why = !whole ? "a quote is not closed" : cells.size() != 7 ? "seven columns are needed: number, en, ru, cs, hu, cause, remedy"
                        : read.ec != std::errc{} || read.ptr != cells[0].data() + cells[0].size() || number <= 0 ? "the number must be a whole one from 1"
                        : cells[1].empty() ? "the English text is missing" : nullptr;
        if (why) {
            faults.push_back({Alarm::BuilderMessageLine, {name, number_of_line, 0, 0}, {}, why});
            continue;
        }
        messages_[number] = {{cells[1], cells[2], cells[3], cells[4]}, cells[5], cells[6]};
    }
    return faults;
}

const BuilderMessage* BuilderMessages::find(int number) const {
    const auto found = messages_.find(number);
    return found == messages_.end() ? nullptr : &found->second;
}

std::string BuilderMessages::explain(int number, MessageLanguage language) const {
    const BuilderMessage* message = find(number);
    if (!message) return {};
    std::string out = ": ";
    out += message->in(language);
    if (!message->cause.empty()) out += "; cause: " + message->cause;
    if (!message->remedy.empty()) out += ". " + message->remedy;
    return out;
}

}  // namespace polyturn::text
