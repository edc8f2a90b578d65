// SPDX-License-Identifier: MIT
#include "clipping/chunks.h"

#include "clipping/python/arguments.h"
#include "clipping/python/module.h"
#include "clipping/python/pieces.h"
#include "clipping/python/rows.h"

#include <variant>

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

/// Boxes around runs of an array's segments.
template <class T>
class ArrayChunks {
public:
    using S = BasicSegment<T>;

    /// `array` is what `segmentsOf` returned, contiguous and of this type.
    explicit ArrayChunks(const py::array& array)
        : array_(array), count_(Rows<T>(array).size()), chunks_(segments())
    {
    }

    void update(std::size_t first, std::size_t last) { chunks_.update(segments(), first, last); }

    py::tuple clip(const Window& edges) const
    {
        const BasicWindow<T> window{glm::vec<2, T>(edges.min), glm::vec<2, T>(edges.max)};
        const auto in = segments();
        PieceBuffer<BasicClipped<S>> pieces(in.size());
        std::size_t count = 0;
        {
            const Released released(in.size());
            count = chunks_.clipAll(in, window, pieces.room());
        }
        return pieces.take(count);
    }

private:
    std::span<const S> segments() const
    {
        const Rows<T> rows(segmentsOf(array_)); // checks the shape again
        if (rows.size() != count_)              // numpy.ndarray.resize with refcheck=False
            throw py::value_error("the array has " + std::to_string(rows.size()) + " rows, but had "
                                  + std::to_string(count_)
                                  + " when its Chunks were made; make them again");
        return {static_cast<const S*>(array_.data()), rows.size()};
    }

    py::array array_;
    std::size_t count_;
    BasicChunks<T> chunks_;
};

/// An array that can stay where it is. Throws ValueError if it cannot.
py::array flat(const py::array& array)
{
    constexpr int needed = int(py::array::c_style) | int(py::detail::npy_api::NPY_ARRAY_ALIGNED_);
    if ((array.flags() & needed) != needed)
        throw py::value_error("segments must be contiguous and aligned, because they are not "
                              "copied, but these of shape "
                              + textOf(array.attr("shape")) + " have the strides "
                              + textOf(array.attr("strides"))
                              + "; use numpy.array(..., copy=True)");
    return array;
}

class AnyChunks {
public:
    explicit AnyChunks(py::handle segments) : chunks_(of(flat(segmentsOf(segments)))) {}

    void update(std::size_t first, std::size_t last)
    {
        std::visit([&](auto& chunks) { chunks.update(first, last); }, chunks_);
    }
    py::tuple clip(py::handle window) const
    {
        return std::visit([&](auto& chunks) { return chunks.clip(windowOf(window)); }, chunks_);
    }

private:
    using Chunks = std::variant<ArrayChunks<double>, ArrayChunks<float>>;

    static Chunks of(const py::array& array)
    {
        if (isFloat32(array))
            return Chunks(std::in_place_type<ArrayChunks<float>>, array);
        return Chunks(std::in_place_type<ArrayChunks<double>>, array);
    }
    Chunks chunks_;
};

} // namespace

void defineChunks(py::module_& module)
{
    py::class_<AnyChunks>(module, "Chunks")
        .def(py::init<py::handle>(), Guarded(), "segments"_a)
        .def("update", &AnyChunks::update, Guarded(), "first"_a, "last"_a)
        .def("clip", &AnyChunks::clip, Guarded(), "window"_a);
}

} // namespace clipping::python
