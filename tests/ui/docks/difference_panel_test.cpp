// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/session/difference_row.h"
#include "ui/docks/difference_panel.h"

#include <QComboBox>
#include <QDockWidget>
#include <QHeaderView>
#include <QSignalSpy>
#include <QToolButton>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_difference_panel_test {

using namespace ui;
using clipping::Segment;

namespace {

/// Ten lines across the window (0,0)-(100,100), of which published KWC loses numbers 2, 5 and 8:
/// they run from below to above and lean by less than one unit. The longest of them is number 5.
app::Sheet tenLines()
{
    app::Sheet sheet;
    sheet.window = {{0, 0}, {100, 100}};
    for (int i = 0; i < 10; ++i) {
        app::Shape line;
        const double x = 10. + 8 * i, lean = i % 3 == 2 ? 0.5 : 30;
        line.paths = {{{x, i == 5 ? -10. : 40.}, {{{x + lean, 90}}}}};
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
        panel.resize(572, 500);
        table = panel.findChild<DenseTable*>();
        const auto boxes = panel.findChildren<QComboBox*>();
        a = boxes[0];
        b = boxes[1];
        ulps = panel.findChild<QSpinBox*>();
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
        QTRY_VERIFY(session.differences.upToDate());
        QTest::qWait(1);
    }
    QString cell(int row, int column) const
    {
        return table->model()->index(row, column).data().toString();
    }
    void click(int row, int column = 0) const
    {
        const QRect cell = table->visualRect(table->model()->index(row, column));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell.center());
    }
    void clickHeading(int column) const
    {
        const QHeaderView* header = table->horizontalHeader();
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {},
                          {header->sectionViewportPosition(column) + 20, 10});
    }
    void choose(QComboBox* box, const QString& name) const
    {
        const int index = box->findText(name);
        QVERIFY2(index >= 0, qPrintable(name));
        box->setCurrentIndex(index);
    }

    app::Session session;
    DifferencePanel panel{session};
    DenseTable* table;
    QComboBox *a, *b;
    QSpinBox* ulps;
};

} // namespace

class DifferencePanelTest : public QObject {
    Q_OBJECT

private slots:
    void nothingIsComputedWhileItIsHidden()
    {
        Stage stage;
        QVERIFY(!stage.session.differences.asked());
        stage.show();
        QVERIFY(stage.session.differences.asked());
        QCOMPARE(stage.session.differences.found().list.size(), std::size_t(3));
        stage.panel.hide();
        QVERIFY(!stage.session.differences.asked());
        QVERIFY(stage.session.differences.piecesAt(stage.session.window()).empty());
    }

    void differencesAreCountedAndListed()
    {
        Stage stage;
        stage.show();
        QCOMPARE(stage.panel.summary(), "KWC as published loses 3 lines that exact keeps.");
        QCOMPARE(stage.table->model()->rowCount(), 3);
        QCOMPARE(stage.cell(0, 0), "3"); // lines are counted from 1
        QCOMPARE(stage.cell(1, 0), "6");
        QCOMPARE(stage.cell(0, 1), "only exact keeps it");
        QCOMPARE(stage.cell(0, 3), "–");
        QVERIFY2(stage.cell(0, 2).startsWith("50.00"), qPrintable(stage.cell(0, 2)));
        QCOMPARE(stage.cell(0, 4), "26.00; 40.00 → 26.50; 90.00");
        QVERIFY(stage.cell(0, 5).endsWith(", shape 3"));
    }

    void aClickInspectsAndShowsTheLine()
    {
        Stage stage;
        stage.show();
        QSignalSpy wanted(&stage.panel, &DifferencePanel::placeWanted);
        stage.click(1);
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(5));
        QVERIFY(!wanted.isEmpty());
        const auto place = wanted.back()[0].value<clipping::Window>();
        QCOMPARE(place.min.y, 0.); // all that exact keeps
        QCOMPARE(place.max.y, 90.);
        // The keyboard too.
        QTest::keyClick(stage.table, Qt::Key_Down);
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(8));
    }

    void columnsAreAsWideAsTheirTexts()
    {
        Stage stage;
        stage.show();
        QVERIFY(stage.table->columnWidth(3) < 50); // a dash
        QVERIFY(stage.table->columnWidth(4)
                >= stage.table->fontMetrics().horizontalAdvance(stage.cell(0, 4)));
        QVERIFY(stage.table->columnViewportPosition(5) < stage.table->viewport()->width());
    }

    /// Also of lines far below, which are not measured.
    void theLongestLineNumberFits()
    {
        Stage stage;
        app::Sheet many = tenLines();
        const auto ten = many.shapes;
        while (many.shapes.size() < 30'000)
            many.shapes.insert(many.shapes.end(), ten.begin(), ten.end());
        ::load(stage.session.document, many);
        stage.show();
        QTRY_VERIFY(stage.table->model()->rowCount() > 5000);
        const int last = stage.table->model()->rowCount() - 1;
        const QString number = stage.table->model()->index(last, 0).data().toString();
        QVERIFY(number.size() > 5);
        QVERIFY(stage.table->columnWidth(0)
                > stage.table->fontMetrics().horizontalAdvance(number) + 8);
    }
    /// In a low panel, too.
    void theExplanationOfAMisprintIsWhole()
    {
        Stage stage;
        stage.panel.resize(320, 250);
        stage.show();
        stage.choose(stage.a, "MD with Step 2 as printed");
        QLabel* told = nullptr;
        for (auto* label : stage.panel.findChildren<QLabel*>())
            if (label->isVisible() && label->text().startsWith("The text of the paper"))
                told = label;
        QVERIFY(told);
        QTRY_VERIFY(told->height() >= told->heightForWidth(told->width()));
    }
    void anyColumnSorts()
    {
        Stage stage;
        stage.show();
        stage.clickHeading(0); // was ascending
        QCOMPARE(stage.cell(0, 0), "9");
        stage.clickHeading(2);
        stage.clickHeading(2);
        QCOMPARE(
            stage.cell(stage.table->horizontalHeader()->sortIndicatorOrder() == Qt::DescendingOrder
                           ? 0
                           : 2,
                       0),
            "6"); // the longest
        stage.click(0);
        QVERIFY(stage.session.inspected());
        QCOMPARE(app::countText(*stage.session.inspected() + 1), stage.cell(0, 0));
    }

    void theSelectedRowKeepsItsLine()
    {
        Stage stage;
        stage.show();
        stage.click(1);
        stage.clickHeading(0);
        ::setWindow(stage.session.document, {{0, 0}, {100, 99}});
        stage.settle();
        QCOMPARE(stage.cell(stage.table->currentIndex().row(), 0), "6");
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(5));
    }

    /// The table is filled once, however often the window moves before.
    void theFrameComesBeforeTheTable()
    {
        struct Canvas : QObject {
            const QSignalSpy& filled;
            int framesBefore = 0;
            explicit Canvas(const QSignalSpy& spy) : filled(spy) {}
            bool event(QEvent* event) override
            {
                if (event->type() == QEvent::UpdateRequest && filled.isEmpty())
                    ++framesBefore;
                return QObject::event(event);
            }
        };
        Stage stage;
        stage.show();
        QSignalSpy filled(stage.table->model(), &QAbstractItemModel::modelReset);
        Canvas canvas(filled);
        connect(&stage.session.differences, &app::LiveDifferences::changed, &canvas, [&] {
            QCoreApplication::postEvent(&canvas, new QEvent(QEvent::UpdateRequest),
                                        Qt::LowEventPriority);
        });
        for (int i = 1; i <= 3; ++i) {
            stage.session.setPreview(
                {.windows = withWindow(stage.session.now().windows(),
                                       clipping::Window{{0, 0}, {100., 100. - i}})});
            stage.session.differences.finish();
            QVERIFY(filled.isEmpty());
        }
        QTRY_COMPARE(filled.size(), 1);
        QVERIFY(canvas.framesBefore > 0);
        QTest::qWait(1);
        QCOMPARE(filled.size(), 1);
    }

    void nextAndPreviousWrapAround()
    {
        Stage stage;
        stage.show();
        std::vector<std::size_t> visited;
        for (const int by : {1, 1, 1, 1, -1, -1}) {
            stage.panel.go(by);
            visited.push_back(*stage.session.inspected());
        }
        QCOMPARE(visited, (std::vector<std::size_t>{2, 5, 8, 2, 8, 5}));
    }

    void theButtonsGoThroughTheDifferences()
    {
        Stage stage;
        stage.show();
        const auto button = [&](const QString& name) -> QToolButton* {
            for (auto* one : stage.panel.findChildren<QToolButton*>())
                if (one->accessibleName().startsWith(name))
                    return one;
            return nullptr;
        };
        QToolButton *next = button("Next difference"), *previous = button("Previous difference");
        QVERIFY(next && next->isVisible() && previous && previous->isVisible());
        QCOMPARE(stage.panel.position(), "");
        for (const char* position : {"1 of 3", "2 of 3", "3 of 3", "1 of 3"}) {
            QTest::mouseClick(next, Qt::LeftButton);
            QCOMPARE(stage.panel.position(), position);
        }
        QTest::mouseClick(previous, Qt::LeftButton);
        QCOMPARE(stage.panel.position(), "3 of 3");
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(8));
        stage.session.inspect(std::nullopt);
        QCOMPARE(stage.panel.position(), "");
        stage.choose(stage.a, "CS  Cohen-Sutherland");
        stage.settle();
        QVERIFY(!next->isVisible() && !previous->isVisible());
    }

    void anotherComparisonSelectsNothing()
    {
        Stage stage;
        stage.show();
        for (const char* a : {"MD  Matthes-Drakopoulos, as published",
                              "KWC  Kodituwakku-Wijeweera-Chamikara, as published"}) {
            stage.choose(stage.a, a);
            stage.settle();
            QVERIFY(!stage.session.inspected());
            QVERIFY(!stage.table->selectionModel()->hasSelection());
        }
        stage.click(1);
        QVERIFY(stage.session.inspected());
        stage.choose(stage.a, "LB  Liang-Barsky");
        QVERIFY(!stage.session.inspected());
        stage.session.inspect(3); // which is not involved
        stage.choose(stage.a, "CS  Cohen-Sutherland");
        QCOMPARE(stage.session.inspected(), std::optional<std::size_t>(3));
    }

    void swappingKeepsTheDifferences()
    {
        Stage stage;
        stage.show();
        const QString a = stage.a->currentText(), b = stage.b->currentText();
        QTest::mouseClick(stage.panel.findChild<QToolButton*>("swap-comparison"), Qt::LeftButton);
        QCOMPARE(stage.a->currentText(), b);
        QCOMPARE(stage.b->currentText(), a);
        QTRY_COMPARE(stage.panel.summary(), "KWC as published loses 3 lines that exact keeps.");
        QCOMPARE(stage.cell(0, 4), "–");
    }

    void agreementIsReported()
    {
        Stage stage;
        stage.show();
        stage.choose(stage.a, "LB  Liang-Barsky");
        QTRY_COMPARE(stage.panel.summary(), "They agree on all 10 lines here.");
        QVERIFY(!stage.table->isVisible());
        stage.session.document.load({});
        QTRY_COMPARE(stage.panel.summary(), "There are no lines to compare.");
    }

    void theAllowedUlpsAreApplied()
    {
        Stage stage;
        stage.show();
        QVERIFY(stage.ulps->text().contains("as in the contract"));
        stage.choose(stage.a, "MD  Matthes-Drakopoulos, as published");
        stage.settle();
        const double contract = stage.session.differences.asked()->allowed();
        stage.ulps->setFocus();
        QTest::keyClick(stage.ulps, Qt::Key_Up); // from the contract to none
        QCOMPARE(stage.session.differences.asked()->allowed(), 0.0);
        QCOMPARE(stage.ulps->text(), "0 ulps");
        QTest::keyClick(stage.ulps, Qt::Key_Up);
        QCOMPARE(stage.ulps->text(), "1 ulp");
        QTest::keyClick(stage.ulps, Qt::Key_Down);
        QTest::keyClick(stage.ulps, Qt::Key_Down);
        QCOMPARE(stage.session.differences.asked()->allowed(), contract);
    }

    void aMisprintIsExplained()
    {
        Stage stage;
        stage.show();
        const auto explanation = [&] {
            for (const QLabel* label : stage.panel.findChildren<QLabel*>())
                if (label->isVisible() && label->text().contains("(ymin\u00a0−\u00a0y1)"))
                    return true;
            return false;
        };
        QVERIFY(!explanation());
        stage.choose(stage.a, "MD with Step 2 as printed");
        QVERIFY(explanation());
        stage.settle();
        QVERIFY2(stage.panel.summary().startsWith("MD with Step 2 as printed "),
                 qPrintable(stage.panel.summary()));
    }

    void theMenuOpensThePanelAndTheCanvasShowsTheLine()
    {
        TestWindow t;
        ::load(t.window->session().document, tenLines());
        t.show();
        QAction* open = t.action("differences");
        auto* dock = t.window->findChild<QDockWidget*>("difference");
        QVERIFY(dock->isHidden() && !open->isChecked());
        QVERIFY(!t.window->session().differences.asked());
        QTest::keyClick(t.drawingArea(), Qt::Key_F9, Qt::ShiftModifier);
        QVERIFY(!dock->isHidden() && open->isChecked());
        QTRY_COMPARE(t.window->differencePanel().summary(),
                     "KWC as published loses 3 lines that exact keeps.");

        t.window->canvas().fitWindow();
        const app::View before = t.window->canvas().view();
        QTest::keyClick(t.drawingArea(), Qt::Key_F4);
        QCOMPARE(t.window->session().inspected(), std::optional<std::size_t>(2));
        QCOMPARE(t.window->canvas().view(), before); // which sees it well
        app::View aside = before;
        aside.pan({1e4, 0});
        t.window->canvas().go(aside);
        QTest::keyClick(t.drawingArea(), Qt::Key_F4, Qt::ShiftModifier);
        QCOMPARE(t.window->session().inspected(), std::optional<std::size_t>(8));
        QCOMPARE(t.window->canvas().view().centre, app::Point(74.25, 65));
        QCOMPARE(t.window->canvas().view().zoom, before.zoom);

        QTest::keyClick(t.drawingArea(), Qt::Key_F9, Qt::ShiftModifier);
        QVERIFY(dock->isHidden() && !open->isChecked());
        QVERIFY(!t.window->session().differences.asked());
        // The next one opens it again.
        t.action("next-difference")->trigger();
        QVERIFY(!dock->isHidden());
        QCOMPARE(t.window->session().inspected(), std::optional<std::size_t>(2));
    }

    void theMenuShowsTheMisprint()
    {
        TestWindow t;
        ::load(t.window->session().document, tenLines());
        t.show();
        t.action("misprint")->trigger();
        QVERIFY(t.window->showsPanel("difference"));
        const auto& asked = t.window->session().differences.asked();
        QVERIFY(asked && asked->a.misprint && asked->b == app::exactVariant());
        QCOMPARE(asked->a.misprint->key, "md-step-2");
    }

    void theNextLineIsBroughtIntoTheView()
    {
        TestWindow t;
        ::load(t.window->session().document, tenLines());
        t.show();
        app::View aside = t.window->canvas().view();
        aside.pan({1e4, 0});
        t.window->canvas().go(aside);
        QTest::keyClick(t.drawingArea(), Qt::Key_F8);
        QCOMPARE(t.window->canvas().view().centre, app::Point(25, 65)); // of (10,40)-(40,90)
        QCOMPARE(t.window->canvas().view().zoom, aside.zoom);
    }

    void halfAMillionRows()
    {
        Stage stage;
        app::Sheet sheet;
        sheet.window = {{0, 0}, {1000, 1000}};
        app::Shape comb;
        for (int i = 0; i < 500'000; ++i)
            comb.paths.push_back({{i * 0.0019, 10}, {{{i * 0.0019 + 0.5, 990}}}});
        comb.style.stroke = app::Colour{};
        sheet.shapes = {comb};
        ::load(stage.session.document, std::move(sheet));
        stage.show();
        QTRY_COMPARE_WITH_TIMEOUT(stage.table->model()->rowCount(), 500'000, 20'000);
        QElapsedTimer clock;
        clock.start();
        stage.table->sortByColumn(2, Qt::DescendingOrder);
        stage.table->scrollToBottom();
        stage.panel.grab();
        qInfo("sort, scroll and paint 500,000 rows: %lld ms", clock.elapsed());
        QCOMPARE(stage.table->model()->rowCount(), 500'000);
    }
};

} // namespace docks_difference_panel_test

TEST_CLASS(docks_difference_panel_test::DifferencePanelTest, Widgets)
#include "tests/ui/docks/difference_panel_test.moc"
