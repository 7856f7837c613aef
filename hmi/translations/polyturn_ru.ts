<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it cutting</source>
        <translation>  из него резание</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it rapid</source>
        <translation>  из него ускоренный ход</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>  of it waiting</source>
        <translation>  из него ожидание</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>%1 a part</source>
        <translation>%1 на деталь</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>%1 ago</source>
        <translation>%1 назад</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1 by %2: straightness</source>
        <translation>%1 по %2: прямолинейность</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 cannot be the name of a program</source>
        <translation>%1 не годится в имя программы</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 has a new insert: its life begins anew, the wear of its offset stays</source>
        <translation>%1: новая пластина, ресурс начинается заново, износ её корректора остаётся</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 has a new insert: life and wear begin anew</source>
        <translation>%1: новая пластина, ресурс и износ начинаются заново</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 has values again: they stay</source>
        <translation>У %1 снова есть значения: они остаются</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>%1 in all</source>
        <translation>всего %1</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 interrupted</source>
        <translation>прерваны: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1 is %2 by now: it stays</source>
        <translation>%1: уже %2, оставлено как есть</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>%1 is being opened</source>
        <translation>%1 открывается</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>%1 is being read: the place answers slowly</source>
        <translation>%1 читается: носитель отвечает медленно</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>%1 is being written: the place answers slowly</source>
        <translation>%1 записывается: носитель отвечает медленно</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is deleted</source>
        <translation>%1: удалено</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>%1 is logged in</source>
        <translation>Вход выполнен: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is new</source>
        <translation>Новая кромка: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>%1 is not such a value</source>
        <translation>%1 сюда не подходит</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is not there any more</source>
        <translation>%1 больше нет</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected</source>
        <translation>%1 защищён</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected by F3202</source>
        <translation>%1 защищена параметром F3202</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is protected: a login of a higher level may change it</source>
        <translation>%1 защищён: менять может вход с более высоким уровнем</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is read-only</source>
        <translation>%1 только для чтения</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected</source>
        <translation>Выбрано: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected in L%2</source>
        <translation>%1 выбрана в L%2</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1 is selected in its channels</source>
        <translation>%1 выбрано в своих каналах</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 is taken out</source>
        <translation>%1 извлечён</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>%1 is there again</source>
        <translation>%1: восстановлено</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>%1 is there already</source>
        <translation>%1 уже есть</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>%1 of %2</source>
        <translation>%1 из %2</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 run</source>
        <translation>работают: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>%1 s after the start of the controller</source>
        <translation>через %1 с после запуска УЧПУ</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 stand</source>
        <translation>стоят: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>%1 stands in %2</source>
        <translation>%1 стоит в %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>%1 too long</source>
        <translation>опозданий: %1</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1 wait</source>
        <translation>ждут: %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>%1 waits for nobody, nobody waits for it: press again</source>
        <translation>%1 никого не ждёт, и его никто: нажмите ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>%1 was refused: %2</source>
        <translation>%1: отказ: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: acts as soon as the axes rest</source>
        <translation>%1: действует, как только оси остановятся</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>%1: another value stands there by now, it stays</source>
        <translation>%1: там уже другое значение, оно остаётся</translation>
    </message>
    <message>
        <location filename="../widgets/pictures/magazine.cpp"/>
        <source>%1: choose its place, Enter puts it there, Escape leaves it</source>
        <translation>%1: выберите место, Enter поставит, Escape отменит</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: gradient</source>
        <translation>%1: градиент</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>%1: no program is selected</source>
        <translation>%1: программа не выбрана</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: periodic</source>
        <translation>%1: периодическая</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: pitch</source>
        <translation>%1: шаг винта</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>%1: pitch, negative direction</source>
        <translation>%1: шаг винта, в минус</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>%1: start goes on</source>
        <translation>%1: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>%1; %2: not so</source>
        <translation>%1; %2: нет</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>(limited)</source>
        <translation>(ограничено)</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>+ Input</source>
        <translation>+ Ввод</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>0.1 lead</source>
        <translation>0.1 шага</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>1/10 lead</source>
        <translation>1/10 шага</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>1/100 s</source>
        <translation>1/100 с</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>1/K</source>
        <translation>1/К</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>1/min</source>
        <translation>об/мин</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>1/s</source>
        <translation>1/с</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>2 to 30 a second</source>
        <translation>от 2 до 30 в секунду</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>250 to 1000 ms</source>
        <translation>от 250 до 1000 мс</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>5 Axis Machining</source>
        <translation>5-осевая обработка</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A block by hand (MDI)</source>
        <translation>Кадр вручную (РВД)</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>A block entered by hand waits: start runs it</source>
        <translation>Ждёт кадр, введённый вручную: пуск выполнит его</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>A part of a long program: lines %1 to %2, %3 % of it. «Check, waits» looks for faults in all of it.</source>
        <translation>Часть длинной программы: строки %1–%2, %3 % её. «Проверка, ожидания» проверяет всю программу.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A program is held: «Jog in hold %1» lets its axes be moved</source>
        <translation>Программа остановлена: оси перемещает «Ручное перемещение в останове %1»</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>A program runs: axes are moved by hand in a hold, after «Jog in hold»</source>
        <translation>Идёт программа: вручную оси движутся на стопе подачи, после «Ручное перемещение в останове»</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>A program works with it: press again</source>
        <translation>Используется программой: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>A value is needed here.</source>
        <translation>Здесь нужно значение.</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Нет</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Acceleration</source>
        <translation>Ускорение</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Accept proposal</source>
        <translation>Принять</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Active</source>
        <translation>Действует</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Active alarms</source>
        <translation>Активные</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active at the next T</source>
        <translation>Со следующего T</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active at the next T or D</source>
        <translation>Со следующего T или D</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Active from the next blocks</source>
        <translation>Со следующих кадров</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add a line</source>
        <translation>Добавить отрезок</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add an arc G2</source>
        <translation>Добавить дугу G2</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Add an arc G3</source>
        <translation>Добавить дугу G3</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Addresses by DHCP</source>
        <translation>Адреса от DHCP</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>After</source>
        <translation>Стало</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Alarm</source>
        <translation>Авария</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.hpp"/>
        <source>Alarms</source>
        <translation>Аварии</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>All are at their blocks: start makes the approach</source>
        <translation>Все у своих кадров: пуск начнёт подход</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>All axes move: press again</source>
        <translation>Все оси поедут: нажмите ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>All channels</source>
        <translation>Все каналы</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>All from their last tool call</source>
        <translation>Все с вызова инструмента</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>All groups</source>
        <translation>Все группы</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>All tables</source>
        <translation>Все таблицы</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>All tools</source>
        <translation>Все инструменты</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>All zeros together</source>
        <translation>Сумма смещений</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Along</source>
        <translation>Вдоль</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Along axis</source>
        <translation>Вдоль оси</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>An alarm has ended the lock for cleaning.</source>
        <translation>Авария сняла блокировку для протирки.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>An arc turns through less than 360°.</source>
        <translation>Дуга меньше 360°.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle at its end to +Z</source>
        <translation>Угол в конце к +Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle at its start to +Z</source>
        <translation>Угол в начале к +Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle between two holes; 0: evenly spread</source>
        <translation>Угол между отверстиями; 0: равномерно</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle it turns through</source>
        <translation>Угол дуги</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle of the first hole to the 1st axis</source>
        <translation>Угол первого отверстия к 1-й оси</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Angle of the infeed</source>
        <translation>Угол врезания</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Angle of the line to the 1st axis</source>
        <translation>Угол прямой к 1-й оси</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Angle of the spindle at the start</source>
        <translation>Угол шпинделя в начале</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Angle of the tool tip</source>
        <translation>Угол вершины резца</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Angle to +Z</source>
        <translation>Угол к +Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Another cycle</source>
        <translation>Другой цикл</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Applied now</source>
        <translation>Действует сейчас</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Arc G2</source>
        <translation>Дуга G2</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Arc G3</source>
        <translation>Дуга G3</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Автомат</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Axes</source>
        <translation>Оси</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Axes and drives</source>
        <translation>Оси и приводы</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Axes are moved by hand while the machine is on</source>
        <translation>Оси движутся вручную при включённом станке</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Axes of L%1</source>
        <translation>Оси L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Axis</source>
        <translation>Ось</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Config</source>
        <translation>Оси</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Limits</source>
        <translation>Пределы осей</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Recomposition</source>
        <translation>Обмен осей</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Axis Servo</source>
        <translation>Приводы осей</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Back</source>
        <translation>Назад</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Back to the text</source>
        <translation>К тексту</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Backup</source>
        <translation>Копия</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Backups</source>
        <translation>Резервные копии</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Barrel thread on an arc, clockwise</source>
        <translation>Бочкообразная резьба по дуге, по часовой стрелке</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Barrel thread on an arc, counter-clockwise</source>
        <translation>Бочкообразная резьба по дуге, против часовой стрелки</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Base</source>
        <translation>База</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Base R</source>
        <translation>База R</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Base lengths</source>
        <translation>Базовые длины</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Before</source>
        <translation>Было</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Begins anew, stood in line %1: press again</source>
        <translation>Сначала (был на строке %1): ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Пропуск кадров</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Block skip %1</source>
        <translation>Пропуск кадров %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Blocks are entered in MDI, or while a program is held</source>
        <translation>Кадры вводятся в режиме РВД или пока программа остановлена</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring</source>
        <translation>Растачивание</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring in the face</source>
        <translation>Растачивание в торце</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring in the side</source>
        <translation>Растачивание сбоку</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring with a dwell</source>
        <translation>Растачивание с выдержкой</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Boring, back with the spindle stopped</source>
        <translation>Растачивание, отвод со стоящим шпинделем</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom X</source>
        <translation>Дно X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom Z</source>
        <translation>Дно Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom of the hole X</source>
        <translation>Дно отверстия X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole X, or the end of the way back</source>
        <translation>Дно отверстия X или конец обратного хода</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Bottom of the hole Z</source>
        <translation>Дно отверстия Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole Z, or the end of the way back</source>
        <translation>Дно отверстия Z или конец обратного хода</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Bottom of the hole, where no depth is told</source>
        <translation>Дно отверстия, если глубина не задана</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Bring the axes to a free place first. Touch one of these blocks twice, press Enter on it, or type its number: the program restarts there. «Restart» reads to it without moving, with all waits replayed. The first start shows what comes; the second one does it: tool, functions, axes, and it cuts.</source>
        <translation>Сначала отведите оси в безопасное место. Дважды коснитесь кадра (или Enter) либо введите его номер. «Перезапуск» просчитает программу до него без движения, с учётом ожиданий. Первый пуск покажет, что будет выполнено; второй вызовет инструмент и функции, подведёт оси и начнёт резание.</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Broken</source>
        <translation>Сломан</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Calibrate</source>
        <translation>Калибровать</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Calibrated: %1 µm a pixel, tilted by %2°</source>
        <translation>Откалибровано: %1 мкм на пиксель, наклон %2°</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Call %1</source>
        <translation>Вызвать %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Called by</source>
        <translation>Вызов</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Cannot be written: %1</source>
        <translation>Не записать: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Cause</source>
        <translation>Причина</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Cell %1</source>
        <translation>Ячейка %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Centre X</source>
        <translation>Центр X</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Centre Z</source>
        <translation>Центр Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Centre from the start point X (radius)</source>
        <translation>Центр от начальной точки X (радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Centre from the start point Z</source>
        <translation>Центр от начальной точки Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Centre of the circle, 1st axis (X: radius)</source>
        <translation>Центр окружности, 1-я ось (X: радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Centre of the circle, 2nd axis (X: radius)</source>
        <translation>Центр окружности, 2-я ось (X: радиус)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Chamfer or rounding has no room here.</source>
        <translation>Для фаски или скругления нет места.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Chamfer to the next one</source>
        <translation>Фаска к следующему</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Change</source>
        <translation>Изменить</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Change of the lead a revolution</source>
        <translation>Изменение шага за оборот</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Changed</source>
        <translation>Изменено</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Changed only</source>
        <translation>Только изменённые</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Changes of %1</source>
        <translation>Изменения: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Channel</source>
        <translation>Канал</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Check, waits</source>
        <translation>Проверка, ожидания</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Choose a backup: «What would change» compares it with the machine, and nothing is changed yet.</source>
        <translation>Выберите копию: «Что изменится» сравнит её со станком, пока ничего не меняя.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Choose a cycle: touch it twice, or Enter.</source>
        <translation>Выберите цикл: коснитесь дважды или Enter.</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>Choose a field</source>
        <translation>Выберите поле</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Choose a job or a program</source>
        <translation>Выберите задание или программу</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Choose a picture of the tool's shadow</source>
        <translation>Выберите снимок тени инструмента</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Choose a signal; type a part of its name</source>
        <translation>Выберите сигнал; наберите часть имени</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Choose signal</source>
        <translation>Выбрать сигнал</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Chuck S%1</source>
        <translation>Патрон S%1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Chuck zone of L%1</source>
        <translation>Зона патрона L%1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Chuck/Tailstock Barrier</source>
        <translation>Зоны патрона и бабки</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Circularity</source>
        <translation>Круглость</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Circularity error</source>
        <translation>Отклонение от круглости</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Clear</source>
        <translation>Очистить</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Clear search</source>
        <translation>Очистить поиск</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Clearance before the next peck</source>
        <translation>Зазор перед следующим шагом</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Close</source>
        <translation>Закрыть</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Commanded</source>
        <translation>Задано</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Compare</source>
        <translation>Сравнить</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Comparison</source>
        <translation>Сравнение</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Compensation</source>
        <translation>Компенсация</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Compensation tables</source>
        <translation>Таблицы компенсации</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Computer</source>
        <translation>Компьютер</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Computing time of ticks</source>
        <translation>Время счёта тактов</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Confirm the loss</source>
        <translation>Признать потерю</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Confirmed: production goes on with what is left</source>
        <translation>Подтверждено: работа идёт дальше с тем, что осталось</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Continuous</source>
        <translation>Непрерывно</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Contour</source>
        <translation>Контур</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Coordinates</source>
        <translation>Координаты</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Copied and compared</source>
        <translation>Скопировано и сверено</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Copy to here</source>
        <translation>Копировать сюда</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Copy, delete ...</source>
        <translation>Копия, удаление ...</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Core diameter at the end</source>
        <translation>Внутренний диаметр в конце</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Corrected</source>
        <translation>Исправляет</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Corrected axis</source>
        <translation>Исправляемая ось</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Correction</source>
        <translation>Поправка</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Couplings</source>
        <translation>Связи</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Couplings and exchanges</source>
        <translation>Связи и обмен осей</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Cutting</source>
        <translation>Резание</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cutting time</source>
        <translation>Время резания</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Цикл</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Cycle form</source>
        <translation>Форма цикла</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cycle last, mean</source>
        <translation>Цикл последний, средний</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Cycle now</source>
        <translation>Цикл сейчас</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Date and time</source>
        <translation>Дата и время</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Decides the time</source>
        <translation>Критич. путь</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Default</source>
        <translation>По умолчанию</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Default value</source>
        <translation>По умолчанию</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Delete</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Delete all</source>
        <translation>Удалить все</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Delete edge</source>
        <translation>Удалить кромку</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Delete the element</source>
        <translation>Удалить элемент</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Delete tool</source>
        <translation>Удалить инструмент</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Delete user</source>
        <translation>Удалить</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Deleted</source>
        <translation>Удалено</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Depends on</source>
        <translation>Зависит от</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Depth below the surface, instead of the bottom</source>
        <translation>Глубина от поверхности вместо дна</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck</source>
        <translation>Глубина шага</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck along X (radius)</source>
        <translation>Глубина шага по X (радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of a peck along Z</source>
        <translation>Глубина шага по Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of a peck; 0: tapping</source>
        <translation>Глубина шага; 0: резьба метчиком</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of cut</source>
        <translation>Глубина резания</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of cut (radius)</source>
        <translation>Глубина резания (радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Depth of cut along Z</source>
        <translation>Глубина резания по Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of the first pass (radius)</source>
        <translation>Глубина первого прохода (радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Depth of the hole</source>
        <translation>Глубина отверстия</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Deviation</source>
        <translation>Отклон.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.hpp"/>
        <source>Diagnosis</source>
        <translation>Диагностика</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Diameter</source>
        <translation>Диаметр</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Diameter at the end</source>
        <translation>Диаметр в конце</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Diameter of the pin</source>
        <translation>Диаметр калибра</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Diameter of this pass at the end</source>
        <translation>Диаметр этого прохода в конце</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Difference</source>
        <translation>Разница</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Differences: %1</source>
        <translation>Различий: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Differs from file</source>
        <translation>Отличия от файла</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Dimension</source>
        <translation>Размер</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Do this step</source>
        <translation>Выполнить шаг</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling</source>
        <translation>Сверление</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Drilling Cycles</source>
        <translation>Циклы сверления</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Drilling and tapping</source>
        <translation>Сверление и нарезание резьбы</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling in the face</source>
        <translation>Сверление в торце</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling in the side</source>
        <translation>Сверление сбоку</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling with a dwell</source>
        <translation>Сверление с выдержкой</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling with pecks</source>
        <translation>Сверление с выводом</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Drilling, breaking chips</source>
        <translation>Сверление с ломкой стружки</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, centring (in G17 along Z)</source>
        <translation>Сверление, центрование (в G17 по Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, centring behind each block that moves</source>
        <translation>Сверление, центрование после каждого кадра с движением</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, counterboring (in G17 along Z)</source>
        <translation>Сверление, цекование (в G17 по Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Drilling, counterboring behind each block that moves</source>
        <translation>Сверление, цекование после каждого кадра с движением</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Drive fault</source>
        <translation>Авария привода</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Пробный прогон</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Dry run %1</source>
        <translation>Пробный прогон %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Dwell</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Dwell at the bottom</source>
        <translation>Выдержка на дне</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Dwell at the bottom; negative: revolutions</source>
        <translation>Выдержка на дне; отрицательная: обороты</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Edge D</source>
        <translation>Кромка D</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Edit</source>
        <translation>Правка</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Editor</source>
        <translation>Редактор</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Effect</source>
        <translation>Действие</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Electronic Gear Box</source>
        <translation>Электронный редуктор</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Emergency stop</source>
        <translation>Аварийный останов</translation>
    </message>
    <message>
        <location filename="../widgets/text_entry.cpp"/>
        <source>Empty</source>
        <translation>Очистить</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Empty the field</source>
        <translation>Очистить поле</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End of the thread Z</source>
        <translation>Конец резьбы Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End of the way back X</source>
        <translation>Конец обратного хода X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End of the way back Z</source>
        <translation>Конец обратного хода Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>End point X</source>
        <translation>Конечная точка X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End point X of the last plunge</source>
        <translation>Конечная точка X последнего врезания</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End point X, where the thread is tapered</source>
        <translation>Конечная точка X, если резьба коническая</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>End point Z</source>
        <translation>Конечная точка Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>End point Z of the last plunge</source>
        <translation>Конечная точка Z последнего врезания</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>End point Z, where the thread is tapered</source>
        <translation>Конечная точка Z, если резьба коническая</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>End with this part</source>
        <translation>Стоп после детали</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Завершён</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Прервёт все: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Прервёт программу: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Ends the programs of the group: press again</source>
        <translation>Прервёт всю группу: ещё раз</translation>
    </message>
    <message>
        <location filename="../widgets/text_pad.cpp"/>
        <source>Enter</source>
        <translation>Enter</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Enter it</source>
        <translation>Ввести</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Enter logs in. A new user gets this name, this password and the level %1.</source>
        <translation>Enter выполняет вход. Новый пользователь получит это имя, этот пароль и уровень «%1».</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Enter takes the block first</source>
        <translation>Сначала примите кадр клавишей Enter</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Enter takes the block, Start runs it</source>
        <translation>Enter принимает кадр, пуск выполняет</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Enter the start point, then add lines and arcs with what the drawing says.</source>
        <translation>Введите начальную точку, затем добавляйте отрезки и дуги по чертежу.</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Enter zeros, offsets</source>
        <translation>Ввести нули, корректоры</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Enter, or a second touch, changes it.</source>
        <translation>Enter или второе касание меняет.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Entered</source>
        <translation>Введено</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Enters the relative counter: press again</source>
        <translation>Введёт счётчик: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Enters what was touched: press again</source>
        <translation>Введёт измеренное: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Every axis and spindle is on its own: nothing is coupled, exchanged or followed.</source>
        <translation>Каждая ось и шпиндель сами по себе: нет связей, обмена и слежения.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Everything becomes as then: press again</source>
        <translation>Всё станет как тогда: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Exchange</source>
        <translation>Поменять</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Exchange with it</source>
        <translation>Поменять с ним</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Export</source>
        <translation>Экспорт</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>External</source>
        <translation>Внеш. смещение</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>F11, or the key at the top: the next one</source>
        <translation>F11 или кнопка вверху: следующий</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Face Z</source>
        <translation>Торец Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Facing a straight section</source>
        <translation>Подрезка прямого участка</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Facing an arc</source>
        <translation>Подрезка дуги</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Facing, one pass</source>
        <translation>Подрезка, один проход</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Factor</source>
        <translation>Множитель</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Factor of the pecks; tapping: kind 0, 1, 2</source>
        <translation>Множитель шагов; метчик: вид 0, 1, 2</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor axes</source>
        <translation>Fagor: оси</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor general</source>
        <translation>Fagor: общее</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fagor spindle</source>
        <translation>Fagor: шпиндель</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc B axis</source>
        <translation>Fanuc: ось B</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc axes</source>
        <translation>Fanuc: оси</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc cycles</source>
        <translation>Fanuc: циклы</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc interfaces</source>
        <translation>Fanuc: интерфейсы</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc macros</source>
        <translation>Fanuc: макро</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc offsets</source>
        <translation>Fanuc: коррекции</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Fanuc programs</source>
        <translation>Fanuc: программы</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Faster</source>
        <translation>Быстрее</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Feed</source>
        <translation>Подача</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Feed hold</source>
        <translation>Стоп подачи</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Стоп подачи: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed into hollows</source>
        <translation>Подача врезания во впадины</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed of finishing</source>
        <translation>Подача чистовой обработки</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Feed of finishing, where the contour says none</source>
        <translation>Чистовая подача, если её нет в контуре</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Feed of roughing</source>
        <translation>Подача черновой обработки</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Feed of the last roughing pass</source>
        <translation>Подача последнего чернового прохода</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed on the way in</source>
        <translation>Подача на пути внутрь</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed on the way out</source>
        <translation>Подача на пути наружу</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Feed: lead times speed</source>
        <translation>Подача: шаг, умноженный на обороты</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Feedrate</source>
        <translation>Подача</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Field</source>
        <translation>Адрес</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Files</source>
        <translation>Файлы</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Filter</source>
        <translation>Фильтр</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Finishing a contour</source>
        <translation>Чистовая обработка контура</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance</source>
        <translation>Чистовой припуск</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance X</source>
        <translation>Чистовой припуск X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Finishing allowance Z</source>
        <translation>Чистовой припуск Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Finishing passes</source>
        <translation>Чистовых проходов</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>First WINS server</source>
        <translation>Первый WINS</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>First block of the contour</source>
        <translation>Первый кадр контура</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>First name server</source>
        <translation>Первый DNS</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>First part</source>
        <translation>Первая деталь</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>First part %1</source>
        <translation>Первая деталь %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>Первая деталь: пуск продолжит этим инструментом</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>First to stop the machine: %1; parts until then: %2</source>
        <translation>Первым остановит станок: %1; деталей до этого: %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Follow. error</source>
        <translation>Рассогл.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>For the offset and the gauge pin</source>
        <translation>Для корректора и калибра</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Forget place</source>
        <translation>Забыть папку</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Found: %1</source>
        <translation>Найдено: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Free</source>
        <translation>Свободно</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>From</source>
        <translation>Откуда</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>From hole to hole</source>
        <translation>От отверстия до отверстия</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>From rapid to feed (R level)</source>
        <translation>Переход на подачу (уровень R)</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>From the beginning</source>
        <translation>С начала</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>From the start to the first hole</source>
        <translation>От начала до первого отверстия</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Full torque</source>
        <translation>Полный момент суппорта</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>G code</source>
        <translation>код G</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Gateway</source>
        <translation>Шлюз</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Geom.</source>
        <translation>Геом.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Geometry + wear</source>
        <translation>Геометрия + износ</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Give this level</source>
        <translation>Задать уровень</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Given</source>
        <translation>Задано</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Goes back to its own place</source>
        <translation>Возвращается на своё место</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Gradient Compensation</source>
        <translation>Коррекция наклона</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Graphics</source>
        <translation>Графика</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Greatest, least deviation</source>
        <translation>Отклонение, макс. / мин.</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Grooving along X</source>
        <translation>Канавки вдоль X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Grooving along Z</source>
        <translation>Канавки вдоль Z</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Group %1</source>
        <translation>Группа %1</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>Handbook</source>
        <translation>Руководство</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Маховичок</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Handwheel offset</source>
        <translation>Смещение маховичком</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Height of the thread (radius)</source>
        <translation>Высота резьбы (радиус)</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Held</source>
        <translation>Удержан</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Help</source>
        <translation>Справка</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Highest bar: %1 of %2 ticks; both scales are logarithmic</source>
        <translation>Самый высокий столбец: %1 из %2 тактов; обе шкалы логарифмические</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>History</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Hold %1</source>
        <translation>Стоп подачи %1</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Hold all</source>
        <translation>Стоп подачи всех</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Hold group %1</source>
        <translation>Стоп подачи группы %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>How</source>
        <translation>Как</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>How long</source>
        <translation>Длит.</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Hz</source>
        <translation>Гц</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Ignore waits %1</source>
        <translation>Без ожиданий %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>In position</source>
        <translation>В позиции</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>In the file</source>
        <translation>В файле</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>In this magazine</source>
        <translation>В этом магазине</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Increment in X (radius)</source>
        <translation>Приращение по X (радиус)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Increment in Z</source>
        <translation>Приращение по Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Input</source>
        <translation>Ввод</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Прерван</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Interval meter</source>
        <translation>Интервальный счётчик</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>It acts at once: press again</source>
        <translation>Действует сразу: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>It cannot be read: %1</source>
        <translation>Не читается: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>It cannot be shown.</source>
        <translation>Показать нельзя.</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>It comes by DHCP (N5108)</source>
        <translation>Приходит по DHCP (N5108)</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>It follows the main spindle</source>
        <translation>Синхронизация с гл. шпинделем</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>It gave no result.</source>
        <translation>Результата нет.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>It is entered</source>
        <translation>Введено</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>It is gone for good: press again</source>
        <translation>Удалится навсегда: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>It is gone: press again</source>
        <translation>Исчезнет: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>It is no text in UTF-8: it cannot be edited without a loss.</source>
        <translation>Это не текст UTF-8: правка испортит его.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>It is the gauge pin: press again</source>
        <translation>Это калибр: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>It runs now: press again</source>
        <translation>Она работает: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>It was stopped.</source>
        <translation>Остановлено.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Its blocks were edited by hand: writing replaces them.</source>
        <translation>Кадры изменены вручную: запись их заменит.</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Its chuck clamps</source>
        <translation>Зажать патрон противошпинделя</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Its chuck opens</source>
        <translation>Разжать патрон противошпинделя</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Its data contradict each other, or nothing fits them.</source>
        <translation>Данные противоречат друг другу или им ничто не подходит.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Its values go: press again</source>
        <translation>Значения пропадут: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Ручной</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Jog against the part</source>
        <translation>Подвести к детали</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Jog in hold %1</source>
        <translation>Ручное перемещение в останове %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Jog keys</source>
        <translation>Клавиши осей</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Jog: pull the part out</source>
        <translation>Вытянуть деталь</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Keep as place</source>
        <translation>Запомнить папку</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Kept, but: %1</source>
        <translation>Сохранено, но: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Kept: %1</source>
        <translation>Запомнено: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Keyboard</source>
        <translation>Клавиатура</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Keyboard layout</source>
        <translation>Раскладка клавиатуры</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Kind</source>
        <translation>Вид</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Kind of infeed</source>
        <translation>Вид врезания</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Kind of place that it needs, 0 any</source>
        <translation>Вид нужного места, 0 любое</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Kind: 500 roughing, 510 finishing, 200 drill ...</source>
        <translation>Вид: 500 черновой, 510 чистовой, 200 сверло ...</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>L%1 asks: %2</source>
        <translation>L%1 спрашивает: %2</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>L%1 decides %2 of %3: what becomes shorter there shortens the cycle.</source>
        <translation>L%1 определяет %2 из %3: ускорение здесь сокращает цикл.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>L%1 is in automatic mode: choose Jog or MDI</source>
        <translation>L%1 в автоматическом режиме: выберите «Ручной» или «РВД»</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>L%1: restart at block</source>
        <translation>L%1: начать с кадра</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>L%1: straightness, pair %2</source>
        <translation>L%1: прямолинейность, пара %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>L%1: volume</source>
        <translation>L%1: объём</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Lag</source>
        <translation>Рассогл.</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Language of the screens</source>
        <translation>Язык экранов</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Larger</source>
        <translation>Крупнее</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Largest</source>
        <translation>Наибольшая</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Largest speed</source>
        <translation>Наибольшие обороты</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Last</source>
        <translation>Последний</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Last block of the contour</source>
        <translation>Последний кадр контура</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Last tool call</source>
        <translation>Вызов инструмента</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Later</source>
        <translation>Позже</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Lead</source>
        <translation>Шаг резьбы</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead along X</source>
        <translation>Шаг резьбы по X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead along Z</source>
        <translation>Шаг резьбы по Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead as on the way in</source>
        <translation>Шаг, как на пути внутрь</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Lead; negative: a left-hand thread</source>
        <translation>Шаг; отрицательный: левая резьба</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Least depth of a pass</source>
        <translation>Наименьшая глубина прохода</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Least depth of a peck</source>
        <translation>Наименьшая глубина шага</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Length</source>
        <translation>Длина</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Length of the run-out</source>
        <translation>Длина сбега</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Level</source>
        <translation>Уровень</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life</source>
        <translation>Ресурс</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Life and forecast</source>
        <translation>Ресурс и прогноз</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life and wear to 0: press again</source>
        <translation>Ресурс и износ в 0: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Life group of programs</source>
        <translation>Группа ресурса программ</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Life left</source>
        <translation>Остаток ресурса</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Life measured in</source>
        <translation>Единица ресурса</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Life nearly over</source>
        <translation>Ресурс на исходе</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Life to 0, wear stays: press again</source>
        <translation>Ресурс в 0, износ остаётся: ещё раз</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Line</source>
        <translation>Отрезок</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Line %1 of the description cannot be read: a new contour begins here.</source>
        <translation>Строка %1 описания не читается: здесь начинается новый контур.</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Little torque for the slide</source>
        <translation>Ограничить момент суппорта</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Load</source>
        <translation>Загрузить</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Loading station</source>
        <translation>Станция загрузки</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Протирка</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Lock place</source>
        <translation>Блокировать место</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Lock tool</source>
        <translation>Блокировать инструмент</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Locked</source>
        <translation>Заблокирован</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Экран заблокирован для протирки</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log in</source>
        <translation>Войти</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log in to see the users.</source>
        <translation>Войдите, чтобы увидеть пользователей.</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Log of stops</source>
        <translation>Журнал остановов</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Log out</source>
        <translation>Выйти</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Logged in: %1, %2</source>
        <translation>Вход выполнен: %1 (%2)</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Longer</source>
        <translation>Окно больше</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Longest wait: L%1 stands %2 s at %3 (line %4).</source>
        <translation>Самое долгое ожидание: L%1 стоит %2 с на %3 (строка %4).</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Проверьте, работает ли УЧПУ; повторите.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Lost: %1</source>
        <translation>Потеряно: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Lower</source>
        <translation>Нижн.</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>M code</source>
        <translation>код M</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>MDI</source>
        <translation>РВД</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>MDI mode takes blocks, and a program in hold</source>
        <translation>Кадры принимают режим РВД и останов подачи</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>MEFI constants</source>
        <translation>Константы MEFI</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Machine</source>
        <translation>Станок</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Блокировка осей</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Machine lock %1</source>
        <translation>Блокировка осей %1</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Machine off</source>
        <translation>Станок выключен</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Machine on</source>
        <translation>Станок вкл.</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Macro</source>
        <translation>Макропрограммы</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Magazines</source>
        <translation>Магазины</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Main axis: 0 Z, 1 X</source>
        <translation>Главная ось: 0 Z, 1 X</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.hpp"/>
        <source>Manual</source>
        <translation>Вручную</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Manual Handle</source>
        <translation>Маховичок</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Mark</source>
        <translation>Отметить</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Marked: %1</source>
        <translation>Отмечено: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Max</source>
        <translation>Макс.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>May be used</source>
        <translation>Разрешён к работе</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Средний</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Meaning</source>
        <translation>Описание</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Measure</source>
        <translation>Измерить</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Measured</source>
        <translation>Измерено</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Measured file</source>
        <translation>Файл измерений</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Measured parts</source>
        <translation>Замеры деталей</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Measured: %1</source>
        <translation>Измерено: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Measures ...</source>
        <translation>Измерение ...</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Message</source>
        <translation>Сообщение</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Min</source>
        <translation>Мин.</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>More</source>
        <translation>Ещё</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Mounted</source>
        <translation>Установлено</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Move</source>
        <translation>Переместить</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Moves</source>
        <translation>Движется</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Multichannel Control</source>
        <translation>Многоканальность</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>NC</source>
        <translation>ЧПУ</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Name of the dimension</source>
        <translation>Название размера</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Network</source>
        <translation>Сеть</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Network address</source>
        <translation>Сетевой адрес</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>New dimension</source>
        <translation>Новый размер</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>New edge</source>
        <translation>Новая кромка</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New folder</source>
        <translation>Новая папка</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>New insert</source>
        <translation>Новая пластина</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New name</source>
        <translation>Новое имя</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>New program</source>
        <translation>Новая программа</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>New tool</source>
        <translation>Новый инструмент</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>New user</source>
        <translation>Новый</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Next difference</source>
        <translation>Следующее различие</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Next fault</source>
        <translation>Следующая ошибка</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Next page</source>
        <translation>Следующая страница</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Next part</source>
        <translation>Следующая часть</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Next solution</source>
        <translation>Другое решение</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>No active alarms.</source>
        <translation>Активных аварий нет.</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>No alarm and no message is known yet.</source>
        <translation>Аварий и сообщений пока не было.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>No block is entered</source>
        <translation>Кадр не введён</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>No changes recorded.</source>
        <translation>Записанных изменений нет.</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>No channel has stood in this time.</source>
        <translation>За это время ни один канал не стоял.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>No circle has been driven since the record began: drive at least three quarters of one in L%1</source>
        <translation>С начала записи круга не было: проедьте хотя бы три четверти круга в L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>No compensation table is described (N2500 to N2808).</source>
        <translation>Таблицы компенсации не описаны (N2500 - N2808).</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>Нет связи с УЧПУ</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>No faults found</source>
        <translation>Ошибок нет</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>No forecast yet: it begins when parts have been made with tools whose life is monitored.</source>
        <translation>Прогноза ещё нет: он начнётся, когда детали будут сделаны инструментом с учётом ресурса.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>No job names the stock of the running program</source>
        <translation>Ни одно задание не называет заготовку программы</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>No network connection is managed here</source>
        <translation>Здесь нет управляемого сетевого подключения</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>No parameter has this in its number, name or meaning.</source>
        <translation>Нет параметра с таким номером, именем или описанием.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>No part transfer is set up on this machine: its channels choose no counter spindle.</source>
        <translation>Передача детали на этом станке не настроена: его каналы не выбирают противошпиндель.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>No pictures (PGM, BMP, PNG) in this folder.</source>
        <translation>В этой папке нет снимков (PGM, BMP, PNG).</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>No program is selected.</source>
        <translation>Программа не выбрана.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No signal has this in its name or meaning.</source>
        <translation>Нет сигнала с таким именем или описанием.</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>No start</source>
        <translation>Нет пуска</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>No tool has been called where the programs stopped: touch a block, or type its number</source>
        <translation>До места останова инструмент не вызывался: коснитесь кадра или введите его номер</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>No tool is chosen.</source>
        <translation>Инструмент не выбран.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>No tool is like this.</source>
        <translation>Таких инструментов нет.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_plot.cpp"/>
        <source>No trace is chosen: Enter on a line, or touch it twice</source>
        <translation>Сигнал не выбран: Enter на строке или двойное касание</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No variable has this in its name.</source>
        <translation>Нет переменной с таким именем.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>No variable of this channel has a value.</source>
        <translation>Ни у одной переменной канала нет значения.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>No.</source>
        <translation>№</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Nobody is logged in. Without a login: %1</source>
        <translation>Никто не вошёл. Без входа: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Nominal</source>
        <translation>Номинал</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>None is known.</source>
        <translation>Неизвестно.</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Not described: enter its parameters.</source>
        <translation>Не описана: введите её параметры.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Not done: %1</source>
        <translation>Не сделано: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Not enabled</source>
        <translation>Не разрешён</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Not in position</source>
        <translation>Не в позиции</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Not in use by the running program</source>
        <translation>Программой не используется</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Not loaded</source>
        <translation>Не загружены</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>Not saved: stopped. The file is as it was.</source>
        <translation>Не сохранено: остановлено. Файл остался прежним.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Nothing has been changed.</source>
        <translation>Ничего не изменено.</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>Nothing is like this. Escape shows all.</source>
        <translation>Такого здесь нет. Escape показывает всё.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Nothing is missing for a start</source>
        <translation>Для пуска всё готово</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Nothing to load: every tool has a place</source>
        <translation>Загружать нечего: у каждого инструмента есть место</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Nothing to simulate: %1</source>
        <translation>Нечего моделировать: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Nothing would change</source>
        <translation>Ничего не изменится</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Now</source>
        <translation>Сейчас</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Number</source>
        <translation>Номер</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Number of holes</source>
        <translation>Число отверстий</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Number of its first block</source>
        <translation>Номер первого кадра</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Number of its last block</source>
        <translation>Номер последнего кадра</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Number of passes</source>
        <translation>Число проходов</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Number of starts</source>
        <translation>Число заходов</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>OK</source>
        <translation>ОК</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Offset</source>
        <translation>Корректор</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Offset number</source>
        <translation>Номер корректора</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Offset number of the radius</source>
        <translation>Номер корректора радиуса</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Offsets</source>
        <translation>Корректоры</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>One ring</source>
        <translation>Цена кольца</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>Only L%1</source>
        <translation>Только L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Only a maker can confirm: log in on the page «Users».</source>
        <translation>Признать может только изготовитель: войдите на странице «Пользователи».</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Only a whole number is possible.</source>
        <translation>Возможно только целое число.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Only more than 0 is possible here.</source>
        <translation>Здесь возможно только больше 0.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Open folder</source>
        <translation>Открыть папку</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Open the program</source>
        <translation>Открыть программу</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Open: %1 more data are needed, here or in the next elements.</source>
        <translation>Открыто: нужно ещё данных: %1, здесь или в следующих элементах.</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Open: what lies before it is not known yet.</source>
        <translation>Открыто: то, что перед ним, ещё не известно.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Operation time</source>
        <translation>Время работы</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Останов M1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Останов M1 %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Останов M1: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Order among sisters</source>
        <translation>Порядок среди дублёров</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Other</source>
        <translation>Прочее</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other edges than the job's hold: %1</source>
        <translation>Действуют не те кромки, что в задании: %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Other feeds than programmed: press again</source>
        <translation>Подачи не из программы: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Other files may name it: press again</source>
        <translation>На него могут ссылаться: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Other level</source>
        <translation>Другой уровень</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other offsets than the job's hold: %1</source>
        <translation>Действуют не те корректоры, что в задании: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Other zeros than the job's hold: %1</source>
        <translation>Действуют не те нули, что в задании: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Outline that protection guards: X -60:0 Z -20:5</source>
        <translation>Контур для защиты: X -60:0 Z -20:5</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Overrides</source>
        <translation>Коррекция</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.hpp"/>
        <source>Overview</source>
        <translation>Обзор</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Own folder</source>
        <translation>Домашняя папка</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Own magazine</source>
        <translation>Свой магазин</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Own place</source>
        <translation>Своё место</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>PID</source>
        <translation>PID</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>PLC</source>
        <translation>ПЛК</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>PLC Constants</source>
        <translation>Константы ПЛК</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Page down</source>
        <translation>Страница вниз</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Page up</source>
        <translation>Страница вверх</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pallet</source>
        <translation>Паллета</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Pallet Management</source>
        <translation>Паллеты</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pallet number, 0: no pallet</source>
        <translation>Номер паллеты, 0: нет паллеты</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Pallets</source>
        <translation>Паллеты</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Panel computer</source>
        <translation>Компьютер</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Part before</source>
        <translation>Предыдущая часть</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Part time</source>
        <translation>Время детали</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Part transfer, step by step</source>
        <translation>Передача детали по шагам</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Parts</source>
        <translation>Детали</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Parts go on: press again</source>
        <translation>Детали дальше: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts in all</source>
        <translation>Деталей всего</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Parts left</source>
        <translation>Ещё деталей</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts of this job</source>
        <translation>Деталей задания</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts since the start</source>
        <translation>Деталей с запуска</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Parts wanted</source>
        <translation>Нужно деталей</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Password</source>
        <translation>Пароль</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Path backwards %1</source>
        <translation>Назад по траектории %1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Paths since these screens started; tips drawn as points</source>
        <translation>Траектории с запуска экрана; вершины резцов — точки</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Pattern menu</source>
        <translation>Меню шаблонов</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Pause</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Pecking and grooving along Z</source>
        <translation>Сверление с выводом, канавки вдоль Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Per division</source>
        <translation>Деление</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>Period</source>
        <translation>Период</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Picture</source>
        <translation>Снимок</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Pitch Error Compensation</source>
        <translation>Погрешности шага</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Place of the hole C</source>
        <translation>Место отверстия C</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Place of the hole X</source>
        <translation>Место отверстия X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Place of the hole Z</source>
        <translation>Место отверстия Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Places</source>
        <translation>Папки и носители</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Places of holes along a line</source>
        <translation>Места отверстий по прямой</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Places of holes on a circle</source>
        <translation>Места отверстий по окружности</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Plain S means the counter spindle</source>
        <translation>S без номера = противошпиндель</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>Plain S means the main spindle</source>
        <translation>S без номера = главный шпиндель</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Plain S of L%1 means S%2 now: M%3 would act on its chuck.</source>
        <translation>S без номера в L%1 сейчас означает S%2: M%3 подействует на его патрон.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Play</source>
        <translation>Показать</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Points</source>
        <translation>Точек</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Polyturn</source>
        <translation>Polyturn</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Pool %1</source>
        <translation>Накопитель %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Position</source>
        <translation>Положение</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Position Switches</source>
        <translation>Позиц. выключатели</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Power on</source>
        <translation>Включено</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Presetter</source>
        <translation>Прибор настройки</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>Previous difference</source>
        <translation>Предыдущее различие</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Print setup sheet</source>
        <translation>Печать карты наладки</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Printed: %1</source>
        <translation>Напечатано: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Probe is offset %1: press again</source>
        <translation>Щуп: корректор %1, ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Process</source>
        <translation>Процесс</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>Процесс не работает</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Processes</source>
        <translation>Процессы</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Processes and ticks</source>
        <translation>Процессы и такты</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Program</source>
        <translation>Программа</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Program control</source>
        <translation>Управление программой</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Program of the pallet</source>
        <translation>Программа паллеты</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Program with the contour</source>
        <translation>Программа с контуром</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Programmed stop</source>
        <translation>Останов в программе</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Останов M0: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Programs</source>
        <translation>Программы</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Programs and jobs</source>
        <translation>Программы и задания</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Proposal</source>
        <translation>Коррекция</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Proposal: %1</source>
        <translation>Коррекция: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Protect</source>
        <translation>Защитить</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Protected</source>
        <translation>Защищено</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Put it here</source>
        <translation>Поставить сюда</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Radius</source>
        <translation>Радиус</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Radius of the arc</source>
        <translation>Радиус дуги</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Radius of the circle of holes</source>
        <translation>Радиус окружности отверстий</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Radius, commanded</source>
        <translation>Заданный радиус</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Range</source>
        <translation>Диапазон</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Range %1 of L%2</source>
        <translation>Зона %1 L%2</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Rapid</source>
        <translation>Быстр. ход</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Rapid %1 %</source>
        <translation>Быстр. %1 %</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Ready</source>
        <translation>Готов</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reaming (in G17 along Z)</source>
        <translation>Развёртывание (в G17 по Z)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reaming behind each block that moves</source>
        <translation>Развёртывание после каждого кадра с движением</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Record</source>
        <translation>Запись</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Records</source>
        <translation>Идёт запись</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Redo</source>
        <translation>Повторить</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Реф. точка</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Reference Point</source>
        <translation>Референтная точка</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Reference all</source>
        <translation>Все оси: в реф. точку</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Reference plane: the surface</source>
        <translation>Базовая плоскость: поверхность</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Refresh</source>
        <translation>Обновить</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Relative input</source>
        <translation>Ввод относит.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Relative zero</source>
        <translation>Относит. нуль</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Release place</source>
        <translation>Разблокировать место</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Release tool</source>
        <translation>Разблокировать инструмент</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Relief at the bottom</source>
        <translation>Отвод на дне</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Осталось</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Remedy</source>
        <translation>Что делать</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Rename</source>
        <translation>Переименовать</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Renamed</source>
        <translation>Переименовано</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Repair: where the thread was measured</source>
        <translation>Ремонт: где измерена резьба</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Repeating a contour</source>
        <translation>Повторение контура</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Repeats in a second</source>
        <translation>Повторов в секунду</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Replaces the one that is here: press again</source>
        <translation>Заменит здешний: нажмите ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Replaces what is entered: press again</source>
        <translation>Заменит введённое: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Required tools</source>
        <translation>Нужные инструменты</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Reset</source>
        <translation>Сброс</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset %1</source>
        <translation>Сброс %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset all</source>
        <translation>Сброс всех</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Reset group %1</source>
        <translation>Сброс группы %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Restart</source>
        <translation>Перезапуск</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Restart at</source>
        <translation>Начать с</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Restart in the middle</source>
        <translation>Пуск с кадра</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Возобновление: пуск выполнит подвод</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Restore</source>
        <translation>Восстановить</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Restored values and files: %1</source>
        <translation>Восстановлено значений и файлов: %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>Возврат по траектории дошёл до конца</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Retract after each pass</source>
        <translation>Отвод после каждого прохода</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Retract plane</source>
        <translation>Плоскость отвода</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Return %1</source>
        <translation>Возврат %1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Rigid tapping</source>
        <translation>Жёсткое нарезание</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the face</source>
        <translation>Жёсткое нарезание в торце</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the face, the way back</source>
        <translation>Жёсткое нарезание в торце, обратный ход</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the side</source>
        <translation>Жёсткое нарезание сбоку</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Rigid tapping in the side, the way back</source>
        <translation>Жёсткое нарезание сбоку, обратный ход</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Rigid tapping of a left-hand thread</source>
        <translation>Жёсткое нарезание левой резьбы</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room above, half places</source>
        <translation>Место сверху, полуместа</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room below, half places</source>
        <translation>Место снизу, полуместа</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room to the left, half places</source>
        <translation>Место слева, полуместа</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Room to the right, half places</source>
        <translation>Место справа, полуместа</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Roughing along X</source>
        <translation>Черновая обработка вдоль X</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Roughing along Z</source>
        <translation>Черновая обработка вдоль Z</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Rounding to the next one</source>
        <translation>Скругление к следующему</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Run-in; -1: as the axis accelerates</source>
        <translation>Разбег; -1: как разгоняется ось</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Run-out in tenths of the lead</source>
        <translation>Сбег в десятых шага</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Run-out; -1: as the axis brakes</source>
        <translation>Сбег; -1: как тормозит ось</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Работает</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Runs in and out within the thread: 1</source>
        <translation>Вход и выход внутри резьбы: 1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Safety distance</source>
        <translation>Безопасное расстояние</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Safety distance before the surface</source>
        <translation>Безопасное расстояние до поверхности</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Safety distance of the way back</source>
        <translation>Безопасное расстояние отвода</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>Save</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Save now</source>
        <translation>Сохранить</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Saved: %1</source>
        <translation>Сохранено: %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Saves the text first: press again</source>
        <translation>Сначала сохранит текст: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Scope</source>
        <translation>Осциллограф</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Search</source>
        <translation>Поиск</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: a zero</source>
        <translation>Поиск: нуль детали</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: number or tool</source>
        <translation>Поиск: номер или инструмент</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Search: number, name or meaning</source>
        <translation>Поиск: номер, имя или описание</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Search: number, tool, edge</source>
        <translation>Поиск: номер, инструмент, кромка</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Second WINS server</source>
        <translation>Второй WINS</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Second name server</source>
        <translation>Второй DNS</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Select in L%1</source>
        <translation>Выбрать в L%1</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Select job</source>
        <translation>Выбрать задание</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Sets the default: press again</source>
        <translation>Задаст исходное: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Sets the zero: press again</source>
        <translation>Задаст нуль: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>Setting</source>
        <translation>Настройка</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Several solutions: touch the one that is meant, or «Next solution».</source>
        <translation>Несколько решений: коснитесь нужного или «Другое решение».</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Shorter</source>
        <translation>Окно меньше</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Signal</source>
        <translation>Сигнал</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Signals</source>
        <translation>Сигналы</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Signals of NC and PLC</source>
        <translation>Сигналы ЧПУ и ПЛК</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Simulation</source>
        <translation>Моделирование</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Simulation, timeline</source>
        <translation>Моделирование, шкала</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Simulation: %1 of %2</source>
        <translation>Моделирование: %1 из %2</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Since</source>
        <translation>Начало</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Single block</source>
        <translation>Покадрово</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block %1</source>
        <translation>Покадрово %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block all</source>
        <translation>Покадрово: все</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Single block group %1</source>
        <translation>Покадрово: группа %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Покадрово: пуск выполнит следующий кадр</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Sinumerik</source>
        <translation>Sinumerik</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Sister</source>
        <translation>Дублёр</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Skip Function</source>
        <translation>Функция пропуска</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Slower</source>
        <translation>Медленнее</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Smaller</source>
        <translation>Мельче</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Smoothing</source>
        <translation>Сглаживание</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>So much left is a warning</source>
        <translation>Предупредить при остатке</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Solid outline: monitored; dashed: drawn only</source>
        <translation>Сплошной контур — под защитой, штриховой — только показ</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Some elements are still open.</source>
        <translation>Некоторые элементы ещё открыты.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Some ticks were missed</source>
        <translation>Часть тактов пропущена</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Speed not reached</source>
        <translation>Обороты не набраны</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Speed of the spindle</source>
        <translation>Частота вращения шпинделя</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Speed reached</source>
        <translation>Обороты набраны</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Spindle</source>
        <translation>Шпиндель</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Spindle %1</source>
        <translation>Шпиндель %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Spindle Control</source>
        <translation>Шпиндели</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Spindle Servo</source>
        <translation>Приводы шпинделей</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>Spindle stop</source>
        <translation>Стоп шпинделя</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Stands</source>
        <translation>Стоит</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start</source>
        <translation>Начало</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start %1</source>
        <translation>Пуск %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start all</source>
        <translation>Пуск всех</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Start blocked:</source>
        <translation>Пуск заблокирован:</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Start goes back along the path: press again</source>
        <translation>Пуск поведёт по пути назад: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Start goes backwards</source>
        <translation>Пуск ведёт назад</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Start group %1</source>
        <translation>Пуск группы %1</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Start of the line, 1st axis (X: radius)</source>
        <translation>Начало прямой, 1-я ось (X: радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Start of the line, 2nd axis (X: radius)</source>
        <translation>Начало прямой, 2-я ось (X: радиус)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start point X</source>
        <translation>Начальная точка X</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Start point Z</source>
        <translation>Начальная точка Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Starts</source>
        <translation>Запускается</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Пуск всех каналов: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/operation_keys.cpp"/>
        <source>Starts the whole group: press again</source>
        <translation>Пуск всей группы: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Station</source>
        <translation>Станция</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Step along X (radius)</source>
        <translation>Шаг по X (радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Step along Z</source>
        <translation>Шаг по Z</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Step between two plunges</source>
        <translation>Шаг между врезаниями</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Stock</source>
        <translation>Заготовка</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Stock to take off</source>
        <translation>Снимаемый припуск</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Stock to take off along X (radius)</source>
        <translation>Снимаемый припуск по X (радиус)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Stock to take off along Z</source>
        <translation>Снимаемый припуск по Z</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Stop</source>
        <translation>Стоп</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Stop record</source>
        <translation>Стоп записи</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Остановлен</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>Stopped at</source>
        <translation>Останов на</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>Stopped: %1</source>
        <translation>Остановлено: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Straightness Compensation</source>
        <translation>Прямолинейность</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Subnet mask</source>
        <translation>Маска подсети</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Surface Z</source>
        <translation>Поверхность Z</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Switched off</source>
        <translation>Выключена</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Switches the drives on: press again</source>
        <translation>Включит приводы: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Synchronised view</source>
        <translation>Синхронный вид</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.hpp"/>
        <source>System</source>
        <translation>Система</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>System Config</source>
        <translation>Система</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Table</source>
        <translation>Таблица</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Tailstock %1</source>
        <translation>Задняя бабка %1</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Tailstock zone of L%1</source>
        <translation>Зона задней бабки L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Take a measured file</source>
        <translation>Взять файл измерений</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Tangential to the one before (1: yes)</source>
        <translation>Касательно к предыдущему (1: да)</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Tangential to what? Nothing lies before it.</source>
        <translation>Касательно к чему? Перед ним ничего нет.</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Taper (Z at the start less that at the end)</source>
        <translation>Конус (Z в начале минус в конце)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Taper (radius at the start less that at the end)</source>
        <translation>Конус (радиус в начале минус в конце)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping</source>
        <translation>Нарезание метчиком</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping a left-hand thread</source>
        <translation>Левая резьба метчиком</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping in the face</source>
        <translation>Нарезание метчиком в торце</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Tapping in the face with a compensating chuck</source>
        <translation>Нарезание в торце с компенсирующим патроном</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Tapping in the side</source>
        <translation>Нарезание метчиком сбоку</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Tapping in the side with a compensating chuck</source>
        <translation>Нарезание сбоку с компенсирующим патроном</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>The NC writes it.</source>
        <translation>Его задаёт ЧПУ.</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>The PLC writes it.</source>
        <translation>Его задаёт ПЛК.</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The axes are free: press again</source>
        <translation>Оси свободны: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The axes go back: press again</source>
        <translation>Оси поедут назад: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>The axes move again: press again</source>
        <translation>Оси снова пойдут: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>The axes stand while the program runs: press again</source>
        <translation>Программа идёт, оси стоят: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The blocks are searched: nothing moves</source>
        <translation>Идёт поиск кадров: ничего не движется</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>The contour is complete.</source>
        <translation>Контур определён полностью.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>УЧПУ не ответило.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>УЧПУ отказало.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The copy of %1 was not what had been sent; what was there before stands</source>
        <translation>Копия %1 не совпала с отправленным; прежний файл остался</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The counter spindle is free</source>
        <translation>Отключить синхронизацию</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The editor holds a text that is not saved</source>
        <translation>В редакторе несохранённый текст</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The file is being read ...</source>
        <translation>Файл читается ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>The folder is being read ...</source>
        <translation>Папка читается ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The job is being simulated</source>
        <translation>Идёт моделирование задания</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>The job is for another machine: %1</source>
        <translation>Задание для другого станка: %1</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>The keys below act when they are kept pressed.</source>
        <translation>Клавиши внизу действуют, если их удерживать.</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>The last %1 days</source>
        <translation>Последние %1 дней</translation>
    </message>
    <message>
        <location filename="../screens/machine/stops_page.cpp"/>
        <source>The last %1 h</source>
        <translation>Последние %1 ч</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_files.cpp"/>
        <source>The last program is still being written.</source>
        <translation>Предыдущая программа ещё записывается.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The line of MDI is not entered: choose MDI, or delete the line</source>
        <translation>Строка РВД не введена: выберите РВД или удалите строку</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>The machine has lost data: no program starts</source>
        <translation>Станок потерял данные: программы не пускаются</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The main chuck clamps</source>
        <translation>Зажать патрон гл. шпинделя</translation>
    </message>
    <message>
        <location filename="../machine/programs/transfer_steps.cpp"/>
        <source>The main chuck opens</source>
        <translation>Разжать патрон гл. шпинделя</translation>
    </message>
    <message>
        <location filename="../app/help_view.cpp"/>
        <source>The manual is not installed here.</source>
        <translation>Руководство здесь не установлено.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>The newest backup: %1</source>
        <translation>Самая новая копия: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>The offset is written</source>
        <translation>Корректор записан</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>The operating system keeps these values and says who may change them; Enter, or a second touch, changes one.</source>
        <translation>Эти значения хранит операционная система, она же решает, кто их меняет; Enter или второе касание меняет значение.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>The pallet in a row goes with its program. «Exchange»: choose a row, press, choose the other row, press again.</source>
        <translation>Паллета меняется вместе с программой. «Поменять»: выберите строку, нажмите, выберите другую, нажмите ещё раз.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>The pallets are being asked for ...</source>
        <translation>Запрашиваются паллеты ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The printer refused it: %1</source>
        <translation>Принтер отказал: %1</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>The program asks: answer on its page</source>
        <translation>Программа спрашивает: ответьте на её странице</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>The program cannot be checked here.</source>
        <translation>Программу здесь не проверить.</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>The program is being read</source>
        <translation>Программа читается</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>The program of L%1 waits for an answer</source>
        <translation>Программа L%1 ждёт ответа</translation>
    </message>
    <message>
        <location filename="../machine/programs/dry_run.cpp"/>
        <source>The program polyturn is not beside the HMI.</source>
        <translation>Программы polyturn нет рядом с HMI.</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>The program runs</source>
        <translation>Программа выполняется</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>The program was broken off</source>
        <translation>Программа прервана</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>The programs are being compared ...</source>
        <translation>Программы сравниваются ...</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The programs are being read</source>
        <translation>Программы читаются</translation>
    </message>
    <message>
        <location filename="../screens/tools/offset_entries.cpp"/>
        <source>The relative counter of L%1 begins here</source>
        <translation>Относительный счётчик L%1 начинается здесь</translation>
    </message>
    <message>
        <location filename="../screens/overview/restart_page.cpp"/>
        <source>The restart was refused, nothing has moved: see the alarms</source>
        <translation>Пуск с кадра отклонён, ничего не сдвинулось: см. аварии</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>The scope records other signals: «Axes of L%1» chooses the axes of a circle</source>
        <translation>Осциллограф пишет другие сигналы: «Оси L%1» выбирает оси окружности</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>The setup sheet is not written: stopped.</source>
        <translation>Карта наладки не записана: остановлено.</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>The simulation is being computed: %1 so far</source>
        <translation>Моделирование вычисляется: пока %1</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>The spindle turns: press again</source>
        <translation>Шпиндель начнёт вращаться: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>The turret turns: press again</source>
        <translation>Револьвер повернётся: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Then</source>
        <translation>Станет</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>There are no dimensions yet: «New dimension».</source>
        <translation>Размеров ещё нет: «Новый размер».</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>There are no tools yet: «New tool» on the page of tool data.</source>
        <translation>Инструментов ещё нет: «Новый инструмент» на странице данных.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There are no users: everybody may do everything. The first one must be a maker.</source>
        <translation>Пользователей нет: всем можно всё. Первым должен быть изготовитель.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There is no backup beside the store: choose one from a stick or the network.</source>
        <translation>Рядом с хранилищем копии нет: выберите её на флешке или в сети.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>There is no backup in this folder.</source>
        <translation>В этой папке нет копий.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>There is no block N%1 in this program yet.</source>
        <translation>Кадра N%1 в этой программе ещё нет.</translation>
    </message>
    <message>
        <location filename="../machine/live/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Нет соединения с УЧПУ.</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>There is no field of text here</source>
        <translation>Здесь нет текстового поля</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>There is no time zone %1</source>
        <translation>Нет часового пояса %1</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>They are the same</source>
        <translation>Они одинаковы</translation>
    </message>
    <message>
        <location filename="../screens/programs/compare_page.cpp"/>
        <source>They are very different</source>
        <translation>Они совсем разные</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>This channel has no offsets.</source>
        <translation>У этого канала нет корректоров.</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>This channel has no tools: enter them on the page of tools.</source>
        <translation>У этого канала нет инструментов: введите их на странице инструментов.</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>This channel has no turret.</source>
        <translation>У канала нет револьвера.</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This computer has no %1</source>
        <translation>На этом компьютере нет %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This computer runs without systemd</source>
        <translation>Этот компьютер работает без systemd</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>This folder cannot be read.</source>
        <translation>Эта папка не читается.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>This folder is empty.</source>
        <translation>Папка пуста.</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>This is here</source>
        <translation>Здесь это</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>This is no number.</source>
        <translation>Это не число.</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>This language has no cycles.</source>
        <translation>В этом языке нет циклов.</translation>
    </message>
    <message>
        <location filename="../widgets/pictures/magazine.cpp"/>
        <source>This machine has no magazine: PT_TURRET_MAGAZINE and N2905 to N2922 describe it.</source>
        <translation>У этого станка нет магазина: его описывают PT_TURRET_MAGAZINE и N2905 до N2922.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>This machine has no pallets (N3300).</source>
        <translation>У этого станка нет паллет (N3300).</translation>
    </message>
    <message>
        <location filename="../screens/machine/settings_page.cpp"/>
        <source>This needs the level of a setter: log in</source>
        <translation>Нужен уровень наладчика: войдите</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>This system knows no WINS: names come from the name servers</source>
        <translation>WINS не поддерживается, имена определяет DNS</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, one pass</source>
        <translation>Резьба вдоль Z, один проход</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, the lead grows</source>
        <translation>Резьба вдоль Z, шаг растёт</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread along Z, the lead shrinks</source>
        <translation>Резьба вдоль Z, шаг убывает</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Thread in several passes</source>
        <translation>Резьба за несколько проходов</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Thread in the face</source>
        <translation>Резьба на торце</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, one pass</source>
        <translation>Резьба на торце, один проход</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, the lead grows</source>
        <translation>Резьба на торце, шаг растёт</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/sinumerik_forms.cpp"/>
        <source>Thread in the face, the lead shrinks</source>
        <translation>Резьба на торце, шаг убывает</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Thread, one pass</source>
        <translation>Резьба, один проход</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Three Dimensional Compensation</source>
        <translation>Объёмная коррекция</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time before a key repeats</source>
        <translation>Задержка повтора</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time from the network</source>
        <translation>Время из сети</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Time left</source>
        <translation>Ещё времени</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Time zone</source>
        <translation>Часовой пояс</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Timeline</source>
        <translation>Временная шкала</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Timers and counters</source>
        <translation>Таймеры и счётчики</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Timers, counters</source>
        <translation>Таймеры</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Timers/Counters</source>
        <translation>Таймеры и счётчики</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Tip</source>
        <translation>Вершина</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Tip is at this measure: press again</source>
        <translation>Вершина на размере: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>To be replaced</source>
        <translation>К замене</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>To go</source>
        <translation>Остаток</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>To load: choose a tool without a place in the list</source>
        <translation>Для загрузки выберите в списке инструмент без места</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>To the backups</source>
        <translation>К резервным копиям</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>To the offsets</source>
        <translation>К корректорам</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>To the start: 0 not, 1 feed, 2 rapid</source>
        <translation>К началу: 0 нет, 1 подача, 2 ускор.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Too large: at most %1.</source>
        <translation>Слишком много: не больше %1.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Too small: at least %1.</source>
        <translation>Слишком мало: не меньше %1.</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Tool</source>
        <translation>Инструмент</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Tool %1 is new: enter what it is</source>
        <translation>Инструмент %1 новый: введите данные</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Compensation</source>
        <translation>Коррекция инструмента</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Holder Interference</source>
        <translation>Защита суппортов</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Tool Management</source>
        <translation>Учёт инструмента</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>Tool data</source>
        <translation>Данные</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Tool edges</source>
        <translation>Кромки</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Tool life (0: not monitored)</source>
        <translation>Ресурс (0: без учёта)</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Tool number</source>
        <translation>Номер инструмента</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Tool offsets</source>
        <translation>Корректоры</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Tool setter</source>
        <translation>Датчик инструмента</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Tool unit, 0 all</source>
        <translation>Инструментальный узел, 0 все</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.hpp"/>
        <source>Tools</source>
        <translation>Инструменты</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Torque</source>
        <translation>Момент</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Touch again or Enter: enlarged</source>
        <translation>Ещё касание или Enter: крупно</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Touch the bit again: it is turned over</source>
        <translation>Коснитесь бита ещё раз: он переключится</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Touch, or Enter: a text</source>
        <translation>Касание или Enter: текст</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Touches and keys do nothing. Unlocks by itself in %1 s, at once when an alarm comes.</source>
        <translation>Касания и клавиши не действуют. Разблокируется само через %1 с, при аварии — сразу.</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trace off</source>
        <translation>Сигнал выкл</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Travel of L%1</source>
        <translation>Ход L%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger downwards</source>
        <translation>Запуск по спаду</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger level</source>
        <translation>Уровень запуска</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Trigger upwards</source>
        <translation>Запуск по росту</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Triggered</source>
        <translation>Сработал</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>Turning Cycles</source>
        <translation>Токарные циклы</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Turning a straight section</source>
        <translation>Точение прямого участка</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Turning an arc</source>
        <translation>Точение дуги</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Turning, one pass</source>
        <translation>Точение, один проход</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>Turret L%1</source>
        <translation>Револьвер L%1</translation>
    </message>
    <message>
        <location filename="../machine/tools/edge_words.cpp"/>
        <source>Type</source>
        <translation>Тип</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type a number or touch it, then Input.</source>
        <translation>Наберите число или коснитесь его, затем «Ввод».</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Type a part of the name</source>
        <translation>Введите часть имени</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type number: the T that calls it</source>
        <translation>Номер типа (T для вызова)</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Type, then Enter.</source>
        <translation>Наберите, затем Enter.</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>USB</source>
        <translation>USB</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>USB sticks and network places appear when they are there. «Keep as place» adds the folder that is shown; /etc/polyturn/places names those of the shop: NAME=/FOLDER.</source>
        <translation>USB и сетевые папки появляются, когда они подключены. «Запомнить папку» добавляет показанную папку; папки цеха записаны в /etc/polyturn/places: ИМЯ=/ПАПКА.</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>Undo</source>
        <translation>Отменить</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Undo zeros, offsets</source>
        <translation>Вернуть нули, корректоры</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>Unit</source>
        <translation>Единица</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_requests.cpp"/>
        <source>Unload</source>
        <translation>Извлечь</translation>
    </message>
    <message>
        <location filename="../app/cleaning_lock.cpp"/>
        <source>Unlock</source>
        <translation>Разблокировать</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Unsaved text goes: press again</source>
        <translation>Несохранённое пропадёт: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Up</source>
        <translation>Вверх</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Upper</source>
        <translation>Верхн.</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Used up</source>
        <translation>Израсходовано</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>User</source>
        <translation>Пользователь</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Users</source>
        <translation>Пользователи</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>V</source>
        <translation>В</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Values and files that would change: %1</source>
        <translation>Изменится значений и файлов: %1</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Variable</source>
        <translation>Переменная</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis.cpp"/>
        <source>Variables</source>
        <translation>Переменные</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Waiting</source>
        <translation>Ожидание</translation>
    </message>
    <message>
        <location filename="../screens/overview/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Ожидание УЧПУ</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Ждёт</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits at %1 for %2, %3 so far</source>
        <translation>Ждёт канал %2 на %1, %3</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Ждёт на %1, все на месте</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Waits for a channel</source>
        <translation>Ждёт канал</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Waits for the trigger</source>
        <translation>Ждёт запуска</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>Waits ignored</source>
        <translation>Ожидания не действуют</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Wanted</source>
        <translation>Нужно</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fagor_forms.cpp"/>
        <source>Way back after each peck</source>
        <translation>Отвод после каждого шага</translation>
    </message>
    <message>
        <location filename="../../ipc/model/languages/fanuc_forms.cpp"/>
        <source>Way back or clearance of a peck</source>
        <translation>Отвод или зазор шага</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Wear</source>
        <translation>Износ</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>Wear %1: press again</source>
        <translation>Износ %1: ещё раз</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Wear R</source>
        <translation>Износ R</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Weight</source>
        <translation>Масса</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>What</source>
        <translation>Что</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>What is lost stays lost: press again</source>
        <translation>Потерянного не вернуть: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>What it does</source>
        <translation>Что делает</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>What was told before stands in «History», what the machine stood still for in «Log of stops».</source>
        <translation>Что было раньше, смотрите в «Журнале»; почему станок стоял — в «Журнале остановов».</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>What would change</source>
        <translation>Что изменится</translation>
    </message>
    <message>
        <location filename="../screens/overview/manual.cpp"/>
        <source>Wheel, tool, transfer</source>
        <translation>Маховичок, инструмент</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>When</source>
        <translation>Когда</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Who</source>
        <translation>Кто</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Who has changed this value</source>
        <translation>Кто менял это значение</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>Whole machine</source>
        <translation>Весь станок</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>Window %1 s</source>
        <translation>Окно %1 с</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Without a display server the keyboard itself decides</source>
        <translation>Без сервера дисплея решает сама клавиатура</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Without a probe offset: press again</source>
        <translation>Без корректора щупа: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>Without effect:</source>
        <translation>Не действует:</translation>
    </message>
    <message>
        <location filename="../machine/tools/offset_table.cpp"/>
        <source>Without tool management (N2900) programs bring their own tools and edges.</source>
        <translation>Без управления инструментами (N2900) инструменты и кромки задаёт сама программа.</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>Word</source>
        <translation>Слово</translation>
    </message>
    <message>
        <location filename="../machine/live/stop_log.cpp"/>
        <source>Work by hand</source>
        <translation>Работа вручную</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>Work moved from L%1 to L%2 saves up to %3 s.</source>
        <translation>Работа, перенесённая из L%1 в L%2, сэкономит до %3 с.</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>Work shift</source>
        <translation>Сдвиг</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets.cpp"/>
        <source>Work zeros</source>
        <translation>Нули детали</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>Working area</source>
        <translation>Рабочая зона</translation>
    </message>
    <message>
        <location filename="../app/dialogue_view.cpp"/>
        <source>Workpiece</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Workpiece setter</source>
        <translation>Щуп детали</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Works</source>
        <translation>Работает</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>Worn</source>
        <translation>Изношен</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Would be entered</source>
        <translation>Будет введено</translation>
    </message>
    <message>
        <location filename="../screens/programs/contour_page.cpp"/>
        <source>Write into the program</source>
        <translation>Записать в программу</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Writes the offset: press again</source>
        <translation>Запишет корректор: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>Written</source>
        <translation>Записано</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>Written as %1</source>
        <translation>Пишется так: %1</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>X of its end, radius</source>
        <translation>X торца калибра (радиус)</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>Z of its end</source>
        <translation>Z торца калибра</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Zero</source>
        <translation>Нуль</translation>
    </message>
    <message>
        <location filename="../screens/tools/offsets_keys.cpp"/>
        <source>Zero here</source>
        <translation>Нуль здесь</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>Zeros</source>
        <translation>Нули</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Zeros and offsets of %1 are entered</source>
        <translation>Нули и корректоры из %1 введены</translation>
    </message>
    <message>
        <location filename="../screens/programs/programs.cpp"/>
        <source>Zeros and offsets stand as before</source>
        <translation>Нули и корректоры как прежде</translation>
    </message>
    <message>
        <location filename="../machine/live/channel_words.cpp"/>
        <source>a marker</source>
        <translation>метки</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>a program is interrupted</source>
        <translation>программа прервана</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>all parameters</source>
        <translation>все параметры</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>авария всё остановила</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>авария канала не снята</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>ось перемещают вручную</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>angle</source>
        <translation>угол</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>another tool: %1</source>
        <translation>другой инструмент: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>arm S%1</source>
        <translation>манипулятор S%1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>подключите её (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>оси идут в реф. точки</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>оси отведены при удержании</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>axis no.</source>
        <translation>№ оси</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>bits</source>
        <translation>бит</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>blocks</source>
        <translation>кадров</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>bore</source>
        <translation>отверстие</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>поставьте инструмент</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>доведите её до конца</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>button tool</source>
        <translation>круглый резец</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>cell no.</source>
        <translation>№ ячейки</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>character code</source>
        <translation>код символа</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>выберите автомат или РВД</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>chuck holds</source>
        <translation>патрон зажат</translation>
    </message>
    <message>
        <location filename="../screens/overview/hand_page.cpp"/>
        <source>chuck open</source>
        <translation>патрон разжат</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>закройте его, проверьте давление</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>закройте её или включите режим наладки</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>column no.</source>
        <translation>№ столбца</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>columns</source>
        <translation>столбцов</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>commanded</source>
        <translation>заданное</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>commanded speed</source>
        <translation>заданные обороты</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>compensation</source>
        <translation>компенсация</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>count</source>
        <translation>шт.</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>counts</source>
        <translation>импульсов</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>decimals</source>
        <translation>знаков</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg</source>
        <translation>°</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/min</source>
        <translation>°/мин</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/rev</source>
        <translation>°/об</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/s</source>
        <translation>°/с</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>deg/s2</source>
        <translation>°/с²</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>detached</source>
        <translation>отключена</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>deviation</source>
        <translation>отклонение</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>drill</source>
        <translation>сверло</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools.cpp"/>
        <source>empty</source>
        <translation>пусто</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>enter one, or choose auto</source>
        <translation>введите его или выберите автомат</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>entered</source>
        <translation>введено</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>entered: %1</source>
        <translation>введено: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>всё остановлено аварией</translation>
    </message>
    <message>
        <location filename="../screens/programs/cycle_form_page.cpp"/>
        <source>feed</source>
        <translation>подача</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>file</source>
        <translation>файл</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>files: %1</source>
        <translation>файлов: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>долейте масло</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>finishing tool</source>
        <translation>чистовой резец</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>following error</source>
        <translation>рассогласование</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>follows S%1</source>
        <translation>следует за S%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>follows it synchronously</source>
        <translation>следует за ней синхронно</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ft/min</source>
        <translation>фут/мин</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>good</source>
        <translation>годен</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>grinding wheel</source>
        <translation>шлифовальный круг</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>grooving tool</source>
        <translation>канавочный резец</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>h</source>
        <translation>ч</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics_picture.cpp"/>
        <source>held by protection</source>
        <translation>удержано защитой</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch</source>
        <translation>дюйм</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>inch, diameter</source>
        <translation>дюйм, диаметр</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>inch, radius</source>
        <translation>дюйм, радиус</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/min</source>
        <translation>дюйм/мин</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/rev</source>
        <translation>дюйм/об</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>inch/s2</source>
        <translation>дюйм/с²</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>input %1</source>
        <translation>вход %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>input no.</source>
        <translation>№ входа</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>it is not there</source>
        <translation>её нет</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>its travel is added to the axis' own</source>
        <translation>её путь добавляется к своему</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>kB</source>
        <translation>кБ</translation>
    </message>
    <message>
        <location filename="../machine/live/alarm_log.cpp"/>
        <source>line</source>
        <translation>строка</translation>
    </message>
    <message>
        <location filename="../screens/programs/editor_page.cpp"/>
        <source>line %1, column %2</source>
        <translation>строка %1, столбец %2</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>load a new one</source>
        <translation>загрузите новый</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>longest below %1 of a tick of %2</source>
        <translation>самый долгий: до %1 (такт %2)</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>m/min</source>
        <translation>м/мин</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>maker</source>
        <translation>изготовитель</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>measured</source>
        <translation>измеренное</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>metres of cutting</source>
        <translation>метры резания</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>milling tool</source>
        <translation>фреза</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>min</source>
        <translation>мин</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>minutes of cutting</source>
        <translation>минуты резания</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm</source>
        <translation>мм</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>mm, diameter</source>
        <translation>мм, диаметр</translation>
    </message>
    <message>
        <location filename="../machine/live/lengths.cpp"/>
        <source>mm, radius</source>
        <translation>мм, радиус</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>mm/K</source>
        <translation>мм/К</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/min</source>
        <translation>мм/мин</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/rev</source>
        <translation>мм/об</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/s</source>
        <translation>мм/с</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/s2</source>
        <translation>мм/с²</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>mm/s3</source>
        <translation>мм/с³</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>more: %1</source>
        <translation>ещё: %1</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>mounted</source>
        <translation>установлен</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>moves its drive: the axes are exchanged</source>
        <translation>движет её приводом: оси обменены</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>ms</source>
        <translation>мс</translation>
    </message>
    <message>
        <location filename="../screens/programs/job_views.cpp"/>
        <source>never comes: %1</source>
        <translation>не придёт: %1</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>no</source>
        <translation>нет</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no block is entered</source>
        <translation>кадр не введён</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>no offset, no tool</source>
        <translation>нет корректора</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>no program</source>
        <translation>нет программы</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no program is selected</source>
        <translation>программа не выбрана</translation>
    </message>
    <message>
        <location filename="../machine/live/axis_places.cpp"/>
        <source>no ref.</source>
        <translation>нет реф.</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>нет инструмента, револьвер не зажат</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>нет инструмента</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>nobody</source>
        <translation>никто</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>not a number yet</source>
        <translation>ещё не число</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>не все оси в реф. точке</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>not all channels of the restart are at their blocks</source>
        <translation>не все каналы пуска с кадра стоят у своих кадров</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>not entered</source>
        <translation>не введено</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>not measured</source>
        <translation>не измерен</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>not monitored</source>
        <translation>без учёта</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>not referenced</source>
        <translation>нет реф. точки</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>not this one</source>
        <translation>не этот</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>nothing</source>
        <translation>ничего</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>off</source>
        <translation>выкл</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>offset no.</source>
        <translation>№ корректора</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>only makers</source>
        <translation>только изготовитель</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>only setters</source>
        <translation>только наладчик</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>operator</source>
        <translation>оператор</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>other name: %1</source>
        <translation>другое имя: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>pale: the rows beside it</source>
        <translation>бледно: соседние ряды</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>pale: the rows beside it; thin: before</source>
        <translation>бледно: соседние ряды; тонко: прежнее</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pallets</source>
        <translation>паллет</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>parting tool</source>
        <translation>отрезной резец</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>parts to the limit: %1</source>
        <translation>деталей до предела: %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>path left</source>
        <translation>остаток пути</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>path speed</source>
        <translation>скорость по контуру</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>pcs</source>
        <translation>шт</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>periods</source>
        <translation>периодов</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>pieces</source>
        <translation>детали</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>point %1, %2</source>
        <translation>точка %1, %2</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>point no.</source>
        <translation>№ точки</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pot no.</source>
        <translation>№ гнезда</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>pots</source>
        <translation>гнёзд</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>нажмите «Все оси: в реф. точку»</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>press reset</source>
        <translation>нажмите «сброс»</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>press return</source>
        <translation>нажмите «возврат»</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>probe</source>
        <translation>щуп</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>program no.</source>
        <translation>№ программы</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>programs run</source>
        <translation>программы выполняются</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>programs stand</source>
        <translation>программы стоят</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ratio</source>
        <translation>отношение</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>read-only</source>
        <translation>только чтение</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>records</source>
        <translation>записей</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>reference it</source>
        <translation>выведите её в реф. точку</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>отпустите его и включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>устраните причину и сбросьте</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>устраните причину, затем сброс</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>restore a backup, or let a maker confirm what is left</source>
        <translation>восстановите резервную копию или пусть изготовитель подтвердит остаток</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rev</source>
        <translation>об</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rev/s2</source>
        <translation>об/с²</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>roughing tool</source>
        <translation>черновой резец</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rows</source>
        <translation>рядов</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rpm</source>
        <translation>об/мин</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>rpm/s</source>
        <translation>об/мин/с</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>s</source>
        <translation>с</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>select one on the page of programs</source>
        <translation>выберите её на странице программ</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>setter</source>
        <translation>наладчик</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>since the start</source>
        <translation>с запуска</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>special tool</source>
        <translation>спецрезец</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>speed</source>
        <translation>обороты</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>spindle no.</source>
        <translation>№ шпинделя</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>stations</source>
        <translation>станций</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>switch it on</source>
        <translation>включите его</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect after a restart of the controller</source>
        <translation>действует после перезапуска УЧПУ</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect at once</source>
        <translation>действует сразу</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>takes effect at the next preprocessing stop</source>
        <translation>действует с останова подготовки кадров</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>пруток закончился</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>нет процесса канала</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>патрон не держит</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the door is open</source>
        <translation>дверь открыта</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>аварийный останов активен</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>нет смазки</translation>
    </message>
    <message>
        <location filename="../screens/machine/alarms.cpp"/>
        <source>the machine</source>
        <translation>станок</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>the machine does not have it</source>
        <translation>у станка такого нет</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>станок не включён</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>станок выключен</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>станок готов</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>режим ручных перемещений</translation>
    </message>
    <message>
        <location filename="../machine/programs/setup_sheet.cpp"/>
        <source>the place is empty</source>
        <translation>место пусто</translation>
    </message>
    <message>
        <location filename="../screens/graphics/graphics.cpp"/>
        <source>the program takes no time</source>
        <translation>программа не занимает времени</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>сброс не закончен</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the store has lost data: no production</source>
        <translation>хранилище потеряло данные: работы нет</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>хранилище не работает: ничего не сохранится</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>задняя бабка ни отведена, ни прижата</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>the time of a tick</source>
        <translation>время такта</translation>
    </message>
    <message>
        <location filename="../screens/machine/compensation_page.cpp"/>
        <source>thin: before</source>
        <translation>тонко: прежнее</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>threading tool</source>
        <translation>резьбовой резец</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>ticks</source>
        <translation>тактов</translation>
    </message>
    <message>
        <location filename="../screens/overview/channel_card.cpp"/>
        <source>tip</source>
        <translation>вершина</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>too large</source>
        <translation>выше допуска</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>too small</source>
        <translation>ниже допуска</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>tool %1</source>
        <translation>инструмент %1</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>torque</source>
        <translation>момент</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>отпустите кнопку, затем включите станок</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>turning drill</source>
        <translation>токарное сверло</translation>
    </message>
    <message>
        <location filename="../machine/live/axis_places.cpp"/>
        <source>turns as spindle S%1</source>
        <translation>вращается как шпиндель S%1</translation>
    </message>
    <message>
        <location filename="../screens/machine/diagnosis_tables.cpp"/>
        <source>turns with it, deviation %1°</source>
        <translation>вращается синхронно, отклонение %1°</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>us</source>
        <translation>мкс</translation>
    </message>
    <message>
        <location filename="../machine/tools/tool_words.cpp"/>
        <source>uses</source>
        <translation>вызовов</translation>
    </message>
    <message>
        <location filename="../screens/machine/parameters.cpp"/>
        <source>values: %1</source>
        <translation>значений: %1</translation>
    </message>
    <message>
        <location filename="../../ipc/params/parameters.csv"/>
        <source>variable no.</source>
        <translation>№ переменной</translation>
    </message>
    <message>
        <location filename="../screens/machine/scope_page.cpp"/>
        <source>velocity</source>
        <translation>скорость</translation>
    </message>
    <message>
        <location filename="../../ipc/model/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>подождите</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait for them; if it was refused, restart again or reset</source>
        <translation>подождите их; если он отклонён, пустите снова или сбросьте</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>подождите его запуска, затем сброс</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>подождите её остановки</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>подождите его запуска</translation>
    </message>
    <message>
        <location filename="../../ipc/requests/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>подождите остановки осей</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>wanted: a whole number</source>
        <translation>нужно целое число</translation>
    </message>
    <message>
        <location filename="../screens/tools/tools_tables.cpp"/>
        <source>wear</source>
        <translation>износ</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>wear of L%1 T%2 D%3</source>
        <translation>износ L%1, T%2 D%3</translation>
    </message>
    <message>
        <location filename="../screens/tools/parts_page.cpp"/>
        <source>wear of L%1 offset %2</source>
        <translation>износ L%1, корр. %2</translation>
    </message>
    <message>
        <location filename="../machine/tools/computer_settings.cpp"/>
        <source>yes</source>
        <translation>да</translation>
    </message>
    <message>
        <location filename="../screens/programs/files_page.cpp"/>
        <source>«Mark» chooses what is copied or compared</source>
        <translation>«Отметить» выбирает, что копировать или сравнить</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>«Measure» finds the tip and shows what would be entered. Camera calibrated: %1.</source>
        <translation>«Измерить» находит вершину и показывает, что будет введено. Камера откалибрована: %1.</translation>
    </message>
    <message>
        <location filename="../screens/tools/presetter_page.cpp"/>
        <source>«Measure» finds the tip and shows what would be entered. The gauge pin calibrates the camera first.</source>
        <translation>«Измерить» находит вершину и показывает, что будет введено. Сначала откалибруйте камеру по калибру.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>«Restore» brings everything back as it was then. The file cannot be read whole: «Confirm the loss» may leave parameters, offsets, zeros, tools and users as on the first day. Look through them before the first part.</source>
        <translation>«Восстановить» вернёт всё, как было тогда. Файл не читается целиком: после «Признать потерю» параметры, корректоры, нули, инструменты и пользователи могут стать как в первый день. Проверьте их до первой детали.</translation>
    </message>
    <message>
        <location filename="../screens/machine/system.cpp"/>
        <source>«Restore» brings everything back as it was then. «Confirm the loss» keeps what is left: the newest changes of parameters, offsets, zeros, tools, lives and users are gone for good. Look through them before the first part.</source>
        <translation>«Восстановить» вернёт всё, как было тогда. «Признать потерю» оставит то, что есть: последние изменения параметров, корректоров, нулей, инструментов, их стойкости и пользователей пропали навсегда. Проверьте их до первой детали.</translation>
    </message>
    <message>
        <location filename="../text/display_languages.cpp"/>
        <source>µm</source>
        <translation>мкм</translation>
    </message>
</context>
</TS>
