// SPDX-License-Identifier: MIT
#include "clipping/python/arguments.h"

#include "clipping/algorithm.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace py = pybind11;

namespace clipping::python {
namespace {

using Kinds = py::detail::npy_api; ///< NumPy's numbers of the types of an array

std::string reprOf(py::handle value) { return py::repr(value).cast<std::string>(); }

/// Whether the numbers are of that type, in this machine's byte order.
bool isOf(const py::array& array, int kind)
{
    const py::dtype type = array.dtype();
    return type.num() == kind
           && type.byteorder() != (std::endian::native == std::endian::little ? '>' : '<');
}

bool isArray(py::handle value) { return py::isinstance<py::array>(value); }

/// Whether it is an array, and not of a subclass, such as one with a mask.
bool isPlainArray(py::handle value) { return Py_TYPE(value.ptr()) == Kinds::get().PyArray_Type_; }

py::object ofNumPy(const char* name) { return py::module_::import("numpy").attr(name); }

void refuseMask(py::handle value, const std::string& what)
{
    if (!isPlainArray(value) && isArray(value)
        && py::isinstance(value, ofNumPy("ma").attr("MaskedArray")))
        throw py::type_error(what
                             + " must not have a mask, because it would be ignored; "
                               "numpy.ma.filled(..., numpy.nan) makes its rows invisible");
}

/// A number; throws a TypeError if it is none, or an error of the conversion.
double numberOf(py::handle value)
{
    PyObject* const object = value.ptr();
    if (!PyFloat_Check(object) && !PyLong_Check(object)
        && (PyUnicode_Check(object) || PyBytes_Check(object)
            || ofNumPy("ndim")(value).cast<int>() != 0
            || ofNumPy("iscomplexobj")(value).cast<bool>()))
        throw py::type_error("not a number");
    return py::float_(py::reinterpret_borrow<py::object>(value));
}

std::vector<double> allNumbersOf(py::handle value)
{
    std::vector<double> numbers;
    for (const py::handle number : py::iter(value))
        numbers.push_back(numberOf(number));
    return numbers;
}

std::vector<glm::dvec2> allPointsOf(py::handle value)
{
    std::vector<glm::dvec2> points;
    if (isPlainArray(value)) {
        const auto array = py::reinterpret_borrow<py::array>(value);
        const bool areFloats = isOf(array, Kinds::NPY_DOUBLE_) || isOf(array, Kinds::NPY_FLOAT_);
        if (areFloats && array.ndim() == 2 && array.shape(1) == 2) {
            const py::array_t<double> doubles(array);
            const auto numbers = doubles.unchecked<2>();
            for (py::ssize_t i = 0; i < numbers.shape(0); ++i)
                points.emplace_back(numbers(i, 0), numbers(i, 1));
            return points;
        }
    }
    for (const py::handle point : py::iter(value)) {
        const auto numbers = allNumbersOf(point);
        if (numbers.size() != 2)
            throw py::type_error("not a point");
        points.emplace_back(numbers[0], numbers[1]);
    }
    return points;
}

/// Converts the value. Where that fails, throws a TypeError with this beginning of a sentence.
template <class T>
T converted(T (*convert)(py::handle), py::handle value, const std::string& beginning)
{
    try {
        return convert(value);
    } catch (const py::type_error&) {
    } catch (py::error_already_set& error) {
        if (!error.matches(PyExc_TypeError) && !error.matches(PyExc_ValueError)
            && !error.matches(PyExc_OverflowError))
            throw;
    }
    throw py::type_error(beginning + whatIs(value));
}

/// Reads a tuple of four floats or ints, which most windows are. False for anything else.
bool readPlain(py::handle value, std::array<double, 4>& numbers)
{
    if (!PyTuple_CheckExact(value.ptr()) || PyTuple_GET_SIZE(value.ptr()) != 4)
        return false;
    for (Py_ssize_t i = 0; i < 4; ++i) {
        PyObject* const item = PyTuple_GET_ITEM(value.ptr(), i);
        if (!PyFloat_CheckExact(item) && !PyLong_CheckExact(item))
            return false;
        numbers[std::size_t(i)] = PyFloat_AsDouble(item);
    }
    if (!PyErr_Occurred())
        return true;
    PyErr_Clear(); // an int that is too large
    return false;
}

std::array<double, 4> fourNumbersOf(py::handle value, const std::string& name, const char* form)
{
    std::array<double, 4> four;
    if (!readPlain(value, four)) {
        const std::string must = name + " must be 4 numbers " + form + ", but th";
        const auto numbers = converted(allNumbersOf, value, must + "is is ");
        if (numbers.size() != four.size())
            throw py::value_error(must + "ese are " + std::to_string(numbers.size()));
        std::ranges::copy(numbers, four.begin());
    }
    if (!std::ranges::all_of(four, [](double number) { return std::isfinite(number); }))
        throw py::value_error(name + " must be finite, but this is "
                              + reprOf(py::make_tuple(four[0], four[1], four[2], four[3])));
    return four;
}

} // namespace

std::string textOf(py::handle value) { return py::str(value).cast<std::string>(); }

std::string whatIs(py::handle value)
{
    if (!isArray(value))
        return "a " + textOf(py::type::of(value).attr("__name__"));
    return "an array of shape " + textOf(value.attr("shape")) + " and dtype "
           + textOf(value.attr("dtype"));
}

py::array segmentsOf(py::handle value)
{
    refuseMask(value, "segments");
    if (!isArray(value))
        throw py::type_error("segments must be a NumPy array of shape (n, 4), but this is "
                             + whatIs(value) + "; use numpy.asarray(..., dtype=float)");
    auto array = py::reinterpret_borrow<py::array>(value);
    if (!isOf(array, Kinds::NPY_DOUBLE_) && !isOf(array, Kinds::NPY_FLOAT_))
        throw py::type_error("segments must be float64 or float32, but this is " + whatIs(value)
                             + "; use .astype(float)");
    if (array.ndim() != 2 || array.shape(1) != 4)
        throw py::value_error("segments must have the shape (n, 4), a row x1, y1, x2, y2 for each, "
                              "but this is "
                              + whatIs(value));
    if (static_cast<std::uint64_t>(array.shape(0)) > 0xffffffff)
        throw py::value_error("at most 4294967295 segments can be clipped at once, but this is "
                              + whatIs(value));
    return array;
}

bool isFloat32(const py::array& segments) { return isOf(segments, Kinds::NPY_FLOAT_); }

py::array doublesOf(py::handle value, const char* what)
{
    py::array array = segmentsOf(value);
    if (isFloat32(array))
        throw py::type_error(std::string(what) + " must be float64, but this is " + whatIs(value)
                             + "; use .astype(float)");
    return array;
}

Window windowOf(py::handle value)
{
    const char* const form = "(xmin, ymin, xmax, ymax)";
    const auto [xmin, ymin, xmax, ymax] = fourNumbersOf(value, "window", form);
    if (xmin > xmax || ymin > ymax)
        throw py::value_error(std::string("window must be ") + form
                              + " with xmin <= xmax and ymin <= ymax, but this is "
                              + reprOf(py::make_tuple(xmin, ymin, xmax, ymax)));
    return {{xmin, ymin}, {xmax, ymax}};
}

Segment segmentOf(py::handle value)
{
    const auto [x1, y1, x2, y2] = fourNumbersOf(value, "segment", "(x1, y1, x2, y2)");
    return {{x1, y1}, {x2, y2}};
}

std::vector<glm::dvec2> cornersOf(py::handle value)
{
    const auto corners =
        converted(allPointsOf, value, "polygon must be points (x, y), shape (m, 2), but this is ");
    if (corners.size() < 3)
        throw py::value_error("polygon must have three or more corners, but these are "
                              + std::to_string(corners.size()));
    return corners;
}

Points pointsOf(py::handle value, const std::string& what)
{
    refuseMask(value, what);
    const auto array = isArray(value) ? py::reinterpret_borrow<py::array>(value) : py::array();
    if (isOf(array, Kinds::NPY_CDOUBLE_) && array.ndim() == 1)
        return {array, array.strides(0), sizeof(double), true};
    if (!isArray(value) || !isOf(array, Kinds::NPY_DOUBLE_))
        throw py::type_error(what
                             + " must be a float64 array of shape (k, 2) or a complex one of shape "
                               "(k,), but this is "
                             + whatIs(value));
    if (array.ndim() != 2 || array.shape(1) != 2)
        throw py::value_error(
            what + " must have the shape (k, 2), a row x, y for each point, but this is "
            + whatIs(value));
    return {array, array.strides(0), array.strides(1), false};
}

bool Points::arePacked() const
{
    return (row == sizeof(glm::dvec2) || size() <= 1) && column == sizeof(double)
           && reinterpret_cast<std::uintptr_t>(array.data()) % alignof(glm::dvec2) == 0;
}

std::span<const glm::dvec2> Points::in(std::vector<glm::dvec2>& copies) const
{
    if (arePacked())
        return {static_cast<const glm::dvec2*>(array.data()), size()};
    copies.resize(size());
    const char* from = static_cast<const char*>(array.data());
    for (glm::dvec2& point : copies) {
        std::memcpy(&point.x, from, sizeof(double));
        std::memcpy(&point.y, from + column, sizeof(double));
        from += row;
    }
    return copies;
}

py::array offsetsOf(py::handle value)
{
    refuseMask(value, "offsets");
    const auto array = isArray(value) ? py::reinterpret_borrow<py::array>(value) : py::array();
    const bool areWhole = isOf(array, Kinds::NPY_LONG_) || isOf(array, Kinds::NPY_INT_)
                          || isOf(array, Kinds::NPY_LONGLONG_);
    if (!isArray(value) || !areWhole)
        throw py::type_error("offsets must be an int32 or int64 array, but this is " + whatIs(value)
                             + "; use .astype(numpy.int64)");
    if (array.ndim() != 1 || array.size() == 0)
        throw py::value_error("offsets must have the shape (m + 1,), from where each of the m "
                              "polylines begins to where the last one ends, but this is "
                              + whatIs(value));
    return array;
}

py::list linesOf(py::handle value)
{
    if (PyUnicode_Check(value.ptr()) || PyBytes_Check(value.ptr())
        || !py::hasattr(value, "__iter__"))
        throw py::type_error("lines must be a list of arrays, but this is " + whatIs(value));
    return py::list(py::reinterpret_borrow<py::object>(value));
}

std::size_t choiceOf(py::handle value, const char* name, std::initializer_list<const char*> choices)
{
    if (PyUnicode_Check(value.ptr()))
        for (std::size_t i = 0; i < choices.size(); ++i)
            if (PyUnicode_CompareWithASCIIString(value.ptr(), choices.begin()[i]) == 0)
                return i;
    std::string all;
    for (const char* choice : choices)
        all += (all.empty() ? "'" : ", '") + std::string(choice) + "'";
    throw py::value_error(std::string(name) + " must be one of " + all + ", but this is "
                          + reprOf(value));
}

const Algorithm& algorithmOf(py::handle value)
{
    if (!PyUnicode_Check(value.ptr()))
        throw py::type_error("algorithm must be a text, but this is " + whatIs(value));
    Py_ssize_t size = 0;
    const char* const key = PyUnicode_AsUTF8AndSize(value.ptr(), &size);
    if (const Algorithm* row = key ? findAlgorithm({key, std::size_t(size)}) : nullptr)
        return *row;
    PyErr_Clear(); // a text that is no Unicode
    throw py::value_error("there is no algorithm " + reprOf(value)
                          + "; clearcut.algorithms() lists them all");
}

int threadsOf(py::handle value)
{
    if (value.is_none())
        return 0;
    const auto number = py::reinterpret_steal<py::object>(
        PyBool_Check(value.ptr()) ? nullptr : PyNumber_Index(value.ptr()));
    PyErr_Clear();
    if (!number)
        throw py::type_error("threads must be a whole number or None, but this is "
                             + whatIs(value));
    int overflow = 0;
    const long threads = PyLong_AsLongAndOverflow(number.ptr(), &overflow);
    if (overflow != 0 || threads < 1 || threads > 1024)
        throw py::value_error("threads must be from 1 to 1024, but this is " + textOf(number));
    return static_cast<int>(threads);
}

void defineArguments(py::module_& module)
{
    using namespace py::literals;
    module.def("checked_segments", segmentsOf, "value"_a);
    module.def(
        "checked_window",
        [](py::handle value) {
            const Window w = windowOf(value);
            return py::make_tuple(w.min.x, w.min.y, w.max.x, w.max.y);
        },
        "value"_a);
}

} // namespace clipping::python
