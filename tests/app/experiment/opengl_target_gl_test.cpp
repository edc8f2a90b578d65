// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/record.h"

#include <QRegularExpression>
#include <QTest>
#include <QThread>

#include "tests/test_class.h"

namespace experiment_opengl_target_gl_test {

namespace {

const clipping::Clipped line{{{-50, 0}, {50, 20}}, 0, 0}, other{{{-50, 0}, {50, 30}}, 0, 0};

} // namespace

class OpenGlTargetGlTest : public QObject {
    Q_OBJECT

private slots:
    void openGlIsChosenWhereThereIsADisplay()
    {
        const auto maker = app::openGlTarget();
        QVERIFY(maker);
        const auto target = maker({});
        static const QRegularExpression name("^OpenGL [3-4]\\.\\d, \\S+");
        QVERIFY2(name.match(target->name()).hasMatch(), qPrintable(target->name()));
        QVERIFY(target->drawsElsewhere());
        QCOMPARE(app::bestDrawTarget()({})->name(), target->name());
    }

    void thePixelsAreTheLines()
    {
        const auto target = app::openGlTarget()({});
        const auto blank = target->checksum();
        target->draw({&line, 1});
        const auto drawn = target->checksum();
        QVERIFY(drawn != blank);
        target->draw({&line, 1});
        QCOMPARE(target->checksum(), drawn);
        target->draw({&other, 1});
        QVERIFY(target->checksum() != drawn);
        target->wipe();
        QCOMPARE(target->checksum(), blank);
        target->draw({});
        QCOMPARE(target->checksum(), blank);
    }

    void manyLinesAreAllDrawn()
    {
        const auto target = app::openGlTarget()({});
        std::vector<clipping::Clipped> lines(200'000, line); // more than fit one buffer
        target->draw({&line, 1});
        target->draw({&other, 1});
        const auto both = target->checksum();
        lines.back() = other;
        target->wipe();
        target->draw(lines);
        QCOMPARE(target->checksum(), both);
    }

    void twoDrawTargetsDoNotDisturbEachOther()
    {
        const auto maker = app::openGlTarget();
        const auto one = maker({}), two = maker({});
        const auto blank = one->checksum();
        one->draw({&line, 1});
        QCOMPARE(two->checksum(), blank);
        two->draw({&other, 1});
        QVERIFY(one->checksum() != two->checksum());
        QVERIFY(one->checksum() != blank);
    }

    void theSurfaceGoesInTheThreadThatItCameFrom()
    {
        auto maker = app::openGlTarget();
        const std::unique_ptr<QThread> thread(
            QThread::create([mine = std::exchange(maker, nullptr)]() mutable {
                mine({})->wipe();
                mine = nullptr; // the last that holds it
            }));
        thread->start();
        QVERIFY(thread->wait());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(app::openGlTarget()({})->name().startsWith("OpenGL")); // and others go on
    }

    void experimentsDrawInAThreadOfTheirOwn()
    {
        app::ExperimentOptions options;
        options.lines = 2000;
        options.runs = 2;
        options.target = app::openGlTarget();
        std::vector<const clipping::Algorithm*> some;
        for (const char* name : {"cs", "md", "exact"})
            some.push_back(clipping::findAlgorithm(name));
        const auto all = app::variantsOf(some, clipping::Form::Corrected);
        const auto pixelsOf = [&](const app::ExperimentOptions& wanted) {
            std::vector<std::uint64_t> pixels;
            const std::unique_ptr<QThread> thread(QThread::create([&] {
                const auto record = app::recorded(wanted, all);
                QVERIFY(!record->options.target);
                for (const auto& timing : record->timings)
                    pixels.push_back(timing.pixels);
                QVERIFY(record->target.startsWith("OpenGL"));
                QVERIFY(record->target.endsWith("clock: wall"));
            }));
            thread->start();
            thread->wait();
            return pixels;
        };
        const auto pixels = pixelsOf(options);
        QCOMPARE(pixels, std::vector(3, pixels[0])); // all see the same
        QCOMPARE(pixelsOf(options), pixels);
        options.field.window.max.x += 5;
        QVERIFY(pixelsOf(options)[0] != pixels[0]);
    }
};

} // namespace experiment_opengl_target_gl_test

TEST_CLASS(experiment_opengl_target_gl_test::OpenGlTargetGlTest, Gui)
#include "tests/app/experiment/opengl_target_gl_test.moc"
