// libs: polyturn_toolmgmt
//
// A backup from anywhere: any bytes, a good one with spoilt places, a good
// one that carries files of any name and content. It is read or refused with what is wrong; what it
// brings is written below the machine's folder and nowhere else.
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "ipc/model/machine/load_machine.hpp"
#include "toolmgmt/database.hpp"
#include "toolmgmt/operations/backup_files.hpp"
#include "toolmgmt/operations/restore_diff.hpp"

namespace {
using namespace polyturn;
using namespace polyturn::toolmgmt;
namespace fs = std::filesystem;

// top/machine is what may be written; beside it stands what a backup would like to reach.
struct Sandbox {
    fs::path top, machine, file;
    std::string good;
    std::optional<Database> disk;
    std::unique_ptr<StoreValues> now = std::make_unique<StoreValues>(),
                                 wanted = std::make_unique<StoreValues>();

    Sandbox() {
        const fs::path root = fs::exists("/dev/shm") ? "/dev/shm" : fs::temp_directory_path();
        top = root / ("backup-fuzz-" + std::to_string(getpid()));
        fs::remove_all(top);
        machine = top / "machine";
        file = top / "backup.ptb";
        fs::create_directories(top / "outside");
        clear(*now);
        now->parameters = *load_machine_file({}).table;
        auto opened = Database::open((top / "store").string());
        if (!opened) std::abort();
        disk.emplace(std::move(*opened));
        if (!disk->backup(file.string(), {{"machine/machine.params", "x", "N1600 L1=2\n"},
                                          {"program/a.nc", "x", "M30\n"}}))
            std::abort();
        std::ifstream in(file, std::ios::binary);
        good.assign(std::istreambuf_iterator<char>(in), {});
        fresh();
    }
    ~Sandbox() { fs::remove_all(top); }
    void fresh() {
        fs::remove_all(machine);
        fs::create_directories(machine / "programs");
        fs::create_directory_symlink(top / "outside", machine / "link");
        fs::create_symlink(top / "outside" / "x", machine / "file.params");
    }
    void put(const std::string& bytes) const {
        std::ofstream(file, std::ios::binary | std::ios::trunc) << bytes;
    }
    void nothing_outside() const {
        if (!fs::is_empty(top / "outside")) std::abort();
        for (const auto& entry : fs::directory_iterator(top)) {
            const std::string name = entry.path().filename().string();
            if (name != "machine" && name != "outside" && name != "store" && name != "backup.ptb")
                std::abort();
        }
    }
    void restore() {
        clear(*wanted);
        wanted->parameters = now->parameters;
        std::vector<Database::File> files;
        std::vector<Diagnosis> warnings;
        const Result<void> read = Database::read_backup(file.string(), *wanted, files, warnings);
        if (!read) {
            if (read.diagnosis().text().empty() || read.diagnosis().remedy().empty()) std::abort();
            return;
        }
        if (files.size() > 20'000) std::abort();
        (void)changes_between(*now, *wanted);
        bool written = false;
        for (const auto& one : files) {
            const auto judged = judge_file(one, {machine.string(), (top / "store").string()});
            if (!judged) {
                if (judged.diagnosis().text().empty()) std::abort();
                continue;
            }
            const fs::path target = fs::path(judged->target).lexically_normal();
            if (target.string().rfind(machine.string() + "/", 0) != 0) std::abort();
            written = true;
            (void)put_file(*judged, one.bytes);
        }
        nothing_outside();
        if (written) fresh();
    }
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Sandbox place;
    if (size < 2) return 0;
    const std::string_view rest(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
        case 0:
            place.put(std::string(rest));
            break;
        case 1: {  // places of a good one: where (three bytes) and what
            std::string bytes = place.good;
            for (std::size_t i = 0; i + 4 <= rest.size(); i += 4) {
                const auto byte = [&](std::size_t k) {
                    return static_cast<unsigned char>(rest[i + k]);
                };
                const std::size_t at = (byte(0) << 16 | byte(1) << 8 | byte(2)) % bytes.size();
                bytes[at] = rest[i + 3];
            }
            if (data[0] & 128) bytes.resize(bytes.size() * data[0] / 256);
            place.put(bytes);
            break;
        }
        default: {  // files: a name up to a newline, the content up to two of them
            std::vector<Database::File> files;
            for (std::size_t at = 0; at < rest.size() && files.size() < 8;) {
                const std::size_t end = std::min(rest.find('\n', at), rest.size()),
                                  next = std::min(rest.find("\n\n", end), rest.size());
                const std::string name(rest.substr(at, end - at));
                files.push_back({(data[0] & 64    ? "machine/"
                                  : data[0] & 128 ? "program/"
                                                  : "") +
                                     name,
                                 "/",
                                 std::string(rest.substr(std::min(end + 1, rest.size()),
                                                         next > end ? next - end - 1 : 0))});
                at = next + 2;
            }
            if (!place.disk->backup(place.file.string(), files)) return 0;
        }
    }
    place.restore();
    return 0;
}
