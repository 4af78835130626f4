// SPDX-License-Identifier: MIT
// A pool of scratch memory for calls on const handles. Each call takes one scratch object from the pool and returns it
// at the end, so later calls allocate nothing.
#pragma once

#include "base/runtime.h"

#include <mutex>
#include <new>
#include <utility>

namespace hrbfnpr::base {

// T is the type of the scratch objects. Each object is constructed from the Runtime. The pool grows to the largest
// number of calls that run at the same time.
template <class T>
class ScratchPool {
    struct Node {
        explicit Node(const Runtime& runtime) : value(runtime) {}
        T value;
        Node* next = nullptr;
    };

public:
    explicit ScratchPool(const Runtime& runtime) noexcept : runtime_(runtime) {}
    ScratchPool(const ScratchPool&) = delete;
    ScratchPool& operator=(const ScratchPool&) = delete;
    ~ScratchPool() {
        while (idle_ != nullptr) {
            Node* const node = std::exchange(idle_, idle_->next);
            node->~Node();
            runtime_.memory.deallocate(node, sizeof(Node));
        }
    }

    class Lease {
    public:
        explicit Lease(ScratchPool& pool) : pool_(pool), node_(pool.take()) {}
        Lease(const Lease&) = delete;
        Lease& operator=(const Lease&) = delete;
        ~Lease() { pool_.give_back(node_); }
        [[nodiscard]] T& operator*() const noexcept { return node_->value; }
        [[nodiscard]] T* operator->() const noexcept { return &node_->value; }

    private:
        ScratchPool& pool_;
        Node* node_;
    };

private:
    [[nodiscard]] Node* take() {
        {
            const std::scoped_lock lock(mutex_);
            if (idle_ != nullptr) return std::exchange(idle_, idle_->next);
        }
        void* const place = runtime_.memory.allocate(sizeof(Node));
        try {
            return new (place) Node(runtime_);
        } catch (...) {
            runtime_.memory.deallocate(place, sizeof(Node));
            throw;
        }
    }
    void give_back(Node* node) noexcept {
        const std::scoped_lock lock(mutex_);
        node->next = std::exchange(idle_, node);
    }

    const Runtime& runtime_;
    std::mutex mutex_;
    Node* idle_ = nullptr;
};

} // namespace hrbfnpr::base
