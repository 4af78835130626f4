// SPDX-License-Identifier: MIT
// Tests that a call of the library fails cleanly when the caller's allocator refuses memory: it keeps no memory, and
// called again with the same objects it gives the same bits as without a refusal.
#include "allocation/retry.h"
#include "stages/stages.h"

#include <array>
#include <cstdio>

namespace api_test::retry_test {
namespace {

class AllocatorRefusal : public Refusal {
public:
    explicit AllocatorRefusal(Allocator& allocator) : allocator_(allocator) {}
    [[nodiscard]] std::int64_t calls() const override { return calls_; }
    void restart() override { calls_ = 0; }

protected:
    void begin() override {
        before_ = allocator_.calls;
        allocator_.refuse_at = at > calls_ ? before_ + at - calls_ : 0;
        allocator_.refuse_after = all_later;
    }
    void end() override {
        calls_ += allocator_.calls - before_;
        allocator_.refuse_at = 0;
        allocator_.refuse_after = false;
    }

private:
    Allocator& allocator_;
    std::int64_t before_ = 0, calls_ = 0;
};

// The groups of stages are separate tests, to run at the same time. The last group has the stages of no other group.
constexpr std::array<const char*, 7> groups{"fit", "orient", "mesh", "marks", "lines", "frame", ""};

std::string group_of(const Stage& stage) {
    for (const std::string group : groups)
        if (!group.empty() && stage.name.rfind(group, 0) == 0) return group;
    return "";
}

// Tests every stage of a group. A refused stage leaves no more memory behind than the same stage undisturbed.
void refuse_in_every_stage(const std::string& group, const StageSizes& sizes, std::int32_t threads,
                           std::int64_t at_most) {
    Allocator allocator;
    std::int64_t refused = 0;
    {
        const Context context = make_context(allocator_desc(allocator, threads));
        Stages stages(context, sizes);
        AllocatorRefusal refusal(allocator);
        for (const Stage& stage : stages.all()) {
            if (group_of(stage) != group) continue;
            if (stage.renew) stage.renew();
            Bytes bytes;
            Error error;
            EXPECT_OK(stage.call(refusal, bytes, error)) << stage.name;
            if (stage.renew) stage.renew();
            const std::int64_t before = allocator.bytes;
            const std::int64_t now = refuse_and_retry(stage, refusal, at_most);
            std::printf("%-24s %6lld refused\n", stage.name.c_str(), static_cast<long long>(now));
            refused += now;
            if (stage.renew) stage.renew();
            EXPECT_EQ(allocator.bytes, before) << stage.name;
            if (testing::Test::HasFailure()) break;
        }
    }
    EXPECT_EQ(allocator.bytes, 0);
    EXPECT_GE(refused, std::min<std::int64_t>(at_most, 11));
    testing::Test::RecordProperty("refused", static_cast<int>(refused));
    std::printf("%lld calls for memory refused\n", static_cast<long long>(refused));
}

class Retry : public testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Stages, Retry, testing::ValuesIn(groups));

// Each stage of marks has hundreds of similar refusals, each with a run of its own, so only about 120 of each are
// tested.
TEST_P(Retry, EveryRefusalInASmallRunCanBeRetried) {
    refuse_in_every_stage(GetParam(), {}, 1, std::string(GetParam()) == "marks" ? 120 : 100000);
}

TEST_P(Retry, SomeRefusalsInALargerRunCanBeRetried) {
    StageSizes sizes;
    sizes.samples = 500;
    sizes.dense_samples = 3000;
    sizes.half_samples = 1500;
    sizes.cloud = 100;
    sizes.marks = 8000;
    sizes.places = 9000;
    sizes.pixels = 400;
    sizes.mesh_around = 80;
    refuse_in_every_stage(GetParam(), sizes, 1, 6);
}

// The context and the operation are made before all stages.
TEST(Allocation, FailedCreationsGiveNoHandles) {
    for (std::int64_t k = 1;; ++k) {
        Error error;
        Allocator allocator;
        allocator.refuse_at = k;
        const hrbfnpr_context_desc desc = allocator_desc(allocator, 3);
        hrbfnpr_context* context = nullptr;
        hrbfnpr_operation* operation = nullptr;
        hrbfnpr_status status = hrbfnpr_context_create(&desc, &context, error);
        EXPECT_EQ(context != nullptr, status == HRBFNPR_STATUS_OK);
        if (context != nullptr) status = hrbfnpr_operation_create(context, &operation, error);
        EXPECT_EQ(operation != nullptr, status == HRBFNPR_STATUS_OK);
        hrbfnpr_operation_release(operation);
        hrbfnpr_context_release(context);
        EXPECT_EQ(allocator.bytes, 0) << k;
        if (status == HRBFNPR_STATUS_OK) {
            EXPECT_GT(k, 2);
            return;
        }
        EXPECT_FAILS(status, HRBFNPR_STATUS_OUT_OF_MEMORY, "bytes");
    }
}

} // namespace
} // namespace api_test::retry_test
