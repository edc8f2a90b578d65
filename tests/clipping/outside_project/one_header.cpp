// SPDX-License-Identifier: MIT
// A program that only wants to clip. It is linked with -ffast-math by tests/CMakeLists.txt, so its
// own numbers near 0 are 0; the library's are not.
#include <clearcut/clip.h>
#include <cstdio>
#include <cstring>

namespace {

/// So many times the smallest number, made without arithmetic.
double denormal(std::uint64_t times)
{
    double number;
    std::memcpy(&number, &times, sizeof number);
    return number;
}

bool isDenormal(double number, std::uint64_t times)
{
    return std::memcmp(&number, &times, sizeof number) == 0;
}

int faults = 0;

void expect(bool holds, const char* what)
{
    if (!holds)
        ++faults, std::fprintf(stderr, "%s\n", what);
}

/// From 0 to 8 at the window from 2 to 6, in the smallest numbers.
void tryDenormals()
{
    const clearcut::Window tiny{{denormal(2), denormal(0)}, {denormal(6), denormal(9)}};
    const clearcut::Segment diagonal{{denormal(0), denormal(0)}, {denormal(8), denormal(8)}};
    const auto piece = clearcut::clip(diagonal, tiny);
    expect(piece && isDenormal(piece->a.x, 2) && isDenormal(piece->b.y, 6), "clip of denormals");
    const auto many = clearcut::clipAll(std::vector(9, diagonal), tiny);
    expect(many.size() == 9 && isDenormal(many[8].segment.a.y, 2)
               && isDenormal(many[8].segment.b.x, 6),
           "clipAll of denormals");
    const auto missing =
        clearcut::clip(clearcut::Segment{{0, denormal(9)}, {denormal(1), 0}}, tiny);
    expect(!missing, "a miss by the smallest number");
}

} // namespace

int main()
{
    tryDenormals();
    const clearcut::ConvexWindow triangle =
        clearcut::ConvexPolygon::from({{0, 4}, {4, 0}, {0, 0}}); // clockwise
    expect(bool(triangle), triangle.whyNot());
    const auto cut = clearcut::clip(clearcut::Segment{{-1, 1}, {9, 1}}, triangle);
    expect(cut && cut->a == glm::dvec2(0, 1) && cut->b == glm::dvec2(3, 1), "a triangle");
    const glm::dvec2 corners[]{{-2, 1}, {2, 1}, {2, 9}};
    const auto runs = clearcut::clip(clearcut::Polyline{corners}, clearcut::Window{{0, 0}, {4, 4}});
    expect(runs.size() == 1 && runs[0].size() == 3 && runs[0].front() == glm::dvec2(0, 1)
               && runs[0].back() == glm::dvec2(2, 4),
           "a polyline");
    return faults;
}
