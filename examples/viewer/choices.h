// SPDX-License-Identifier: MIT
// The user's choices for a picture, and their descriptor. The library decides all that is left open.
#pragma once

#include "camera.h"

namespace viewer {

using SettingsHandle = std::shared_ptr<const hrbfnpr_settings>;

// A settings file (docs/settings.md). Its dabs are kept apart, so that they can be undone.
struct Settings {
    SettingsHandle handle; // may be null
    std::string text;
    std::vector<hrbfnpr_dab> dabs;
    Size size; // 0: the file has none
    bool has_camera = false;
};

Settings settings_of_text(const Context& context, const std::string& text);
Settings read_settings(const Context& context, const std::string& path);
// Returns the settings without one of their parts, such as "camera".
Settings without(const Context& context, const Settings& settings, const char* part);

struct Choices {
    Settings settings;
    std::string style; // the name of a preset; empty: the style of the settings, or the library's first choice
    double pen = 0;    // pixels; 0: depends on the picture's size
    double line_width = 0;
    double hatch_angle = 0;                                   // degrees
    std::optional<std::string> lines;                         // kinds; empty: those of the style
    std::vector<std::pair<std::string, std::string>> changes; // hrbfnpr_change: fields and their values
    Size drawn; // size of the picture that the lengths in these choices were made for; 0: no lengths
    std::vector<hrbfnpr_dab> dabs;
    Size size;               // size of pictures that are written; 0: that of the window
    bool is_preview = false; // draws only stipples, which are ready sooner than hatching

    void change(const std::string& field, const std::string& value);
    // Removes the changes whose field names have this beginning.
    void forget(const std::string& beginning);
    bool has_lengths() const { return pen > 0 || line_width > 0 || !changes.empty(); }
};

// A picture descriptor, and the data that it points to.
class Descriptor {
public:
    // camera: null means the one that the library plans.
    Descriptor(const Choices& choices, Size size, const hrbfnpr_camera* camera);
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    hrbfnpr_picture_desc desc;

private:
    Choices choices_; // the descriptor points to its texts
    std::vector<hrbfnpr_change> changes_;
    hrbfnpr_camera camera_{};
};

// Returns the name of a preset; empty if no preset has this number.
std::string preset_name(std::uint32_t preset);

} // namespace viewer
