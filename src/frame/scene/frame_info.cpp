#include "frame/scene/frame_info.h"

#include <initializer_list>

namespace hrbfnpr::frame {

FrameInfo& FrameInfo::operator+=(const FrameInfo& other) noexcept {
    for (std::int64_t FrameInfo::*const field :
         {&FrameInfo::marks, &FrameInfo::outside, &FrameInfo::front, &FrameInfo::back, &FrameInfo::silhouette,
          &FrameInfo::shown, &FrameInfo::dropped_tone, &FrameInfo::dropped_depth, &FrameInfo::dropped_zoom,
          &FrameInfo::dropped_hidden, &FrameInfo::painted, &FrameInfo::culled})
        this->*field += other.*field;
    return *this;
}

} // namespace hrbfnpr::frame
