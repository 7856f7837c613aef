#include "toolmgmt/durability/inspect.hpp"

#include <unistd.h>

namespace polyturn::toolmgmt {

Inspection inspect(const std::string& folder, const std::string& file) {
    Inspection out;
    WitnessFile witness(folder);
    out.witness = witness.read();
    out.acknowledged = witness.now();
    out.sums_state = out.sums.read(folder);
    std::string main;
    const bool readable = read_whole_file(file, main);
    // https://www.sqlite.org/fileformat2.html#user_version_number
    if (main.size() >= 100 && main.rfind("SQLite format 3", 0) == 0)
        for (std::size_t at = 60; at < 64; ++at)
            out.version = out.version << 8 | static_cast<unsigned char>(main[at]);
    // new, or of a version without acknowledgements
    if (out.witness == WitnessFile::State::Missing && out.sums_state == PageSums::State::Missing)
        return out;
    const std::string name = file.substr(file.rfind('/') + 1);
    const auto say = [&](Alarm alarm, std::string what) {
        out.damage = Diagnosis{alarm, {file, 0, 0, 0}, {}, std::move(what)};
    };
    if (!readable && ::access(file.c_str(), F_OK) == 0) {
        say(Alarm::StoreDamaged, name + " cannot be read to its end");
        return out;
    }
    if (main.empty()) {
        say(Alarm::StoreLost, name + (readable ? " is empty" : " is missing"));
        return out;
    }
    if (out.sums_state != PageSums::State::Good) {
        say(Alarm::StoreDamaged,
            std::string(PageSums::kName) +
                (out.sums_state == PageSums::State::Missing ? " is missing" : " is damaged"));
        return out;
    }
    if (out.witness == WitnessFile::State::Good && out.sums.store != out.acknowledged.store) {
        say(Alarm::StoreLost, std::string(PageSums::kName) + " belongs to another store");
        return out;
    }
    if (const std::uint32_t page = out.sums.damaged(main, read_log(file + "-wal")); page != 0)
        say(Alarm::StoreDamaged, "page " + std::to_string(page) + " of " + name);
    return out;
}

}  // namespace polyturn::toolmgmt
