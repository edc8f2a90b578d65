// SPDX-License-Identifier: GPL-3.0-or-later
#include "clipping/algorithm.h"
#include "clipping/chunks.h"

#include <QTest>

#include <cstring>

#include "tests/benchmarks/scenes.h"
#include "tests/test_class.h"

namespace chunks_test {

using namespace clipping;

namespace {

template <class T>
auto clippedAll(const Scene<T>& scene)
{
    std::vector<BasicClipped<BasicSegment<T>>> out(scene.segments.size());
    const Algorithm& exact = exactAlgorithm();
    if constexpr (sizeof(T) == sizeof(double))
        out.resize(exact.corrected.clipAll(scene.segments, scene.window, out));
    else
        out.resize(exact.floats->clipAll(scene.segments, scene.window, out));
    return out;
}

template <class T>
bool sameAsAll(const BasicChunks<T>& chunks, const Scene<T>& scene)
{
    std::vector<BasicClipped<BasicSegment<T>>> out(scene.segments.size());
    out.resize(chunks.clipAll(scene.segments, scene.window, out));
    const auto all = clippedAll(scene);
    return out.size() == all.size()
           && (all.empty() || std::memcmp(out.data(), all.data(), all.size() * sizeof all[0]) == 0);
}

template <class T>
void compareWithAll()
{
    auto scenes = hardScenes<T>(5003);
    scenes.push_back(strokes<T>(70001));
    scenes.push_back(allInside<T>(64));
    scenes.push_back(allOutside<T>(1000));
    scenes.push_back({"nothing", paperWindow<T>(), {}});
    for (auto& scene : scenes) {
        const BasicChunks<T> chunks(scene.segments);
        QVERIFY2(sameAsAll(chunks, scene), scene.name.c_str());
        scene.window.max *= T(0.5);
        QVERIFY2(sameAsAll(chunks, scene), scene.name.c_str());
        std::swap(scene.window.min, scene.window.max);
        QVERIFY2(sameAsAll(chunks, scene), scene.name.c_str());
    }
}

} // namespace

class ChunksTest : public QObject {
    Q_OBJECT

private slots:
    void boxesGiveTheSameResultAsClippingEverything() { compareWithAll<double>(); }
    void boxesGiveTheSameResultAsClippingEverythingInFloat() { compareWithAll<float>(); }

    void nonFiniteNumbersAreLeftToTheClipper()
    {
        auto scene = allInside<double>(1000);
        scene.segments[70].a.x = double(NAN);
        scene.segments[200].b.y = double(INFINITY);
        scene.segments[300].a.y = -double(INFINITY);
        QCOMPARE(clippedAll(scene).size(), scene.segments.size() - 3);
        QVERIFY(sameAsAll(Chunks(scene.segments), scene));
    }

    void boxesFollowChanges()
    {
        auto scene = strokes<double>(10000);
        Chunks chunks(scene.segments);
        for (std::size_t i = 700; i < 900; ++i)
            scene.segments[i] = {{0, 0}, {1, double(i)}};
        QVERIFY(!sameAsAll(chunks, scene));
        chunks.update(scene.segments, 700, 900);
        QVERIFY(sameAsAll(chunks, scene));

        const auto more = strokes<double>(777);
        scene.segments.insert(scene.segments.begin() + 5000, more.segments.begin(),
                              more.segments.end());
        chunks.update(scene.segments, 5000, scene.segments.size());
        QVERIFY(sameAsAll(chunks, scene));

        scene.segments.erase(scene.segments.begin() + 100, scene.segments.begin() + 140);
        chunks.update(scene.segments, 100, scene.segments.size());
        QVERIFY(sameAsAll(chunks, scene));
    }
};

} // namespace chunks_test

TEST_CLASS(chunks_test::ChunksTest, None)
#include "tests/clipping/chunks_test.moc"
