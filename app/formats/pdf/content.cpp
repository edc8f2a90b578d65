// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/pdf/content.h"

#include "app/base/number.h"
#include "app/formats/coordinates.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace app::pdf {
namespace {

std::string operand(double value)
{
    std::string result;
    appendNumber(result, value);
    return result;
}

// A line that covers the same area as a square cap at a point, because PDF does not paint square
// caps of lines without length.
Object squareAt(const Point& p, const Style& style)
{
    const Point half{style.width / 2, 0};
    Object square{Path(clipping::Segment{p - half, p + half}), style};
    square.style.cap = Cap::Butt;
    square.style.fill.reset();
    square.style.dashes.clear();
    return square;
}

std::string stateName(int alpha) { return "/A" + std::to_string(alpha); }

std::string imageName(std::size_t number) { return "/I" + std::to_string(number); }

// The dash operator with dashes and phase. PDF requires a positive phase. An odd pattern is
// doubled, because poppler draws it wrongly. A pattern of total length 0 is a solid line.
std::string dashOperator(const Style& style)
{
    std::vector<double> pattern = style.dashes;
    if (pattern.size() % 2 == 1)
        pattern.insert(pattern.end(), style.dashes.begin(), style.dashes.end());
    const double period = std::accumulate(pattern.begin(), pattern.end(), 0.0);
    if (!(period > 0))
        return "[] 0 d\n";
    std::string result = "[";
    for (const double dash : pattern)
        result += operand(dash) + ' ';
    const double phase = std::fmod(style.dashOffset, period);
    return result + "] " + operand(phase < 0 ? phase + period : phase) + " d\n";
}

std::string colour(const Colour& c)
{
    const auto part = [](std::uint8_t value) {
        std::string result;
        appendNumber(result, value / 255.0, 4, 0, 1); // precise enough to give the same byte
        return result;
    };
    return part(c.red) + ' ' + part(c.green) + ' ' + part(c.blue);
}

// The operators for width, cap, join, miter limit and dashes.
std::string pen(const Style& style)
{
    return operand(style.width) + " w " + std::to_string(int(style.cap)) + " J "
           + std::to_string(int(style.join)) + " j " + operand(std::max(1.0, style.miterLimit))
           + " M " + dashOperator(style);
}
static_assert(int(Cap::Butt) == 0 && int(Cap::Round) == 1 && int(Cap::Square) == 2);
static_assert(int(Join::Miter) == 0 && int(Join::Round) == 1 && int(Join::Bevel) == 2);

} // namespace

void Content::set(std::string& last, const std::string& now)
{
    if (now != last)
        text_ += last = now;
}

void Content::place(double scale, const Point& origin)
{
    text_ += operand(scale) + " 0 0 " + operand(-scale) + ' ' + operand(origin.x) + ' '
             + operand(origin.y) + " cm\n";
}

void Content::paint(const Object& object)
{
    const Style& style = object.style;
    const std::vector<Subpath> subpaths = object.path.subpaths();
    if (style.fill) {
        setAlpha(style.fill->alpha);
        set(fill_, colour(*style.fill) + " rg\n");
        outline(subpaths);
        text_ += style.fillRule == FillRule::EvenOdd ? "f*\n" : "f\n";
    }
    if (style.stroke && style.width > 0) {
        setAlpha(style.stroke->alpha);
        set(stroke_, colour(*style.stroke) + " RG\n");
        set(pen_, pen(style));
        outline(subpaths);
        text_ += "S\n";
        for (const Subpath& path : subpaths)
            if (path.segments.empty() && style.cap == Cap::Square)
                paint(squareAt(path.start, style));
    }
}

void Content::paint(const Underlay& underlay, std::size_t number)
{
    const auto& [file, place, clip, opacity, svgId] = underlay;
    setAlpha(std::uint8_t(std::lround(std::clamp(opacity, 0.0, 1.0) * 255)));
    text_ += "q\n";
    for (std::size_t i = 0; i < clip.size(); ++i)
        text_ += operand(clip[i].x) + ' ' + operand(clip[i].y) + (i == 0 ? " m\n" : " l\n");
    text_ += clip.empty() ? "" : "h W n\n";
    const Point across = place.x * double(file->width), down = place.y * double(file->height);
    const Point corner = place.to + down; // an image in PDF has its origin at the lower left
    for (const double entry : {across.x, across.y, -down.x, -down.y, corner.x, corner.y})
        text_ += operand(entry) + ' ';
    text_ += "cm\n" + imageName(number) + " Do\nQ\n";
    images_.insert(number);
}

void Content::outline(std::span<const Subpath> subpaths)
{
    const auto point = [&](const Point& p, const char* operation) {
        appendPoint(text_, p, ' ', options_);
        text_ += operation;
    };
    const auto controls = [&](const PathSegment& curve) {
        for (const Point& control : {curve.control1, curve.control2}) {
            appendControl(text_, control, ' ', options_);
            text_ += ' ';
        }
    };
    for (const Subpath& path : subpaths) {
        point(path.start, " m\n");
        for (const PathSegment& segment : path.segments) {
            if (segment.curved)
                controls(segment);
            point(segment.to, segment.curved ? " c\n" : " l\n");
        }
        if (path.segments.empty())
            point(path.start, " l\n"); // a point is a line without length
        if (path.closed)
            text_ += "h\n";
    }
}

void Content::setAlpha(std::uint8_t alpha)
{
    if (alpha != 255 || !alphas_.empty()) {
        alphas_.insert(alpha);
        set(alpha_, stateName(alpha) + " gs\n");
    }
}

std::string Content::resources() const
{
    std::string states;
    for (const int alpha : alphas_) {
        const std::string value = operand(std::round(alpha / 255.0 * 10'000) / 10'000);
        states.append(stateName(alpha)).append("<</CA ").append(value);
        states.append("/ca ").append(value).append(">>");
    }
    std::string images;
    for (const std::size_t number : images_)
        images.append(imageName(number)).append(" ").append(std::to_string(number)).append(" 0 R");
    return (states.empty() ? states : "/ExtGState<<" + states + ">>")
           + (images.empty() ? images : "/XObject<<" + images + ">>");
}

} // namespace app::pdf
