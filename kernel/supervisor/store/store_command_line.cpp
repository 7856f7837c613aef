#include "kernel/supervisor/store/store_command_line.hpp"

#include <CLI/CLI.hpp>

namespace polyturn::supervisor {

namespace {

struct Action {
    const char *group, *name, *text, *words;  // words: what follows it, for the help
    int least, most;                          // how many; -1 any number
};
constexpr Action kActions[] = {
    {"tools", "list", "The tool table", "", 0, 0},
    {"tools", "show", "Everything about one tool", "TOOL", 1, 1},
    {"tools", "fields", "The columns of the table, their units and limits", "", 0, 0},
    {"tools", "places", "All places of the magazines and what stands there", "", 0, 0},
    {"tools", "add", "A new tool: its data number (or the next free one) and columns",
     "[NUMBER] COLUMN=VALUE ...", 0, -1},
    {"tools", "set", "Columns of a tool; edges as D1.DP3=12.5", "TOOL COLUMN=VALUE ...", 2, -1},
    {"tools", "delete", "Takes a tool out of the table", "TOOL", 1, 1},
    {"tools", "load", "Into a place, or into the nearest free one", "TOOL [MAGAZINE [POT]]", 1, 3},
    {"tools", "move", "From its place to another", "TOOL [MAGAZINE [POT]]", 1, 3},
    {"tools", "unload", "Out of its place; it stays in the table", "TOOL", 1, 1},
    {"tools", "place", "Locks a place or gives it a kind", "MAGAZINE POT locked=1 place_type=2", 3,
     -1},
    {"tools", "life",
     "What is left of each tool and group, and what stops the machine first; 'life reset TOOL "
     "...' after a new insert",
     "[reset TOOL ...]", 0, -1},
    {"tools", "import", "Tool data of a file: all of it or nothing", "FILE", 1, 1},
    {"tools", "export", "Tool data to a file or to standard output", "[FILE]", 0, 1},
    {"offsets", "list", "The offset table of a channel", "[L]", 0, 1},
    {"offsets", "set",
     "Values of one offset; NUMBER may be an edge as T3.D1, and its values DP13=0.02",
     "L NUMBER geometry|wear|second X=1.5 ...", 3, -1},
    {"offsets", "measure", "The tip stands where the workpiece measures this",
     "L NUMBER geometry X=40", 4, 4},
    {"offsets", "touch",
     "The tool has touched the setter: shows old, new and difference; with --yes writes",
     "L [NUMBER [geometry|wear]]", 1, 3},
    {"offsets", "origin", "The relative counter begins here", "[L]", 0, 1},
    {"offsets", "relative", "The relative counter becomes the offset", "L NUMBER geometry X", 4, 4},
    {"offsets", "undo", "Takes the last entry back; with T3 or T3.D1 that of a tool's edges",
     "[L [T3.D1]]", 0, 2},
    {"offsets", "history", "Who entered what", "", 0, 0},
    {"zeros", "list", "The zero offsets of a channel", "[L]", 0, 1},
    {"zeros", "set", "Values of one zero offset", "L G54 Z=-150 ...", 3, -1},
    {"zeros", "measure", "The tip stands at a surface of the workpiece that is to be here",
     "L G54 Z=0", 3, 3},
    {"zeros", "touch",
     "The workpiece setter has answered: shows old, new and difference; with --yes writes",
     "L [G54] [Z=0]", 1, 3},
    {"presetter", "calibrate",
     "Scale, tilt and place of the camera by a gauge pin (IMAGE may be camera:0); x and z are "
     "the offsets that the middle of its end has, x as a radius",
     "IMAGE diameter=6 x=50 z=30 [mirrored=1]", 4, 5},
    {"presetter", "measure",
     "X, Z, nose radius, tip number and angles of the tool in the picture (PGM, BMP, camera:0, "
     "camera:shot_%02d.pgm); with L and NUMBER (of an edge T3.D1) what would be entered, with "
     "--yes enters it",
     "IMAGE [L NUMBER]", 1, 3},
    {"parts", "list", "Dimensions, what was measured, what is proposed", "", 0, 0},
    {"parts", "add",
     "A dimension: nominal= upper= lower= tool= channel= axis= limit= share= average= name=",
     "[NUMBER] COLUMN=VALUE ...", 1, -1},
    {"parts", "set", "Columns of a dimension", "DIMENSION COLUMN=VALUE ...", 2, -1},
    {"parts", "delete", "Removes a dimension", "DIMENSION", 1, 1},
    {"parts", "measure", "A measured value; answers with the proposed correction",
     "DIMENSION VALUE", 2, 2},
    {"parts", "accept", "Writes the proposed correction, or another one, to the wear",
     "DIMENSION [VALUE]", 1, 2},
    {"pallets", "list", "The pallet table", "", 0, 0},
    {"pallets", "set", "pallet= program= custom1= ...", "ROW COLUMN=VALUE ...", 2, -1},
    {"pallets", "exchange", "Two rows change places", "ROW ROW", 2, 2},
    {"users", "list", "Logins and their levels", "", 0, 0},
    {"users", "add", "A login; the password is asked for", "NAME operator|setter|maker [uid=1000]",
     2, 3},
    {"users", "delete", "Removes a login", "NAME", 1, 1},
    {"users", "level", "Another level", "NAME operator|setter|maker", 2, 2},
    {"users", "password", "A new password", "NAME", 1, 1},
};
constexpr Action kVerbs[] = {
    {"login", "", "Logs in; the password is asked for", "NAME", 1, 1},
    {"logout", "", "Ends the login", "", 0, 0},
    {"who", "", "Who is logged in, and with which level", "", 0, 0},
    {"history", "", "Who changed what, newest first", "[TEXT]", 0, 1},
    {"stops", "", "When the channels stood, how long and why, newest first", "", 0, 0},
    {"backup", "", "Everything in one file, while the controller works", "FILE", 1, 1},
    {"restore", "",
     "Shows what a backup would change; with --yes changes it. Without FILE the newest usable "
     "one of the store's own",
     "[FILE]", 0, 1},
};

void add(CLI::App& parent, const Action& action, const std::string& name, CommandLine& line) {
    CLI::App* one = parent.add_subcommand(name, action.text);
    StoreOptions& store = line.store;
    if (action.most != 0) {
        auto* words =
            one->add_option("WORDS", store.words, action.words)->option_text(action.words);
        if (action.least > 0) words->required();
        words->expected(action.least, action.most < 0 ? 100'000 : action.most);
    }
    one->add_option("--instance", store.instance, "the controller; default polyturn");
    one->add_flag("--json", line.json, "for programs");
    const std::string_view group = action.group, which = name;
    if (which == "import" || which == "export") {
        one->add_option("--format", store.format, "csv (default), fanuc or sinumerik")
            ->check(CLI::IsMember({"csv", "fanuc", "sinumerik"}));
        one->add_option("--channel", store.channel, "channel of the offsets (fanuc)");
    }
    if (which == "import") one->add_flag("--preview", store.preview, "only check and count");
    if (which == "life")
        one->add_option("--channel", store.channel,
                        "with reset: also clears the wear of the tool's offset in this channel");
    if (group == "tools" && which == "list") {
        one->add_option("--magazine", store.magazine, "only what stands there");
        one->add_option("--type", store.type, "only sisters of this type number");
    }
    if (group == "zeros" && (which == "measure" || which == "touch"))
        one->add_option("--offset", store.offset,
                        "offset of the tool or probe that stands there; 0: none");
    if (which == "set" && (group == "offsets" || group == "zeros"))
        one->add_flag("--incremental", store.incremental, "added to what is there");
    if (which == "measure" && group == "offsets")
        one->add_option("--zero", store.zero, "zero offset of the workpiece; default G54");
    if (group == "offsets" &&
        (which == "set" || which == "measure" || which == "touch" || which == "relative"))
        one->add_option("--plane", store.plane,
                        "of an edge: 17, 18 (default) or 19 says which length lies along X, Y, Z")
            ->check(CLI::IsMember({17, 18, 19}));
    if (group == "presetter")
        one->add_option("--calibration", store.name,
                        "file of the calibration; default presetter.json");
    if (group == "presetter")
        one->add_option("--frames", store.frames,
                        "of a camera, put together to one picture; default 8")
            ->check(CLI::Range(1, 256));
    if (group == "presetter" && which == "measure") one->add_flag("--yes", store.yes, "write it");
    if (which == "touch") one->add_flag("--yes", store.yes, "write it");
    if (group == "stops") {
        one->add_option("--most", store.most, "lines")->check(CLI::Range(1, 5'000));
        one->add_option("--since", store.since, "UTC, as 2026-01-31T06:00");
    }
    if (group == "history" || which == "history") {
        one->add_option("--most", store.most, "lines")->check(CLI::Range(1, 100'000));
        one->add_option("--who", store.who, "only of this user");
    }
    if (group == "backup")
        one->add_option("--with", store.with, "program or folder of programs; repeatable")
            ->allow_extra_args(false);
    if (group == "restore") {
        one->add_flag("--yes", store.yes, "do it");
        one->add_flag("--with-plc", store.with_plc,
                      "also programs of the PLC and of drives that the backup holds");
        one->add_option("--store", store.store,
                        "folder of a controller that does not run: its store is replaced");
        one->add_option("--machine", store.machine, "with --store: its machine");
    }
    const std::string family = group == which ? std::string() : name;
    one->callback([&store, group = std::string(group), family] {
        store.group = group;
        store.action = family;
    });
    one->footer("Exit status: 0 done; 2 refused, nothing changed.");
}

}  // namespace

void add_store_verbs(CLI::App& app, CommandLine& line) {
    static constexpr const char* kTexts[][2] = {
        {"tools", "Tools, magazines, life"},
        {"offsets", "Tool offsets of a running controller"},
        {"zeros", "Zero offsets of a running controller"},
        {"presetter", "Tools measured in pictures of their shadow"},
        {"parts", "Measured parts and the corrections they propose"},
        {"pallets", "The pallet table"},
        {"users", "Logins and levels"}};
    for (const auto& [group, text] : kTexts) {
        CLI::App* parent = app.add_subcommand(group, text);
        parent->require_subcommand(1);
        for (const Action& action : kActions)
            if (std::string_view(action.group) == group) add(*parent, action, action.name, line);
    }
    for (const Action& verb : kVerbs) add(app, verb, verb.group, line);
}

}  // namespace polyturn::supervisor
