// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"

#include <memory>
#include <new>
#include <pybind11/numpy.h>
#include <span>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace clipping::python {

/// Memory for pieces, of which only the pages that are written are ever occupied.
template <class Piece>
class PieceBuffer {
public:
    explicit PieceBuffer(std::size_t size) : size_(size)
    {
        const std::size_t page = size * sizeof(Piece) < 2 * hugePage ? smallPage : hugePage;
        const std::size_t bytes = (size * sizeof(Piece) / page + 1) * page;
        memory_.reset(static_cast<Piece*>(std::aligned_alloc(page, bytes)));
        if (!memory_)
            throw std::bad_alloc();
#ifdef __linux__
        if (page == hugePage) // a hundred thousand page faults take longer than clipping
            ::madvise(memory_.get(), bytes, MADV_HUGEPAGE);
#endif
    }

    std::span<Piece> room() { return {memory_.get(), size_}; }

    /// The first `count` pieces as NumPy arrays that share this memory: (m, 4) numbers, the
    /// sources and the cuts.
    pybind11::tuple take(std::size_t count)
    {
        namespace py = pybind11;
        using Number = typename decltype(Piece::segment.a)::value_type;
        Piece* const first = memory_.release();
        const py::capsule owner(first, [](void* memory) { std::free(memory); });
        constexpr py::ssize_t stride = sizeof(Piece);
        const auto n = static_cast<py::ssize_t>(count);
        const auto numbers = reinterpret_cast<const Number*>(first);
        return py::make_tuple(py::array_t<Number>({n, py::ssize_t(4)},
                                                  {stride, py::ssize_t(sizeof(Number))}, numbers,
                                                  owner),
                              py::array_t<std::uint32_t>({n}, {stride}, &first->source, owner),
                              py::array_t<std::uint32_t>({n}, {stride}, &first->cut, owner));
    }

private:
    struct Free {
        void operator()(Piece* memory) const { std::free(memory); }
    };
    static constexpr std::size_t smallPage = 4096, hugePage = std::size_t(1) << 21;
    std::unique_ptr<Piece, Free> memory_;
    std::size_t size_;
};

} // namespace clipping::python
