<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="hu_HU" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>%1 in all</source>
        <translation>összesen %1</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>%1 is selected in L%2</source>
        <translation>%1 kiválasztva: L%2</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>%1 is selected in its channels</source>
        <translation>%1 kiválasztva a csatornáiban</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>%1 s after the start of the controller</source>
        <translation>%1 s a vezérlő indulása után</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>+ Input</source>
        <translation>+ Bevitel</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>A block by hand (MDI)</source>
        <translation>Mondat kézzel (MDI)</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>A start needs:</source>
        <translation>Az indításhoz kell:</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>A text: it is changed by polyturn params set</source>
        <translation>Szöveg: a polyturn params set módosítja</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Nincs</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Active at the next T</source>
        <translation>A következő T-től</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Active from the next blocks</source>
        <translation>A következő mondatoktól</translation>
    </message>
    <message>
        <location filename="../screens/alarms.hpp"/>
        <source>Alarms</source>
        <translation>Riasztások</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>All</source>
        <translation>Mind</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>All groups</source>
        <translation>Minden csoport</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>All zeros together</source>
        <translation>Nullpontok együtt</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Applied now</source>
        <translation>Most érvényes</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>As held</source>
        <translation>Nyomva</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Automata</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axes</source>
        <translation>Tengelyek</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axes and drives</source>
        <translation>Tengelyek és hajtások</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axis</source>
        <translation>Tengely</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Mondatkihagyás</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Changed</source>
        <translation>Módosítva</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Changed only</source>
        <translation>Csak módosítottak</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Changes since the start of these screens</source>
        <translation>Változások a képernyők indítása óta</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Channel</source>
        <translation>Csatorna</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Check, waits</source>
        <translation>Ellenőrzés, várakozások</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>Choose a field</source>
        <translation>Válasszon mezőt</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Choose a job or a program</source>
        <translation>Válasszon munkát vagy programot</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Clear</source>
        <translation>Törlés</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Clear search</source>
        <translation>Keresés törlése</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Commanded</source>
        <translation>Parancs</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Compensation</source>
        <translation>Kompenzáció</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Computing time of ticks</source>
        <translation>Ütemek számítási ideje</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Couplings</source>
        <translation>Csatolások</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Couplings and exchanges</source>
        <translation>Csatolások és cserék</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Cutting</source>
        <translation>Forgácsolás</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Ciklus</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Sötét</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Default</source>
        <translation>Alapérték</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Default value</source>
        <translation>Alapérték</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Depends on</source>
        <translation>Mitől függ</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Drive fault</source>
        <translation>Hajtáshiba</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Próbafutás</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Dry run, timeline</source>
        <translation>Próbafutás, idővonal</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Dwell</source>
        <translation>Várakozási idő</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Emergency stop</source>
        <translation>Vészstop</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>End with this part</source>
        <translation>Vége e darabbal</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Kész</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Mindet befejezi: újra</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Befejezi a programot: újra</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Every axis and spindle is on its own: nothing is coupled, exchanged or followed.</source>
        <translation>Minden tengely és orsó önálló: nincs csatolás, csere vagy követés.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>External</source>
        <translation>Külső</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Feed</source>
        <translation>Előtolás</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Előtolás-állj: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Files</source>
        <translation>Fájlok</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>First part</source>
        <translation>Első darab</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>Első darab: a start ezzel a szerszámmal folytatja</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Follow. error</source>
        <translation>Köv. hiba</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>From</source>
        <translation>Forrás</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Geom.</source>
        <translation>Geom.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Geometry + wear</source>
        <translation>Geometria + kopás</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Graphics</source>
        <translation>Grafika</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Kézikerék</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Held</source>
        <translation>Tartva</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>History</source>
        <translation>Előzmények</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Hold %1</source>
        <translation>Állj %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold all</source>
        <translation>Állj mind</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>How</source>
        <translation>Hogyan</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>In position</source>
        <translation>Pozícióban</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Input</source>
        <translation>Bevitel</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Megszakítva</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>It cannot be shown.</source>
        <translation>Nem jeleníthető meg.</translation>
    </message>
    <message>
        <location filename="../machine/dry_run.cpp"/>
        <source>It gave no result.</source>
        <translation>Nem adott eredményt.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Kézi</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Larger</source>
        <translation>Nagyobb</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Last</source>
        <translation>Előző</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Leave the hold %1</source>
        <translation>Elhagyás %1</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Level</source>
        <translation>Szint</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Világos</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Zár</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Zárolva tisztításhoz</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Longest wait: L%1 stands %2 s at M%3 (line %4). Work moved from the channel that comes last to L%1 saves up to this time.</source>
        <translation>Leghosszabb várakozás: L%1 %2 s-ot áll, M%3 (%4. sor). Az utolsónak érkező csatornától L%1-re áttett munka ennyit takaríthat meg.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Ellenőrizze, fut-e a vezérlő; próbálja újra.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>MDI</source>
        <translation>MDI</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine</source>
        <translation>Gép</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Géplezárás</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Machine on</source>
        <translation>Gép be</translation>
    </message>
    <message>
        <location filename="../screens/manual.hpp"/>
        <source>Manual</source>
        <translation>Kézi</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Átlag</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Meaning</source>
        <translation>Jelentés</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Measured</source>
        <translation>Mért</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Message</source>
        <translation>Üzenet</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Moves</source>
        <translation>Mozog</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Name</source>
        <translation>Név</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>No alarm stands.</source>
        <translation>Nincs fennálló riasztás.</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>A vezérlő nem válaszol</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>No faults found</source>
        <translation>Nincs hiba</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>No job names the stock of the running program</source>
        <translation>Egyik munka sem adja meg a nyersdarabot</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>No parameter has this in its number, name or meaning.</source>
        <translation>Nincs paraméter ilyen számmal, névvel vagy jelentéssel.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>No signal has this in its name or meaning.</source>
        <translation>Nincs jel ilyen névvel vagy jelentéssel.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>No.</source>
        <translation>Sz.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>None is known.</source>
        <translation>Nem ismert.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Not in position</source>
        <translation>Nincs pozícióban</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Not in use by the running program</source>
        <translation>A program nem használja</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Nothing has been told since the controller started.</source>
        <translation>A vezérlő indulása óta nem volt üzenet.</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Nothing is missing</source>
        <translation>Semmi nem hiányzik</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Number</source>
        <translation>Szám</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Offset</source>
        <translation>Korrekció</translation>
    </message>
    <message>
        <location filename="../screens/offsets.hpp"/>
        <source>Offsets</source>
        <translation>Korrekciók</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Open folder</source>
        <translation>Mappa megnyitása</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Feltételes állj</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Feltételes állj %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Feltételes megállás M1: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Overrides</source>
        <translation>Override-ok</translation>
    </message>
    <message>
        <location filename="../screens/overview.hpp"/>
        <source>Overview</source>
        <translation>Áttekintés</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Parameters</source>
        <translation>Paraméterek</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Parts</source>
        <translation>Darab</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Place</source>
        <translation>Hely</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Process</source>
        <translation>Folyamat</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>A folyamat leállt</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Processes</source>
        <translation>Folyamatok</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Processes and ticks</source>
        <translation>Folyamatok és ütemek</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Programozott megállás M0: a start folytatja</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Programs</source>
        <translation>Programok</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Programs and jobs</source>
        <translation>Programok és munkák</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Radius</source>
        <translation>Sugár</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Range</source>
        <translation>Tartomány</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Rapid</source>
        <translation>Gyors</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Read again</source>
        <translation>Újraolvasás</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Referencia</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Reference all</source>
        <translation>Mind referencia</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Hátravan</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Remedy</source>
        <translation>Teendő</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reset</source>
        <translation>Reset</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Reset %1</source>
        <translation>Reset %1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Reset L%1</source>
        <translation>Reset L%1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Reset all</source>
        <translation>Reset mind</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Újraindítás: a start elvégzi a ráállást</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>A visszakövetés a végére ért</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Return %1</source>
        <translation>Vissza %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Fut</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Search</source>
        <translation>Keresés</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Search: number, name or meaning</source>
        <translation>Keresés: szám, név vagy jelentés</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Select in L%1</source>
        <translation>Kiválasztás: L%1</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Select job</source>
        <translation>Munka kiválasztása</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Sets the default: press again</source>
        <translation>Alapérték: újra</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Sets the zero: press again</source>
        <translation>Nullát állít: újra</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signal</source>
        <translation>Jel</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signals</source>
        <translation>Jelek</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signals of NC and PLC</source>
        <translation>NC és PLC jelei</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Since the start of these screens; tips as points, without width and radius</source>
        <translation>A képernyők indítása óta; csúcsok pontként, szélesség és sugár nélkül</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Single block</source>
        <translation>Mondatonként</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block %1</source>
        <translation>Mondatonként %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block all</source>
        <translation>Mondatonként mind</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Mondatonként: a start a következőt hajtja végre</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Size</source>
        <translation>Méret</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Smaller</source>
        <translation>Kisebb</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Spindle</source>
        <translation>Orsó</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Start %1</source>
        <translation>Start %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start all</source>
        <translation>Start mind</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Starts</source>
        <translation>Indul</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Mindet indítja: újra</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>State</source>
        <translation>Állapot</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Stock</source>
        <translation>Nyersdarab</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Megállt</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Synchronised view</source>
        <translation>Szinkron nézet</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Text</source>
        <translation>Szöveg</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>A vezérlő nem adott választ.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>A vezérlő elutasította.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>The job is being driven in virtual time</source>
        <translation>A munka virtuális időben fut</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>The machine works with it</source>
        <translation>A gép ezzel dolgozik</translation>
    </message>
    <message>
        <location filename="../machine/dry_run.cpp"/>
        <source>The program polyturn is not beside the HMI.</source>
        <translation>A polyturn program nincs a HMI mellett.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>The programs are being read</source>
        <translation>A programok olvasása folyik</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Nincs kapcsolat a vezérlővel.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>This folder is empty.</source>
        <translation>A mappa üres.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>This is here</source>
        <translation>Itt ennyi</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Time</source>
        <translation>Idő</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Timeline</source>
        <translation>Idővonal</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tip</source>
        <translation>Csúcs</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tip is at this measure: press again</source>
        <translation>A csúcs a méreten: újra</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>To go</source>
        <translation>Hátravan</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tool offsets</source>
        <translation>Korrekciók</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Tools that it needs</source>
        <translation>Szükséges szerszámok</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Torque</source>
        <translation>Nyomaték</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Touch the line, type, Enter starts it</source>
        <translation>Érintse meg a sort, írjon, az Enter indítja</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Touches and keys do nothing. The machine goes on.</source>
        <translation>Az érintés és a billentyűk hatástalanok. A gép megy tovább.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Type a part of the name</source>
        <translation>Írja be a név egy részét</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Undo</source>
        <translation>Visszavonás</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Unit</source>
        <translation>Egység</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Up</source>
        <translation>Fel</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Value</source>
        <translation>Érték</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Waiting</source>
        <translation>Várakozás</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Várakozás a vezérlőre</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Vár</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1 for %2, since %3</source>
        <translation>Itt vár: %1, erre: %2, %3 óta</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Vár itt: %1, mindenki itt van</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Wear</source>
        <translation>Kopás</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Wear R</source>
        <translation>Kopás R</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>What</source>
        <translation>Mi</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>What stands</source>
        <translation>Fennálló</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Without effect:</source>
        <translation>Hatás nélkül:</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Work shift</source>
        <translation>Eltolás</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Work zeros</source>
        <translation>Nullpontok</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Workpiece</source>
        <translation>Munkadarab</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Zero</source>
        <translation>Nullpont</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Zero here</source>
        <translation>Nulla itt</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>a marker</source>
        <translation>jelölő</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts after a restart of the controller</source>
        <translation>a vezérlő újraindítása után hat</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts at once</source>
        <translation>azonnal hat</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts at the channel's next stop of reading</source>
        <translation>a csatorna következő olvasási megállásánál hat</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>riasztás állított le mindent</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>a csatorna riasztása áll</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>egy tengelyt kézzel mozgatnak</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>csatolja vissza (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>a tengelyek referenciára mennek</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>a tengelyeket tartás közben elmozdították</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>bore</source>
        <translation>furat</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>állítson be szerszámot</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>vigye a végállásba</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>válasszon automatát vagy MDI-t</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>zárja, nézze meg a nyomását</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>csukja be, vagy váltson beállító módra</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>detached</source>
        <translation>leválasztva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>riasztás állított le mindent</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>töltse fel az olajat</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>follows it synchronously</source>
        <translation>szinkronban követi</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>its way is added to the own one</source>
        <translation>az útja hozzáadódik</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>line</source>
        <translation>sor</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>load a new one</source>
        <translation>töltsön be újat</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>longest %1 of a tick of %2 µs</source>
        <translation>leghosszabb %1, ütem %2 µs</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>maker</source>
        <translation>gyártó</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>moves its drive: the axes are exchanged</source>
        <translation>annak hajtását mozgatja: cserélt tengelyek</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>never comes: %1</source>
        <translation>sosem jön: %1</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no program</source>
        <translation>nincs program</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no ref.</source>
        <translation>nincs ref.</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>nincs szerszám, a revolverfej nincs rögzítve</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>nincs szerszám</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>not a number yet</source>
        <translation>még nem szám</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>nincs minden referencia</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>not referenced</source>
        <translation>nincs referencia</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>operator</source>
        <translation>kezelő</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>nyomja meg: gép be</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>nyomja meg: mind referencia</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press reset</source>
        <translation>nyomjon resetet</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press return</source>
        <translation>nyomja meg: visszatérés</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>reference it</source>
        <translation>vegyen fel referenciát</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>oldja ki és kapcsolja be a gépet</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>szüntesse meg az okát és reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>szüntesse meg az okát, majd reset</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>setter</source>
        <translation>beállító</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>switch it on</source>
        <translation>kapcsolja be</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>elfogyott a rúd</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>a csatorna folyamata nem fut</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>a tokmány nem fog</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the door is open</source>
        <translation>az ajtó nyitva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>a vészleállítás aktív</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>nincs kenés</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>the machine</source>
        <translation>a gép</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>a gép nincs bekapcsolva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>a gép ki van kapcsolva</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>a gép üzemkész</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>a mód kézi mozgatás</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>a reset még tart</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>a tároló nem fut: semmi nem maradna meg</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>a szegnyereg sem hátul, sem szorítva</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>tip</source>
        <translation>csúcs</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>oldja ki a gombot, majd gép be</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>turns as spindle S%1</source>
        <translation>S%1 orsóként forog</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>turns with it, deviation %1°</source>
        <translation>vele forog, eltérés %1°</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>várjon</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>várja meg az újraindulását, majd reset</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>várja meg, míg megáll</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>várja meg, míg újra fut</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>várja meg, míg a tengelyek megállnak</translation>
    </message>
</context>
</TS>
