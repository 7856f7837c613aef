<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hu_HU" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it cutting</source>
        <translation>  ebből forgácsolás</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it rapid</source>
        <translation>  ebből gyorsjárat</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it waiting</source>
        <translation>  ebből bevárás</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>%1 a part</source>
        <translation>%1/darab</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>%1 ago</source>
        <translation>%1 ideje</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1 by %2: straightness</source>
        <translation>%1 a(z) %2 szerint: egyenesség</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 cannot be the name of a program</source>
        <translation>%1 nem lehet program neve</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 has a new insert: its life begins anew, the wear of its offset stays</source>
        <translation>%1: új lapka, az éltartam újrakezdődik, a korrekciójának kopása marad</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 has a new insert: life and wear begin anew</source>
        <translation>%1: új lapka, az éltartam és a kopás újrakezdődik</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 has values again: they stay</source>
        <translation>%1: ismét vannak értékei, maradnak</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>%1 in all</source>
        <translation>összesen %1</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 interrupted</source>
        <translation>megszakítva: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1 is %2 by now: it stays</source>
        <translation>%1: már %2, így marad</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>%1 is being opened</source>
        <translation>%1 megnyitása</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>%1 is being read: the place answers slowly</source>
        <translation>%1 olvasása folyik: a hely lassan válaszol</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>%1 is being written: the place answers slowly</source>
        <translation>%1 írása folyik: a hely lassan válaszol</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is deleted</source>
        <translation>%1 törölve</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>%1 is logged in</source>
        <translation>%1 bejelentkezett</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is new</source>
        <translation>Új él: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>%1 is not such a value</source>
        <translation>%1 ide nem illik</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is not there any more</source>
        <translation>%1 már nincs meg</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected</source>
        <translation>%1 védett</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected by F3202</source>
        <translation>%1: az F3202 paraméter védi</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected: a login of a higher level may change it</source>
        <translation>%1 védett: magasabb szintű bejelentkezéssel módosítható</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is read-only</source>
        <translation>%1 csak olvasható</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected</source>
        <translation>Kiválasztva: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected in L%2</source>
        <translation>%1 kiválasztva: L%2</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected in its channels</source>
        <translation>%1 kiválasztva a csatornáiban</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 is taken out</source>
        <translation>%1 ki van véve</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is there again</source>
        <translation>%1 ismét megvan</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is there already</source>
        <translation>%1 már van</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>%1 of %2</source>
        <translation>%1 / %2</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 run</source>
        <translation>fut: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>%1 s after the start of the controller</source>
        <translation>%1 s a vezérlő indulása után</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 stand</source>
        <translation>áll: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 stands in %2</source>
        <translation>%1 itt áll: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>%1 too long</source>
        <translation>túl hosszú: %1</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 wait</source>
        <translation>várnak: %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>%1 waits for nobody, nobody waits for it: press again</source>
        <translation>%1 senkire sem vár, rá sem vár senki: nyomja meg újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>%1 was refused: %2</source>
        <translation>%1: elutasítva: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: acts as soon as the axes rest</source>
        <translation>%1: hat, amint a tengelyek állnak</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1: another value stands there by now, it stays</source>
        <translation>%1: közben más érték áll ott, marad</translation>
    </message>
    <message>
        <location filename="../widgets/pictures/magazine.cpp"/>
        <source>%1: choose its place, Enter puts it there, Escape leaves it</source>
        <translation>%1: válasszon helyet, Enter leteszi, Escape elhagyja</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: gradient</source>
        <translation>%1: gradiens</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1: no program is selected</source>
        <translation>%1: nincs kiválasztott program</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: periodic</source>
        <translation>%1: periodikus</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: pitch</source>
        <translation>%1: emelkedéshiba</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: pitch, negative direction</source>
        <translation>%1: emelkedéshiba, negatív irány</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>%1: start goes on</source>
        <translation>%1: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>%1; %2: not so</source>
        <translation>%1; %2: nem</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>(limited)</source>
        <translation>(korlátozva)</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>+ Input</source>
        <translation>+ Bevitel</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>0.1 lead</source>
        <translation>0.1 emelkedés</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>1/10 lead</source>
        <translation>1/10 emelk.</translation>
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
        <translation>ford/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>1/s</source>
        <translation>1/s</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>2 to 30 a second</source>
        <translation>2-től 30-ig másodpercenként</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>250 to 1000 ms</source>
        <translation>250-től 1000 ms-ig</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>5 Axis Machining</source>
        <translation>5 tengelyes megm.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A block by hand (MDI)</source>
        <translation>Mondat kézzel (MDI)</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>A block entered by hand waits: start runs it</source>
        <translation>Kézzel beírt mondat vár: a start végrehajtja</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>A part of a long program: lines %1 to %2, %3 % of it. «Check, waits» looks for faults in all of it.</source>
        <translation>Egy hosszú program része: %1–%2. sor, a program %3 %-a. Az „Ellenőrzés, bevárások” az egészet átnézi.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A program is held: «Jog in hold %1» lets its axes be moved</source>
        <translation>A program áll: a tengelyeket a «Kézi mozgatás álljban %1» mozgatja</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A program runs: axes are moved by hand in a hold, after «Jog in hold»</source>
        <translation>Program fut: kézzel a tengelyek állj közben mozgathatók, a „Kézi mozgatás álljban” után</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>A program works with it: press again</source>
        <translation>Program dolgozik vele: még egyszer</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>A value is needed here.</source>
        <translation>Itt érték kell.</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Nincs</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Acceleration</source>
        <translation>Gyorsulás</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Accept proposal</source>
        <translation>Elfogadás</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Active</source>
        <translation>Aktív</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Active alarms</source>
        <translation>Aktív riasztások</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active at the next T</source>
        <translation>A következő T-től</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active at the next T or D</source>
        <translation>A következő T-től vagy D-től</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active from the next blocks</source>
        <translation>A következő mondatoktól</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add a line</source>
        <translation>Egyenes hozzáadása</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add an arc G2</source>
        <translation>G2 ív hozzáadása</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add an arc G3</source>
        <translation>G3 ív hozzáadása</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Addresses by DHCP</source>
        <translation>Címek DHCP-vel</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>After</source>
        <translation>Utána</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Alarm</source>
        <translation>Riasztás</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.hpp"/>
        <source>Alarms</source>
        <translation>Riasztások</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>All are at their blocks: start makes the approach</source>
        <translation>Mind a mondatánál áll: a start megközelíti</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>All axes move: press again</source>
        <translation>Minden tengely mozog: nyomja meg újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>All channels</source>
        <translation>Minden csatorna</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>All from their last tool call</source>
        <translation>Mind a szerszámhívástól</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>All groups</source>
        <translation>Minden csoport</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>All tables</source>
        <translation>Minden táblázat</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>All tools</source>
        <translation>Minden szerszám</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>All zeros together</source>
        <translation>Eltolások összege</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Along</source>
        <translation>Mentén</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Along axis</source>
        <translation>Tengely mentén</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>An alarm has ended the lock for cleaning.</source>
        <translation>Riasztás oldotta fel a tisztítási zárat.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>An arc turns through less than 360°.</source>
        <translation>Egy ív 360°-nál kisebb.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle at its end to +Z</source>
        <translation>Végszög a +Z-hez</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle at its start to +Z</source>
        <translation>Kezdeti szög a +Z-hez</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle between two holes; 0: evenly spread</source>
        <translation>Szög két furat között; 0: egyenletesen</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle it turns through</source>
        <translation>Az ív szöge</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle of the first hole to the 1st axis</source>
        <translation>Az első furat szöge az 1. tengelyhez</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Angle of the infeed</source>
        <translation>Fogásvétel szöge</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle of the line to the 1st axis</source>
        <translation>A vonal szöge az 1. tengelyhez</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Angle of the spindle at the start</source>
        <translation>Főorsó szöge a kezdetnél</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Angle of the tool tip</source>
        <translation>Szerszámcsúcs szöge</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle to +Z</source>
        <translation>Szög a +Z-hez</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Another cycle</source>
        <translation>Másik ciklus</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Applied now</source>
        <translation>Most érvényes</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Arc G2</source>
        <translation>Ív G2</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Arc G3</source>
        <translation>Ív G3</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Automata</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Axes</source>
        <translation>Tengelyek</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Axes and drives</source>
        <translation>Tengelyek és hajtások</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Axes are moved by hand while the machine is on</source>
        <translation>A tengelyek kézzel bekapcsolt gépen mozgathatók</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Axes of L%1</source>
        <translation>L%1 tengelyei</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Axis</source>
        <translation>Tengely</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Config</source>
        <translation>Tengelyek</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Limits</source>
        <translation>Tengelyhatárok</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Recomposition</source>
        <translation>Tengelycsere</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Servo</source>
        <translation>Tengelyhajtások</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Back</source>
        <translation>Vissza</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Back to the text</source>
        <translation>Vissza a szöveghez</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Backup</source>
        <translation>Mentés</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Backups</source>
        <translation>Mentések</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Barrel thread on an arc, clockwise</source>
        <translation>Hordómenet íven, óramutató szerint</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Barrel thread on an arc, counter-clockwise</source>
        <translation>Hordómenet íven, óramutatóval ellentétesen</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Base</source>
        <translation>Bázis</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Base R</source>
        <translation>Bázis R</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Base lengths</source>
        <translation>Bázishosszak</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Before</source>
        <translation>Előtte</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Begins anew, stood in line %1: press again</source>
        <translation>Elölről (a(z) %1. sorban állt): újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Mondatkihagyás</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Block skip %1</source>
        <translation>Mondatkihagyás %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Blocks are entered in MDI, or while a program is held</source>
        <translation>Mondatot MDI-ben vagy megállított programnál lehet beírni</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring</source>
        <translation>Kiesztergálás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring in the face</source>
        <translation>Kiesztergálás a homlokon</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring in the side</source>
        <translation>Kiesztergálás oldalról</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring with a dwell</source>
        <translation>Kiesztergálás várakozással</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring, back with the spindle stopped</source>
        <translation>Kiesztergálás, vissza álló főorsóval</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom X</source>
        <translation>Fenék X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom Z</source>
        <translation>Fenék Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom of the hole X</source>
        <translation>Furat alja X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole X, or the end of the way back</source>
        <translation>Furat alja X, vagy a visszaút vége</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom of the hole Z</source>
        <translation>Furat alja Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole Z, or the end of the way back</source>
        <translation>Furat alja Z, vagy a visszaút vége</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole, where no depth is told</source>
        <translation>Furat alja, ha nincs mélység megadva</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Bring the axes to a free place first. Touch one of these blocks twice, press Enter on it, or type its number: the program restarts there. «Restart» reads to it without moving, with all waits replayed. The first start shows what comes; the second one does it: tool, functions, axes, and it cuts.</source>
        <translation>Előbb vigye a tengelyeket szabad helyre! Érintse meg kétszer az egyik mondatot (vagy Enter), vagy írja be a mondatszámot: a program onnan folytatódik. Az „Újraindítás” mozgás nélkül végigolvassa a programot eddig a mondatig, a bevárásokkal együtt. Az első start megmutatja, mi következik; a második végrehajtja: szerszám, funkciók, tengelyek, majd forgácsolás.</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Broken</source>
        <translation>Törött</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Calibrate</source>
        <translation>Kalibrálás</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Calibrated: %1 µm a pixel, tilted by %2°</source>
        <translation>Kalibrálva: %1 µm képpontonként, dőlés %2°</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Call %1</source>
        <translation>Hívás: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Called by</source>
        <translation>Hívja</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Cannot be written: %1</source>
        <translation>Nem írható: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Cause</source>
        <translation>Kiváltó ok</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Cell %1</source>
        <translation>%1. cella</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Centre X</source>
        <translation>Középpont X</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Centre Z</source>
        <translation>Középpont Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Centre from the start point X (radius)</source>
        <translation>Középpont a kezdettől X (sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Centre from the start point Z</source>
        <translation>Középpont a kezdettől Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Centre of the circle, 1st axis (X: radius)</source>
        <translation>Kör középpontja, 1. tengely (X: sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Centre of the circle, 2nd axis (X: radius)</source>
        <translation>Kör középpontja, 2. tengely (X: sugár)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Chamfer or rounding has no room here.</source>
        <translation>A letörésnek vagy lekerekítésnek nincs helye.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Chamfer to the next one</source>
        <translation>Letörés a következőhöz</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Change</source>
        <translation>Módosítás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Change of the lead a revolution</source>
        <translation>Emelkedés változása fordulatonként</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Changed</source>
        <translation>Módosítva</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Changed only</source>
        <translation>Csak módosítottak</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Changes of %1</source>
        <translation>Változások: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Channel</source>
        <translation>Csatorna</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Check, waits</source>
        <translation>Ellenőrzés, bevárások</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Choose a backup: «What would change» compares it with the machine, and nothing is changed yet.</source>
        <translation>Válasszon mentést: a „Mi változna” összeveti a géppel, és még semmit sem változtat.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Choose a cycle: touch it twice, or Enter.</source>
        <translation>Válasszon ciklust: érintse kétszer, vagy Enter.</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>Choose a field</source>
        <translation>Válasszon mezőt</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Choose a job or a program</source>
        <translation>Válasszon megbízást vagy programot</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Choose a picture of the tool's shadow</source>
        <translation>Válasszon képet a szerszám árnyékáról</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Choose a signal; type a part of its name</source>
        <translation>Válasszon jelet; írja be a név egy részét</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Choose signal</source>
        <translation>Jel választása</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Chuck S%1</source>
        <translation>S%1 tokmány</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Chuck zone of L%1</source>
        <translation>Tokmányzóna L%1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Chuck/Tailstock Barrier</source>
        <translation>Tokmány- és nyeregzóna</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Circularity</source>
        <translation>Köralakvizsgálat</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Circularity error</source>
        <translation>Köralakhiba</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Clear</source>
        <translation>Pályák törlése</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Clear search</source>
        <translation>Keresés törlése</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Clearance before the next peck</source>
        <translation>Hézag a következő lépés előtt</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Close</source>
        <translation>Bezárás</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Commanded</source>
        <translation>Előírt</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Compare</source>
        <translation>Összehasonlítás</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Comparison</source>
        <translation>Összehasonlítás</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Compensation</source>
        <translation>Kompenzáció</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Compensation tables</source>
        <translation>Kompenzációs táblázatok</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Computer</source>
        <translation>Számítógép</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Computing time of ticks</source>
        <translation>Ütemek számítási ideje</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Confirm the loss</source>
        <translation>Veszteség megerősítése</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Confirmed: production goes on with what is left</source>
        <translation>Megerősítve: a gyártás a megmaradttal folytatódik</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Continuous</source>
        <translation>Folyamatos</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Contour</source>
        <translation>Kontúr</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Coordinates</source>
        <translation>Koordináták</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Copied and compared</source>
        <translation>Másolva és ellenőrizve</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Copy to here</source>
        <translation>Másolás ide</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Copy, delete ...</source>
        <translation>Másolás, törlés...</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Core diameter at the end</source>
        <translation>Magátmérő a végén</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Corrected</source>
        <translation>Javított</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Corrected axis</source>
        <translation>Javított tengely</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Correction</source>
        <translation>Kompenzáció</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Couplings</source>
        <translation>Csatolások</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Couplings and exchanges</source>
        <translation>Csatolások és cserék</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Cutting</source>
        <translation>Forgácsolás</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cutting time</source>
        <translation>Forgácsolási idő</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Ciklus</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Cycle form</source>
        <translation>Ciklusűrlap</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cycle last, mean</source>
        <translation>Utolsó ciklus, átlag</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cycle now</source>
        <translation>Aktuális ciklus</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Sötét</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Date and time</source>
        <translation>Dátum és idő</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Decides the time</source>
        <translation>Kritikus út</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Default</source>
        <translation>Alapérték</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Default value</source>
        <translation>Alapérték</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Delete</source>
        <translation>Törlés</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Delete all</source>
        <translation>Mindent töröl</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Delete edge</source>
        <translation>Él törlése</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Delete the element</source>
        <translation>Elem törlése</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Delete tool</source>
        <translation>Szerszám törlése</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Delete user</source>
        <translation>Felhasználó törlése</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Deleted</source>
        <translation>Törölve</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Depends on</source>
        <translation>Mitől függ</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Depth below the surface, instead of the bottom</source>
        <translation>Mélység a felület alatt, az alj helyett</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck</source>
        <translation>Lépés mélysége</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck along X (radius)</source>
        <translation>Lépés mélysége X mentén (sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck along Z</source>
        <translation>Lépés mélysége Z mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of a peck; 0: tapping</source>
        <translation>Lépés mélysége; 0: menetfúrás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of cut</source>
        <translation>Fogásmélység</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of cut (radius)</source>
        <translation>Fogásmélység (sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of cut along Z</source>
        <translation>Fogásmélység Z mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of the first pass (radius)</source>
        <translation>Első fogás mélysége (sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of the hole</source>
        <translation>Furat mélysége</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Deviation</source>
        <translation>Eltérés</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.hpp"/>
        <source>Diagnosis</source>
        <translation>Diagnosztika</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Diameter</source>
        <translation>Átmérő</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Diameter at the end</source>
        <translation>Átmérő a végén</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Diameter of the pin</source>
        <translation>Csap átmérője</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Diameter of this pass at the end</source>
        <translation>E fogás átmérője a végén</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Difference</source>
        <translation>Eltérés</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Differences: %1</source>
        <translation>Eltérések: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Differs from file</source>
        <translation>Fájltól eltérő</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Dimension</source>
        <translation>Méret</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Do this step</source>
        <translation>Lépés végrehajtása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling</source>
        <translation>Fúrás</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Drilling Cycles</source>
        <translation>Fúróciklusok</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Drilling and tapping</source>
        <translation>Fúrás és menetfúrás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling in the face</source>
        <translation>Fúrás a homlokon</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling in the side</source>
        <translation>Fúrás oldalról</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling with a dwell</source>
        <translation>Fúrás várakozással</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling with pecks</source>
        <translation>Fúrás lépésekben</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling, breaking chips</source>
        <translation>Fúrás forgácstöréssel</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, centring (in G17 along Z)</source>
        <translation>Fúrás, központfúrás (G17-ben Z mentén)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, centring behind each block that moves</source>
        <translation>Fúrás, központfúrás minden mozgó mondat után</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, counterboring (in G17 along Z)</source>
        <translation>Fúrás, süllyesztés (G17-ben Z mentén)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, counterboring behind each block that moves</source>
        <translation>Fúrás, süllyesztés minden mozgó mondat után</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Drive fault</source>
        <translation>Hajtáshiba</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Próbafutás</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Dry run %1</source>
        <translation>Próbafutás %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Dwell</source>
        <translation>Kivárás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Dwell at the bottom</source>
        <translation>Várakozás az alján</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Dwell at the bottom; negative: revolutions</source>
        <translation>Várakozás az alján; negatív: fordulatok</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Edge D</source>
        <translation>Él D</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Edit</source>
        <translation>Szerkesztés</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Editor</source>
        <translation>Szerkesztő</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Effect</source>
        <translation>Hatás</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Electronic Gear Box</source>
        <translation>Elektronikus hajtómű</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Emergency stop</source>
        <translation>Vészleállítás</translation>
    </message>
    <message>
        <location filename="../widgets/text_entry.cpp"/>
        <source>Empty</source>
        <translation>Törlés</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Empty the field</source>
        <translation>Mező ürítése</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End of the thread Z</source>
        <translation>Menet vége Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End of the way back X</source>
        <translation>A visszaút vége X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End of the way back Z</source>
        <translation>A visszaút vége Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>End point X</source>
        <translation>Végpont X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End point X of the last plunge</source>
        <translation>Utolsó beszúrás végpontja X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End point X, where the thread is tapered</source>
        <translation>X végpont, ha a menet kúpos</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>End point Z</source>
        <translation>Végpont Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End point Z of the last plunge</source>
        <translation>Utolsó beszúrás végpontja Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End point Z, where the thread is tapered</source>
        <translation>Z végpont, ha a menet kúpos</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>End with this part</source>
        <translation>Leállás a darab után</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Kész</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Mindet befejezi: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Befejezi a programot: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends the programs of the group: press again</source>
        <translation>Az egész csoportot befejezi: újra</translation>
    </message>
    <message>
        <location filename="../widgets/text_pad.cpp"/>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Enter it</source>
        <translation>Beírás</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Enter logs in. A new user gets this name, this password and the level %1.</source>
        <translation>Enter: bejelentkezés. Az új felhasználó e névvel és jelszóval, „%1” szinttel jön létre.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Enter takes the block first</source>
        <translation>Előbb vegye át a mondatot Enterrel</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Enter takes the block, Start runs it</source>
        <translation>Enter átveszi, a start végrehajtja</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Enter the start point, then add lines and arcs with what the drawing says.</source>
        <translation>Adja meg a kezdőpontot, majd az egyeneseket és íveket a rajz szerint.</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Enter zeros, offsets</source>
        <translation>Nullpontok, korrekciók beírása</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Enter, or a second touch, changes it.</source>
        <translation>Az Enter vagy második érintés átállítja.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Entered</source>
        <translation>Tényleges</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Enters the relative counter: press again</source>
        <translation>Beírja a számlálót: újra</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Enters what was touched: press again</source>
        <translation>Beírja az érintést: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Every axis and spindle is on its own: nothing is coupled, exchanged or followed.</source>
        <translation>Minden tengely és orsó önálló: nincs csatolás, csere vagy követés.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Everything becomes as then: press again</source>
        <translation>Minden olyan lesz, mint akkor: újra</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Exchange</source>
        <translation>Csere</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Exchange with it</source>
        <translation>Csere ezzel</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Export</source>
        <translation>Exportálás</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>External</source>
        <translation>Külső</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>F11, or the key at the top: the next one</source>
        <translation>F11 vagy a felső gomb: a következő</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Face Z</source>
        <translation>Homlok Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Facing a straight section</source>
        <translation>Egyenes szakasz oldalazása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Facing an arc</source>
        <translation>Ív oldalazása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Facing, one pass</source>
        <translation>Oldalazás, egy fogás</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Factor</source>
        <translation>Szorzó</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Factor of the pecks; tapping: kind 0, 1, 2</source>
        <translation>Lépések szorzója; menetfúrás: 0, 1, 2</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor axes</source>
        <translation>Fagor: tengelyek</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor general</source>
        <translation>Fagor: általános</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor spindle</source>
        <translation>Fagor: orsó</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc B axis</source>
        <translation>Fanuc: B tengely</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc axes</source>
        <translation>Fanuc: tengelyek</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc cycles</source>
        <translation>Fanuc: ciklusok</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc interfaces</source>
        <translation>Fanuc: interfészek</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc macros</source>
        <translation>Fanuc: makrók</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc offsets</source>
        <translation>Fanuc: korrekciók</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc programs</source>
        <translation>Fanuc: programok</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Faster</source>
        <translation>Gyorsabban</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Feed</source>
        <translation>Előtolás</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Feed hold</source>
        <translation>Előtolás állj</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Előtolás-állj: a start folytatja</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed into hollows</source>
        <translation>Előtolás a mélyedésekbe</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed of finishing</source>
        <translation>Simítás előtolása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Feed of finishing, where the contour says none</source>
        <translation>Simító előtolás, ha a kontúr nem mondja</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Feed of roughing</source>
        <translation>Nagyolás előtolása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed of the last roughing pass</source>
        <translation>Utolsó nagyoló fogás előtolása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed on the way in</source>
        <translation>Előtolás befelé</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed on the way out</source>
        <translation>Előtolás kifelé</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed: lead times speed</source>
        <translation>Előtolás: emelkedés × fordulatszám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Feedrate</source>
        <translation>Előtolás</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Field</source>
        <translation>Adat</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Files</source>
        <translation>Fájlok</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Filter</source>
        <translation>Szűrő</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Finishing a contour</source>
        <translation>Kontúr simítása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance</source>
        <translation>Simítási ráhagyás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance X</source>
        <translation>Simítási ráhagyás X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance Z</source>
        <translation>Simítási ráhagyás Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Finishing passes</source>
        <translation>Simító fogások</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>First WINS server</source>
        <translation>Első WINS</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>First block of the contour</source>
        <translation>A kontúr első mondata</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>First name server</source>
        <translation>Első névkiszolgáló</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>First part</source>
        <translation>Első darab</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>First part %1</source>
        <translation>Első darab %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>Első darab: a start ezzel a szerszámmal folytatja</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>First to stop the machine: %1; parts until then: %2</source>
        <translation>Elsőként állítja meg a gépet: %1; darab addig: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Follow. error</source>
        <translation>Köv. hiba</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>For the offset and the gauge pin</source>
        <translation>A korrekcióhoz és a mérőcsaphoz</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Forget place</source>
        <translation>Hely törlése</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Found: %1</source>
        <translation>Találat: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Free</source>
        <translation>Szabad</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>From</source>
        <translation>Forrás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>From hole to hole</source>
        <translation>Furattól furatig</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>From rapid to feed (R level)</source>
        <translation>Gyorsból előtolásra (R szint)</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>From the beginning</source>
        <translation>Elölről</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>From the start to the first hole</source>
        <translation>A kezdettől az első furatig</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Full torque</source>
        <translation>Teljes nyomaték</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>G code</source>
        <translation>G kód</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Gateway</source>
        <translation>Átjáró</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Geom.</source>
        <translation>Geom.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Geometry + wear</source>
        <translation>Geometria + kopás</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Give this level</source>
        <translation>Szint megadása</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Given</source>
        <translation>Megadva</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Goes back to its own place</source>
        <translation>Visszatér a saját helyére</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Gradient Compensation</source>
        <translation>Lejtéskorrekció</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Graphics</source>
        <translation>Grafika</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Greatest, least deviation</source>
        <translation>Legnagyobb, legkisebb eltérés</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Grooving along X</source>
        <translation>Beszúrás X mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Grooving along Z</source>
        <translation>Beszúrás Z mentén</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Group %1</source>
        <translation>%1. csoport</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Handbook</source>
        <translation>Kézikönyv</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Kézikerék</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Handwheel offset</source>
        <translation>Kézikerekes eltolás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Height of the thread (radius)</source>
        <translation>Menetmagasság (sugár)</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Held</source>
        <translation>Előtolás állj</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Help</source>
        <translation>Súgó</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Highest bar: %1 of %2 ticks; both scales are logarithmic</source>
        <translation>Legmagasabb oszlop: %1 / %2 ütem; mindkét skála logaritmikus</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>History</source>
        <translation>Előzmények</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Hold %1</source>
        <translation>Állj %1</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Hold all</source>
        <translation>Állj: mind</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Hold group %1</source>
        <translation>Állj: %1. csoport</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>How</source>
        <translation>Hogyan</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>How long</source>
        <translation>Időtartam</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Hz</source>
        <translation>Hz</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Ignore waits %1</source>
        <translation>Bevárás nélkül %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>In position</source>
        <translation>Pozícióban</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>In the file</source>
        <translation>A fájlban</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>In this magazine</source>
        <translation>Ebben a tárban</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Increment in X (radius)</source>
        <translation>Növekmény X-ben (sugár)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Increment in Z</source>
        <translation>Növekmény Z-ben</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Input</source>
        <translation>Bevitel</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Megszakítva</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Interval meter</source>
        <translation>Szakaszidő-mérő</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>It acts at once: press again</source>
        <translation>Azonnal hat: újra</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>It cannot be read: %1</source>
        <translation>Nem olvasható: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>It cannot be shown.</source>
        <translation>Nem jeleníthető meg.</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>It comes by DHCP (N5108)</source>
        <translation>DHCP adja (N5108)</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>It follows the main spindle</source>
        <translation>Az ellenorsó követi a főorsót</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>It gave no result.</source>
        <translation>Nem adott eredményt.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>It is entered</source>
        <translation>Beírva</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>It is gone for good: press again</source>
        <translation>Végleg eltűnik: nyomja újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>It is gone: press again</source>
        <translation>Eltűnik: még egyszer</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>It is no text in UTF-8: it cannot be edited without a loss.</source>
        <translation>Nem UTF-8 szöveg: veszteség nélkül nem szerkeszthető.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>It is the gauge pin: press again</source>
        <translation>Ez a mérőcsap: még egyszer</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>It runs now: press again</source>
        <translation>Most fut: újra</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>It was stopped.</source>
        <translation>Leállítva.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Its blocks were edited by hand: writing replaces them.</source>
        <translation>A mondatokat kézzel módosították: az írás lecseréli őket.</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Its chuck clamps</source>
        <translation>Az ellenorsó tokmánya szorít</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Its chuck opens</source>
        <translation>Az ellenorsó tokmánya nyit</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Its data contradict each other, or nothing fits them.</source>
        <translation>Az adatok ellentmondanak, vagy semmi sem illik rájuk.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Its values go: press again</source>
        <translation>Értékei elvesznek: még egyszer</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Kézi</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Jog against the part</source>
        <translation>Kézzel a darabhoz</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Jog in hold %1</source>
        <translation>Kézi mozgatás álljban %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Jog keys</source>
        <translation>Tengelygombok</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Jog: pull the part out</source>
        <translation>Kézzel: darab kihúzása</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Keep as place</source>
        <translation>Hely mentése</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Kept, but: %1</source>
        <translation>Mentve, de: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Kept: %1</source>
        <translation>Mentve: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Keyboard</source>
        <translation>Billentyűzet</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Keyboard layout</source>
        <translation>Billentyűzetkiosztás</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Kind</source>
        <translation>Fajta</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Kind of infeed</source>
        <translation>Fogásvétel fajtája</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Kind of place that it needs, 0 any</source>
        <translation>Szükséges helyfajta, 0 bármely</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Kind: 500 roughing, 510 finishing, 200 drill ...</source>
        <translation>Fajta: 500 nagyoló, 510 simító, 200 fúró...</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>L%1 asks: %2</source>
        <translation>L%1 kérdezi: %2</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>L%1 decides %2 of %3: what becomes shorter there shortens the cycle.</source>
        <translation>Ciklusidő: %3, ebből %2 az L%1 csatornán múlik; ami ott rövidül, a ciklust is rövidíti.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>L%1 is in automatic mode: choose Jog or MDI</source>
        <translation>L%1 automata üzemmódban van: válasszon Kézit vagy MDI-t</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>L%1: restart at block</source>
        <translation>L%1: folytatás a mondattól</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>L%1: straightness, pair %2</source>
        <translation>L%1: egyenesség, %2. pár</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>L%1: volume</source>
        <translation>L%1: térfogat</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Lag</source>
        <translation>Köv. hiba</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Language of the screens</source>
        <translation>A képernyők nyelve</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Larger</source>
        <translation>Nagyítás</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Largest</source>
        <translation>Legnagyobb</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Largest speed</source>
        <translation>Legnagyobb fordulat</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Last</source>
        <translation>Utolsó</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Last block of the contour</source>
        <translation>A kontúr utolsó mondata</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Last tool call</source>
        <translation>Szerszámhívás</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Later</source>
        <translation>Később</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Lead</source>
        <translation>Menetemelkedés</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead along X</source>
        <translation>Menetemelkedés X mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead along Z</source>
        <translation>Menetemelkedés Z mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead as on the way in</source>
        <translation>Emelkedés, mint befelé</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead; negative: a left-hand thread</source>
        <translation>Emelkedés; negatív: bal menet</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Least depth of a pass</source>
        <translation>Legkisebb fogásmélység</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Least depth of a peck</source>
        <translation>Legkisebb lépésmélység</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Length</source>
        <translation>Hossz</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Length of the run-out</source>
        <translation>Kifutás hossza</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Level</source>
        <translation>Szint</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life</source>
        <translation>Éltartam</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Life and forecast</source>
        <translation>Éltartam és előrejelzés</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life and wear to 0: press again</source>
        <translation>Éltartam, kopás nullára: újra</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Life group of programs</source>
        <translation>Programok éltartamcsoportja</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Life left</source>
        <translation>Maradék éltartam</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Life measured in</source>
        <translation>Éltartam egysége</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Life nearly over</source>
        <translation>Éltartam fogytán</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life to 0, wear stays: press again</source>
        <translation>Éltartam nullára, kopás marad: újra</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Világos</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Line</source>
        <translation>Egyenes</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Line %1 of the description cannot be read: a new contour begins here.</source>
        <translation>A leírás %1. sora nem olvasható: itt új kontúr kezdődik.</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Little torque for the slide</source>
        <translation>Csökkentett nyomaték a szánon</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Load</source>
        <translation>Betöltés</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Loading station</source>
        <translation>Betöltő állomás</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Zárolás</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Lock place</source>
        <translation>Hely zárolása</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Lock tool</source>
        <translation>Szerszám zárolása</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Locked</source>
        <translation>Zárolt</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Zárolva tisztításhoz</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log in</source>
        <translation>Bejelentkezés</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log in to see the users.</source>
        <translation>Jelentkezzen be a felhasználók megtekintéséhez.</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Log of stops</source>
        <translation>Állásnapló</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log out</source>
        <translation>Kijelentkezés</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Logged in: %1, %2</source>
        <translation>Bejelentkezve: %1, %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Longer</source>
        <translation>Hosszabb ablak</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Longest wait: L%1 stands %2 s at %3 (line %4).</source>
        <translation>Leghosszabb bevárás: L%1, %3 (%4. sor), %2 s.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Ellenőrizze, fut-e a vezérlő; próbálja újra.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Lost: %1</source>
        <translation>Elveszett: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Lower</source>
        <translation>Alsó</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>M code</source>
        <translation>M kód</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>MDI</source>
        <translation>MDI</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>MDI mode takes blocks, and a program in hold</source>
        <translation>Mondatot az MDI mód és az álló program vesz át</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>MEFI constants</source>
        <translation>MEFI-állandók</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Machine</source>
        <translation>Gép</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Géplezárás</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Machine lock %1</source>
        <translation>Géplezárás %1</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Machine off</source>
        <translation>Gép kikapcsolva</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Machine on</source>
        <translation>Gép be</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Macro</source>
        <translation>Makrók</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Magazines</source>
        <translation>Tárak</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Main axis: 0 Z, 1 X</source>
        <translation>Főtengely: 0 Z, 1 X</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.hpp"/>
        <source>Manual</source>
        <translation>Kézi</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Manual Handle</source>
        <translation>Kézikerék</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Mark</source>
        <translation>Kijelölés</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Marked: %1</source>
        <translation>Kijelölve: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Max</source>
        <translation>Max.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>May be used</source>
        <translation>Használható</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Átlag</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Meaning</source>
        <translation>Jelentés</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Measure</source>
        <translation>Mérés</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Measured</source>
        <translation>Mért</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Measured file</source>
        <translation>Mérési fájl</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Measured parts</source>
        <translation>Mért darabok</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Measured: %1</source>
        <translation>Mért: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Measures ...</source>
        <translation>Mér...</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Message</source>
        <translation>Üzenet</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Min</source>
        <translation>Min.</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>More</source>
        <translation>Tovább</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Mounted</source>
        <translation>Behelyezve</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Move</source>
        <translation>Áthelyezés</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Moves</source>
        <translation>Mozog</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Multichannel Control</source>
        <translation>Többcsatornás vezérlés</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>NC</source>
        <translation>NC</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Name</source>
        <translation>Név</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Name of the dimension</source>
        <translation>A méret neve</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Network</source>
        <translation>Hálózat</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Network address</source>
        <translation>Hálózati cím</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>New dimension</source>
        <translation>Új méret</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>New edge</source>
        <translation>Új él</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New folder</source>
        <translation>Új mappa</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>New insert</source>
        <translation>Új lapka</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New name</source>
        <translation>Új név</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New program</source>
        <translation>Új program</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>New tool</source>
        <translation>Új szerszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>New user</source>
        <translation>Új felhasználó</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Next difference</source>
        <translation>Következő eltérés</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Next fault</source>
        <translation>Következő hiba</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Next page</source>
        <translation>Következő oldal</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Next part</source>
        <translation>Következő rész</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Next solution</source>
        <translation>Másik megoldás</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>No active alarms.</source>
        <translation>Nincs aktív riasztás.</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>No alarm and no message is known yet.</source>
        <translation>Még nem volt riasztás vagy üzenet.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>No block is entered</source>
        <translation>Nincs beírva mondat</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>No changes recorded.</source>
        <translation>Nincs rögzített változás.</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>No channel has stood in this time.</source>
        <translation>Ez alatt egy csatorna sem állt.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>No circle has been driven since the record began: drive at least three quarters of one in L%1</source>
        <translation>A rögzítés kezdete óta nem volt kör: járjon be legalább háromnegyedet L%1-ben</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>No compensation table is described (N2500 to N2808).</source>
        <translation>Nincs megadva kompenzációs táblázat (N2500 ... N2808).</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>A vezérlő nem válaszol</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>No faults found</source>
        <translation>Nincs hiba</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>No forecast yet: it begins when parts have been made with tools whose life is monitored.</source>
        <translation>Még nincs előrejelzés: akkor kezdődik, ha figyelt éltartamú szerszámmal készült darab.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>No job names the stock of the running program</source>
        <translation>Egyik megbízás sem adja meg a nyersdarabot</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>No network connection is managed here</source>
        <translation>Itt nincs kezelt hálózati kapcsolat</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>No parameter has this in its number, name or meaning.</source>
        <translation>Nincs paraméter ilyen számmal, névvel vagy jelentéssel.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>No part transfer is set up on this machine: its channels choose no counter spindle.</source>
        <translation>Ezen a gépen nincs beállítva darabátadás: a csatornái nem választanak ellenorsót.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>No pictures (PGM, BMP, PNG) in this folder.</source>
        <translation>Ebben a mappában nincs kép (PGM, BMP, PNG).</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>No program is selected.</source>
        <translation>Nincs kiválasztott program.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No signal has this in its name or meaning.</source>
        <translation>Nincs jel ilyen névvel vagy jelentéssel.</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>No start</source>
        <translation>Nincs start</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>No tool has been called where the programs stopped: touch a block, or type its number</source>
        <translation>A megállásig nem volt szerszámhívás: érintsen meg egy mondatot, vagy írja be a számát</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>No tool is chosen.</source>
        <translation>Nincs kiválasztott szerszám.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>No tool is like this.</source>
        <translation>Nincs ilyen szerszám.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_plot.cpp"/>
        <source>No trace is chosen: Enter on a line, or touch it twice</source>
        <translation>Nincs jel kiválasztva: Enter a soron vagy kettős érintés</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No variable has this in its name.</source>
        <translation>Nincs ilyen nevű változó.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No variable of this channel has a value.</source>
        <translation>A csatornának nincs értékkel bíró változója.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>No.</source>
        <translation>Sz.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Nobody is logged in. Without a login: %1</source>
        <translation>Senki sincs bejelentkezve. Anélkül: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Nominal</source>
        <translation>Névleges</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>None is known.</source>
        <translation>Nem ismert.</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Not described: enter its parameters.</source>
        <translation>Nincs leírva: adja meg a paramétereit.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Not done: %1</source>
        <translation>Nem sikerült: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Not enabled</source>
        <translation>Nincs engedélyezve</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Not in position</source>
        <translation>Nincs pozícióban</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Not in use by the running program</source>
        <translation>A program nem használja</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Not loaded</source>
        <translation>Nincs betöltve</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>Not saved: stopped. The file is as it was.</source>
        <translation>Nincs mentve: leállítva. A fájl változatlan.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Nothing has been changed.</source>
        <translation>Semmi sem változott.</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>Nothing is like this. Escape shows all.</source>
        <translation>Ilyen nincs. Escape mindent mutat.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Nothing is missing for a start</source>
        <translation>Az indításhoz semmi sem hiányzik</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Nothing to load: every tool has a place</source>
        <translation>Nincs mit betölteni: minden szerszámnak van helye</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Nothing to simulate: %1</source>
        <translation>Nincs mit szimulálni: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Nothing would change</source>
        <translation>Semmi sem változna</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Now</source>
        <translation>Most</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Number</source>
        <translation>Szám</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Number of holes</source>
        <translation>Furatok száma</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Number of its first block</source>
        <translation>Első mondat száma</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Number of its last block</source>
        <translation>Utolsó mondat száma</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Number of passes</source>
        <translation>Fogások száma</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Number of starts</source>
        <translation>Bekezdések száma</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Offset</source>
        <translation>Korrekció</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Offset number</source>
        <translation>Korrekció száma</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Offset number of the radius</source>
        <translation>Sugárkorrekció száma</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Offsets</source>
        <translation>Korrekciók</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>One ring</source>
        <translation>Gyűrűk távolsága</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>Only L%1</source>
        <translation>Csak L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Only a maker can confirm: log in on the page «Users».</source>
        <translation>Csak a gépgyártó erősítheti meg: jelentkezzen be a «Felhasználók» lapon.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Only a whole number is possible.</source>
        <translation>Csak egész szám lehet.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Only more than 0 is possible here.</source>
        <translation>Itt csak 0-nál nagyobb lehet.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Open folder</source>
        <translation>Mappa megnyitása</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Open the program</source>
        <translation>Program megnyitása</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Open: %1 more data are needed, here or in the next elements.</source>
        <translation>Nyitott: még %1 adat kell, itt vagy a következő elemekben.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Open: what lies before it is not known yet.</source>
        <translation>Nyitott: ami előtte van, még nem ismert.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Operation time</source>
        <translation>Üzemidő</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Feltételes állj</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Feltételes állj %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Feltételes megállás M1: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Order among sisters</source>
        <translation>Sorrend a testvérszerszámok között</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Other</source>
        <translation>Egyéb</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other edges than the job's hold: %1</source>
        <translation>Nem a megbízás élei érvényesek: %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Other feeds than programmed: press again</source>
        <translation>A programtól eltérő előtolás: újra</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Other files may name it: press again</source>
        <translation>Más fájlok hivatkozhatják: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Other level</source>
        <translation>Másik szint</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other offsets than the job's hold: %1</source>
        <translation>Nem a megbízás korrekciói érvényesek: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other zeros than the job's hold: %1</source>
        <translation>Nem a megbízás nullpontjai érvényesek: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Outline that protection guards: X -60:0 Z -20:5</source>
        <translation>Védett körvonal: X -60:0 Z -20:5</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Overrides</source>
        <translation>Override</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.hpp"/>
        <source>Overview</source>
        <translation>Áttekintés</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Own folder</source>
        <translation>Saját mappa</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Own magazine</source>
        <translation>Saját tár</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Own place</source>
        <translation>Saját hely</translation>
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
        <translation>PLC-állandók</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Page down</source>
        <translation>Lap le</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Page up</source>
        <translation>Lap fel</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pallet</source>
        <translation>Paletta</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Pallet Management</source>
        <translation>Paletták</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pallet number, 0: no pallet</source>
        <translation>Paletta száma, 0: nincs</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Pallets</source>
        <translation>Paletták</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Panel computer</source>
        <translation>Számítógép</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Parameters</source>
        <translation>Paraméterek</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Part before</source>
        <translation>Előző rész</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Part time</source>
        <translation>Darabidő</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Part transfer, step by step</source>
        <translation>Darabátadás lépésenként</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Parts</source>
        <translation>Darabszám</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Parts go on: press again</source>
        <translation>Tovább gyárt: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts in all</source>
        <translation>Összes darabszám</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Parts left</source>
        <translation>Hátralévő darab</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts of this job</source>
        <translation>A megbízás darabszáma</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts since the start</source>
        <translation>Darabszám indítás óta</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts wanted</source>
        <translation>Előírt darabszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Password</source>
        <translation>Jelszó</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Path backwards %1</source>
        <translation>Pályán vissza %1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Paths since these screens started; tips drawn as points</source>
        <translation>Szerszámpályák a képernyők indítása óta; a csúcs pont</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Pattern menu</source>
        <translation>Mintaábra-menü</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Pause</source>
        <translation>Szünet</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Pecking and grooving along Z</source>
        <translation>Lépéses beszúrás Z mentén</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Per division</source>
        <translation>Egy osztás</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>Period</source>
        <translation>Időszak</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Picture</source>
        <translation>Kép</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Pitch Error Compensation</source>
        <translation>Emelkedéshiba</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Place</source>
        <translation>Hely</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Place of the hole C</source>
        <translation>Furat helye C</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Place of the hole X</source>
        <translation>Furat helye X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Place of the hole Z</source>
        <translation>Furat helye Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Places</source>
        <translation>Helyek</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Places of holes along a line</source>
        <translation>Furatok helye egyenes mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Places of holes on a circle</source>
        <translation>Furatok helye körön</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Plain S means the counter spindle</source>
        <translation>A szám nélküli S az ellenorsóé</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Plain S means the main spindle</source>
        <translation>A szám nélküli S a főorsóé</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Plain S of L%1 means S%2 now: M%3 would act on its chuck.</source>
        <translation>L%1: a szám nélküli S most az S%2 orsóé; az M%3 annak tokmányára hatna.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Play</source>
        <translation>Lejátszás</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Points</source>
        <translation>Pontok</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Polyturn</source>
        <translation>Polyturn</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pool %1</source>
        <translation>Tároló %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Position</source>
        <translation>Pozíció</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Position Switches</source>
        <translation>Helyzetkapcsolók</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Power on</source>
        <translation>Bekapcsolva</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Presetter</source>
        <translation>Bemérőkészülék</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Previous difference</source>
        <translation>Előző eltérés</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Print setup sheet</source>
        <translation>Beállítólap nyomtatása</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Printed: %1</source>
        <translation>Kinyomtatva: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Probe is offset %1: press again</source>
        <translation>Tapintó: %1. korrekció, újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Process</source>
        <translation>Folyamat</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>A folyamat leállt</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Processes</source>
        <translation>Folyamatok</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Processes and ticks</source>
        <translation>Folyamatok és ütemek</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Program</source>
        <translation>Program</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Program control</source>
        <translation>Programvezérlés</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Program of the pallet</source>
        <translation>A paletta programja</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Program with the contour</source>
        <translation>A kontúr programja</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Programmed stop</source>
        <translation>Programozott állj</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Programozott megállás M0: a start folytatja</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Programs</source>
        <translation>Programok</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Programs and jobs</source>
        <translation>Programok és megbízások</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Proposal</source>
        <translation>Javaslat</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Proposal: %1</source>
        <translation>Javaslat: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Protect</source>
        <translation>Védelem</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Protected</source>
        <translation>Védett</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Put it here</source>
        <translation>Ide tenni</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Radius</source>
        <translation>Sugár</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Radius of the arc</source>
        <translation>Az ív sugara</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Radius of the circle of holes</source>
        <translation>A furatkör sugara</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Radius, commanded</source>
        <translation>Sugár, előírt</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Range</source>
        <translation>Tartomány</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Range %1 of L%2</source>
        <translation>L%2 %1. tartománya</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Rapid</source>
        <translation>Gyorsjárat</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Rapid %1 %</source>
        <translation>Gyors %1 %</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Ready</source>
        <translation>Üzemkész</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reaming (in G17 along Z)</source>
        <translation>Dörzsárazás (G17-ben Z mentén)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reaming behind each block that moves</source>
        <translation>Dörzsárazás minden mozgó mondat után</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Record</source>
        <translation>Rögzítés</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Records</source>
        <translation>Rögzítés folyamatban</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Redo</source>
        <translation>Újra</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Reference Point</source>
        <translation>Referenciapont</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Reference all</source>
        <translation>Összes tengely referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reference plane: the surface</source>
        <translation>Vonatkoztatási sík: a felület</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Refresh</source>
        <translation>Frissítés</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Relative input</source>
        <translation>Relatív bevitel</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Relative zero</source>
        <translation>Relatív nulla</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Release place</source>
        <translation>Hely feloldása</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Release tool</source>
        <translation>Szerszám feloldása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Relief at the bottom</source>
        <translation>Elhúzás az alján</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Hátravan</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Remedy</source>
        <translation>Teendő</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Rename</source>
        <translation>Átnevezés</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Renamed</source>
        <translation>Átnevezve</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Repair: where the thread was measured</source>
        <translation>Javítás: hol mérték a menetet</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Repeating a contour</source>
        <translation>Kontúr ismétlése</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Repeats in a second</source>
        <translation>Ismétlés másodpercenként</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Replaces the one that is here: press again</source>
        <translation>Az ittenit felülírja: nyomja újra</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Replaces what is entered: press again</source>
        <translation>A beírtakat felülírja: még egyszer</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Required tools</source>
        <translation>Szükséges szerszámok</translation>
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
        <translation>Reset: mind</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset group %1</source>
        <translation>Reset: %1. csoport</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Restart</source>
        <translation>Újraindítás</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Restart at</source>
        <translation>Folytatás innen</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Restart in the middle</source>
        <translation>Indítás mondattól</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Újraindítás: a start elvégzi a ráállást</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Restore</source>
        <translation>Visszaállítás</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Restored values and files: %1</source>
        <translation>Visszaállított értékek és fájlok: %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>A visszakövetés a végére ért</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Retract after each pass</source>
        <translation>Kiemelés fogásonként</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Retract plane</source>
        <translation>Visszahúzási sík</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Return %1</source>
        <translation>Vissza %1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Rigid tapping</source>
        <translation>Merevszárú menetfúrás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the face</source>
        <translation>Merevszárú menetfúrás a homlokon</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the face, the way back</source>
        <translation>Merevszárú menetfúrás a homlokon, visszaút</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the side</source>
        <translation>Merevszárú menetfúrás oldalról</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the side, the way back</source>
        <translation>Merevszárú menetfúrás oldalról, visszaút</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Rigid tapping of a left-hand thread</source>
        <translation>Merevszárú balmenetfúrás</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room above, half places</source>
        <translation>Hely felül, félhely</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room below, half places</source>
        <translation>Hely alul, félhely</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room to the left, half places</source>
        <translation>Hely balra, félhely</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room to the right, half places</source>
        <translation>Hely jobbra, félhely</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Roughing along X</source>
        <translation>Nagyolás X mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Roughing along Z</source>
        <translation>Nagyolás Z mentén</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Rounding to the next one</source>
        <translation>Lekerekítés a következőhöz</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Run-in; -1: as the axis accelerates</source>
        <translation>Ráfutás; -1: ahogy a tengely gyorsul</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Run-out in tenths of the lead</source>
        <translation>Kifutás az emelkedés tizedében</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Run-out; -1: as the axis brakes</source>
        <translation>Kifutás; -1: ahogy a tengely fékez</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Fut</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Runs in and out within the thread: 1</source>
        <translation>Be- és kifutás a meneten belül: 1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Safety distance</source>
        <translation>Biztonsági távolság</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Safety distance before the surface</source>
        <translation>Biztonsági távolság a felület előtt</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Safety distance of the way back</source>
        <translation>Visszahúzás biztonsági távolsága</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Save</source>
        <translation>Mentés</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Save now</source>
        <translation>Mentés most</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Saved: %1</source>
        <translation>Mentve: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Saves the text first: press again</source>
        <translation>Előbb elmenti a szöveget: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Scope</source>
        <translation>Oszcilloszkóp</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Search</source>
        <translation>Keresés</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: a zero</source>
        <translation>Keresés: nullpont</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: number or tool</source>
        <translation>Keresés: szám vagy szerszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Search: number, name or meaning</source>
        <translation>Keresés: szám, név vagy jelentés</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: number, tool, edge</source>
        <translation>Keresés: szám, szerszám, él</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Second WINS server</source>
        <translation>Második WINS</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Second name server</source>
        <translation>Második névkiszolgáló</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Select in L%1</source>
        <translation>Kiválasztás: L%1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Select job</source>
        <translation>Megbízás kiválasztása</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Sets the default: press again</source>
        <translation>Alapérték: újra</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Sets the zero: press again</source>
        <translation>Nullát állít: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Setting</source>
        <translation>Beállítás</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Several solutions: touch the one that is meant, or «Next solution».</source>
        <translation>Több megoldás: érintse meg a kívántat, vagy „Másik megoldás”.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Shorter</source>
        <translation>Rövidebb ablak</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Signal</source>
        <translation>Jel</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Signals</source>
        <translation>Jelek</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Signals of NC and PLC</source>
        <translation>Az NC és a PLC jelei</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Simulation</source>
        <translation>Szimuláció</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Simulation, timeline</source>
        <translation>Szimuláció, idővonal</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Simulation: %1 of %2</source>
        <translation>Szimuláció: %1 / %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Since</source>
        <translation>Mióta</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Single block</source>
        <translation>Mondatonként</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block %1</source>
        <translation>Mondatonként %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block all</source>
        <translation>Mondatonként: mind</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block group %1</source>
        <translation>Mondatonként: %1. csoport</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Mondatonként: a start a következőt hajtja végre</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Sinumerik</source>
        <translation>Sinumerik</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Sister</source>
        <translation>Testvérszerszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Size</source>
        <translation>Méret</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Skip Function</source>
        <translation>Skip funkció</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Slower</source>
        <translation>Lassabban</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Smaller</source>
        <translation>Kicsinyítés</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Smoothing</source>
        <translation>Simítás</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>So much left is a warning</source>
        <translation>Ennyi maradéknál figyelmeztet</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Solid outline: monitored; dashed: drawn only</source>
        <translation>Folytonos körvonal: ütközésre figyelt; szaggatott: csak rajz</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Some elements are still open.</source>
        <translation>Néhány elem még nyitott.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Some ticks were missed</source>
        <translation>Néhány ütem kimaradt</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Speed not reached</source>
        <translation>Fordulat nincs elérve</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Speed of the spindle</source>
        <translation>Főorsó fordulatszáma</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Speed reached</source>
        <translation>Fordulat elérve</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Spindle</source>
        <translation>Orsó</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Spindle %1</source>
        <translation>Főorsó %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Spindle Control</source>
        <translation>Orsók</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Spindle Servo</source>
        <translation>Orsóhajtások</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Spindle stop</source>
        <translation>Főorsó állj</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Stands</source>
        <translation>Áll</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start</source>
        <translation>Kezdet</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start all</source>
        <translation>Start: mind</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Start blocked:</source>
        <translation>Az indítás tiltva:</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Start goes back along the path: press again</source>
        <translation>A start visszafelé visz a pályán: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Start goes backwards</source>
        <translation>A start visszafelé visz</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start group %1</source>
        <translation>Start: %1. csoport</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Start of the line, 1st axis (X: radius)</source>
        <translation>Vonal kezdete, 1. tengely (X: sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Start of the line, 2nd axis (X: radius)</source>
        <translation>Vonal kezdete, 2. tengely (X: sugár)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start point X</source>
        <translation>Kezdőpont X</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start point Z</source>
        <translation>Kezdőpont Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Starts</source>
        <translation>Indul</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Mindet indítja: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Starts the whole group: press again</source>
        <translation>Az egész csoportot indítja: újra</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>State</source>
        <translation>Állapot</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Station</source>
        <translation>Állomás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Step along X (radius)</source>
        <translation>Lépés X mentén (sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Step along Z</source>
        <translation>Lépés Z mentén</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Step between two plunges</source>
        <translation>Lépés két beszúrás között</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Stock</source>
        <translation>Nyersdarab</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Stock to take off</source>
        <translation>Leválasztandó ráhagyás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Stock to take off along X (radius)</source>
        <translation>Ráhagyás X mentén (sugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Stock to take off along Z</source>
        <translation>Ráhagyás Z mentén</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Stop</source>
        <translation>Állj</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Stop record</source>
        <translation>Rögzítés leállítása</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Megállt</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Stopped at</source>
        <translation>Megállás helye</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Stopped: %1</source>
        <translation>Leállítva: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Straightness Compensation</source>
        <translation>Egyenesség</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Subnet mask</source>
        <translation>Alhálózati maszk</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Surface Z</source>
        <translation>Felület Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Switched off</source>
        <translation>Kikapcsolva</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Switches the drives on: press again</source>
        <translation>Bekapcsolja a hajtásokat: még egyszer</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Synchronised view</source>
        <translation>Szinkron nézet</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.hpp"/>
        <source>System</source>
        <translation>Rendszer</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>System Config</source>
        <translation>Rendszer</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Table</source>
        <translation>Táblázat</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Tailstock %1</source>
        <translation>Szegnyereg %1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Tailstock zone of L%1</source>
        <translation>Szegnyeregzóna L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Take a measured file</source>
        <translation>Mérési fájl átvétele</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Tangential to the one before (1: yes)</source>
        <translation>Érintő az előzőhöz (1: igen)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Tangential to what? Nothing lies before it.</source>
        <translation>Mihez érintő? Semmi sincs előtte.</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Taper (Z at the start less that at the end)</source>
        <translation>Kúp (kezdő Z mínusz vég Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Taper (radius at the start less that at the end)</source>
        <translation>Kúp (kezdősugár mínusz végsugár)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping</source>
        <translation>Menetfúrás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping a left-hand thread</source>
        <translation>Balmenet fúrása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping in the face</source>
        <translation>Menetfúrás a homlokon</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Tapping in the face with a compensating chuck</source>
        <translation>Menetfúrás a homlokon kiegyenlítő tokmánnyal</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping in the side</source>
        <translation>Menetfúrás oldalról</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Tapping in the side with a compensating chuck</source>
        <translation>Menetfúrás oldalról kiegyenlítő tokmánnyal</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Text</source>
        <translation>Szöveg</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>The NC writes it.</source>
        <translation>Az NC írja.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>The PLC writes it.</source>
        <translation>A PLC írja.</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The axes are free: press again</source>
        <translation>A tengelyek szabadok: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The axes go back: press again</source>
        <translation>A tengelyek visszamennek: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>The axes move again: press again</source>
        <translation>A tengelyek járnak: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>The axes stand while the program runs: press again</source>
        <translation>A program fut, a tengelyek állnak: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The blocks are searched: nothing moves</source>
        <translation>A mondatok keresése folyik: semmi sem mozog</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>The contour is complete.</source>
        <translation>A kontúr teljes.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>A vezérlő nem adott választ.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>A vezérlő elutasította.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The copy of %1 was not what had been sent; what was there before stands</source>
        <translation>A(z) %1 másolata nem egyezett; a korábbi fájl megmaradt</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The counter spindle is free</source>
        <translation>Az ellenorsó szinkronja oldva</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The editor holds a text that is not saved</source>
        <translation>A szerkesztőben mentetlen szöveg van</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The file is being read ...</source>
        <translation>Fájl olvasása...</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The folder is being read ...</source>
        <translation>Mappa olvasása...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The job is being simulated</source>
        <translation>A megbízás szimulációja fut</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>The job is for another machine: %1</source>
        <translation>A megbízás másik géphez való: %1</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>The keys below act when they are kept pressed.</source>
        <translation>Az alsó billentyűk nyomva tartva hatnak.</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>The last %1 days</source>
        <translation>Utolsó %1 nap</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>The last %1 h</source>
        <translation>Utolsó %1 óra</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>The last program is still being written.</source>
        <translation>Az előző program írása még folyik.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The line of MDI is not entered: choose MDI, or delete the line</source>
        <translation>Az MDI sor nincs beírva: válassza az MDI-t, vagy törölje a sort</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>The machine has lost data: no program starts</source>
        <translation>A gép adatokat vesztett: egyetlen program sem indul</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The main chuck clamps</source>
        <translation>A fő tokmány szorít</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The main chuck opens</source>
        <translation>A fő tokmány nyit</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>The manual is not installed here.</source>
        <translation>A kézikönyv itt nincs telepítve.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>The newest backup: %1</source>
        <translation>A legújabb mentés: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>The offset is written</source>
        <translation>A korrekció be van írva</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>The operating system keeps these values and says who may change them; Enter, or a second touch, changes one.</source>
        <translation>Ezeket az operációs rendszer tárolja és dönti el, ki módosíthatja; Enter vagy második érintés módosít.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>The pallet in a row goes with its program. «Exchange»: choose a row, press, choose the other row, press again.</source>
        <translation>A paletta a programjával együtt cserélődik. „Csere”: válasszon sort, nyomja meg, válassza a másikat, nyomja meg újra.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>The pallets are being asked for ...</source>
        <translation>A paletták lekérdezése...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The printer refused it: %1</source>
        <translation>A nyomtató visszautasította: %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>The program asks: answer on its page</source>
        <translation>A program kérdez: válaszoljon az oldalán</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>The program cannot be checked here.</source>
        <translation>A program itt nem ellenőrizhető.</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>The program is being read</source>
        <translation>A program olvasása folyik</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>The program of L%1 waits for an answer</source>
        <translation>Az L%1 programja válaszra vár</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>The program polyturn is not beside the HMI.</source>
        <translation>A polyturn program nincs a HMI mellett.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The program runs</source>
        <translation>A program fut</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>The program was broken off</source>
        <translation>A program megszakadt</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>The programs are being compared ...</source>
        <translation>Összehasonlítás...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The programs are being read</source>
        <translation>A programok olvasása folyik</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>The relative counter of L%1 begins here</source>
        <translation>L%1 relatív számlálója innen indul</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The restart was refused, nothing has moved: see the alarms</source>
        <translation>Az újraindítást elutasította, semmi sem mozdult: lásd a hibákat</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>The scope records other signals: «Axes of L%1» chooses the axes of a circle</source>
        <translation>Az oszcilloszkóp más jeleket rögzít: az „L%1 tengelyei” a kör tengelyeit választja</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The setup sheet is not written: stopped.</source>
        <translation>A beállítási lap nincs megírva: leállítva.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>The simulation is being computed: %1 so far</source>
        <translation>A szimuláció számítása folyik: eddig %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>The spindle turns: press again</source>
        <translation>A főorsó forogni fog: újra</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>The turret turns: press again</source>
        <translation>A revolver fordul: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Then</source>
        <translation>Visszaállítás után</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>There are no dimensions yet: «New dimension».</source>
        <translation>Még nincs méret: „Új méret”.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>There are no tools yet: «New tool» on the page of tool data.</source>
        <translation>Még nincs szerszám: „Új szerszám” az adatok lapján.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There are no users: everybody may do everything. The first one must be a maker.</source>
        <translation>Nincs felhasználó: mindenki mindent tehet. Az elsőnek gyártónak kell lennie.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There is no backup beside the store: choose one from a stick or the network.</source>
        <translation>A tároló mellett nincs mentés: válasszon egyet pendrive-ról vagy a hálózatról.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There is no backup in this folder.</source>
        <translation>Ebben a mappában nincs mentés.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>There is no block N%1 in this program yet.</source>
        <translation>N%1 mondat még nincs ebben a programban.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Nincs kapcsolat a vezérlővel.</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>There is no field of text here</source>
        <translation>Itt nincs szövegmező</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>There is no time zone %1</source>
        <translation>Nincs %1 időzóna</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>They are the same</source>
        <translation>Egyformák</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>They are very different</source>
        <translation>Nagyon különböznek</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>This channel has no offsets.</source>
        <translation>Ennek a csatornának nincsenek korrekciói.</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>This channel has no tools: enter them on the page of tools.</source>
        <translation>Ennek a csatornának nincs szerszáma: vigye fel őket a szerszámok oldalán.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>This channel has no turret.</source>
        <translation>A csatornának nincs revolvere.</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This computer has no %1</source>
        <translation>Ezen a számítógépen nincs %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This computer runs without systemd</source>
        <translation>Ez a számítógép systemd nélkül fut</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>This folder cannot be read.</source>
        <translation>Ez a mappa nem olvasható.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>This folder is empty.</source>
        <translation>A mappa üres.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>This is here</source>
        <translation>Itt ennyi</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>This is no number.</source>
        <translation>Ez nem szám.</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>This language has no cycles.</source>
        <translation>Ebben a nyelvben nincsenek ciklusok.</translation>
    </message>
    <message>
        <location filename="../widgets/pictures/magazine.cpp"/>
        <source>This machine has no magazine: PT_TURRET_MAGAZINE and N2905 to N2922 describe it.</source>
        <translation>Ennek a gépnek nincs tára: a PT_TURRET_MAGAZINE és az N2905–N2922 írja le.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>This machine has no pallets (N3300).</source>
        <translation>Ennek a gépnek nincs palettája (N3300).</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>This needs the level of a setter: log in</source>
        <translation>Beállítói szint kell: jelentkezzen be</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This system knows no WINS: names come from the name servers</source>
        <translation>Ez a rendszer nem ismer WINS-t: a neveket a DNS adja</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, one pass</source>
        <translation>Menet Z mentén, egy fogás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, the lead grows</source>
        <translation>Menet Z mentén, növekvő emelkedés</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, the lead shrinks</source>
        <translation>Menet Z mentén, csökkenő emelkedés</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Thread in several passes</source>
        <translation>Menet több fogással</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Thread in the face</source>
        <translation>Menet a homlokon</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, one pass</source>
        <translation>Menet a homlokon, egy fogás</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, the lead grows</source>
        <translation>Menet a homlokon, növekvő emelkedés</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, the lead shrinks</source>
        <translation>Menet a homlokon, csökkenő emelkedés</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Thread, one pass</source>
        <translation>Menet, egy fogás</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Three Dimensional Compensation</source>
        <translation>Térbeli korrekció</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Time</source>
        <translation>Idő</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time before a key repeats</source>
        <translation>Billentyűismétlés késleltetése</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time from the network</source>
        <translation>Idő a hálózatról</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Time left</source>
        <translation>Hátralévő idő</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time zone</source>
        <translation>Időzóna</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Timeline</source>
        <translation>Idővonal</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Timers and counters</source>
        <translation>Időzítők és számlálók</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Timers, counters</source>
        <translation>Számlálók</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Timers/Counters</source>
        <translation>Időzítők, számlálók</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Tip</source>
        <translation>Csúcs</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Tip is at this measure: press again</source>
        <translation>A csúcs a méreten: újra</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>To be replaced</source>
        <translation>Cserélendő</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>To go</source>
        <translation>Hátralévő</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>To load: choose a tool without a place in the list</source>
        <translation>Betöltéshez: válasszon a listából hely nélküli szerszámot</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>To the backups</source>
        <translation>A mentésekhez</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>To the offsets</source>
        <translation>A korrekciókhoz</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>To the start: 0 not, 1 feed, 2 rapid</source>
        <translation>A kezdethez: 0 nem, 1 előtolás, 2 gyors</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Too large: at most %1.</source>
        <translation>Túl nagy: legfeljebb %1.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Too small: at least %1.</source>
        <translation>Túl kicsi: legalább %1.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Tool</source>
        <translation>Szerszám</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Tool %1 is new: enter what it is</source>
        <translation>A(z) %1. szerszám új: adja meg az adatait</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Compensation</source>
        <translation>Szerszámkorrekció</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Holder Interference</source>
        <translation>Szántartók védelme</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Management</source>
        <translation>Szerszámkezelés</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Tool data</source>
        <translation>Adatok</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Tool edges</source>
        <translation>Szerszámélek</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Tool life (0: not monitored)</source>
        <translation>Éltartam (0: nem figyelt)</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Tool number</source>
        <translation>Szerszám száma</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Tool offsets</source>
        <translation>Korrekciók</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Tool setter</source>
        <translation>Szerszám bemérése</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Tool unit, 0 all</source>
        <translation>Szerszámegység, 0 mind</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.hpp"/>
        <source>Tools</source>
        <translation>Szerszámok</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Torque</source>
        <translation>Nyomaték</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Touch again or Enter: enlarged</source>
        <translation>Még egy érintés vagy Enter: nagyítás</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Touch the bit again: it is turned over</source>
        <translation>Érintse meg még egyszer a bitet: átvált</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Touch, or Enter: a text</source>
        <translation>Érintés vagy Enter: szöveg</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Touches and keys do nothing. Unlocks by itself in %1 s, at once when an alarm comes.</source>
        <translation>Az érintés és a billentyűk nem hatnak. Magától felold %1 s múlva, riasztáskor azonnal.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trace off</source>
        <translation>Jel kikapcsolása</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Travel of L%1</source>
        <translation>L%1 mozgástartománya</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger downwards</source>
        <translation>Lefutó él</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger level</source>
        <translation>Triggerszint</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger upwards</source>
        <translation>Felfutó él</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Triggered</source>
        <translation>Indítva</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Turning Cycles</source>
        <translation>Esztergaciklusok</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Turning a straight section</source>
        <translation>Egyenes szakasz esztergálása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Turning an arc</source>
        <translation>Ív esztergálása</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Turning, one pass</source>
        <translation>Esztergálás, egy fogás</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Turret L%1</source>
        <translation>L%1 revolverfej</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Type</source>
        <translation>Típus</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type a number or touch it, then Input.</source>
        <translation>Írja be vagy érintse a számot, majd „Bevitel”.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Type a part of the name</source>
        <translation>Írja be a név egy részét</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type number: the T that calls it</source>
        <translation>Típusszám (T-vel ezt hívják)</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type, then Enter.</source>
        <translation>Írja be, majd Enter.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>USB</source>
        <translation>USB</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>USB sticks and network places appear when they are there. «Keep as place» adds the folder that is shown; /etc/polyturn/places names those of the shop: NAME=/FOLDER.</source>
        <translation>Az USB és a hálózati helyek megjelennek, ha elérhetők. A „Hely mentése” a látható mappát veszi fel; az üzem helyei: /etc/polyturn/places, NÉV=/MAPPA.</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Undo</source>
        <translation>Visszavonás</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Undo zeros, offsets</source>
        <translation>Nullpontok, korrekciók vissza</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Unit</source>
        <translation>Egység</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Unload</source>
        <translation>Kivétel</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Unlock</source>
        <translation>Feloldás</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Unsaved text goes: press again</source>
        <translation>A nem mentett elvész: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Up</source>
        <translation>Egy szinttel feljebb</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Upper</source>
        <translation>Felső</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Used up</source>
        <translation>Elhasznált rész</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>User</source>
        <translation>Felhasználó</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Users</source>
        <translation>Felhasználók</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Value</source>
        <translation>Érték</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Values and files that would change: %1</source>
        <translation>Változó értékek és fájlok: %1</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Variable</source>
        <translation>Változó</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Variables</source>
        <translation>Változók</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Waiting</source>
        <translation>Bevárás</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Várakozás a vezérlőre</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Vár</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits at %1 for %2, %3 so far</source>
        <translation>%1: az %2 csatornára vár, %3 ideje</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Vár itt: %1, mindenki itt van</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Waits for a channel</source>
        <translation>Csatornára vár</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Waits for the trigger</source>
        <translation>Triggerre vár</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Waits ignored</source>
        <translation>Bevárások nélkül</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Wanted</source>
        <translation>Előírt</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Way back after each peck</source>
        <translation>Visszahúzás lépésenként</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Way back or clearance of a peck</source>
        <translation>Lépés visszahúzása vagy hézaga</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Wear</source>
        <translation>Kopás</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Wear %1: press again</source>
        <translation>Kopás %1: nyomja újra</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Wear R</source>
        <translation>Kopás R</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Weight</source>
        <translation>Tömeg</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>What</source>
        <translation>Megnevezés</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>What is lost stays lost: press again</source>
        <translation>Az elveszett nem jön vissza: újra</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>What it does</source>
        <translation>Mit csinál</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>What was told before stands in «History», what the machine stood still for in «Log of stops».</source>
        <translation>A korábbiak az „Előzmények”, az állások okai az „Állásnapló” lapon vannak.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>What would change</source>
        <translation>Mi változna</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Wheel, tool, transfer</source>
        <translation>Kézikerék, szerszám, átadás</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>When</source>
        <translation>Mikor</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Who</source>
        <translation>Ki</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Who has changed this value</source>
        <translation>Ki változtatta ezt az értéket</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Whole machine</source>
        <translation>Teljes gép</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Window %1 s</source>
        <translation>Ablak: %1 s</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Without a display server the keyboard itself decides</source>
        <translation>Megjelenítő kiszolgáló nélkül a billentyűzet dönt</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Without a probe offset: press again</source>
        <translation>Tapintókorrekció nélkül: újra</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Without effect:</source>
        <translation>Hatás nélkül:</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>Without tool management (N2900) programs bring their own tools and edges.</source>
        <translation>Szerszámkezelés (N2900) nélkül a program adja meg a szerszámokat és éleket.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Word</source>
        <translation>Szó</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Work by hand</source>
        <translation>Kézi munka</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Work moved from L%1 to L%2 saves up to %3 s.</source>
        <translation>L%1 munkájából L%2-re áttett rész legfeljebb %3 s-ot takarít meg.</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Work shift</source>
        <translation>Munkadarab-eltolás</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Work zeros</source>
        <translation>Nullpontok</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Working area</source>
        <translation>Munkatér</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Workpiece</source>
        <translation>Munkadarab</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Workpiece setter</source>
        <translation>Munkadarab bemérése</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Works</source>
        <translation>Dolgozik</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Worn</source>
        <translation>Elhasznált</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Would be entered</source>
        <translation>Ez kerülne be</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Write into the program</source>
        <translation>Írás a programba</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Writes the offset: press again</source>
        <translation>Beírja a korrekciót: még egyszer</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Written</source>
        <translation>Beírva</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Written as %1</source>
        <translation>Így írandó: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>X of its end, radius</source>
        <translation>Csapvég X (sugár)</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Z of its end</source>
        <translation>Csapvég Z</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Zero</source>
        <translation>Nullpont</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Zero here</source>
        <translation>Nullázás itt</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Zeros</source>
        <translation>Nullpontok</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Zeros and offsets of %1 are entered</source>
        <translation>%1 nullpontjai és korrekciói beírva</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Zeros and offsets stand as before</source>
        <translation>A nullpontok és korrekciók a régiek</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>a marker</source>
        <translation>jelölő</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>a program is interrupted</source>
        <translation>egy program megszakadt</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>all parameters</source>
        <translation>minden paraméter</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>riasztás állított le mindent</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>a csatorna riasztása áll</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>egy tengelyt kézzel mozgatnak</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>angle</source>
        <translation>szög</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>another tool: %1</source>
        <translation>más szerszám: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>arm S%1</source>
        <translation>kar S%1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>csatolja vissza (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>a tengelyek referenciára mennek</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>a tengelyeket tartás közben elmozdították</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>axis no.</source>
        <translation>tengelyszám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>bits</source>
        <translation>bit</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>blocks</source>
        <translation>mondat</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>bore</source>
        <translation>furat</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>állítson be szerszámot</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>vigye a végállásba</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>button tool</source>
        <translation>gombkés</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>cell no.</source>
        <translation>cellaszám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>character code</source>
        <translation>karakterkód</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>válasszon automatát vagy MDI-t</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>chuck holds</source>
        <translation>tokmány zárva</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>chuck open</source>
        <translation>tokmány nyitva</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>zárja, nézze meg a nyomását</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>csukja be, vagy váltson beállító módra</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>column no.</source>
        <translation>oszlopszám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>columns</source>
        <translation>oszlop</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>commanded</source>
        <translation>előírt</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>commanded speed</source>
        <translation>előírt fordulat</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>compensation</source>
        <translation>kompenzáció</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>count</source>
        <translation>db</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>counts</source>
        <translation>inkremens</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>decimals</source>
        <translation>tizedes</translation>
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
        <translation>°/ford</translation>
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
        <translation>leválasztva</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>deviation</source>
        <translation>eltérés</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>drill</source>
        <translation>fúró</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>empty</source>
        <translation>üres</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>enter one, or choose auto</source>
        <translation>írjon be egyet, vagy válasszon automatát</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>entered</source>
        <translation>egyezik</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>entered: %1</source>
        <translation>tényleges: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>riasztás állított le mindent</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>feed</source>
        <translation>előtolás</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>file</source>
        <translation>fájl</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>files: %1</source>
        <translation>fájlok: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>töltse fel az olajat</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>finishing tool</source>
        <translation>simító kés</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>following error</source>
        <translation>követési hiba</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>follows S%1</source>
        <translation>követi: S%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>follows it synchronously</source>
        <translation>szinkronban követi</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ft/min</source>
        <translation>láb/min</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>good</source>
        <translation>jó</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>grinding wheel</source>
        <translation>köszörűkorong</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>grooving tool</source>
        <translation>beszúró kés</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>h</source>
        <translation>h</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>held by protection</source>
        <translation>a védelem tartja</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch</source>
        <translation>hüvelyk</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>inch, diameter</source>
        <translation>hüvelyk, átmérő</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>inch, radius</source>
        <translation>hüvelyk, sugár</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/min</source>
        <translation>hüvelyk/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/rev</source>
        <translation>hüvelyk/ford</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/s2</source>
        <translation>hüvelyk/s²</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>input %1</source>
        <translation>%1. bemenet</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>input no.</source>
        <translation>bemenetszám</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>it is not there</source>
        <translation>nincs meg</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>its travel is added to the axis' own</source>
        <translation>az útja hozzáadódik a sajáthoz</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>kB</source>
        <translation>kB</translation>
    </message>
    <message>
        <location filename="../machine/live/alarm_log.cpp"/>
        <source>line</source>
        <translation>sor</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>line %1, column %2</source>
        <translation>%1. sor, %2. oszlop</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>load a new one</source>
        <translation>töltsön be újat</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>longest below %1 of a tick of %2</source>
        <translation>leghosszabb: %1 alatt; megengedett: %2</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>m/min</source>
        <translation>m/min</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>maker</source>
        <translation>gyártó</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>measured</source>
        <translation>mért</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>metres of cutting</source>
        <translation>forgácsolási méter</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>milling tool</source>
        <translation>maró</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>min</source>
        <translation>perc</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>minutes of cutting</source>
        <translation>forgácsolási perc</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>mm, diameter</source>
        <translation>mm, átmérő</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>mm, radius</source>
        <translation>mm, sugár</translation>
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
        <translation>mm/ford</translation>
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
        <translation>további: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>mounted</source>
        <translation>behelyezve</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>moves its drive: the axes are exchanged</source>
        <translation>annak hajtását mozgatja: cserélt tengelyek</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>never comes: %1</source>
        <translation>sosem jön: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>no</source>
        <translation>nem</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no block is entered</source>
        <translation>nincs beírva mondat</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>no offset, no tool</source>
        <translation>nincs korrekció</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>no program</source>
        <translation>nincs program</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no program is selected</source>
        <translation>nincs kiválasztott program</translation>
    </message>
    <message>
        <location filename="../machine/live/axis_places.cpp"/>
        <source>no ref.</source>
        <translation>nincs ref.</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>nincs szerszám, a revolverfej nincs rögzítve</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>nincs szerszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>nobody</source>
        <translation>senki</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>not a number yet</source>
        <translation>még nem szám</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>nincs minden referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>not all channels of the restart are at their blocks</source>
        <translation>az újraindítás nem minden csatornája áll a mondatánál</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>not entered</source>
        <translation>nincs megadva</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>not measured</source>
        <translation>nem mért</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>not monitored</source>
        <translation>nem figyelt</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>not referenced</source>
        <translation>nincs referencia</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>not this one</source>
        <translation>nem ez</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>nothing</source>
        <translation>nincs</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>off</source>
        <translation>ki</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>offset no.</source>
        <translation>korrekciószám</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>only makers</source>
        <translation>csak gyártó</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>only setters</source>
        <translation>csak beállító</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>operator</source>
        <translation>kezelő</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>other name: %1</source>
        <translation>más név: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>pale: the rows beside it</source>
        <translation>halvány: szomszédos sorok</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>pale: the rows beside it; thin: before</source>
        <translation>halvány: szomszédos sorok; vékony: előtte</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pallets</source>
        <translation>paletta</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>parting tool</source>
        <translation>leszúró kés</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>parts to the limit: %1</source>
        <translation>darab a határig: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>path left</source>
        <translation>hátralévő út</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>path speed</source>
        <translation>pályasebesség</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>pcs</source>
        <translation>db</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>periods</source>
        <translation>periódus</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>pieces</source>
        <translation>darab</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>point %1, %2</source>
        <translation>%1. pont, %2</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>point no.</source>
        <translation>pontszám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pot no.</source>
        <translation>helyszám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pots</source>
        <translation>hely</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>nyomja meg: gép be</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>nyomja meg: összes tengely referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>press reset</source>
        <translation>nyomjon resetet</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>press return</source>
        <translation>nyomja meg: vissza</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>probe</source>
        <translation>tapintó</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>program no.</source>
        <translation>programszám</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>programs run</source>
        <translation>programok futnak</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>programs stand</source>
        <translation>programok állnak</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ratio</source>
        <translation>arány</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>read-only</source>
        <translation>csak olvasható</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>records</source>
        <translation>rekord</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>reference it</source>
        <translation>vegyen fel referenciát</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>oldja ki és kapcsolja be a gépet</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>szüntesse meg az okát és reset</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>szüntesse meg az okát, majd reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>restore a backup, or let a maker confirm what is left</source>
        <translation>állítson vissza egy mentést, vagy a gyártó hagyja jóvá, ami megmaradt</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rev</source>
        <translation>ford</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rev/s2</source>
        <translation>ford/s²</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>roughing tool</source>
        <translation>nagyoló kés</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rows</source>
        <translation>sor</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rpm</source>
        <translation>ford/min</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rpm/s</source>
        <translation>ford/min/s</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>select one on the page of programs</source>
        <translation>válasszon egyet a programok oldalán</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>setter</source>
        <translation>beállító</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>since the start</source>
        <translation>indítás óta</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>special tool</source>
        <translation>különleges szerszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>speed</source>
        <translation>fordulat</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>spindle no.</source>
        <translation>főorsószám</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>stations</source>
        <translation>állomás</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>switch it on</source>
        <translation>kapcsolja be</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect after a restart of the controller</source>
        <translation>a vezérlő újraindítása után érvényes</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect at once</source>
        <translation>azonnal érvényes</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect at the next preprocessing stop</source>
        <translation>a következő előfeldolgozási megállás után érvényes</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>elfogyott a rúd</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>a csatorna folyamata nem fut</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>a tokmány nem fog</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the door is open</source>
        <translation>az ajtó nyitva</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>a vészleállítás aktív</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>nincs kenés</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>the machine</source>
        <translation>a gép</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>the machine does not have it</source>
        <translation>a gépnek nincs ilyen</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>a gép nincs bekapcsolva</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>a gép ki van kapcsolva</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>a gép üzemkész</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>a mód kézi mozgatás</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>the place is empty</source>
        <translation>üres a hely</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>the program takes no time</source>
        <translation>a program nem vesz igénybe időt</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>a reset még tart</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the store has lost data: no production</source>
        <translation>a tároló adatokat vesztett: nincs gyártás</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>a tároló nem fut: semmi nem maradna meg</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>a szegnyereg sem hátul, sem szorítva</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>the time of a tick</source>
        <translation>egy ütem ideje</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>thin: before</source>
        <translation>vékony: előtte</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>threading tool</source>
        <translation>menetkés</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ticks</source>
        <translation>ciklus</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>tip</source>
        <translation>csúcs</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>too large</source>
        <translation>tűrés felett</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>too small</source>
        <translation>tűrés alatt</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>tool %1</source>
        <translation>%1. szerszám</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>torque</source>
        <translation>nyomaték</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>oldja ki a gombot, majd gép be</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>turning drill</source>
        <translation>esztergafúró</translation>
    </message>
    <message>
        <location filename="../machine/live/axis_places.cpp"/>
        <source>turns as spindle S%1</source>
        <translation>S%1 orsóként forog</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>turns with it, deviation %1°</source>
        <translation>vele forog, eltérés %1°</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>us</source>
        <translation>µs</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>uses</source>
        <translation>használat</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>values: %1</source>
        <translation>érték: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>variable no.</source>
        <translation>változószám</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>velocity</source>
        <translation>sebesség</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>várjon</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait for them; if it was refused, restart again or reset</source>
        <translation>várjon rájuk; ha elutasította, indítsa újra vagy reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>várja meg az újraindulását, majd reset</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>várja meg, míg megáll</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>várja meg, míg újra fut</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>várja meg, míg a tengelyek megállnak</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>wanted: a whole number</source>
        <translation>egész szám kell</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>wear</source>
        <translation>kopás</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>wear of L%1 T%2 D%3</source>
        <translation>kopás L%1, T%2 D%3</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>wear of L%1 offset %2</source>
        <translation>kopás L%1, korr. %2</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>yes</source>
        <translation>igen</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>«Mark» chooses what is copied or compared</source>
        <translation>A „Kijelölés” választja ki a másolandót vagy összehasonlítandót</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>«Measure» finds the tip and shows what would be entered. Camera calibrated: %1.</source>
        <translation>A «Mérés» megkeresi a csúcsot, és megmutatja, mi kerülne be. Kamera kalibrálva: %1.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>«Measure» finds the tip and shows what would be entered. The gauge pin calibrates the camera first.</source>
        <translation>A „Mérés” megkeresi a csúcsot, és megmutatja, mi kerülne be. Előbb kalibrálja a kamerát a mérőcsappal.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>«Restore» brings everything back as it was then. The file cannot be read whole: «Confirm the loss» may leave parameters, offsets, zeros, tools and users as on the first day. Look through them before the first part.</source>
        <translation>A «Visszaállítás» mindent az akkori állapotba hoz. A fájl nem olvasható teljesen: a «Veszteség megerősítése» után a paraméterek, korrekciók, nullpontok, szerszámok és felhasználók olyanok lehetnek, mint az első napon. Nézze át őket az első darab előtt.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>«Restore» brings everything back as it was then. «Confirm the loss» keeps what is left: the newest changes of parameters, offsets, zeros, tools, lives and users are gone for good. Look through them before the first part.</source>
        <translation>A «Visszaállítás» mindent az akkori állapotba hoz. A «Veszteség megerősítése» azt hagyja meg, ami maradt: a paraméterek, korrekciók, nullpontok, szerszámok, éltartamok és felhasználók legutóbbi módosításai végleg elvesznek. Nézze át őket az első darab előtt.</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>µm</source>
        <translation>µm</translation>
    </message>
</context>
</TS>
