// SPDX-License-Identifier: MIT
#include "script.h"

#include <cstdio>
#include <fstream>
#include <iomanip>
#include <sstream>

namespace viewer {

namespace {

// Splits a line into words. Quotes keep blanks inside a word.
std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> words;
    std::istringstream stream(line);
    for (std::string word; stream >> std::quoted(word);) words.push_back(word);
    return words;
}

std::string rest_of(const std::vector<std::string>& words, std::size_t first = 1) {
    std::string text;
    for (std::size_t i = first; i < words.size(); ++i) text += (i > first ? " " : "") + words[i];
    return text;
}

int number(const std::vector<std::string>& words, std::size_t i) {
    try {
        return std::stoi(words.at(i));
    } catch (const std::exception&) {
        throw Failure(rest_of(words, 0) + ": word " + std::to_string(i + 1) + " must be a whole number");
    }
}

Brush brush_of(const std::string& name) {
    static const char* const names[] = {"off", "darken", "lighten", "fewer", "more", "comb"};
    for (int i = 0; i < 6; ++i)
        if (name == names[i]) return static_cast<Brush>(i);
    throw Failure("there is no brush " + name + "; choose off, darken, lighten, fewer, more or comb");
}

} // namespace

void Script::add_file(const std::string& path) {
    std::ifstream file(path);
    if (!file) throw Failure(path + ": cannot be opened; check the name");
    for (std::string line; std::getline(file, line);)
        if (!line.empty() && line[0] != '#') add(line);
}

bool Script::step(App& app, Ui& ui, Window& window) {
    if (!mouse_.empty()) {
        window.mouse = mouse_.front();
        mouse_.pop_front();
        return true;
    }
    if (window.mouse) window.mouse->wheel = 0;
    if (turning_ > 0) {
        measure_turn(app);
        return true;
    }
    if (commands_.empty()) {
        if (app.is_writing()) return true;
        if (!app.message.empty()) throw Failure("at the end: " + app.message);
        return false;
    }
    const std::string& next = commands_.front();
    const bool looks_on = next.rfind("wait", 0) == 0 || next == "cancel";
    if (app.is_writing() && !looks_on) return true; // the next command waits until the file is written
    const bool may_fail = next == "wait" || next.rfind("expect", 0) == 0 || next.rfind("shot", 0) == 0;
    if (!app.message.empty() && !may_fail) throw Failure("before `" + commands_.front() + "`: " + app.message);
    // A command that has to wait runs again in the next frame.
    if (run(split(commands_.front()), app, ui, window)) commands_.pop_front();
    return true;
}

void Script::drag(const std::vector<std::string>& words, const Ui& ui) {
    constexpr int steps = 12;
    const std::string which = words.size() > 5 ? words[5] : "left";
    const int button = which == "left" ? 0 : which == "right" ? 1 : 2;
    const float left = ui.canvas_min.x, top = ui.canvas_min.y;
    const auto at = [&](int i, bool down) {
        const auto between = [&](std::size_t k) {
            return static_cast<float>(number(words, k) + (number(words, k + 2) - number(words, k)) * i / steps);
        };
        ScriptedMouse mouse{left + between(1), top + between(2)};
        mouse.down[button] = down;
        return mouse;
    };
    mouse_.push_back(at(0, false));
    for (int i = 0; i <= steps; ++i) mouse_.push_back(at(i, true));
    mouse_.push_back(at(steps, false));
}

bool Script::run(const std::vector<std::string>& words, App& app, Ui& ui, Window& window) {
    if (words.empty()) return true;
    const std::string& name = words[0];
    const std::string text = rest_of(words);
    if (name == "wait") { // waits for three frames without work under way
        idle_frames_ = app.is_busy() ? 0 : idle_frames_ + 1;
        if (idle_frames_ < 3) return false;
        idle_frames_ = 0;
        return true;
    }
    if (name == "wait-busy") return app.worker().is_busy();
    if (name == "load")
        app.load(text);
    else if (name == "model")
        app.load_formula(text);
    else if (name == "style")
        app.use_style(text);
    else if (name == "change")
        app.change(words.at(1), words.at(2));
    else if (name == "settings")
        app.load_settings(text);
    else if (name == "save")
        app.save(text);
    else if (name == "drag")
        drag(words, ui);
    else if (name == "wheel") {
        ScriptedMouse mouse{ui.canvas_min.x + 20, ui.canvas_min.y + 20};
        mouse.wheel = static_cast<float>(number(words, 1));
        mouse_.push_back(mouse);
    } else if (name == "drop") {
        SDL_Event event{};
        event.type = SDL_DROPFILE;
        event.drop.file = SDL_strdup(text.c_str());
        SDL_PushEvent(&event);
    } else if (name == "open")
        ui.open_panels.assign(words.begin() + 1, words.end());
    else if (name == "brush")
        app.brush.kind = brush_of(text);
    else if (name == "published")
        app.set_distribution(text == "off" ? "blue_noise" : "published");
    else if (name == "patches")
        app.show_patches(text != "off");
    else if (name == "step")
        app.set_step(0.01 * number(words, 1) * app.scene()->patches.estimate);
    else if (name == "record")
        app.record(words.at(1), number(words, 2), {number(words, 3), number(words, 4)});
    else if (name == "size")
        app.choices.size = {number(words, 1), number(words, 2)};
    else if (name == "window")
        window.resize({number(words, 1), number(words, 2)});
    else if (name == "cancel")
        app.cancel();
    else if (name == "undo")
        app.undo_stroke();
    else if (name == "shot")
        window.take_screenshot(text);
    else if (name == "report")
        report(app);
    else if (name == "turn")
        turning_ = number(words, 1), turned_ = 0, window_sum_ = library_sum_ = 0;
    else if (name == "expect") {
        if (app.message.find(text) == std::string::npos)
            throw Failure("`" + text + "` is not in the message \"" + app.message + "\"");
        app.message.clear();
    } else if (name == "expect-cancelled") {
        if (!app.was_cancelled()) throw Failure("the last job was not cancelled");
    } else {
        throw Failure("there is no command " + name + "; README.md lists the commands");
    }
    return true;
}

// Orbits for `turning_` frames and times them: each call adds the time of the frame before.
void Script::measure_turn(App& app) {
    if (turned_ > 0) {
        window_sum_ += app.window_milliseconds;
        library_sum_ += app.frame().draw_milliseconds + app.frame().raster_milliseconds;
    }
    if (turned_++ == turning_) {
        std::printf("frame: window %.2f ms, library %.2f ms of it, mean of %d at %d x %d\n", window_sum_ / turning_,
                    library_sum_ / turning_, turning_, app.frame().size.width, app.frame().size.height);
        turning_ = 0;
        return;
    }
    app.orbit_by(8, turned_ % 2 == 0 ? 1 : -1);
}

void Script::report(const App& app) const {
    if (app.scene() == nullptr) throw Failure("there is nothing to report on; load a model first");
    const Scene& scene = *app.scene();
    for (const auto& layer : scene.layers())
        std::printf("layer: %s %lld marks %lld strokes\n", layer.name, static_cast<long long>(layer.marks),
                    static_cast<long long>(layer.strokes));
    for (const Timing& timing : scene.timings)
        std::printf("stage: %s %.1f ms\n", timing.stage.c_str(), timing.milliseconds);
    const double *low = scene.info.bounds_min, *high = scene.info.bounds_max;
    std::printf("bounds: %.3f %.3f %.3f to %.3f %.3f %.3f\n", low[0], low[1], low[2], high[0], high[1], high[2]);
    std::printf("dabs: %d\n", static_cast<int>(app.choices.dabs.size()));
    std::printf("rho_0: %.9g estimate %.9g\n", scene.sheet.marks.initial_step, scene.patches.estimate);
}

} // namespace viewer
