// SPDX-License-Identifier: MIT
// The state of the window and the commands that change it. Panels, mouse and scripts all go through here.
#pragma once

#include "export.h"
#include "frame.h"

#include <chrono>
#include <deque>

namespace viewer {

enum class Brush { off, darken, lighten, fewer, more, comb };

struct BrushSettings {
    Brush kind = Brush::off;
    float radius = 24; // pixels
    float strength = 0.35F;
};

class App {
public:
    App();

    // ---- Commands. Long work goes to the worker. The message shows a Failure.
    void load(const std::string& path);
    void load_formula(const std::string& name);
    void load_bunny();
    void use_style(const std::string& name);
    void load_settings(const std::string& path);
    void save(const std::string& path); // the format depends on the ending, see export.h
    void record(const std::string& pattern, int frames, Size size);
    void cancel();
    void reset_view();
    void set_distribution(const char* name);
    void show_patches(bool shown);
    void set_step(double step); // rho_0; 0 = the library's
    // Sets a field of the sheet, of a fit or of lines to another value: hrbfnpr_change.
    void change(const std::string& field, const std::string& value);
    // Forgets all settings of the marks but their distribution, so that the library chooses them.
    void forget_marks();
    // Call this after `choices` has changed.
    void restyle();

    // ---- The mouse on the picture, in its pixels.
    void orbit_by(double dx, double dy);
    void pan_by(double dx, double dy);
    void zoom_by(double steps);
    View* movable(); // nullptr: there is no model yet
    void moved();
    void begin_stroke();
    void paint_at(double x, double y);
    void end_stroke();
    void undo_stroke();
    void clear_paint();
    void aim_light(const Vec& in_camera);
    Vec light_in_camera() const;
    // Finds where a pixel's ray meets the surface; false if it does not.
    bool hit(double x, double y, Vec& place, Vec& normal) const;

    // ---- Called once for each frame of the window.
    void update();
    void set_canvas(Size size);
    // True if the pixels are new.
    bool draw();
    // Updates the panels from the picture, unless one of them is being used.
    void refresh_sheet();

    // ---- State
    Choices choices;
    Sheet sheet; // the values that panels show and change
    hrbfnpr_fit_desc fit;
    hrbfnpr_mesh_fit_desc mesh_fit;
    BrushSettings brush;
    std::string message; // why the last command failed; empty: it did not
    std::string said;    // what the last successful command did

    bool is_busy() const {
        return worker_.is_busy() || wants_restyle_ || restyle_at_ || load_ != nullptr || !writes_.empty();
    }
    bool is_writing() const { return is_writing_ || !writes_.empty(); }
    bool was_cancelled() const { return worker_.was_cancelled(); }
    const Worker& worker() const { return worker_; }
    const Progress& progress() const { return progress_; }
    const Scene* scene() const { return scene_.get(); }
    const Frame& frame() const { return frame_; }
    Size canvas() const { return canvas_; }
    bool patches_shown() const { return patches_shown_; }
    double bytes() const;

    double window_milliseconds = 0; // time for the last whole frame of the window, with the library's part

private:
    using Clock = std::chrono::steady_clock;
    void start_loading(std::function<Source(Work&)> open);
    void start_job();
    // Returns the choices for the window's next picture: a preview first, unless the settings choose the marks.
    Choices next_choices();
    void write(std::function<void(const Export&, Work&)> job, Size size, const std::string& done);
    void take(Scene&& scene, const Choices& made_by);
    void restyle_soon() { restyle_at_ = Clock::now() + std::chrono::milliseconds(250); }
    void fail(const std::exception& failure) { message = failure.what(); }
    View current_view() const; // call it only if there is a scene

    Context context_;
    Progress progress_; // declared before the pictures that report to it
    Worker worker_;
    std::shared_ptr<const Scene> scene_;
    Choices drawn_by_;                  // the last choices that the library could draw: those of the scene
    std::function<Source(Work&)> load_; // the load that starts next
    std::deque<std::pair<std::function<void(Work&)>, std::string>>
        writes_; // jobs, and the text for `said` when they are done
    bool wants_restyle_ = false, wants_preview_ = false, is_writing_ = false, is_restyling_ = false, is_stale_ = false,
         patches_shown_ = false, sheet_is_old_ = false;
    std::optional<Clock::time_point>
        restyle_at_;                // the time to restyle after an action in steps, such as turning a wheel
    bool settings_are_new_ = false; // settings were read and no model uses them yet, so their camera is kept
    std::optional<View> view_;      // the view that the mouse has made; empty: the library plans it
    Frame frame_;
    Size canvas_{640, 480};
    std::vector<std::size_t> strokes_; // the number of dabs before each stroke
    Vec last_dab_{};
    bool has_last_dab_ = false;
};

} // namespace viewer
