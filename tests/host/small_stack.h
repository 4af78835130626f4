// SPDX-License-Identifier: MIT
// Runs work on a thread with a small stack, as hosts have, and measures how much of the stack is used.
#pragma once

#include <cstddef>
#include <functional>

namespace host_test {

// Runs `work` on a thread with a stack of `size` bytes, below which lies a protected page. Returns how many bytes were
// used, including those of the thread library. Passes on what `work` throws.
std::size_t run_on_a_stack_of(std::size_t size, const std::function<void()>& work);

} // namespace host_test
