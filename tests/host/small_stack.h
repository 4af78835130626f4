// SPDX-License-Identifier: MIT
// A thread whose stack is as small as a host makes it, and a measure of what was used of it.
#pragma once

#include <cstddef>
#include <functional>

namespace host_test {

// Runs `work` on a thread with a stack of `size` bytes, below which lies a page that no one may touch.  Returns how
// many bytes were used, the thread library's own included.  Passes on what `work` throws.
std::size_t run_on_a_stack_of(std::size_t size, const std::function<void()>& work);

} // namespace host_test
