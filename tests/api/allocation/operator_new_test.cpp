// SPDX-License-Identifier: MIT
// The standard library inside the library takes small, fixed amounts of memory from operator new. If that fails, the
// call fails cleanly, too, and gives the same result when it is made again.
#include "allocation/retry.h"
#include "stages/stages.h"

#include <cstdio>
#include <new>

namespace {

// Requests are counted while `armed`. Request `refuse_at` is refused, and with `all_later` each later one.
std::atomic<bool> armed{false};
std::atomic<bool> all_later{false};
std::atomic<std::int64_t> new_calls{0};
std::atomic<std::int64_t> refuse_at{0}; // 0: none

bool refused() {
    if (!armed) return false;
    const std::int64_t call = new_calls.fetch_add(1) + 1;
    return refuse_at > 0 && (call == refuse_at || (all_later && call > refuse_at));
}

void* allocate(std::size_t size) {
    if (refused()) throw std::bad_alloc();
    void* memory = std::malloc(size > 0 ? size : 1);
    if (memory == nullptr) throw std::bad_alloc();
    return memory;
}

} // namespace

// These replace the operators of the whole program, including the library.
void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t /*size*/) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t /*size*/) noexcept { std::free(memory); }

namespace api_test::operator_new_test {
namespace {

class NewRefusal : public Refusal {
public:
    [[nodiscard]] std::int64_t calls() const override { return new_calls; }
    void restart() override { new_calls = 0; }

protected:
    void begin() override {
        refuse_at = at;
        ::all_later = all_later;
        armed = true;
    }
    void end() override { armed = false; }
};

// Stages that only use the caller's memory make no request here.
TEST(OperatorNew, EveryRefusalInASmallRunCanBeRetried) {
    Allocator allocator;
    std::int64_t refused = 0;
    {
        const Context context = make_context(allocator_desc(allocator));
        Stages stages(context);
        NewRefusal refusal;
        for (const Stage& stage : stages.all()) {
            if (!stage.renew) { // the objects that it makes once for all later calls
                Bytes bytes;
                Error error;
                Attempt undisturbed;
                EXPECT_OK(stage.call(undisturbed, bytes, error)) << stage.name;
            }
            const std::int64_t now = refuse_and_retry(stage, refusal, 400);
            std::printf("%-24s %6lld refused\n", stage.name.c_str(), static_cast<long long>(now));
            refused += now;
            if (HasFailure()) break;
        }
    }
    EXPECT_EQ(allocator.bytes, 0);
    EXPECT_GT(refused, 100);
}

// Tests a context that starts threads, and then the build info.
TEST(OperatorNew, AFailedContextCreationGivesNoContext) {
    NewRefusal refusal;
    std::int64_t calls = 1;
    for (std::int64_t k = 1; k <= calls; ++k) {
        Error error;
        auto desc = made(hrbfnpr_context_desc_init);
        desc.thread_count = 3;
        hrbfnpr_context* context = nullptr;
        refusal.restart();
        refusal.at = k;
        const hrbfnpr_status status = refusal([&] { return hrbfnpr_context_create(&desc, &context, error); });
        calls = std::max(calls, refusal.calls() + 1);
        EXPECT_EQ(status == HRBFNPR_STATUS_OK, context != nullptr) << k;
        hrbfnpr_context_release(context);
        if (status == HRBFNPR_STATUS_OK) break;
        EXPECT_EQ(status, HRBFNPR_STATUS_OUT_OF_MEMORY) << k;
    }
    char text[4096];
    std::int64_t needed = 0;
    refusal.restart();
    refusal.at = 1;
    const hrbfnpr_status status = refusal([&] { return hrbfnpr_build_info(text, sizeof text, &needed); });
    EXPECT_EQ(status, refusal.calls() > 0 ? HRBFNPR_STATUS_OUT_OF_MEMORY : HRBFNPR_STATUS_OK);
}

} // namespace
} // namespace api_test::operator_new_test
