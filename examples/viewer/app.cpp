// SPDX-License-Identifier: MIT
#include "app.h"

#include "fields.h"

#include <algorithm>
#include <fstream>

namespace viewer {

App::App()
    : fit(defaults<hrbfnpr_fit_desc>(hrbfnpr_fit_desc_init)),
      mesh_fit(defaults<hrbfnpr_mesh_fit_desc>(hrbfnpr_mesh_fit_desc_init)),
      context_(
          make<hrbfnpr_context>(hrbfnpr_context_release,
                                [](auto** out, auto* error) { return hrbfnpr_context_create(nullptr, out, error); })),
      worker_(context_, progress_) {
    fit.normal_mode = HRBFNPR_NORMALS_AUTO;
}

// ---- Models

void App::start_loading(std::function<Source(Work&)> open) {
    worker_.cancel();
    load_ = std::move(open);
    wants_restyle_ = false;
    message.clear();
}

void App::load(const std::string& path) {
    start_loading([path](Work& work) { return source_of_file(path, work); });
}

void App::load_formula(const std::string& name) {
    start_loading([name](Work& work) { return source_of_formula(name, work); });
}

void App::load_bunny() {
    for (const char* const path : {".cache/bunny-1.0.1.obj", HRBFNPR_VIEW_BUNNY}) {
        if (!std::ifstream(path)) continue;
        load(path);
        return;
    }
    message = "the bunny is not installed; run scripts/fetch_bunny in the sources of hrbfnpr";
}

// ---- Choices

void App::restyle() {
    wants_restyle_ = true;
    if (choices.has_lengths() && choices.drawn.width == 0) choices.drawn = canvas_;
}

void App::change(const std::string& field, const std::string& value) {
    choices.change(field, value);
    const bool is_of_fit = field.rfind("fit.", 0) == 0 || field.rfind("mesh_fit.", 0) == 0;
    if (!is_of_fit) restyle();
}

void App::use_style(const std::string& name) {
    choices.style = name;
    choices.lines.reset();
    choices.forget("style.");
    wants_preview_ = true;
    restyle();
}

void App::set_distribution(const char* name) {
    choices.change("marks.distribution", name);
    use_style(scene_ ? preset_name(scene_->info.preset) : choices.style);
}

void App::forget_marks() {
    const bool is_published = sheet.marks.distribution == HRBFNPR_DISTRIBUTION_PUBLISHED;
    choices.forget("marks.");
    choices.settings = without(context_, choices.settings, "marks");
    choices.change("marks.distribution", is_published ? "published" : "blue_noise");
    restyle();
}

void App::show_patches(bool shown) {
    patches_shown_ = shown;
    is_stale_ = true;
    if (shown) restyle();
}

void App::set_step(double step) { change("marks.initial_step", decimals(step)); }

void App::load_settings(const std::string& path) {
    try {
        const Settings read = read_settings(context_, path);
        choices = Choices();
        choices.settings = read;
        choices.dabs = read.dabs;
        choices.size = read.size;
        strokes_.clear();
        settings_are_new_ = scene_ == nullptr || load_ != nullptr || worker_.is_busy();
        if (read.has_camera) view_.reset();
        if (scene_) restyle();
        said = "read the settings of " + path;
    } catch (const Failure& failure) {
        fail(failure);
    }
}

// ---- Files

void App::write(std::function<void(const Export&, Work&)> job, Size size, const std::string& done) {
    if (!scene_) throw Failure("there is nothing to save yet; open a model first");
    const Export what{*scene_, choices, view_, size};
    writes_.emplace_back([job = std::move(job), what](Work& work) { job(what, work); }, done);
}

void App::save(const std::string& path) {
    try {
        check_ending(path);
        write([path](const Export& what, Work& work) { write_export(what, path, work); },
              choices.size.width > 0 ? choices.size : canvas_, "wrote " + path);
    } catch (const Failure& failure) {
        fail(failure);
    }
}

void App::record(const std::string& pattern, int frames, Size size) {
    try {
        if (frames < 1 || frames > 10000) throw Failure("a turntable must have 1 to 10000 frames");
        numbered(pattern, 0); // throws the Failure for a bad pattern now
        write([=](const Export& what, Work& work) { write_turntable(what, pattern, frames, work); }, size,
              "wrote " + std::to_string(frames) + " frames");
    } catch (const Failure& failure) {
        fail(failure);
    }
}

void App::cancel() {
    worker_.cancel();
    wants_restyle_ = wants_preview_ = false;
    restyle_at_.reset();
    writes_.clear();
}

// ---- Work

void App::take(Scene&& scene, const Choices& made_by) {
    scene_ = std::make_shared<const Scene>(std::move(scene));
    drawn_by_ = made_by;
    drawn_by_.is_preview = false;
    is_stale_ = sheet_is_old_ = true;
}

Choices App::next_choices() {
    Choices next = choices;
    const bool says_marks = choices.style.empty() && choices.settings.handle;
    next.is_preview = wants_preview_ && !says_marks;
    wants_restyle_ = next.is_preview;
    wants_preview_ = false;
    return next;
}

void App::start_job() {
    const Size size = canvas_;
    const auto made = std::make_shared<Scene>();
    if (load_) {
        if (!settings_are_new_) { // drops the settings of the previous model
            choices.settings = without(context_, choices.settings, "camera");
            choices.forget("marks.initial_step");
        }
        settings_are_new_ = false;
        wants_preview_ = true;
        view_.reset();
        const Choices with = next_choices();
        worker_.start(
            [made, size, with, open = std::move(load_)](Work& work) { *made = scene_of(open(work), with, size, work); },
            [this, made, with](Work&) { take(std::move(*made), with); });
        load_ = nullptr;
        if (patches_shown_) wants_restyle_ = true; // the restyled scene has the squares
    } else if (!writes_.empty()) {
        const auto [job, done] = writes_.front();
        writes_.pop_front();
        is_writing_ = true;
        worker_.start(job, [this, what = done](Work&) { said = what; });
    } else if (wants_restyle_ && scene_) {
        is_restyling_ = true;
        const Choices with = next_choices();
        worker_.start([made, size, with, from = scene_, view = view_, patches = patches_shown_](
                          Work& work) { *made = restyled(*from, with, size, view ? &*view : nullptr, patches, work); },
                      [this, made, with](Work&) { take(std::move(*made), with); });
    }
}

void App::update() {
    try {
        worker_.poll();
    } catch (const std::exception& failure) {
        fail(failure);
        if (is_restyling_) { // choices that cannot be drawn are taken back
            choices = drawn_by_;
            sheet_is_old_ = true;
        }
    }
    if (restyle_at_ && Clock::now() >= *restyle_at_) {
        restyle_at_.reset();
        wants_restyle_ = true;
    }
    if (worker_.is_busy()) return;
    is_writing_ = is_restyling_ = false;
    if (!scene_ && !load_) wants_restyle_ = false; // there is nothing to draw
    start_job();
}

void App::refresh_sheet() {
    if (!sheet_is_old_ || wants_restyle_) return;
    sheet = scene_->sheet;
    sheet_is_old_ = false;
}

void App::set_canvas(Size size) {
    if (size.width == canvas_.width && size.height == canvas_.height) return;
    canvas_ = size;
    is_stale_ = true;
    if (scene_) restyle_soon();
}

View App::current_view() const {
    const double* const up = scene_->info.up;
    return view_ ? *view_ : view_by(scene_->camera, scene_->centre(), {up[0], up[1], up[2]});
}

bool App::draw() {
    if (!scene_ || !is_stale_) return false;
    is_stale_ = false;
    try {
        frame_.wants_depth = patches_shown_;
        draw_frame(frame_, *scene_, camera_of(current_view(), canvas_));
        return true;
    } catch (const Failure& failure) {
        fail(failure);
        return false;
    }
}

double App::bytes() const {
    auto info = defaults<hrbfnpr_context_info>(hrbfnpr_context_info_init);
    checked([&](auto* error) { return hrbfnpr_context_get_info(context_.get(), &info, error); });
    return static_cast<double>(info.bytes_now);
}

// ---- The mouse

View* App::movable() {
    if (!scene_) return nullptr;
    if (!view_) view_ = current_view();
    take_over(*view_);
    return &*view_;
}

void App::moved() {
    enclose(*view_, scene_->centre(), 0.5 * scene_->diagonal());
    is_stale_ = true;
}

void App::orbit_by(double dx, double dy) {
    View* const view = movable();
    if (view == nullptr) return;
    orbit(*view, -0.008 * dx, 0.008 * dy);
    moved();
}

void App::pan_by(double dx, double dy) {
    View* const view = movable();
    if (view == nullptr) return;
    pan(*view, dx / canvas_.height, -dy / canvas_.height);
    moved();
}

void App::zoom_by(double steps) {
    View* const view = movable();
    if (view == nullptr) return;
    const double factor = std::pow(1.1, steps), far = length(view->eye - view->target) / scene_->diagonal();
    const bool is_flat = view->vertical_angle == 0;
    const double size = (is_flat ? view->view_height / scene_->diagonal() : far) / factor;
    if ((size < 0.005 && factor > 1) || (size > 200 && factor < 1)) return; // outside this range nothing can be seen
    zoom(*view, factor);
    moved();
    restyle_soon(); // the number of marks depends on their size
}

void App::reset_view() {
    if (!scene_) return;
    view_.reset();
    restyle();
}

Vec App::light_in_camera() const {
    const double* const l = sheet.style.light;
    const Vec light = unit({l[0], l[1], l[2]});
    if (sheet.style.light_space == HRBFNPR_LIGHT_CAMERA || !scene_) return light;
    return to_camera(camera_of(current_view(), canvas_), light);
}

void App::aim_light(const Vec& in_camera) {
    Vec light = unit(in_camera);
    if (sheet.style.light_space == HRBFNPR_LIGHT_WORLD && scene_)
        light = to_world(camera_of(current_view(), canvas_), light);
    std::copy(light.begin(), light.end(), sheet.style.light);
    change("style.light", text_of(field_of("hrbfnpr_style", "light"), &sheet.style));
}

bool App::hit(double x, double y, Vec& place, Vec& normal) const {
    if (!scene_ || !frame_.drawing) return false;
    const auto [origin, direction] = ray_of(frame_.camera, x, y);
    const std::vector<Vec> from{origin}, along{direction};
    const hrbfnpr_array origins = view_of(from), directions = view_of(along);
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < scene_->parts.size(); ++i) {
        if (scene_->parts[i].model == nullptr) continue;
        Vec at{}, facing{};
        auto desc = defaults<hrbfnpr_cast_desc>(hrbfnpr_cast_desc_init);
        desc.lipschitz = scene_->lipschitz[i];
        desc.smallest_step = 1e-3;
        auto hits = defaults<hrbfnpr_ray_hits>(hrbfnpr_ray_hits_init);
        hits.position = {&at, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        hits.normal = {&facing, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
        Error error;
        const auto status =
            hrbfnpr_model_cast_rays(scene_->parts[i].model, &origins, &directions, &desc, &hits, nullptr, error);
        const double distance = dot(at - origin, direction);
        if (status != HRBFNPR_STATUS_OK || hits.hit_rays != 1 || distance >= nearest) continue;
        nearest = distance;
        place = at;
        normal = facing;
    }
    return std::isfinite(nearest);
}

// ---- The brush

void App::begin_stroke() {
    strokes_.push_back(choices.dabs.size());
    has_last_dab_ = false;
}

void App::paint_at(double x, double y) {
    Vec place, normal;
    if (brush.kind == Brush::off || !hit(x, y, place, normal)) return;
    auto dab = defaults<hrbfnpr_dab>(hrbfnpr_dab_init);
    dab.radius = static_cast<double>(brush.radius) * units_per_pixel(frame_.camera, place);
    dab.strength = static_cast<double>(brush.strength);
    // Dabs a third of the brush radius apart make an even stroke.
    if (has_last_dab_ && length(place - last_dab_) < 0.35 * dab.radius) return;
    const Vec way = place - last_dab_;
    const bool has_way = has_last_dab_;
    last_dab_ = place;
    has_last_dab_ = true;
    std::copy(place.begin(), place.end(), dab.position);
    std::copy(normal.begin(), normal.end(), dab.normal);
    if (brush.kind == Brush::comb) {
        if (!has_way) return; // the first dab of a stroke has no direction
        const Vec direction = unit(way - dot(way, normal) * normal);
        dab.map = HRBFNPR_DAB_DIRECTION;
        std::copy(direction.begin(), direction.end(), dab.direction);
    } else {
        const bool is_tone = brush.kind == Brush::darken || brush.kind == Brush::lighten;
        dab.map = is_tone ? HRBFNPR_DAB_TONE : HRBFNPR_DAB_DENSITY;
        dab.value = brush.kind == Brush::lighten || brush.kind == Brush::more ? 1 : 0;
    }
    choices.dabs.push_back(dab);
    if (dab.map == HRBFNPR_DAB_TONE) restyle(); // other maps change the marks, so they wait for end_stroke()
}

void App::end_stroke() {
    if (!strokes_.empty() && strokes_.back() < choices.dabs.size()) restyle();
}

void App::undo_stroke() {
    if (strokes_.empty()) return;
    choices.dabs.resize(std::min(choices.dabs.size(), strokes_.back()));
    strokes_.pop_back();
    restyle();
}

void App::clear_paint() {
    choices.dabs.clear();
    strokes_.clear();
    restyle();
}

} // namespace viewer
