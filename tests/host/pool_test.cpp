// SPDX-License-Identifier: MIT
// Tests the library's own threads: when they exist, their names, and what happens if the system refuses threads.
#include "host/calls.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <pthread.h>
#include <set>
#include <string>
#include <thread>

namespace {

std::atomic<bool> refuses{false};
std::atomic<int> refused{0};
using Create = int (*)(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*);

} // namespace

// Replaces the C library's pthread_create for the whole program and the library.
extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*work)(void*),
                              void* user) noexcept {
    if (refuses) {
        ++refused;
        return EAGAIN;
    }
    return reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"))(thread, attributes, work, user);
}

namespace host_test::pool_test {
namespace {

std::set<std::string> threads_of_the_library() {
    std::set<std::string> names;
    for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
        std::string name;
        std::getline(std::ifstream(task.path() / "comm"), name);
        if (name.starts_with("hrbfnpr")) names.insert(name);
    }
    return names;
}

// Waits for `wanted` threads, at most ten seconds, because a new thread sets its name itself.
std::set<std::string> threads_of_the_library(std::size_t wanted) {
    for (int wait = 0; wait < 10000 && threads_of_the_library().size() != wanted; ++wait)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    return threads_of_the_library();
}

Context context_by(std::int32_t threads, std::uint32_t backend) {
    auto desc = made(hrbfnpr_context_desc_init);
    desc.thread_count = threads;
    desc.thread_backend = backend;
    return make_context(desc);
}

TEST(Pool, LivesFromFirstUseToLastReference) {
    using Names = std::set<std::string>;
    Context context = context_by(4, HRBFNPR_THREAD_BACKEND_AUTO);
    EXPECT_EQ(threads_of_the_library(), Names{});
    Model model = fit(context);
    const Names three = {"hrbfnpr-1", "hrbfnpr-2", "hrbfnpr-3"};
    EXPECT_EQ(threads_of_the_library(3), three);
    context.reset();
    EXPECT_EQ(threads_of_the_library(), three); // the model keeps the threads
    model.reset();
    EXPECT_EQ(threads_of_the_library(), Names{});
}

TEST(Pool, IsNotMadeForOtherBackends) {
    const Scene serial(context_by(0, HRBFNPR_THREAD_BACKEND_SERIAL));
    const Scene one(context_by(1, HRBFNPR_THREAD_BACKEND_POOL));
    EXPECT_EQ(threads_of_the_library(), std::set<std::string>{});
}

TEST(Pool, ReportsItsBackend) {
    const auto backend = [](const Context& context) {
        auto info = made(hrbfnpr_context_info_init);
        scenes::Check()(hrbfnpr_context_get_info(context.get(), &info, nullptr));
        return info.thread_backend;
    };
    EXPECT_EQ(backend(context_by(2, HRBFNPR_THREAD_BACKEND_AUTO)), HRBFNPR_THREAD_BACKEND_POOL);
    EXPECT_EQ(backend(context_by(2, HRBFNPR_THREAD_BACKEND_SERIAL)), HRBFNPR_THREAD_BACKEND_SERIAL);
    EXPECT_EQ(backend(context_by(1, HRBFNPR_THREAD_BACKEND_POOL)), HRBFNPR_THREAD_BACKEND_SERIAL);
}

TEST(Pool, WorksIfTheSystemRefusesThreads) {
    const Bytes wanted = everything(make_context(1));
    refuses = true;
    const Bytes alone = everything(make_context(4));
    refuses = false;
    EXPECT_GT(refused, 0);
    EXPECT_TRUE(alone == wanted);
}

} // namespace
} // namespace host_test::pool_test
