// SPDX-License-Identifier: MIT
// Arrays of vectors whose memory takes long to touch for the first time. These functions check for cancellation.
#pragma once

#include "base/long_array.h"
#include "geometry/vec_array.h"

namespace hrbfnpr::geometry {

// Reserves and touches room for `capacity` vectors, so that later push_backs touch no new memory.
inline void make_room_long(VecArray& array, std::int64_t capacity, const base::Progress& progress) {
    for (base::Array<double>* of : {&array.x, &array.y, &array.z}) base::make_room_long(*of, capacity, progress);
}

// Added vectors are zero.
inline void resize_long(VecArray& array, std::int64_t size, const base::Progress& progress) {
    for (base::Array<double>* of : {&array.x, &array.y, &array.z}) base::resize_long(*of, size, progress);
}

inline void push_back_long(VecArray& array, const glm::dvec3& v, const base::Progress& progress) {
    base::push_back_long(array.x, v.x, progress);
    base::push_back_long(array.y, v.y, progress);
    base::push_back_long(array.z, v.z, progress);
}

} // namespace hrbfnpr::geometry
