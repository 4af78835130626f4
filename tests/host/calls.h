// SPDX-License-Identifier: MIT
// Every kind of call that can run on a small stack, as tests/api/stages lists them.
#pragma once

#include "host/session.h"
#include "stages/stages.h"

#include <string>

namespace host_test {

// Fits, normals and pictures need a larger stack; the other calls make the parts of a picture.
inline bool needs_a_large_stack(const std::string& name) {
    return name.rfind("fit", 0) == 0 || name.rfind("mesh.fit", 0) == 0 || name.rfind("picture", 0) == 0 ||
           name == "orient";
}

class Calls {
public:
    explicit Calls(Context context) : context_(std::move(context)), stages_(context_) {
        for (api_test::Stage& stage : stages_.all())
            if (!needs_a_large_stack(stage.name)) all_.push_back(std::move(stage));
    }

    [[nodiscard]] const std::vector<api_test::Stage>& all() const { return all_; }

    static Bytes run(const api_test::Stage& stage) {
        api_test::Error error;
        api_test::Attempt attempt;
        Bytes bytes;
        if (stage.renew) stage.renew();
        EXPECT_OK(stage.call(attempt, bytes, error)) << stage.name;
        return bytes;
    }

    // Runs all calls and returns what they compute.
    [[nodiscard]] Bytes everything() const {
        Bytes bytes;
        for (const api_test::Stage& stage : all_) api_test::append(bytes, run(stage));
        return bytes;
    }

private:
    Context context_;
    api_test::Stages stages_;
    std::vector<api_test::Stage> all_;
};

inline Bytes everything(Context context) { return Calls(std::move(context)).everything(); }

} // namespace host_test
