#include "ipc/memory/segment.hpp"

#include <fcntl.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <boost/interprocess/mapped_region.hpp>
#include <boost/interprocess/shared_memory_object.hpp>
#include <cctype>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <thread>

#include "ipc/memory/trusted_owner.hpp"
#include "ipc/params/registry.hpp"

namespace polyturn {
namespace bip = boost::interprocess;

namespace {
constexpr std::string_view kPrefix = "polyturn.", kMaker = ".of-";
// where shm_open() of Linux keeps its names: one is renamed and all are listed here
const std::filesystem::path kFolder = "/dev/shm";

// The table of fields and the parameters' slots: whoever was built with others means something else
// by the same bytes.
std::uint64_t compute_layout_hash() {
    std::uint64_t hash = kLayoutHash;
    for (const params::Row& row : params::rows()) {
        for (const char c : row.number)
            hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
        hash = (hash ^ row.first_slot) * 0x100000001b3ull;
    }
    return hash;
}

std::uint64_t layout_hash() {
    static const std::uint64_t hash = compute_layout_hash();
    return hash;
}

Diagnosis fault(Alarm alarm, std::string detail) {
    return Diagnosis{alarm, {}, {}, std::move(detail)};
}
}  // namespace

bool valid_instance(std::string_view instance) {
    if (instance.empty() || instance.size() > 40) return false;
    for (const char c : instance)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '-' && c != '_') return false;
    return true;
}

std::string segment_name(std::string_view instance, SegmentKind kind, std::size_t number) {
    static constexpr std::string_view kNames[] = {"supervisor", "kernel", "plc", "store",
                                                  "channel"};
    std::string name = std::string(kPrefix) + std::string(instance) + "." +
                       std::string(kNames[static_cast<std::size_t>(kind)]);
    if (kind == SegmentKind::Channel) name += std::to_string(number);
    return name;
}

namespace {

bool believed(const struct stat& info) {
    return S_ISREG(info.st_mode) && trusted_owner(info.st_uid);
}

// What a name of /dev/shm leads to, opened without waiting and checked: an ordinary file of
// somebody who is trusted. A pipe of that name would hold its reader for ever, a stranger's file
// would say whatever he likes. boost::interprocess maps it.
class SharedFile {
public:
    SharedFile() = default;
    SharedFile(const SharedFile&) = delete;
    SharedFile& operator=(const SharedFile&) = delete;
    ~SharedFile() {
        if (fd_ >= 0) ::close(fd_);
    }

    Result<void> open(const std::string& name, bip::mode_t mode) {
        mode_ = mode;
        struct stat info {};
        // not even opened
        if (::lstat((kFolder / name).c_str(), &info) == 0 && !believed(info))
            return Diagnosis{Alarm::InstanceForeign, {}, {}, name};
        fd_ = ::open((kFolder / name).c_str(), (mode == bip::read_write ? O_RDWR : O_RDONLY) |
                                                   O_CLOEXEC | O_NONBLOCK | O_NOFOLLOW | O_NOCTTY);
        const bool there = fd_ >= 0 && ::fstat(fd_, &info) == 0;
        if (there && believed(info)) {
            size_ = static_cast<std::size_t>(info.st_size);
            return Result<void>();
        }
        const bool foreign = there || errno == EACCES || errno == ELOOP || errno == ENXIO;
        return Diagnosis{foreign ? Alarm::InstanceForeign : Alarm::SegmentMissing, {}, {}, name};
    }
    // A new one; O_EXCL: whatever bears the name already is not ours.
    Result<void> create(const std::string& name, std::size_t size) {
        mode_ = bip::read_write;
        fd_ = ::open((kFolder / name).c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW,
                     private_mode());
        if (fd_ >= 0 && ::fchmod(fd_, private_mode()) == 0 &&
            ::ftruncate(fd_, static_cast<off_t>(size)) == 0) {
            size_ = size;
            return Result<void>();
        }
        return errno == EEXIST
                   ? Diagnosis{Alarm::InstanceForeign, {}, {}, name}
                   : Diagnosis{Alarm::SegmentCreate, {}, {}, name + ": " + std::strerror(errno)};
    }
    std::size_t size() const { return size_; }
    bip::mapping_handle_t get_mapping_handle() const {
        return bip::ipcdetail::mapping_handle_from_file_handle(fd_);
    }
    bip::mode_t get_mode() const { return mode_; }

private:
    int fd_ = -1;
    std::size_t size_ = 0;
    bip::mode_t mode_ = bip::read_only;
};

}  // namespace

struct RawSegment::Parts {
    bip::mapped_region region;
    std::string own_name, hidden_name;  // of a segment that was made here
};

RawSegment::RawSegment() = default;
RawSegment::RawSegment(RawSegment&&) noexcept = default;
RawSegment& RawSegment::operator=(RawSegment&&) noexcept = default;
RawSegment::~RawSegment() = default;
void* RawSegment::address() const { return parts_ ? parts_->region.get_address() : nullptr; }

Result<RawSegment> RawSegment::create(const std::string& name, std::size_t size) {
    // A predecessor's segment stays mapped by whoever still reads it; the name is taken over by a
    // fresh one.
    bip::shared_memory_object::remove(name.c_str());
    RawSegment out;
    out.parts_ = std::make_unique<Parts>();
    out.parts_->own_name = name;
    out.parts_->hidden_name = name + std::string(kMaker) + std::to_string(getpid());
    bip::shared_memory_object::remove(out.parts_->hidden_name.c_str());
    SharedFile file;
    if (const auto made = file.create(out.parts_->hidden_name, size); !made)
        return made.diagnosis();
    try {
        out.parts_->region = bip::mapped_region(file, bip::read_write, 0, size);
    } catch (const bip::interprocess_exception& error) {
        return fault(Alarm::SegmentCreate, name + ": " + error.what());
    }
    return out;
}

Result<void> RawSegment::reveal() {
    std::error_code failed;
    std::filesystem::rename(kFolder / parts_->hidden_name, kFolder / parts_->own_name, failed);
    if (!failed) return {};
    std::error_code none;
    std::filesystem::remove(kFolder / parts_->hidden_name, none);
    const bool foreign = failed == std::errc::operation_not_permitted ||
                         failed == std::errc::permission_denied ||
                         failed == std::errc::is_a_directory;
    return foreign ? fault(Alarm::InstanceForeign, parts_->own_name)
                   : fault(Alarm::SegmentCreate, parts_->own_name + ": " + failed.message());
}

Result<RawSegment> RawSegment::map(const std::string& name, std::size_t size, bool writable) {
    const bip::mode_t mode = writable ? bip::read_write : bip::read_only;
    SharedFile file;
    if (const auto opened = file.open(name, mode); !opened) return opened.diagnosis();
    // Size 0: its writer has not given it one yet. Any other size was made by another build.
    if (file.size() < size)
        return fault(file.size() == 0 ? Alarm::SegmentNotReady : Alarm::SegmentLayout, name);
    try {
        RawSegment out;
        out.parts_ = std::make_unique<Parts>();
        out.parts_->region = bip::mapped_region(file, mode, 0, size);
        return out;
    } catch (const bip::interprocess_exception&) { return fault(Alarm::SegmentMissing, name); }
}

Result<RawSegment> RawSegment::attach(const std::string& name, std::size_t size) {
    return map(name, size, false);
}
Result<RawSegment> RawSegment::adopt(const std::string& name, std::size_t size) {
    return map(name, size, true);
}

void fill_header(SegmentHeader& header, std::string_view instance, std::uint64_t generation) {
    header.magic = kMagic;
    header.layout_hash = layout_hash();
    header.generation = generation;
    header.writer_pid = static_cast<std::int32_t>(getpid());
    header.instance.fill(0);
    std::memcpy(header.instance.data(), instance.data(),
                std::min(instance.size(), header.instance.size() - 1));
}

// P1: all that the segment shows from its first moment on
void publish_header(SegmentHeader& header) { header.ready.store(1, std::memory_order_release); }

Result<void> check_header(const SegmentHeader& header, std::string_view instance) {
    if (header.magic != kMagic)
        return fault(Alarm::SegmentLayout, std::string(instance) + ": no segment of Polyturn");
    if (header.layout_hash != layout_hash())
        return fault(Alarm::SegmentLayout, std::string(instance));
    if (std::string_view(header.instance.data()) != instance)
        return fault(Alarm::SegmentLayout,
                     "belongs to instance " + std::string(header.instance.data()));
    return {};
}

void sleep_ms(int milliseconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

// A process that has ended and waits to be reaped holds nothing any more; nor does one that is
// being taken apart (that of a killed kernel may last a while: its memory is given back first).
bool process_lives(int pid) {
    if (pid <= 0) return false;
    if (kill(pid, 0) != 0 && errno != EPERM) return false;
    std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
    std::string stat;
    std::getline(file, stat);
    const std::size_t name_end = stat.rfind(") ");  // the name may hold anything
    if (name_end == std::string::npos) return true;
    std::istringstream rest(stat.substr(name_end + 2));
    char state = 0;
    int parent, group, session, terminal, foreground;
    unsigned flags = 0;
    rest >> state >> parent >> group >> session >> terminal >> foreground >> flags;
    constexpr unsigned kExiting = 4;  // PF_EXITING of Linux
    return state != 'Z' && state != 'X' && !(flags & kExiting);
}

namespace {
struct Found {
    std::vector<std::string> names;
    bool alive = false;
};

// Whose it is says its header, or its name as long as it has none.
int maker_of(const std::string& name) {
    if (const std::size_t at = name.rfind(kMaker); at != std::string::npos)
        return std::atoi(name.c_str() + at + kMaker.size());
    const auto raw = RawSegment::attach(name, sizeof(SegmentHeader));
    const auto* header = raw ? static_cast<const SegmentHeader*>(raw->address()) : nullptr;
    return header && header->magic == kMagic ? header->writer_pid : 0;
}

std::map<std::string, Found> instances_in_memory() {
    std::map<std::string, Found> found;
    std::error_code none;
    for (const auto& entry : std::filesystem::directory_iterator(kFolder, none)) {
        const std::string name = entry.path().filename().string();
        struct stat info {};  // of the name itself: nothing of a stranger is opened, nor followed
        if (name.rfind(kPrefix, 0) != 0 || ::lstat(entry.path().c_str(), &info) != 0 ||
            !believed(info))
            continue;
        const std::size_t dot = name.find('.', kPrefix.size());
        if (dot == std::string::npos) continue;
        Found& instance = found[name.substr(kPrefix.size(), dot - kPrefix.size())];
        instance.names.push_back(name);
        if (process_lives(maker_of(name))) instance.alive = true;
    }
    return found;
}
}  // namespace

std::vector<std::string> remove_dead_instances() {
    std::vector<std::string> removed;
    for (const auto& [instance, found] : instances_in_memory()) {
        if (found.alive) continue;
        for (const auto& name : found.names)
            if (bip::shared_memory_object::remove(name.c_str())) removed.push_back(name);
    }
    return removed;
}

void remove_instance(std::string_view instance) {
    for (const auto& [name, found] : instances_in_memory())
        if (name == instance)
            for (const auto& segment : found.names)
                bip::shared_memory_object::remove(segment.c_str());
}

}  // namespace polyturn
