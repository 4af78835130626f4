// SPDX-License-Identifier: MIT
// The thread backend of tests that name none. The same tests run once for each backend.
#pragma once

#include <hrbfnpr.h>

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace hrbfnpr::test {

// Depends on the environment variable HRBFNPR_TEST_BACKEND: openmp, or the library's choice.
[[nodiscard]] inline std::uint32_t test_backend() {
    const char* name = std::getenv("HRBFNPR_TEST_BACKEND");
    return name != nullptr && std::string_view(name) == "openmp" ? HRBFNPR_THREAD_BACKEND_OPENMP
                                                                 : HRBFNPR_THREAD_BACKEND_AUTO;
}

} // namespace hrbfnpr::test
