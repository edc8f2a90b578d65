// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/pseudo_code.h"
#include "clipping/python/arguments.h"
#include "clipping/python/module.h"

#include <pybind11/stl.h>

namespace py = pybind11;
using namespace py::literals;

namespace clipping::python {
namespace {

constexpr std::array edgeNames{"", "left", "right", "bottom", "top", "near", "far"};
constexpr std::array stepNames{"test", "let", "cut", "accept", "reject", "give up"};

std::string text(std::string_view view) { return std::string(view); }

std::vector<double> numbersOf(const Segment& s) { return {s.a.x, s.a.y, s.b.x, s.b.y}; }

py::list algorithmList()
{
    py::list rows;
    for (const Algorithm& row : algorithms())
        rows.append(py::dict("key"_a = text(row.key), "abbreviation"_a = text(row.abbreviation),
                             "name"_a = text(row.name), "year"_a = row.year,
                             "idea"_a = text(row.idea), "ulps"_a = row.ulps,
                             "published"_a = row.published != nullptr,
                             "polygon"_a = row.polygon != nullptr, "line"_a = row.line != nullptr,
                             "ray"_a = row.ray != nullptr));
    return rows;
}

py::object valueOf(const NamedValue& value)
{
    if (value.kind == ValueKind::Truth)
        return py::bool_(value.value != 0);
    if (value.kind == ValueKind::Number)
        return py::float_(value.value);
    return py::int_(static_cast<long long>(value.value));
}

py::dict dictOf(const Step& step, const std::vector<CodeLine>& code)
{
    py::dict values;
    for (const NamedValue& value : step.values)
        values[py::str(text(value.name))] = valueOf(value);
    const int line = lineOf(code, step.label);
    return py::dict("what"_a = stepNames[static_cast<std::size_t>(step.what)],
                    "holds"_a = step.holds, "name"_a = text(step.name), "line"_a = line,
                    "code"_a = line > 0 ? text(code[std::size_t(line) - 1].text) : std::string(),
                    "segment"_a = py::tuple(py::cast(numbersOf(step.segment))),
                    "edge"_a = edgeNames[static_cast<std::size_t>(step.edge)], "values"_a = values);
}

py::list traceOf(py::handle segment, py::handle window, py::handle algorithm, py::handle form)
{
    const bool published = choiceOf(form, "form", {"corrected", "published"}) == 1;
    const Segment given = segmentOf(segment);
    const Window edges = windowOf(window);
    const Algorithm& row = algorithmOf(algorithm);
    const Form chosen = published ? Form::Published : Form::Corrected;
    const auto* uses = functionsOf(row, chosen);
    if (!uses)
        throw py::value_error("'" + text(row.key) + "' has no published form");
    const Trace trace = uses->trace(given, edges);
    py::list steps;
    const auto code = clipping::linesOf(codeOf(row, chosen));
    for (const Step& step : trace.steps)
        steps.append(dictOf(step, code));
    return steps;
}

} // namespace

void defineCatalogue(py::module_& module)
{
    module.def("algorithms", algorithmList);
    module.def("trace", traceOf, Guarded(), "segment"_a, "window"_a, "algorithm"_a, "form"_a);
}

} // namespace clipping::python
