// polyturn-presetter: measures a picture and says what it found as one JSON line; it writes no
// offset. `polyturn presetter` asks it.
//
// X and Z are told as offsets, from the tip to the seat (X as a radius): that is what the offset
// table wants.
//
//   polyturn-presetter calibrate IMAGE --diameter 6 --x 50 --z 30 --save FILE [--mirrored]
//   polyturn-presetter measure IMAGE --calibration FILE
//   polyturn-presetter measure camera:0 --frames 8 --calibration FILE
//
// Exit status: 0 measured; 1 refused, the reason as a diagnosis in the JSON; 2 wrong usage.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "ipc/diagnosis/display_language.hpp"
#include "toolmgmt/presetter/camera.hpp"
#include "toolmgmt/presetter/measure.hpp"

namespace {

using namespace polyturn;
using Json = nlohmann::json;

int say(const Json& json, int status) {
    std::printf("%s\n", json.dump(-1, ' ', false, Json::error_handler_t::replace).c_str());
    return status;
}

int refuse(const Diagnosis& diagnosis) {
    return say(
        {{"ok", false},
         {"number", std::string(alarm_number(diagnosis.alarm, Dialect::Polyturn))},
         {"text", text_in(diagnosis, display_language_now())},
         {"remedy", std::string(alarm_text(diagnosis.alarm, display_language_now()).remedy)}},
        1);
}

double rounded(double mm) { return std::round(mm * 1e5) / 1e5; }

}  // namespace

int main(int argc, char** argv) {
    CLI::App app{"Measures the picture of a tool's shadow"};
    app.require_subcommand(1);
    std::string image, file;
    int frames = presetter::kFrames;
    presetter::GaugePin pin;
    CLI::App* calibrate =
        app.add_subcommand("calibrate", "Finds scale, tilt and place with a gauge pin");
    calibrate
        ->add_option("IMAGE", image,
                     "PGM or BMP; - is standard input; camera:0 and the like (camera.hpp)")
        ->required();
    calibrate->add_option("--diameter", pin.diameter_mm, "of the pin, mm")->required();
    calibrate->add_option("--error", pin.error_mm,
                          "standard uncertainty of the diameter, mm; default 0.0005");
    calibrate
        ->add_option("--x", pin.x_mm,
                     "X offset that the middle of the pin's end has, mm, as a radius")
        ->required();
    calibrate->add_option("--z", pin.z_mm, "Z offset of it, mm")->required();
    calibrate->add_flag("--mirrored", pin.mirrored, "the right of the picture is -Z");
    calibrate->add_option("--save", file, "where the calibration goes")->required();
    CLI::App* measure = app.add_subcommand("measure", "X, Z, nose radius, tip number and angles");
    measure
        ->add_option("IMAGE", image,
                     "PGM or BMP; - is standard input; camera:0 and the like (camera.hpp)")
        ->required();
    measure->add_option("--calibration", file, "what calibrate has saved")->required();
    for (CLI::App* one : {calibrate, measure})
        one->add_option("--frames", frames, "of a camera, put together to one picture")
            ->check(CLI::Range(1, presetter::kMostFrames));
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) { return app.exit(error) == 0 ? 0 : 2; }
    const auto picture = presetter::is_camera(image) ? presetter::take_picture(image, frames)
                                                     : presetter::read_image(image);
    if (!picture) return refuse(picture.diagnosis());
    if (calibrate->parsed()) {
        // where it stands, seen from the seat
        pin.x_mm = -pin.x_mm;
        pin.z_mm = -pin.z_mm;
        const auto found = presetter::calibrate(*picture, pin);
        if (!found) return refuse(found.diagnosis());
        if (const auto kept = presetter::write_calibration(file, *found); !kept)
            return refuse(kept.diagnosis());
        return say({{"ok", true},
                    {"um_per_pixel", found->mm_per_pixel * 1000},
                    {"tilt_deg", found->tilt_rad * 57.29577951308232},
                    {"scale_error", found->scale_error}},
                   0);
    }
    const auto calibration = presetter::read_calibration(file);
    if (!calibration) return refuse(calibration.diagnosis());
    const auto m = presetter::measure(*picture, *calibration);
    if (!m) return refuse(m.diagnosis());
    return say({{"ok", true},
                {"X", rounded(-m->x_mm)},
                {"Z", rounded(-m->z_mm)},
                {"R", rounded(m->radius_mm)},
                {"T", m->tip},
                {"edges_deg", {m->edge_deg[0], m->edge_deg[1]}},
                {"included_deg", m->included_deg},
                {"X_error", m->x_error_mm},
                {"Z_error", m->z_error_mm},
                {"R_error", m->radius_error_mm},
                {"angle_error_deg", m->angle_error_deg},
                {"blur_pixels", m->blur_pixels},
                {"deviation", m->deviation_mm},
                {"outliers", m->outliers}},
               0);
}
