// SPDX-License-Identifier: MIT
#include "clipping/chunks.h"

#include "clipping/python/module.h"
#include "clipping/python/pieces.h"
#include "clipping/python/rows.h"

#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

/// Boxes around runs of an array's segments. The package keeps the array alive.
template <class T>
class ArrayChunks {
public:
    using S = BasicSegment<T>;

    explicit ArrayChunks(const py::array& array)
        : array_(array), count_(Rows<T>(array).size()), chunks_(segments())
    {
    }

    void update(std::size_t first, std::size_t last) { chunks_.update(segments(), first, last); }

    py::tuple clip(const WindowNumbers& w) const
    {
        const BasicWindow<T> window{{T(w[0]), T(w[1])}, {T(w[2]), T(w[3])}};
        const auto in = segments();
        PieceBuffer<BasicClipped<S>> pieces(in.size());
        std::size_t count = 0;
        {
            const py::gil_scoped_release released;
            count = chunks_.clipAll(in, window, pieces.room());
        }
        return pieces.take(count);
    }

private:
    std::span<const S> segments() const
    {
        const Rows<T> rows(array_);
        if (!rows.template isPacked<S>())
            throw py::value_error("the array must be contiguous, because it is not copied");
        if (rows.size() != count_) // numpy.ndarray.resize with refcheck=False
            throw py::value_error("the array has " + std::to_string(rows.size()) + " rows, but had "
                                  + std::to_string(count_)
                                  + " when its Chunks were made; make them again");
        return {static_cast<const S*>(array_.data()), rows.size()};
    }

    py::array array_;
    std::size_t count_;
    BasicChunks<T> chunks_;
};

template <class T>
void define(py::module_& module, const char* name)
{
    py::class_<ArrayChunks<T>>(module, name)
        .def(py::init<py::array>(), Guarded(), "segments"_a)
        .def("update", &ArrayChunks<T>::update, Guarded(), "first"_a, "last"_a)
        .def("clip", &ArrayChunks<T>::clip, Guarded(), "window"_a);
}

} // namespace

void defineChunks(py::module_& module)
{
    define<double>(module, "Chunks");
    define<float>(module, "FloatChunks");
}

} // namespace clipping::python
