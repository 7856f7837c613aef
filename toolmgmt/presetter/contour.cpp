#include "toolmgmt/presetter/contour.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

namespace polyturn::presetter {
namespace {

constexpr double kLeastContrast = 60;  // grey values
constexpr double kLeastShare = 0.005;  // of the picture, shadow or light
constexpr double kMostBlur = 3.5;      // pixels
constexpr double kSmoothing = 1.0;     // pixels, against noise, before edges are looked for
constexpr int kReach = 9;              // pixels to both sides of an edge
constexpr double kStep = 0.25;
constexpr int kMargin = kReach + 2;  // points nearer to the border are not measured

Diagnosis refused(std::string why) {
    return Diagnosis{Alarm::PresetterImage, {}, {}, std::move(why)};
}

double sample(const cv::Mat& image, double x, double y) {
    const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
    if (x0 < 0 || y0 < 0 || x0 + 1 >= image.cols || y0 + 1 >= image.rows) return std::nan("");
    const double u = x - x0, v = y - y0;
    const float* a = image.ptr<float>(y0) + x0;
    const float* b = image.ptr<float>(y0 + 1) + x0;
    return (a[0] * (1 - u) + a[1] * u) * (1 - v) + (b[0] * (1 - u) + b[1] * u) * v;
}

double median(std::vector<float>& values) {
    if (values.empty()) return 0;
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

// Mean grey of shadow and light, each by its median, and the noise of the light.
bool levels(const cv::Mat& grey, const cv::Mat& shadow, double& dark, double& light,
            double& noise) {
    std::vector<float> in, out;
    for (int y = 0; y < grey.rows; y += 2)
        for (int x = 0; x < grey.cols; x += 2)
            (shadow.at<std::uint8_t>(y, x) ? in : out).push_back(grey.at<float>(y, x));
    if (in.empty() || out.empty()) return false;
    dark = median(in);
    light = median(out);
    for (float& one : out) one = std::fabs(one - static_cast<float>(light));
    noise = 1.4826 * median(out);
    return true;
}

// The place on the gradient through (x, y) where the grey crosses `half`, and how far the edge is
// spread there.
bool refine(const cv::Mat& grey, const cv::Mat& gx, const cv::Mat& gy, double half, double contrast,
            Point& p, double& spread) {
    double nx = sample(gx, p.x, p.y), ny = sample(gy, p.x, p.y);
    const double length = std::hypot(nx, ny);
    if (!(length > 1e-3)) return false;
    nx /= length;
    ny /= length;
    double before = std::nan(""), where = std::nan(""), first = std::nan(""), last = std::nan("");
    double low = std::nan(""), high = std::nan("");
    for (double t = -kReach; t <= kReach; t += kStep) {
        const double g = sample(grey, p.x + t * nx, p.y + t * ny);
        if (std::isnan(g)) return false;
        const auto crosses = [&](double level) { return before < level && g >= level; };
        if (crosses(half) && (std::isnan(where) || std::fabs(t) < std::fabs(where)))
            where = t - kStep * (g - half) / (g - before);
        if (crosses(half - 0.34 * contrast))
            low = t - kStep * (g - (half - 0.34 * contrast)) / (g - before);
        if (crosses(half + 0.34 * contrast) && std::isnan(high))
            high = t - kStep * (g - (half + 0.34 * contrast)) / (g - before);
        if (std::isnan(first)) first = g;
        last = g;
        before = g;
    }
    if (std::isnan(where) || last - first < 0.6 * contrast) return false;
    // 16 to 84 %: two standard deviations
    spread =
        !std::isnan(low) && !std::isnan(high) && high > low ? (high - low) / 2.0 : std::nan("");
    p.x += where * nx;
    p.y += where * ny;
    return true;
}

}  // namespace

Result<Contour> find_contour(const ShadowImage& image) {
    const cv::Mat raw(image.height, image.width, CV_32F, const_cast<float*>(image.grey.data()));
    cv::Mat grey, eight, shadow, gx, gy;
    cv::GaussianBlur(raw, grey, cv::Size(), kSmoothing, kSmoothing, cv::BORDER_REPLICATE);
    grey.convertTo(eight, CV_8U);
    cv::threshold(eight, shadow, 0, 255, cv::THRESH_BINARY_INV | cv::THRESH_OTSU);
    Contour out;
    double dark = 0, light = 0;
    const double share = cv::countNonZero(shadow) / static_cast<double>(shadow.total());
    if (!levels(raw, shadow, dark, light, out.noise) || share < kLeastShare ||
        share > 1 - kLeastShare)
        return refused("it is empty: there is no shadow beside light");
    out.contrast = light - dark;
    if (out.contrast < kLeastContrast)
        return refused("it is empty, or has too little contrast (" +
                       std::to_string(static_cast<int>(out.contrast)) + " grey values)");
    const double half = (dark + light) / 2;
    shadow = grey < half;
    std::vector<std::vector<cv::Point>> all;
    cv::findContours(shadow, all, cv::RETR_EXTERNAL, cv::CHAIN_APPROX_NONE);
    const auto largest = std::max_element(all.begin(), all.end(), [](const auto& a, const auto& b) {
        return cv::contourArea(a) < cv::contourArea(b);
    });
    if (largest == all.end() ||
        cv::contourArea(*largest) < kLeastShare * static_cast<double>(shadow.total()))
        return refused("it is empty: there is only dirt in it");
    const auto inside = [&](const cv::Point& p) {
        return p.x >= kMargin && p.y >= kMargin && p.x < image.width - kMargin &&
               p.y < image.height - kMargin;
    };
    // Begin behind the border, so that what is inside stays in one piece.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < largest->size(); ++i)
        if (!inside((*largest)[i])) {
            out.at_border = true;
            begin = i;
        }
    std::size_t best = 0;
    std::vector<cv::Point> piece, longest;
    for (std::size_t k = 1; k <= largest->size(); ++k) {
        const cv::Point& p = (*largest)[(begin + k) % largest->size()];
        if (inside(p)) {
            piece.push_back(p);
            if (k < largest->size()) continue;
        }
        if (piece.size() > best) {
            best = piece.size();
            longest = piece;
        }
        piece.clear();
    }
    cv::Sobel(grey, gx, CV_32F, 1, 0, 5);
    cv::Sobel(grey, gy, CV_32F, 0, 1, 5);
    std::vector<float> spreads;
    for (const cv::Point& p : longest) {
        Point fine{static_cast<double>(p.x), static_cast<double>(p.y)};
        double spread = 0;
        if (!refine(grey, gx, gy, half, out.contrast, fine, spread)) continue;
        out.points.push_back(fine);
        spreads.push_back(std::isnan(spread) ? static_cast<float>(kReach)
                                             : static_cast<float>(spread));
    }
    if (out.points.size() < 0.5 * static_cast<double>(longest.size()) || out.points.size() < 100)
        return refused("it is blurred or the edge is not to be followed: only " +
                       std::to_string(out.points.size()) + " of " + std::to_string(longest.size()) +
                       " places of the edge are sharp");
    out.blur = median(spreads);
    if (out.blur > kMostBlur)
        return refused("it is blurred: the edge is spread over " +
                       std::to_string(static_cast<int>(std::lround(4 * out.blur))) + " pixels");
    return out;
}

}  // namespace polyturn::presetter
