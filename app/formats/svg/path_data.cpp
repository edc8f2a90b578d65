// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/path_data.h"

#include "app/base/text.h"
#include "app/formats/svg/arc.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

// Turns a path that is only a line to its own start into a point.
void settle(Subpath& path)
{
    if (!path.closed && path.segments.size() == 1 && !path.segments.front().curved
        && path.segments.front().to == path.start)
        path.segments.clear();
}

class PathReader {
public:
    explicit PathReader(std::string_view text) : in_(text) {}

    Outline read()
    {
        in_.skipBlanks();
        while (!in_.atEnd() && !outline_.damaged)
            outline_.damaged = !step();
        finish();
        return std::move(outline_);
    }

private:
    // Reads one command, or one more set of numbers for the last command.
    bool step()
    {
        const char c = in_.peek();
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
        if (letter) {
            in_.take(c);
            in_.skipBlanks();
            command_ = c;
        } else if (command_ == 'M' || command_ == 'm') {
            command_ = command_ == 'M' ? 'L' : 'l';
        }
        relative_ = command_ >= 'a';
        const char upper = relative_ ? char(command_ - 'a' + 'A') : command_;
        if ((!begun_ && upper != 'M') || (!letter && upper == 'Z'))
            return false;
        const bool read = draw(upper);
        previous_ = upper;
        in_.skipSeparator();
        return read;
    }

    bool draw(char upper)
    {
        struct Command {
            char letter;
            bool (PathReader::*draw)();
        };
        static constexpr std::array commands{
            Command{'M', &PathReader::move},       Command{'L', &PathReader::line},
            Command{'H', &PathReader::horizontal}, Command{'V', &PathReader::vertical},
            Command{'C', &PathReader::cubic},      Command{'S', &PathReader::smoothCubic},
            Command{'Q', &PathReader::quadratic},  Command{'T', &PathReader::smoothQuadratic},
            Command{'A', &PathReader::arc},        Command{'Z', &PathReader::close},
        };
        const auto found = std::ranges::find(commands, upper, &Command::letter);
        return found != commands.end() && (this->*found->draw)();
    }

    std::optional<Point> point()
    {
        const auto x = in_.number();
        in_.skipSeparator();
        const auto y = x ? in_.number() : std::nullopt;
        if (!y)
            return std::nullopt;
        in_.skipSeparator();
        return relative_ ? at_ + Point{*x, *y} : Point{*x, *y};
    }

    bool move()
    {
        const auto p = point();
        if (!p)
            return false;
        finish();
        at_ = start_ = *p;
        begun_ = true;
        return true;
    }

    bool line()
    {
        const auto p = point();
        if (p)
            append({*p});
        return p.has_value();
    }

    bool horizontal() { return along(0); }
    bool vertical() { return along(1); }

    bool along(int axis)
    {
        const auto number = in_.number();
        if (!number)
            return false;
        Point p = at_;
        p[axis] = *number + (relative_ ? at_[axis] : 0);
        append({p});
        return true;
    }

    bool cubic()
    {
        const auto c1 = point(), c2 = c1 ? point() : c1, p = c2 ? point() : c2;
        if (!p)
            return false;
        append({*p, *c1, *c2, true});
        return true;
    }

    bool smoothCubic()
    {
        const Point c1 = previous_ == 'C' || previous_ == 'S' ? 2.0 * at_ - control_ : at_;
        const auto c2 = point(), p = c2 ? point() : c2;
        if (!p)
            return false;
        append({*p, c1, *c2, true});
        return true;
    }

    bool quadratic()
    {
        const auto control = point(), p = control ? point() : control;
        if (p)
            appendQuadratic(*control, *p);
        return p.has_value();
    }

    bool smoothQuadratic()
    {
        const Point control = previous_ == 'Q' || previous_ == 'T' ? 2.0 * at_ - control_ : at_;
        const auto p = point();
        if (p)
            appendQuadratic(control, *p);
        return p.has_value();
    }

    bool arc()
    {
        std::array<double, 3> v{};
        for (double& number : v) {
            const auto read = in_.number();
            if (!read)
                return false;
            number = *read;
            in_.skipSeparator();
        }
        const auto large = in_.flag();
        in_.skipSeparator();
        const auto positive = large ? in_.flag() : large;
        in_.skipSeparator();
        const auto to = positive ? point() : std::nullopt;
        if (!to)
            return false;
        begin();
        const auto first = path_.segments.size();
        appendArc(path_.segments, {at_, *to, {v[0], v[1]}, v[2], *large, *positive});
        for (auto i = first; i + 1 < path_.segments.size(); ++i)
            outline_.joints.push_back({outline_.paths.size(), i});
        at_ = *to;
        return true;
    }

    void appendQuadratic(const Point& control, const Point& to)
    {
        const Point from = at_;
        append({to, from + (control - from) * (2.0 / 3), to + (control - to) * (2.0 / 3), true});
        control_ = control;
    }

    void append(const PathSegment& segment)
    {
        begin();
        path_.segments.push_back(segment);
        at_ = segment.to;
        control_ = segment.control2;
        if (path_.segments.size() > mostParts)
            throw Refused{Text::tr("has a path of more than %1 points.").arg(mostParts)};
    }

    bool close()
    {
        begin();
        path_.closed = true;
        finish();
        at_ = start_;
        return true;
    }

    void begin()
    {
        if (!drawn_)
            path_ = {start_, {}, false};
        drawn_ = true;
    }

    void finish()
    {
        if (drawn_ && (path_.closed || !path_.segments.empty())) {
            settle(path_);
            outline_.paths.push_back(std::move(path_));
        }
        drawn_ = false;
    }

    Scanner in_;
    Outline outline_;
    Subpath path_;
    Point start_{}, at_{};
    Point control_{}; ///< of the last command, for smooth curves
    char command_ = 0, previous_ = 0;
    bool relative_ = false;
    bool begun_ = false; ///< whether there was a move
    bool drawn_ = false; ///< whether path_ is being drawn
};

} // namespace

Outline parsePathData(std::string_view text)
{
    if (trimmed(text) == "none")
        return {};
    return PathReader(text).read();
}

Subpath lineBetween(const Point& from, const Point& to)
{
    Subpath path{from, {{to}}, false};
    settle(path);
    return path;
}

Outline parsePoints(std::string_view text, Ending ending)
{
    Outline outline;
    Subpath path;
    Scanner in(text);
    std::size_t count = 0;
    for (in.skipBlanks(); !in.atEnd() && !outline.damaged; in.skipSeparator()) {
        const auto x = in.number();
        in.skipSeparator();
        const auto y = x ? in.number() : std::nullopt;
        outline.damaged = !y;
        if (y && count++ == 0)
            path.start = {*x, *y};
        else if (y)
            path.segments.push_back({{*x, *y}});
    }
    path.closed = ending == Ending::Closed;
    settle(path);
    if (count > 1 || (count == 1 && path.closed))
        outline.paths.push_back(std::move(path));
    return outline;
}

} // namespace app::svg
