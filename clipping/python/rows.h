// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <pybind11/numpy.h>
#include <span>
#include <vector>

namespace clipping::python {

/// The rows of an array that `segmentsOf` (arguments.h) returned, read where they are, whatever
/// their strides are. Does not keep the array alive.
template <class T>
class Rows {
public:
    explicit Rows(const pybind11::array& array)
        : data_(static_cast<const char*>(array.data())),
          count_(static_cast<std::size_t>(array.shape(0))), row_(array.strides(0)),
          column_(array.strides(1))
    {
    }

    std::size_t size() const { return count_; }

    /// Whether the rows are a plain array of S, four numbers each.
    template <class S>
    bool isPacked() const
    {
        return count_ == 0
               || ((row_ == sizeof(S) || count_ == 1) && column_ == sizeof(T)
                   && reinterpret_cast<std::uintptr_t>(data_) % alignof(S) == 0);
    }

    /// Calls `use` with spans that together are all rows, and with the index of each first row. If
    /// the rows are not packed, they are gathered in a small buffer.
    template <class S, class Use>
    void forEachBlock(const Use& use) const
    {
        static_assert(sizeof(S) == 4 * sizeof(T));
        if (isPacked<S>())
            return use(std::span(reinterpret_cast<const S*>(data_), count_), 0);
        constexpr std::size_t most = 4096;
        std::vector<S> block(std::min(most, count_));
        for (std::size_t first = 0; first < count_; first += most) {
            const std::size_t count = std::min(most, count_ - first);
            for (std::size_t i = 0; i < count; ++i)
                copyRow(first + i, block[i]);
            use(std::span<const S>(block).first(count), first);
        }
    }

private:
    template <class S>
    void copyRow(std::size_t row, S& to) const
    {
        std::array<T, 4> numbers;
        const char* from = data_ + static_cast<std::ptrdiff_t>(row) * row_;
        for (T& number : numbers) {
            std::memcpy(&number, from, sizeof number);
            from += column_;
        }
        std::memcpy(static_cast<void*>(&to), numbers.data(), sizeof to);
    }

    const char* data_;
    std::size_t count_;
    std::ptrdiff_t row_, column_;
};

} // namespace clipping::python
