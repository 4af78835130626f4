// SPDX-License-Identifier: MIT
// The standard library inside takes small, fixed amounts of memory from operator new; when that
// fails, the call fails cleanly, too.
#include "fixture.h"

#include <new>

namespace {

// Counts while armed; the k-th call is refused.
std::atomic<std::int64_t> new_calls{0};
std::atomic<std::int64_t> refuse_at{-1}; // -1: not armed

void* allocate(std::size_t size) {
    if (refuse_at >= 0 && new_calls.fetch_add(1) + 1 == refuse_at) throw std::bad_alloc();
    void* memory = std::malloc(size > 0 ? size : 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

} // namespace

// Replaces the whole program's, the library's among them.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace api_test {
namespace {

// Runs call() with the k-th allocation refused, for every k until it succeeds.
template <class F>
std::int64_t refuse_each(F&& call) {
    for (std::int64_t k = 1;; ++k) {
        new_calls = 0;
        refuse_at = k;
        const hrbfnpr_status status = call();
        refuse_at = -1;
        if (new_calls < k) {
            EXPECT_EQ(status, HRBFNPR_STATUS_OK);
            return k - 1;
        }
        EXPECT_EQ(status, HRBFNPR_STATUS_OUT_OF_MEMORY) << k;
    }
}

TEST(OperatorNew, FailuresAreCleanAndLeakNothing) {
    Allocator allocator;
    Error error;
    const Context context = make_context(allocator_desc(allocator));
    const scenes::Samples samples = scenes::sphere_6();
    const hrbfnpr_fit_desc desc = fit_desc(samples);
    Generation generate_desc = small_desc(HRBFNPR_DISTRIBUTION_PUBLISHED);
    std::int64_t refused = refuse_each([&] {
        hrbfnpr_model* model = nullptr;
        const hrbfnpr_status status = hrbfnpr_model_fit(context.get(), &desc, nullptr, &model, error);
        hrbfnpr_model_release(model);
        return status;
    });
    const Model model = fit(context, samples);
    const std::int64_t bytes = allocator.bytes;
    refused += refuse_each([&] {
        hrbfnpr_point_set* set = nullptr;
        const hrbfnpr_status status =
            hrbfnpr_point_set_generate(context.get(), model.get(), generate_desc.get(), nullptr, &set, error);
        hrbfnpr_point_set_release(set);
        return status;
    });
    EXPECT_EQ(allocator.bytes, bytes);
    refused += refuse_each([&] {
        hrbfnpr_renderer* renderer = nullptr;
        const hrbfnpr_status status = hrbfnpr_renderer_create(context.get(), &renderer, error);
        hrbfnpr_renderer_release(renderer);
        return status;
    });
    EXPECT_EQ(allocator.bytes, bytes);
    refused += refuse_each([&] {
        std::int64_t needed = 0;
        char text[4096];
        return hrbfnpr_build_info(text, sizeof text, &needed);
    });
    EXPECT_GT(refused, 0);
}

} // namespace
} // namespace api_test
