#include "toolmgmt/options.hpp"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "ipc/memory/segment.hpp"
#include "ipc/model/files/machine_path.hpp"

namespace polyturn::toolmgmt {

Options read_options(int argc, char** argv) {
    Options options;
    CLI::App app{
        "The store of a Polyturn controller: parameters, offsets, zeros, kept variables. "
        "Started by polyturn.",
        "polyturn-toolmgmt"};
    app.add_option("--instance", options.instance, "name of the controller");
    auto* store = app.add_option("--store", options.store, "folder in which the values are kept");
    auto* memory = app.add_flag("--memory", options.memory, "keep nothing");
    store->excludes(memory);
    app.add_option("--machine", options.machine.machine,
                   "parameter file, folder or name of the machine");
    app.add_option("--param-file", options.machine.param_files,
                   "file of parameter lines, on top of the machine's")
        ->allow_extra_args(false);
    app.add_option("--set", options.machine.sets, "one parameter line, on top of all files")
        ->allow_extra_args(false);
    app.add_option("--setup", options.setup,
                   "what an operator would have entered: offsets, zeros, variables (TOML)");
    app.add_option("--like", options.like,
                   "the running controller whose tools this one begins with");
    app.add_option(
        "--restore", options.restore,
        "puts this backup (or newest: of the folder's own) in place of the store and ends");
    app.add_flag("--with-plc", options.with_plc,
                 "with --restore: also programs of the PLC and drives that the backup holds");
    app.add_flag("--confirm-loss", options.confirm,
                 "production goes on with what a damaged store still holds; ends then");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        options.exit_status = app.exit(error) == 0 ? 0 : 2;
        return options;
    }
    if (const auto path = text::resolve_machine(options.machine.machine))
        options.machine_folder = path->folder;
    if ((!options.restore.empty() || options.confirm) && !options.store.empty()) return options;
    if (!valid_instance(options.instance)) {
        std::fprintf(stderr, "polyturn-toolmgmt: \"%s\" is no name of a controller\n",
                     options.instance.c_str());
        options.exit_status = 2;
    } else if (options.store.empty() && !options.memory) {
        std::fprintf(stderr, "polyturn-toolmgmt: say --store DIR or --memory\n");
        options.exit_status = 2;
    }
    return options;
}

}  // namespace polyturn::toolmgmt
