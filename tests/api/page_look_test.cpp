// SPDX-License-Identifier: MIT
// Tests pages of very many lines: how often the operation's callback is called, and that each call may cancel.
#include "fixture.h"

#include <cmath>
#include <ctime>
#include <string>
#include <vector>

namespace api_test::page_look_test {
namespace {

constexpr int lines = 100000;

struct Page : hrbfnpr_page_desc {
    Page() : hrbfnpr_page_desc(made(hrbfnpr_page_desc_init)) {
        width = height = 200.0;
        for (int i = 0; i < lines; ++i)
            for (int k = 0; k < 4; ++k) {
                points.push_back(1.0 + 198.0 * std::fmod(0.754877666 * i, 1.0) + 0.1 * k);
                points.push_back(1.0 + 198.0 * std::fmod(0.569840291 * i, 1.0) + 0.1 * std::sin(k));
            }
        for (int i = 0; i < lines; ++i) {
            annotation.push_back(made(hrbfnpr_annotation_init));
            annotation.back().points = {points.data() + 8 * i, 4, 0, HRBFNPR_SCALAR_FLOAT64, 2};
        }
        annotations = annotation.data();
        annotation_count = lines;
    }
    std::vector<double> points;
    std::vector<hrbfnpr_annotation> annotation;
};

// Processor time of this thread, so that other threads do not count.
double processor_seconds() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

struct Watch {
    std::int64_t calls = 0, cancel_at = -1;
    double last = processor_seconds(), longest = 0.0;
    static std::int32_t call(void* user, double) {
        auto& self = *static_cast<Watch*>(user);
        const double now = processor_seconds();
        self.longest = std::max(self.longest, now - self.last);
        self.last = now;
        return self.calls++ == self.cancel_at ? 1 : 0;
    }
};

hrbfnpr_status write(const Context& context, const Page& page, Watch& watch) {
    const Operation operation = make_operation(context);
    Error error;
    EXPECT_OK(hrbfnpr_operation_set_callback(operation.get(), Watch::call, &watch, error));
    const auto skip = [](void*, const void*, std::uint64_t) { return std::int32_t{0}; };
    return hrbfnpr_page_write(context.get(), &page, skip, nullptr, nullptr, operation.get(), error);
}

TEST(PageLooks, CheckForACancelOftenWithManyLines) {
    const Context context = make_context();
    Page page;
    for (const int format : {HRBFNPR_PAGE_FORMAT_SVG, HRBFNPR_PAGE_FORMAT_PDF, HRBFNPR_PAGE_FORMAT_HPGL}) {
        page.format = static_cast<std::uint32_t>(format);
        Watch watch;
        ASSERT_EQ(write(context, page, watch), HRBFNPR_STATUS_OK);
        std::printf("format %d: %lld calls, %.1f ms of processor time between two at most\n", format,
                    static_cast<long long>(watch.calls), 1e3 * watch.longest);
        // The calls while lines are read, and while they are written, 8 numbers each.
        EXPECT_GE(watch.calls, lines / 1024 + lines * 8 / 2048);
        if (format != HRBFNPR_PAGE_FORMAT_HPGL) {
            for (const std::int64_t call : {std::int64_t{3}, watch.calls / 2, watch.calls - 2}) {
                Watch other;
                other.cancel_at = call;
                EXPECT_EQ(write(context, page, other), HRBFNPR_STATUS_CANCELLED);
                EXPECT_EQ(other.calls, call + 1); // no call after the cancel
            }
        } else {
            EXPECT_GE(watch.calls, 2 * lines / 64 + 2000LL * lines / 100000); // plus the calls while lines are sorted
        }
    }
}

} // namespace
} // namespace api_test::page_look_test
