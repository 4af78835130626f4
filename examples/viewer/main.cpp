// SPDX-License-Identifier: MIT
// hrbfnpr-view: a model in a window, drawn in pen and ink. README.md beside this file says how to use it.
#include "fields.h"
#include "script.h"

#include <cstdio>
#include <cstring>

namespace viewer {

namespace {

constexpr const char* usage =
    "hrbfnpr-view [FILE] [--model NAME] [--settings FILE] [--size WxH] [--screenshot OUT.png] [--script FILE]\n"
    "\n"
    "FILE holds a mesh or points (.ply, .obj, .stl, .xyz), a saved model (.hrbf) or saved marks (.hrbm).\n"
    "  --model NAME         open a built-in model: torus, linked tori, drilled cube, tangle cube, trefoil knot, heart, "
    "or none\n"
    "  --settings FILE      begin with these settings (docs/settings.md)\n"
    "  --size WxH           size of the window in pixels (1200x800)\n"
    "  --screenshot OUT.png write a picture of the window when all is drawn, and end\n"
    "  --script FILE        run the commands of this file, and end\n"
    "  --print-schema       print the fields of settings files as JSON, and end\n";

struct Options {
    std::string file, model = "torus", settings, screenshot, script;
    Size size{1200, 800};
};

Options options_of(int argc, char** argv) {
    Options options;
    const auto value = [&](int& i) {
        if (i + 1 >= argc) throw Failure(std::string(argv[i]) + " needs a value after it");
        return std::string(argv[++i]);
    };
    for (int i = 1; i < argc; ++i) {
        const std::string word = argv[i];
        if (word == "--model")
            options.model = value(i);
        else if (word == "--settings")
            options.settings = value(i);
        else if (word == "--screenshot")
            options.screenshot = value(i);
        else if (word == "--script")
            options.script = value(i);
        else if (word == "--size") {
            const std::string size = value(i);
            if (std::sscanf(size.c_str(), "%dx%d", &options.size.width, &options.size.height) != 2 ||
                options.size.width < 320 || options.size.height < 240 || options.size.width > 16384 ||
                options.size.height > 16384)
                throw Failure("--size " + size + ": give WIDTHxHEIGHT, such as 1200x800, from 320x240 to 16384x16384");
        } else if (word.size() > 1 && word[0] == '-') {
            throw Failure("there is no option " + word + "\n\n" + usage);
        } else {
            options.file = word;
        }
    }
    return options;
}

void set_up(App& app, Script& script, const Options& options) {
    if (!options.settings.empty()) app.load_settings(options.settings);
    if (!options.file.empty())
        app.load(options.file);
    else if (options.model != "none")
        app.load_formula(options.model);
    if (!options.screenshot.empty()) {
        script.add("wait");
        script.add("shot " + options.screenshot);
        script.add("wait");
    }
    if (!options.script.empty()) script.add_file(options.script);
}

void run(const Options& options) {
    Window window(options.size);
    App app;
    Ui ui;
    Script script;
    set_up(app, script, options);
    if (!app.message.empty()) throw Failure(app.message); // the settings cannot be read
    const bool scripted = !script.is_done();
    for (int quiet = 0; window.take_events(app, scripted || app.is_busy() || quiet < 3); ++quiet) {
        if (app.is_busy() || SDL_HasEvents(SDL_FIRSTEVENT, SDL_LASTEVENT) != 0) quiet = 0;
        if (scripted && !script.step(app, ui, window)) return;
        app.update();
        window.show(app, ui);
    }
}

} // namespace

} // namespace viewer

int main(int argc, char** argv) {
    try {
        if (argc == 2 && std::strcmp(argv[1], "--help") == 0)
            std::fputs(viewer::usage, stdout);
        else if (argc == 2 && std::strcmp(argv[1], "--print-schema") == 0)
            std::puts(viewer::schema_text().c_str());
        else
            viewer::run(viewer::options_of(argc, argv));
        return 0;
    } catch (const std::exception& failure) {
        std::fprintf(stderr, "hrbfnpr-view: %s\n", failure.what());
        return 1;
    }
}
