// SPDX-License-Identifier: MIT
// Records the calls of a progress callback, and says when to cancel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <thread>
#include <vector>

namespace hrbfnpr::test {

struct Watcher {
    std::vector<double> values;     // the progress values in the order of the calls
    double cancel_at = 2.0;         // cancels from this progress on; above 1: never
    std::size_t cancel_at_call = 0; // number of the call that cancels, from 1; 0: none
    bool other_thread = false;      // whether a call came on another thread than the one that made the watcher

    // For hrbfnpr_operation_set_callback and base::Operation::set_callback, with the watcher as `user`.
    static std::int32_t call(void* user, double progress) {
        auto& self = *static_cast<Watcher*>(user);
        self.values.push_back(progress);
        self.other_thread = self.other_thread || std::this_thread::get_id() != self.maker_;
        return progress >= self.cancel_at || self.values.size() == self.cancel_at_call ? 1 : 0;
    }

private:
    std::thread::id maker_ = std::this_thread::get_id();
};

} // namespace hrbfnpr::test
