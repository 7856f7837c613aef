#include "ipc/diagnosis/os_errors.hpp"

#include <array>
#include <cerrno>
#include <cstring>

namespace polyturn {
namespace {

constexpr auto kErrors = std::to_array<OsErrorRow>({
    {EPERM,
     {"Operation not permitted", "это не разрешено", "tato operace není povolena",
      "ez a művelet nem engedélyezett"}},
    {ENOENT,
     {"No such file or directory", "такого файла или папки нет",
      "takový soubor ani složka neexistuje", "nincs ilyen fájl vagy mappa"}},
    {EIO,
     {"Input/output error", "ошибка ввода-вывода", "chyba vstupu nebo výstupu",
      "be- vagy kiviteli hiba"}},
    {ENXIO,
     {"No such device or address", "такого устройства или адреса нет",
      "takové zařízení ani adresa neexistuje", "nincs ilyen eszköz vagy cím"}},
    {EAGAIN,
     {"Resource temporarily unavailable", "сейчас занято, попробуйте позже",
      "prostředek je dočasně nedostupný", "az erőforrás átmenetileg nem érhető el"}},
    {ENOMEM,
     {"Cannot allocate memory", "не хватает памяти", "nedostatek paměti", "nincs elég memória"}},
    {EACCES,
     {"Permission denied", "нет прав доступа", "přístup odepřen", "a hozzáférés megtagadva"}},
    {EBUSY,
     {"Device or resource busy", "устройство или файл занят", "zařízení nebo soubor se používá",
      "az eszköz vagy fájl foglalt"}},
    {EEXIST, {"File exists", "такой файл уже есть", "soubor už existuje", "a fájl már létezik"}},
    {EXDEV,
     {"Invalid cross-device link", "это на другом диске", "je to na jiném disku",
      "ez másik lemezen van"}},
    {ENODEV,
     {"No such device", "такого устройства нет", "takové zařízení neexistuje",
      "nincs ilyen eszköz"}},
    {ENOTDIR, {"Not a directory", "это не папка", "není to složka", "nem mappa"}},
    {EISDIR, {"Is a directory", "это папка", "je to složka", "ez mappa"}},
    {EINVAL, {"Invalid argument", "так нельзя", "to není možné", "ez így nem lehetséges"}},
    {ENFILE,
     {"Too many open files in system", "на компьютере открыто слишком много файлов",
      "v počítači je otevřeno příliš mnoho souborů", "a számítógépen túl sok fájl van nyitva"}},
    {EMFILE,
     {"Too many open files", "открыто слишком много файлов", "je otevřeno příliš mnoho souborů",
      "túl sok fájl van nyitva"}},
    {ETXTBSY,
     {"Text file busy", "файл сейчас исполняется", "soubor se právě provádí", "a fájl éppen fut"}},
    {EFBIG,
     {"File too large", "файл слишком большой", "soubor je příliš velký", "a fájl túl nagy"}},
    {ENOSPC,
     {"No space left on device", "на диске нет места", "na disku není místo",
      "a lemezen nincs hely"}},
    {EROFS,
     {"Read-only file system", "диск только для чтения", "disk je jen pro čtení",
      "a lemez csak olvasható"}},
    {EPIPE,
     {"Broken pipe", "другая сторона закрыла соединение", "druhá strana zavřela spojení",
      "a másik oldal lezárta a kapcsolatot"}},
    {ENAMETOOLONG,
     {"File name too long", "слишком длинное имя файла", "jméno souboru je příliš dlouhé",
      "a fájl neve túl hosszú"}},
    {ENOTEMPTY,
     {"Directory not empty", "папка не пуста", "složka není prázdná", "a mappa nem üres"}},
    {ELOOP,
     {"Too many levels of symbolic links", "ссылки ведут по кругу", "odkazy vedou v kruhu",
      "a hivatkozások körbe mutatnak"}},
    {EADDRINUSE,
     {"Address already in use", "адрес уже занят", "adresa se už používá", "a cím már foglalt"}},
    {ENETDOWN, {"Network is down", "сеть не работает", "síť nefunguje", "a hálózat nem működik"}},
    {ENETUNREACH,
     {"Network is unreachable", "сеть недоступна", "síť je nedostupná", "a hálózat nem érhető el"}},
    {ECONNABORTED,
     {"Software caused connection abort", "соединение прервано этим компьютером",
      "spojení přerušil tento počítač", "a kapcsolatot ez a számítógép szakította meg"}},
    {ECONNRESET,
     {"Connection reset by peer", "другая сторона оборвала соединение",
      "druhá strana přerušila spojení", "a másik oldal megszakította a kapcsolatot"}},
    {ENOTCONN,
     {"Transport endpoint is not connected", "соединения нет", "spojení není navázáno",
      "nincs kapcsolat"}},
    {ETIMEDOUT,
     {"Connection timed out", "ответа нет слишком долго", "odpověď nepřišla včas",
      "a válasz nem jött meg időben"}},
    {ECONNREFUSED,
     {"Connection refused", "в соединении отказано", "spojení odmítnuto",
      "a kapcsolat elutasítva"}},
    {EHOSTDOWN,
     {"Host is down", "другой компьютер выключен", "druhý počítač je vypnutý",
      "a másik számítógép nem működik"}},
    {EHOSTUNREACH,
     {"No route to host", "к другому компьютеру нет пути", "k druhému počítači nevede cesta",
      "a másik számítógép nem érhető el"}},
    {ESTALE,
     {"Stale file handle", "файл тем временем изменили", "soubor mezitím někdo změnil",
      "a fájlt közben megváltoztatták"}},
    {EDQUOT,
     {"Disk quota exceeded", "место, отведённое на диске, кончилось",
      "přidělené místo na disku je vyčerpáno", "a lemezen kiosztott hely elfogyott"}},
    {EOPNOTSUPP,
     {"Operation not supported", "этот диск или устройство так не умеет",
      "tento disk nebo zařízení to neumí", "ez a lemez vagy eszköz ezt nem tudja"}},
    {ENOMEDIUM,
     {"No medium found", "носителя нет", "není vloženo médium", "nincs behelyezett adathordozó"}},
});

// An error is quoted whole: behind the beginning, a bracket or a colon; before the end, a bracket
// or another one.
bool quoted_whole(std::string_view text, std::size_t at, std::size_t size) {
    const std::string_view before = text.substr(0, at), behind = text.substr(at + size);
    return (before.empty() || before.ends_with('(') || before.ends_with(": ") ||
            before.ends_with("; ")) &&
           (behind.empty() || behind.front() == ')' || behind.front() == ';' ||
            behind.front() == '.');
}

}  // namespace

std::span<const OsErrorRow> os_error_rows() { return kErrors; }

std::string os_error(int number, DisplayLanguage display_language) {
    for (const OsErrorRow& row : kErrors)
        if (row.number == number)
            return std::string(row.in[static_cast<std::size_t>(display_language)]);
    return std::strerror(number);
}

std::string os_errors_in(std::string_view told, DisplayLanguage display_language) {
    std::string out(told);
    for (const OsErrorRow& row : kErrors)
        for (const DisplayLanguage from : kDisplayLanguages) {
            const std::string_view text = row.in[static_cast<std::size_t>(from)],
                                   own = row.in[static_cast<std::size_t>(display_language)];
            if (from == display_language) continue;
            for (std::size_t at = 0; (at = out.find(text, at)) != std::string::npos;) {
                const bool whole = quoted_whole(out, at, text.size());
                if (whole) out.replace(at, text.size(), own);
                at += whole ? own.size() : 1;
            }
        }
    return out;
}

}  // namespace polyturn
