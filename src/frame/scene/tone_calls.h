// SPDX-License-Identifier: MIT
// Asks a style's tone callback for tau, on the thread that entered.
#pragma once

#include "base/memory.h"
#include "frame/scene/scene.h"

namespace hrbfnpr::frame {

class ToneCalls {
public:
    explicit ToneCalls(base::Memory& memory) noexcept
        : positions_(memory), normals_(memory), tau_(memory), places_(memory) {}

    // The answers to all marks added go to out[place].  Call begin() first, for each item, and end() last.
    void begin(const ItemView& item, base::Array<float>& out) noexcept;
    void add(const glm::vec3& own_position, const glm::vec3& own_normal, std::int64_t place);
    void end() { call(); }

    [[nodiscard]] std::int64_t bytes() const noexcept {
        return positions_.bytes() + normals_.bytes() + tau_.bytes() + places_.bytes();
    }

private:
    void call();
    void forget() noexcept;

    const ItemView* item_ = nullptr;
    base::Array<float>* out_ = nullptr;
    base::Array<float> positions_, normals_, tau_;
    base::Array<std::int64_t> places_;
};

} // namespace hrbfnpr::frame
