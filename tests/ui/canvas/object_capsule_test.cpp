// SPDX-License-Identifier: GPL-3.0-or-later
// The controls beside selected objects.
#include "app/session/window_steps.h"
#include "ui/canvas/object_capsule.h"
#include "ui/widgets/font_list.h"
#include "ui/widgets/length_field.h"

#include <QLabel>
#include <QSignalSpy>

#include "tests/test_class.h"
#include "tests/ui/canvas/stage.h"

namespace canvas_object_capsule_test {

namespace {

app::Shape square(app::Point from, app::Point to)
{
    app::Shape shape;
    shape.paths.push_back(
        {from, {{{to.x, from.y}}, {to}, {{from.x, to.y}}}, true}); // a closed outline
    shape.style.stroke = app::Colour{};
    return shape;
}

struct ObjectStage : Stage {
    ObjectStage()
        : Stage(ui::Backend::Raster, {line({10, 50}, {190, 50}), square({60, 20}, {100, 40})})
    {
        canvas->setTool("select");
        session.changeDisplay([](app::Display& d) { d.unit = app::Unit::Px; });
        canvas->settle();
    }
    ui::ObjectCapsule& capsule() { return *canvas->findChild<ui::ObjectCapsule*>(); }
    ui::LengthField& field(const char* name)
    {
        return *canvas->findChild<ui::LengthField*>(QStringLiteral("object-capsule-") + name);
    }
    QRect place() { return {surface().mapFrom(canvas.get(), capsule().pos()), capsule().size()}; }
    clipping::Window box() { return *session.selectionBounds(); }
};

} // namespace

class ObjectCapsuleTest : public QObject {
    Q_OBJECT

private slots:
    void itIsBesideTheSelectedObjects()
    {
        ObjectStage stage;
        QVERIFY(!stage.capsule().isVisible());
        stage.click({60, 30}); // the left side of the square
        QVERIFY(stage.session.selection() == app::ObjectRanges({1}));
        QVERIFY(stage.capsule().isVisible());
        QCOMPARE(stage.capsule().accessibleName(), QStringLiteral("Path 2, selected"));
        const QRect square(stage.at({60, 20}), stage.at({100, 40}));
        QVERIFY(!stage.place().intersects(square.adjusted(-12, -12, 12, 12)));
        stage.canvas->setTool("line");
        QVERIFY(!stage.capsule().isVisible());
        stage.canvas->setTool("select");
        QVERIFY(stage.capsule().isVisible());
        stage.session.select({});
        QVERIFY(!stage.capsule().isVisible());
    }
    // Keys and the capsule are for what was chosen last.
    void aWindowThatIsChosenHasItsOwn()
    {
        ObjectStage stage;
        stage.session.select({1});
        stage.session.chooseWindow(0);
        QVERIFY(!stage.capsule().isVisible());
        stage.session.select({0});
        QVERIFY(stage.capsule().isVisible());
    }
    void nodesHaveNone()
    {
        ObjectStage stage;
        stage.session.select({1});
        stage.canvas->setTool("nodes");
        QVERIFY(!stage.capsule().isVisible());
    }
    void typedSizesAreUndoSteps()
    {
        ObjectStage stage;
        stage.session.select({1});
        ui::LengthField& width = stage.field("w");
        QCOMPARE(width.text(), QStringLiteral("40.0"));
        stage.key(Qt::Key_Return);
        QVERIFY(width.hasFocus());
        QTest::keyClicks(&width, "20*3");
        QTest::keyClick(&width, Qt::Key_Tab);
        QCOMPARE(stage.box(), (clipping::Window{{60, 20}, {120, 40}}));
        ui::LengthField& height = stage.field("h");
        QVERIFY(height.hasFocus());
        QTest::keyClicks(&height, "10");
        QTest::keyClick(&height, Qt::Key_Return);
        QVERIFY(stage.surface().hasFocus());
        QCOMPARE(stage.box(), (clipping::Window{{60, 20}, {120, 30}}));
        QCOMPARE(stage.session.history.count(), 2);
        stage.session.history.undo();
        stage.session.history.undo();
        QTRY_COMPARE(width.text(), QStringLiteral("40.0"));
    }
    void aLineHasALengthAndAnAngle()
    {
        ObjectStage stage;
        stage.session.select({0});
        QVERIFY(!stage.field("w").isVisible() && !stage.field("h").isVisible());
        ui::LengthField& length = stage.field("length");
        QVERIFY(length.isVisible());
        QCOMPARE(length.text(), QStringLiteral("180.0"));
        stage.key(Qt::Key_Return);
        QVERIFY(length.hasFocus());
        QTest::keyClicks(&length, "100");
        QTest::keyClick(&length, Qt::Key_Return);
        QCOMPARE(stage.box(), (clipping::Window{{10, 50}, {110, 50}}));
        ui::LengthField& angle = stage.field("angle");
        angle.setFocus();
        angle.selectAll();
        QTest::keyClicks(&angle, "90");
        QTest::keyClick(&angle, Qt::Key_Return);
        QVERIFY(near(stage.box(), {{10, -50}, {10, 50}}, 1e-9));
    }
    void whatIsTypedIsForTheObjectsThatWereShown()
    {
        ObjectStage stage;
        stage.session.select({1});
        stage.key(Qt::Key_Return);
        QTest::keyClicks(&stage.field("w"), "7");
        stage.session.select({0});
        QCOMPARE(stage.session.history.count(), 0);
        QVERIFY(stage.surface().hasFocus());
        stage.session.select({1});
        QCOMPARE(stage.field("w").text(), QStringLiteral("40.0"));
    }
    void whatIsImpossibleIsRefused()
    {
        ObjectStage stage;
        QSignalSpy refused(&stage.session, &app::Session::refused);
        stage.session.select({1});
        stage.key(Qt::Key_Return);
        QTest::keyClicks(&stage.field("w"), "0");
        QTest::keyClick(&stage.field("w"), Qt::Key_Return);
        QCOMPARE(refused.size(), 1);
        QCOMPARE(stage.session.history.count(), 0);
    }
    void itIsGoneInEveryGesture()
    {
        ObjectStage stage;
        stage.session.select({1});
        stage.move({60, 30});
        stage.press({60, 30});
        stage.move({70, 30}, Qt::LeftButton);
        QVERIFY(!stage.capsule().isVisible());
        stage.release({70, 30});
        QVERIFY(stage.capsule().isVisible());
        stage.key(Qt::Key_G); // moves without a button
        QVERIFY(!stage.capsule().isVisible());
        stage.key(Qt::Key_Escape);
        QVERIFY(stage.capsule().isVisible());
    }
    void itsMenuIsAskedFor()
    {
        ObjectStage stage;
        stage.session.select({1});
        QSignalSpy wanted(stage.canvas.get(), &ui::Canvas::objectMenuWanted);
        QTest::qWait(300); // until it listens
        QTest::mouseClick(stage.canvas->findChild<QToolButton*>("object-capsule-more"),
                          Qt::LeftButton);
        QCOMPARE(wanted.size(), 1);
    }
    void aTextHasItsFontAndItsSize()
    {
        ObjectStage stage;
        stage.canvas->setTool("text");
        stage.click({20, 80});
        QTest::keyClicks(QApplication::focusWidget(), "Clear");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        stage.canvas->setTool("select");
        stage.session.select({2});
        auto& size = stage.field("text-size");
        auto& font = *stage.capsule().findChild<ui::FontList*>();
        QVERIFY(size.isVisible() && font.isVisible());
        QVERIFY(!stage.field("w").isVisible() && !stage.field("h").isVisible());
        const auto text = [&] {
            return std::get<app::TextRecipe>(
                app::Recipe(stage.session.now().objects()[2].particulars().recipe));
        };
        QCOMPARE(font.font(), text().font);
        stage.key(Qt::Key_Return);
        QVERIFY(size.hasFocus());
        QTest::keyClicks(&size, "7px");
        QTest::keyClick(&size, Qt::Key_Return);
        QVERIFY(stage.surface().hasFocus());
        const double px = 25.4 / 96 / stage.session.now().page().millimetresPerUnit();
        QVERIFY(std::abs(text().size - 7 * px) < 1e-9);
        const QString before = text().font;
        font.setFocus();
        QTest::keyClick(&font, Qt::Key_Down);
        QVERIFY(text().font != before);
        QCOMPARE(font.font(), text().font);
        stage.session.select({1});
        QVERIFY(!size.isVisible() && !font.isVisible() && stage.field("w").isVisible());
    }
    void itIsSwitchedOff()
    {
        ObjectStage stage;
        stage.session.select({1});
        stage.canvas->setCapsuleHome(app::CapsuleHome::Off);
        QVERIFY(!stage.capsule().isVisible());
        stage.key(Qt::Key_Return); // nothing to go into
        QVERIFY(stage.surface().hasFocus());
    }
};

} // namespace canvas_object_capsule_test

TEST_CLASS(canvas_object_capsule_test::ObjectCapsuleTest, Widgets)
#include "tests/ui/canvas/object_capsule_test.moc"
