// SPDX-License-Identifier: GPL-3.0-or-later
// Every end of a cut beside a reference, which knows nothing of polygons: the roots of the true
// curves' equations, in extended precision.
#include "app/cut/cut.h"
#include "app/document/arc_curves.h"
#include "app/document/document_builder.h"
#include "app/document/recipe_outline.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "tests/app/document/sheet.h"
#include "tests/deep.h"
#include "tests/test_class.h"

namespace cut_true_cuts_test {

using namespace app;

namespace {

using Real = long double; // 64 bits
struct Vector {
    Real x, y;
};
Vector operator-(const Vector& a, const Vector& b) { return {a.x - b.x, a.y - b.y}; }
Real crossOf(const Vector& a, const Vector& b) { return a.x * b.y - a.y * b.x; }

constexpr Real exact = 1e-6L; // mm: how far an end may be off
constexpr Real least = 1e-3L; // what is shorter may be left out

const Point centre(100, 90);

double number(std::mt19937_64& random, double low, double high)
{
    return low + (high - low) * double(random() >> 11) * 0x1p-53;
}

/// A polynomial from 0 to 1 by its Bernstein coefficients.
using Polynomial = std::vector<Real>;

/// The coefficients of both halves.
std::pair<Polynomial, Polynomial> halvesOf(Polynomial p)
{
    Polynomial low, high(p.size());
    for (std::size_t n = p.size(); n > 0; --n) {
        low.push_back(p.front());
        high[n - 1] = p[n - 1];
        for (std::size_t i = 0; i + 1 < n; ++i)
            p[i] = (p[i] + p[i + 1]) / 2;
    }
    return {low, high};
}

/// All roots, by halving until their signs say that there is none, or one.
void addRoots(const Polynomial& p, Real low, Real high, std::vector<Real>& roots)
{
    int changes = 0;
    for (std::size_t i = 1; i < p.size(); ++i)
        changes += (p[i] < 0) != (p[i - 1] < 0);
    if (changes == 0)
        return;
    const Real middle = (low + high) / 2;
    if (!(middle > low && middle < high) || high - low < 1e-18L) {
        roots.push_back(middle);
        return;
    }
    const auto [left, right] = halvesOf(p);
    addRoots(left, low, middle, roots);
    addRoots(right, middle, high, roots);
}

Polynomial product(const Polynomial& a, const Polynomial& b)
{
    const auto choose = [](std::size_t n, std::size_t k) {
        Real value = 1;
        for (std::size_t i = 0; i < k; ++i)
            value = value * Real(n - i) / Real(i + 1);
        return value;
    };
    const std::size_t m = a.size() - 1, n = b.size() - 1;
    Polynomial all(m + n + 1, 0);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            all[i + j] += a[i] * b[j] * choose(m, i) * choose(n, j) / choose(m + n, i + j);
    return all;
}

/// A line or a cubic curve.
struct Curve {
    std::vector<Vector> points;

    Vector at(Real t) const
    {
        std::vector<Vector> p = points;
        for (std::size_t n = p.size(); n > 1; --n)
            for (std::size_t i = 0; i + 1 < n; ++i)
                p[i] = {p[i].x + (p[i + 1].x - p[i].x) * t, p[i].y + (p[i + 1].y - p[i].y) * t};
        return p.front();
    }
};

Curve curveOf(const Point& from, const PathSegment& s)
{
    const auto v = [](const Point& p) { return Vector{p.x, p.y}; };
    return s.curved ? Curve{{v(from), v(s.control1), v(s.control2), v(s.to)}}
                    : Curve{{v(from), v(s.to)}};
}

/// The image of the unit circle.
struct Ellipse {
    Vector centre, axis1, axis2;

    /// Below 0 inside.
    Real value(const Vector& p) const
    {
        const Real all = crossOf(axis1, axis2);
        const Real x = crossOf(p - centre, axis2) / all, y = crossOf(axis1, p - centre) / all;
        return x * x + y * y - 1;
    }
    std::vector<Real> meetings(const Curve& curve) const
    {
        const Real all = crossOf(axis1, axis2);
        Polynomial x, y;
        for (const Vector& p : curve.points) {
            x.push_back(crossOf(p - centre, axis2) / all);
            y.push_back(crossOf(axis1, p - centre) / all);
        }
        Polynomial sum = product(x, x);
        const Polynomial other = product(y, y);
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += other[i] - 1;
        std::vector<Real> roots;
        addRoots(sum, 0, 1, roots);
        return roots;
    }
};

/// An outline of lines and curves that crosses itself nowhere.
struct Outline {
    std::vector<Curve> curves;

    /// By halving the larger of two curves whose boxes meet.
    static void addMeetings(const Curve& a, Real a0, Real a1, const Curve& b,
                            std::vector<Real>& found)
    {
        struct Box {
            explicit Box(const Curve& c) : min(c.points[0]), max(c.points[0])
            {
                for (const Vector& p : c.points) {
                    min = {std::min(min.x, p.x), std::min(min.y, p.y)};
                    max = {std::max(max.x, p.x), std::max(max.y, p.y)};
                }
            }
            Real size() const { return std::max(max.x - min.x, max.y - min.y); }
            Vector min, max;
        };
        const Box p(a), q(b);
        if (p.max.x < q.min.x || q.max.x < p.min.x || p.max.y < q.min.y || q.max.y < p.min.y)
            return;
        constexpr Real small = 1e-12L;
        if (std::max(p.size(), q.size()) < small)
            return found.push_back((a0 + a1) / 2);
        const auto halves = [](const Curve& c) {
            Polynomial x, y;
            for (const Vector& v : c.points)
                x.push_back(v.x), y.push_back(v.y);
            const auto [x1, x2] = halvesOf(x);
            const auto [y1, y2] = halvesOf(y);
            std::array<Curve, 2> both;
            for (std::size_t i = 0; i < x.size(); ++i) {
                both[0].points.push_back({x1[i], y1[i]});
                both[1].points.push_back({x2[i], y2[i]});
            }
            return both;
        };
        if (p.size() < q.size()) {
            for (const Curve& half : halves(b))
                addMeetings(a, a0, a1, half, found);
            return;
        }
        const auto [low, high] = halves(a);
        const Real middle = (a0 + a1) / 2;
        addMeetings(low, a0, middle, b, found);
        addMeetings(high, middle, a1, b, found);
    }
    std::vector<Real> meetings(const Curve& curve) const
    {
        std::vector<Real> found;
        for (const Curve& own : curves)
            addMeetings(curve, 0, 1, own, found);
        std::ranges::sort(found);
        std::vector<Real> apart;
        for (const Real t : found)
            if (apart.empty() || t - apart.back() > 1e-10L)
                apart.push_back(t);
        return apart;
    }
};

struct Case {
    ClipWindow window;
    std::function<std::vector<Real>(const Curve&)> meetings;
};

ClipWindow windowOf(const Subpath& path, Recipe recipe = {})
{
    return {QString(), PathShape{Path(std::span(&path, 1)), FillRule::NonZero, recipe}};
}

Case ellipseCase(const Point& axis1, const Point& axis2, int arcs)
{
    const auto v = [](const Point& p) { return Vector{p.x, p.y}; };
    const Ellipse ellipse{v(centre), v(axis1), v(axis2)};
    const auto meetings = [=](const Curve& curve) { return ellipse.meetings(curve); };
    if (arcs == 0) {
        const EllipseRecipe recipe{centre, {axis1.x, axis2.y}};
        return {windowOf(*outlineOf(recipe), recipe), meetings};
    }
    const EllipseArc all{centre, axis1, axis2, 0.4, 2 * std::numbers::pi};
    Subpath path{all.at(0.4), {}, true};
    for (int i = 0; i < arcs; ++i) {
        const double step = all.sweep / arcs;
        const EllipseArc arc{centre, axis1, axis2, 0.4 + i * step, step};
        appendCurves(path.segments, arc, i == 0 ? path.start : path.segments.back().to,
                     i + 1 == arcs ? path.start : arc.at(arc.angle + step));
    }
    return {windowOf(path), meetings};
}

/// Curves around the centre, which bend in and out.
Case outlineCase(std::mt19937_64& random)
{
    constexpr int corners = 6;
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2 * std::numbers::pi * i / corners;
        points.push_back(centre + number(random, 25, 50) * Point(std::cos(angle), std::sin(angle)));
    }
    Subpath path{points[0], {}, true};
    for (std::size_t i = 0; i < corners; ++i) {
        const Point from = points[i], to = points[(i + 1) % corners], along = to - from;
        const Point across(along.y, -along.x);
        path.segments.push_back({to, from + 0.3 * along + number(random, -0.3, 0.3) * across,
                                 to - 0.25 * along + number(random, -0.3, 0.3) * across, true});
    }
    Outline outline;
    Point from = path.start;
    for (const PathSegment& s : path.segments) {
        outline.curves.push_back(cut_true_cuts_test::curveOf(from, s));
        from = s.to;
    }
    return {windowOf(path), [=](const Curve& curve) { return outline.meetings(curve); }};
}

std::vector<Subpath> cutAt(const ClipWindow& window, const Subpath& path, Keep keep)
{
    Sheet sheet;
    sheet.shapes.push_back({{path}, {.stroke = Colour{}}, QString(), 0, false});
    Document document = documentOf(sheet);
    CutOptions options{.clipAll = clipping::exactAlgorithm().corrected.clipAll};
    app::cutAt(options, {{window}, keep}, document.page());
    document.apply(cut(document, options).edit);
    std::vector<Subpath> all;
    for (const Shape& shape : sheetOf(document).shapes)
        all.insert(all.end(), shape.paths.begin(), shape.paths.end());
    return all;
}

std::vector<Vector> cutEndsOf(const std::vector<Subpath>& parts, const Subpath& whole)
{
    std::vector<Vector> ends;
    for (const Subpath& part : parts)
        for (const Point& end :
             {part.start, part.segments.empty() ? part.start : part.segments.back().to})
            if (end != whole.start && end != whole.segments.back().to)
                ends.push_back({end.x, end.y});
    return ends;
}

Real distance(const Vector& a, const Vector& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Near a parameter.
Real distanceTo(const Curve& curve, const Vector& p, Real t)
{
    Real low = t - 0.01L, high = t + 0.01L;
    for (int i = 0; i < 200; ++i) {
        const Real a = low + (high - low) / 3, b = high - (high - low) / 3;
        const bool isLow = distance(curve.at(a), p) < distance(curve.at(b), p);
        (isLow ? high : low) = isLow ? b : a;
    }
    return distance(curve.at((low + high) / 2), p);
}

struct Counts {
    std::size_t cuts = 0, off = 0, missing = 0, extra = 0;
};

/// Compares the ends of what is inside with the reference.
void compare(const Case& each, const Subpath& path, Counts& counts)
{
    const Curve curve = cut_true_cuts_test::curveOf(path.start, path.segments[0]);
    std::vector<Vector> expected;
    std::vector<bool> isSure;
    const auto roots = each.meetings(curve);
    // What ends within a micrometre of the border ends on it; who goes beyond it by less than a
    // nanometre touches it.
    const auto isBeside = [&](const Vector& p, Real by) {
        const auto meets = [&](Real x, Real y) {
            return !each.meetings({{{p.x - x, p.y - y}, {p.x + x, p.y + y}}}).empty();
        };
        return meets(by, by) || meets(by, -by);
    };
    const auto isApart = [&](Real t, Real other) {
        const Real end = t < other ? 1 : 0, middle = (t + other) / 2;
        return distance(curve.at(t), curve.at(other)) > least
               && !(other == end && isBeside(curve.at(other), 2 * least))
               && !isBeside(curve.at(middle), 2 * exact);
    };
    for (std::size_t i = 0; i < roots.size(); ++i) {
        expected.push_back(curve.at(roots[i]));
        isSure.push_back(isApart(roots[i], i == 0 ? 0 : roots[i - 1])
                         && isApart(roots[i], i + 1 == roots.size() ? 1 : roots[i + 1]));
    }
    const auto ends = cutEndsOf(cutAt(each.window, path, Keep::Inside), path);
    counts.cuts += ends.size();
    const std::size_t wrongBefore = counts.off + counts.missing;
    std::vector<bool> isMet(expected.size());
    for (const Vector& end : ends) {
        Real nearest = 1e9L;
        std::size_t which = 0;
        for (std::size_t i = 0; i < expected.size(); ++i)
            if (const Real away = distance(end, expected[i]); away < nearest)
                nearest = away, which = i;
        // At very small angles, what is on both is not where they meet.
        const bool isOnBoth =
            !roots.empty() && isBeside(end, exact) && distanceTo(curve, end, roots[which]) <= exact;
        if (nearest > exact && !isOnBoth) {
            ++counts.off;
        } else if (isMet[which]) {
            ++counts.extra;
        } else {
            isMet[which] = true;
        }
    }
    for (std::size_t i = 0; i < expected.size(); ++i)
        counts.missing += isSure[i] && !isMet[i];
    if (qEnvironmentVariableIsSet("CLEARCUT_SHOW") && counts.off + counts.missing > wrongBefore) {
        QByteArray text;
        const auto add = [&](const char* what, const Vector& p) {
            text += QByteArray(what) + QByteArray::number(double(p.x), 'g', 17) + ','
                    + QByteArray::number(double(p.y), 'g', 17) + ' ';
        };
        for (const Vector& p : curve.points)
            add("", p);
        for (std::size_t i = 0; i < expected.size(); ++i) {
            add(isMet[i] ? "met " : isSure[i] ? "MISSED " : "unsure ", expected[i]);
            text += "t " + QByteArray::number(double(roots[i]), 'g', 12) + ' ';
        }
        for (const Vector& end : ends)
            add("end ", end);
        qInfo("%s", text.constData());
    }
}

} // namespace

class TrueCutsTest : public QObject {
    Q_OBJECT

private slots:
    void cutsAreTheReferences_data()
    {
        QTest::addColumn<int>("kind");
        QTest::addRow("circle") << 0;
        QTest::addRow("ellipse of arcs") << 1;
        QTest::addRow("curves") << 2;
        QTest::addRow("lines beside a circle") << 3;
        QTest::addRow("curves beside a circle") << 4;
    }
    void cutsAreTheReferences()
    {
        QFETCH(int, kind);
        std::mt19937_64 random(std::uint64_t(kind) + 5);
        const auto anywhere = [&] {
            const double x = number(random, -60, 60);
            return centre + Point(x, number(random, -60, 60));
        };
        Counts counts;
        const int pairs = tests::caseStep() == 1 ? 30'000 : 600;
        Case each = kind == 1   ? ellipseCase({50, 10}, {-12, 20}, 6)
                    : kind == 2 ? outlineCase(random)
                                : ellipseCase({40, 0}, {0, 40}, 0);
        for (int i = 0; i < pairs; ++i) {
            if (kind == 2 && i % 50 == 49)
                each = outlineCase(random);
            Subpath path{anywhere(), {{anywhere(), anywhere(), anywhere(), i % 2 == 0}}, false};
            if (kind >= 3) { // a micrometre or so from touching it
                const double angle = number(random, 0, 6.3), off = number(random, -3, 3);
                const Point out(std::cos(angle), std::sin(angle)), along(-out.y, out.x);
                const Point touch =
                    centre + out * (40 + std::pow(10, off) / 1000 * (i % 4 < 2 ? -1 : 1));
                const double before = number(random, 3, 60), after = number(random, 3, 60);
                path = {touch - along * before, {{touch + along * after}}, false};
                if (kind == 4)
                    path.segments[0] = {touch + along * after,
                                        touch - along * (before / 3) - out * number(random, -3, 3),
                                        touch + along * (after / 3) - out * number(random, -3, 3),
                                        true};
            }
            compare(each, path, counts);
        }
        qInfo("%zu cuts, %zu off, %zu missing, %zu twice", counts.cuts, counts.off, counts.missing,
              counts.extra);
        QVERIFY(counts.cuts > std::size_t(pairs) / 3);
        QCOMPARE(counts.off, std::size_t(0));
        QCOMPARE(counts.missing, std::size_t(0));
        QCOMPARE(counts.extra, std::size_t(0));
    }
};

} // namespace cut_true_cuts_test

TEST_CLASS(cut_true_cuts_test::TrueCutsTest, None)
#include "tests/app/cut/true_cuts_test.moc"
