// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/test_scene.h"

#include "app/base/text.h"
#include "app/comparison/line_class.h"
#include "app/formats/coordinates.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

namespace app {
namespace {

using clipping::Segment;
using clipping::Window;

glm::dvec2 direction(Random& random)
{
    const double angle = random.between(0, 2 * std::numbers::pi);
    return {std::cos(angle), std::sin(angle)};
}

glm::dvec2 sizeOf(const Window& window) { return window.max - window.min; }

Segment inside(Random& random, const Field& field)
{
    const glm::dvec2 a = random.in(field.window);
    return {a, random.in(field.window)};
}

/// Both ends beyond the same edge.
Segment rejected(Random& random, const Field& field)
{
    Window beyond = field.space;
    const bool low = random.heads(), vertical = random.heads();
    auto& near = low ? beyond.max : beyond.min;
    const auto& edge = low ? field.window.min : field.window.max;
    (vertical ? near.x : near.y) = vertical ? edge.x : edge.y;
    const glm::dvec2 a = random.in(beyond);
    return {a, random.in(beyond)};
}

/// From one end in the space through a point of the window, continued by a random length.
Segment crossing(Random& random, const Field& field)
{
    const glm::dvec2 a = random.in(field.space);
    const glm::dvec2 b = a + (random.in(field.window) - a) * random.between(1, 3);
    return {a, glm::clamp(b, field.space.min, field.space.max)};
}

/// Past a corner, at a distance between a tenth and a billionth of the window.
Segment nearMiss(Random& random, const Field& field)
{
    const double side = random.heads() ? 1 : -1, up = random.heads() ? 1 : -1;
    const glm::dvec2 outward{side, up}, size = sizeOf(field.window);
    const glm::dvec2 corner = glm::mix(field.window.min, field.window.max, 0.5 * (outward + 1.0));
    const glm::dvec2 off = corner + outward * size * std::pow(10, random.between(-9, -1));
    glm::dvec2 a = random.in(field.space);
    a.y = off.y + up * std::abs(a.y - off.y);
    return {a, off + (off - a) * random.between(0, 3)};
}

/// A thousand times as long as the space is wide, near the window.
Segment longLine(Random& random, const Field& field)
{
    const glm::dvec2 size = sizeOf(field.window), around = random.in({-size, size});
    const glm::dvec2 middle = 0.5 * (field.window.min + field.window.max) + around;
    const glm::dvec2 whole = 1000 * sizeOf(field.space).x * direction(random);
    const double at = random.between(0, 1);
    return {middle - whole * at, middle + whole * (1 - at)};
}

bool is(const Segment& line, const Field& field, LineClass lineClass)
{
    return lineClassOf(line, field.window) == lineClass;
}
bool isWithin(const Segment& line, const Field& field)
{
    const auto within = [&](const glm::dvec2& p) {
        return glm::clamp(p, field.space.min, field.space.max) == p;
    };
    return within(line.a) && within(line.b);
}

bool liesInside(const Segment& s, const Field& f) { return is(s, f, LineClass::Inside); }
bool isRejected(const Segment& s, const Field& f) { return is(s, f, LineClass::Rejected); }
bool isCrossing(const Segment& s, const Field& f)
{
    const auto outside = [&](const glm::dvec2& p) {
        return glm::clamp(p, f.window.min, f.window.max) != p;
    };
    return outside(s.a) && outside(s.b) && is(s, f, LineClass::Cut);
}
bool isMissing(const Segment& s, const Field& f)
{
    return isWithin(s, f) && is(s, f, LineClass::Missed);
}
bool isAnything(const Segment&, const Field&) { return true; }

/// For windows with so little room around them that a near miss is rare: around a corner, from
/// beyond one edge to beyond the next.
Segment roundCorner(Random& random, const Field& field)
{
    const double side = random.heads() ? 1 : -1, up = random.heads() ? 1 : -1;
    const glm::dvec2 share = 0.5 * (glm::dvec2{side, up} + 1.0);
    const glm::dvec2 corner = glm::mix(field.window.min, field.window.max, share);
    const glm::dvec2 room = glm::mix(field.space.min, field.space.max, share) - corner;
    const double far = random.between(0.1, 1),
                 back = far * random.between(0, 0.9); // back < far: past the corner
    const glm::dvec2 out = corner + far * room;
    const glm::dvec2 in =
        corner - back * glm::sign(room) * glm::min(glm::abs(room), sizeOf(field.window));
    return {{in.x, out.y}, {out.x, in.y}};
}

/// For such windows, too: from beyond one edge to beyond the opposite one.
Segment across(Random& random, const Field& field)
{
    const Window &space = field.space, &window = field.window;
    if (random.heads())
        return {random.in({{space.min.x, window.min.y}, {window.min.x, window.max.y}}),
                random.in({{window.max.x, window.min.y}, {space.max.x, window.max.y}})};
    return {random.in({{window.min.x, space.min.y}, {window.max.x, window.min.y}}),
            random.in({{window.min.x, window.max.y}, {window.max.x, space.max.y}})};
}

/// Lines from `line` that satisfy `wanted` (rounding alone can violate it). After a thousand tries
/// without success, `tight` generates the lines. If that fails as well, because numbers are too
/// coarse for such a field, all its lines are accepted: the loop always ends.
template <auto line, auto wanted, auto tight>
class Made {
public:
    Made(const Field& field, std::uint64_t seed) : field_(field), random_(seed) {}
    void operator()(std::span<Segment> lines)
    {
        for (Segment& one : lines)
            one = next();
    }

private:
    Segment next()
    {
        constexpr int most = 1000;
        static constexpr std::array ways{line, tight};
        for (; way_ < ways.size(); ++way_)
            for (int tries = 0; tries < most; ++tries)
                if (const Segment one = ways[way_](random_, field_); wanted(one, field_))
                    return one;
        return tight(random_, field_);
    }

    Field field_;
    Random random_;
    std::size_t way_ = 0;
};

/// Repeats the lines in their order.
class Repeated {
public:
    explicit Repeated(SceneLines lines) : lines_(std::move(lines)) {}
    void operator()(std::span<Segment> some)
    {
        while (!some.empty()) {
            const auto left = lines_.runs()[run_].segments.subspan(next_);
            const std::size_t count = std::min(left.size(), some.size());
            std::ranges::copy(left.first(count), some.begin());
            some = some.subspan(count);
            next_ += count;
            if (count == left.size()) {
                run_ = (run_ + 1) % lines_.runs().size();
                next_ = 0;
            }
        }
    }

private:
    SceneLines lines_;
    std::size_t run_ = 0, next_ = 0; ///< next_: index within the run
};

template <auto line, auto wanted, auto tight = line>
LineSource begin(const Field& field, std::uint64_t seed)
{
    assert(hasRoom(field));
    return Made<line, wanted, tight>(field, seed);
}

LineSource beginPaper(const Field& field, std::uint64_t seed)
{
    return [scene = PaperScene(seed, field.space)](std::span<Segment> lines) mutable {
        scene.fill(lines);
    };
}

} // namespace

QString windowText(const Field& field)
{
    return field.shape ? field.shape->text : rectangleText(field.window);
}

bool hasRoom(const Field& field)
{
    const Window &space = field.space, &window = field.window;
    return space.min.x < window.min.x && window.min.x < window.max.x && window.max.x < space.max.x
           && space.min.y < window.min.y && window.min.y < window.max.y
           && window.max.y < space.max.y;
}

// THE CATALOGUE. To add a scene: write the function that makes a line, and a row here.
std::vector<TestScene> testScenes()
{
    return {
        {"paper", Text::tr("The paper's"),
         Text::tr("Both ends anywhere in the space, as in the paper."), beginPaper, 0, true},
        {"inside", Text::tr("Inside"), Text::tr("Both ends inside the window."),
         begin<inside, liesInside>},
        {"rejected", Text::tr("Rejected"), Text::tr("Both ends beyond one side of the window."),
         begin<rejected, isRejected>},
        {"crossing", Text::tr("Crossing"),
         Text::tr("Both ends outside, with a visible part between them."),
         begin<crossing, isCrossing, across>},
        {"near-miss", Text::tr("Near miss"),
         Text::tr("Lines that pass a corner of the window at a distance of a billionth to a "
                  "tenth of the window's size."),
         begin<nearMiss, isMissing, roundCorner>},
        {"long", Text::tr("Long"),
         Text::tr(
             "Lines through or past the window, a thousand times as long as the space is wide."),
         begin<longLine, isAnything>, 0, true},
    };
}

std::optional<TestScene> findTestScene(QStringView key)
{
    for (TestScene& scene : testScenes())
        if (scene.key == key)
            return std::move(scene);
    return std::nullopt;
}

TestScene drawingScene(const QString& name, const SceneLines& lines)
{
    assert(lines.size() > 0);
    const auto begin = [lines](const Field&, std::uint64_t) { return Repeated(lines); };
    return {"drawing", name,         Text::tr("The lines of a drawing, in the drawing's order."),
            begin,     lines.size(), true};
}

TestScene repeatedScene(const QString& name, std::vector<clipping::Segment> lines)
{
    return drawingScene(name,
                        SceneLines(std::vector{Shared(SceneBlock{.segments = std::move(lines)})}));
}

} // namespace app
