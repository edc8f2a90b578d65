// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/variant.h"
#include "app/document/document_builder.h"
#include "app/scene/scene_lines.h"
#include "app/view/live_picture.h"

#include <QElapsedTimer>
#include <QPainter>
#include <QSignalSpy>
#include <QTest>
#include <QThreadPool>

#include <algorithm>
#include <atomic>
#include <memory>
#include <random>
#include <set>
#include <thread>

#include "tests/busy_threads.h"
#include "tests/test_class.h"

namespace view_live_picture_test {

using namespace std::chrono_literals;

namespace {

constexpr clipping::Window page{{0, 0}, {400, 300}};

/// Lines with both ends anywhere on the page.
app::Document longLines(int count, double width = 1)
{
    std::mt19937 random(1);
    const auto point = [&] { return app::Point(random() % 4000, random() % 3000) / 10.0; };
    app::DocumentBuilder builder;
    builder.open({.name = "Lines"});
    const app::StyleEntry style = builder.style({.stroke = app::Colour{}, .width = width});
    for (int i = 0; i < count; ++i)
        builder.addLine({point(), point()}, style);
    builder.close();
    return builder.take({{0, 0}, {400, 300}, {400, app::Unit::Px}, {300, app::Unit::Px}}, {},
                        {{{.shape = app::RectangleShape{{{100, 60}, {300, 200}}}}}});
}

app::FrameWish wishFor(const app::Document& document)
{
    app::FrameWish wish{.key = {}, .document = document, .lines = app::linesOf(document)};
    wish.key = {.lines = wish.lines.revision(),
                .view = {.size = {400, 300}, .centre = {200, 150}},
                .region = regionOf(document.windows(), document.page()),
                .variant = {&app::usualAlgorithm()},
                .pixels = {400, 300}};
    return wish;
}

QImage paintedBy(const app::LivePicture& picture)
{
    QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter painter(&image);
    picture.paint(painter);
    return image;
}

QImage paintedAtOnce(const app::FrameWish& wish)
{
    app::FramePainter painter;
    const auto frame =
        painter.paint(wish, {{}, [](const app::Progress&) {}}, std::make_shared<app::FrameParts>());
    QImage image(400, 300, QImage::Format_ARGB32_Premultiplied);
    image.fill(Qt::white);
    QPainter(&image).drawImage(0, 0, frame.image);
    return image;
}

} // namespace

class LivePictureTest : public QObject {
    Q_OBJECT

private slots:
    void theImageIsThatOfTheFrame()
    {
        const app::FrameWish wish = wishFor(longLines(500));
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        QVERIFY(!picture.times().painting);
        QCOMPARE(paintedBy(picture), paintedAtOnce(wish));
        QCOMPARE(picture.times().total, std::size_t(500));
        QVERIFY(picture.times().visible > 0 && picture.times().visible < 500);
        QCOMPARE(picture.times().choice, std::optional(wish.key.variant));
    }
    // Whatever was measured before: with a bound on the time that it waits, nothing can hold the
    // thread that wants a frame.
    void aFrameThatIsNotPaintedHoldsNothing()
    {
        app::LivePicture picture;
        picture.want(wishFor(longLines(1)), 1s); // a fast one
        picture.settle();
        app::FrameWish wish = wishFor(longLines(500));
        {
            const BusyThreads busy;
            picture.want(wish, 1ms);
            QVERIFY(picture.times().painting);
            wish.key.view.zoomAt({30, 40}, 1.2);
            picture.want(wish, 1ms);
            QVERIFY(picture.times().painting);
        }
        picture.settle();
        QVERIFY(!picture.times().painting);
        QCOMPARE(paintedBy(picture), paintedAtOnce(wish));
    }
    // QPainter divides the scaling of a large image among the threads of the global pool, where a
    // clip is set.
    void theLastPictureIsScaledMeanwhile()
    {
        app::FrameWish wish = wishFor(longLines(40));
        wish.key.view.size = {1600, 1200};
        wish.key.pixels = {1600, 1200};
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        std::atomic<bool> freed = false;
        auto busy = std::make_unique<BusyThreads>();
        const std::jthread waiting([&](const std::stop_token& painted) {
            for (int i = 0; i < 200 && !painted.stop_requested(); ++i)
                std::this_thread::sleep_for(50ms);
            freed = !painted.stop_requested();
            busy.reset();
        });
        wish.key.view.zoomAt({30, 40}, 1.3);
        picture.want(wish, 0us);
        QImage image(1600, 1200, QImage::Format_ARGB32_Premultiplied);
        QPainter painter(&image);
        painter.setClipRegion(QRegion(0, 0, 1600, 500) + QRegion(0, 600, 1500, 600)); // as by bands
        picture.paint(painter);
        painter.end();
        QVERIFY(!freed);
    }
    void theLastPictureIsMovedMeanwhile()
    {
        app::FrameWish wish = wishFor(longLines(40));
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        const QImage before = paintedBy(picture);
        const BusyThreads busy;
        wish.key.view.pan({20, 10});
        picture.want(wish, 0us);
        QCOMPARE(paintedBy(picture).copy(20, 10, 380, 290), before.copy(0, 0, 380, 290));
    }
    void whatIsFinishedIsShown()
    {
        app::FrameWish wish = wishFor(longLines(100'000, 3));
        app::LivePicture picture;
        QSignalSpy advanced(&picture, &app::LivePicture::advanced);
        picture.want(wish, 0us);
        QVERIFY(advanced.wait(60'000));
        QVERIFY(picture.times().painting);
        QCOMPARE(picture.times().total, std::size_t(100'000)); // clipped already
        const QImage part = paintedBy(picture);
        QImage blank(part.size(), part.format());
        blank.fill(Qt::white);
        QVERIFY(part != blank);
        wish.key.view.pan({0, 1}); // it goes on
        picture.want(wish, 0us);
        QVERIFY(paintedBy(picture) != blank);
    }
    /// Nor is there paper between them and the last picture.
    void bandsJoinAtAnyPixelRatio_data()
    {
        QTest::addColumn<double>("ratio");
        for (const double ratio : {1.0, 1.25, 1.5, 2.0})
            QTest::addRow("%g", ratio) << ratio;
    }
    void bandsJoinAtAnyPixelRatio()
    {
        QFETCH(double, ratio);
        const app::Style red{.fill = app::Colour{200, 0, 0}};
        const app::Subpath area{{-9, -9}, {{{409, -9}}, {{409, 309}}, {{-9, 309}}}, true};
        app::DocumentBuilder builder;
        builder.open({.name = "Area"});
        for (int i = 0; i < 12'000; ++i)
            builder.add(app::Object{app::Path(std::span(&area, 1)), red});
        builder.close();
        app::FrameWish wish = wishFor(builder.take({{0, 0}, {400, 300}, {}, {}}));
        wish.key.pixelRatio = ratio;
        wish.key.pixels = (QSizeF(400, 300) * ratio).toSize();
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        int images = 0;
        connect(&picture, &app::LivePicture::advanced, this, [&] {
            QImage image(wish.key.pixels, QImage::Format_ARGB32_Premultiplied);
            image.setDevicePixelRatio(ratio);
            image.fill(Qt::white);
            QPainter painter(&image);
            picture.paint(painter);
            painter.end();
            ++images;
            for (int y = 0; y < image.height(); ++y)
                QCOMPARE(image.pixel(image.width() / 2, y), qRgb(200, 0, 0));
        });
        wish.key.look = 1;
        picture.want(wish, 0us);
        QTRY_VERIFY_WITH_TIMEOUT(!picture.times().painting, 60'000);
        QVERIFY(images > 0);
    }
    /// The finished bands of another cut would have two cuts in one picture, and only one outline:
    /// they are shown only where frames take long.
    void aPictureHasPartsOfTwoCutsOnlyIfItTakesLong_data()
    {
        QTest::addColumn<int>("lines");
        QTest::newRow("few lines") << 300;
        QTest::newRow("many lines") << 100'000;
    }
    void aPictureHasPartsOfTwoCutsOnlyIfItTakesLong()
    {
        QFETCH(int, lines);
        app::FrameWish wish = wishFor(longLines(lines, 3));
        wish.ghost = 0.3;
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        const bool takesLong = picture.frame().drawMs > app::LivePicture::longWait;
        std::vector<QImage> seen{paintedBy(picture)};
        connect(&picture, &app::LivePicture::advanced, this,
                [&] { seen.push_back(paintedBy(picture)); });
        const app::ClipWindows moved{{{.shape = app::RectangleShape{{{120, 70}, {320, 210}}}}}};
        wish.key.region = regionOf(moved, wish.document.page());
        picture.want(wish, 0us);
        QTRY_VERIFY_WITH_TIMEOUT(!picture.times().painting, 60'000);
        seen.push_back(paintedBy(picture));
        QVERIFY(seen.front() != seen.back());
        const bool hasParts = !std::ranges::all_of(seen, [&](const QImage& image) {
            return image == seen.front() || image == seen.back();
        });
        QCOMPARE(hasParts, takesLong);
    }
    void aPictureSaysHowLateItsCutIs()
    {
        app::FrameWish wish = wishFor(longLines(40));
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        std::this_thread::sleep_for(5ms);
        QCOMPARE(picture.times().lateMs, 0.0);
        const auto move = [&](double by) {
            const app::ClipWindows moved{
                {{.shape = app::RectangleShape{{{120 + by, 70}, {320 + by, 210}}}}}};
            wish.key.region = regionOf(moved, wish.document.page());
            picture.want(wish, 0us);
        };
        QElapsedTimer clock;
        {
            const BusyThreads busy;
            move(1);
            std::this_thread::sleep_for(20ms);
            clock.start();
            move(2);
            std::this_thread::sleep_for(20ms);
            QVERIFY(picture.times().lateMs >= 40); // than the first one
        }
        QSignalSpy advanced(&picture, &app::LivePicture::advanced);
        QVERIFY(advanced.wait(60'000));
        const double late = picture.times().lateMs; // it shows the second one, or the third one
        QVERIFY(late <= double(clock.elapsed()) + 1);
        picture.settle();
        QCOMPARE(picture.times().lateMs, 0.0);
        const BusyThreads busy;
        clock.start();
        move(3);
        QVERIFY(picture.times().lateMs <= double(clock.elapsed()) + 1);
        wish.key.view.zoomAt({30, 40}, 1.3);
        picture.want(wish, 0us);
        QCOMPARE(picture.times().lateMs, 0.0); // of another view, not of another cut
    }
    void lateTimesAreToldAgain()
    {
        app::FrameWish wish = wishFor(longLines(40));
        app::LivePicture picture;
        picture.want(wish, 0us);
        picture.settle();
        const BusyThreads busy;
        wish.key.region = {};
        picture.want(wish, 0us);
        QSignalSpy timed(&picture, &app::LivePicture::timed);
        QVERIFY(timed.wait(60'000));
        const double once = picture.times().lateMs;
        QVERIFY(timed.wait(60'000));
        QVERIFY(picture.times().lateMs > once);
        picture.forget();
        QCOMPARE(picture.times().lateMs, 0.0);
    }
    /// Lines that the row loses are shown at once, though roughly.
    void aRoughFrameIsPaintedFinelyAtRest()
    {
        app::FrameWish wish = wishFor(longLines(30'000));
        wish.key.variant = {clipping::findAlgorithm("kwc"), clipping::Form::Published};
        app::LivePicture picture;
        bool wasRough = false;
        connect(&picture, &app::LivePicture::advanced, this,
                [&] { wasRough = wasRough || picture.frame().rough; });
        picture.want(wish, 0us);
        picture.settle();
        QVERIFY(!wasRough && !picture.frame().rough);
        const app::ClipWindows moved{{{.shape = app::RectangleShape{{{120, 70}, {320, 210}}}}}};
        wish.key.region = regionOf(moved, wish.document.page());
        picture.want(wish, 0us);
        QTRY_VERIFY_WITH_TIMEOUT(wasRough && !picture.frame().rough, 60'000);
        QCOMPARE(paintedBy(picture), paintedAtOnce(wish));
    }
    void eventsFasterThanFramesStarveNeither_data()
    {
        QTest::addColumn<bool>("edits");
        QTest::newRow("views") << false;
        QTest::newRow("drawings") << true;
    }
    void eventsFasterThanFramesStarveNeither()
    {
        QFETCH(const bool, edits);
        const app::Document document = longLines(4000);
        const app::Document other = longLines(4100);
        const app::FrameWish wishes[]{wishFor(document), wishFor(other)};
        app::LivePicture picture;
        int events = 0, frames = 0;
        std::optional<app::FrameKey> last;
        while (frames < 4) {
            app::FrameWish wish = wishes[edits ? events % 2 : 0];
            wish.key.view.pan({double(events % 50) / 10, 0});
            wish.key.look = std::uint64_t(++events);
            picture.want(wish, 0us);
            QTest::qWait(1);
            if (picture.key() && *picture.key() != last) {
                ++frames;
                last = *picture.key();
            }
        }
        QVERIFY(events >= frames);
    }
    void timesBelongToWhatIsClipped()
    {
        app::FrameWish wish = wishFor(longLines(50));
        app::LivePicture picture;
        const auto next = [&] {
            picture.want(wish, 0us);
            picture.settle();
            return picture.times();
        };
        const app::FrameTimes first = next(), second = next();
        QCOMPARE(second.subject, first.subject);
        QVERIFY(second.clipping != first.clipping); // every frame clips all lines
        wish.key.view.pan({5, 5});
        QCOMPARE(next().subject, first.subject);
        std::set<std::uint64_t> subjects{first.subject};
        wish.key.region.steps.clear();
        subjects.insert(next().subject);
        wish.key.region = wishFor(longLines(1)).key.region;
        subjects.insert(next().subject);
        wish.key.variant = {clipping::findAlgorithm("cs")};
        subjects.insert(next().subject);
        wish = wishFor(longLines(50));
        subjects.insert(next().subject);
        app::LivePicture other; // a pane beside it, which may be chosen instead
        other.want(wish, 0us);
        other.settle();
        subjects.insert(other.times().subject);
        QCOMPARE(subjects.size(), std::size_t(6));
    }
    void timesOfAnEarlierFrameDoNotComeAfterThoseOfALaterOne()
    {
        app::LivePicture picture;
        const app::FrameWish earlier = wishFor(longLines(50));
        picture.want(earlier, 0us);
        picture.settle();
        picture.want(earlier, 0us); // its lines are clipped again
        picture.want(wishFor(longLines(7)), 0us);
        picture.settle();
        QCOMPARE(picture.times().total, std::size_t(7));
    }
    void itMayEndWhileItPaints()
    {
        const app::FrameWish wish = wishFor(longLines(400'000));
        for (int i = 0; i < 3; ++i) {
            app::LivePicture picture;
            picture.want(wish, 0us);
            QTest::qWait(i * 20);
            if (i == 1)
                picture.forget();
        }
        app::paintingThreads().waitForDone();
    }
};

} // namespace view_live_picture_test

TEST_CLASS(view_live_picture_test::LivePictureTest, Gui)
#include "tests/app/view/live_picture_test.moc"
