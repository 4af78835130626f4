// SPDX-License-Identifier: MIT
// Refuses memory in a stage, and tries again with the same objects.
#pragma once

#include "stages/stage.h"

namespace api_test {

// Refuses one request for memory within the calls that it wraps, and with `all_later` each later one, too.
class Refusal : public Attempt {
public:
    std::int64_t at = 0; // number of the refused request, from 1 on; 0 = none
    bool all_later = false;

    [[nodiscard]] virtual std::int64_t calls() const = 0; // requests for memory since restart()
    virtual void restart() = 0;
};

// Returns the numbers of the refused requests, of `count`: all if `at_most` allows it, otherwise the first, the last
// and some between.
[[nodiscard]] inline std::vector<std::int64_t> moments(std::int64_t count, std::int64_t at_most) {
    std::vector<std::int64_t> some;
    const std::int64_t step = 1 + count / at_most;
    for (std::int64_t k = 1; k <= count; ++k)
        if (step == 1 || k <= at_most / 4 || k > count - at_most / 8 || k % step == 0) some.push_back(k);
    return some;
}

// Expects OUT_OF_MEMORY for each refused request, and then, with the same objects, the result of an undisturbed run. If
// more than 32 requests are refused and objects are not made anew, the result is only checked after every fourth.
// Returns how many requests were refused.
inline std::int64_t refuse_and_retry(const Stage& stage, Refusal& refusal, std::int64_t at_most) {
    const auto run = [&](Bytes& bytes, std::int64_t at) {
        Error error;
        refusal.restart();
        refusal.at = at;
        const hrbfnpr_status status = stage.call(refusal, bytes, error);
        refusal.at = 0;
        EXPECT_TRUE(status == HRBFNPR_STATUS_OK || error.record.message[0] != '\0') << stage.name;
        return status;
    };
    Bytes wanted;
    if (stage.renew) stage.renew();
    EXPECT_EQ(run(wanted, 0), HRBFNPR_STATUS_OK) << stage.name;
    const std::vector<std::int64_t> refused = moments(refusal.calls(), std::min(at_most, stage.most_refusals));
    const std::size_t in_a_row = refused.size() > 32 && !stage.renew ? 4 : 1;
    for (std::size_t i = 0; i < refused.size() && !testing::Test::HasFailure(); ++i) {
        if (stage.renew) stage.renew();
        Bytes nothing, again;
        refusal.all_later = (i / in_a_row + i) % 2 == 0;
        EXPECT_EQ(run(nothing, refused[i]), HRBFNPR_STATUS_OUT_OF_MEMORY) << stage.name << ", call " << refused[i];
        if ((i + 1) % in_a_row != 0 && i + 1 < refused.size()) continue;
        EXPECT_EQ(run(again, 0), HRBFNPR_STATUS_OK) << stage.name << ", after " << refused[i];
        EXPECT_TRUE(again == wanted) << stage.name << ", after " << refused[i];
    }
    return static_cast<std::int64_t>(refused.size());
}

} // namespace api_test
