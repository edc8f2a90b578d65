// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/snap_choice.h"

#include <QMenu>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::bars_snap_choice_test {

// Snapping in the bar across the top, by mouse and keys.
class SnapChoiceTest : public QObject {
    Q_OBJECT

    struct Bar {
        Bar() { t.show(); }
        SnapChoice& magnet() { return *t.window->findChild<SnapChoice*>(); }
        QMenu* menu() { return magnet().menu(); }
        QPoint placeOf(const char* kind)
        {
            return menu()->actionGeometry(menu()->findChild<QAction*>(kind)).center();
        }
        bool has(const char* kind) { return t.window->canvas().snapping().has(kind); }

        TestWindow t;
    };

private slots:
    void theTooltipSaysHowManyKindsAreOn()
    {
        Bar bar;
        const auto all = app::snapKinds().size(), on = app::SnapTo::usual().size();
        QVERIFY(on < all);
        const QString said = QStringLiteral("%1 of %2 kinds").arg(on).arg(all);
        QVERIFY2(bar.magnet().toolTip().contains(said), qPrintable(bar.magnet().toolTip()));
        QVERIFY(bar.magnet().isChecked());
    }
    void theKeyboardOpensTheKindsAndGoesBackToTheDrawing()
    {
        Bar bar;
        bar.magnet().setFocus();
        bool seen = false;
        QTimer::singleShot(0, bar.menu(), [&] {
            seen = bar.menu()->isVisible();
            QTest::keyClick(bar.menu(), Qt::Key_Escape);
        });
        QTest::keyClick(&bar.magnet(), Qt::Key_Down, Qt::AltModifier);
        QVERIFY(seen);
        QCOMPARE(bar.t.window->focusWidget(), bar.t.drawingArea());
    }
    void theMenuStaysOpenWhileKindsAreTicked()
    {
        Bar bar;
        QTimer::singleShot(0, bar.menu(), [&] {
            QVERIFY(bar.menu()->isVisible());
            for (const char* kind : {"ends", "on-path"}) {
                const bool before = bar.has(kind);
                QTest::mouseClick(bar.menu(), Qt::LeftButton, {}, bar.placeOf(kind));
                QCOMPARE(bar.has(kind), !before);
                QVERIFY(bar.menu()->isVisible());
            }
            bar.menu()->setActiveAction(bar.menu()->findChild<QAction*>("ends"));
            QTest::keyClick(bar.menu(), Qt::Key_Space);
            QVERIFY(bar.has("ends") && bar.menu()->isVisible());
            QTest::keyClick(bar.menu(), Qt::Key_Escape);
            QVERIFY(!bar.menu()->isVisible());
        });
        emit bar.magnet().customContextMenuRequested({4, 4});
        QVERIFY(bar.has("ends") && bar.has("on-path"));
        QCOMPARE(bar.t.window->focusWidget(), bar.t.drawingArea());
    }
    void theButtonAndF5SwitchSnapping()
    {
        Bar bar;
        QTest::mouseClick(&bar.magnet(), Qt::LeftButton);
        QVERIFY(!bar.t.window->canvas().snaps());
        QTest::keyClick(bar.t.drawingArea(), Qt::Key_F5);
        QVERIFY(bar.t.window->canvas().snaps() && bar.magnet().isChecked());
        QVERIFY(bar.t.action("snap")->isChecked());
    }
    void theChoiceIsRemembered()
    {
        Bar bar;
        bar.menu()->findChild<QAction*>("middles")->trigger();
        QTest::mouseClick(&bar.magnet(), Qt::LeftButton);
        const auto next = windowWithMenus();
        QVERIFY(!next->canvas().snaps());
        QCOMPARE(next->canvas().snapping(), app::SnapTo::usual().without("middles"));
    }
};

} // namespace ui::bars_snap_choice_test

TEST_CLASS(ui::bars_snap_choice_test::SnapChoiceTest, Widgets)
#include "tests/ui/bars/snap_choice_test.moc"
