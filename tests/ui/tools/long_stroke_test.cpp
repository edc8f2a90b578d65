// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal.h"
#include "app/recovery/leftover.h"
#include "app/recovery/replay.h"

#include <QTemporaryDir>

#include <glm/geometric.hpp>

#include <cmath>
#include <ctime>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace tools_long_stroke_test {

// A freehand line of a million points, with the journal on.
class LongStrokeTest : public QObject {
    Q_OBJECT

    static constexpr int count = 1'000'000;
    static constexpr double longest = 100; // seconds of the processor, in slow builds

    /// A canvas whose steps are recorded, as in the editor.
    struct Hand : Stage {
        explicit Hand(const QString& folder)
            : Stage(ui::Backend::Raster, {}), journal(session.document, session.history, folder)
        {
            canvas->setTool("pencil");
            QObject::connect(canvas.get(), &ui::Canvas::stepsChanged, &journal,
                             [this] { journal.setInHand(canvas->pendingObject()); });
        }
        QPointF place(int i) // on a spiral
        {
            const double turn = i * 0.01, radius = 20 + 200.0 * i / count;
            return QRectF(surface().rect()).center()
                   + QPointF(std::cos(turn), std::sin(turn)) * radius;
        }
        app::Point drawn(int i)
        {
            const QPointF at = place(i);
            return canvas->view().toDrawing({at.x(), at.y()});
        }
        void send(QEvent::Type type, int i, Qt::MouseButtons buttons)
        {
            const auto button = type == QEvent::MouseMove ? Qt::NoButton : Qt::LeftButton;
            QMouseEvent event(type, place(i), surface().mapToGlobal(place(i)), button, buttons, {});
            QApplication::sendEvent(&surface(), &event);
        }
        app::Journal journal;
    };

private slots:
    void aMillionPointsAreDrawnAndRecorded()
    {
        const QTemporaryDir folder;
        app::Subpath path;
        {
            Hand hand(folder.path());
            QVERIFY(hand.journal.ready());
            const std::clock_t begin = std::clock();
            hand.send(QEvent::MouseButtonPress, 0, Qt::LeftButton);
            for (int i = 1; i <= count; ++i) {
                hand.send(QEvent::MouseMove, i, Qt::LeftButton);
                if (i % 100'000 == 0)
                    QCoreApplication::processEvents(); // paints, and records what is drawn so far
            }
            hand.send(QEvent::MouseButtonRelease, count, Qt::NoButton);
            const double seconds = double(std::clock() - begin) / CLOCKS_PER_SEC;
            qInfo("%d points: %.1f s", count, seconds);
            QVERIFY(seconds < longest);
            QCOMPARE(hand.session.now().objects().size(), std::size_t(1));
            QCOMPARE(hand.session.history.count(), 1);
            path = hand.session.now().objects()[0].path().subpaths()[0];
            const double pixel = 1 / hand.canvas->view().zoom;
            QVERIFY(glm::distance(path.start, hand.drawn(0)) < pixel);
            QVERIFY(glm::distance(path.segments.back().to, hand.drawn(count)) < pixel);
            QVERIFY(path.segments.size() > 1591 * 2); // of so many turns
        }                                             // as if the program had been killed
        auto left = app::claimLeftovers(folder.path());
        QCOMPARE(left.size(), std::size_t(1));
        const auto recovered = app::recover(left.front());
        QVERIFY2(recovered, qPrintable(recovered.error));
        QVERIFY(recovered.value->document.objects()[0].path().subpaths()[0] == path);
    }
};

} // namespace tools_long_stroke_test

TEST_CLASS(tools_long_stroke_test::LongStrokeTest, Widgets)
#include "tests/ui/tools/long_stroke_test.moc"
