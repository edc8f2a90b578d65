// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/record.h"

#include <QRegularExpression>
#include <QTest>
#include <QThread>

namespace {

const clipping::Clipped line{{{-50, 0}, {50, 20}}, 0, 0}, other{{{-50, 0}, {50, 30}}, 0, 0};

} // namespace

class GlEaselGlTest : public QObject {
    Q_OBJECT

private slots:
    void itIsTheBestWhereThereIsADisplay()
    {
        const auto maker = app::openGlEasel();
        QVERIFY(maker);
        const auto easel = maker({});
        static const QRegularExpression name("^OpenGL [3-4]\\.\\d, \\S+");
        QVERIFY2(name.match(easel->name()).hasMatch(), qPrintable(easel->name()));
        QVERIFY(easel->drawsElsewhere());
        QCOMPARE(app::bestEasel()({})->name(), easel->name());
    }

    void thePixelsAreTheLines()
    {
        const auto easel = app::openGlEasel()({});
        const auto blank = easel->checksum();
        easel->draw({&line, 1});
        const auto drawn = easel->checksum();
        QVERIFY(drawn != blank);
        easel->draw({&line, 1});
        QCOMPARE(easel->checksum(), drawn);
        easel->draw({&other, 1});
        QVERIFY(easel->checksum() != drawn);
        easel->wipe();
        QCOMPARE(easel->checksum(), blank);
        easel->draw({});
        QCOMPARE(easel->checksum(), blank);
    }

    void manyLinesAreAllDrawn()
    {
        const auto easel = app::openGlEasel()({});
        std::vector<clipping::Clipped> lines(200'000, line); // more than fit one buffer
        easel->draw({&line, 1});
        easel->draw({&other, 1});
        const auto both = easel->checksum();
        lines.back() = other;
        easel->wipe();
        easel->draw(lines);
        QCOMPARE(easel->checksum(), both);
    }

    void twoEaselsDoNotDisturbEachOther()
    {
        const auto maker = app::openGlEasel();
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
        auto maker = app::openGlEasel();
        const std::unique_ptr<QThread> thread(
            QThread::create([mine = std::exchange(maker, nullptr)]() mutable {
                mine({})->wipe();
                mine = nullptr; // the last that holds it
            }));
        thread->start();
        QVERIFY(thread->wait());
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QVERIFY(app::openGlEasel()({})->name().startsWith("OpenGL")); // and others go on
    }

    void experimentsDrawInAThreadOfTheirOwn()
    {
        app::ExperimentOptions options;
        options.lines = 2000;
        options.runs = 2;
        options.easel = app::openGlEasel();
        std::vector<const clipping::Algorithm*> some;
        for (const char* name : {"cs", "md", "exact"})
            some.push_back(clipping::findAlgorithm(name));
        const auto all = app::variantsOf(some, clipping::Form::Corrected);
        const auto pixelsOf = [&](const app::ExperimentOptions& wanted) {
            std::vector<std::uint64_t> pixels;
            const std::unique_ptr<QThread> thread(QThread::create([&] {
                const auto record = app::recorded(wanted, all);
                QVERIFY(!record->options.easel);
                for (const auto& timing : record->timings)
                    pixels.push_back(timing.pixels);
                QVERIFY(record->easel.startsWith("OpenGL"));
                QVERIFY(record->easel.endsWith("clock: wall"));
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

QTEST_MAIN(GlEaselGlTest)
#include "gl_easel_gl_test.moc"
