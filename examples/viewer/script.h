// SPDX-License-Identifier: MIT
// Runs commands in place of a user, for tests and pictures. examples/viewer/README.md lists them.
#pragma once

#include "window.h"

#include <deque>

namespace viewer {

class Script {
public:
    void add(const std::string& line) { commands_.push_back(line); }
    void add_file(const std::string& path);

    // Called before each frame: runs the commands that are due. Returns false at the end.
    bool step(App& app, Ui& ui, Window& window);
    bool is_done() const { return commands_.empty() && mouse_.empty(); }

private:
    bool run(const std::vector<std::string>& words, App& app, Ui& ui, Window& window);
    void drag(const std::vector<std::string>& words, const Ui& ui);
    void report(const App& app) const;
    void measure_turn(App& app);

    std::deque<std::string> commands_;
    std::deque<ScriptedMouse> mouse_; // one per frame, like a hand's
    int idle_frames_ = 0, turning_ = 0, turned_ = 0;
    double window_sum_ = 0, library_sum_ = 0;
};

} // namespace viewer
