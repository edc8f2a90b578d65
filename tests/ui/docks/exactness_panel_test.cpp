// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/ulps.h"
#include "ui/docks/exactness_panel.h"
#include "ui/widgets/error_histogram.h"
#include "ui/widgets/magnifier_view.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QToolButton>
#include <QWheelEvent>

#include <cmath>
#include <set>

#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_exactness_panel_test {

using namespace ui;

namespace {

constexpr clipping::Window window{{0, 0}, {100, 100}};

/// Ten lines across the window: published KWC loses numbers 2, 5 and 8; the others leave the window
/// where a third of a unit is not a double.
app::Sheet tenLines()
{
    app::Sheet sheet;
    sheet.window = window;
    for (int i = 0; i < 10; ++i) {
        app::Shape line;
        const double x = 10. + 8 * i, lean = i % 3 == 2 ? 0.5 : 20 + i;
        line.paths = {{{x, 40}, {{{x + lean, 90. + (i % 3 == 2 ? 0 : 37)}}}}};
        line.style.stroke = app::Colour{};
        sheet.shapes.push_back(std::move(line));
    }
    return sheet;
}

struct Stage {
    Stage()
    {
        applyTheme(*qApp, Theme::Light);
        ::load(session.document, tenLines());
        panel.resize(572, 620);
        table = panel.findChild<DenseTable*>();
        algorithm = panel.findChild<QComboBox*>();
    }
    void show()
    {
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        settle();
    }
    /// The panel shows the results after the next frame.
    void settle()
    {
        QTRY_VERIFY(session.exactness.upToDate());
        QTest::qWait(1);
    }
    void choose(const QString& key)
    {
        algorithm->setCurrentIndex(algorithm->findText(app::titleOf(*app::findVariant(key))));
        settle();
    }
    QString cell(int row, int column) const
    {
        return table->model()->index(row, column).data().toString();
    }
    QPoint place(int row) const
    {
        return table->visualRect(table->model()->index(row, 0)).center();
    }

    app::Session session;
    ExactnessPanel panel{session};
    DenseTable* table;
    QComboBox* algorithm;
};

} // namespace

class ExactnessPanelTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsComputedWhileItIsHidden()
    {
        Stage stage;
        QTest::qWait(30);
        QVERIFY(!stage.session.exactness.asked());
        stage.show();
        QCOMPARE(stage.session.exactness.found().list.size(), std::size_t(10));
        QVERIFY(!stage.session.exactness.piecesAt(window).empty());
        stage.panel.hide();
        QVERIFY(!stage.session.exactness.asked());
        QVERIFY(stage.session.exactness.piecesAt(window).empty());
        QVERIFY(stage.session.exactness.found().list.empty());
    }

    void errorsAreListedWorstFirst()
    {
        Stage stage;
        stage.show();
        QVERIFY2(stage.panel.summary().startsWith("exact is right about all 10 visible lines"),
                 qPrintable(stage.panel.summary()));
        stage.choose("kwc:published");
        QVERIFY2(stage.panel.summary().startsWith(
                     "KWC as published is wrong about 3 of 10 visible lines: 3 lost"),
                 qPrintable(stage.panel.summary()));
        QCOMPARE(stage.table->model()->rowCount(), 10);
        for (int row = 0; row < 3; ++row)
            QVERIFY2(stage.cell(row, 1).startsWith("lost: "), qPrintable(stage.cell(row, 1)));
        const auto& last = *stage.session.exactness.piecesAt(window).back();
        QCOMPARE(last.size(), std::size_t(3)); // painted like differing lines
        QVERIFY(
            stage.panel.findChild<ErrorHistogram*>()->accessibleDescription().endsWith("wrong: 3"));
    }

    void theUnitOfErrorCanBeChanged()
    {
        Stage stage;
        stage.show();
        stage.choose("md");
        const QString before = stage.panel.summary();
        for (QToolButton* button : stage.panel.findChildren<QToolButton*>())
            if (button->text() == "own coordinate")
                QTest::mouseClick(button, Qt::LeftButton);
        QTRY_COMPARE(stage.session.exactness.asked()->errorUnit, app::ErrorUnit::Own);
        QTRY_VERIFY(stage.panel.summary() != before);
    }

    void aClickInspectsAndShowsTheLine()
    {
        Stage stage;
        stage.show();
        stage.choose("kwc:published");
        QSignalSpy wanted(&stage.panel, &ExactnessPanel::placeWanted);
        QTest::mouseClick(stage.table->viewport(), Qt::LeftButton, {}, stage.place(0));
        QVERIFY(stage.session.inspected());
        QCOMPARE(*stage.session.inspected() % 3, std::size_t(2));
        QCOMPARE(wanted.size(), 1);
    }

    void aDoubleClickMagnifiesTheWorseEnd()
    {
        Stage stage;
        stage.show();
        stage.choose("lb:published");
        QTest::mouseClick(stage.table->viewport(), Qt::LeftButton, {}, stage.place(0));
        QTest::mouseDClick(stage.table->viewport(), Qt::LeftButton, {}, stage.place(0));
        QVERIFY(stage.panel.magnifies());
        const std::size_t line = *stage.session.inspected();
        const auto exactness = app::exactnessOf(*app::findVariant("lb:published"),
                                                stage.session.scene.lines()[line], window);
        const app::Magnified& seen = stage.panel.magnifier().seen();
        QVERIFY(seen.returned && seen.exactness);
        const double off = std::max(std::abs(seen.exactness->x), std::abs(seen.exactness->y));
        QCOMPARE(off / seen.largestUlp, app::errorOf(*exactness, app::ErrorUnit::Largest));
        QTest::keyClick(&stage.panel.magnifier(), Qt::Key_Escape);
        QVERIFY(!stage.panel.magnifies());
    }

    void theMagnifierZoomsByWheelAndKeys()
    {
        Stage stage;
        stage.show();
        stage.panel.magnify(0, 1);
        QVERIFY(stage.panel.magnifies());
        Magnifier& magnifier = stage.panel.magnifier();
        const double first = magnifier.view().pixelsPerUnit;
        QTest::keyClick(&magnifier, Qt::Key_PageDown);
        QCOMPARE(magnifier.view().pixelsPerUnit, first / 16);
        QTest::keyClick(&magnifier, Qt::Key_Plus);
        QCOMPARE(magnifier.view().pixelsPerUnit, first / 8);
        QTest::keyClick(&magnifier, Qt::Key_Minus);
        QTest::keyClick(&magnifier, Qt::Key_PageUp);
        QCOMPARE(magnifier.view().pixelsPerUnit, first);
        const QPointF about = QRectF(magnifier.rect()).center() + QPointF(50, 20);
        QWheelEvent wheel(about, magnifier.mapToGlobal(about), {}, {0, -120}, {}, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(&magnifier, &wheel);
        QCOMPARE(magnifier.view().pixelsPerUnit, first / 1.5);
        QTest::keyClick(&magnifier, Qt::Key_Right);
        QTest::keyClick(&magnifier, Qt::Key_Home);
        QCOMPARE(magnifier.view().pixelsPerUnit, first);
        QVERIFY(!magnifier.grab().toImage().isNull());
    }

    void anEndThatIsNotANumberIsReported()
    {
        Stage stage;
        app::Sheet sheet;
        sheet.window = {{0, 0}, {2, 2}};
        app::Shape line;
        line.paths = {{{2, 1}, {{{2, -1}}}}};
        sheet.shapes.push_back(line);
        ::load(stage.session.document, sheet);
        stage.show();
        stage.choose("sb:published");
        QVERIFY2(stage.panel.summary().contains("1 with an end that is not a number"),
                 qPrintable(stage.panel.summary()));
        QCOMPARE(stage.cell(0, 1).left(18), "an end is not a nu");
        stage.panel.magnify(0, 1);
        QVERIFY(!stage.panel.magnifier().isVisible());
        bool said = false;
        for (const QLabel* label : stage.panel.findChildren<QLabel*>())
            said = said || label->text().contains("an end is not a number");
        QVERIFY(said);
    }

    void thePanelIsInTheMainWindow()
    {
        TestWindow test;
        test.show();
        test.open(test.twoLines());
        QTRY_COMPARE(test.window->session().scene.lines().size(), std::size_t(2));
        QTest::keyClick(test.window.get(), Qt::Key_F3, Qt::ShiftModifier);
        QTRY_VERIFY(test.window->session().exactness.asked());
        QTRY_VERIFY(test.window->exactnessPanel().summary().startsWith("exact is right"));
        QTest::keyClick(test.window.get(), Qt::Key_F3, Qt::ShiftModifier);
        QTRY_VERIFY(!test.window->session().exactness.asked());
    }

    void linesAreColouredByTheirError()
    {
        TestWindow test;
        test.show();
        test.open(test.twoLines());
        QTRY_COMPARE(test.window->session().scene.lines().size(), std::size_t(2));
        const auto colours = [&] {
            test.window->canvas().settle();
            const QImage image = test.drawingArea()->grab().toImage();
            std::set<QRgb> found;
            for (int y = 0; y < image.height(); ++y)
                for (int x = 0; x < image.width(); ++x)
                    found.insert(image.pixel(x, y));
            return found;
        };
        const QRgb exact =
            app::errorColour(0, app::Ground::Light, lookOf(qApp->palette()).differs).rgb();
        QVERIFY(!colours().contains(exact));
        test.action("exactness")->trigger();
        QTRY_VERIFY(test.window->session().exactness.upToDate());
        QTRY_VERIFY(colours().contains(exact));
    }
};

} // namespace docks_exactness_panel_test

TEST_CLASS(docks_exactness_panel_test::ExactnessPanelTest, Widgets)
#include "tests/ui/docks/exactness_panel_test.moc"
