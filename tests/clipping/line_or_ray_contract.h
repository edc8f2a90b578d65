// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The contract of clipping/algorithm.h for lines and rays, checked with integers of any length.

#include "clipping/algorithm.h"

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <optional>
#include <string>

#include "tests/clipping/contract.h"

namespace line_or_ray_contract {

using Int = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                          boost::multiprecision::et_off>;

constexpr int leastPlace = -1074;

inline int lastPlace(double x)
{
    return x == 0 ? leastPlace : std::max(std::ilogb(x) - 52, leastPlace);
}

/// A parameter: over / under, under > 0.
struct Ratio {
    Int over, under;
    bool operator<(const Ratio& t) const { return over * t.under < t.over * under; }
};

/// The visible part, from one parameter to another; an end that is not a cut has no parameter.
struct Part {
    std::optional<Ratio> from, to;
};

/// All numbers in units of a power of two, fine enough for a result too.
class Truth {
public:
    Truth(const clipping::Segment& points, const clipping::Window& w, bool isRay) : isRay_(isRay)
    {
        const std::array all{points.a.x, points.a.y, points.b.x, points.b.y,
                             w.min.x,    w.min.y,    w.max.x,    w.max.y};
        unit_ = ulp_ = lastPlace(
            std::abs(*std::ranges::max_element(all, {}, [](double x) { return std::abs(x); })));
        for (const double x : all)
            if (x != 0)
                unit_ = std::min(unit_, lastPlace(x));
        unit_ -= 8; // a result has finer bits
        for (int k = 0; k < 2; ++k) {
            a_[k] = whole(points.a[k]), d_[k] = whole(points.b[k]) - a_[k];
            low_[k] = whole(w.min[k]), high_[k] = whole(w.max[k]);
        }
    }

    /// With the sides of the window moved out by `ulps`, in if negative.
    std::optional<Part> inside(int ulps) const
    {
        Part found;
        if (isRay_)
            found.from = Ratio{0, 1};
        for (int k = 0; k < 2; ++k) {
            const Int low = low_[k] - ulp() * ulps, high = high_[k] + ulp() * ulps;
            if (low > high || (d_[k] == 0 && (a_[k] < low || a_[k] > high)))
                return std::nullopt;
            if (d_[k] == 0)
                continue;
            const bool up = d_[k] > 0;
            const Int under = up ? d_[k] : Int(-d_[k]);
            const Ratio in{up ? Int(low - a_[k]) : Int(a_[k] - high), under};
            const Ratio out{up ? Int(high - a_[k]) : Int(a_[k] - low), under};
            found.from = found.from ? std::max(*found.from, in) : in;
            found.to = found.to ? std::min(*found.to, out) : out;
        }
        if (*found.to < *found.from)
            return std::nullopt;
        return found;
    }

    /// Whether p is the point at t, by `ulps`.
    bool isAt(const glm::dvec2& p, const Ratio& t, double ulps) const
    {
        for (int k = 0; k < 2; ++k) {
            const Int off = (whole(p[k]) - a_[k]) * t.under - d_[k] * t.over;
            if ((off < 0 ? Int(-off) : off) > ulp() * int(ulps) * t.under)
                return false;
        }
        return true;
    }

private:
    Int ulp() const { return Int(1) << unsigned(ulp_ - unit_); }
    Int whole(double x) const
    {
        if (x == 0)
            return 0;
        const int place = lastPlace(x);
        const auto m =
            static_cast<long long>(std::ldexp(std::ldexp(x, -place / 2), -(place - place / 2)));
        return place >= unit_       ? Int(m) << unsigned(place - unit_)
               : unit_ - place > 62 ? Int(0)
                                    : Int(m / (1LL << unsigned(unit_ - place)));
    }
    int unit_, ulp_;
    bool isRay_;
    Int a_[2], d_[2], low_[2], high_[2];
};

inline bool within(const glm::dvec2& p, const clipping::Window& w)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

} // namespace line_or_ray_contract

/// How a result breaks the contract with this k; empty if it keeps it. With 0, on small whole
/// numbers: no wrong decision is excused.
inline std::string lineOrRayFault(const std::optional<clipping::Segment>& found, const Input& input,
                                  bool isRay, double k)
{
    using line_or_ray_contract::within;
    const auto& [points, w] = input;
    if (points.a == points.b)
        return found ? "seen without a direction" : "";
    const line_or_ray_contract::Truth truth(points, w, isRay);
    const auto part = truth.inside(0);
    if (!found)
        return part && (k == 0 || truth.inside(-int(k))) ? "lost" : "";
    if (!within(found->a, w) || !within(found->b, w))
        return "outside the window";
    if (!part)
        return k != 0 && truth.inside(int(k)) ? "" : "seen where there is nothing";
    if (isRay && within(points.a, w) && !sameBits(points.a, found->a))
        return "an inner end has moved";
    if (k == 0 && !(*part->from < *part->to) && found->a != found->b)
        return "a contact that is no point";
    const double most = k == 0 ? 24 : k;
    return truth.isAt(found->a, *part->from, most) && truth.isAt(found->b, *part->to, most)
               ? ""
               : "not the right ends";
}
