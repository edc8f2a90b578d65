// SPDX-License-Identifier: GPL-3.0-or-later
// A person draws a star over the street map, makes it a clip window, cuts a rotated rectangle out
// of it, crops, and undoes it: by events alone.
#include "app/document/window_shape.h"
#include "app/session/samples.h"
#include "app/view/frame_handles.h"

#include <QAbstractButton>
#include <QLabel>
#include <QListView>

#include "tests/ui/tools/hand.h"

class CutByStarTest : public QObject {
    Q_OBJECT

private slots:
    void fromStarToCroppedMapAndBack()
    {
        Hand h({});
        const auto samples = app::samples();
        const auto map = std::ranges::find(samples, QString("street-map"), &app::Sample::key);
        QVERIFY(map != samples.end());
        h.t.window->files().openSample(*map);
        h.t.window->files().wait();
        h.canvas.fitDrawing();
        h.canvas.setFocus();
        h.t.run("remove-window"); // the sample has one
        const app::Document before = h.session.now();
        const auto visible = [&] {
            return h.session.scene.clip(h.session.region(), h.session.variant()).visible;
        };
        const std::size_t all = visible();
        QCOMPARE(all, h.session.scene.lines().size());

        h.key(Qt::Key_S);
        h.drag({210, 150}, {210, 30});
        h.key(Qt::Key_G); // selects what was just drawn
        h.key(Qt::Key_Escape);
        QCOMPARE(h.session.selection().size(), 1u);
        h.key(Qt::Key_W);
        QTest::mouseClick(h.t.window->findChild<QAbstractButton*>("window-from-selection"),
                          Qt::LeftButton);
        QCOMPARE(h.session.now().windows().list.size(), 1u);
        const std::size_t inStar = visible();
        QVERIFY2(inStar > 1000 && inStar < all, qPrintable(QString::number(inStar)));

        const auto uses =
            h.t.window->findChild<QWidget*>("window-use")->findChildren<QAbstractButton*>();
        QTest::mouseClick(uses[1], Qt::LeftButton); // Cut out
        h.drag({190, 130}, {230, 160});
        const double above = app::rotationHandleAbove / h.canvas.view().zoom;
        h.drag({210, 130 - above}, {225, 130 - above});
        const auto& list = h.session.now().windows().list;
        QCOMPARE(list.size(), 2u);
        const auto hole = std::get<app::RectangleShape>(list[1].shape);
        QVERIFY(hole.angle > 0.1 && list[1].operation == app::WindowOperation::CutOut);
        const std::size_t left = visible();
        QVERIFY2(left > 0 && left < inStar, qPrintable(QString("%1 of %2").arg(left).arg(inStar)));
        QCOMPARE(h.t.window->findChild<QListView*>("clip-windows")->model()->rowCount(), 2);

        const std::size_t objects = h.session.now().objects().size();
        h.t.run("crop");
        QVERIFY(h.session.now().objects().size() < objects);
        QVERIFY(h.session.now().windows().list.size() == 2u);
        for (int step = h.session.history.index(); step > 1; --step)
            h.key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(h.session.now() == before);
    }
};

QTEST_MAIN(CutByStarTest)
#include "cut_by_star_test.moc"
