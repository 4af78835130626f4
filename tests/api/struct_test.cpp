// SPDX-License-Identifier: MIT
// Tests versioned structs that a call reads or writes: short ones of older callers, long ones of newer ones, invalid
// ones.
#include "fixture.h"

namespace api_test::struct_test {
namespace {

// A struct of a newer version: today's struct with a tail.
template <class T>
union Longer {
    T known;
    std::uint8_t bytes[sizeof(T) + 64];
    Longer() { fill(0x55); }
    void fill(int byte) { std::memset(bytes, byte, sizeof bytes); }
};

// The rules for structs that a call reads, tested with the descriptor of a context.
class ReadStruct : public testing::Test {
protected:
    hrbfnpr_status create() {
        hrbfnpr_context* context = nullptr;
        const hrbfnpr_status status = hrbfnpr_context_create(&desc.known, &context, error);
        EXPECT_EQ(context != nullptr, status == HRBFNPR_STATUS_OK);
        if (context != nullptr) {
            auto info = made(hrbfnpr_context_info_init);
            EXPECT_OK(hrbfnpr_context_get_info(context, &info, error));
            threads = info.thread_count;
        }
        hrbfnpr_context_release(context);
        return status;
    }

    Error error;
    Longer<hrbfnpr_context_desc> desc;
    std::int32_t threads = 0;
};

TEST_F(ReadStruct, AShortStructGetsDefaultsForTheRest) {
    // The size ends before thread_count. The rest is garbage that must not be read.
    EXPECT_EQ(hrbfnpr_context_desc_init(&desc.known, 8), HRBFNPR_STATUS_OK);
    desc.known.thread_count = -77;
    EXPECT_OK(create());
    EXPECT_GE(threads, 1);
    // The size includes thread_count.
    desc.known.struct_size = 16;
    desc.known.thread_count = 3;
    desc.known.flags = 0;
    EXPECT_OK(create());
    EXPECT_EQ(threads, 3);
}

TEST_F(ReadStruct, APartialPointerIsIgnored) {
    EXPECT_OK(hrbfnpr_context_desc_init(&desc.known, sizeof(hrbfnpr_context_desc)));
    std::memset(static_cast<void*>(&desc.known.log), 0x55, sizeof desc.known.log);
    desc.known.struct_size = offsetof(hrbfnpr_context_desc, log) + 4;
    EXPECT_OK(create());
}

TEST_F(ReadStruct, ALongStructIsRefusedOnlyIfItsTailIsSet) {
    EXPECT_OK(hrbfnpr_context_desc_init(&desc.known, sizeof desc));
    EXPECT_OK(create());
    for (std::size_t at = sizeof(hrbfnpr_context_desc); at < sizeof desc; ++at) {
        desc.bytes[at] = 1;
        EXPECT_FAILS(create(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                     std::string("context_desc sets fields that this library, version ") + hrbfnpr_version_string() +
                         ", does not know");
        desc.bytes[at] = 0;
    }
}

TEST_F(ReadStruct, AnUninitializedStructIsRefused) {
    for (const std::uint32_t size : {0U, 7U, 0x55555555U}) {
        desc.known.struct_size = size;
        EXPECT_FAILS(create(), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                     "context_desc.struct_size is " + std::to_string(size) + "; set up the struct with its _init");
    }
}

TEST(WriteStruct, InfosAreFilledUpToTheirSize) {
    Error error;
    const Context context = make_context(3);
    Longer<hrbfnpr_context_info> info;
    info.known.struct_size = 8;
    EXPECT_OK(hrbfnpr_context_get_info(context.get(), &info.known, error));
    EXPECT_EQ(info.known.thread_count, 3);
    EXPECT_EQ(info.bytes[8], 0x55);
    info.known.struct_size = sizeof info;
    EXPECT_OK(hrbfnpr_context_get_info(context.get(), &info.known, error));
    EXPECT_EQ(info.known.struct_size, sizeof info);
    EXPECT_GE(info.known.instruction_set, static_cast<std::uint32_t>(HRBFNPR_INSTRUCTION_SET_BASELINE));
    EXPECT_LE(info.known.instruction_set, static_cast<std::uint32_t>(HRBFNPR_INSTRUCTION_SET_NEON));
    EXPECT_EQ(info.bytes[sizeof info - 1], 0);
    info.known.struct_size = 3;
    EXPECT_FAILS(hrbfnpr_context_get_info(context.get(), &info.known, error), HRBFNPR_STATUS_UNSUPPORTED_STRUCT,
                 "context_info.struct_size is 3");
    EXPECT_FAILS(hrbfnpr_context_get_info(context.get(), nullptr, error), HRBFNPR_STATUS_INVALID_ARGUMENT,
                 "context_info is NULL");
}

// The rules for structs of results, tested with those of projections and rays, which hold arrays and a returned number.
class ResultStruct : public testing::Test {
protected:
    template <class T>
    hrbfnpr_status call(Longer<T>& result) {
        const hrbfnpr_array points = in(point);
        if constexpr (std::is_same_v<T, hrbfnpr_projection>)
            return hrbfnpr_model_project(model.get(), &points, nullptr, &result.known, nullptr, error);
        else
            return hrbfnpr_model_cast_rays(model.get(), &points, &points, nullptr, &result.known, nullptr, error);
    }

    // Makes an older caller's struct that ends before `member`. The rest is garbage.
    template <class T, class Member>
    void expect_short_one_is_kept_to(hrbfnpr_status (*init)(T*, std::uint32_t), Member T::*member) {
        Longer<T> result;
        ASSERT_OK(init(&result.known, sizeof(T)));
        const auto size =
            static_cast<std::size_t>(reinterpret_cast<const std::uint8_t*>(&(result.known.*member)) - result.bytes);
        std::memset(result.bytes + size, 0x55, sizeof result - size);
        result.known.struct_size = static_cast<std::uint32_t>(size);
        EXPECT_OK(call(result));
        for (std::size_t at = size; at < sizeof result; ++at) ASSERT_EQ(result.bytes[at], 0x55) << at;
    }

    Error error;
    Context context = make_context(1);
    Model model = fit(context, scenes::sphere_6());
    std::vector<double> point{0.0, 0.0, 0.9};
};

TEST_F(ResultStruct, FieldsBeyondAShortStructAreNotTouched) {
    expect_short_one_is_kept_to(hrbfnpr_projection_init, &hrbfnpr_projection::position);
    expect_short_one_is_kept_to(hrbfnpr_projection_init, &hrbfnpr_projection::converged);
    expect_short_one_is_kept_to(hrbfnpr_ray_hits_init, &hrbfnpr_ray_hits::count);
    expect_short_one_is_kept_to(hrbfnpr_ray_hits_init, &hrbfnpr_ray_hits::hit_rays);
}

TEST_F(ResultStruct, ALongStructIsRefusedOnlyIfItsTailIsSet) {
    Longer<hrbfnpr_projection> result;
    ASSERT_OK(hrbfnpr_projection_init(&result.known, sizeof result));
    EXPECT_OK(call(result));
    EXPECT_EQ(result.known.converged, 1);
    EXPECT_EQ(result.known.struct_size, sizeof result);
    result.known.converged = -7;
    result.bytes[sizeof(hrbfnpr_projection)] = 1;
    EXPECT_FAILS(call(result), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "projection sets fields that this library");
    EXPECT_EQ(result.known.converged, -7);
    result.known.struct_size = 3;
    EXPECT_FAILS(call(result), HRBFNPR_STATUS_UNSUPPORTED_STRUCT, "projection.struct_size is 3");
}

TEST_F(ResultStruct, AFailedCallWritesNothing) {
    Operation operation;
    hrbfnpr_operation* raw = nullptr;
    ASSERT_OK(hrbfnpr_operation_create(context.get(), &raw, error));
    operation.reset(raw);
    hrbfnpr_operation_cancel(raw);
    auto projection = made(hrbfnpr_projection_init);
    projection.converged = -7;
    const hrbfnpr_array points = in(point);
    EXPECT_EQ(hrbfnpr_model_project(model.get(), &points, nullptr, &projection, raw, error), HRBFNPR_STATUS_CANCELLED);
    EXPECT_EQ(projection.converged, -7);
    auto hits = made(hrbfnpr_ray_hits_init);
    hits.hit_rays = -7;
    EXPECT_EQ(hrbfnpr_model_cast_rays(model.get(), &points, &points, nullptr, &hits, raw, error),
              HRBFNPR_STATUS_CANCELLED);
    EXPECT_EQ(hits.hit_rays, -7);
}

TEST(Context, InstructionSetIsCapped) {
    Error error;
    hrbfnpr_context_desc desc;
    ASSERT_OK(hrbfnpr_context_desc_init(&desc, sizeof desc));
    desc.highest_instruction_set = HRBFNPR_INSTRUCTION_SET_BASELINE;
    hrbfnpr_context* raw = nullptr;
    ASSERT_OK(hrbfnpr_context_create(&desc, &raw, error));
    const Context context(raw);
    hrbfnpr_context_info info;
    ASSERT_OK(hrbfnpr_context_info_init(&info, sizeof info));
    ASSERT_OK(hrbfnpr_context_get_info(raw, &info, error));
    EXPECT_EQ(info.instruction_set, static_cast<std::uint32_t>(HRBFNPR_INSTRUCTION_SET_BASELINE));
}

} // namespace
} // namespace api_test::struct_test
