// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of the next shape, in the bar across the top.
#include "app/lettering/stroke_fonts.h"
#include "ui/bars/option_bar.h"
#include "ui/bars/shape_options.h"
#include "ui/widgets/font_list.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"

#include <QCheckBox>
#include <QSpinBox>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace bars_shape_options_test {

using namespace ui;

class ShapeOptionsTest : public QObject {
    Q_OBJECT

    struct Bar : TestWindow {
        Bar()
        {
            open(twoLines());
            show();
            window->resize(1280, 800);
        }
        ShapeOptions& row() { return *window->optionBar().findChild<ShapeOptions*>(); }
        template <class Field>
        Field* field(const char* name)
        {
            for (auto* field : row().findChildren<Field*>())
                if (field->accessibleName() == name)
                    return field;
            return nullptr;
        }
        template <class Field>
        void type(const char* name, const char* text)
        {
            auto* in = field<Field>(name);
            QTRY_VERIFY(in->isVisible());
            in->setFocus();
            in->selectAll();
            QTest::keyClicks(in, text);
            QTest::keyClick(in, Qt::Key_Return);
            QCOMPARE(window->focusWidget(), drawingArea());
        }
        void drag()
        {
            const QPoint from = drawingArea()->rect().center();
            QTest::mousePress(drawingArea(), Qt::LeftButton, {}, from);
            for (const int by : {20, 60})
                QTest::mouseMove(drawingArea(), from + QPoint(by, by / 2));
            QTest::mouseRelease(drawingArea(), Qt::LeftButton, {}, from + QPoint(60, 30));
        }
        app::Recipe drawn()
        {
            const auto& objects = window->session().now().objects();
            return objects[objects.size() - 1].particulars().recipe;
        }
    };

private slots:
    void theyAreThereForTheirToolsAlone()
    {
        Bar bar;
        for (const char* tool : {"select", "line", "polygon", "star", "rectangle", "ellipse"}) {
            bar.window->canvas().setTool(tool);
            QTRY_COMPARE(bar.field<QSpinBox>("Sides")->isVisible(), tool == QByteArray("polygon"));
            QTRY_COMPARE(bar.field<QSpinBox>("Points")->isVisible(), tool == QByteArray("star"));
            QTRY_COMPARE(bar.field<LengthField>("Corner radius")->isVisible(),
                         tool == QByteArray("rectangle"));
        }
    }
    void theNextShapeHasThem()
    {
        Bar bar;
        bar.window->canvas().setTool("polygon");
        bar.type<QSpinBox>("Sides", "7");
        bar.drag();
        QCOMPARE(std::get<app::StarRecipe>(bar.drawn()).points, 7);
        bar.window->canvas().setTool("star");
        bar.type<QSpinBox>("Points", "8");
        bar.type<QSpinBox>("Inner radius", "50");
        bar.drag();
        const auto star = std::get<app::StarRecipe>(bar.drawn());
        QCOMPARE(star.points, 8);
        QVERIFY(std::abs(star.inner / star.outer - 0.5) < 1e-12);
        bar.window->canvas().setTool("rectangle");
        bar.type<LengthField>("Corner radius", "2");
        bar.drag();
        QVERIFY(std::get<app::RectangleRecipe>(bar.drawn()).radius > 0);
    }
    void theyFollowWhatWasDrawn()
    {
        Bar bar;
        bar.window->canvas().setTool("polygon");
        const QPoint from = bar.drawingArea()->rect().center();
        QTest::mousePress(bar.drawingArea(), Qt::LeftButton, {}, from);
        for (const int by : {20, 60})
            QTest::mouseMove(bar.drawingArea(), from + QPoint(by, by / 2));
        QTest::keyClick(bar.drawingArea(), Qt::Key_Up);
        QTest::mouseRelease(bar.drawingArea(), Qt::LeftButton, {}, from + QPoint(60, 30));
        QTRY_COMPARE(bar.field<QSpinBox>("Sides")->value(), 7);
    }
    void linesMakeAChainUnlessThatIsSwitchedOff()
    {
        Bar bar;
        const auto named = [&](const QString& text) -> QCheckBox& {
            for (auto* box : bar.row().findChildren<QCheckBox*>())
                if (box->text() == text)
                    return *box;
            qFatal("no box %s", qPrintable(text));
        };
        const auto click = [](QCheckBox& box) {
            QTest::mouseClick(&box, Qt::LeftButton, {}, {8, box.height() / 2});
        };
        bar.window->canvas().setTool("line");
        QCheckBox &chain = named("Chain lines"), &start = named("Close at the start");
        QTRY_VERIFY(chain.isVisible() && start.isVisible());
        QVERIFY(chain.isChecked() && start.isChecked() && start.isEnabled());
        click(chain);
        QCOMPARE(bar.window->canvas().keptNumbers("line").value()[0], 0.0);
        QVERIFY(!start.isEnabled());
        QCOMPARE(bar.window->focusWidget(), bar.drawingArea());
        click(chain);
        click(start);
        QCOMPARE(bar.window->canvas().keptNumbers("line").value()[1], 0.0);
        bar.window->canvas().setTool("polyline");
        QTRY_VERIFY(named("Close").isVisible() && !chain.isVisible());
        click(named("Close"));
        QCOMPARE(bar.window->canvas().keptNumbers("polyline").value()[0], 1.0);
    }
    void anArcIsByItsCentreOrThroughPoints()
    {
        Bar bar;
        bar.window->canvas().setTool("arc");
        auto* by = bar.row().findChild<Segments*>("arc-by");
        QTRY_VERIFY(by->isVisible());
        QCOMPARE(by->chosen(), 0);
        const QString hint = bar.window->canvas().toolHint();
        QTest::mouseClick(by->findChildren<QToolButton*>()[1], Qt::LeftButton);
        QVERIFY(bar.window->canvas().toolHint() != hint);
        QTest::keyClick(bar.drawingArea(), Qt::Key_C); // back
        QCOMPARE(bar.window->canvas().toolHint(), hint);
        QTRY_COMPARE(by->chosen(), 0);
    }
    void thePencilKeepsItsTolerance()
    {
        Bar bar;
        bar.window->canvas().setTool("pencil");
        auto* field = bar.field<LengthField>("Tolerance");
        QTRY_VERIFY(field->isVisible());
        QCOMPARE(field->text(), QString()); // as the view is zoomed
        const auto stroke = [&] {
            const QPoint from = bar.drawingArea()->rect().center();
            QTest::mousePress(bar.drawingArea(), Qt::LeftButton, {}, from);
            for (int i = 1; i < 30; ++i)
                QTest::mouseMove(bar.drawingArea(), from + QPoint(5 * i, i % 2 ? 12 : -12));
            QTest::mouseRelease(bar.drawingArea(), Qt::LeftButton, {}, from + QPoint(150, 0));
            const auto& objects = bar.window->session().now().objects();
            return objects[objects.size() - 1].path().subpaths().front().segments.size();
        };
        const std::size_t fine = stroke();
        bar.type<LengthField>("Tolerance", "300");
        QVERIFY(stroke() < fine);
        bar.window->canvas().setTool("line");
        bar.window->canvas().setTool("pencil");
        QTRY_VERIFY(field->text().startsWith("300"));
        bar.type<LengthField>("Tolerance", "0");
        QCOMPARE(stroke(), fine);
    }
    void theNextTextHasItsFontAndSize()
    {
        Bar bar;
        bar.window->canvas().setTool("text");
        auto* font = bar.row().findChild<FontList*>();
        QTRY_VERIFY(font->isVisible());
        const QString other = app::strokeFonts().back().name;
        QVERIFY(!font->font().isEmpty() && font->font() != other);
        font->setCurrentIndex(font->findData(other));
        bar.type<LengthField>("Size", "30mm");
        QTest::mouseClick(bar.drawingArea(), Qt::LeftButton, {},
                          bar.drawingArea()->rect().center());
        QTest::keyClicks(QApplication::focusWidget(), "ab");
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
        const auto text = std::get<app::TextRecipe>(bar.drawn());
        QCOMPARE(text.font, other);
        const double unit = bar.window->session().now().page().millimetresPerUnit();
        QVERIFY(std::abs(text.size * unit - 30) < 1e-9);
    }
    void clipWindowsHaveThemToo()
    {
        Bar bar;
        app::Session& session = bar.window->session();
        bar.window->canvas().setTool("window");
        QTRY_VERIFY(!bar.field<QSpinBox>("Points")->isVisible());
        session.nextWindow = "star";
        emit session.displayChanged();
        QTRY_VERIFY(bar.field<QSpinBox>("Points")->isVisible());
    }
};

} // namespace bars_shape_options_test

TEST_CLASS(bars_shape_options_test::ShapeOptionsTest, Widgets)
#include "tests/ui/bars/shape_options_test.moc"
