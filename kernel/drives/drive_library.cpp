// External drives that are called in this process: the machine builder's drive.so, and a substitute
// for one that is missing.
#include <dlfcn.h>

#include "ipc/model/files/regular_file.hpp"
#include "kernel/drives/segment_drives.hpp"

namespace polyturn::kernel {

const PolyturnDriveApi* load_drive_library(const std::string& file, std::string& reason) {
    // dlopen() would wait for the writer of a pipe
    if (auto ordinary = text::RegularFile::open(file, text::kLargestLibrary); !ordinary) {
        reason = file + ": " + ordinary.diagnosis().detail;
        return nullptr;
    }
    void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) {
        const char* why = dlerror();
        reason = why ? why : file;
        return nullptr;
    }
    using Export = const PolyturnDriveApi* (*)();
    const auto get = reinterpret_cast<Export>(dlsym(library, "polyturn_drive_api"));
    const PolyturnDriveApi* api = get ? get() : nullptr;
    if (api && api->version == POLYTURN_DRIVE_VERSION && api->open && api->close && api->exchange)
        return api;
    reason = !api ? file + " does not export polyturn_drive_api"
                  : file + " was built for another version of drive.h";
    return nullptr;
}

const PolyturnDriveApi& missing_drive_api() {
    static int nothing = 0;
    static constexpr PolyturnDriveApi kApi{
        POLYTURN_DRIVE_VERSION, [](const PolyturnDriveSetup*) -> void* { return &nothing; },
        [](void*) {},
        [](void*, const PolyturnDriveCommand*, PolyturnDriveStatus* status) {
            *status = {};
            status->status = POLYTURN_DRIVE_FAULT;
        }};
    return kApi;
}

}  // namespace polyturn::kernel
