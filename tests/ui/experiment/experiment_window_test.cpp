// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/verdict.h"
#include "ui/experiment/experiment_window.h"
#include "ui/experiment/exports.h"
#include "ui/widgets/table_model.h"
#include "ui/widgets/table_view.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QMenu>
#include <QProgressBar>
#include <QScreen>
#include <QSpinBox>
#include <QStandardItemModel>
#include <QTabWidget>
#include <QThreadPool>

#include "tests/app/document/sheet_edits.h"
#include "tests/content_of.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace experiment_experiment_window_test {

using namespace ui;

namespace {

constexpr int patience = 120'000; // milliseconds; only a busy machine needs more than a second

bool aThreadMeasures() { return app::backgroundThreads().activeThreadCount() > 0; }

/// The editor with two lines, and the window that its menu opens.
class Stage {
public:
    Stage()
    {
        test.open(test.twoLines());
        test.show();
        test.action("reproduce-paper")->trigger();
        window = test.window->findChild<ExperimentWindow*>();
        auto prepared = std::make_unique<PreparedAnswers>(*window);
        answers = prepared.get();
        window->setQuestions(std::move(prepared));
    }

    template <class Widget>
    Widget* named(const QString& name) const
    {
        for (Widget* widget : window->findChildren<Widget*>())
            if (widget->accessibleName() == name)
                return widget;
        return nullptr;
    }
    QPushButton* button(const QString& text) const
    {
        for (QPushButton* one : window->findChildren<QPushButton*>())
            if (one->text().remove('&') == text)
                return one;
        return nullptr;
    }
    void click(const QString& text) const { QTest::mouseClick(button(text), Qt::LeftButton); }
    void choose(const QString& key) const
    {
        auto* subject = named<QComboBox>("What is measured");
        subject->setCurrentIndex(subject->findData(key));
    }
    /// A thousand lines, twice.
    void chooseFew() const
    {
        named<QSpinBox>("Lines")->setValue(1000);
        named<QSpinBox>("Runs")->setValue(2);
    }
    bool measuring() const { return button("Cancel")->isVisible(); }
    void runFew(const QString& key) const
    {
        choose(key);
        chooseFew();
        click("Run");
        QTRY_VERIFY_WITH_TIMEOUT(!measuring(), patience);
    }
    /// Chooses an export, and waits for it.
    void run(const QString& command) const
    {
        window->findChild<QAction*>(command)->trigger();
        QTRY_VERIFY(!window->findChild<Exports*>()->busy());
    }
    QString state() const { return window->findChild<QLabel*>("state")->text(); }
    QList<TableView*> shownTables() const
    {
        QList<TableView*> shown;
        for (TableView* view : window->findChildren<TableView*>())
            if (view->isVisible())
                shown << view;
        return shown;
    }

    TestWindow test;
    ExperimentWindow* window;
    PreparedAnswers* answers;
};

QString digitsOf(QString text)
{
    return text.remove(QLocale().groupSeparator()).replace(QChar(0x2212), '-');
}

} // namespace

class ExperimentWindowTest : public QObject {
    Q_OBJECT

private slots:
    void thereIsOneWindowAndThePaperIsItsFirstChoice()
    {
        const Stage stage;
        stage.test.action("reproduce-paper")->trigger();
        QCOMPARE(stage.test.window->findChildren<ExperimentWindow*>().size(), 1);
        QVERIFY(!stage.window->isModal());
        QCOMPARE(stage.named<QComboBox>("What is measured")->currentData().toString(), "all");
        QCOMPARE(stage.named<QSpinBox>("Lines")->text(), "as in the paper");
        QCOMPARE(stage.named<QSpinBox>("Runs")->value(), 10);
        int ticked = 0;
        for (const auto& algorithm : clipping::algorithms())
            ticked += stage.named<QCheckBox>(algorithm.name.data())->isChecked();
        QCOMPARE(ticked, 7);
        QVERIFY(!stage.measuring() && !stage.window->study());
    }

    void aRunShowsTheTables()
    {
        const Stage stage;
        stage.runFew("all");
        const app::Study* study = stage.window->study();
        QVERIFY(study);
        QCOMPARE(study->trials.size(), 2u);
        QCOMPARE(study->trials[0].record.options.lines, 1000u);
        QCOMPARE(study->measures.size(), 3u);
        const auto wanted =
            app::tablesOf(study->trials[0], study->measures[0], app::Against::Paper);
        const auto shown = stage.shownTables();
        QVERIFY(shown.size() >= 2);
        for (std::size_t t = 0; t < wanted.size(); ++t) {
            QCOMPARE(shown[int(t)]->table().key, wanted[t].key);
            const auto* model = shown[int(t)]->model();
            QCOMPARE(model->rowCount(), int(wanted[t].rows.size()));
            for (int row = 0; row < model->rowCount(); ++row)
                for (int column = 0; column < model->columnCount(); ++column)
                    QCOMPARE(digitsOf(model->index(row, column).data().toString()),
                             wanted[t].rows[std::size_t(row)][column]);
        }
        QVERIFY(stage.named<QLabel>("Verdict")->text().contains("ranking"));
    }

    void eachRunCanBeAProcess()
    {
        const Stage stage;
        stage.window->setProgram(CLEARCUT_BINARY);
        for (auto* box : stage.window->findChildren<QCheckBox*>())
            if (box->text() == "Each run in a new process")
                box->click();
        stage.runFew("drawing");
        const app::Study* study = stage.window->study();
        QVERIFY(study);
        const app::Record record = study->trials.front().record;
        QVERIFY(record.options.inProcesses);
        QCOMPARE(record.timings.front().clip.size(), 2u);
        stage.window->setProgram("/bin/false");
        stage.click("Run");
        QTRY_VERIFY_WITH_TIMEOUT(!stage.measuring(), patience);
        QVERIFY(stage.window->study() == study);
        QVERIFY(stage.window->findChild<MessageStrip*>()->isVisible());
    }

    void thereAreEnoughRunsToTellTheAlgorithmsApart()
    {
        const Stage stage;
        const auto runs = [&] { return stage.named<QSpinBox>("Runs")->value(); };
        stage.choose("near-miss");
        const auto published = std::size_t(std::ranges::count_if(
            clipping::algorithms(), [](const auto& one) { return one.published != nullptr; }));
        QCOMPARE(runs(), int(app::usualRounds(published)));
        QVERIFY(runs() > 10);
        stage.choose("table1");
        QCOMPARE(runs(), 10);
        stage.named<QSpinBox>("Runs")->setValue(4); // typed
        stage.choose("near-miss");
        QCOMPARE(runs(), 4);
    }

    void exactIsShownInBatchesAndOneByOneWithDifferentMarks()
    {
        const Stage stage;
        stage.choose("near-miss");
        for (auto* forms : stage.window->findChildren<QAbstractButton*>())
            if (forms->text() == "Corrected")
                forms->click();
        stage.runFew("near-miss");
        const auto* model = stage.shownTables().front()->model();
        QStringList names;
        for (int row = 0; row < model->rowCount(); ++row) {
            names << model->index(row, 0).data().toString();
            QVERIFY2(model->index(row, 0).data(TableModel::VariantRole).isValid(),
                     qPrintable(names.back()));
        }
        QVERIFY2(names.contains("EX") && names.contains("EX one by one"),
                 qPrintable(names.join(' ')));
        QCOMPARE(std::size_t(names.size()), clipping::algorithms().size() + 1);
    }

    void onlyTickedAlgorithmsRun()
    {
        const Stage stage;
        stage.choose("near-miss");
        for (const auto& algorithm : clipping::algorithms())
            if (algorithm.abbreviation != "CS" && algorithm.abbreviation != "KWC")
                QTest::mouseClick(stage.named<QCheckBox>(algorithm.name.data()), Qt::LeftButton, {},
                                  {8, 8});
        stage.runFew("near-miss");
        QVERIFY(stage.window->study());
        const auto& timings = stage.window->study()->trials[0].record.timings;
        QCOMPARE(timings.size(), 2u);
        QCOMPARE(timings[0].variant.algorithm, clipping::findAlgorithm("CS"));
        // The paper selects its seven algorithms, and the ticks of the user are kept.
        stage.choose("table1");
        QVERIFY(stage.named<QCheckBox>(clipping::findAlgorithm("MD")->name.data())->isChecked());
        stage.choose("long");
        QVERIFY(!stage.named<QCheckBox>(clipping::findAlgorithm("MD")->name.data())->isChecked());
    }

    void withoutAlgorithmsItSaysWhatIsMissing()
    {
        const Stage stage;
        stage.choose("inside");
        for (const auto& algorithm : clipping::algorithms())
            QTest::mouseClick(stage.named<QCheckBox>(algorithm.name.data()), Qt::LeftButton, {},
                              {8, 8});
        QVERIFY(!stage.button("Run")->isEnabled() && !stage.button("Quick run")->isEnabled());
        bool said = false;
        for (const QLabel* label : stage.window->findChildren<QLabel*>())
            said = said || label->text() == "Choose at least one algorithm.";
        QVERIFY(said);
    }

    void noNumberOfLinesIsTooSmallOrTooLarge()
    {
        const Stage stage;
        stage.choose("paper");
        auto* lines = stage.named<QSpinBox>("Lines");
        for (const char* typed : {"0", "-5", "99999999999999", "", "abc"}) {
            lines->selectAll();
            QTest::keyClicks(lines, typed);
            QTest::keyClick(lines, Qt::Key_Tab);
            QVERIFY(lines->value() >= 1 && lines->value() <= 1'000'000'000);
        }
    }

    void progressArrivesAndCancelEndsIt()
    {
        const Stage stage;
        stage.choose("table1");
        stage.named<QSpinBox>("Runs")->setValue(50);
        stage.click("Run");
        QVERIFY(stage.measuring());
        QTRY_VERIFY_WITH_TIMEOUT(stage.named<QProgressBar>("Progress")->value() > 0, patience);
        QTRY_VERIFY_WITH_TIMEOUT(stage.state().contains("left"), patience);
        QVERIFY(aThreadMeasures());
        QElapsedTimer timer;
        timer.start();
        stage.click("Cancel");
        qInfo("cancelled in %lld ms", timer.elapsed());
        QVERIFY(!stage.measuring() && !stage.window->study());
        QVERIFY(stage.button("Run")->isEnabled());
        QTRY_VERIFY(!aThreadMeasures()); // the window does not wait for it
        QVERIFY(!stage.window->study());
    }

    void theEditorStaysUsable()
    {
        const Stage stage;
        stage.click("Run");
        auto& session = stage.test.window->session();
        const auto before = session.display().variant.algorithm;
        QElapsedTimer timer;
        timer.start();
        for (QAction* action : stage.test.window->findChildren<QAction*>())
            if (action->objectName() == "algorithm-2")
                action->trigger();
        stage.test.window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(stage.test.window.get()));
        stage.test.window->canvas().setFocus();
        QTest::keyClick(stage.test.drawingArea(), Qt::Key_5);
        QVERIFY(session.display().variant.algorithm != before);
        qInfo("answered in %lld ms", timer.elapsed());
        QVERIFY(stage.measuring());
        stage.click("Cancel");
    }

    void closingStopsIt()
    {
        const Stage stage;
        stage.click("Run");
        QTRY_VERIFY(aThreadMeasures());
        stage.window->close();
        QTRY_VERIFY(!aThreadMeasures());
        stage.test.action("reproduce-paper")->trigger();
        QVERIFY(stage.window->isVisible() && !stage.measuring());
        stage.runFew("table1"); // and it can be used again
        QVERIFY(stage.window->study());
    }

    void theEditorMayCloseDuringARun()
    {
        {
            const Stage stage;
            stage.click("Run");
            QTRY_VERIFY(aThreadMeasures());
        }
        QTRY_VERIFY(!aThreadMeasures());
    }

    void escFirstCancelsThenCloses()
    {
        const Stage stage;
        stage.click("Run");
        QTest::keyClick(stage.window, Qt::Key_Escape);
        QVERIFY(stage.window->isVisible() && !stage.measuring());
        QTest::keyClick(stage.window, Qt::Key_Escape);
        QVERIFY(!stage.window->isVisible());
    }

    void theDrawingCanBeMeasuredIfItHasLines()
    {
        const Stage stage;
        const auto* model =
            qobject_cast<QStandardItemModel*>(stage.named<QComboBox>("What is measured")->model());
        const auto* row = model->item(model->rowCount() - 1);
        QVERIFY(row->isEnabled());
        stage.choose("drawing");
        QCOMPARE(stage.named<QSpinBox>("Lines")->value(), 100'000); // two again and again
        stage.test.window->files().startNew();
        QVERIFY(!row->isEnabled());
        QCOMPARE(stage.named<QComboBox>("What is measured")->currentData().toString(), "all");
        stage.test.open(stage.test.twoLines());
        stage.runFew("drawing");
        QVERIFY(stage.window->study());
        for (const auto& timing : stage.window->study()->trials[0].record.timings)
            QCOMPARE(timing.found.visible, 1000u); // its window is the page
    }

    void typedValuesStayWhenTheDrawingChanges()
    {
        const Stage stage;
        stage.choose("drawing");
        auto* lines = stage.named<QSpinBox>("Lines");
        lines->setValue(1234);
        app::EditedDocument& document = stage.test.window->session().document;
        ::setWindow(document, {{1, 2}, {30, 40}});
        QCOMPARE(lines->value(), 1234);
        stage.choose("long");
        stage.choose("drawing");
        QCOMPARE(lines->value(), 100'000);
        stage.window->hide(); // it asks for missed changes when it is shown again
        stage.test.window->files().startNew();
        QVERIFY(stage.named<QComboBox>("What is measured")->currentData().toString() == "drawing");
        stage.window->show();
        QCOMPARE(stage.named<QComboBox>("What is measured")->currentData().toString(), "all");
    }

    void exportsEqualTheShownResults()
    {
        const Stage stage;
        stage.runFew("table1");
        const app::Study& study = *stage.window->study();
        stage.answers->save = stage.test.path("out.csv");
        stage.run("export-0-csv");
        for (const app::Table& table : app::tablesOf(study)) {
            QFile file(stage.test.folder.filePath("out-" + table.key + ".csv"));
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            const auto lines = file.readAll().trimmed().split('\n');
            QCOMPARE(lines.size(), qsizetype(table.rows.size()) + 1);
            QVERIFY(lines[0].startsWith(table.names.join(',').toUtf8()));
            QVERIFY(lines[1].startsWith(table.rows[0].join(',').toUtf8()));
        }
        for (const QString ending : {"json", "md", "tex"}) {
            stage.answers->save = stage.test.folder.filePath("out." + ending);
            stage.run("export-0-" + ending);
            QFile file(stage.answers->save);
            QVERIFY(file.open(QIODevice::ReadOnly));
            const QString text = QString::fromUtf8(file.readAll());
            QVERIFY2(text.contains("Against the paper"), qPrintable(ending));
        }
        stage.answers->save = "/nowhere/at/all.json";
        stage.run("export-0-json");
        QTRY_VERIFY(stage.window->findChild<MessageStrip*>()->sentence().startsWith(
            "Cannot write /nowhere/at/all.json"));
    }

    void existingFilesAreOverwrittenOnlyAfterAQuestion()
    {
        const Stage stage;
        stage.runFew("near-miss");
        const QString there = stage.test.path("out-classes.csv");
        const auto content = [&] { return contentOf(there); };
        QFile own(there);
        QVERIFY(own.open(QIODevice::WriteOnly));
        own.write("mine");
        own.close();
        stage.answers->save = stage.test.path("out.csv");
        stage.run("export-0-csv");
        QCOMPARE(stage.answers->existing, QStringList{there});
        QCOMPARE(content(), QByteArray("mine"));
        QCOMPARE(QDir(stage.test.folder.path()).entryList({"out-*"}).size(), 1);
        stage.answers->overwrite = true;
        stage.run("export-0-csv");
        QVERIFY(content().startsWith("algorithm,form"));
        QCOMPARE(QDir(stage.test.folder.path()).entryList({"out-*"}).size(),
                 qsizetype(app::tablesOf(*stage.window->study()).size()));
    }

    void theMenuSaysHowManyFilesAreWritten()
    {
        const Stage stage;
        stage.runFew("near-miss");
        auto* action = stage.window->findChild<QAction*>("export-0-csv");
        emit qobject_cast<QMenu*>(action->parent())->aboutToShow();
        const auto tables = app::tablesOf(*stage.window->study()).size();
        QCOMPARE(action->text(), QString("All %1 tables as CSV (%1 files)…").arg(tables));
        QVERIFY(stage.window->findChild<QAction*>("export-0-json")->text().contains("(one file)"));
    }

    void theShownTableIsWrittenToTheChosenFile()
    {
        const Stage stage;
        stage.runFew("near-miss");
        const auto* shown = stage.shownTables().front();
        stage.answers->save = stage.test.path("this.csv");
        stage.run("export-shown-csv");
        QFile file(stage.answers->save);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const app::Table& table = shown->table();
        QVERIFY(file.readAll().startsWith(table.names.join(u',').toUtf8()));
        stage.answers->save = stage.test.path("this.svg");
        stage.run("export-shown-svg"); // no chart is in front
        QVERIFY(!QFile::exists(stage.answers->save));
        stage.window->findChild<QTabWidget*>()->setCurrentIndex(1);
        stage.run("export-shown-svg");
        QVERIFY(QFile::exists(stage.answers->save));
        QCOMPARE(QDir(stage.test.folder.path()).entryList({"this*"}).size(), 2);
    }

    void everyChartIsAFile()
    {
        const Stage stage;
        stage.runFew("near-miss");
        for (const QString ending : {"svg", "pdf", "png"}) {
            stage.answers->save = stage.test.folder.filePath("chart." + ending);
            stage.run("export-1-" + ending);
            const auto files = QDir(stage.test.folder.path()).entryList({"chart-*." + ending});
            QVERIFY2(files.size() >= 4, qPrintable(files.join(' ')));
        }
    }

    void theReportHasTheWindowsVerdict()
    {
        const Stage stage;
        stage.runFew("table1");
        stage.answers->save = stage.test.path("report.html");
        stage.run("export-2-html");
        QFile file(stage.answers->save);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString page = QString::fromUtf8(file.readAll());
        const auto& study = *stage.window->study();
        const QString said = app::verdict(study.trials[0], study.measures).front();
        QVERIFY2(page.contains(said.toHtmlEscaped()) || page.contains(said), qPrintable(said));
        QVERIFY(page.contains("<svg"));
        QVERIFY(stage.window->findChild<MessageStrip*>()->sentence().startsWith("Wrote "));
    }

    void aTableIsCopiedWithItsHeadings()
    {
        const Stage stage;
        stage.runFew("table1");
        QTest::mouseClick(stage.shownTables()[1]->viewport(), Qt::LeftButton, {}, {30, 10});
        stage.click("Copy table");
        QVERIFY(QApplication::clipboard()->text().startsWith("Algorithm\tPaper, total s\tOurs"));
        QTest::mouseClick(stage.shownTables()[0]->viewport(), Qt::LeftButton, {}, {30, 10});
        stage.click("Copy table");
        const QString text = QApplication::clipboard()->text();
        QVERIFY2(text.startsWith("Exec.\tCS\tLB\tCB\tNLN\tSkala\tKWC\tProp."), qPrintable(text));
        QCOMPARE(text.count('\n'), 4); // headings, two runs, their average
    }

    void withoutAnExplanationItsTabIsDisabled()
    {
        const Stage stage;
        for (QCheckBox* box : stage.window->findChildren<QCheckBox*>())
            if (box->text().startsWith("Explain"))
                box->setChecked(false);
        stage.runFew("long");
        auto* tabs = stage.window->findChild<QTabWidget*>();
        QVERIFY(tabs->count() > 1);
        for (int i = 0; i < tabs->count(); ++i)
            QCOMPARE(tabs->isTabEnabled(i), tabs->tabText(i) != "&Why");
    }

    void theWindowIsNeverLargerThanTheScreen()
    {
        const Stage stage;
        const QRect free = stage.window->screen()->availableGeometry();
        stage.window->setMinimumSize(0, 0);
        stage.window->resize(free.width() + 300, free.height() + 200);
        stage.window->move(200, 200);
        stage.window->close();
        ExperimentWindow another(stage.test.window->session(), [] { return QString("x"); });
        another.show();
        QVERIFY(another.width() <= free.width() && another.height() <= free.height());
        QVERIFY(another.minimumWidth() <= free.width() && another.minimumHeight() <= free.height());
        another.resize(another.minimumSize());
        QCoreApplication::processEvents();
        for (const QPushButton* button : another.findChildren<QPushButton*>()) {
            const QString text = button->text().remove('&');
            if (text != "Run" && text != "Quick run")
                continue;
            QVERIFY(button->visibleRegion().boundingRect() == button->rect());
            QVERIFY(
                another.rect().contains(QRect(button->mapTo(&another, QPoint()), button->size())));
        }
    }

    void oldResultsAreMarkedAndNothingJumps()
    {
        const Stage stage;
        stage.runFew("table1");
        auto* age = stage.window->findChild<QLabel*>("age");
        const auto* tabs = stage.window->findChild<QTabWidget*>();
        const auto place = [&] { return tabs->mapTo(stage.window, QPoint()); };
        const QPoint before = place();
        QVERIFY(!age->isVisible());
        stage.answers->save = stage.test.path("out.json");
        stage.run("export-0-json");
        QVERIFY(stage.window->findChild<MessageStrip*>()->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
        stage.named<QSpinBox>("Runs")->setValue(50);
        stage.click("Run");
        QVERIFY(age->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
        stage.click("Cancel");
        QVERIFY(age->isVisible()); // they are still those of the previous run
        stage.runFew("long");
        QVERIFY(!age->isVisible());
        QCoreApplication::processEvents();
        QCOMPARE(place(), before);
    }

    void aShortRunDoesNotChangeTheEstimate()
    {
        const Stage stage;
        const QVariant before = QSettings().value("experimentPace");
        stage.runFew("table1");
        QCOMPARE(QSettings().value("experimentPace"), before);
    }

    void theWindowRemembersItsSize()
    {
        const Stage stage;
        stage.window->resize(700, 500);
        stage.window->close();
        const ExperimentWindow another(stage.test.window->session(), [] { return QString("x"); });
        QCOMPARE(another.size(), QSize(700, 500));
    }
};

} // namespace experiment_experiment_window_test

TEST_CLASS(experiment_experiment_window_test::ExperimentWindowTest, Widgets)
#include "tests/ui/experiment/experiment_window_test.moc"
