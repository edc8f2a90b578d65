// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/formulas/evaluate.h"

#include "app/teaching/formulas/code.h"
#include "clipping/outcode.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace app::formulas {

namespace {

unsigned bitPattern(double value)
{
    if (!(value >= 0 && value < 0x1p32 && value == std::floor(value)))
        throw Unreadable(text(value) + " is no pattern of bits");
    return unsigned(value);
}

using Number = clipping::Counted<double>;

/// Computes a value as the library does, and adds what that costs.
template <class Compute>
double counting(clipping::OperationCounts* cost, const Compute& compute)
{
    const auto before = std::exchange(clipping::operations, {});
    const double value = compute();
    const auto own = std::exchange(clipping::operations, before);
    if (cost)
        add(*cost, own);
    return value;
}

/// The nearest coordinate of the window.
double heldCoordinate(double value, const Scope& scope)
{
    if (scope.axis < 0)
        throw Unreadable("held(...) is no coordinate here");
    const clipping::Window w = scope.window();
    const Number v(value), low(w.min[scope.axis]), high(w.max[scope.axis]);
    return (v < low ? low : v > high ? high : v).value();
}

/// Whether a point is beyond the edge of the step.
bool isBeyondEdge(const glm::dvec2& p, const Scope& scope)
{
    if (scope.edge == clipping::Edge::NoEdge)
        throw Unreadable("beyond(...) is of no edge here");
    const auto axis = clipping::axisOf(scope.edge);
    const Number level(clipping::levelOf(scope.edge, scope.window())), coordinate(p[axis]);
    return scope.edge == clipping::lowerEdge(axis) ? coordinate < level : coordinate > level;
}

/// The edge at which the variable got its value; NoEdge for anything else.
clipping::Edge edgeAt(const Expression& variable, const Scope& scope)
{
    return variable.kind == Kind::Name ? scope.edgeOf(slotOf(variable, scope))
                                       : clipping::Edge::NoEdge;
}

double sign(std::partial_ordering order)
{
    return std::is_lt(order) ? -1 : std::is_gt(order) ? 1 : 0;
}

Number magnitudeOf(Number v) { return v < Number(0) ? -v : v; }

/// Of a function that the library computes exactly.
double exactValue(const Expression& e, const Scope& scope, double first, double second)
{
    if (!scope.exact)
        throw Unreadable(e.name + "(...) is computed exactly, by the library alone");
    const clipping::Segment ends{{scope.value(0), scope.value(1)},
                                 {scope.value(2), scope.value(3)}};
    if (e.name == "yAt")
        return scope.exact->crossing(ends, first);
    if (e.name == "xAt")
        return scope.exact->crossing({{ends.a.y, ends.a.x}, {ends.b.y, ends.b.x}}, first);
    return e.name == "order" ? scope.exact->order(ends, first, second)
                             : scope.exact->side(ends, {first, second});
}

double valueOfFunction(const Expression& e, const Scope& scope, clipping::OperationCounts* cost)
{
    const double first = valueOf(e.parts[0], scope, cost);
    auto* const own = operatesOnNumbers(e, scope) ? cost : nullptr;
    if (e.name == "abs")
        return counting(own, [&] { return magnitudeOf(Number(first)).value(); });
    if (e.name == "sign")
        return counting(own, [&] { return sign(Number(first) <=> Number(0)); });
    if (e.name == "held")
        return counting(own, [&] { return heldCoordinate(first, scope); });
    if (cost) // the most that they can cost: it depends on whether floating point decides
        add(*cost, mostCostOf(e));
    const clipping::Edge edge = edgeAt(e.parts[0], scope);
    if (e.name == "atEdge")
        return edge != clipping::Edge::NoEdge;
    if ((e.name == "vertical" || e.name == "edge") && edge == clipping::Edge::NoEdge)
        throw Unreadable(e.name + "(...) is of no edge here");
    if (e.name == "vertical")
        return clipping::axisOf(edge) == 0;
    if (e.name == "edge")
        return clipping::levelOf(edge, scope.window());
    const double second = e.parts.size() > 1 ? valueOf(e.parts[1], scope, cost) : 0;
    if (e.name == "yAt" || e.name == "xAt" || e.name == "order" || e.name == "side")
        return exactValue(e, scope, first, second);
    if (e.name == "beyond")
        return counting(own, [&] { return double(isBeyondEdge({first, second}, scope)); });
    if (e.name == "min")
        return counting(own, [&] { return std::min(Number(first), Number(second)).value(); });
    if (e.name == "max")
        return counting(own, [&] { return std::max(Number(first), Number(second)).value(); });
    return counting(own, [&] {
        return double(clipping::outcodeOf(clipping::counted(glm::dvec2{first, second}),
                                          clipping::counted(scope.window())));
    });
}

/// Of two operands that are both looked at.
double combined(Kind kind, double a, double b)
{
    switch (kind) {
    case Kind::Sum:
        return a + b;
    case Kind::Difference:
        return a - b;
    case Kind::Product:
        return a * b;
    case Kind::Quotient:
        return a / b;
    case Kind::BitAnd:
        return double(bitPattern(a) & bitPattern(b));
    case Kind::BitOr:
        return double(bitPattern(a) | bitPattern(b));
    case Kind::Less:
        return a < b;
    case Kind::Greater:
        return a > b;
    case Kind::AtMost:
        return a <= b;
    case Kind::AtLeast:
        return a >= b;
    case Kind::Equal:
        return a == b;
    default:
        return a != b;
    }
}

} // namespace

int slotOf(const Expression& variable, const Scope& scope)
{
    if (variable.kind == Kind::Name)
        return variable.variables[0];
    const double index = valueOf(variable.parts[0], scope);
    if (!(index >= 0 && index < 16))
        throw Unreadable("an index is " + text(index));
    return variable.variables[std::size_t(index)];
}

double valueOf(const Expression& e, const Scope& scope, clipping::OperationCounts* cost)
{
    const auto part = [&](std::size_t i) { return valueOf(e.parts[i], scope, cost); };
    if (cost && !isCopy(e) && e.kind != Kind::Function)
        add(*cost, operationOf(e, scope));
    switch (e.kind) {
    case Kind::Number:
        return e.number;
    case Kind::Name:
    case Kind::Element:
        return scope.value(slotOf(e, scope));
    case Kind::Negative:
        return -part(0);
    case Kind::Complement:
        return double(~bitPattern(part(0)));
    case Kind::Not:
        return part(0) == 0;
    case Kind::And:
        return part(0) != 0 && part(1) != 0;
    case Kind::Or:
        return part(0) != 0 || part(1) != 0;
    case Kind::Choice:
        return part(0) != 0 ? part(1) : part(2);
    case Kind::Function:
        return valueOfFunction(e, scope, cost);
    case Kind::Call:
        throw Unreadable(e.name + "(...) has no value of its own: tell what its lines do");
    default:
        return combined(e.kind, part(0), part(1));
    }
}

bool same(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b)
           || (std::isnan(a) && std::isnan(b));
}

} // namespace app::formulas
