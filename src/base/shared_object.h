// SPDX-License-Identifier: MIT
// Keeps shared objects loaded while threads run their code.
#pragma once

namespace hrbfnpr::base {

// Keeps the shared object that contains `address` loaded until release_shared_object(), even if the host unloads it. On
// Windows it then stays loaded until the process ends. Returns NULL if no shared object contains it, or if the system
// cannot do this.
[[nodiscard]] void* hold_shared_object(const void* address) noexcept;
void release_shared_object(void* held) noexcept; // does nothing for NULL

// Keeps the shared object that contains `address` loaded until the process ends. A second call has no effect.
void keep_shared_object(const void* address) noexcept;

} // namespace hrbfnpr::base
