// SPDX-License-Identifier: GPL-3.0-or-later
// Lines and rays keep the contract of clipping/algorithm.h: for every row that clips them, against
// whole numbers of any length. The inputs are those of the segments, whose two points are all the
// same numbers.
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstring>
#include <limits>

#include "tests/clipping/contract.h"
#include "tests/clipping/rows.h"

using namespace clipping;

namespace {

using Int = boost::multiprecision::number<boost::multiprecision::cpp_int_backend<>,
                                          boost::multiprecision::et_off>;

constexpr int leastPlace = -1074;

int lastPlace(double x) { return x == 0 ? leastPlace : std::max(std::ilogb(x) - 52, leastPlace); }

/// A parameter: over / under, under > 0.
struct Ratio {
    Int over, under;
    bool operator<(const Ratio& t) const { return over * t.under < t.over * under; }
};

/// What is visible, from one parameter to another; an end that is none of a cut has no parameter.
struct Part {
    std::optional<Ratio> from, to;
};

/// All numbers in units of a power of two, fine enough for a result too.
class Truth {
public:
    Truth(const Segment& points, const Window& w, bool isRay) : isRay_(isRay)
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

bool within(const glm::dvec2& p, const Window& w)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}
bool sameBits(const glm::dvec2& p, const glm::dvec2& q)
{
    return std::memcmp(&p, &q, sizeof p) == 0;
}

/// How a result breaks the contract with this k; empty if it keeps it.
std::string endlessFault(const std::optional<Segment>& found, const Input& input, bool isRay,
                         double k)
{
    const auto& [points, w] = input;
    if (points.a == points.b)
        return found ? "seen without a direction" : "";
    const Truth truth(points, w, isRay);
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

/// What a row does with one of both.
template <class S>
struct Row {
    const Algorithm* algorithm;
    const Uses<S, Window, Segment>* uses;
    static constexpr bool isRay = std::is_same_v<S, Ray>;

    std::string faultAt(const Input& input, double k) const
    {
        const auto found = uses->clip(S{input.segment.a, input.segment.b}, input.window);
        const auto wrong = endlessFault(found, input, isRay, k);
        return wrong.empty() ? "" : wrong + " for " + exactly(input);
    }
};

template <class S>
std::vector<Row<S>> rows()
{
    std::vector<Row<S>> all;
    for (const Algorithm& a : algorithms()) {
        if constexpr (std::is_same_v<S, Line>)
            all.push_back({&a, a.line});
        else
            all.push_back({&a, a.ray});
        if (!all.back().uses)
            all.pop_back();
    }
    return all;
}

template <class S>
void compareFamilies()
{
    for (const Family& family : families()) {
        const auto inputs = family.inputs();
        const std::size_t step = std::max<std::size_t>(1, inputs.size() / 15'000);
        for (std::size_t i = 0; i < inputs.size(); i += step)
            for (const auto& row : rows<S>()) {
                const auto wrong = row.faultAt(inputs[i], row.algorithm->ulps);
                QVERIFY2(wrong.empty(), (row.algorithm->key.data() + (": " + wrong)).c_str());
            }
    }
}

/// On small whole numbers no wrong decision is excused.
template <class S>
void compareGrid()
{
    for (const Input& input : grid())
        for (const auto& row : rows<S>()) {
            const auto wrong = row.faultAt(input, 0);
            QVERIFY2(wrong.empty(), (row.algorithm->key.data() + (": " + wrong)).c_str());
        }
}

template <class S>
void compareUses()
{
    for (const Family& family : families()) {
        const auto inputs = family.inputs();
        for (std::size_t i = 0; i < inputs.size() && i < 2'000; ++i)
            for (const auto& [algorithm, uses] : rows<S>()) {
                const auto& [points, w] = inputs[i];
                const S endless{points.a, points.b};
                const auto text = exactly(inputs[i]);
                const auto piece = uses->clip(endless, w);
                std::array<Clipped, 1> out;
                QVERIFY2((uses->clipAll({&endless, 1}, w, out) == 1) == piece.has_value(),
                         text.c_str());
                const Trace trace = uses->trace(endless, w);
                QVERIFY2((trace.outcome == Outcome::Visible) == piece.has_value(), text.c_str());
                QVERIFY2(trace.steps.empty() == (points.a == points.b), text.c_str());
                const auto cost = uses->count({&endless, 1}, w);
                QVERIFY2((cost.comparisons == 0) == (points.a == points.b), text.c_str());
                if (!piece)
                    continue;
                QVERIFY2(::sameBits(*piece, out[0].segment) && ::sameBits(*piece, trace.visible),
                         text.c_str());
                const bool keepsA = Row<S>::isRay && piece->a == points.a;
                QVERIFY2((cutEdgeOfA(out[0].cut) == Edge::None) == keepsA, text.c_str());
                QVERIFY2(cutEdgeOfB(out[0].cut) != Edge::None, text.c_str());
            }
    }
}

template <class S>
void compareWithoutNumbers()
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const auto& [algorithm, uses] : rows<S>()) {
        for (const double by : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
            for (int index = 0; index < 8; ++index) {
                S endless{{-1, 0.5}, {3, 0.5}};
                Window w{{0, 0}, {2, 2}};
                QVERIFY(uses->clip(endless, w));
                *std::array{
                    &endless.a.x, &endless.a.y, &endless.b.x, &endless.b.y,
                    &w.min.x,     &w.min.y,     &w.max.x,     &w.max.y}[std::size_t(index)] = by;
                QVERIFY(!uses->clip(endless, w));
                QVERIFY(uses->trace(endless, w).steps.empty());
            }
        QVERIFY(!uses->clip(S{{-1, 0.5}, {3, 0.5}}, {{2, 0}, {0, 2}}));
    }
}

} // namespace

class EndlessTest : public QObject {
    Q_OBJECT

private slots:
    void rowsAreThere()
    {
        for (const char* key : {"liang-barsky", "cyrus-beck", "skala", "matthes-drakopoulos"}) {
            QVERIFY2(findAlgorithm(key)->line, key);
            QVERIFY2(findAlgorithm(key)->ray, key);
        }
    }
    void linesOfTheGrid() { compareGrid<Line>(); }
    void raysOfTheGrid() { compareGrid<Ray>(); }
    void lines() { compareFamilies<Line>(); }
    void rays() { compareFamilies<Ray>(); }
    void usesOfLines() { compareUses<Line>(); }
    void usesOfRays() { compareUses<Ray>(); }
    void linesWithoutNumbers() { compareWithoutNumbers<Line>(); }
    void raysWithoutNumbers() { compareWithoutNumbers<Ray>(); }
};

QTEST_APPLESS_MAIN(EndlessTest)
#include "endless_test.moc"
