// Several frames become one picture (toolmgmt/presetter/camera.hpp): noise goes down with their
// root, movement is refused.
#include "toolmgmt/presetter/camera.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "tests/unit/presetter/shadow_generator.hpp"
#include "toolmgmt/presetter/frame_source.hpp"
#include "toolmgmt/presetter/measure.hpp"

namespace polyturn {
namespace {

using test::picture;
using test::Scene;
using test::Wedge;

struct Shots : ::testing::Test {
    std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("polyturn-shots-" + std::to_string(::getpid()));
    Wedge wedge{-0.3, -0.3, 85, 5, 0.4};
    void SetUp() override { std::filesystem::create_directories(folder); }
    void TearDown() override { std::filesystem::remove_all(folder); }
    static std::string bytes(const presetter::ShadowImage& image) {
        std::string out;
        for (const float g : image.grey)
            out +=
                static_cast<char>(static_cast<unsigned char>(std::clamp(std::lround(g), 0L, 255L)));
        return out;
    }
    void shot(int number, const Scene& scene, const Wedge& shape) {
        std::ofstream file(folder / ("shot_" + std::to_string(number) + ".pgm"), std::ios::binary);
        file << "P5\n"
             << scene.width << " " << scene.height << "\n255\n"
             << bytes(picture(scene, [&](double z, double x) { return shape.covers(z, x); }));
    }
    std::string source() const { return "camera:" + (folder / "shot_%d.pgm").string(); }
    static double noise_in_the_light(const presetter::ShadowImage& image) {
        double sum = 0, squares = 0;
        int n = 0;
        for (int y = image.height - 60; y < image.height; ++y)
            for (int x = 0; x < 60; ++x, ++n) {
                sum += image.at(x, y);
                squares += static_cast<double>(image.at(x, y)) * image.at(x, y);
            }
        return std::sqrt(squares / n - sum / n * sum / n);
    }
};

TEST_F(Shots, BecomeOnePictureWithLessNoise) {
    for (int k = 1; k <= 8; ++k) {
        Scene scene;
        scene.noise = 8;
        scene.seed = static_cast<std::uint32_t>(k);
        shot(k, scene, wedge);
    }
    const auto one = presetter::take_picture(source(), 1),
               all = presetter::take_picture(source(), 8);
    ASSERT_TRUE(one && all) << (one ? all.diagnosis() : one.diagnosis()).text();
    EXPECT_NEAR(noise_in_the_light(*one), 8, 1.0);
    EXPECT_NEAR(noise_in_the_light(*all), 8 / std::sqrt(8.0), 0.4);
    EXPECT_TRUE(presetter::take_picture(source(), 20));  // there are only eight
}

TEST_F(Shots, AreRefusedWhenTheyDoNotShowTheSame) {
    for (int k = 0; k < 3; ++k) {
        Wedge moved = wedge;
        moved.corner_z += 0.01 * k;  // two pixels a frame
        shot(k, {}, moved);
    }
    const auto moving = presetter::take_picture(source(), 3);
    ASSERT_FALSE(moving);
    EXPECT_NE(moving.diagnosis().text().find("move"), std::string::npos)
        << moving.diagnosis().text();
    EXPECT_TRUE(presetter::take_picture(source(), 1));
    Scene small;
    small.width = 400;
    shot(1, small, wedge);
    const auto sizes = presetter::take_picture(source(), 3);
    ASSERT_FALSE(sizes);
    EXPECT_NE(sizes.diagnosis().text().find("size"), std::string::npos) << sizes.diagnosis().text();
}

TEST_F(Shots, OfACameraThatIsNotThereAreRefusedWithTheReason) {
    for (const std::string what :
         {"camera:", "camera:96", "camera:/dev/video96", "camera:nothing.avi",
          "camera:none_%02d.pgm", "camera:none_%s.pgm", "camera:http://127.0.0.1:9/none.mjpg"}) {
        const auto none = presetter::take_picture(what, 2);
        ASSERT_FALSE(none) << what;
        EXPECT_EQ(none.diagnosis().alarm, Alarm::PresetterImage) << what;
        EXPECT_NE(none.diagnosis().text().find("no picture"), std::string::npos)
            << none.diagnosis().text();
    }
}

TEST_F(Shots, OfAFilmAreReadByOpenCv) {
    Scene scene;
    std::ofstream film(folder / "film.y4m", std::ios::binary);
    film << "YUV4MPEG2 W" << scene.width << " H" << scene.height << " F25:1 Ip A1:1 Cmono\n";
    for (int k = 1; k <= 4; ++k) {
        scene.seed = static_cast<std::uint32_t>(k);
        film << "FRAME\n"
             << bytes(picture(scene, [&](double z, double x) { return wedge.covers(z, x); }));
    }
    film.close();
    const auto filmed = presetter::take_picture("camera:" + (folder / "film.y4m").string(), 4);
    if (!filmed && filmed.diagnosis().text().find("has no cameras") != std::string::npos)
        GTEST_SKIP() << "built without videoio";
    ASSERT_TRUE(filmed) << filmed.diagnosis().text();
    const auto drawn = picture(scene, [&](double z, double x) { return wedge.covers(z, x); });
    ASSERT_EQ(filmed->width, drawn.width);
    double worst = 0;
    for (std::size_t i = 0; i < drawn.grey.size(); ++i)
        worst = std::max(worst, static_cast<double>(std::fabs(filmed->grey[i] - drawn.grey[i])));
    EXPECT_LT(worst, 20);  // noise of one against the mean of four
}

}  // namespace
}  // namespace polyturn
