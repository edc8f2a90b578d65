// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/compare_table.h"
#include "ui/docks/dock.h"
#include "ui/widgets/segments.h"

#include <QElapsedTimer>
#include <QHeaderView>

#include "tests/app/document/sheet_edits.h"
#include "tests/app/scene/block_scene.h"
#include "tests/app/session/concave_window.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace docks_compare_test {

using namespace ui;

namespace {

/// A window with a drawing of many short lines.
struct CompareWindow : TestWindow {
    explicit CompareWindow(int lines)
    {
        QFile file(path("lines.svg"));
        [[maybe_unused]] const bool open = file.open(QIODevice::WriteOnly);
        file.write("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                   "viewBox='0 0 100 100'><path stroke='#000' fill='none' d='M0 0");
        for (int i = 1; i <= lines; ++i)
            file.write(QByteArray("L%1 %2")
                           .replace("%1", QByteArray::number(i % 101))
                           .replace("%2", QByteArray::number(i % 97)));
        file.write("'/></svg>");
        file.close();
        TestWindow::open(file.fileName());
        ::setWindow(window->session().document, {{25, 25}, {75, 75}});
        show();
    }
    ComparePanel& panel() const { return *window->findChild<ComparePanel*>(); }
    CompareTable& table() const { return panel().table(); }
    Dock& dock() const { return *window->findChild<Dock*>("compare"); }
    int rows() const { return table().model()->rowCount(); }
    QString text(int row, int column) const
    {
        return table().model()->index(row, column).data().toString();
    }
    void openPanel()
    {
        action("compare-live")->trigger();
        QTRY_VERIFY(rows() > 0);
    }
    void click(int row)
    {
        const QRect place = table().visualRect(table().model()->index(row, 0));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place.center());
    }
    void clickHeader(int column)
    {
        const QHeaderView* header = table().horizontalHeader();
        const QPoint at(header->sectionViewportPosition(column) + 8, header->height() / 2);
        QTest::mouseClick(header->viewport(), Qt::LeftButton, {}, at);
    }
    std::vector<double> order(int column) const
    {
        std::vector<double> values;
        for (int row = 0; row < rows(); ++row)
            values.push_back(
                table().model()->index(row, column).data(CompareModel::OrderRole).toDouble());
        return values;
    }
    QString chosen() const
    {
        const app::Display& display = window->session().display();
        return app::shortNameOf(usable(display.variant));
    }
};

int formsInTheCatalogue()
{
    int forms = 0;
    for (const auto& row : clipping::algorithms())
        forms += row.published ? 2 : 1;
    return forms;
}

} // namespace

class CompareTest : public QObject {
    Q_OBJECT

private slots:
    void theRaceRunsOnlyWhileThePanelIsOpen()
    {
        CompareWindow t(2000);
        QVERIFY(!t.dock().isVisible());
        QVERIFY(!t.panel().race().running());
        t.openPanel();
        QVERIFY(t.panel().race().running());
        QVERIFY(t.action("compare-live")->isChecked());
        t.action("compare-live")->trigger();
        QVERIFY(!t.panel().race().running());
        QVERIFY(!t.dock().isVisible());
        t.openPanel();
        t.dock().close();
        QVERIFY(!t.panel().race().running());
        QTRY_VERIFY(!t.action("compare-live")->isChecked());
    }
    void theRacePausesBehindAnotherTab()
    {
        CompareWindow t(2000);
        t.openPanel();
        t.window->raisePanel("algorithm");
        QTRY_VERIFY(!t.panel().race().running());
        t.action("compare-live")->trigger(); // to the front again
        QTRY_VERIFY(t.panel().race().running());
        QVERIFY(t.action("compare-live")->isChecked());
    }
    void everyFormHasARow()
    {
        CompareWindow t(2000);
        t.openPanel();
        QCOMPARE(t.rows(), formsInTheCatalogue());
        QCOMPARE(t.panel().field(), "2,000 lines, rotated order, 1 thread");
        app::Session& session = t.window->session();
        const auto visible =
            visibleIn(session.scene.lines(), session.region(), app::exactVariant());
        for (int row = 0; row < t.rows(); ++row)
            if (t.text(row, CompareModel::Name) == "EX")
                QCOMPARE(t.text(row, CompareModel::Visible), QLocale().toString(int(visible)));
    }
    void theSegmentsChooseTheForms()
    {
        CompareWindow t(2000);
        t.openPanel();
        const auto buttons = t.panel().findChild<Segments*>()->findChildren<QToolButton*>();
        QTest::mouseClick(buttons[0], Qt::LeftButton);
        QTRY_COMPARE(t.rows(), int(clipping::algorithms().size()));
        QTest::mouseClick(buttons[1], Qt::LeftButton);
        QTRY_COMPARE(t.rows(), formsInTheCatalogue() - int(clipping::algorithms().size()));
        QVERIFY(t.text(0, CompareModel::Name).endsWith("as published"));
    }
    void aClickChoosesAlgorithmAndForm()
    {
        CompareWindow t(2000);
        t.openPanel();
        for (int row = 0; row < t.rows(); ++row) {
            const QString name = t.text(row, CompareModel::Name);
            t.click(row);
            QCOMPARE(t.chosen(), name);
            if (name.endsWith("published"))
                QCOMPARE(t.window->session().display().variant.form, clipping::Form::Published);
        }
    }
    void keysChooseToo()
    {
        CompareWindow t(2000);
        t.openPanel();
        t.click(1);
        const QString next = t.text(2, CompareModel::Name), first = t.text(1, CompareModel::Name);
        QTest::keyClick(&t.table(), Qt::Key_Down);
        QCOMPARE(t.chosen(), next);
        QTest::keyClick(&t.table(), Qt::Key_Up);
        QCOMPARE(t.chosen(), first);
    }
    void anAlgorithmChosenElsewhereIsSelectedHere()
    {
        CompareWindow t(2000);
        t.openPanel();
        app::Display display = t.window->session().display();
        display.variant.algorithm = clipping::findAlgorithm("lb");
        t.window->session().setDisplay(display);
        const auto current = t.table().currentIndex();
        QCOMPARE(t.text(current.row(), CompareModel::Name), "LB");
        QVERIFY(t.table().selectionModel()->isRowSelected(current.row()));
    }
    void aHeaderSortsAndReverses()
    {
        CompareWindow t(2000);
        t.openPanel();
        t.click(3);
        const QString chosen = t.chosen();
        for (const int column : {CompareModel::Operations, CompareModel::Visible,
                                 CompareModel::Differ, CompareModel::Median}) {
            t.clickHeader(column);
            QVERIFY(std::ranges::is_sorted(t.order(column)));
            t.clickHeader(column);
            QVERIFY(std::ranges::is_sorted(t.order(column), std::greater()));
            QCOMPARE(t.text(t.table().currentIndex().row(), CompareModel::Name), chosen);
            QCOMPARE(t.chosen(), chosen);
        }
    }
    /// Numbers are updated ten times a second, the order once a second.
    void theOrderIsStable()
    {
        app::Session session;
        CompareTable table(session);
        const auto rowsWith = [](double first, double second) {
            std::vector<app::RaceRow> rows;
            for (const double ms : {first, second})
                rows.push_back(
                    {.variant = {&clipping::algorithms()[rows.size()], clipping::Form::Corrected},
                     .milliseconds = {ms}});
            return rows;
        };
        const auto top = [&] { return table.model()->index(0, CompareModel::Name).data(); };
        table.showRows(rowsWith(1, 2), 5000);
        const auto before = top();
        QElapsedTimer shown;
        shown.start();
        table.showRows(rowsWith(3, 2), 5000);
        if (shown.elapsed() < 500) // or this program got no processor time
            QCOMPARE(top(), before);
        QTRY_VERIFY((table.showRows(rowsWith(3, 2), 5000), top() != before));
    }
    /// The table has no numbers of another place, and agrees with the status bar.
    void atAStarItSaysWhoCanClip()
    {
        CompareWindow t(2000);
        t.openPanel();
        CompareTable& table = t.table();
        const auto rowOf = [&](const QString& name) {
            for (int row = 0; row < t.rows(); ++row)
                if (t.text(row, CompareModel::Name) == name)
                    return row;
            return -1;
        };
        QVERIFY(table.isColumnHidden(CompareModel::Here));
        setWindows(t.window->session(), {concaveWindow("Star", {{25, 25}, {75, 75}})});
        QVERIFY(!table.isColumnHidden(CompareModel::Here));
        for (const auto& [name, words] :
             {std::pair("KWC", "rectangles only"), std::pair("CB", "convex only"),
              std::pair("EX", "clips it")}) {
            QVERIFY2(rowOf(name) >= 0, name);
            QCOMPARE(t.text(rowOf(name), CompareModel::Here), QString(words));
        }
        const auto noNumbers = [&] {
            for (int row = 0; row < t.rows(); ++row)
                for (const int column :
                     {CompareModel::Median, CompareModel::Spread, CompareModel::Operations,
                      CompareModel::Visible, CompareModel::Differ})
                    if (t.text(row, column) != QStringLiteral("–"))
                        return false;
            return true;
        };
        QVERIFY(noNumbers());
        QTest::qWait(300); // no round of before comes late
        QVERIFY(noNumbers());
        setWindows(t.window->session(), {{.shape = app::RectangleShape{{{25, 25}, {75, 75}}}}});
        QTRY_VERIFY(!noNumbers());
        QVERIFY(table.isColumnHidden(CompareModel::Here));
        QTRY_VERIFY(t.panel().race().upToDate());
        const std::size_t visible =
            visibleIn(t.window->session().scene.lines(), t.window->session().region(),
                      app::exactVariant());
        QTRY_COMPARE(t.text(rowOf("EX"), CompareModel::Visible), app::countText(visible));
    }
    void columnsAreHiddenWithoutRoom()
    {
        CompareWindow t(2000);
        t.openPanel();
        CompareTable& table = t.table();
        const auto hidden = [&](int width) {
            t.dock().setFloating(true);
            t.dock().resize(width, 500);
            QCoreApplication::processEvents();
            QList<int> columns;
            for (const int column :
                 {CompareModel::Visible, CompareModel::Spread, CompareModel::Sparkline})
                if (table.isColumnHidden(column))
                    columns << column;
            return columns;
        };
        QCOMPARE(hidden(640), QList<int>{});
        qsizetype before = 0;
        for (int width = 640; width >= 272; width -= 10) {
            const auto columns = hidden(width); // in the order in which they are hidden
            QVERIFY(columns.size() >= before);
            before = columns.size();
            QCOMPARE(columns, (QList<int>{CompareModel::Visible, CompareModel::Spread,
                                          CompareModel::Sparkline}
                                   .mid(0, before)));
            for (const int column : {CompareModel::Name, CompareModel::Median,
                                     CompareModel::Operations, CompareModel::Differ})
                QVERIFY(!table.isColumnHidden(column));
        }
        QCOMPARE(before, 3);
    }
    void fewLinesAreNotTimed()
    {
        CompareWindow t(312);
        t.openPanel();
        QCOMPARE(t.panel().field(), "312 lines: too few to time");
        QCOMPARE(t.panel().groups(), "");
        QCOMPARE(t.text(0, CompareModel::Median), "–");
        QVERIFY(t.text(0, CompareModel::Visible).toInt() > 0);
        QCOMPARE(t.text(0, CompareModel::Name), "CS"); // in the order of the catalogue
        QCOMPARE(t.text(t.rows() - 1, CompareModel::Name), "SB as published");
        const QHeaderView* header = t.table().horizontalHeader();
        QVERIFY(!header->isSortIndicatorShown());
        t.clickHeader(CompareModel::Visible);
        QVERIFY(header->isSortIndicatorShown());
    }
    void theDockAreaIsWideWhileThePanelIsOpen()
    {
        CompareWindow t(312);
        t.window->resize(1440, 900);
        const QWidget* canvas = &t.window->canvas();
        QCoreApplication::processEvents();
        const int before = canvas->width();
        t.openPanel();
        QTRY_COMPARE(t.dock().width(), 572);
        QVERIFY(t.dock().y() < 100);
        t.dock().close();
        QTRY_COMPARE(canvas->width(), before);
    }
    void aUserLayoutIsLeftAlone()
    {
        CompareWindow t(312);
        auto* layers = t.window->findChild<Dock*>("layers");
        t.window->addDockWidget(Qt::LeftDockWidgetArea, layers); // as if it had been dragged there
        QCoreApplication::processEvents();
        t.openPanel();
        QCOMPARE(t.window->dockWidgetArea(layers), Qt::LeftDockWidgetArea);
        t.action("compare-live")->trigger();
        QCoreApplication::processEvents();
        QCOMPARE(t.window->dockWidgetArea(layers), Qt::LeftDockWidgetArea);
    }
};

} // namespace docks_compare_test

TEST_CLASS(docks_compare_test::CompareTest, Widgets)
#include "tests/ui/docks/compare_test.moc"
