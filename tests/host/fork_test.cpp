// SPDX-License-Identifier: MIT
// Tests processes that fork after they used the library: children continue with old objects, and with new contexts.
#include "host/session.h"

#include <gtest/gtest.h>

#include <exception>
#include <sys/wait.h>
#include <unistd.h>

namespace host_test::fork_test {
namespace {

// Runs `work` in a child, which must return 0. An alarm ends a child that hangs.
template <class Work>
int in_a_child(const Work& work) {
    const pid_t child = fork();
    if (child == 0) {
        alarm(240);
        int result = 99;
        try {
            result = work();
        } catch (const std::exception&) {
        }
        _exit(result);
    }
    int status = -1;
    waitpid(child, &status, 0);
    return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

TEST(Fork, ChildrenDoTheSameWork) {
    const Scene scene(make_context(0)); // the threads have started
    const auto work = [&](const Context& context) {
        const Model model = fit(context);
        Bytes bytes = draw(context, generate(context, model), model.get());
        const Bytes old = draw(context, scene.marks, scene.model.get()); // drawn from the parent's marks
        bytes.insert(bytes.end(), old.begin(), old.end());
        return bytes;
    };
    const Bytes wanted = work(scene.context);
    const auto same = [&] { return work(scene.context) == wanted && work(make_context(0)) == wanted; };
    for (int child = 0; child < 2; ++child) EXPECT_EQ(in_a_child([&] { return same() ? 0 : 1; }), 0);
    EXPECT_EQ(in_a_child([&] { return in_a_child([&] { return same() ? 0 : 1; }); }), 0);
    EXPECT_TRUE(same());
}

TEST(Fork, ChildrenCanReleaseInheritedObjects) {
    EXPECT_EQ(in_a_child([] {
                  Scene scene(make_context(0));
                  return in_a_child([&] {
                      const Scene gone = std::move(scene);
                      return 0;
                  });
              }),
              0);
}

} // namespace
} // namespace host_test::fork_test
