#include "toolmgmt/presetter/camera.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "toolmgmt/presetter/frame_source.hpp"

namespace polyturn::presetter {
namespace {

constexpr std::string_view kPrefix = "camera:";
constexpr int kSettling = 8;  // frames of a camera that find the exposure
// pixels each way of a block whose mean is compared: noise is averaged out, a moved edge is not
constexpr int kBlock = 8;
constexpr float kMoved = 10.0F;  // grey values of such a mean

// "shot_%03d.pgm": where the number stands and how many digits it has at least.
struct Pattern {
    std::string before, after;
    unsigned digits = 0;
};
bool read_pattern(const std::string& text, Pattern& out) {
    const std::size_t at = text.find('%');
    if (at == std::string::npos) return false;
    std::size_t end = at + 1;
    while (end < text.size() && text[end] >= '0' && text[end] <= '9' && end - at < 3)
        out.digits = out.digits * 10 + static_cast<unsigned>(text[end++] - '0');
    if (end >= text.size() || text[end] != 'd' || text.find('%', end) != std::string::npos)
        return false;
    out.before = text.substr(0, at);
    out.after = text.substr(end + 1);
    return true;
}

class NumberedPictures final : public FrameSource {
public:
    explicit NumberedPictures(Pattern pattern) : pattern_(std::move(pattern)) {
        if (!std::filesystem::exists(name(0))) number_ = 1;
    }
    Result<ShadowImage> next() override {
        const std::string file = name(number_);
        if (!std::filesystem::exists(file)) return no_picture("there is no " + file);
        ++number_;
        return read_image(file);
    }

private:
    std::string name(unsigned number) const {
        std::string digits = std::to_string(number);
        if (digits.size() < pattern_.digits) digits.insert(0, pattern_.digits - digits.size(), '0');
        return pattern_.before + digits + pattern_.after;
    }
    Pattern pattern_;
    unsigned number_ = 0;
};

// The largest difference of two pictures' block means.
float difference(const ShadowImage& a, const ShadowImage& b) {
    float most = 0;
    for (int y = 0; y + kBlock <= a.height; y += kBlock)
        for (int x = 0; x + kBlock <= a.width; x += kBlock) {
            float sum = 0;
            for (int j = 0; j < kBlock; ++j)
                for (int i = 0; i < kBlock; ++i) sum += a.at(x + i, y + j) - b.at(x + i, y + j);
            most = std::max(most, std::fabs(sum) / (kBlock * kBlock));
        }
    return most;
}

Result<std::unique_ptr<FrameSource>> open(const std::string& what) {
    if (Pattern pattern; read_pattern(what, pattern))
        return std::unique_ptr<FrameSource>(std::make_unique<NumberedPictures>(std::move(pattern)));
    return open_capture(what);
}

}  // namespace

bool is_camera(std::string_view source) { return source.substr(0, kPrefix.size()) == kPrefix; }

Result<ShadowImage> take_picture(const std::string& source, int frames) {
    const std::string what = source.substr(std::min(kPrefix.size(), source.size()));
    if (what.empty())
        return no_picture("camera: and then its number, its device, an address or shot_%02d.pgm");
    const auto opened = open(what);
    if (!opened) return opened.diagnosis();
    FrameSource& camera = **opened;
    if (camera.live)
        for (int i = 0; i < kSettling; ++i)
            if (const auto frame = camera.next(); !frame) return frame.diagnosis();
    auto first = camera.next();
    if (!first) return first.diagnosis();
    std::vector<double> sum(first->grey.begin(), first->grey.end());
    for (int i = 1; i < frames; ++i) {
        const auto frame = camera.next();
        // a film or a row of pictures that is shorter than asked for
        if (!frame && i >= 2 && !camera.live) {
            frames = i;
            break;
        }
        if (!frame) return frame.diagnosis();
        if (frame->width != first->width || frame->height != first->height)
            return no_picture("the frames are not of one size");
        if (difference(*first, *frame) > kMoved)
            return Diagnosis{Alarm::PresetterImage,
                             {},
                             {},
                             "the frames do not show the same: tool, camera or light move"};
        for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += frame->grey[k];
    }
    for (std::size_t k = 0; k < sum.size(); ++k)
        first->grey[k] = static_cast<float>(sum[k] / frames);
    return std::move(*first);
}

}  // namespace polyturn::presetter
