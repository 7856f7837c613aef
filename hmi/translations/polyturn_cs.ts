<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="cs_CZ" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it cutting</source>
        <translation>  z toho řez</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it rapid</source>
        <translation>  z toho rychloposuv</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it waiting</source>
        <translation>  z toho čekání</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>%1 a part</source>
        <translation>%1 na kus</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>%1 ago</source>
        <translation>před %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1 by %2: straightness</source>
        <translation>%1 podle %2: přímost</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 cannot be the name of a program</source>
        <translation>%1 nemůže být jménem programu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 has a new insert: its life begins anew, the wear of its offset stays</source>
        <translation>%1 má novou destičku: životnost začíná znovu, opotřebení její korekce zůstává</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 has a new insert: life and wear begin anew</source>
        <translation>%1 má novou destičku: životnost a opotřebení začínají znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 has values again: they stay</source>
        <translation>%1 má zase hodnoty: zůstanou</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>%1 in all</source>
        <translation>celkem %1</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 interrupted</source>
        <translation>přerušeno: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1 is %2 by now: it stays</source>
        <translation>%1: nyní je %2, zůstává</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>%1 is being opened</source>
        <translation>%1 se otevírá</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>%1 is being read: the place answers slowly</source>
        <translation>%1 se čte: místo odpovídá pomalu</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>%1 is being written: the place answers slowly</source>
        <translation>%1 se zapisuje: místo odpovídá pomalu</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is deleted</source>
        <translation>%1 je smazán</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>%1 is logged in</source>
        <translation>%1 je přihlášen</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is new</source>
        <translation>Nový břit: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>%1 is not such a value</source>
        <translation>%1 sem nepatří</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is not there any more</source>
        <translation>%1 už není k dispozici</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected</source>
        <translation>%1 je chráněn</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected by F3202</source>
        <translation>%1 chrání parametr F3202</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected: a login of a higher level may change it</source>
        <translation>%1 je chráněn: měnit smí přihlášení s vyšší úrovní</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is read-only</source>
        <translation>%1 je jen pro čtení</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected</source>
        <translation>Zvoleno: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected in L%2</source>
        <translation>%1 zvolen v L%2</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected in its channels</source>
        <translation>%1 zvoleno ve svých kanálech</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 is taken out</source>
        <translation>%1 je vyjmut</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is there again</source>
        <translation>%1 je zase zde</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is there already</source>
        <translation>%1 už existuje</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>%1 of %2</source>
        <translation>%1 z %2</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 run</source>
        <translation>běží: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>%1 s after the start of the controller</source>
        <translation>%1 s po startu řízení</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 stand</source>
        <translation>stojí: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 stands in %2</source>
        <translation>%1 stojí v %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>%1 too long</source>
        <translation>zpožděných: %1</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 wait</source>
        <translation>čekají: %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>%1 waits for nobody, nobody waits for it: press again</source>
        <translation>%1 na nikoho nečeká, nikdo na něj: stiskněte znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>%1 was refused: %2</source>
        <translation>%1: odmítnuto: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: acts as soon as the axes rest</source>
        <translation>%1: platí, jakmile se osy zastaví</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1: another value stands there by now, it stays</source>
        <translation>%1: mezitím je tam jiná hodnota, zůstane</translation>
    </message>
    <message>
        <location filename="../widgets/pictures/magazine.cpp"/>
        <source>%1: choose its place, Enter puts it there, Escape leaves it</source>
        <translation>%1: zvolte místo, Enter ho tam dá, Escape nechá být</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: gradient</source>
        <translation>%1: gradient</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1: no program is selected</source>
        <translation>%1: není zvolen žádný program</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: periodic</source>
        <translation>%1: periodická</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: pitch</source>
        <translation>%1: chyba stoupání</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: pitch, negative direction</source>
        <translation>%1: chyba stoupání, záporný směr</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>%1: start goes on</source>
        <translation>%1: start pokračuje</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>%1; %2: not so</source>
        <translation>%1; %2: ne</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>(limited)</source>
        <translation>(omezeno)</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>+ Input</source>
        <translation>+ Zadat</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>0.1 lead</source>
        <translation>0.1 stoupání</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>1/10 lead</source>
        <translation>1/10 stoup.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>1/100 s</source>
        <translation>1/100 s</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>1/K</source>
        <translation>1/K</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>1/min</source>
        <translation>ot/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>1/s</source>
        <translation>1/s</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>2 to 30 a second</source>
        <translation>2 až 30 za sekundu</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>250 to 1000 ms</source>
        <translation>250 až 1000 ms</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>5 Axis Machining</source>
        <translation>5osé obrábění</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A block by hand (MDI)</source>
        <translation>Blok ručně (MDI)</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>A block entered by hand waits: start runs it</source>
        <translation>Čeká ručně zadaný blok: start jej provede</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>A part of a long program: lines %1 to %2, %3 % of it. «Check, waits» looks for faults in all of it.</source>
        <translation>Část dlouhého programu: řádky %1 až %2, %3 % z něj. „Kontrola, čekání“ prohlédne celý program.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A program is held: «Jog in hold %1» lets its axes be moved</source>
        <translation>Program je zastaven: osami se jezdí klávesou «Ruční pojezd v zastavení %1»</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A program runs: axes are moved by hand in a hold, after «Jog in hold»</source>
        <translation>Běží program: ručně se osy posouvají při zastavení, po „Ruční pojezd v zastavení“</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>A program works with it: press again</source>
        <translation>Program s ní pracuje: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>A value is needed here.</source>
        <translation>Zde je nutná hodnota.</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Není</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Acceleration</source>
        <translation>Zrychlení</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Accept proposal</source>
        <translation>Přijmout návrh</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Active</source>
        <translation>Aktivní</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Active alarms</source>
        <translation>Aktivní alarmy</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active at the next T</source>
        <translation>Od dalšího T</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active at the next T or D</source>
        <translation>Od dalšího T nebo D</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active from the next blocks</source>
        <translation>Od dalších bloků</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add a line</source>
        <translation>Přidat úsečku</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add an arc G2</source>
        <translation>Přidat oblouk G2</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add an arc G3</source>
        <translation>Přidat oblouk G3</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Addresses by DHCP</source>
        <translation>Adresy z DHCP</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>After</source>
        <translation>Poté</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Alarm</source>
        <translation>Alarm</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.hpp"/>
        <source>Alarms</source>
        <translation>Alarmy</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>All are at their blocks: start makes the approach</source>
        <translation>Všechny jsou u svých bloků: start zahájí nájezd</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>All axes move: press again</source>
        <translation>Pojedou všechny osy: stiskněte znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>All channels</source>
        <translation>Všechny kanály</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>All from their last tool call</source>
        <translation>Vše od volání nástroje</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>All groups</source>
        <translation>Všechny skupiny</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>All tables</source>
        <translation>Všechny tabulky</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>All tools</source>
        <translation>Všechny nástroje</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>All zeros together</source>
        <translation>Součet posunutí</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Along</source>
        <translation>Podél</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Along axis</source>
        <translation>Podél osy</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>An alarm has ended the lock for cleaning.</source>
        <translation>Alarm ukončil zámek pro čištění.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>An arc turns through less than 360°.</source>
        <translation>Oblouk má méně než 360°.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle at its end to +Z</source>
        <translation>Úhel na konci k +Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle at its start to +Z</source>
        <translation>Úhel na začátku k +Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle between two holes; 0: evenly spread</source>
        <translation>Úhel mezi děrami; 0: rovnoměrně</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle it turns through</source>
        <translation>Úhel oblouku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle of the first hole to the 1st axis</source>
        <translation>Úhel první díry k 1. ose</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Angle of the infeed</source>
        <translation>Úhel přísuvu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle of the line to the 1st axis</source>
        <translation>Úhel přímky k 1. ose</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Angle of the spindle at the start</source>
        <translation>Úhel vřetena na začátku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Angle of the tool tip</source>
        <translation>Úhel špičky nástroje</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle to +Z</source>
        <translation>Úhel k +Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Another cycle</source>
        <translation>Jiný cyklus</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Applied now</source>
        <translation>Nyní platí</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Arc G2</source>
        <translation>Oblouk G2</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Arc G3</source>
        <translation>Oblouk G3</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Automatika</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Axes</source>
        <translation>Osy</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Axes and drives</source>
        <translation>Osy a pohony</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Axes are moved by hand while the machine is on</source>
        <translation>Osy se posouvají ručně při zapnutém stroji</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Axes of L%1</source>
        <translation>Osy L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Axis</source>
        <translation>Osa</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Config</source>
        <translation>Osy</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Limits</source>
        <translation>Meze os</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Recomposition</source>
        <translation>Výměna os</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Servo</source>
        <translation>Pohony os</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Back</source>
        <translation>Zpět</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Back to the text</source>
        <translation>Zpět k textu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Backup</source>
        <translation>Záloha</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Backups</source>
        <translation>Zálohy</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Barrel thread on an arc, clockwise</source>
        <translation>Soudkový závit po oblouku, po směru hodin</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Barrel thread on an arc, counter-clockwise</source>
        <translation>Soudkový závit po oblouku, proti směru hodin</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Base</source>
        <translation>Báze</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Base R</source>
        <translation>Báze R</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Base lengths</source>
        <translation>Základní délky</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Before</source>
        <translation>Před</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Begins anew, stood in line %1: press again</source>
        <translation>Začne znovu (stál na řádku %1): znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Vypuštění bloků</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Block skip %1</source>
        <translation>Vypuštění bloků %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Blocks are entered in MDI, or while a program is held</source>
        <translation>Bloky se zadávají v MDI nebo při zastaveném programu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring</source>
        <translation>Vyvrtávání</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring in the face</source>
        <translation>Vyvrtávání na čele</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring in the side</source>
        <translation>Vyvrtávání z boku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring with a dwell</source>
        <translation>Vyvrtávání s prodlevou</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring, back with the spindle stopped</source>
        <translation>Vyvrtávání, návrat se stojícím vřetenem</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom X</source>
        <translation>Dno X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom Z</source>
        <translation>Dno Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom of the hole X</source>
        <translation>Dno díry X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole X, or the end of the way back</source>
        <translation>Dno díry X, nebo konec zpětné dráhy</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom of the hole Z</source>
        <translation>Dno díry Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole Z, or the end of the way back</source>
        <translation>Dno díry Z, nebo konec zpětné dráhy</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole, where no depth is told</source>
        <translation>Dno díry, není-li zadána hloubka</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Bring the axes to a free place first. Touch one of these blocks twice, press Enter on it, or type its number: the program restarts there. «Restart» reads to it without moving, with all waits replayed. The first start shows what comes; the second one does it: tool, functions, axes, and it cuts.</source>
        <translation>Nejdřív odjeďte osami na volné místo! Dotkněte se dvakrát jednoho z těchto bloků (nebo Enter), nebo zadejte jeho číslo: program začne tam. „Restart“ k němu čte bez pohybu a přehraje všechna čekání. První start ukáže, co následuje; druhý to provede: nástroj, funkce, osy, pak obrábění.</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Broken</source>
        <translation>Zlomený</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Calibrate</source>
        <translation>Kalibrovat</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Calibrated: %1 µm a pixel, tilted by %2°</source>
        <translation>Zkalibrováno: %1 µm na pixel, náklon %2°</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Call %1</source>
        <translation>Vyvolat %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Called by</source>
        <translation>Vyvolání</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Cannot be written: %1</source>
        <translation>Nelze zapsat: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Cause</source>
        <translation>Příčina</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Cell %1</source>
        <translation>Buňka %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Centre X</source>
        <translation>Střed X</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Centre Z</source>
        <translation>Střed Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Centre from the start point X (radius)</source>
        <translation>Střed od počátku X (poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Centre from the start point Z</source>
        <translation>Střed od počátku Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Centre of the circle, 1st axis (X: radius)</source>
        <translation>Střed kružnice, 1. osa (X: poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Centre of the circle, 2nd axis (X: radius)</source>
        <translation>Střed kružnice, 2. osa (X: poloměr)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Chamfer or rounding has no room here.</source>
        <translation>Pro sražení nebo zaoblení není místo.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Chamfer to the next one</source>
        <translation>Sražení k dalšímu</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Change</source>
        <translation>Změnit</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Change of the lead a revolution</source>
        <translation>Změna stoupání na otáčku</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Changed</source>
        <translation>Změněno</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Changed only</source>
        <translation>Jen změněné</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Changes of %1</source>
        <translation>Změny: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Channel</source>
        <translation>Kanál</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Check, waits</source>
        <translation>Kontrola, čekání</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Choose a backup: «What would change» compares it with the machine, and nothing is changed yet.</source>
        <translation>Zvolte zálohu: „Co by se změnilo“ ji porovná se strojem a nic zatím nemění.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Choose a cycle: touch it twice, or Enter.</source>
        <translation>Zvolte cyklus: dotkněte se dvakrát, nebo Enter.</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>Choose a field</source>
        <translation>Zvolte pole</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Choose a job or a program</source>
        <translation>Zvolte zakázku nebo program</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Choose a picture of the tool's shadow</source>
        <translation>Zvolte snímek stínu nástroje</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Choose a signal; type a part of its name</source>
        <translation>Zvolte signál; napište část názvu</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Choose signal</source>
        <translation>Zvolit signál</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Chuck S%1</source>
        <translation>Sklíčidlo S%1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Chuck zone of L%1</source>
        <translation>Zóna sklíčidla L%1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Chuck/Tailstock Barrier</source>
        <translation>Zóny sklíčidla a koníku</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Circularity</source>
        <translation>Kruhovitost</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Circularity error</source>
        <translation>Odchylka kruhovitosti</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Clear</source>
        <translation>Smazat dráhy</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Clear search</source>
        <translation>Smazat hledání</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Clearance before the next peck</source>
        <translation>Vůle před dalším krokem</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Close</source>
        <translation>Zavřít</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Commanded</source>
        <translation>Požadovaná</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Compare</source>
        <translation>Porovnat</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Comparison</source>
        <translation>Porovnání</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Compensation</source>
        <translation>Kompenzace</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Compensation tables</source>
        <translation>Kompenzační tabulky</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Computer</source>
        <translation>Počítač</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Computing time of ticks</source>
        <translation>Doba výpočtu taktů</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Confirm the loss</source>
        <translation>Potvrdit ztrátu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Confirmed: production goes on with what is left</source>
        <translation>Potvrzeno: výroba pokračuje s tím, co zbylo</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Continuous</source>
        <translation>Plynule</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Contour</source>
        <translation>Obrys</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Coordinates</source>
        <translation>Souřadnice</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Copied and compared</source>
        <translation>Zkopírováno a ověřeno</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Copy to here</source>
        <translation>Kopírovat sem</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Copy, delete ...</source>
        <translation>Kopie, mazání ...</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Core diameter at the end</source>
        <translation>Průměr jádra na konci</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Corrected</source>
        <translation>Opravuje</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Corrected axis</source>
        <translation>Opravovaná osa</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Correction</source>
        <translation>Kompenzace</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Couplings</source>
        <translation>Vazby</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Couplings and exchanges</source>
        <translation>Vazby a výměny os</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Cutting</source>
        <translation>Řez</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cutting time</source>
        <translation>Doba řezu</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Cyklus</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Cycle form</source>
        <translation>Formulář cyklu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cycle last, mean</source>
        <translation>Poslední cyklus, průměr</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cycle now</source>
        <translation>Aktuální cyklus</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Tmavý</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Date and time</source>
        <translation>Datum a čas</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Decides the time</source>
        <translation>Kritická cesta</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Default</source>
        <translation>Výchozí</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Default value</source>
        <translation>Výchozí hodnota</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Delete</source>
        <translation>Smazat</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Delete all</source>
        <translation>Smazat vše</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Delete edge</source>
        <translation>Smazat břit</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Delete the element</source>
        <translation>Smazat prvek</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Delete tool</source>
        <translation>Smazat nástroj</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Delete user</source>
        <translation>Smazat uživatele</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Deleted</source>
        <translation>Smazáno</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Depends on</source>
        <translation>Závisí na</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Depth below the surface, instead of the bottom</source>
        <translation>Hloubka pod povrchem místo dna</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck</source>
        <translation>Hloubka kroku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck along X (radius)</source>
        <translation>Hloubka kroku v X (poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck along Z</source>
        <translation>Hloubka kroku v Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of a peck; 0: tapping</source>
        <translation>Hloubka kroku; 0: závitování</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of cut</source>
        <translation>Hloubka řezu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of cut (radius)</source>
        <translation>Hloubka řezu (poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of cut along Z</source>
        <translation>Hloubka řezu v Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of the first pass (radius)</source>
        <translation>Hloubka prvního řezu (poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of the hole</source>
        <translation>Hloubka díry</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Deviation</source>
        <translation>Odchylka</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.hpp"/>
        <source>Diagnosis</source>
        <translation>Diagnostika</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Diameter</source>
        <translation>Průměr</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Diameter at the end</source>
        <translation>Průměr na konci</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Diameter of the pin</source>
        <translation>Průměr kolíku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Diameter of this pass at the end</source>
        <translation>Průměr tohoto řezu na konci</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Difference</source>
        <translation>Rozdíl</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Differences: %1</source>
        <translation>Rozdílů: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Differs from file</source>
        <translation>Jiné než soubor</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Dimension</source>
        <translation>Rozměr</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Do this step</source>
        <translation>Provést krok</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling</source>
        <translation>Vrtání</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Drilling Cycles</source>
        <translation>Vrtací cykly</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Drilling and tapping</source>
        <translation>Vrtání a závitování</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling in the face</source>
        <translation>Vrtání na čele</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling in the side</source>
        <translation>Vrtání z boku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling with a dwell</source>
        <translation>Vrtání s prodlevou</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling with pecks</source>
        <translation>Vrtání s výplachem</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling, breaking chips</source>
        <translation>Vrtání s lámáním třísky</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, centring (in G17 along Z)</source>
        <translation>Vrtání, navrtávání (v G17 podél Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, centring behind each block that moves</source>
        <translation>Vrtání, navrtávání za každým blokem s pohybem</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, counterboring (in G17 along Z)</source>
        <translation>Vrtání, zahlubování (v G17 podél Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, counterboring behind each block that moves</source>
        <translation>Vrtání, zahlubování za každým blokem s pohybem</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Drive fault</source>
        <translation>Porucha pohonu</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Chod naprázdno</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Dry run %1</source>
        <translation>Chod naprázdno %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Dwell</source>
        <translation>Prodleva</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Dwell at the bottom</source>
        <translation>Prodleva na dně</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Dwell at the bottom; negative: revolutions</source>
        <translation>Prodleva na dně; záporná: otáčky</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Edge D</source>
        <translation>Břit D</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Edit</source>
        <translation>Upravit</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Editor</source>
        <translation>Editor</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Effect</source>
        <translation>Působení</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Electronic Gear Box</source>
        <translation>Elektronická převodovka</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Emergency stop</source>
        <translation>Nouzové zastavení</translation>
    </message>
    <message>
        <location filename="../widgets/text_entry.cpp"/>
        <source>Empty</source>
        <translation>Vymazat</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Empty the field</source>
        <translation>Vymazat pole</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End of the thread Z</source>
        <translation>Konec závitu Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End of the way back X</source>
        <translation>Konec zpětné dráhy X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End of the way back Z</source>
        <translation>Konec zpětné dráhy Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>End point X</source>
        <translation>Koncový bod X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End point X of the last plunge</source>
        <translation>Koncový bod X posledního zápichu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End point X, where the thread is tapered</source>
        <translation>Koncový bod X, je-li závit kuželový</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>End point Z</source>
        <translation>Koncový bod Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End point Z of the last plunge</source>
        <translation>Koncový bod Z posledního zápichu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End point Z, where the thread is tapered</source>
        <translation>Koncový bod Z, je-li závit kuželový</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>End with this part</source>
        <translation>Konec po tomto kusu</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Ukončen</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Ukončí vše: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Ukončí program: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends the programs of the group: press again</source>
        <translation>Ukončí celou skupinu: znovu</translation>
    </message>
    <message>
        <location filename="../widgets/text_pad.cpp"/>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Enter it</source>
        <translation>Zapsat</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Enter logs in. A new user gets this name, this password and the level %1.</source>
        <translation>Enter přihlásí. Nový uživatel dostane toto jméno, toto heslo a úroveň %1.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Enter takes the block first</source>
        <translation>Nejprve blok převezměte klávesou Enter</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Enter takes the block, Start runs it</source>
        <translation>Enter blok převezme, start provede</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Enter the start point, then add lines and arcs with what the drawing says.</source>
        <translation>Zadejte počáteční bod, pak přidávejte úsečky a oblouky podle výkresu.</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Enter zeros, offsets</source>
        <translation>Zadat nuly, korekce</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Enter, or a second touch, changes it.</source>
        <translation>Enter nebo druhý dotyk to změní.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Entered</source>
        <translation>Skutečné</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Enters the relative counter: press again</source>
        <translation>Zapíše počítadlo: znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Enters what was touched: press again</source>
        <translation>Zapíše dotyk: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Every axis and spindle is on its own: nothing is coupled, exchanged or followed.</source>
        <translation>Každá osa a vřeteno je samostatné: žádná vazba, výměna ani sledování.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Everything becomes as then: press again</source>
        <translation>Vše bude jako tehdy: znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Exchange</source>
        <translation>Vyměnit</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Exchange with it</source>
        <translation>Vyměnit s ním</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>External</source>
        <translation>Externí</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>F11, or the key at the top: the next one</source>
        <translation>F11 nebo tlačítko nahoře: další</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Face Z</source>
        <translation>Čelo Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Facing a straight section</source>
        <translation>Čelní soustružení přímého úseku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Facing an arc</source>
        <translation>Čelní soustružení oblouku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Facing, one pass</source>
        <translation>Čelo, jeden řez</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Factor</source>
        <translation>Násobek</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Factor of the pecks; tapping: kind 0, 1, 2</source>
        <translation>Činitel kroků; závitování: druh 0, 1, 2</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor axes</source>
        <translation>Fagor: osy</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor general</source>
        <translation>Fagor: obecné</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor spindle</source>
        <translation>Fagor: vřeteno</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc B axis</source>
        <translation>Fanuc: osa B</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc axes</source>
        <translation>Fanuc: osy</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc cycles</source>
        <translation>Fanuc: cykly</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc interfaces</source>
        <translation>Fanuc: rozhraní</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc macros</source>
        <translation>Fanuc: makra</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc offsets</source>
        <translation>Fanuc: korekce</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc programs</source>
        <translation>Fanuc: programy</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Faster</source>
        <translation>Rychleji</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Feed</source>
        <translation>Posuv</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Feed hold</source>
        <translation>Zastavení posuvu</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Stop posuvu: start pokračuje</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed into hollows</source>
        <translation>Posuv do prohlubní</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed of finishing</source>
        <translation>Posuv dokončování</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Feed of finishing, where the contour says none</source>
        <translation>Posuv dokončování, není-li v obrysu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Feed of roughing</source>
        <translation>Posuv hrubování</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed of the last roughing pass</source>
        <translation>Posuv posledního hrubovacího řezu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed on the way in</source>
        <translation>Posuv při cestě dovnitř</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed on the way out</source>
        <translation>Posuv při cestě ven</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed: lead times speed</source>
        <translation>Posuv: stoupání krát otáčky</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Feedrate</source>
        <translation>Posuv</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Field</source>
        <translation>Údaj</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Files</source>
        <translation>Soubory</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Filter</source>
        <translation>Filtr</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Finishing a contour</source>
        <translation>Dokončení obrysu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance</source>
        <translation>Přídavek na dokončení</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance X</source>
        <translation>Přídavek na dokončení X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance Z</source>
        <translation>Přídavek na dokončení Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Finishing passes</source>
        <translation>Dokončovacích řezů</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>First WINS server</source>
        <translation>První WINS</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>First block of the contour</source>
        <translation>První blok obrysu</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>First name server</source>
        <translation>První DNS</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>First part</source>
        <translation>První kus</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>First part %1</source>
        <translation>První kus %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>První kus: start pokračuje tímto nástrojem</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>First to stop the machine: %1; parts until then: %2</source>
        <translation>První zastaví stroj: %1; kusů do té doby: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Follow. error</source>
        <translation>Vlečná chyba</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>For the offset and the gauge pin</source>
        <translation>Pro korekci a kalibrační kolík</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Forget place</source>
        <translation>Zapomenout místo</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Found: %1</source>
        <translation>Nalezeno: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Free</source>
        <translation>Volné</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>From</source>
        <translation>Od</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>From hole to hole</source>
        <translation>Od díry k díře</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>From rapid to feed (R level)</source>
        <translation>Přechod na posuv (úroveň R)</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>From the beginning</source>
        <translation>Od začátku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>From the start to the first hole</source>
        <translation>Od počátku k první díře</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Full torque</source>
        <translation>Plný moment</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>G code</source>
        <translation>kód G</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Gateway</source>
        <translation>Brána</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Geom.</source>
        <translation>Geom.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Geometry + wear</source>
        <translation>Geometrie + opotř.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Give this level</source>
        <translation>Přidělit úroveň</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Given</source>
        <translation>Zadáno</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Goes back to its own place</source>
        <translation>Vrací se na vlastní místo</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Gradient Compensation</source>
        <translation>Korekce sklonu</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Graphics</source>
        <translation>Grafika</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Greatest, least deviation</source>
        <translation>Největší, nejmenší odchylka</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Grooving along X</source>
        <translation>Zapichování v X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Grooving along Z</source>
        <translation>Zapichování v Z</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Group %1</source>
        <translation>Skupina %1</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Handbook</source>
        <translation>Příručka</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Ruční kolečko</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Handwheel offset</source>
        <translation>Posun kolečkem</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Height of the thread (radius)</source>
        <translation>Výška závitu (poloměr)</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Held</source>
        <translation>Pozastaven</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Help</source>
        <translation>Nápověda</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Highest bar: %1 of %2 ticks; both scales are logarithmic</source>
        <translation>Nejvyšší sloupec: %1 z %2 taktů; obě stupnice jsou logaritmické</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>History</source>
        <translation>Historie</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Hold %1</source>
        <translation>Stop posuvu %1</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Hold all</source>
        <translation>Stop posuvu: vše</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Hold group %1</source>
        <translation>Stop posuvu: skupina %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>How</source>
        <translation>Jak</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>How long</source>
        <translation>Trvání</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Ignore waits %1</source>
        <translation>Bez čekání %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>In position</source>
        <translation>V poloze</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>In the file</source>
        <translation>V souboru</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>In this magazine</source>
        <translation>V tomto zásobníku</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Increment in X (radius)</source>
        <translation>Přírůstek v X (poloměr)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Increment in Z</source>
        <translation>Přírůstek v Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Input</source>
        <translation>Zadat</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Přerušen</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Interval meter</source>
        <translation>Intervalový časovač</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>It acts at once: press again</source>
        <translation>Působí ihned: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>It cannot be read: %1</source>
        <translation>Nelze číst: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>It cannot be shown.</source>
        <translation>Nelze zobrazit.</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>It comes by DHCP (N5108)</source>
        <translation>Přichází z DHCP (N5108)</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>It follows the main spindle</source>
        <translation>Protivřeteno sleduje hlavní vřeteno</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>It gave no result.</source>
        <translation>Nedal výsledek.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>It is entered</source>
        <translation>Zapsáno</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>It is gone for good: press again</source>
        <translation>Zmizí navždy: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>It is gone: press again</source>
        <translation>Bude pryč: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>It is no text in UTF-8: it cannot be edited without a loss.</source>
        <translation>Není to text v UTF-8: nelze upravit beze ztráty.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>It is the gauge pin: press again</source>
        <translation>Je to kolík: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>It runs now: press again</source>
        <translation>Právě běží: znovu</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>It was stopped.</source>
        <translation>Bylo to zastaveno.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Its blocks were edited by hand: writing replaces them.</source>
        <translation>Bloky byly změněny ručně: zápis je nahradí.</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Its chuck clamps</source>
        <translation>Sklíčidlo protivřetena upne</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Its chuck opens</source>
        <translation>Sklíčidlo protivřetena se otevře</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Its data contradict each other, or nothing fits them.</source>
        <translation>Údaje si odporují, nebo jim nic nevyhovuje.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Its values go: press again</source>
        <translation>Hodnoty zmizí: znovu</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Ruční</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Jog against the part</source>
        <translation>Přijet k dílu</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Jog in hold %1</source>
        <translation>Ruční pojezd v zastavení %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Jog keys</source>
        <translation>Klávesy os</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Jog: pull the part out</source>
        <translation>Vytáhnout díl</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Keep as place</source>
        <translation>Uložit místo</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Kept, but: %1</source>
        <translation>Uloženo, ale: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Kept: %1</source>
        <translation>Uloženo: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Keyboard</source>
        <translation>Klávesnice</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Keyboard layout</source>
        <translation>Rozložení kláves</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Kind</source>
        <translation>Druh</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Kind of infeed</source>
        <translation>Druh přísuvu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Kind of place that it needs, 0 any</source>
        <translation>Druh potřebného místa, 0 libovolné</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Kind: 500 roughing, 510 finishing, 200 drill ...</source>
        <translation>Druh: 500 hrubovací, 510 dokončovací, 200 vrták ...</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>L%1 asks: %2</source>
        <translation>L%1 se ptá: %2</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>L%1 decides %2 of %3: what becomes shorter there shortens the cycle.</source>
        <translation>L%1 určuje %2 z %3: co se zkrátí tam, zkrátí cyklus.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>L%1 is in automatic mode: choose Jog or MDI</source>
        <translation>L%1 je v automatice: zvolte Ruční nebo MDI</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>L%1: restart at block</source>
        <translation>L%1: začít od bloku</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>L%1: straightness, pair %2</source>
        <translation>L%1: přímost, dvojice %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>L%1: volume</source>
        <translation>L%1: objem</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Lag</source>
        <translation>Vl. chyba</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Language of the screens</source>
        <translation>Jazyk obrazovek</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Larger</source>
        <translation>Zvětšit</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Largest</source>
        <translation>Největší</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Largest speed</source>
        <translation>Největší otáčky</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Last</source>
        <translation>Poslední</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Last block of the contour</source>
        <translation>Poslední blok obrysu</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Last tool call</source>
        <translation>Volání nástroje</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Later</source>
        <translation>Později</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Lead</source>
        <translation>Stoupání</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead along X</source>
        <translation>Stoupání podél X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead along Z</source>
        <translation>Stoupání podél Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead as on the way in</source>
        <translation>Stoupání jako při cestě dovnitř</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead; negative: a left-hand thread</source>
        <translation>Stoupání; záporné: levý závit</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Least depth of a pass</source>
        <translation>Nejmenší hloubka řezu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Least depth of a peck</source>
        <translation>Nejmenší hloubka kroku</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Length</source>
        <translation>Délka</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Length of the run-out</source>
        <translation>Délka výběhu</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Level</source>
        <translation>Úroveň</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life</source>
        <translation>Životnost</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Life and forecast</source>
        <translation>Životnost a výhled</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life and wear to 0: press again</source>
        <translation>Životnost a opotřebení na 0: znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Life group of programs</source>
        <translation>Skupina životnosti programů</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Life left</source>
        <translation>Zbývá životnosti</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Life measured in</source>
        <translation>Jednotka životnosti</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Life nearly over</source>
        <translation>Životnost končí</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life to 0, wear stays: press again</source>
        <translation>Životnost na 0, ne opotřebení: znovu</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Světlý</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Line</source>
        <translation>Úsečka</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Line %1 of the description cannot be read: a new contour begins here.</source>
        <translation>Řádek %1 popisu nelze přečíst: zde začíná nový obrys.</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Little torque for the slide</source>
        <translation>Snížený moment saní</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Load</source>
        <translation>Založit</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Loading station</source>
        <translation>Zakládací stanice</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Zámek</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Lock place</source>
        <translation>Blokovat místo</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Lock tool</source>
        <translation>Blokovat nástroj</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Locked</source>
        <translation>Blokovaný</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Uzamčeno pro čištění</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log in</source>
        <translation>Přihlásit</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log in to see the users.</source>
        <translation>Přihlaste se, abyste viděli uživatele.</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Log of stops</source>
        <translation>Záznam zastavení</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log out</source>
        <translation>Odhlásit</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Logged in: %1, %2</source>
        <translation>Přihlášen: %1, %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Longer</source>
        <translation>Delší okno</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Longest wait: L%1 stands %2 s at %3 (line %4).</source>
        <translation>Nejdelší čekání: L%1 stojí %2 s na %3 (řádek %4).</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Ověřte, zda řízení běží; zkuste znovu.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Lost: %1</source>
        <translation>Ztraceno: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Lower</source>
        <translation>Dolní</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>M code</source>
        <translation>kód M</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>MDI</source>
        <translation>MDI</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>MDI mode takes blocks, and a program in hold</source>
        <translation>Bloky přijímá MDI a zastavený program</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>MEFI constants</source>
        <translation>Konstanty MEFI</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Machine</source>
        <translation>Stroj</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Blokování os</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Machine lock %1</source>
        <translation>Blokování os %1</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Machine off</source>
        <translation>Stroj vypnut</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Machine on</source>
        <translation>Stroj zap.</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Macro</source>
        <translation>Makra</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Magazines</source>
        <translation>Zásobníky</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Main axis: 0 Z, 1 X</source>
        <translation>Hlavní osa: 0 Z, 1 X</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.hpp"/>
        <source>Manual</source>
        <translation>Ručně</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Manual Handle</source>
        <translation>Ruční kolečko</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Mark</source>
        <translation>Označit</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Marked: %1</source>
        <translation>Označeno: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Max</source>
        <translation>Max.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>May be used</source>
        <translation>Smí se použít</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Průměr</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Meaning</source>
        <translation>Význam</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Measure</source>
        <translation>Změřit</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Measured</source>
        <translation>Změřeno</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Measured file</source>
        <translation>Soubor měření</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Measured parts</source>
        <translation>Změřené díly</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Measured: %1</source>
        <translation>Změřeno: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Measures ...</source>
        <translation>Měří ...</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Message</source>
        <translation>Zpráva</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Min</source>
        <translation>Min.</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>More</source>
        <translation>Další</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Mounted</source>
        <translation>Založeno</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Move</source>
        <translation>Přemístit</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Moves</source>
        <translation>Jede</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Multichannel Control</source>
        <translation>Vícekanálové řízení</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>NC</source>
        <translation>NC</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Name</source>
        <translation>Název</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Name of the dimension</source>
        <translation>Název rozměru</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Network</source>
        <translation>Síť</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Network address</source>
        <translation>Síťová adresa</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>New dimension</source>
        <translation>Nový rozměr</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>New edge</source>
        <translation>Nový břit</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New folder</source>
        <translation>Nová složka</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>New insert</source>
        <translation>Nová destička</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New name</source>
        <translation>Nový název</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New program</source>
        <translation>Nový program</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>New tool</source>
        <translation>Nový nástroj</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>New user</source>
        <translation>Nový uživatel</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Next difference</source>
        <translation>Další rozdíl</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Next fault</source>
        <translation>Další chyba</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Next page</source>
        <translation>Další strana</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Next part</source>
        <translation>Další část</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Next solution</source>
        <translation>Další řešení</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>No active alarms.</source>
        <translation>Žádné aktivní alarmy.</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>No alarm and no message is known yet.</source>
        <translation>Zatím není znám žádný alarm ani zpráva.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>No block is entered</source>
        <translation>Není zadán žádný blok</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>No changes recorded.</source>
        <translation>Žádné zaznamenané změny.</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>No channel has stood in this time.</source>
        <translation>V té době žádný kanál nestál.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>No circle has been driven since the record began: drive at least three quarters of one in L%1</source>
        <translation>Od začátku záznamu se nejela kružnice: projeďte v L%1 aspoň tři čtvrtiny</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>No compensation table is described (N2500 to N2808).</source>
        <translation>Žádná kompenzační tabulka není popsána (N2500 až N2808).</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>Řízení neodpovídá</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>No faults found</source>
        <translation>Bez chyb</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>No forecast yet: it begins when parts have been made with tools whose life is monitored.</source>
        <translation>Výhled ještě není: začne, až budou díly vyrobeny nástroji se sledovanou životností.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>No job names the stock of the running program</source>
        <translation>Žádná zakázka neuvádí polotovar programu</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>No network connection is managed here</source>
        <translation>Žádné síťové připojení tu není spravováno</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>No parameter has this in its number, name or meaning.</source>
        <translation>Žádný parametr to nemá v čísle, názvu ani významu.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>No part transfer is set up on this machine: its channels choose no counter spindle.</source>
        <translation>Předání dílu není na tomto stroji nastaveno: jeho kanály nevolí protivřeteno.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>No pictures (PGM, BMP, PNG) in this folder.</source>
        <translation>V této složce nejsou snímky (PGM, BMP, PNG).</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>No program is selected.</source>
        <translation>Není zvolen žádný program.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No signal has this in its name or meaning.</source>
        <translation>Žádný signál to nemá v názvu ani významu.</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>No start</source>
        <translation>Nespuštěno</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>No tool has been called where the programs stopped: touch a block, or type its number</source>
        <translation>Před místem zastavení nebyl volán nástroj: dotkněte se bloku nebo zadejte jeho číslo</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>No tool is chosen.</source>
        <translation>Není zvolen nástroj.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>No tool is like this.</source>
        <translation>Takový nástroj není.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_plot.cpp"/>
        <source>No trace is chosen: Enter on a line, or touch it twice</source>
        <translation>Není zvolen signál: Enter na řádku nebo dvojí dotyk</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No variable has this in its name.</source>
        <translation>Žádná proměnná to nemá v názvu.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No variable of this channel has a value.</source>
        <translation>Žádná proměnná kanálu nemá hodnotu.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>No.</source>
        <translation>Č.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Nobody is logged in. Without a login: %1</source>
        <translation>Nikdo není přihlášen. Bez přihlášení: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Nominal</source>
        <translation>Jmenovitý</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>None is known.</source>
        <translation>Není známa.</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Not described: enter its parameters.</source>
        <translation>Není popsána: zadejte její parametry.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Not done: %1</source>
        <translation>Neprovedeno: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Not enabled</source>
        <translation>Nepovolený</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Not in position</source>
        <translation>Mimo polohu</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Not in use by the running program</source>
        <translation>Program ji nepoužívá</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Not loaded</source>
        <translation>Nezaložené</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>Not saved: stopped. The file is as it was.</source>
        <translation>Neuloženo: zastaveno. Soubor zůstal, jak byl.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Nothing has been changed.</source>
        <translation>Nic se nezměnilo.</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>Nothing is like this. Escape shows all.</source>
        <translation>Nic takového zde není. Escape ukáže vše.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Nothing is missing for a start</source>
        <translation>Ke startu nic nechybí</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Nothing to load: every tool has a place</source>
        <translation>Není co vložit: každý nástroj má místo</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Nothing to simulate: %1</source>
        <translation>Není co simulovat: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Nothing would change</source>
        <translation>Nic by se nezměnilo</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Now</source>
        <translation>Nyní</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Number</source>
        <translation>Číslo</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Number of holes</source>
        <translation>Počet děr</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Number of its first block</source>
        <translation>Číslo prvního bloku</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Number of its last block</source>
        <translation>Číslo posledního bloku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Number of passes</source>
        <translation>Počet řezů</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Number of starts</source>
        <translation>Počet chodů</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Offset</source>
        <translation>Korekce</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Offset number</source>
        <translation>Číslo korekce</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Offset number of the radius</source>
        <translation>Číslo korekce poloměru</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Offsets</source>
        <translation>Korekce</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>One ring</source>
        <translation>Rozteč kroužků</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>Only L%1</source>
        <translation>Jen L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Only a maker can confirm: log in on the page «Users».</source>
        <translation>Potvrdit může jen výrobce: přihlaste se na stránce «Uživatelé».</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Only a whole number is possible.</source>
        <translation>Je možné jen celé číslo.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Only more than 0 is possible here.</source>
        <translation>Zde je možné jen více než 0.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Open folder</source>
        <translation>Otevřít složku</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Open the program</source>
        <translation>Otevřít program</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Open: %1 more data are needed, here or in the next elements.</source>
        <translation>Otevřeno: chybí ještě údajů: %1, zde nebo v dalších prvcích.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Open: what lies before it is not known yet.</source>
        <translation>Otevřeno: co je před ním, ještě není známo.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Operation time</source>
        <translation>Doba provozu</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Volitelný stop</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Volitelný stop %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Volitelný stop M1: start pokračuje</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Order among sisters</source>
        <translation>Pořadí mezi sesterskými</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Other</source>
        <translation>Ostatní</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other edges than the job's hold: %1</source>
        <translation>Platí jiné břity než v zakázce: %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Other feeds than programmed: press again</source>
        <translation>Jiné posuvy než v programu: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Other files may name it: press again</source>
        <translation>Jiné soubory ho znají: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Other level</source>
        <translation>Jiná úroveň</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other offsets than the job's hold: %1</source>
        <translation>Platí jiné korekce než v zakázce: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other zeros than the job's hold: %1</source>
        <translation>Platí jiné nulové body než v zakázce: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Outline that protection guards: X -60:0 Z -20:5</source>
        <translation>Obrys pro ochranu: X -60:0 Z -20:5</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Overrides</source>
        <translation>Override</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.hpp"/>
        <source>Overview</source>
        <translation>Přehled</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Own folder</source>
        <translation>Domovská složka</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Own magazine</source>
        <translation>Vlastní zásobník</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Own place</source>
        <translation>Vlastní místo</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>PID</source>
        <translation>PID</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>PLC</source>
        <translation>PLC</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>PLC Constants</source>
        <translation>Konstanty PLC</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Page down</source>
        <translation>O stránku níž</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Page up</source>
        <translation>O stránku výš</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pallet</source>
        <translation>Paleta</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Pallet Management</source>
        <translation>Palety</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pallet number, 0: no pallet</source>
        <translation>Číslo palety, 0: bez palety</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Pallets</source>
        <translation>Palety</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Panel computer</source>
        <translation>Počítač</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Parameters</source>
        <translation>Parametry</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Part before</source>
        <translation>Předchozí část</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Part time</source>
        <translation>Čas na kus</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Part transfer, step by step</source>
        <translation>Předání dílu po krocích</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Parts</source>
        <translation>Kusy</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Parts go on: press again</source>
        <translation>Kusy jdou dál: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts in all</source>
        <translation>Kusů celkem</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Parts left</source>
        <translation>Zbývá kusů</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts of this job</source>
        <translation>Kusů této zakázky</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts since the start</source>
        <translation>Kusů od startu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts wanted</source>
        <translation>Požadováno kusů</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Password</source>
        <translation>Heslo</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Path backwards %1</source>
        <translation>Po dráze zpět %1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Paths since these screens started; tips drawn as points</source>
        <translation>Dráhy nástrojů od spuštění obrazovky; špička jako bod</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Pattern menu</source>
        <translation>Nabídka vzorů</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Pause</source>
        <translation>Pauza</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Pecking and grooving along Z</source>
        <translation>Přerušované zapichování v Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Per division</source>
        <translation>Dílek</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>Period</source>
        <translation>Období</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Picture</source>
        <translation>Snímek</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Pitch Error Compensation</source>
        <translation>Chyby stoupání</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Place</source>
        <translation>Místo</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Place of the hole C</source>
        <translation>Poloha díry C</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Place of the hole X</source>
        <translation>Poloha díry X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Place of the hole Z</source>
        <translation>Poloha díry Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Places</source>
        <translation>Místa</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Places of holes along a line</source>
        <translation>Polohy děr na přímce</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Places of holes on a circle</source>
        <translation>Polohy děr na kružnici</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Plain S means the counter spindle</source>
        <translation>S bez čísla platí pro protivřeteno</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Plain S means the main spindle</source>
        <translation>S bez čísla platí pro hlavní vřeteno</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Plain S of L%1 means S%2 now: M%3 would act on its chuck.</source>
        <translation>S bez čísla v L%1 teď znamená S%2: M%3 by platilo pro jeho sklíčidlo.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Play</source>
        <translation>Přehrát</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Points</source>
        <translation>Bodů</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Polyturn</source>
        <translation>Polyturn</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pool %1</source>
        <translation>Zásoba %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Position</source>
        <translation>Poloha</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Position Switches</source>
        <translation>Polohové spínače</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Power on</source>
        <translation>Zapnuto</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Presetter</source>
        <translation>Předseřízení</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Previous difference</source>
        <translation>Předchozí rozdíl</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Print setup sheet</source>
        <translation>Tisk seřizovacího listu</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Printed: %1</source>
        <translation>Vytištěno: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Probe is offset %1: press again</source>
        <translation>Sonda: korekce %1, znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Process</source>
        <translation>Proces</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>Proces skončil</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Processes</source>
        <translation>Procesy</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Processes and ticks</source>
        <translation>Procesy a takty</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Program control</source>
        <translation>Ovládání programu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Program of the pallet</source>
        <translation>Program palety</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Program with the contour</source>
        <translation>Program s obrysem</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Programmed stop</source>
        <translation>Programový stop</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Programový stop M0: start pokračuje</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Programs</source>
        <translation>Programy</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Programs and jobs</source>
        <translation>Programy a zakázky</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Proposal</source>
        <translation>Návrh</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Proposal: %1</source>
        <translation>Návrh: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Protect</source>
        <translation>Chránit</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Protected</source>
        <translation>Chráněno</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Put it here</source>
        <translation>Dát sem</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Radius</source>
        <translation>Rádius</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Radius of the arc</source>
        <translation>Poloměr oblouku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Radius of the circle of holes</source>
        <translation>Poloměr kružnice děr</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Radius, commanded</source>
        <translation>Poloměr, požadovaný</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Range</source>
        <translation>Rozsah</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Range %1 of L%2</source>
        <translation>Oblast %1 L%2</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Rapid</source>
        <translation>Rychloposuv</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Rapid %1 %</source>
        <translation>Rychlop. %1 %</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Ready</source>
        <translation>Připravený</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reaming (in G17 along Z)</source>
        <translation>Vystružování (v G17 podél Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reaming behind each block that moves</source>
        <translation>Vystružování za každým blokem s pohybem</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Record</source>
        <translation>Záznam</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Records</source>
        <translation>Záznam běží</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Redo</source>
        <translation>Znovu</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Reference</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Reference Point</source>
        <translation>Referenční bod</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Reference all</source>
        <translation>Reference všech</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reference plane: the surface</source>
        <translation>Vztažná rovina: povrch</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Refresh</source>
        <translation>Načíst znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Relative input</source>
        <translation>Relativní vstup</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Relative zero</source>
        <translation>Relativní nula</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Release place</source>
        <translation>Uvolnit místo</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Release tool</source>
        <translation>Uvolnit nástroj</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Relief at the bottom</source>
        <translation>Odskok na dně</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Zbývá</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Remedy</source>
        <translation>Náprava</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Rename</source>
        <translation>Přejmenovat</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Renamed</source>
        <translation>Přejmenováno</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Repair: where the thread was measured</source>
        <translation>Oprava: kde byl závit změřen</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Repeating a contour</source>
        <translation>Opakování obrysu</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Repeats in a second</source>
        <translation>Opakování za sekundu</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Replaces the one that is here: press again</source>
        <translation>Nahradí zdejší: stiskněte znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Replaces what is entered: press again</source>
        <translation>Přepíše zadané: znovu</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Required tools</source>
        <translation>Potřebné nástroje</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset %1</source>
        <translation>Reset %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset all</source>
        <translation>Reset všech</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset group %1</source>
        <translation>Reset skupiny %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Restart</source>
        <translation>Restart</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Restart at</source>
        <translation>Začít od</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Restart in the middle</source>
        <translation>Start od bloku</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Opakovaný start: start provede najetí</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Restore</source>
        <translation>Obnovit</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Restored values and files: %1</source>
        <translation>Obnoveno hodnot a souborů: %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>Zpětný chod je na konci</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Retract after each pass</source>
        <translation>Odjezd po každém řezu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Retract plane</source>
        <translation>Rovina návratu</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Return %1</source>
        <translation>Návrat %1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Rigid tapping</source>
        <translation>Synchronní závitování</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the face</source>
        <translation>Synchronní závitování na čele</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the face, the way back</source>
        <translation>Synchronní závitování na čele, cesta zpět</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the side</source>
        <translation>Synchronní závitování z boku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the side, the way back</source>
        <translation>Synchronní závitování z boku, cesta zpět</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Rigid tapping of a left-hand thread</source>
        <translation>Synchronní závitování, levý závit</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room above, half places</source>
        <translation>Prostor nahoře, půlmísta</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room below, half places</source>
        <translation>Prostor dole, půlmísta</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room to the left, half places</source>
        <translation>Prostor vlevo, půlmísta</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room to the right, half places</source>
        <translation>Prostor vpravo, půlmísta</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Roughing along X</source>
        <translation>Hrubování podél X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Roughing along Z</source>
        <translation>Hrubování podél Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Rounding to the next one</source>
        <translation>Zaoblení k dalšímu</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Run-in; -1: as the axis accelerates</source>
        <translation>Náběh; -1: jak osa zrychlí</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Run-out in tenths of the lead</source>
        <translation>Výběh v desetinách stoupání</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Run-out; -1: as the axis brakes</source>
        <translation>Výběh; -1: jak osa zabrzdí</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Běží</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Runs in and out within the thread: 1</source>
        <translation>Náběh a výběh uvnitř závitu: 1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Safety distance</source>
        <translation>Bezpečná vzdálenost</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Safety distance before the surface</source>
        <translation>Bezpečná vzdálenost před povrchem</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Safety distance of the way back</source>
        <translation>Bezpečná vzdálenost návratu</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Save</source>
        <translation>Uložit</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Save now</source>
        <translation>Uložit nyní</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Saved: %1</source>
        <translation>Uloženo: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Saves the text first: press again</source>
        <translation>Nejprve uloží text: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Scope</source>
        <translation>Osciloskop</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Search</source>
        <translation>Hledat</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: a zero</source>
        <translation>Hledat: nulový bod</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: number or tool</source>
        <translation>Hledat: číslo nebo nástroj</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Search: number, name or meaning</source>
        <translation>Hledat: číslo, název nebo význam</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: number, tool, edge</source>
        <translation>Hledat: číslo, nástroj, břit</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Second WINS server</source>
        <translation>Druhý WINS</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Second name server</source>
        <translation>Druhý DNS</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Select in L%1</source>
        <translation>Zvolit v L%1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Select job</source>
        <translation>Zvolit zakázku</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Sets the default: press again</source>
        <translation>Nastaví výchozí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Sets the zero: press again</source>
        <translation>Nastaví nulu: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Setting</source>
        <translation>Nastavení</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Several solutions: touch the one that is meant, or «Next solution».</source>
        <translation>Více řešení: dotkněte se správného, nebo „Další řešení“.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Shorter</source>
        <translation>Kratší okno</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Signal</source>
        <translation>Signál</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Signals</source>
        <translation>Signály</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Signals of NC and PLC</source>
        <translation>Signály NC a PLC</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Simulation</source>
        <translation>Simulace</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Simulation, timeline</source>
        <translation>Simulace, časová osa</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Simulation: %1 of %2</source>
        <translation>Simulace: %1 z %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Since</source>
        <translation>Od</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Single block</source>
        <translation>Blok po bloku</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block %1</source>
        <translation>Blok po bloku %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block all</source>
        <translation>Blok po bloku: vše</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block group %1</source>
        <translation>Blok po bloku: skupina %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Blok po bloku: start provede další</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Sinumerik</source>
        <translation>Sinumerik</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Sister</source>
        <translation>Sesterský</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Size</source>
        <translation>Velikost</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Skip Function</source>
        <translation>Funkce skip</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Slower</source>
        <translation>Pomaleji</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Smaller</source>
        <translation>Zmenšit</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Smoothing</source>
        <translation>Vyhlazování</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>So much left is a warning</source>
        <translation>Varovat při zbytku</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Solid outline: monitored; dashed: drawn only</source>
        <translation>Plný obrys: hlídáno; čárkovaný: jen nakresleno</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Some elements are still open.</source>
        <translation>Některé prvky jsou ještě otevřené.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Some ticks were missed</source>
        <translation>Některé takty chybí</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Speed not reached</source>
        <translation>Otáčky nedosaženy</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Speed of the spindle</source>
        <translation>Otáčky vřetena</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Speed reached</source>
        <translation>Otáčky dosaženy</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Spindle</source>
        <translation>Vřeteno</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Spindle %1</source>
        <translation>Vřeteno %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Spindle Control</source>
        <translation>Vřetena</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Spindle Servo</source>
        <translation>Pohony vřeten</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Spindle stop</source>
        <translation>Stop vřetena</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Stands</source>
        <translation>Stojí</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start</source>
        <translation>Začátek</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start all</source>
        <translation>Start všech</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Start blocked:</source>
        <translation>Start je blokován:</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Start goes back along the path: press again</source>
        <translation>Start pojede po dráze zpět: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Start goes backwards</source>
        <translation>Start jede zpět</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start group %1</source>
        <translation>Start skupiny %1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Start of the line, 1st axis (X: radius)</source>
        <translation>Počátek přímky, 1. osa (X: poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Start of the line, 2nd axis (X: radius)</source>
        <translation>Počátek přímky, 2. osa (X: poloměr)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start point X</source>
        <translation>Počáteční bod X</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start point Z</source>
        <translation>Počáteční bod Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Starts</source>
        <translation>Startuje</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Spustí vše: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Starts the whole group: press again</source>
        <translation>Spustí celou skupinu: znovu</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>State</source>
        <translation>Stav</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Station</source>
        <translation>Stanice</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Step along X (radius)</source>
        <translation>Krok v X (poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Step along Z</source>
        <translation>Krok v Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Step between two plunges</source>
        <translation>Krok mezi zápichy</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Stock</source>
        <translation>Polotovar</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Stock to take off</source>
        <translation>Odebíraný přídavek</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Stock to take off along X (radius)</source>
        <translation>Odebíraný přídavek v X (poloměr)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Stock to take off along Z</source>
        <translation>Odebíraný přídavek v Z</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Stop</source>
        <translation>Stop</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Stop record</source>
        <translation>Zastavit záznam</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Zastaven</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Stopped at</source>
        <translation>Zastaveno na</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Stopped: %1</source>
        <translation>Zastaveno: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Straightness Compensation</source>
        <translation>Přímost</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Subnet mask</source>
        <translation>Maska podsítě</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Surface Z</source>
        <translation>Povrch Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Switched off</source>
        <translation>Vypnuto</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Switches the drives on: press again</source>
        <translation>Zapne pohony: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Synchronised view</source>
        <translation>Synchronní pohled</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.hpp"/>
        <source>System</source>
        <translation>Systém</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>System Config</source>
        <translation>Systém</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Table</source>
        <translation>Tabulka</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Tailstock %1</source>
        <translation>Koník %1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Tailstock zone of L%1</source>
        <translation>Zóna koníku L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Take a measured file</source>
        <translation>Převzít soubor měření</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Tangential to the one before (1: yes)</source>
        <translation>Tečně k předchozímu (1: ano)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Tangential to what? Nothing lies before it.</source>
        <translation>Tečně k čemu? Nic před ním není.</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Taper (Z at the start less that at the end)</source>
        <translation>Kužel (Z na začátku minus na konci)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Taper (radius at the start less that at the end)</source>
        <translation>Kužel (poloměr na začátku minus na konci)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping</source>
        <translation>Závitování</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping a left-hand thread</source>
        <translation>Závitování, levý závit</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping in the face</source>
        <translation>Závitování na čele</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Tapping in the face with a compensating chuck</source>
        <translation>Závitování na čele s vyrovnávacím pouzdrem</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping in the side</source>
        <translation>Závitování z boku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Tapping in the side with a compensating chuck</source>
        <translation>Závitování z boku s vyrovnávacím pouzdrem</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>The NC writes it.</source>
        <translation>Zapisuje jej NC.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>The PLC writes it.</source>
        <translation>Zapisuje jej PLC.</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The axes are free: press again</source>
        <translation>Osy jsou volné: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The axes go back: press again</source>
        <translation>Osy pojedou zpět: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>The axes move again: press again</source>
        <translation>Osy se zase pohnou: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>The axes stand while the program runs: press again</source>
        <translation>Program běží, osy stojí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The blocks are searched: nothing moves</source>
        <translation>Bloky se hledají: nic se nepohybuje</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>The contour is complete.</source>
        <translation>Obrys je úplný.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>Řízení neodpovědělo.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>Řízení odmítlo.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The copy of %1 was not what had been sent; what was there before stands</source>
        <translation>Kopie %1 nesouhlasila s odeslaným; původní soubor zůstal</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The counter spindle is free</source>
        <translation>Synchronizace protivřetena zrušena</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The editor holds a text that is not saved</source>
        <translation>V editoru je neuložený text</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The file is being read ...</source>
        <translation>Soubor se čte ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The folder is being read ...</source>
        <translation>Složka se čte ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The job is being simulated</source>
        <translation>Zakázka se simuluje</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>The job is for another machine: %1</source>
        <translation>Zakázka je pro jiný stroj: %1</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>The keys below act when they are kept pressed.</source>
        <translation>Klávesy dole působí, když se podrží.</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>The last %1 days</source>
        <translation>Posledních %1 dní</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>The last %1 h</source>
        <translation>Posledních %1 h</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>The last program is still being written.</source>
        <translation>Předchozí program se ještě zapisuje.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The line of MDI is not entered: choose MDI, or delete the line</source>
        <translation>Řádek MDI není zadán: zvolte MDI, nebo jej smažte</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>The machine has lost data: no program starts</source>
        <translation>Stroj ztratil data: žádný program se nespustí</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The main chuck clamps</source>
        <translation>Hlavní sklíčidlo upne</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The main chuck opens</source>
        <translation>Hlavní sklíčidlo se otevře</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>The manual is not installed here.</source>
        <translation>Příručka zde není nainstalována.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>The newest backup: %1</source>
        <translation>Nejnovější záloha: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>The offset is written</source>
        <translation>Korekce je zapsána</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>The operating system keeps these values and says who may change them; Enter, or a second touch, changes one.</source>
        <translation>Tyto hodnoty drží operační systém a určuje, kdo je smí měnit; Enter nebo druhý dotyk hodnotu změní.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>The pallet in a row goes with its program. «Exchange»: choose a row, press, choose the other row, press again.</source>
        <translation>Paleta se mění i s programem. „Vyměnit“: zvolte řádek, stiskněte, zvolte druhý, stiskněte znovu.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>The pallets are being asked for ...</source>
        <translation>Zjišťují se palety ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The printer refused it: %1</source>
        <translation>Tiskárna to odmítla: %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>The program asks: answer on its page</source>
        <translation>Program se ptá: odpovězte na jeho stránce</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>The program cannot be checked here.</source>
        <translation>Program zde nelze zkontrolovat.</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>The program is being read</source>
        <translation>Program se čte</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>The program of L%1 waits for an answer</source>
        <translation>Program L%1 čeká na odpověď</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>The program polyturn is not beside the HMI.</source>
        <translation>Program polyturn není vedle HMI.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The program runs</source>
        <translation>Program běží</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>The program was broken off</source>
        <translation>Program byl přerušen</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>The programs are being compared ...</source>
        <translation>Programy se porovnávají ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The programs are being read</source>
        <translation>Programy se čtou</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>The relative counter of L%1 begins here</source>
        <translation>Relativní počítadlo L%1 začíná zde</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The restart was refused, nothing has moved: see the alarms</source>
        <translation>Start od bloku byl odmítnut, nic se nepohnulo: viz alarmy</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>The scope records other signals: «Axes of L%1» chooses the axes of a circle</source>
        <translation>Osciloskop zaznamenává jiné signály: „Osy L%1“ zvolí osy kružnice</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The setup sheet is not written: stopped.</source>
        <translation>Seřizovací list není zapsán: zastaveno.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>The simulation is being computed: %1 so far</source>
        <translation>Simulace se počítá: zatím %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>The spindle turns: press again</source>
        <translation>Vřeteno se roztočí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>The turret turns: press again</source>
        <translation>Revolver se otočí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Then</source>
        <translation>Potom</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>There are no dimensions yet: «New dimension».</source>
        <translation>Rozměry zatím nejsou: „Nový rozměr“.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>There are no tools yet: «New tool» on the page of tool data.</source>
        <translation>Nástroje ještě nejsou: „Nový nástroj“ na stránce dat.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There are no users: everybody may do everything. The first one must be a maker.</source>
        <translation>Nejsou uživatelé: každý smí vše. První musí být výrobce.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There is no backup beside the store: choose one from a stick or the network.</source>
        <translation>Vedle úložiště záloha není: vyberte ji na flash disku nebo v síti.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There is no backup in this folder.</source>
        <translation>V této složce není záloha.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>There is no block N%1 in this program yet.</source>
        <translation>Blok N%1 v tomto programu ještě není.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Není spojení s řízením.</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>There is no field of text here</source>
        <translation>Tady není textové pole</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>There is no time zone %1</source>
        <translation>Časové pásmo %1 neexistuje</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>They are the same</source>
        <translation>Jsou stejné</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>They are very different</source>
        <translation>Jsou velmi odlišné</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>This channel has no offsets.</source>
        <translation>Tento kanál nemá korekce.</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>This channel has no tools: enter them on the page of tools.</source>
        <translation>Tento kanál nemá nástroje: zadejte je na stránce nástrojů.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>This channel has no turret.</source>
        <translation>Kanál nemá revolver.</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This computer has no %1</source>
        <translation>Tento počítač nemá %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This computer runs without systemd</source>
        <translation>Tento počítač běží bez systemd</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>This folder cannot be read.</source>
        <translation>Tuto složku nelze číst.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>This folder is empty.</source>
        <translation>Složka je prázdná.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>This is here</source>
        <translation>Zde je toto</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>This is no number.</source>
        <translation>To není číslo.</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>This language has no cycles.</source>
        <translation>Tento jazyk nemá cykly.</translation>
    </message>
    <message>
        <location filename="../widgets/pictures/magazine.cpp"/>
        <source>This machine has no magazine: PT_TURRET_MAGAZINE and N2905 to N2922 describe it.</source>
        <translation>Tento stroj nemá zásobník: popisují ho PT_TURRET_MAGAZINE a N2905 až N2922.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>This machine has no pallets (N3300).</source>
        <translation>Tento stroj nemá palety (N3300).</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>This needs the level of a setter: log in</source>
        <translation>Je třeba úroveň seřizovače: přihlaste se</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This system knows no WINS: names come from the name servers</source>
        <translation>Tento systém nezná WINS: jména dávají servery DNS</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, one pass</source>
        <translation>Závit podél Z, jeden řez</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, the lead grows</source>
        <translation>Závit podél Z, stoupání roste</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, the lead shrinks</source>
        <translation>Závit podél Z, stoupání klesá</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Thread in several passes</source>
        <translation>Závit na více řezů</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Thread in the face</source>
        <translation>Závit na čele</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, one pass</source>
        <translation>Závit na čele, jeden řez</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, the lead grows</source>
        <translation>Závit na čele, stoupání roste</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, the lead shrinks</source>
        <translation>Závit na čele, stoupání klesá</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Thread, one pass</source>
        <translation>Závit, jeden řez</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Three Dimensional Compensation</source>
        <translation>Prostorová korekce</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Time</source>
        <translation>Čas</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time before a key repeats</source>
        <translation>Prodleva opakování</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time from the network</source>
        <translation>Čas ze sítě</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Time left</source>
        <translation>Zbývá času</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time zone</source>
        <translation>Časové pásmo</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Timeline</source>
        <translation>Časová osa</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Timers and counters</source>
        <translation>Časovače a čítače</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Timers, counters</source>
        <translation>Časovače, čítače</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Timers/Counters</source>
        <translation>Časovače a čítače</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Tip</source>
        <translation>Špička</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Tip is at this measure: press again</source>
        <translation>Špička je na míře: znovu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>To be replaced</source>
        <translation>K výměně</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>To go</source>
        <translation>Zbývá</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>To load: choose a tool without a place in the list</source>
        <translation>K vložení: vyberte v seznamu nástroj bez místa</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>To the backups</source>
        <translation>K zálohám</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>To the offsets</source>
        <translation>Na korekce</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>To the start: 0 not, 1 feed, 2 rapid</source>
        <translation>K počátku: 0 ne, 1 posuv, 2 rychle</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Too large: at most %1.</source>
        <translation>Příliš mnoho: nejvýše %1.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Too small: at least %1.</source>
        <translation>Příliš málo: nejméně %1.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Tool</source>
        <translation>Nástroj</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Tool %1 is new: enter what it is</source>
        <translation>Nástroj %1 je nový: zadejte data</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Compensation</source>
        <translation>Korekce nástrojů</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Holder Interference</source>
        <translation>Ochrana suportů</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Management</source>
        <translation>Správa nástrojů</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Tool data</source>
        <translation>Data nástroje</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Tool edges</source>
        <translation>Břity nástrojů</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Tool life (0: not monitored)</source>
        <translation>Životnost (0: nesleduje se)</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Tool number</source>
        <translation>Číslo nástroje</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Tool offsets</source>
        <translation>Korekce nástrojů</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Tool setter</source>
        <translation>Měření nástroje</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Tool unit, 0 all</source>
        <translation>Nástrojová jednotka, 0 všechny</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.hpp"/>
        <source>Tools</source>
        <translation>Nástroje</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Torque</source>
        <translation>Moment</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Touch again or Enter: enlarged</source>
        <translation>Další dotek nebo Enter: zvětšit</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Touch the bit again: it is turned over</source>
        <translation>Dotkněte se bitu znovu: přepne se</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Touch, or Enter: a text</source>
        <translation>Dotyk nebo Enter: text</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Touches and keys do nothing. Unlocks by itself in %1 s, at once when an alarm comes.</source>
        <translation>Dotyky a klávesy nic nedělají. Odemkne se samo za %1 s, při alarmu ihned.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trace off</source>
        <translation>Signál vyp</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Travel of L%1</source>
        <translation>Rozsah pojezdu L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger downwards</source>
        <translation>Sestupná hrana</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger level</source>
        <translation>Úroveň spouštění</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger upwards</source>
        <translation>Náběžná hrana</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Triggered</source>
        <translation>Spuštěno</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Turning Cycles</source>
        <translation>Soustružnické cykly</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Turning a straight section</source>
        <translation>Soustružení přímého úseku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Turning an arc</source>
        <translation>Soustružení oblouku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Turning, one pass</source>
        <translation>Soustružení, jeden řez</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Turret L%1</source>
        <translation>Revolver L%1</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type a number or touch it, then Input.</source>
        <translation>Napište číslo nebo se ho dotkněte, pak „Vstup“.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Type a part of the name</source>
        <translation>Zadejte část názvu</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type number: the T that calls it</source>
        <translation>Číslo typu: T, které ho volá</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type, then Enter.</source>
        <translation>Napište, pak Enter.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>USB</source>
        <translation>USB</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>USB sticks and network places appear when they are there. «Keep as place» adds the folder that is shown; /etc/polyturn/places names those of the shop: NAME=/FOLDER.</source>
        <translation>USB a síťová místa se objeví, když jsou připojena. „Uložit místo“ přidá zobrazenou složku; místa dílny jsou v /etc/polyturn/places: NÁZEV=/SLOŽKA.</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Undo</source>
        <translation>Vrátit změnu</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Undo zeros, offsets</source>
        <translation>Vrátit nuly, korekce</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Unit</source>
        <translation>Jednotka</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Unload</source>
        <translation>Vyjmout</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Unlock</source>
        <translation>Odemknout</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Unsaved text goes: press again</source>
        <translation>Neuložené zmizí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Up</source>
        <translation>Nahoru</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Upper</source>
        <translation>Horní</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Used up</source>
        <translation>Spotřebováno</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>User</source>
        <translation>Uživatel</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Users</source>
        <translation>Uživatelé</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Value</source>
        <translation>Hodnota</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Values and files that would change: %1</source>
        <translation>Změní se hodnot a souborů: %1</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Variable</source>
        <translation>Proměnná</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Variables</source>
        <translation>Proměnné</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Waiting</source>
        <translation>Čekání</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Čekání na řízení</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Čeká</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits at %1 for %2, %3 so far</source>
        <translation>Čeká v %1 na %2, již %3</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Čeká v %1, všichni jsou tu</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Waits for a channel</source>
        <translation>Čeká na kanál</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Waits for the trigger</source>
        <translation>Čeká na spuštění</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Waits ignored</source>
        <translation>Čekání se ignorují</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Wanted</source>
        <translation>Požadováno</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Way back after each peck</source>
        <translation>Návrat po každém kroku</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Way back or clearance of a peck</source>
        <translation>Návrat nebo vůle kroku</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Wear</source>
        <translation>Opotř.</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Wear %1: press again</source>
        <translation>Opotřebení %1: znovu</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Wear R</source>
        <translation>Opotř. R</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Weight</source>
        <translation>Hmotnost</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>What</source>
        <translation>Co</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>What is lost stays lost: press again</source>
        <translation>Ztracené se nevrátí: znovu</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>What it does</source>
        <translation>Co dělá</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>What was told before stands in «History», what the machine stood still for in «Log of stops».</source>
        <translation>Co bylo hlášeno dříve, je v „Historii“, proč stroj stál, v „Záznamu zastavení“.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>What would change</source>
        <translation>Co by se změnilo</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Wheel, tool, transfer</source>
        <translation>Kolečko, nástroj, předání</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>When</source>
        <translation>Kdy</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Who</source>
        <translation>Kdo</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Who has changed this value</source>
        <translation>Kdo tuto hodnotu změnil</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Whole machine</source>
        <translation>Celý stroj</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Window %1 s</source>
        <translation>Okno %1 s</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Without a display server the keyboard itself decides</source>
        <translation>Bez zobrazovacího serveru rozhoduje klávesnice</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Without a probe offset: press again</source>
        <translation>Bez korekce sondy: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Without effect:</source>
        <translation>Bez účinku:</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>Without tool management (N2900) programs bring their own tools and edges.</source>
        <translation>Bez správy nástrojů (N2900) zadává nástroje a břity program.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Word</source>
        <translation>Slovo</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Work by hand</source>
        <translation>Ruční práce</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Work moved from L%1 to L%2 saves up to %3 s.</source>
        <translation>Práce přesunutá z L%1 na L%2 ušetří až %3 s.</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Work shift</source>
        <translation>Posunutí počátku</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Work zeros</source>
        <translation>Nulové body</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Working area</source>
        <translation>Pracovní prostor</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Workpiece</source>
        <translation>Obrobek</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Workpiece setter</source>
        <translation>Měření obrobku</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Works</source>
        <translation>Pracuje</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Worn</source>
        <translation>Opotřebený</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Would be entered</source>
        <translation>Zapsalo by se</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Write into the program</source>
        <translation>Zapsat do programu</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Writes the offset: press again</source>
        <translation>Zapíše korekci: znovu</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Written</source>
        <translation>Zapsáno</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Written as %1</source>
        <translation>Píše se takto: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>X of its end, radius</source>
        <translation>X jeho konce, poloměr</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Z of its end</source>
        <translation>Z jeho konce</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Zero</source>
        <translation>Nulový bod</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Zero here</source>
        <translation>Nula zde</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Zeros</source>
        <translation>Nulové body</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Zeros and offsets of %1 are entered</source>
        <translation>Nuly a korekce z %1 jsou zadány</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Zeros and offsets stand as before</source>
        <translation>Nuly a korekce jsou jako dříve</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>a marker</source>
        <translation>bodu synchronizace</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>a program is interrupted</source>
        <translation>program je přerušen</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>all parameters</source>
        <translation>všechny parametry</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>alarm vše zastavil</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>trvá alarm kanálu</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>osou se ručně pohybuje</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>angle</source>
        <translation>úhel</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>another tool: %1</source>
        <translation>jiný nástroj: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>arm S%1</source>
        <translation>rameno S%1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>připojte ji (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>osy jedou do referenčních bodů</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>s osami se při stopu posuvu pohnulo</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>axis no.</source>
        <translation>č. osy</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>bits</source>
        <translation>bity</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>blocks</source>
        <translation>bloků</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>bore</source>
        <translation>otvor</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>nastavte nástroj</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>dojeďte jím na konec</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>button tool</source>
        <translation>nůž s kruhovou destičkou</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>cell no.</source>
        <translation>č. buňky</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>character code</source>
        <translation>kód znaku</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>zvolte automatiku nebo MDI</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>chuck holds</source>
        <translation>sklíčidlo upnuto</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>chuck open</source>
        <translation>sklíčidlo otevřené</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>zavřete je, ověřte tlak</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>zavřete je nebo zapněte seřizování</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>column no.</source>
        <translation>č. sloupce</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>columns</source>
        <translation>sloupců</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>commanded</source>
        <translation>požadovaná</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>commanded speed</source>
        <translation>požadované otáčky</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>compensation</source>
        <translation>kompenzace</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>count</source>
        <translation>ks</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>counts</source>
        <translation>inkrementů</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>decimals</source>
        <translation>des. míst</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/min</source>
        <translation>°/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/rev</source>
        <translation>°/ot</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/s</source>
        <translation>°/s</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/s2</source>
        <translation>°/s²</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>detached</source>
        <translation>odpojena</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>deviation</source>
        <translation>odchylka</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>drill</source>
        <translation>vrták</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>empty</source>
        <translation>prázdné</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>enter one, or choose auto</source>
        <translation>zadejte jej, nebo zvolte automatiku</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>entered</source>
        <translation>souhlasí</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>entered: %1</source>
        <translation>skutečné: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>vše zastavil alarm</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>feed</source>
        <translation>posuv</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>file</source>
        <translation>soubor</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>files: %1</source>
        <translation>souborů: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>doplňte olej</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>finishing tool</source>
        <translation>dokončovací nůž</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>following error</source>
        <translation>vlečná chyba</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>follows S%1</source>
        <translation>sleduje S%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>follows it synchronously</source>
        <translation>sleduje ji synchronně</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ft/min</source>
        <translation>stopa/min</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>good</source>
        <translation>dobrý</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>grinding wheel</source>
        <translation>brusný kotouč</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>grooving tool</source>
        <translation>zapichovací nůž</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>held by protection</source>
        <translation>drží ochrana</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch</source>
        <translation>palec</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>inch, diameter</source>
        <translation>palec, průměr</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>inch, radius</source>
        <translation>palec, poloměr</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/min</source>
        <translation>palec/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/rev</source>
        <translation>palec/ot</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/s2</source>
        <translation>palec/s²</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>input %1</source>
        <translation>vstup %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>input no.</source>
        <translation>č. vstupu</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>it is not there</source>
        <translation>není tu</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>its travel is added to the axis' own</source>
        <translation>její dráha se přičítá</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>kB</source>
        <translation>kB</translation>
    </message>
    <message>
        <location filename="../machine/live/alarm_log.cpp"/>
        <source>line</source>
        <translation>řádek</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>line %1, column %2</source>
        <translation>řádek %1, sloupec %2</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>load a new one</source>
        <translation>vložte novou</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>longest below %1 of a tick of %2</source>
        <translation>nejdelší výpočet pod %1, perioda taktu %2</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>m/min</source>
        <translation>m/min</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>maker</source>
        <translation>výrobce</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>measured</source>
        <translation>měřená</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>metres of cutting</source>
        <translation>metry řezu</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>milling tool</source>
        <translation>fréza</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>minutes of cutting</source>
        <translation>minuty řezu</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>mm, diameter</source>
        <translation>mm, průměr</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>mm, radius</source>
        <translation>mm, poloměr</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>mm/K</source>
        <translation>mm/K</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/min</source>
        <translation>mm/min</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/rev</source>
        <translation>mm/ot</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/s2</source>
        <translation>mm/s²</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/s3</source>
        <translation>mm/s³</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>more: %1</source>
        <translation>další: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>mounted</source>
        <translation>založen</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>moves its drive: the axes are exchanged</source>
        <translation>pohybuje jejím pohonem: osy jsou vyměněny</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>never comes: %1</source>
        <translation>nikdy nepřijde: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>no</source>
        <translation>ne</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no block is entered</source>
        <translation>není zadán žádný blok</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>no offset, no tool</source>
        <translation>bez korekce</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>no program</source>
        <translation>bez programu</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no program is selected</source>
        <translation>není zvolen žádný program</translation>
    </message>
    <message>
        <location filename="../machine/live/axis_places.cpp"/>
        <source>no ref.</source>
        <translation>bez ref.</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>nástroj není na místě, hlava není zajištěna</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>bez nástroje</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>nobody</source>
        <translation>nikdo</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>not a number yet</source>
        <translation>ještě ne číslo</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>osy nemají referenci</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>not all channels of the restart are at their blocks</source>
        <translation>ne všechny kanály startu od bloku jsou u svých bloků</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>not entered</source>
        <translation>nezadáno</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>not measured</source>
        <translation>neměřeno</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>not monitored</source>
        <translation>nesleduje se</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>not referenced</source>
        <translation>bez reference</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>not this one</source>
        <translation>není to tento</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>nothing</source>
        <translation>nic</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>off</source>
        <translation>vyp</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>offset no.</source>
        <translation>č. korekce</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>only makers</source>
        <translation>jen výrobce</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>only setters</source>
        <translation>jen seřizovač</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>operator</source>
        <translation>obsluha</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>other name: %1</source>
        <translation>jiný název: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>pale: the rows beside it</source>
        <translation>bledě: sousední řady</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>pale: the rows beside it; thin: before</source>
        <translation>bledě: sousední řady; tence: předtím</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pallets</source>
        <translation>palet</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>parting tool</source>
        <translation>upichovací nůž</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>parts to the limit: %1</source>
        <translation>kusů do meze: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>path left</source>
        <translation>zbytek dráhy</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>path speed</source>
        <translation>rychlost dráhy</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>pcs</source>
        <translation>ks</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>periods</source>
        <translation>period</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>pieces</source>
        <translation>kusy</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>point %1, %2</source>
        <translation>bod %1, %2</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>point no.</source>
        <translation>č. bodu</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pot no.</source>
        <translation>č. místa</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pots</source>
        <translation>míst</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>zapněte stroj</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>stiskněte reference všech</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>press reset</source>
        <translation>stiskněte reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>press return</source>
        <translation>stiskněte návrat</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>probe</source>
        <translation>sonda</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>program no.</source>
        <translation>č. programu</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>programs run</source>
        <translation>programy běží</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>programs stand</source>
        <translation>programy stojí</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ratio</source>
        <translation>poměr</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>read-only</source>
        <translation>jen pro čtení</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>records</source>
        <translation>záznamů</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>reference it</source>
        <translation>najeďte referenci</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>uvolněte jej a zapněte stroj</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>odstraňte příčinu a reset</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>odstraňte příčinu, pak reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>restore a backup, or let a maker confirm what is left</source>
        <translation>obnovte zálohu, nebo ať výrobce potvrdí, co zbylo</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rev</source>
        <translation>ot</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rev/s2</source>
        <translation>ot/s²</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>roughing tool</source>
        <translation>hrubovací nůž</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rows</source>
        <translation>řad</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rpm</source>
        <translation>ot/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rpm/s</source>
        <translation>ot/min/s</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>select one on the page of programs</source>
        <translation>zvolte jej na stránce programů</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>setter</source>
        <translation>seřizovač</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>since the start</source>
        <translation>od startu</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>special tool</source>
        <translation>speciální nástroj</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>speed</source>
        <translation>otáčky</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>spindle no.</source>
        <translation>č. vřetena</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>stations</source>
        <translation>stanic</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>switch it on</source>
        <translation>zapněte jej</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect after a restart of the controller</source>
        <translation>působí po restartu řízení</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect at once</source>
        <translation>působí ihned</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect at the next preprocessing stop</source>
        <translation>působí od příštího zastavení předzpracování</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>tyč je spotřebována</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>proces kanálu neběží</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>sklíčidlo nedrží</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the door is open</source>
        <translation>dveře jsou otevřené</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>nouzové zastavení je aktivní</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>chybí mazání</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>the machine</source>
        <translation>stroj</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>the machine does not have it</source>
        <translation>stroj to nemá</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>stroj není zapnut</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>stroj je vypnut</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>stroj je připraven</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>režim je ruční</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>the place is empty</source>
        <translation>místo je prázdné</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>the program takes no time</source>
        <translation>program netrvá žádný čas</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>reset neskončil</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the store has lost data: no production</source>
        <translation>úložiště ztratilo data: bez výroby</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>úložiště neběží: nic by se neuložilo</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>koník není vzadu ani nedrží</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>the time of a tick</source>
        <translation>perioda taktu</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>thin: before</source>
        <translation>tence: předtím</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>threading tool</source>
        <translation>závitový nůž</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ticks</source>
        <translation>taktů</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>tip</source>
        <translation>špička</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>too large</source>
        <translation>nad tolerancí</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>too small</source>
        <translation>pod tolerancí</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>tool %1</source>
        <translation>nástroj %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>torque</source>
        <translation>moment</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>uvolněte tlačítko, pak zapněte stroj</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>turning drill</source>
        <translation>soustružnický vrták</translation>
    </message>
    <message>
        <location filename="../machine/live/axis_places.cpp"/>
        <source>turns as spindle S%1</source>
        <translation>otáčí se jako vřeteno S%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>turns with it, deviation %1°</source>
        <translation>otáčí se s ním, odchylka %1°</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>us</source>
        <translation>µs</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>uses</source>
        <translation>použití</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>values: %1</source>
        <translation>hodnot: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>variable no.</source>
        <translation>č. proměnné</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>velocity</source>
        <translation>rychlost</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>počkejte</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait for them; if it was refused, restart again or reset</source>
        <translation>počkejte na ně; byl-li odmítnut, začněte znovu nebo reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>počkejte na jeho spuštění, pak reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>počkejte, až stojí</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>počkejte, až poběží</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>počkejte, až osy stojí</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>wanted: a whole number</source>
        <translation>je třeba celé číslo</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>wear</source>
        <translation>opotřebení</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>wear of L%1 T%2 D%3</source>
        <translation>opotř. L%1, T%2 D%3</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>wear of L%1 offset %2</source>
        <translation>opotř. L%1, kor. %2</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>yes</source>
        <translation>ano</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>«Mark» chooses what is copied or compared</source>
        <translation>„Označit“ zvolí, co kopírovat nebo porovnat</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>«Measure» finds the tip and shows what would be entered. Camera calibrated: %1.</source>
        <translation>«Změřit» najde špičku a ukáže, co by se zapsalo. Kamera je zkalibrována: %1.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>«Measure» finds the tip and shows what would be entered. The gauge pin calibrates the camera first.</source>
        <translation>„Změřit“ najde špičku a ukáže, co by se zapsalo. Kameru nejdřív zkalibrujte kolíkem.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>«Restore» brings everything back as it was then. The file cannot be read whole: «Confirm the loss» may leave parameters, offsets, zeros, tools and users as on the first day. Look through them before the first part.</source>
        <translation>«Obnovit» vrátí vše, jak to tehdy bylo. Soubor nelze přečíst celý: po «Potvrdit ztrátu» mohou být parametry, korekce, nulové body, nástroje a uživatelé jako první den. Projděte je před prvním kusem.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>«Restore» brings everything back as it was then. «Confirm the loss» keeps what is left: the newest changes of parameters, offsets, zeros, tools, lives and users are gone for good. Look through them before the first part.</source>
        <translation>«Obnovit» vrátí vše, jak to tehdy bylo. «Potvrdit ztrátu» ponechá, co zbylo: poslední změny parametrů, korekcí, nulových bodů, nástrojů, životností a uživatelů jsou navždy pryč. Projděte je před prvním kusem.</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>µm</source>
        <translation>µm</translation>
    </message>
</context>
</TS>
