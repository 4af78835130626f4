// SPDX-License-Identifier: MIT
// What the window shows, and what can be done with it.  Panels, mouse and scripts all go through here.
#pragma once

#include "export.h"

#include <deque>

namespace viewer {

enum class Brush { off, darken, lighten, fewer, more, comb };

struct BrushSettings {
    Brush kind = Brush::off;
    float radius = 24; // pixels
    float strength = 0.35F;
};

// A recording that is under way.
struct Turntable {
    std::string pattern;
    int frames = 0, done = 0;
    Size size;
    View first;
    Renderer renderer;
};

class App {
public:
    App();

    // ---- Commands.  Long work goes to the worker; a Failure becomes the message.
    void load(const std::string& path);
    void load_formula(const std::string& name);
    void load_bunny();
    void use_preset(std::uint32_t preset);
    void load_settings(const std::string& path);
    void save(const std::string& path); // by its ending, export.h
    void record(const std::string& pattern, int frames, Size size);
    void cancel();
    void place_marks() { wants_marks_ = true; } // anew
    void redraw() { is_stale_ = true; }
    void reset_view();
    void set_distribution(std::uint32_t distribution);
    void show_patches(bool shown);
    void set_step(double step); // rho_0; 0 = the library's

    // ---- The mouse on the picture, in its pixels.
    void orbit_by(double dx, double dy);
    void pan_by(double dx, double dy);
    void zoom_by(double steps);
    void begin_stroke();
    void paint_at(double x, double y);
    void end_stroke();
    void undo_stroke();
    void clear_paint();
    void aim_light(const Vec& in_camera);
    Vec light_in_camera() const;
    // Where a pixel's ray meets the surface; false if it does not.
    bool hit(double x, double y, Vec& place, Vec& normal) const;

    // ---- Once for each frame of the window.
    void update();
    void set_canvas(Size size);
    // True if the pixels are new.
    bool draw();

    // ---- What there is.
    Settings settings;
    BrushSettings brush;
    std::string message; // of the last thing that failed; empty: none
    std::string said;    // of the last thing that was done

    bool is_busy() const {
        return worker_.is_busy() || wants_marks_ || wants_fine_ || load_ != nullptr || turntable_ != nullptr;
    }
    bool was_cancelled() const { return worker_.was_cancelled(); }
    const Worker& worker() const { return worker_; }
    const Turntable* turntable() const { return turntable_.get(); }
    const Surface* surface() const { return surface_.get(); }
    const Ink* ink() const { return ink_.get(); }
    const Frame& frame() const { return frame_; }
    Size canvas() const { return canvas_; }
    bool patches_shown() const { return patches_shown_; }
    std::vector<hrbfnpr_layer_desc>& own_layers(); // of the settings; those used become them
    // The settings with all that was chosen for this picture.
    Settings complete() const;
    double bytes() const;

    double window_milliseconds = 0; // of the last whole frame of the window, the library's part included

private:
    void start_loading(std::function<Surface(const Settings&, Work&)> open);
    void start_marks(bool coarse);
    void fail(const std::exception& failure) { message = failure.what(); }
    void record_frame();
    View* movable(); // nullptr: there is nothing to look at yet
    void moved();

    Context context_;
    Worker worker_;
    Renderer renderer_;
    std::shared_ptr<const Surface> surface_;
    std::shared_ptr<const Ink> ink_;
    std::function<Surface(const Settings&, Work&)> load_; // to be started
    bool is_loading_ = false, wants_marks_ = false, wants_fine_ = false, is_stale_ = false, patches_shown_ = false;
    bool settings_are_new_ = false; // read, and not used for a model yet: their camera and marks count
    Frame frame_;
    Size canvas_{640, 480};
    std::unique_ptr<PaintedMap> tone_;
    std::vector<std::size_t> strokes_; // numbers of dabs before each
    Vec last_dab_{};
    bool has_last_dab_ = false;
    std::unique_ptr<Turntable> turntable_;
};

} // namespace viewer
