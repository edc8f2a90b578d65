// SPDX-License-Identifier: GPL-3.0-or-later
// The controls of what is chosen, in the options bar instead of beside it.
#include "app/document/window_shape.h"
#include "ui/bars/option_bar.h"
#include "ui/canvas/object_capsule.h"
#include "ui/canvas/window_capsule.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace bars_capsule_in_bar_test {

namespace {

struct InBar : Hand {
    InBar() : Hand({shape({corner()}), shape({wave()})})
    {
        session.document.apply({.windows = app::ClipWindows{
                                    {{.shape = app::RectangleShape{{{110, 20}, {180, 80}}}}}}});
        canvas.setCapsuleHome(app::CapsuleHome::InBar);
        key(Qt::Key_W);
        session.chooseWindow(0);
    }
    ui::OptionBar& bar() { return t.window->optionBar(); }
    template <class Part>
    Part& part(const char* name)
    {
        return *bar().findChild<Part*>(QLatin1StringView(name));
    }
    ui::WindowCapsule& ofWindow() { return *t.window->findChild<ui::WindowCapsule*>(); }
    ui::ObjectCapsule& ofObjects() { return *t.window->findChild<ui::ObjectCapsule*>(); }
    clipping::Window box() { return app::boxOf(session.windows().list.front().shape); }
};

} // namespace

class CapsuleInBarTest : public QObject {
    Q_OBJECT

private slots:
    void itStandsInTheBarWhileSomethingIsChosen()
    {
        InBar d;
        QTRY_VERIFY(d.ofWindow().isVisible() && d.bar().isAncestorOf(&d.ofWindow()));
        QVERIFY(!d.ofObjects().isVisible());
        const int low = d.bar().mapToGlobal(d.bar().rect().bottomLeft()).y();
        QVERIFY(d.ofWindow().mapToGlobal(d.ofWindow().rect().bottomLeft()).y() <= low);
        d.key(Qt::Key_V);
        d.click({150, 5}); // nothing
        QTRY_VERIFY(!d.ofWindow().isVisible() && !d.ofObjects().isVisible());
        d.click({60, 20});
        QTRY_VERIFY(d.ofObjects().isVisible() && d.bar().isAncestorOf(&d.ofObjects()));
        d.canvas.setCapsuleHome(app::CapsuleHome::Off);
        QTRY_VERIFY(!d.ofObjects().isVisible());
        d.canvas.setCapsuleHome(app::CapsuleHome::AtObject);
        d.canvas.settle();
        QVERIFY(d.ofObjects().isVisible() && d.canvas.isAncestorOf(&d.ofObjects()));
    }
    void enterGoesThere()
    {
        InBar d;
        d.key(Qt::Key_Return);
        auto& width = d.part<ui::LengthField>("capsule-width");
        QVERIFY(width.hasFocus());
        QTest::keyClicks(&width, "12");
        QTest::keyClick(&width, Qt::Key_Return);
        QVERIFY(d.surface().hasFocus());
        QCOMPARE(d.box().max.x - d.box().min.x, 12.0);
    }
    // Beside the object it would be in the way.
    void itFollowsGestures()
    {
        InBar d;
        auto& width = d.part<ui::LengthField>("capsule-width");
        QTRY_VERIFY(d.ofWindow().isVisible());
        const QString before = width.text();
        QTest::mousePress(&d.surface(), Qt::LeftButton, {}, d.at({180, 50}));
        d.move({175, 50}, Qt::LeftButton);
        d.move({160, 50}, Qt::LeftButton);
        QVERIFY(d.ofWindow().isVisible() && width.text() != before);
        d.release({160, 50});
        QVERIFY(d.ofWindow().isVisible() && width.text() != before);
        const QString typed = width.text();
        d.drag({20, 30}, {60, 60}); // another window is drawn
        QVERIFY(d.ofWindow().isVisible() && width.text() != typed);
        QCOMPARE(d.session.windows().list.size(), 2u);
    }
    void nothingIsOfferedTwice()
    {
        InBar d;
        d.key(Qt::Key_V);
        d.click({60, 20});
        const auto shown = [&](const char* name) {
            int count = 0;
            for (const auto* part : d.bar().findChildren<QWidget*>())
                count += part->isVisible() && part->accessibleName() == QLatin1StringView(name);
            return count;
        };
        QTRY_COMPARE(shown("Stroke width"), 1);
        d.session.select({});
        QTRY_COMPARE(shown("Stroke width"), 0); // the panel Style has it
        d.canvas.setTool("line");
        QTRY_COMPARE(shown("Stroke width"), 1);
        d.canvas.setTool("select");
        d.session.chooseWindow(0);
        QTRY_COMPARE(shown("Stroke width"), 0);
        QCOMPARE(shown("Keep"), 0); // it is that of all windows: their panel has it
    }
    void theBarMayGoFirst()
    {
        InBar d;
        QTRY_VERIFY(d.ofWindow().isVisible());
        {
            QWidget other;
            d.canvas.setCapsuleBar(other);
        }
        QVERIFY(!d.ofWindow().isVisible());
    }
};

} // namespace bars_capsule_in_bar_test

TEST_CLASS(bars_capsule_in_bar_test::CapsuleInBarTest, Widgets)
#include "tests/ui/bars/capsule_in_bar_test.moc"
