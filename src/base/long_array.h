// SPDX-License-Identifier: MIT
// Operations on arrays so large that the first write to their memory takes long. The operations check for cancellation.
#pragma once

#include "base/memory.h"
#include "base/operation.h"

#include <algorithm>
#include <cstdint>
#include <utility>

namespace hrbfnpr::base {

// The number of elements that are processed between two checks for cancellation: 2 MiB of elements.
template <class T>
constexpr std::int64_t at_once = std::max<std::int64_t>(1, (std::int64_t{1} << 21) / std::int64_t{sizeof(T)});

// Works like array.reserve(capacity). If the array grows, its elements are copied.
template <class T>
void reserve_long(Array<T>& array, std::int64_t capacity, const Progress& progress) {
    progress.check();
    if (array.size() <= at_once<T>) return array.reserve(capacity);
    if (capacity <= array.bytes() / std::int64_t{sizeof(T)}) return;
    Array<T> grown(array.memory());
    grown.reserve(capacity);
    while (grown.size() < array.size()) {
        progress.check();
        const std::int64_t begin = grown.size();
        grown.resize_for_overwrite(std::min(array.size(), begin + at_once<T>));
        std::copy(array.begin() + begin, array.begin() + grown.size(), grown.begin() + begin);
    }
    array = std::move(grown);
}

// Works like array.resize(size). Added elements are zero.
template <class T>
void resize_long(Array<T>& array, std::int64_t size, const Progress& progress) {
    reserve_long(array, size, progress);
    while (size - array.size() > at_once<T>) {
        progress.check();
        array.resize(array.size() + at_once<T>);
    }
    array.resize(size);
}

// Reserves memory for `capacity` elements and touches it, so that later push_back calls never touch a page for the
// first time.
template <class T>
void make_room_long(Array<T>& array, std::int64_t capacity, const Progress& progress) {
    const std::int64_t size = array.size();
    resize_long(array, capacity, progress);
    array.resize_for_overwrite(size);
}

// Works like array.push_back(value). `value` may be an element of the array.
template <class T>
void push_back_long(Array<T>& array, T value, const Progress& progress) {
    if (const std::int64_t size = array.size(); size > at_once<T> && size == array.bytes() / std::int64_t{sizeof(T)})
        reserve_long(array, size + size / 2, progress);
    array.push_back(value);
}

// Fills the array with `size` copies of `value`. The old elements are lost.
template <class T>
void fill_long(Array<T>& array, std::int64_t size, const T& value, const Progress& progress) {
    array.clear();
    array.reserve(size);
    while (array.size() < size) {
        progress.check();
        const std::int64_t begin = array.size();
        array.resize_for_overwrite(std::min(size, begin + at_once<T>));
        std::fill(array.begin() + begin, array.end(), value);
    }
}

} // namespace hrbfnpr::base
