// Cameras and films by OpenCV's videoio. POLYTURN_VIDEOIO is set where that is installed.
#include "toolmgmt/presetter/frame_source.hpp"

#ifdef POLYTURN_VIDEOIO
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <opencv2/core/utils/logger.hpp>
#include <opencv2/imgproc.hpp>
#include <opencv2/videoio.hpp>
#endif

namespace polyturn::presetter {

#ifdef POLYTURN_VIDEOIO

namespace {

constexpr int kTimeoutMs = 5000;  // of a camera in the network

class Capture final : public FrameSource {
public:
    Capture(const std::string& what, int device) : what_(what) {
        live = device >= 0 || what.find("://") != std::string::npos;
        if (device >= 0)
            camera_.open(device, cv::CAP_V4L2);
        else
            camera_.open(what, cv::CAP_FFMPEG,
                         {cv::CAP_PROP_OPEN_TIMEOUT_MSEC, kTimeoutMs,
                          cv::CAP_PROP_READ_TIMEOUT_MSEC, kTimeoutMs});
    }
    bool is_open() const { return camera_.isOpened(); }
    Result<ShadowImage> next() override {
        cv::Mat frame, grey, exact;
        if (!camera_.read(frame) || frame.empty())
            return no_picture(what_ + " gives no more frames");
        if (frame.channels() == 3)
            cv::cvtColor(frame, grey, cv::COLOR_BGR2GRAY);
        else if (frame.channels() == 4)
            cv::cvtColor(frame, grey, cv::COLOR_BGRA2GRAY);
        else
            grey = frame;
        if (grey.channels() != 1 || (grey.depth() != CV_8U && grey.depth() != CV_16U))
            return no_picture(what_ + " gives frames of a kind that is not known");
        if (grey.cols < kLeastSide || grey.rows < kLeastSide || grey.cols > kMostSide ||
            grey.rows > kMostSide)
            return no_picture(what_ + " gives frames of " + std::to_string(grey.cols) + " x " +
                              std::to_string(grey.rows) + " pixels");
        grey.convertTo(exact, CV_32F, grey.depth() == CV_16U ? 255.0 / 65535.0 : 1.0);
        ShadowImage out{exact.cols, exact.rows, {}};
        out.grey.reserve(exact.total());
        for (int y = 0; y < exact.rows; ++y)
            out.grey.insert(out.grey.end(), exact.ptr<float>(y), exact.ptr<float>(y) + exact.cols);
        return out;
    }

private:
    std::string what_;
    cv::VideoCapture camera_;
};

// "0" or "/dev/video0"; -1: neither.
int device_of(const std::string& what) {
    const std::string prefix = "/dev/video",
                      digits = what.rfind(prefix, 0) == 0 ? what.substr(prefix.size()) : what;
    if (digits.empty() || digits.size() > 3 ||
        digits.find_first_not_of("0123456789") != std::string::npos)
        return -1;
    return std::atoi(digits.c_str());
}

}  // namespace

Result<std::unique_ptr<FrameSource>> open_capture(const std::string& what) {
    // what is wrong, the diagnosis says
    cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
    setenv("OPENCV_FFMPEG_LOGLEVEL", "-8", 1);
    const int device = device_of(what);
    const std::string file = device >= 0 ? "/dev/video" + std::to_string(device) : what;
    if (what.find("://") == std::string::npos && access(file.c_str(), R_OK) != 0)
        return no_picture(file + ": " + std::strerror(errno));
    try {
        auto capture = std::make_unique<Capture>(file, device);
        if (!capture->is_open()) return no_picture(file + " does not answer as a camera or a film");
        return std::unique_ptr<FrameSource>(std::move(capture));
    } catch (const cv::Exception& error) { return no_picture(file + ": " + error.err); }
}

#else

Result<std::unique_ptr<FrameSource>> open_capture(const std::string& what) {
    return no_picture(
        what +
        ": this build has no cameras (OpenCV videoio); numbered pictures, camera:shot_%02d.pgm, it "
        "reads");
}

#endif

}  // namespace polyturn::presetter
