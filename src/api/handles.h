// SPDX-License-Identifier: MIT
// Reference-counted handles in the context's memory.  Each keeps its context alive, so that
// handles can be released in any order.
#pragma once

#include "base/runtime.h"
#include "base/scratch_pool.h"
#include "output/raster/raster.h"
#include "output/vertex/vertices.h"

#include <hrbfnpr.h>

#include <atomic>
#include <cstdint>
#include <new>
#include <utility>

namespace hrbfnpr::api {

class Counted {
public:
    Counted() noexcept = default;
    Counted(const Counted&) = delete;
    Counted& operator=(const Counted&) = delete;

    void add_reference() const noexcept { references_.fetch_add(1, std::memory_order_relaxed); }
    // Returns true if this was the last reference.
    [[nodiscard]] bool remove_reference() const noexcept {
        return references_.fetch_sub(1, std::memory_order_acq_rel) == 1;
    }

    // If the caller holds the only reference, no other thread can add one at the same time.
    [[nodiscard]] bool has_one_reference() const noexcept { return references_.load(std::memory_order_acquire) == 1; }

protected:
    ~Counted() = default;

private:
    mutable std::atomic<std::int64_t> references_{1};
};

// Working memory for the calls that read a drawing. These take a const handle, and may run on several threads at once.
struct DrawingScratch {
    explicit DrawingScratch(const base::Runtime& runtime) noexcept : rasters(runtime), vertices(runtime) {}

    base::ScratchPool<output::Raster> rasters;
    base::ScratchPool<output::VertexScratch> vertices;
};

} // namespace hrbfnpr::api

struct hrbfnpr_context : hrbfnpr::api::Counted {
    explicit hrbfnpr_context(const hrbfnpr_context_desc& desc);
    ~hrbfnpr_context() = default;

    hrbfnpr::base::AllocateFn allocate; // the allocator for the context itself; NULL: the default allocator
    hrbfnpr::base::DeallocateFn deallocate;
    void* allocator_user;
    hrbfnpr::base::Runtime runtime;
    mutable hrbfnpr::api::DrawingScratch drawing_scratch{runtime};
};

namespace hrbfnpr::api {

void release_context(const hrbfnpr_context* context) noexcept; // NULL is ignored.

class Child : public Counted {
public:
    explicit Child(hrbfnpr_context& context) noexcept : context_(&context) { context.add_reference(); }
    ~Child() { release_context(context_); }

    [[nodiscard]] hrbfnpr_context& context() const noexcept { return *context_; }
    [[nodiscard]] const base::Runtime& runtime() const noexcept { return context_->runtime; }

private:
    hrbfnpr_context* context_;
};

// Makes an object of type T with one reference.
template <class T, class... Arguments>
[[nodiscard]] T* make_handle(hrbfnpr_context& context, Arguments&&... arguments) {
    base::Memory& memory = context.runtime.memory;
    void* place = memory.allocate(sizeof(T));
    try {
        return new (place) T(context, std::forward<Arguments>(arguments)...);
    } catch (...) {
        memory.deallocate(place, sizeof(T));
        throw;
    }
}

// Removes a reference. If it was the last one, destroys the object. NULL is ignored.
template <class T>
void release_handle(const T* handle) noexcept {
    if (handle == nullptr || !handle->remove_reference()) return;
    const hrbfnpr_context& context = handle->context();
    context.add_reference(); // The context must outlive the memory of the object.
    handle->~T();
    context.runtime.memory.deallocate(const_cast<T*>(handle), sizeof(T));
    release_context(&context);
}

// Keeps an object alive while a call uses it.
template <class T>
class HandleHold {
public:
    explicit HandleHold(T* handle) noexcept : handle_(handle) {
        if (handle_ != nullptr) handle_->add_reference();
    }
    ~HandleHold() { release_handle(handle_); }
    HandleHold(const HandleHold&) = delete;
    HandleHold& operator=(const HandleHold&) = delete;

private:
    T* handle_;
};

} // namespace hrbfnpr::api
