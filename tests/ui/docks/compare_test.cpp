// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/short_names.h"
#include "app/base/text.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/compare_table.h"
#include "ui/docks/dock.h"
#include "ui/docks/verdict_list.h"
#include "ui/widgets/segments.h"

#include <QHeaderView>
#include <QScrollBar>

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
        QTRY_VERIFY(!panel().field().isEmpty());
    }
    int rowOf(const QString& name) const
    {
        for (int row = 0; row < rows(); ++row)
            if (text(row, CompareModel::Name) == name)
                return row;
        return -1;
    }
    void click(int row, int column = 0)
    {
        const QRect place = table().visualRect(table().model()->index(row, column));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, place.center());
    }
    QString chosen() const
    {
        const app::Display& display = window->session().display();
        return app::shortNameOf(usable(display.variant));
    }
};

const auto everyAlgorithm = int(clipping::algorithms().size());

int published()
{
    return int(std::ranges::count_if(clipping::algorithms(),
                                     [](const auto& row) { return row.published != nullptr; }));
}

app::RaceRow rowOf(std::size_t number, clipping::Form form, double ms)
{
    return {.variant = {&clipping::algorithms()[number], form}, .milliseconds = {ms}};
}

/// A table without a race.
struct TableAlone {
    app::Session session;
    CompareTable table{session};

    /// The first algorithms of the catalogue, in that form.
    void show(const std::vector<double>& times, std::size_t lines = 5000)
    {
        std::vector<app::RaceRow> rows;
        for (const double ms : times)
            rows.push_back(rowOf(rows.size(), clipping::Form::Corrected, ms));
        table.showRows(rows, lines);
    }
    QStringList names() const
    {
        QStringList all;
        for (int row = 0; row < table.model()->rowCount(); ++row)
            all << table.model()->index(row, CompareModel::Name).data().toString();
        return all;
    }
    void clickHeader(int column) { emit table.horizontalHeader()->sectionClicked(column); }
};

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
        t.window->raisePanel("exactness");
        QTRY_VERIFY(!t.panel().race().running());
        t.action("compare-live")->trigger(); // to the front again
        QTRY_VERIFY(t.panel().race().running());
        QVERIFY(t.action("compare-live")->isChecked());
    }
    void everyAlgorithmHasARow()
    {
        CompareWindow t(2000);
        t.openPanel();
        QCOMPARE(t.rows(), everyAlgorithm);
        QCOMPARE(t.panel().field(), "2,000 lines, rotated order, 1 thread");
        for (int row = 0; row < t.rows(); ++row) {
            const clipping::Algorithm& algorithm = clipping::algorithms()[std::size_t(row)];
            QCOMPARE(t.text(row, CompareModel::Name), app::latin(algorithm.abbreviation));
            QCOMPARE(t.text(row, CompareModel::Hollow) == "none", !algorithm.published);
        }
    }
    /// What a table with a row for each form showed.
    void theTipHasAllNumbersOfBothForms()
    {
        CompareWindow t(2000);
        t.openPanel();
        app::Session& session = t.window->session();
        const auto visible =
            visibleIn(session.scene.lines(), session.region(), app::exactVariant());
        const QModelIndex ex = t.table().model()->index(t.rowOf("EX"), CompareModel::Name);
        const QString tip = ex.data(Qt::ToolTipRole).toString();
        QVERIFY2(tip.contains(app::countText(visible) + " visible lines"), qPrintable(tip));
        QVERIFY(tip.contains("Corrected: ") && !tip.contains("As published: "));
        const QString both = ex.siblingAtRow(t.rowOf("CS")).data(Qt::ToolTipRole).toString();
        for (const char* words : {"Corrected: ", "As published: ", " ± ", " operations per line"})
            QVERIFY2(both.contains(words), words);
    }
    void theSegmentsChooseTheForms()
    {
        CompareWindow t(2000);
        t.openPanel();
        CompareTable& table = t.table();
        const auto hidden = [&] {
            return std::pair(table.isColumnHidden(CompareModel::Filled),
                             table.isColumnHidden(CompareModel::Hollow));
        };
        const auto buttons = t.panel().findChild<Segments*>()->findChildren<QToolButton*>();
        QVERIFY(buttons[0]->isChecked());
        QCOMPARE(hidden(), std::pair(false, false));
        QTest::mouseClick(buttons[1], Qt::LeftButton);
        QTRY_COMPARE(t.rows(), everyAlgorithm);
        QCOMPARE(hidden(), std::pair(false, true));
        QTest::mouseClick(buttons[2], Qt::LeftButton);
        QTRY_COMPARE(t.rows(), published());
        QVERIFY(t.text(0, CompareModel::Name).endsWith("as published"));
        QCOMPARE(hidden(), std::pair(true, false));
    }
    void aClickChoosesTheAlgorithm()
    {
        CompareWindow t(2000);
        t.openPanel();
        for (int row = 0; row < t.rows(); ++row) {
            t.click(row);
            QCOMPARE(t.chosen(), t.text(row, CompareModel::Name));
        }
    }
    void aClickOnATimeChoosesTheForm()
    {
        CompareWindow t(2000);
        t.openPanel();
        const auto form = [&] { return t.window->session().display().variant.form; };
        t.click(0, CompareModel::Hollow);
        QCOMPARE(t.chosen(), "CS as published");
        t.click(1);
        QCOMPARE(t.chosen(), "LB as published"); // the form that is wanted
        t.click(1, CompareModel::Filled);
        QCOMPARE(t.chosen(), "LB");
        QCOMPARE(form(), clipping::Form::Corrected);
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
    void aHeadingSortsOnce()
    {
        TableAlone t;
        t.show({2, 3, 1});
        const QStringList listed{"CS", "LB", "CB"};
        QCOMPARE(t.names(), listed);
        for (const int column : {CompareModel::Filled, CompareModel::Lane}) {
            t.clickHeader(column);
            const QStringList sorted{"CB", "CS", "LB"};
            QCOMPARE(t.names(), sorted);
            QVERIFY(t.table.horizontalHeader()->isSortIndicatorShown());
            t.show({1, 2, 3}); // as a race goes on
            QCOMPARE(t.names(), sorted);
            t.clickHeader(column);
            QCOMPARE(t.names(), listed);
            QVERIFY(!t.table.horizontalHeader()->isSortIndicatorShown());
            t.show({2, 3, 1});
        }
    }
    void sortingByTimeAgainSortsAgain()
    {
        TableAlone t;
        t.show({2, 3, 1});
        t.table.sortByTime();
        QCOMPARE(t.names(), (QStringList{"CB", "CS", "LB"}));
        t.show({3, 2, 2});
        t.table.sortByTime();
        QCOMPARE(t.names(), (QStringList{"LB", "CB", "CS"})); // a tie is in the list's order
        t.clickHeader(CompareModel::Filled);
        QCOMPARE(t.names(), (QStringList{"CS", "LB", "CB"}));
    }
    void theMostDifferencesComeFirst()
    {
        TableAlone t;
        std::vector<app::RaceRow> rows;
        for (const std::size_t lost : {3, 0, 7})
            rows.push_back(rowOf(rows.size(), clipping::Form::Corrected, 1)),
                rows.back().differences.onlyB = lost;
        rows.push_back(rowOf(1, clipping::Form::Published, 1));
        rows.back().differences.onlyB = 5;
        t.table.showRows(rows, 5000);
        t.clickHeader(CompareModel::Differ);
        QCOMPARE(t.names(), (QStringList{"CB", "LB", "CS"}));
    }
    void formsThatAreMissingComeLast()
    {
        TableAlone t;
        std::vector<app::RaceRow> rows;
        for (std::size_t i = 0; i < 3; ++i)
            rows.push_back(rowOf(i, clipping::Form::Corrected, 1));
        rows.push_back(rowOf(2, clipping::Form::Published, 1));
        rows.push_back(rowOf(1, clipping::Form::Published, 2));
        t.table.showRows(rows, 5000);
        t.clickHeader(CompareModel::Hollow);
        QCOMPARE(t.names(), (QStringList{"CB", "LB", "CS"}));
        QCOMPARE(t.table.model()->index(2, CompareModel::Hollow).data().toString(), "none");
    }
    void theMenuSortsByTime()
    {
        CompareWindow t(5000);
        t.action("sort-by-time")->trigger();
        QVERIFY(t.dock().isVisible());
        QTRY_VERIFY(t.panel().race().settled());
        QTRY_COMPARE(t.panel().groups().isEmpty(), false);
        t.action("sort-by-time")->trigger();
        std::vector<double> times;
        for (int row = 0; row < t.rows(); ++row)
            times.push_back(t.table()
                                .model()
                                ->index(row, CompareModel::Filled)
                                .data(CompareModel::OrderRole)
                                .toDouble());
        QVERIFY(std::ranges::is_sorted(times));
    }
    void screenReadersGetTheNumbersAndTheirUnit()
    {
        TableAlone t;
        t.table.showRows(std::vector{rowOf(0, clipping::Form::Corrected, 0.2311),
                                     rowOf(0, clipping::Form::Published, 0.5),
                                     rowOf(1, clipping::Form::Corrected, 0.1)},
                         5000);
        const auto spoken = [&](int row, int column) {
            return t.table.model()->index(row, column).data(Qt::AccessibleTextRole).toString();
        };
        QCOMPARE(spoken(0, CompareModel::Lane), "corrected 231 µs, as published 500 µs");
        QCOMPARE(spoken(0, CompareModel::Filled), "231 µs");
        QCOMPARE(spoken(0, CompareModel::Name), "CS, Cohen-Sutherland");
        QCOMPARE(spoken(1, CompareModel::Hollow), "none");
        QCOMPARE(t.table.model()->headerData(CompareModel::Lane, Qt::Horizontal).toString(),
                 "0 to 500 µs");
    }
    /// Numbers change at most twice a second, and the last ones are shown in the end.
    void numbersDoNotFlicker()
    {
        CompareWindow t(2000);
        t.openPanel();
        QTRY_VERIFY(t.panel().race().settled());
        QTest::qWait(1); // what was posted
        int shown = 0;
        connect(t.table().model(), &QAbstractItemModel::headerDataChanged, this,
                [&shown](Qt::Orientation, int first) { shown += first == 0; });
        auto& race = const_cast<app::LiveRace&>(t.panel().race());
        for (int i = 0; i < 5; ++i)
            emit race.advanced();
        QVERIFY2(shown <= 1, qPrintable(QString::number(shown)));
        const int before = shown;
        QTRY_COMPARE(shown, before + 1);
    }
    /// Each paragraph is shown whole, whatever its length.
    void theVerdictIsNotElided()
    {
        CompareWindow t(2000);
        t.openPanel();
        setWindows(t.window->session(),
                   {{.name = "Box", .shape = app::RectangleShape{{{25, 25}, {75, 75}}}},
                    concaveWindow("Star", {{25, 25}, {75, 75}})});
        const VerdictList& verdict = t.panel().verdict();
        QTRY_VERIFY(verdict.text().contains("algorithms cannot clip Star."));
        QTRY_VERIFY(verdict.text().contains("All corrected forms agree in Box."));
        QCOMPARE(t.panel().place().section(' ', 1), "and differences: Box only, all can clip it");
        QCoreApplication::processEvents();
        const auto labels = verdict.findChildren<QLabel*>();
        QVERIFY(labels.size() > 2);
        for (const QLabel* label : labels)
            if (label->isVisible())
                QVERIFY2(label->height() >= label->heightForWidth(label->width()),
                         qPrintable(label->text()));
    }
    /// The table has no numbers of another place, and agrees with the status bar.
    void atAStarItSaysWhoCanClip()
    {
        CompareWindow t(2000);
        t.openPanel();
        CompareTable& table = t.table();
        QVERIFY(table.isColumnHidden(CompareModel::Here));
        setWindows(t.window->session(), {concaveWindow("Star", {{25, 25}, {75, 75}})});
        QVERIFY(!table.isColumnHidden(CompareModel::Here));
        for (const auto& [name, words] :
             {std::pair("KWC", "rectangles only"), std::pair("CB", "convex only"),
              std::pair("EX", "clips it")}) {
            QVERIFY2(t.rowOf(name) >= 0, name);
            QCOMPARE(t.text(t.rowOf(name), CompareModel::Here), QString(words));
        }
        QCOMPARE(table.model()->headerData(CompareModel::Here, Qt::Horizontal).toString(), "Star");
        const auto tip = [&] {
            return table.model()
                ->index(t.rowOf("EX"), CompareModel::Name)
                .data(Qt::ToolTipRole)
                .toString();
        };
        const auto noNumbers = [&] {
            for (int row = 0; row < t.rows(); ++row)
                for (const int column :
                     {CompareModel::Filled, CompareModel::Hollow, CompareModel::Differ})
                    if (const QString text = t.text(row, column); text != "–" && text != "none")
                        return false;
            return !tip().contains("visible lines");
        };
        QVERIFY(noNumbers());
        QTest::qWait(300); // no round of before comes late
        QVERIFY(noNumbers());
        setWindows(t.window->session(), {{.shape = app::RectangleShape{{{25, 25}, {75, 75}}}}});
        QTRY_VERIFY(!noNumbers());
        QVERIFY(table.isColumnHidden(CompareModel::Here));
        QTRY_VERIFY(t.panel().race().upToDate());
        const std::size_t visible = visibleIn(t.window->session().scene.lines(),
                                              t.window->session().region(), app::exactVariant());
        QTRY_VERIFY(tip().contains(app::countText(visible) + " visible lines"));
    }
    /// The names go first, then the lane, then a digit: never the unit.
    void columnsAreHiddenWithoutRoom()
    {
        TableAlone t;
        t.show({0.2313, 0.4567, 0.1999});
        t.table.show();
        const auto title = [&] {
            return t.table.model()->headerData(CompareModel::Filled, Qt::Horizontal).toString();
        };
        const auto digits = [&] {
            return t.table.model()->index(0, CompareModel::Filled).data().toString();
        };
        const auto at = [&](int width) {
            t.table.resize(width, 300);
            QCoreApplication::processEvents();
            return !t.table.isColumnHidden(CompareModel::Lane);
        };
        QVERIFY(at(560));
        QCOMPARE(title(), "median");
        QCOMPARE(digits(), "231");
        bool lane = true;
        for (int width = 560; width >= 120; width -= 10) {
            const bool shown = at(width);
            QVERIFY(lane || !shown); // it does not come back
            lane = shown;
            QCOMPARE(title(), lane ? "median" : "median µs");
            QCOMPARE(digits().size(), 3); // of three before the decimal point none is lost
        }
        QVERIFY(!lane);
        t.show({1.234, 2.3, 4.5});
        QCOMPARE(digits(), "1.2");
        at(560);
        QCOMPARE(digits(), "1.23");
    }
    void twelveRowsFitBesideWhatStandsBelow()
    {
        CompareWindow t(2000);
        t.window->resize(1440, 900);
        t.action("workspace-compare")->trigger();
        QTRY_VERIFY(!t.panel().field().isEmpty());
        QCoreApplication::processEvents();
        QVERIFY(!t.table().verticalScrollBar()->isVisible());
        QCOMPARE(t.rows(), everyAlgorithm);
    }
    void fewLinesAreNotTimed()
    {
        CompareWindow t(312);
        t.openPanel();
        QCOMPARE(t.panel().field(), "312 lines: too few to time");
        QCOMPARE(t.panel().groups(), "");
        QCOMPARE(t.text(0, CompareModel::Filled), "–");
        QVERIFY(t.panel().verdict().text().contains("312 lines are too few to time."));
        const QHeaderView* header = t.table().horizontalHeader();
        t.table().sortByTime();
        QVERIFY(!header->isSortIndicatorShown());
        emit t.table().horizontalHeader()->sectionClicked(CompareModel::Filled);
        QVERIFY(!header->isSortIndicatorShown());
        emit t.table().horizontalHeader()->sectionClicked(CompareModel::Differ);
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
