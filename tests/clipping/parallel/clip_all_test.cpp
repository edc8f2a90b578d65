// SPDX-License-Identifier: GPL-3.0-or-later
// Qt's macro of that name is a function of oneTBB's.
#define QT_NO_EMIT

#include "clipping/batch/kernels.h"
#include "clipping/parallel/clip_all.h"

#include <QTest>

#include <cstring>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>

#include "tests/benchmarks/scenes.h"
#include "tests/test_class.h"

namespace parallel_clip_all_test {

using namespace clipping;

namespace {

template <class T>
void compareThreads()
{
    using Piece = BasicClipped<BasicSegment<T>>;
    for (const std::size_t count : {parallelThreshold - 1, parallelThreshold, std::size_t(500'009)})
        for (const auto& maker : benchmarkScenes<T>) {
            const auto scene = maker.make(count);
            std::vector<Piece> expected(count), out(count);
            expected.resize(
                clipBatch(Batch<T>{scene.segments.data(), 0, count, scene.window, expected.data()})
                    .pieces);
            for (const int threads : {1, 2, 3, 8}) {
                tbb::task_arena arena(threads);
                const std::size_t pieces = arena.execute(
                    [&] { return clipAllInParallel(scene.segments, scene.window, out); });
                QCOMPARE(pieces, expected.size());
                QVERIFY2(std::memcmp(out.data(), expected.data(), pieces * sizeof(Piece)) == 0
                             || pieces == 0,
                         maker.name);
            }
        }
}

} // namespace

class ClipAllTest : public QObject {
    Q_OBJECT

    tbb::global_control enough_{tbb::global_control::max_allowed_parallelism, 8};

private slots:
    void anyNumberOfThreadsGivesTheSameResult() { compareThreads<double>(); }
    void anyNumberOfThreadsGivesTheSameResultInFloat() { compareThreads<float>(); }
};

} // namespace parallel_clip_all_test

TEST_CLASS(parallel_clip_all_test::ClipAllTest, None)
#include "tests/clipping/parallel/clip_all_test.moc"
