// A renderer as a handle: the scratch of one thread, and the point sets of its prepared frame.
#pragma once

#include "api/handles.h"
#include "api/point_set.h"
#include "frame/frame.h"
#include "output/raster/draw.h"

struct hrbfnpr_renderer : hrbfnpr::api::Child {
    explicit hrbfnpr_renderer(hrbfnpr_context& context)
        : Child(context), frame(context.runtime), raster(context.runtime), items(context.runtime.memory),
          kept(context.runtime.memory), coming(context.runtime.memory) {}
    ~hrbfnpr_renderer() { let_go(); }

    // Releases the point sets of the last frame.
    void let_go() noexcept {
        for (const hrbfnpr_point_set* set : kept) hrbfnpr::api::release_handle(set);
        kept.clear();
    }

    hrbfnpr::frame::Frame frame;
    hrbfnpr::output::Raster raster;
    hrbfnpr::base::Array<hrbfnpr::frame::Item> items;
    hrbfnpr::base::Array<const hrbfnpr_point_set*> kept;   // a reference to each
    hrbfnpr::base::Array<const hrbfnpr_point_set*> coming; // of the frame being prepared
    std::int64_t nanoseconds_draw = 0;
};
