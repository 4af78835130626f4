// SPDX-License-Identifier: MIT
// What the user chose for a picture, and its descriptor.  What is left open is up to the library.
#pragma once

#include "camera.h"

namespace viewer {

using SettingsHandle = std::shared_ptr<const hrbfnpr_settings>;

// A file of settings (docs/settings.md).  Its dabs are taken out, so that they can be taken back.
struct Settings {
    SettingsHandle handle; // may be null
    std::string text;
    std::vector<hrbfnpr_dab> dabs;
    Size size; // 0: the file has none
    bool has_camera = false;
};

Settings settings_of_text(const Context& context, const std::string& text);
Settings read_settings(const Context& context, const std::string& path);
// The same without one of its parts, such as "camera".
Settings without(const Context& context, const Settings& settings, const char* part);

struct Choices {
    Settings settings;
    std::string style; // the name of a preset; empty: the style of the settings, or the library's first choice
    double pen = 0;    // pixels; 0: by the picture's size
    double line_width = 0;
    double hatch_angle = 0;                                   // degrees
    std::optional<std::string> lines;                         // kinds; else those of the style
    std::vector<std::pair<std::string, std::string>> changes; // hrbfnpr_change: fields and their values
    Size drawn; // the picture that the lengths among these were chosen for; 0: there are none
    std::vector<hrbfnpr_dab> dabs;
    Size size;               // of pictures that are written; 0: as in the window
    bool is_preview = false; // stipples alone, which are there sooner than hatching

    void change(const std::string& field, const std::string& value);
    // Forgets the changes whose fields begin so.
    void forget(const std::string& beginning);
    bool has_lengths() const { return pen > 0 || line_width > 0 || !changes.empty(); }
};

// A descriptor of a picture with what it points to.
class Descriptor {
public:
    // camera: null is the one that the library plans.
    Descriptor(const Choices& choices, Size size, const hrbfnpr_camera* camera);
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    hrbfnpr_picture_desc desc;

private:
    Choices choices_; // whose texts the descriptor points to
    std::vector<hrbfnpr_change> changes_;
    hrbfnpr_camera camera_{};
};

// The name of a preset; empty: there is none of this number.
std::string preset_name(std::uint32_t preset);

} // namespace viewer
