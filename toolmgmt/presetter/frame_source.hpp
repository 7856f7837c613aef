// Where frames come from, one after the other; see camera.hpp.
#pragma once

#include <memory>
#include <string>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/presetter/shadow_image.hpp"

namespace polyturn::presetter {

class FrameSource {
public:
    virtual ~FrameSource() = default;
    virtual Result<ShadowImage> next() = 0;
    bool live = false;  // a camera: its first frames are not to be trusted
};

inline Diagnosis no_picture(std::string why) {
    return Diagnosis{Alarm::PresetterImage, {}, {}, "no picture: " + why};
}

// A camera or a film, by OpenCV. `what`: without "camera:".
Result<std::unique_ptr<FrameSource>> open_capture(const std::string& what);

}  // namespace polyturn::presetter
