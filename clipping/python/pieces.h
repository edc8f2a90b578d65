// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/geometry.h"
#include "clipping/python/large_memory.h"

#include <memory>
#include <pybind11/numpy.h>
#include <span>

namespace clipping::python {

/// Memory for pieces.
template <class Piece>
class PieceBuffer {
public:
    explicit PieceBuffer(std::size_t size)
        : memory_(static_cast<Piece*>(takeMemory(size * sizeof(Piece)))), size_(size)
    {
    }

    std::span<Piece> room() { return {memory_.get(), size_}; }

    /// The first `count` pieces as NumPy arrays that share this memory: (m, 4) numbers, the
    /// sources and the cuts.
    pybind11::tuple take(std::size_t count)
    {
        namespace py = pybind11;
        using Number = typename decltype(Piece::segment.a)::value_type;
        Piece* const first = memory_.release();
        const py::capsule owner(first, giveMemory);
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
        void operator()(Piece* memory) const { giveMemory(memory); }
    };
    std::unique_ptr<Piece, Free> memory_;
    std::size_t size_;
};

} // namespace clipping::python
