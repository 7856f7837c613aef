<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ru_RU" sourcelanguage="en">
<context>
    <name>hmi</name>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>%1 in all</source>
        <translation>всего %1</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>%1 is selected in L%2</source>
        <translation>%1 выбрана в L%2</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>%1 is selected in its channels</source>
        <translation>%1 выбрано в своих каналах</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>%1 s after the start of the controller</source>
        <translation>через %1 с после запуска УЧПУ</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>+ Input</source>
        <translation>+ Ввод</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>A block by hand (MDI)</source>
        <translation>Кадр вручную (РВД)</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>A start needs:</source>
        <translation>Для пуска нужно:</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>A text: it is changed by polyturn params set</source>
        <translation>Текст: меняется командой polyturn params set</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Absent</source>
        <translation>Нет</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Active at the next T</source>
        <translation>Со следующего T</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Active from the next blocks</source>
        <translation>Со следующих кадров</translation>
    </message>
    <message>
        <location filename="../screens/alarms.hpp"/>
        <source>Alarms</source>
        <translation>Аварии</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>All</source>
        <translation>Всё</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>All groups</source>
        <translation>Все группы</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>All zeros together</source>
        <translation>Все нули вместе</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Applied now</source>
        <translation>Действует сейчас</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>As held</source>
        <translation>Пока нажата</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Automatic</source>
        <translation>Автомат</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axes</source>
        <translation>Оси</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axes and drives</source>
        <translation>Оси и приводы</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Axis</source>
        <translation>Ось</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Block skip</source>
        <translation>Пропуск кадров</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Changed</source>
        <translation>Изменён</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Changed only</source>
        <translation>Только изменённые</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Changes since the start of these screens</source>
        <translation>Изменения с запуска экранов</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Channel</source>
        <translation>Канал</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Check, waits</source>
        <translation>Проверка, ожидания</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>Choose a field</source>
        <translation>Выберите поле</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Choose a job or a program</source>
        <translation>Выберите задание или программу</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Clear</source>
        <translation>Очистить</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Clear search</source>
        <translation>Очистить поиск</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Commanded</source>
        <translation>Задано</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Compensation</source>
        <translation>Компенсация</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Computing time of ticks</source>
        <translation>Время счёта тактов</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Couplings</source>
        <translation>Связи</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Couplings and exchanges</source>
        <translation>Связи и обмен осей</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Cutting</source>
        <translation>Резание</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Cycle</source>
        <translation>Цикл</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Dark</source>
        <translation>Тёмная</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Default</source>
        <translation>По умолчанию</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Default value</source>
        <translation>По умолчанию</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Depends on</source>
        <translation>Зависит от</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Drive fault</source>
        <translation>Авария привода</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Dry run</source>
        <translation>Пробный прогон</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Dry run, timeline</source>
        <translation>Прогон, шкала</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Dwell</source>
        <translation>Пауза</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Emergency stop</source>
        <translation>Аварийный стоп</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>End with this part</source>
        <translation>Конец с этой деталью</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Ended</source>
        <translation>Завершён</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Ends all programs: press again</source>
        <translation>Прервёт все: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Ends the program: press again</source>
        <translation>Прервёт программу: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Every axis and spindle is on its own: nothing is coupled, exchanged or followed.</source>
        <translation>Каждая ось и шпиндель сами по себе: нет связей, обмена и слежения.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>External</source>
        <translation>Внешний</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Feed</source>
        <translation>Подача</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Feed hold: start goes on</source>
        <translation>Стоп подачи: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Files</source>
        <translation>Файлы</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>First part</source>
        <translation>Первая деталь</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>First part: start goes on with this tool</source>
        <translation>Первая деталь: пуск продолжит этим инструментом</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Follow. error</source>
        <translation>Рассогл.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>From</source>
        <translation>От</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Geom.</source>
        <translation>Геом.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Geometry + wear</source>
        <translation>Геометрия + износ</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Graphics</source>
        <translation>Графика</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Handwheel</source>
        <translation>Маховичок</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Held</source>
        <translation>Удержан</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>History</source>
        <translation>Журнал</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Hold %1</source>
        <translation>Стоп подачи %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Hold all</source>
        <translation>Стоп подачи всех</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>How</source>
        <translation>Как</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>In position</source>
        <translation>В позиции</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Input</source>
        <translation>Ввод</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Interrupted</source>
        <translation>Прерван</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>It cannot be shown.</source>
        <translation>Показать нельзя.</translation>
    </message>
    <message>
        <location filename="../machine/dry_run.cpp"/>
        <source>It gave no result.</source>
        <translation>Результата нет.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Jog</source>
        <translation>Ручной</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Larger</source>
        <translation>Крупнее</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Last</source>
        <translation>Прошлый</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Leave the hold %1</source>
        <translation>Отвод %1</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Level</source>
        <translation>Уровень</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Light</source>
        <translation>Светлая</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Lock</source>
        <translation>Замок</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Locked for cleaning</source>
        <translation>Заблокировано для протирки</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Longest wait: L%1 stands %2 s at M%3 (line %4). Work moved from the channel that comes last to L%1 saves up to this time.</source>
        <translation>Самое долгое ожидание: L%1 стоит %2 с на M%3 (строка %4). Работа, переданная от опоздавшего канала каналу L%1, сбережёт до этого времени.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>Look whether the controller runs; try again.</source>
        <translation>Проверьте, работает ли УЧПУ; повторите.</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>MDI</source>
        <translation>РВД</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine</source>
        <translation>Станок</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Machine lock</source>
        <translation>Блокировка осей</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Machine on</source>
        <translation>Станок вкл.</translation>
    </message>
    <message>
        <location filename="../screens/manual.hpp"/>
        <source>Manual</source>
        <translation>Вручную</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Mean</source>
        <translation>Средний</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Meaning</source>
        <translation>Значение (смысл)</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Measured</source>
        <translation>Измерено</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Message</source>
        <translation>Сообщение</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Moves</source>
        <translation>Движется</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Name</source>
        <translation>Имя</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>No alarm stands.</source>
        <translation>Активных аварий нет.</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>No controller answers</source>
        <translation>Нет связи с УЧПУ</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>No faults found</source>
        <translation>Ошибок нет</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>No job names the stock of the running program</source>
        <translation>Ни одно задание не называет заготовку программы</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>No parameter has this in its number, name or meaning.</source>
        <translation>Нет параметра с таким номером, именем или смыслом.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>No signal has this in its name or meaning.</source>
        <translation>Нет сигнала с таким именем или смыслом.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>No.</source>
        <translation>№</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>None is known.</source>
        <translation>Неизвестно.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Not in position</source>
        <translation>Не в позиции</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Not in use by the running program</source>
        <translation>Программой не используется</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Nothing has been told since the controller started.</source>
        <translation>С запуска УЧПУ сообщений не было.</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Nothing is missing</source>
        <translation>Всё готово</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Number</source>
        <translation>Номер</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Offset</source>
        <translation>Корректор</translation>
    </message>
    <message>
        <location filename="../screens/offsets.hpp"/>
        <source>Offsets</source>
        <translation>Коррекции</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Open folder</source>
        <translation>Открыть папку</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Optional stop</source>
        <translation>Останов M1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Optional stop %1</source>
        <translation>Останов M1 %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Optional stop M1: start goes on</source>
        <translation>Останов M1: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Overrides</source>
        <translation>Коррекции</translation>
    </message>
    <message>
        <location filename="../screens/overview.hpp"/>
        <source>Overview</source>
        <translation>Обзор</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Parameters</source>
        <translation>Параметры</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Parts</source>
        <translation>Детали</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Place</source>
        <translation>Место</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Process</source>
        <translation>Процесс</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Process dead</source>
        <translation>Процесс погиб</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Processes</source>
        <translation>Процессы</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Processes and ticks</source>
        <translation>Процессы и такты</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Programmed stop M0: start goes on</source>
        <translation>Останов M0: пуск продолжит</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Programs</source>
        <translation>Программы</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Programs and jobs</source>
        <translation>Программы и задания</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Radius</source>
        <translation>Радиус</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Range</source>
        <translation>Диапазон</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Rapid</source>
        <translation>Быстро</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Read again</source>
        <translation>Перечитать</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reference</source>
        <translation>Выход в 0</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Reference all</source>
        <translation>Все в ноль</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Remaining</source>
        <translation>Осталось</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Remedy</source>
        <translation>Что делать</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Reset</source>
        <translation>Сброс</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Reset %1</source>
        <translation>Сброс %1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Reset L%1</source>
        <translation>Сброс L%1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Reset all</source>
        <translation>Сброс всех</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Restart: start makes the approach</source>
        <translation>Возобновление: пуск выполнит подвод</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Retrace has come to its end</source>
        <translation>Возврат по траектории дошёл до конца</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Return %1</source>
        <translation>Возврат %1</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Runs</source>
        <translation>Работает</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Search</source>
        <translation>Поиск</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Search: number, name or meaning</source>
        <translation>Поиск: номер, имя или смысл</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Select in L%1</source>
        <translation>Выбрать в L%1</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Select job</source>
        <translation>Выбрать задание</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Sets the default: press again</source>
        <translation>Задаст исходное: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Sets the zero: press again</source>
        <translation>Задаст нуль: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signal</source>
        <translation>Сигнал</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signals</source>
        <translation>Сигналы</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Signals of NC and PLC</source>
        <translation>Сигналы ЧПУ и ПЛК</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Since the start of these screens; tips as points, without width and radius</source>
        <translation>С запуска экранов; вершины как точки, без ширины и радиуса</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Single block</source>
        <translation>Покадрово</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block %1</source>
        <translation>Покадрово %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Single block all</source>
        <translation>Покадрово все</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Single block: start does the next one</source>
        <translation>Покадрово: пуск выполнит следующий кадр</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Size</source>
        <translation>Размер</translation>
    </message>
    <message>
        <location filename="../screens/graphics.cpp"/>
        <source>Smaller</source>
        <translation>Мельче</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Spindle</source>
        <translation>Шпиндель</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Start %1</source>
        <translation>Пуск %1</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Start all</source>
        <translation>Пуск всех</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Starts</source>
        <translation>Запускается</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Starts all channels: press again</source>
        <translation>Пуск всех каналов: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>State</source>
        <translation>Состояние</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Stock</source>
        <translation>Заготовка</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Stopped</source>
        <translation>Остановлен</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Synchronised view</source>
        <translation>Синхронный вид</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Text</source>
        <translation>Текст</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller gave no answer.</source>
        <translation>УЧПУ не ответило.</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>The controller refused.</source>
        <translation>УЧПУ отказало.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>The job is being driven in virtual time</source>
        <translation>Задание идёт в виртуальном времени</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>The machine works with it</source>
        <translation>Станок работает с ним</translation>
    </message>
    <message>
        <location filename="../machine/dry_run.cpp"/>
        <source>The program polyturn is not beside the HMI.</source>
        <translation>Программы polyturn нет рядом с HMI.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>The programs are being read</source>
        <translation>Программы читаются</translation>
    </message>
    <message>
        <location filename="../machine/requests.cpp"/>
        <source>There is no connection to the controller.</source>
        <translation>Нет соединения с УЧПУ.</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>This folder is empty.</source>
        <translation>Папка пуста.</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>This is here</source>
        <translation>Здесь это</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Time</source>
        <translation>Время</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Timeline</source>
        <translation>Временная шкала</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tip</source>
        <translation>Вершина</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tip is at this measure: press again</source>
        <translation>Вершина на размере: ещё раз</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>To go</source>
        <translation>Остаток</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Tool offsets</source>
        <translation>Корректоры</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Tools that it needs</source>
        <translation>Нужные инструменты</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Torque</source>
        <translation>Момент</translation>
    </message>
    <message>
        <location filename="../screens/manual.cpp"/>
        <source>Touch the line, type, Enter starts it</source>
        <translation>Коснитесь строки, введите, Enter запустит</translation>
    </message>
    <message>
        <location filename="../app/main_window.cpp"/>
        <source>Touches and keys do nothing. The machine goes on.</source>
        <translation>Касания и клавиши не действуют. Станок работает.</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Type a part of the name</source>
        <translation>Введите часть имени</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Undo</source>
        <translation>Отменить</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Unit</source>
        <translation>Единица</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>Up</source>
        <translation>Вверх</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>Value</source>
        <translation>Значение</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>Waiting</source>
        <translation>Ожидание</translation>
    </message>
    <message>
        <location filename="../screens/overview.cpp"/>
        <source>Waiting for the controller</source>
        <translation>Ожидание УЧПУ</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits</source>
        <translation>Ждёт</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1 for %2, since %3</source>
        <translation>Ждёт на %1 канал %2, уже %3</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>Waits at %1, all are there</source>
        <translation>Ждёт на %1, все на месте</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Wear</source>
        <translation>Износ</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Wear R</source>
        <translation>Износ R</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>What</source>
        <translation>Что</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>What stands</source>
        <translation>Активные</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>Without effect:</source>
        <translation>Не действует:</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Work shift</source>
        <translation>Сдвиг</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Work zeros</source>
        <translation>Нули детали</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>Workpiece</source>
        <translation>Деталь</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Zero</source>
        <translation>Нуль</translation>
    </message>
    <message>
        <location filename="../screens/offsets.cpp"/>
        <source>Zero here</source>
        <translation>Нуль здесь</translation>
    </message>
    <message>
        <location filename="../machine/channel_words.cpp"/>
        <source>a marker</source>
        <translation>метке</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts after a restart of the controller</source>
        <translation>действует после перезапуска УЧПУ</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts at once</source>
        <translation>действует сразу</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>acts at the channel's next stop of reading</source>
        <translation>действует на следующей остановке чтения</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>an alarm has stopped everything</source>
        <translation>авария всё остановила</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an alarm of the channel stands</source>
        <translation>авария канала не снята</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>an axis is being moved by hand</source>
        <translation>ось перемещают вручную</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>attach it (AP_DETCHR)</source>
        <translation>присоедините её (AP_DETCHR)</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>axes are on their way to their reference points</source>
        <translation>оси идут в нулевые точки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>axes were moved in the hold</source>
        <translation>оси отведены при удержании</translation>
    </message>
    <message>
        <location filename="../screens/programs.cpp"/>
        <source>bore</source>
        <translation>отверстие</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring a tool into place</source>
        <translation>поставьте инструмент</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>bring it to its end</source>
        <translation>доведите её до конца</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>choose auto or mdi</source>
        <translation>выберите автомат или РВД</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, look at its pressure</source>
        <translation>закройте его, проверьте давление</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>close it, or switch to setup mode</source>
        <translation>закройте её или включите режим наладки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>detached</source>
        <translation>отсоединена</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>everything was stopped by an alarm</source>
        <translation>всё остановлено аварией</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>fill up its oil</source>
        <translation>долейте масло</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>follows it synchronously</source>
        <translation>следует за ней синхронно</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>its way is added to the own one</source>
        <translation>её путь добавляется к своему</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>line</source>
        <translation>строка</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>load a new one</source>
        <translation>загрузите новый</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>longest %1 of a tick of %2 µs</source>
        <translation>наибольшее %1 в такте %2 µs</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>maker</source>
        <translation>изготовитель</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>moves its drive: the axes are exchanged</source>
        <translation>движет её приводом: оси обменены</translation>
    </message>
    <message>
        <location filename="../screens/job_views.cpp"/>
        <source>never comes: %1</source>
        <translation>не придёт: %1</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no program</source>
        <translation>нет программы</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no ref.</source>
        <translation>нет нуля</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>no tool is in place, the turret is not locked</source>
        <translation>нет инструмента, револьвер не зажат</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>no tool known</source>
        <translation>нет инструмента</translation>
    </message>
    <message>
        <location filename="../widgets/number_pad.cpp"/>
        <source>not a number yet</source>
        <translation>ещё не число</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>not all axes are referenced</source>
        <translation>не все оси в нуле</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>not referenced</source>
        <translation>нет выхода в ноль</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>operator</source>
        <translation>оператор</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press machine on</source>
        <translation>включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>press reference all</source>
        <translation>нажмите «все в ноль»</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press reset</source>
        <translation>нажмите «сброс»</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>press return</source>
        <translation>нажмите «возврат»</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>reference it</source>
        <translation>выведите её в ноль</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>release it and switch the machine on</source>
        <translation>отпустите его и включите станок</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>remove its cause and reset</source>
        <translation>устраните причину и сбросьте</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>remove its cause, then press reset</source>
        <translation>устраните причину, затем сброс</translation>
    </message>
    <message>
        <location filename="../screens/parameters.cpp"/>
        <source>setter</source>
        <translation>наладчик</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>switch it on</source>
        <translation>включите его</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the bar is used up</source>
        <translation>пруток закончился</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the channel's process is not there</source>
        <translation>нет процесса канала</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the chuck does not hold</source>
        <translation>патрон не держит</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the door is open</source>
        <translation>дверь открыта</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the emergency stop is active</source>
        <translation>аварийный останов активен</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the lubrication is missing</source>
        <translation>нет смазки</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>the machine</source>
        <translation>станок</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the machine is not switched on</source>
        <translation>станок не включён</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is off</source>
        <translation>станок выключен</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>the machine is ready</source>
        <translation>станок готов</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the mode is for moving by hand</source>
        <translation>режим ручных перемещений</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the reset is not over</source>
        <translation>сброс не закончен</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the store is dead: nothing would be kept</source>
        <translation>хранилище не работает: ничего не сохранится</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>the tailstock is neither back nor does it hold</source>
        <translation>задняя бабка ни отведена, ни прижата</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>tip</source>
        <translation>вершина</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>turn the button back, then press machine on</source>
        <translation>отпустите кнопку, затем включите станок</translation>
    </message>
    <message>
        <location filename="../screens/channel_card.cpp"/>
        <source>turns as spindle S%1</source>
        <translation>вращается как шпиндель S%1</translation>
    </message>
    <message>
        <location filename="../screens/alarms.cpp"/>
        <source>turns with it, deviation %1°</source>
        <translation>вращается с ним, отклонение %1°</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/machine_step.hpp"/>
        <source>wait</source>
        <translation>подождите</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it is started again, then reset</source>
        <translation>подождите его запуска, затем сброс</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it rests</source>
        <translation>подождите её остановки</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until it runs again</source>
        <translation>подождите его запуска</translation>
    </message>
    <message>
        <location filename="../../ipc/machine/start_words.hpp"/>
        <source>wait until the axes rest</source>
        <translation>подождите остановки осей</translation>
    </message>
</context>
</TS>
