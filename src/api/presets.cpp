// SPDX-License-Identifier: MIT
#include "api/presets.h"

#include "api/barrier.h"
#include "api/descriptor.h"
#include "api/preset_table.h"

namespace hrbfnpr::api {
namespace {

const Preset* preset_of(std::uint32_t number) noexcept {
    return number < presets().size() ? &presets()[number] : nullptr;
}

} // namespace

std::span<const Preset> presets() noexcept { return preset_table::presets; }

} // namespace hrbfnpr::api

using namespace hrbfnpr;

extern "C" {

hrbfnpr_status hrbfnpr_style_init_preset(hrbfnpr_style* style, uint32_t struct_size, uint32_t preset,
                                         hrbfnpr_error* error) {
    return api::guarded(error, [&] {
        api::require_pointer(style, "style");
        api::check_struct_size<hrbfnpr_style>(struct_size, "style");
        const api::Preset* const row = api::preset_of(preset);
        if (row == nullptr)
            fail(Status::invalid_argument, "preset is %u; it must be one of HRBFNPR_PRESET_* (0 to %d)", preset,
                 static_cast<int>(api::presets().size()) - 1);
        style->struct_size = struct_size;
        api::write_struct(style, row->style);
    });
}

const hrbfnpr_layer_desc* hrbfnpr_preset_layers(uint32_t preset, int64_t* count) {
    const api::Preset* const row = api::preset_of(preset);
    if (count != nullptr) *count = row != nullptr ? std::ssize(row->marks) : 0;
    return row != nullptr ? row->marks.data() : nullptr;
}

const char* hrbfnpr_preset_name(uint32_t preset) {
    const api::Preset* const row = api::preset_of(preset);
    return row != nullptr ? row->name : nullptr;
}

} // extern "C"
