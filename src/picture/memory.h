// SPDX-License-Identifier: MIT
// The standard library's containers in the context's memory.
#pragma once

#include "base/memory.h"

#include <memory_resource>
#include <string>
#include <vector>

namespace hrbfnpr::picture {

// A Pool makes std::pmr containers take their memory from the context, which counts it. They fail with
// Error{out_of_memory}. The Memory must outlive the Pool, and the Pool must outlive its containers.
class Pool : public std::pmr::memory_resource {
public:
    explicit Pool(base::Memory& memory) noexcept : memory_(&memory) {}
    [[nodiscard]] base::Memory& memory() const noexcept { return *memory_; }

private:
    void* do_allocate(std::size_t bytes, std::size_t /*alignment*/) override { return memory_->allocate(bytes); }
    void do_deallocate(void* memory, std::size_t bytes, std::size_t /*alignment*/) override {
        memory_->deallocate(memory, bytes);
    }
    [[nodiscard]] bool do_is_equal(const std::pmr::memory_resource& other) const noexcept override {
        const auto* pool = dynamic_cast<const Pool*>(&other);
        return pool != nullptr && pool->memory_ == memory_;
    }

    base::Memory* memory_;
};

template <class T>
using Vector = std::pmr::vector<T>;
using String = std::pmr::string;

} // namespace hrbfnpr::picture
