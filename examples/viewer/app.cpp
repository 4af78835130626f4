// SPDX-License-Identifier: MIT
#include "app.h"

#include <algorithm>
#include <fstream>

namespace viewer {

namespace {

constexpr double first_angle = 0.5235987755982988; // 30 degrees
const Vec first_azimuth_elevation{30, 20, 0};      // degrees, as of the command line

Renderer new_renderer(const Context& context) {
    return make<hrbfnpr_renderer>(hrbfnpr_renderer_release, [&](auto** out, auto* error) {
        return hrbfnpr_renderer_create(context.get(), out, error);
    });
}

// From the eye into the scene: azimuth 0 looks from the front, which is +z, or -y where z is up.
Vec first_direction(const Vec& up) {
    const double degree = 0.017453292519943295;
    Vec front = std::abs(up[2]) < 0.9 ? Vec{0, 0, 1} : Vec{0, -1, 0};
    front = unit(front - dot(front, up) * up);
    const double around = degree * first_azimuth_elevation[0], above = degree * first_azimuth_elevation[1];
    const Vec eye =
        std::cos(above) * (std::cos(around) * front + std::sin(around) * cross(up, front)) + std::sin(above) * up;
    return -1.0 * eye;
}

View first_view(const Surface& surface, Size size) {
    return view_of_all(surface.places, first_direction(surface.up), surface.up, first_angle,
                       static_cast<double>(size.width) / std::max(size.height, 1));
}

} // namespace

App::App()
    : context_(
          make<hrbfnpr_context>(hrbfnpr_context_release,
                                [](auto** out, auto* error) { return hrbfnpr_context_create(nullptr, out, error); })),
      worker_(context_), renderer_(new_renderer(context_)),
      tone_(std::make_unique<PaintedMap>(settings.paint, Map::tone)) {}

void App::start_loading(std::function<Surface(const Settings&, Work&)> open) {
    worker_.cancel();
    load_ = std::move(open);
    wants_fine_ = false;
    message.clear();
}

void App::load(const std::string& path) {
    start_loading([path](const Settings& with, Work& work) { return surface_of_file(path, with, work); });
}

void App::load_formula(const std::string& name) {
    start_loading([name](const Settings& with, Work& work) { return surface_of_formula(name, with, work); });
}

void App::load_bunny() {
    for (const char* const path : {".cache/bunny-1.0.1.obj", HRBFNPR_VIEW_BUNNY}) {
        if (!std::ifstream(path)) continue;
        load(path);
        return;
    }
    message = "the bunny is not here: scripts/fetch_bunny of the library's sources brings it to .cache";
}

void App::use_preset(std::uint32_t preset) {
    const auto distribution = settings.marks.distribution;
    set_preset(settings, preset);
    if (distribution == HRBFNPR_DISTRIBUTION_PUBLISHED) draw_as_published(settings.style, preset);
    wants_marks_ = true;
}

void App::set_distribution(std::uint32_t distribution) {
    settings.marks.distribution = distribution;
    use_preset(settings.preset);
}

void App::show_patches(bool shown) {
    patches_shown_ = shown;
    is_stale_ = true;
    if (shown) wants_marks_ = true;
}

void App::set_step(double step) {
    settings.marks.initial_step = step;
    wants_marks_ = true;
}

void App::load_settings(const std::string& path) {
    try {
        Settings read = read_settings(path);
        if (!read.view) read.view = settings.view;
        settings = std::move(read);
        tone_ = std::make_unique<PaintedMap>(settings.paint, Map::tone);
        strokes_.clear();
        settings_are_new_ = surface_ == nullptr || load_ != nullptr || is_loading_;
        wants_marks_ = wants_marks_ || surface_ != nullptr;
        said = "settings of " + path;
    } catch (const Failure& failure) {
        fail(failure);
    }
}

Settings App::complete() const {
    Settings result = settings;
    if (result.size.width == 0) result.size = canvas_;
    if (ink_) result.layers = ink_->made;
    return result;
}

void App::save(const std::string& path) {
    try {
        if (!ink_) throw Failure("there is nothing to save yet");
        const Settings with = complete();
        const Renderer fresh = new_renderer(context_); // what it writes does not depend on frames before
        write_export({context_, fresh, *surface_, *ink_, with, *tone_, with.size}, path);
        said = "wrote " + path;
    } catch (const Failure& failure) {
        fail(failure);
    }
}

void App::cancel() {
    worker_.cancel();
    wants_marks_ = wants_fine_ = false;
    if (turntable_) said = "recording ended after " + std::to_string(turntable_->done) + " frames";
    turntable_.reset();
}

void App::update() {
    try {
        worker_.poll();
    } catch (const std::exception& failure) {
        fail(failure);
    }
    if (!worker_.is_busy()) is_loading_ = false;
    if (load_ && !worker_.is_busy()) {
        is_loading_ = true;
        if (!settings_are_new_) {
            settings.view.reset();
            settings.layers.clear();
            settings.marks.initial_step = 0;
            settings.paint.clear();
            strokes_.clear();
            tone_ = std::make_unique<PaintedMap>(settings.paint, Map::tone);
        }
        settings_are_new_ = false;
        auto surface = std::make_shared<Surface>();
        worker_.start([surface, open = std::move(load_), with = settings](Work& work) { *surface = open(with, work); },
                      [this, surface](Work&) {
                          surface_ = surface;
                          ink_.reset();
                          if (!settings.view) settings.view = first_view(*surface_, canvas_);
                          wants_marks_ = true;
                      });
        load_ = nullptr;
    }
    if (wants_marks_ && surface_ && !is_loading_) {
        if (worker_.is_busy())
            worker_.cancel(); // what it makes is not wanted any more
        else
            start_marks(has_hatching(settings));
    } else if (wants_fine_ && !worker_.is_busy()) {
        start_marks(false);
    }
    if (!surface_ && !worker_.is_busy()) wants_marks_ = false;
    if (turntable_ && ink_) record_frame();
}

void App::start_marks(bool coarse) {
    wants_marks_ = wants_fine_ = false;
    if (!settings.view) settings.view = first_view(*surface_, canvas_);
    const Size size = settings.size.width > 0 ? settings.size : canvas_;
    auto ink = std::make_shared<Ink>();
    worker_.start([ink, surface = surface_, with = settings, size, coarse, patches = patches_shown_](
                      Work& work) { *ink = ink_of(*surface, with, size, patches, coarse, work); },
                  [this, ink, coarse](Work&) {
                      ink_ = ink;
                      is_stale_ = true;
                      wants_fine_ = coarse;
                  });
}

std::vector<hrbfnpr_layer_desc>& App::own_layers() {
    if (settings.layers.empty() && ink_) settings.layers = ink_->layers;
    return settings.layers;
}

void App::set_canvas(Size size) {
    if (size.width == canvas_.width && size.height == canvas_.height) return;
    // What was in the picture stays in it when that gets narrow.
    const auto room = [](Size of) { return std::min(1.0, static_cast<double>(of.width) / std::max(of.height, 1)); };
    if (surface_ && settings.view && !settings.view->view && room(size) != room(canvas_)) {
        zoom(*settings.view, room(size) / room(canvas_));
        moved();
    }
    canvas_ = size;
    is_stale_ = true;
}

bool App::draw() {
    if (!is_stale_ || !ink_) return false;
    is_stale_ = false;
    try {
        frame_.wants_depth = patches_shown_; // they are hidden by what is before them
        draw_frame(frame_, renderer_, *surface_, *ink_, settings, *tone_, canvas_);
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

// ---- Turntable

void App::record(const std::string& pattern, int frames, Size size) {
    try {
        if (!ink_ || !settings.view) throw Failure("there is nothing to record yet");
        if (frames < 1 || frames > 10000) throw Failure("a turntable has 1 to 10000 frames");
        numbered(pattern, 0); // or a Failure now
        turntable_ = std::make_unique<Turntable>();
        *turntable_ = {pattern, frames, 0, size, *settings.view, new_renderer(context_)};
    } catch (const Failure& failure) {
        fail(failure);
    }
}

void App::record_frame() {
    Turntable& turn = *turntable_;
    try {
        Settings with = complete();
        with.view = turn.first;
        orbit(*with.view, 6.283185307179586 * turn.done / turn.frames, 0);
        write_export({context_, turn.renderer, *surface_, *ink_, with, *tone_, turn.size},
                     numbered(turn.pattern, turn.done));
        if (++turn.done < turn.frames) return;
        said = "wrote " + std::to_string(turn.frames) + " frames";
    } catch (const Failure& failure) {
        fail(failure);
    }
    turntable_.reset();
}

// ---- The mouse

View* App::movable() {
    if (!surface_ || !settings.view) return nullptr;
    if (settings.view->view) settings.view->target = surface_->centre(); // matrices have none
    return &*settings.view;
}

void App::moved() {
    const Surface& surface = *surface_;
    enclose(*settings.view, surface.centre(), 0.5 * surface.diagonal());
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
    const double factor = std::pow(1.1, steps), far = length(view->eye - view->target) / surface_->diagonal();
    const bool is_flat = view->vertical_angle == 0;
    const double size = (is_flat ? view->view_height / surface_->diagonal() : far) / factor;
    if ((size < 0.005 && factor > 1) || (size > 200 && factor < 1)) return; // farther there is nothing to see
    zoom(*view, factor);
    moved();
}

void App::reset_view() {
    if (!surface_) return;
    settings.view = first_view(*surface_, canvas_);
    is_stale_ = true;
}

Vec App::light_in_camera() const {
    const double* const l = settings.style.fields.light;
    const Vec light = unit({l[0], l[1], l[2]});
    if (settings.style.fields.light_space == HRBFNPR_LIGHT_CAMERA || !settings.view) return light;
    return to_camera(camera_of(*settings.view, canvas_), light);
}

void App::aim_light(const Vec& in_camera) {
    Vec light = unit(in_camera);
    if (settings.style.fields.light_space == HRBFNPR_LIGHT_WORLD && settings.view)
        light = to_world(camera_of(*settings.view, canvas_), light);
    std::copy(light.begin(), light.end(), settings.style.fields.light);
    is_stale_ = true;
}

bool App::hit(double x, double y, Vec& place, Vec& normal) const {
    if (!surface_ || !surface_->model || !ink_ || !frame_.drawing) return false;
    const auto [origin, direction] = ray_of(frame_.camera, x, y);
    const std::vector<Vec> from{origin}, along{direction};
    const hrbfnpr_array origins = view_of(from), directions = view_of(along);
    auto desc = defaults<hrbfnpr_cast_desc>(hrbfnpr_cast_desc_init);
    desc.lipschitz = surface_->lipschitz;
    desc.smallest_step = 1e-3;
    auto hits = defaults<hrbfnpr_ray_hits>(hrbfnpr_ray_hits_init);
    hits.position = {&place, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    hits.normal = {&normal, 1, 0, HRBFNPR_SCALAR_FLOAT64, 3};
    Error error;
    const auto status =
        hrbfnpr_model_cast_rays(surface_->model.get(), &origins, &directions, &desc, &hits, nullptr, error);
    return status == HRBFNPR_STATUS_OK && hits.hit_rays == 1;
}

void App::begin_stroke() {
    strokes_.push_back(settings.paint.size());
    has_last_dab_ = false;
}

void App::paint_at(double x, double y) {
    Dab dab;
    if (brush.kind == Brush::off || !hit(x, y, dab.position, dab.normal)) return;
    dab.radius = brush.radius * units_per_pixel(frame_.camera, dab.position);
    dab.strength = brush.strength;
    // Dabs a third of the brush apart make an even stroke.
    if (has_last_dab_ && length(dab.position - last_dab_) < 0.35 * dab.radius) return;
    const Vec way = dab.position - last_dab_;
    const bool has_way = has_last_dab_;
    last_dab_ = dab.position;
    has_last_dab_ = true;
    if (brush.kind == Brush::comb) {
        if (!has_way) return; // one place has no direction
        dab.map = Map::direction;
        dab.direction = unit(way - dot(way, dab.normal) * dab.normal);
    } else {
        dab.map = brush.kind == Brush::darken || brush.kind == Brush::lighten ? Map::tone : Map::density;
        dab.value = brush.kind == Brush::lighten || brush.kind == Brush::more ? 1 : 0;
    }
    settings.paint.push_back(dab);
    if (dab.map == Map::tone) tone_ = std::make_unique<PaintedMap>(settings.paint, Map::tone);
    is_stale_ = true;
}

void App::end_stroke() {
    const std::size_t first = strokes_.empty() ? 0 : strokes_.back();
    if (first < settings.paint.size() && settings.paint.back().map != Map::tone) wants_marks_ = true;
}

void App::undo_stroke() {
    if (strokes_.empty()) return;
    settings.paint.resize(std::min(settings.paint.size(), strokes_.back()));
    strokes_.pop_back();
    tone_ = std::make_unique<PaintedMap>(settings.paint, Map::tone);
    wants_marks_ = is_stale_ = true;
}

void App::clear_paint() {
    settings.paint.clear();
    strokes_.clear();
    tone_ = std::make_unique<PaintedMap>(settings.paint, Map::tone);
    wants_marks_ = is_stale_ = true;
}

} // namespace viewer
