// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/algorithm.h"
#include "clipping/batch/kernels.h"
#include "clipping/batch/streaming.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <limits>

#include "tests/clipping/same_bits.h"
#include "tests/clipping/scenes.h"
#include "tests/test_class.h"

namespace batch_kernels_test {

using namespace clipping;

namespace {

template <class T>
using Piece = BasicClipped<BasicSegment<T>>;

template <class T>
auto clipOf(const InstructionSet& set)
{
    if constexpr (sizeof(T) == sizeof(double))
        return set.clip;
    else
        return set.clipSingle;
}

template <class T>
const Functions<BasicSegment<T>, BasicWindow<T>>& exactUses()
{
    if constexpr (sizeof(T) == sizeof(double))
        return exactAlgorithm().corrected;
    else
        return *exactAlgorithm().floats;
}

/// The result of `exact`, one segment after the other.
template <class T>
std::vector<Piece<T>> oneByOne(const Scene<T>& scene)
{
    std::vector<Piece<T>> pieces;
    for (std::size_t i = 0; i < scene.segments.size(); ++i)
        if (const auto piece = exactUses<T>().clip(scene.segments[i], scene.window))
            pieces.push_back({*piece, static_cast<std::uint32_t>(i), 0});
    return pieces;
}

/// The result of an instruction set between begin and end, in a buffer of exactly that size.
template <class T>
std::vector<Piece<T>> clipped(const InstructionSet& set, const Scene<T>& scene, std::size_t begin,
                              std::size_t end)
{
    std::vector<Piece<T>> out(end - begin);
    const auto result =
        clipOf<T>(set)({scene.segments.data(), begin, end, scene.window, out.data()});
    out.resize(result.pieces);
    return out;
}

template <class T>
bool sameBits(const std::vector<Piece<T>>& p, const std::vector<Piece<T>>& q)
{
    return p.size() == q.size()
           && (p.empty() || std::memcmp(p.data(), q.data(), p.size() * sizeof(Piece<T>)) == 0);
}

template <class T>
bool sameSegments(const std::vector<Piece<T>>& p, const std::vector<Piece<T>>& q)
{
    for (std::size_t i = 0; i < std::min(p.size(), q.size()); ++i)
        if (!::sameBits(p[i].segment, q[i].segment) || p[i].source != q[i].source)
            return false;
    return p.size() == q.size();
}

/// Non-finite numbers among finite ones.
template <class T>
Scene<T> spoilt(Scene<T> scene)
{
    const T bad[] = {T(NAN), T(INFINITY), -T(INFINITY)};
    RandomNumbers random(7);
    for (auto& s : scene.segments) {
        T* const numbers[] = {&s.a.x, &s.a.y, &s.b.x, &s.b.y};
        if (random.integer(0, 2) == 0)
            *numbers[random.integer(0, 3)] = bad[random.integer(0, 2)];
    }
    scene.name += ", spoilt";
    return scene;
}

/// Through the window from where products of two coordinates are just below or above the largest
/// number, and between points whose sum overflows.
template <class T>
Scene<T> nearOverflow()
{
    constexpr auto half = std::numeric_limits<T>::max_exponent / 2;
    const T most = std::ldexp(T(1), half), near = most / 128;
    Scene<T> scene{"near overflow", {{-near, -near}, {near, near}}, {}};
    RandomNumbers random(8);
    const auto number = [&](double low, double high, T unit) {
        return unit * static_cast<T>(random.uniform(low, high));
    };
    for (int i = 0; i < 5000; ++i) {
        const T x = number(0.99, 1.01, most), y = number(0.99, 1.01, most);
        scene.segments.push_back({{x, y}, {number(-2, 2, near), number(-2, 2, near)}});
        const T large = std::numeric_limits<T>::max();
        const T far = number(0.4, 1, large), further = number(0.4, 1, large);
        scene.segments.push_back({{far, number(-1, 1, near)}, {further, number(-1, 1, near)}});
    }
    return scene;
}

/// Through the corners of a window, where products of two coordinates are hardly above the smallest
/// number and lose most of their digits.
template <class T>
Scene<T> nearUnderflow()
{
    using Limits = std::numeric_limits<T>;
    const T unit = std::ldexp(T(1), (Limits::min_exponent - Limits::digits) / 2);
    Scene<T> scene{"near underflow", {{-3 * unit, -2 * unit}, {4 * unit, 5 * unit}}, {}};
    RandomNumbers random(9);
    const auto number = [&] {
        return std::ldexp(static_cast<T>(random.uniform(-2, 2)), random.integer(-1, 3)) * unit;
    };
    const auto& [low, high] = scene.window;
    for (int i = 0; i < 20'000; ++i) {
        const T x = random.integer(0, 1) ? low.x : high.x,
                y = random.integer(0, 1) ? low.y : high.y;
        const T dx = number(), dy = number();
        const T far = std::ldexp(T(1), random.integer(-4, 4));
        scene.segments.push_back({{x + dx, y + dy}, {x - far * dx, y - far * dy}});
    }
    return scene;
}

template <class T>
std::vector<Scene<T>> allScenes()
{
    auto scenes = hardScenes<T>(20011);
    for (const std::size_t i : {0, 1})
        scenes.push_back(spoilt(scenes[i]));
    scenes.push_back(nearOverflow<T>());
    scenes.push_back(nearUnderflow<T>());
    auto inside = paperScene<T>(5003);
    inside.name = "all inside";
    inside.window = {{-960, -720}, {960, 720}};
    scenes.push_back(inside);
    scenes.push_back({"an empty window", {{1, 1}, {-1, -1}}, inside.segments});
    scenes.push_back({"no window", {{-1, -1}, {T(NAN), 1}}, inside.segments});
    return scenes;
}

template <class T>
void compareSets()
{
    for (const auto& scene : allScenes<T>()) {
        const auto expected = oneByOne(scene);
        const auto& portable = instructionSets().front();
        const auto first = clipped(portable, scene, 0, scene.segments.size());
        QVERIFY2(sameSegments(first, expected), scene.name.c_str());
        for (const InstructionSet& set : instructionSets())
            if (set.available) {
                const auto pieces = clipped(set, scene, 0, scene.segments.size());
                QVERIFY2(sameBits(pieces, first),
                         (scene.name + ", " + std::string(set.name)).c_str());
            }
    }
}

/// Blocks that lie wholly inside, apart from one non-finite number.
template <class T>
void spoilOneNumber()
{
    auto scene = paperScene<T>(1536);
    scene.window = {{-960, -720}, {960, 720}};
    for (const std::size_t at : {0, 700, 1535})
        for (const T bad : {T(NAN), T(INFINITY), -T(INFINITY)})
            for (int number = 0; number < 4; ++number) {
                auto some = scene;
                auto& [a, b] = some.segments[at];
                (number < 2 ? a : b)[number % 2] = bad;
                for (const InstructionSet& set : instructionSets())
                    if (set.available)
                        QVERIFY(sameSegments(clipped(set, some, 0, 1536), oneByOne(some)));
            }
}

template <class T>
void comparePartsOfTheWhole()
{
    const auto scene = hardScenes<T>(1100)[1];
    for (const InstructionSet& set : instructionSets())
        if (set.available)
            for (std::size_t begin : {0, 1, 513})
                for (std::size_t end = begin; end < begin + 70; ++end) {
                    std::vector<Piece<T>> expected;
                    for (const auto& piece : clipped(set, scene, 0, scene.segments.size()))
                        if (piece.source >= begin && piece.source < end)
                            expected.push_back(piece);
                    QVERIFY(sameBits(clipped(set, scene, begin, end), expected));
                }
}

/// As many segments as make an output that is streamed, most of them wholly inside.
template <class T>
Scene<T> toBeStreamed()
{
    auto scene = paperScene<T>(streamedSize / sizeof(Piece<T>) + 1001);
    scene.window = {{-960, -720}, {960, 720}};
    for (std::size_t at = 0; at < scene.segments.size(); at += 5000) { // some cut, some outside
        scene.segments[at].a.x += T(at / 5000 % 3 * 1500);
        scene.segments[at].b.x += T(at / 5000 % 3 * 1000);
    }
    return scene;
}

/// Compares a whole scene with its parts, which are too small to be streamed. Its output begins
/// `skipped` numbers of four bytes after one that malloc gives.
template <class T>
void compareStreamed(std::size_t skipped)
{
    const auto scene = toBeStreamed<T>();
    const std::size_t count = scene.segments.size(), size = sizeof(Piece<T>);
    for (const InstructionSet& set : instructionSets()) {
        if (!set.available)
            continue;
        std::vector<Piece<T>> parts;
        for (std::size_t begin = 0; begin < count; begin += 10'000) {
            const auto some = clipped(set, scene, begin, std::min(begin + 10'000, count));
            parts.insert(parts.end(), some.begin(), some.end());
        }
        QVERIFY(parts.size() > count / 2 && parts.size() < count);
        constexpr std::uint32_t untouched = 0xa5a5a5a5;
        std::vector<std::uint32_t> room(skipped + count * size / 4 + 1, untouched);
        auto* const out = reinterpret_cast<Piece<T>*>(room.data() + skipped);
        QCOMPARE(isStreamed(out, count), skipped == 0);
        const auto found =
            clipOf<T>(set)({scene.segments.data(), 0, count, scene.window, out}).pieces;
        QCOMPARE(found, parts.size());
        QVERIFY(std::memcmp(out, parts.data(), found * size) == 0);
        QCOMPARE(room.back(), untouched);
    }
}

} // namespace

class KernelsTest : public QObject {
    Q_OBJECT

private slots:
    void missingInstructionSetsAreReported()
    {
        QVERIFY(instructionSets().front().available);
        for (const InstructionSet& set : instructionSets())
            if (!set.available)
                qWarning("%s is not available here and was not tested", set.name.data());
    }

    void everyInstructionSetGivesTheSameBits() { compareSets<double>(); }
    void everyInstructionSetGivesTheSameBitsInFloat() { compareSets<float>(); }
    void aSingleNonFiniteNumberIsFound() { spoilOneNumber<double>(); }
    void aSingleNonFiniteNumberIsFoundInFloat() { spoilOneNumber<float>(); }
    void anyPartIsClippedWithoutWritingBeyondIt() { comparePartsOfTheWhole<double>(); }
    void anyPartIsClippedWithoutWritingBeyondItInFloat() { comparePartsOfTheWhole<float>(); }

    void aLargeOutputIsTheSameAsThatOfItsParts() { compareStreamed<double>(0); }
    void aLargeOutputOfFloatsIsTheSameAsThatOfItsParts()
    {
        compareStreamed<float>(0);
        compareStreamed<float>(1);
    }

    void thePapersSceneIsDecidedInVectors()
    {
        const auto scene = paperScene<double>(100000);
        std::vector<Clipped> out(scene.segments.size());
        for (const InstructionSet& set : instructionSets())
            if (set.available) {
                const auto result = set.clip(
                    {scene.segments.data(), 0, scene.segments.size(), scene.window, out.data()});
                QVERIFY(result.pieces > 10000 && result.unsettled <= 10); // 0.01 %
            }
    }

    void longFloatsAreDecidedInVectors()
    {
        std::vector<BasicClipped<BasicSegment<float>>> out(20011);
        const auto scene = hardScenes<float>(out.size())[5]; // up to 2^40 long
        QCOMPARE(scene.name, std::string("long lines"));
        for (const InstructionSet& set : instructionSets())
            if (set.available) {
                const auto result = set.clipSingle(
                    {scene.segments.data(), 0, out.size(), scene.window, out.data()});
                QVERIFY2(result.unsettled <= 20, set.name.data()); // 0.1 %
            }
    }

    void theRowUsesTheFirstKernel()
    {
        const auto scene = paperScene<double>(3000);
        std::vector<Clipped> out(scene.segments.size());
        out.resize(exactAlgorithm().corrected.clipAll(scene.segments, scene.window, out));
        QVERIFY(sameBits(out, clipped(instructionSets().front(), scene, 0, scene.segments.size())));
    }
};

} // namespace batch_kernels_test

TEST_CLASS(batch_kernels_test::KernelsTest, None)
#include "tests/clipping/batch/kernels_test.moc"
