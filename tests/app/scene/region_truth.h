// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <boost/rational.hpp>
#include <vector>

/// What clip windows keep of a line whose numbers are small whole ones, found point by point in
/// fractions. Shares no code and no types with the program.
namespace truth {

using Fraction = boost::rational<long long>;
enum class Does { Add, CutOut, Intersect, Replace };
struct Rectangle {
    std::array<int, 2> min, max;
    Does does;
};
struct Line {
    std::array<int, 2> a, b;
};
/// From one share of the way along the line to another one.
struct Kept {
    Fraction from, to;
};

inline std::array<Fraction, 2> pointOf(const Line& line, const Fraction& t)
{
    return {line.a[0] + t * (line.b[0] - line.a[0]), line.a[1] + t * (line.b[1] - line.a[1])};
}

/// Whether a point belongs to what the rectangles describe. Rectangles are closed; one that is
/// inverted or without area has no point.
inline bool holds(const std::vector<Rectangle>& list, const std::array<Fraction, 2>& p)
{
    bool in = list.empty() || list[0].does != Does::Add;
    for (const Rectangle& r : list) {
        const bool area = r.min[0] < r.max[0] && r.min[1] < r.max[1];
        const bool within = area && p[0] >= Fraction(r.min[0]) && p[0] <= Fraction(r.max[0])
                            && p[1] >= Fraction(r.min[1]) && p[1] <= Fraction(r.max[1]);
        switch (r.does) {
        case Does::Add:
            in = in || within;
            break;
        case Does::CutOut:
            in = in && !within;
            break;
        case Does::Intersect:
            in = in && within;
            break;
        case Does::Replace:
            in = within;
        }
    }
    return in;
}

/// Where the line meets the line of an edge, and its ends: ascending.
inline std::vector<Fraction> crossings(const std::vector<Rectangle>& list, const Line& line)
{
    std::vector<Fraction> all{0, 1};
    for (const Rectangle& r : list)
        for (const auto& corner : {r.min, r.max})
            for (int k = 0; k < 2; ++k)
                if (const int d = line.b[k] - line.a[k]; d != 0)
                    if (const Fraction t(corner[k] - line.a[k], d);
                        t > Fraction(0) && t < Fraction(1))
                        all.push_back(t);
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return line.a == line.b ? std::vector<Fraction>{0} : all;
}

/// The closure of the points that are held (or of those that are not), in the line's order.
inline std::vector<Kept> kept(const std::vector<Rectangle>& list, bool inside, const Line& line)
{
    const auto wanted = [&](const Fraction& t) {
        return list.empty() || holds(list, pointOf(line, t)) == inside;
    };
    const std::vector<Fraction> at = crossings(list, line);
    std::vector<Kept> all;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const bool joins = !all.empty() && all.back().to == at[i];
        if (wanted(at[i]) && !joins)
            all.push_back({at[i], at[i]});
        if (i + 1 == at.size() || !wanted((at[i] + at[i + 1]) / 2))
            continue;
        if (!all.empty() && all.back().to == at[i])
            all.back().to = at[i + 1];
        else
            all.push_back({at[i], at[i + 1]});
    }
    return all;
}

} // namespace truth
