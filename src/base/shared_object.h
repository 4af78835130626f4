// SPDX-License-Identifier: MIT
// Shared objects that must stay while threads run in their code.
#pragma once

namespace hrbfnpr::base {

// Holds the shared object that `address` lies in: unloaded by the host, it stays until release().
// NULL if it is none, or the system cannot.
[[nodiscard]] void* hold_shared_object(const void* address) noexcept;
void release_shared_object(void* held) noexcept; // NULL is ignored

// The same for as long as the process lives.  A second time changes nothing.
void keep_shared_object(const void* address) noexcept;

} // namespace hrbfnpr::base
