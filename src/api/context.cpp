// SPDX-License-Identifier: MIT
#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/fields.h"
#include "api/handles.h"
#include "base/parallel_openmp.h"

using namespace hrbfnpr;

static_assert(static_cast<std::int32_t>(base::LogLevel::debug) == HRBFNPR_LOG_DEBUG);
static_assert(static_cast<std::int32_t>(base::LogLevel::info) == HRBFNPR_LOG_INFO);
static_assert(static_cast<std::int32_t>(base::LogLevel::warning) == HRBFNPR_LOG_WARNING);
static_assert(static_cast<std::uint32_t>(base::ThreadBackend::automatic) == HRBFNPR_THREAD_BACKEND_AUTO);
static_assert(static_cast<std::uint32_t>(base::ThreadBackend::pool) == HRBFNPR_THREAD_BACKEND_POOL);
static_assert(static_cast<std::uint32_t>(base::ThreadBackend::openmp) == HRBFNPR_THREAD_BACKEND_OPENMP);
static_assert(static_cast<std::uint32_t>(base::ThreadBackend::run_tasks) == HRBFNPR_THREAD_BACKEND_RUN_TASKS);
static_assert(static_cast<std::uint32_t>(base::ThreadBackend::serial) == HRBFNPR_THREAD_BACKEND_SERIAL);
static_assert(static_cast<std::uint32_t>(base::InstructionSet::baseline) == HRBFNPR_INSTRUCTION_SET_BASELINE);
static_assert(static_cast<std::uint32_t>(base::InstructionSet::avx2) == HRBFNPR_INSTRUCTION_SET_AVX2);
static_assert(static_cast<std::uint32_t>(base::InstructionSet::avx512) == HRBFNPR_INSTRUCTION_SET_AVX512);
static_assert(static_cast<std::uint32_t>(base::InstructionSet::neon) == HRBFNPR_INSTRUCTION_SET_NEON);

namespace {

base::Parallel make_parallel(const hrbfnpr_context_desc& desc) {
    switch (desc.thread_backend) {
    case HRBFNPR_THREAD_BACKEND_OPENMP: return base::Parallel::openmp(desc.thread_count);
    case HRBFNPR_THREAD_BACKEND_SERIAL: return {};
    default: return {desc.thread_count, desc.run_tasks, desc.run_tasks_user};
    }
}

} // namespace

hrbfnpr_context::hrbfnpr_context(const hrbfnpr_context_desc& desc)
    : allocate(desc.allocate), deallocate(desc.deallocate), allocator_user(desc.allocator_user),
      runtime(desc.allocate, desc.deallocate, desc.allocator_user, make_parallel(desc),
              static_cast<base::InstructionSet>(desc.highest_instruction_set), desc.log, desc.log_user,
              static_cast<base::LogLevel>(desc.log_level)) {}

namespace hrbfnpr::api {

namespace {

using Context = hrbfnpr_context_desc;

constexpr auto context_fields() noexcept {
    return FieldTable{field("abi_version", &Context::abi_version, rule::Any{}),
                      field("thread_count", &Context::thread_count, rule::not_negative),
                      field("flags", &Context::flags, rule::Zero{}),
                      field("thread_backend", &Context::thread_backend,
                            rule::OneOf{HRBFNPR_THREAD_BACKEND_SERIAL, "HRBFNPR_THREAD_BACKEND_*"}),
                      field("highest_instruction_set", &Context::highest_instruction_set,
                            rule::OneOf{HRBFNPR_INSTRUCTION_SET_NEON, "HRBFNPR_INSTRUCTION_SET_*"}),
                      field("allocate", &Context::allocate, rule::Any{}),
                      field("deallocate", &Context::deallocate, rule::Any{}),
                      field("allocator_user", &Context::allocator_user, rule::Any{}),
                      field("log", &Context::log, rule::Any{}),
                      field("log_user", &Context::log_user, rule::Any{}),
                      field("log_level", &Context::log_level, rule::OneOf{HRBFNPR_LOG_WARNING, "HRBFNPR_LOG_*"}),
                      reserved("reserved", &Context::reserved),
                      field("run_tasks", &Context::run_tasks, rule::Any{}),
                      field("run_tasks_user", &Context::run_tasks_user, rule::Any{})};
}
static_assert(context_fields().covers<Context>());

} // namespace

template <>
hrbfnpr_context_desc defaults() noexcept {
    hrbfnpr_context_desc desc{};
    desc.abi_version = HRBFNPR_ABI_VERSION;
    return desc;
}

template <>
hrbfnpr_context_info defaults() noexcept {
    return {};
}

namespace {

void check_backend(const hrbfnpr_context_desc& desc) {
    const bool hosted = desc.run_tasks != nullptr;
    if (desc.thread_backend == HRBFNPR_THREAD_BACKEND_RUN_TASKS) Checks("context_desc").not_null("run_tasks", hosted);
    if (hosted && desc.thread_backend != HRBFNPR_THREAD_BACKEND_AUTO &&
        desc.thread_backend != HRBFNPR_THREAD_BACKEND_RUN_TASKS)
        fail(Status::invalid_argument,
             "context_desc.thread_backend is %u, but run_tasks is given; set thread_backend to AUTO or RUN_TASKS, or "
             "run_tasks to NULL",
             desc.thread_backend);
    if (desc.thread_backend == HRBFNPR_THREAD_BACKEND_OPENMP && !base::openmp_is_built_in())
        fail(Status::invalid_argument,
             "context_desc.thread_backend is OPENMP, but this library was built without OpenMP; use POOL or AUTO");
}

void check(const hrbfnpr_context_desc& desc) {
    if (desc.abi_version != HRBFNPR_ABI_VERSION)
        fail(Status::version_mismatch,
             "context_desc.abi_version is %u, but the library's is %d; build with the library's header, and call "
             "hrbfnpr_context_desc_init",
             desc.abi_version, static_cast<int>(HRBFNPR_ABI_VERSION));
    context_fields().check("context_desc", desc);
    check_backend(desc);
    if ((desc.allocate == nullptr) != (desc.deallocate == nullptr))
        fail(Status::invalid_argument, "context_desc.%s is NULL; give both allocate and deallocate, or neither",
             desc.allocate == nullptr ? "allocate" : "deallocate");
}

} // namespace

void release_context(const hrbfnpr_context* context) noexcept {
    if (context == nullptr || !context->remove_reference()) return;
    // A temporary Memory frees the context, because the context's own Memory is part of it and is already destroyed.
    base::Memory memory(context->allocate, context->deallocate, context->allocator_user);
    context->~hrbfnpr_context();
    memory.deallocate(const_cast<hrbfnpr_context*>(context), sizeof(hrbfnpr_context));
}

} // namespace hrbfnpr::api

extern "C" {

hrbfnpr_status hrbfnpr_context_desc_init(hrbfnpr_context_desc* desc, uint32_t struct_size) {
    return api::init_struct(desc, struct_size);
}

hrbfnpr_status hrbfnpr_context_create(const hrbfnpr_context_desc* desc, hrbfnpr_context** out_context,
                                      hrbfnpr_error* error) {
    return api::guarded_create(out_context, "out_context", error, [&] {
        const hrbfnpr_context_desc full = api::read_optional_struct(desc, "context_desc");
        api::check(full);
        base::Memory memory(full.allocate, full.deallocate, full.allocator_user);
        void* const place = memory.allocate(sizeof(hrbfnpr_context));
        try {
            return new (place) hrbfnpr_context(full);
        } catch (...) {
            memory.deallocate(place, sizeof(hrbfnpr_context));
            throw;
        }
    });
}

void hrbfnpr_context_retain(hrbfnpr_context* context) {
    if (context != nullptr) context->add_reference();
}

void hrbfnpr_context_release(hrbfnpr_context* context) { api::release_context(context); }

hrbfnpr_status hrbfnpr_context_info_init(hrbfnpr_context_info* info, uint32_t struct_size) {
    return api::init_struct(info, struct_size);
}

hrbfnpr_status hrbfnpr_context_get_info(const hrbfnpr_context* context, hrbfnpr_context_info* info,
                                        hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        const base::Runtime& runtime = api::deref(context, "context").runtime;
        api::check_output_struct(info, "context_info");
        hrbfnpr_context_info full{};
        full.thread_count = runtime.parallel.threads();
        full.thread_backend = static_cast<std::uint32_t>(runtime.parallel.backend());
        full.instruction_set = static_cast<std::uint32_t>(runtime.instruction_set);
        full.bytes_now = runtime.memory.bytes_now();
        full.bytes_peak = runtime.memory.bytes_peak();
        api::write_struct(info, full);
    });
}

} // extern "C"
