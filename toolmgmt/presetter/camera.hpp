// A picture from the presetter's camera instead of a file: several frames, one behind the other,
// become one picture with less noise.
//
//   camera:0  camera:/dev/video2      a camera of this computer, by its number or its device
//   camera:rtsp://...  camera:http://...  camera:shot.avi    a camera in the network, a film
//   camera:shot_%02d.pgm              pictures that a camera program has written, by number, from 0
//                                     or 1 on
//
// The first frames of a camera are not used: its exposure is still being found. Frames that do not
// show the same are refused, for the tool or the camera moves; so are a camera that does not answer
// and one that ends before the frames are together. Cameras and films need OpenCV's videoio; a
// build without it says so. Numbered pictures need nothing.
#pragma once

#include <string>
#include <string_view>

#include "ipc/diagnosis/diagnosis.hpp"
#include "toolmgmt/presetter/shadow_image.hpp"

namespace polyturn::presetter {

inline constexpr int kFrames = 8, kMostFrames = 256;

// "camera:..." and not a file.
bool is_camera(std::string_view source);
Result<ShadowImage> take_picture(const std::string& source, int frames = kFrames);

}  // namespace polyturn::presetter
