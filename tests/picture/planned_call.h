// SPDX-License-Identifier: MIT
// Makes the Call that the picture's steps take, from options that a test sets, without a picture.
#pragma once

#include "picture/call.h"
#include "picture/handles.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace picture_tests {

// Set `desc`, `settings` and the changes, then use call().
class PlannedCall {
public:
    PlannedCall() : desc(hrbfnpr::picture::defaults<hrbfnpr_picture_desc>(hrbfnpr_picture_desc_init)), pool(memory_) {
        auto of_context = hrbfnpr::picture::defaults<hrbfnpr_context_desc>(hrbfnpr_context_desc_init);
        of_context.thread_count = 1;
        context = hrbfnpr::picture::make<hrbfnpr::picture::Context>([&](hrbfnpr_context** made, hrbfnpr_error* error) {
            return hrbfnpr_context_create(&of_context, made, error);
        });
        desc.wording = HRBFNPR_WORDING_OPTIONS;
    }
    explicit PlannedCall(std::uint32_t preset) : PlannedCall() { desc.preset = preset; }

    PlannedCall& change(std::string field, std::string value) {
        changes_.emplace_back(std::move(field), std::move(value));
        return *this;
    }

    [[nodiscard]] hrbfnpr::picture::Call call() {
        std::vector<hrbfnpr_change> list;
        for (const auto& [field, value] : changes_)
            list.push_back({sizeof(hrbfnpr_change), 0, field.c_str(), value.c_str()});
        desc.changes = list.data();
        desc.change_count = static_cast<std::int64_t>(list.size());
        options_.emplace(desc, settings, pool);
        report.emplace(pool, desc.wording, nullptr, nullptr, *context.get(), nullptr);
        return {*context.get(), *options_, *report, pool};
    }

private:
    hrbfnpr::base::Memory memory_;

public:
    hrbfnpr_picture_desc desc;
    hrbfnpr::picture::Pool pool;
    hrbfnpr::picture::Context context;
    std::shared_ptr<const hrbfnpr::picture::Settings> settings;
    std::optional<hrbfnpr::picture::Report> report; // The report of the last call().

private:
    std::vector<std::pair<std::string, std::string>> changes_;
    std::optional<hrbfnpr::picture::Options> options_;
};

} // namespace picture_tests
