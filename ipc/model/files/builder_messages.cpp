#include "ipc/model/files/builder_messages.hpp"

#include <charconv>
#include <filesystem>

#include "ipc/model/files/read_file.hpp"

namespace polyturn::text {
namespace {

// Numbers: kernel/plc/lathe/lathe_plc.hpp.
constexpr std::string_view kBuiltIn =
    "number,en,ru,cs,hu,cause,remedy,cause.ru,cause.cs,cause.hu,remedy.ru,remedy.cs,remedy.hu\n"
    "1,the chuck must not open while the spindle turns,патрон нельзя разжать при вращении "
    "шпинделя,sklíčidlo se nesmí otevřít za otáčení vřetena,a tokmány forgó orsónál nem "
    "nyitható,M11 before the spindle was stopped,\"Program M5 before M11.\",M11 до останова "
    "шпинделя,M11 před zastavením vřetena,M11 az orsó megállása előtt,Запрограммируйте M5 "
    "перед M11.,Naprogramujte M5 před M11.,Programozzon M5-öt az M11 elé.\n"
    "2,the spindle must not turn with an open chuck,шпиндель нельзя включить при разжатом "
    "патроне,vřeteno se nesmí otáčet s otevřeným sklíčidlem,az orsó nyitott tokmánnyal nem "
    "foroghat,\"M3, M4 or M19 while the chuck is open\",\"Clamp the workpiece with M10 "
    "first.\",M3 M4 или M19 при разжатом патроне,M3 M4 nebo M19 při otevřeném sklíčidle,M3 "
    "M4 vagy M19 nyitott tokmánynál,Сначала зажмите заготовку: M10.,Nejdřív upněte obrobek: "
    "M10.,Előbb fogja be a munkadarabot: M10.\n"
    "3,the turret has no such station,в револьверной головке нет такой позиции,revolverová "
    "hlava nemá tuto pozici,a revolverfejnek nincs ilyen állása,the T word names a station "
    "beyond PT_TURRET_STATIONS,\"Correct the T word.\",слово T называет позицию больше "
    "PT_TURRET_STATIONS,slovo T udává pozici nad PT_TURRET_STATIONS,a T szó a "
    "PT_TURRET_STATIONS feletti állást nevez meg,Исправьте слово T.,Opravte slovo T.,Javítsa "
    "a T szót.\n"
    "4,no spindle is selected,шпиндель не выбран,není zvoleno žádné vřeteno,nincs "
    "kiválasztott orsó,the channel has no spindle of its own and no driven tool,\"Set N0604 "
    "or PT_DRIVEN_SPINDLE, or select a spindle.\",у канала нет ни своего шпинделя ни "
    "приводного инструмента,kanál nemá vlastní vřeteno ani poháněný nástroj,a csatornának "
    "nincs saját orsója és hajtott szerszáma,Задайте N0604 или PT_DRIVEN_SPINDLE либо "
    "выберите шпиндель.,Zadejte N0604 nebo PT_DRIVEN_SPINDLE anebo zvolte vřeteno.,Adja meg "
    "az N0604-et vagy a PT_DRIVEN_SPINDLE-t; vagy válasszon orsót.\n"
    "5,the spindle did not come to rest or into position,шпиндель не остановился или не "
    "вышел в позицию,vřeteno se nezastavilo nebo nedosáhlo polohy,az orsó nem állt meg vagy "
    "nem ért pozícióba,it took longer than 15 s,\"Look at the drive, the brake and the "
    "encoder.\",прошло больше 15 с,trvalo to déle než 15 s,15 s-nál tovább tartott,Проверьте "
    "привод тормоз и датчик.,Zkontrolujte pohon brzdu a snímač.,Nézze meg a hajtást a féket "
    "és a jeladót.\n"
    "6,the spindle is a C axis now,шпиндель сейчас работает как ось C,vřeteno je nyní osou C,"
    "az orsó most C tengely,\"M3, M4 or M19 while PT_M_C_AXIS holds\",\"Switch back to the "
    "spindle first.\",M3 M4 или M19 пока действует PT_M_C_AXIS,M3 M4 nebo M19 dokud platí "
    "PT_M_C_AXIS,M3 M4 vagy M19 amíg a PT_M_C_AXIS érvényes,Сначала переключитесь обратно на "
    "шпиндель.,Nejdřív přepněte zpět na vřeteno.,Előbb kapcsoljon vissza orsóra.\n"
    "7,the door is open,дверь открыта,dveře jsou otevřené,az ajtó nyitva van,the input "
    "PT_IN_DOOR is off,\"Close the door.\",вход PT_IN_DOOR выключен,vstup PT_IN_DOOR je "
    "vypnutý,a PT_IN_DOOR bemenet ki van kapcsolva,Закройте дверь.,Zavřete dveře.,Csukja be "
    "az ajtót.\n"
    "8,the tailstock must not go back while the spindle turns,пиноль нельзя отвести при "
    "вращении шпинделя,koník nesmí odjet za otáčení vřetena,a szegnyereg forgó orsónál nem "
    "mehet vissza,the workpiece would lose its centre,\"Program M5 first.\",заготовка "
    "осталась бы без центра,obrobek by přišel o hrot,a munkadarab csúcs nélkül maradna,"
    "Сначала запрограммируйте M5.,Nejdřív naprogramujte M5.,Előbb programozzon M5-öt.\n"
    "9,no clamping pressure,нет давления зажима,chybí upínací tlak,nincs szorítónyomás,the "
    "input PT_IN_CHUCK is off,\"Look at the hydraulics.\",вход PT_IN_CHUCK выключен,vstup "
    "PT_IN_CHUCK je vypnutý,a PT_IN_CHUCK bemenet ki van kapcsolva,Проверьте гидравлику.,"
    "Zkontrolujte hydrauliku.,Nézze meg a hidraulikát.\n"
    "10,the bar is used up,пруток закончился,tyč je spotřebovaná,a rúd elfogyott,the input "
    "PT_IN_BAR is off,\"Load a new bar.\",вход PT_IN_BAR выключен,vstup PT_IN_BAR je vypnutý,"
    "a PT_IN_BAR bemenet ki van kapcsolva,Загрузите новый пруток.,Založte novou tyč.,Töltsön "
    "be új rudat.\n"
    "11,the chuck must not clamp while its spindle turns by itself,патрон нельзя зажать пока "
    "его шпиндель вращается сам по себе,sklíčidlo nesmí upnout dokud se jeho vřeteno otáčí "
    "samo,a tokmány nem foghat amíg az orsója magában forog,M10 before the spindle was "
    "synchronous with the one that holds the part,\"Couple the spindles first (PT_M_FOLLOW) "
    "or stop them.\",M10 до синхронизации шпинделя с тем который держит деталь,M10 dříve než "
    "bylo vřeteno synchronní s tím které drží díl,M10 mielőtt az orsó szinkronba került a "
    "darabot tartóval,Сначала свяжите шпиндели (PT_M_FOLLOW) или остановите их.,Nejdřív "
    "spřáhněte vřetena (PT_M_FOLLOW) nebo je zastavte.,Előbb kapcsolja össze az orsókat "
    "(PT_M_FOLLOW) vagy állítsa meg őket.\n"
    "12,the spindle did not become synchronous with its master,шпиндель не вошёл в "
    "синхронизацию с ведущим,vřeteno se nesynchronizovalo s řídicím,az orsó nem került "
    "szinkronba a vezetőjével,it took longer than 15 s,\"Look at PT_SPINDLE_MASTER, the "
    "ramps of both and their speeds.\",прошло больше 15 с,trvalo to déle než 15 s,15 s-nál "
    "tovább tartott,Проверьте PT_SPINDLE_MASTER разгон обоих и их скорости.,Zkontrolujte "
    "PT_SPINDLE_MASTER rozběhy obou a jejich otáčky.,Nézze meg a PT_SPINDLE_MASTER-t "
    "mindkettő felfutását és fordulatát.\n"
    "13,the axis did not leave its fixed stop,ось не отошла от упора,osa neopustila pevný "
    "doraz,a tengely nem hagyta el az ütközőt,the torque limit was taken away and it still "
    "pressed,\"Look at the stop and at PT_STOP_WINDOW.\",предел момента сняли а ось ещё "
    "прижата,mez momentu byla zrušena a osa ještě tlačila,a nyomatékkorlát megszűnt és a "
    "tengely még nyomott,Проверьте упор и PT_STOP_WINDOW.,Zkontrolujte doraz a "
    "PT_STOP_WINDOW.,Nézze meg az ütközőt és a PT_STOP_WINDOW-t.\n"
    "14,the axes were not coupled or exchanged,оси не были связаны или переключены,osy "
    "nebyly spřaženy ani zaměněny,a tengelyek nem kapcsolódtak össze vagy nem cseréltek,one "
    "of them moved longer than PT_COUPLE_TIMEOUT or another request contradicts,\"Enclose "
    "the M code by waiting codes in both channels; end the other coupling first.\",одна из "
    "них двигалась дольше PT_COUPLE_TIMEOUT или другой запрос противоречит,jedna z nich se "
    "pohybovala déle než PT_COUPLE_TIMEOUT nebo jiný požadavek odporuje,az egyik a "
    "PT_COUPLE_TIMEOUT idejénél tovább mozgott vagy más kérés ellentmond,Поставьте коды "
    "ожидания вокруг M-кода в обоих каналах; сначала завершите другую связь.,Obklopte M kód "
    "čekacími kódy v obou kanálech; nejdřív ukončete druhé spřažení.,Fogja közre az M kódot "
    "várakozó kódokkal mindkét csatornában; előbb fejezze be a másik kapcsolatot.\n";

// Cells of one line; a quoted one may hold commas and doubled quotes. false: a quote is not closed.
bool cells_of(std::string_view line, std::vector<std::string>& cells) {
    cells.assign(1, {});
    bool quoted = false;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        if (quoted && c == '"' && i + 1 < line.size() && line[i + 1] == '"') {
            cells.back() += '"';
            ++i;
        } else if (c == '"')
            quoted = !quoted;
        else if (c == ',' && !quoted)
            cells.emplace_back();
        else if (c != '\r')
            cells.back() += c;
    }
    return !quoted;
}

}  // namespace

BuilderMessages::BuilderMessages() { (void)add(kBuiltIn, "built-in PLC"); }

std::vector<Diagnosis> BuilderMessages::add_file(const std::string& path) {
    std::error_code none;
    if (!std::filesystem::exists(path, none)) return {};
    const auto content = read_text_file(path);
    return content ? add(*content, path) : std::vector<Diagnosis>{content.diagnosis()};
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
        if (line.find_first_not_of(" \t\r") == std::string_view::npos || line.front() == '#' ||
            (number_of_line == 1 && line.starts_with("number")))
            continue;
        int number = 0;
        const bool whole = cells_of(line, cells);
        const auto read =
            std::from_chars(cells[0].data(), cells[0].data() + cells[0].size(), number);
        const char* why =
            !whole ? "a quote is not closed"
            : cells.size() != 7 && cells.size() != 13
                ? "seven columns are needed: number, en, ru, cs, hu, cause, remedy; or six "
                  "more: cause and remedy in ru, cs, hu"
            : read.ec != std::errc{} || read.ptr != cells[0].data() + cells[0].size() || number <= 0
                ? "the number must be a whole one from 1"
            : cells[1].empty() ? "the English text is missing"
                               : nullptr;
        if (why) {
            faults.push_back({Alarm::BuilderMessageLine, {name, number_of_line, 0, 0}, {}, why});
            continue;
        }
        cells.resize(13);
        messages_[number] = {{cells[1], cells[2], cells[3], cells[4]},
                             {cells[5], cells[7], cells[8], cells[9]},
                             {cells[6], cells[10], cells[11], cells[12]}};
    }
    return faults;
}

const BuilderMessage* BuilderMessages::find(int number) const {
    const auto found = messages_.find(number);
    return found == messages_.end() ? nullptr : &found->second;
}

std::string BuilderMessages::explain(int number, MessageLanguage language, bool remedy) const {
    static constexpr std::string_view kCause[] = {
        "; cause: ", "; причина: ", "; příčina: ", "; ok: "};
    const BuilderMessage* message = find(number);
    if (!message) return {};
    std::string out = ": ";
    out += message->in(language);
    if (const std::string_view cause = BuilderMessage::own(message->cause, language);
        !cause.empty())
        out += std::string(kCause[static_cast<std::size_t>(language)]).append(cause);
    if (const std::string_view what = BuilderMessage::own(message->remedy, language);
        remedy && !what.empty())
        out.append(". ").append(what);
    return out;
}

std::string BuilderMessages::told_in(std::string text, MessageLanguage language) const {
    std::size_t place = std::string::npos, longest = 0;
    std::string own;
    for (const auto& [number, message] : messages_)
        for (const bool remedy : {true, false})
            for (unsigned spoken = 0; spoken < 4; ++spoken) {
                const std::string told =
                    explain(number, static_cast<MessageLanguage>(spoken), remedy);
                // one message may begin as another one reads
                if (told.size() <= longest) continue;
                const std::size_t at = text.find(told);
                if (at != std::string::npos) {
                    place = at;
                    longest = told.size();
                    own = explain(number, language, remedy);
                }
            }
    if (place != std::string::npos) text.replace(place, longest, own);
    return text;
}

}  // namespace polyturn::text
