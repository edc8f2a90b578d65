// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judge/judge_window.h"
#include "ui/judge/verdict_view.h"
#include "ui/widgets/table_view.h"

#include <QApplication>
#include <QDir>
#include <QLabel>
#include <QPushButton>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace judge_judge_window_test {

using namespace ui;

namespace {

class Answers : public PreparedAnswers {
public:
    using PreparedAnswers::PreparedAnswers;

    QString folder;
    bool trusts = true;
    int trustAsked = 0;

    QString libraryToOpen(const QString&) override { return open; }
    QString folderToWrite(const QString&, const QString&) override { return folder; }
    bool trustLibrary(const QString&) override { return ++trustAsked, trusts; }
};

QString pathOf(const char* sample) { return QStringLiteral(PLUG_INS "/%1.so").arg(sample); }

/// The editor, and the window that its menu opens.
class Stage {
public:
    Stage()
    {
        test.show();
        test.action("judge")->trigger();
        window = test.window->findChild<JudgeWindow*>();
        window->setProgram(CLEARCUT_BINARY);
        auto prepared = std::make_unique<Answers>(*window);
        answers = prepared.get();
        window->setQuestions(std::move(prepared));
    }

    QPushButton* button(const QString& text) const
    {
        for (auto* one : window->findChildren<QPushButton*>())
            if (one->text().remove('&') == text)
                return one;
        return nullptr;
    }
    void click(const QString& text) const { QTest::mouseClick(button(text), Qt::LeftButton); }
    void judge(const QString& path) const
    {
        answers->open = path;
        click("Choose library…");
        QTRY_VERIFY_WITH_TIMEOUT(!window->judging(), 60'000);
    }
    QString sentence() const { return window->findChild<QLabel*>("verdict")->text(); }
    TableView* table(const QString& key) const
    {
        for (auto* view : window->findChildren<TableView*>())
            if (view->table().key == key)
                return view;
        return nullptr;
    }

    TestWindow test;
    JudgeWindow* window = nullptr;
    Answers* answers = nullptr;
};

} // namespace

class JudgeWindowTest : public QObject {
    Q_OBJECT

private slots:
    void aCorrectLibraryPassesAndIsRaced()
    {
        Stage stage;
        QVERIFY(!stage.window->verdict());
        stage.judge(pathOf("example"));
        QVERIFY2(stage.sentence().startsWith("Passed: Liang-Barsky, the example"),
                 qPrintable(stage.sentence()));
        QVERIFY(!stage.table("findings"));
        QVERIFY(!stage.button("Open line in microscope")->isVisible());
        const auto* race = stage.table("race");
        QVERIFY(race);
        QCOMPARE(std::size_t(race->model()->rowCount()), clipping::algorithms().size() + 1);
        QVERIFY(stage.table("classes") && stage.table("categories"));
        const app::Table& points = stage.table("categories")->table();
        QCOMPARE(std::size_t(points.rows.size()), app::plug_in::categories().size());
        for (const QStringList& row : points.rows)
            QCOMPARE(row[points.names.indexOf("points")], "10");
    }

    void errorsInTheRaceAreShown()
    {
        Stage stage;
        stage.judge(pathOf("race_cheat"));
        QVERIFY2(stage.sentence().contains("In the race"), qPrintable(stage.sentence()));
        QCOMPARE(stage.table("findings")->table().names.back(), "error");
    }

    void choosingSourceCodeExplainsHowToCompileIt()
    {
        Stage stage;
        stage.judge(QStringLiteral(SOURCE_DIR "/resources/plug_in/example.c"));
        QVERIFY2(stage.sentence().endsWith("compile it first."), qPrintable(stage.sentence()));
        const auto labels = stage.window->findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [](const QLabel* label) {
            return label->text().startsWith("cc -std=c99 -O2 -shared") && label->isVisible();
        }));
    }

    /// The line opens in the microscope, clipped by the reference.
    void aWrongLibraryShowsItsLines()
    {
        Stage stage;
        stage.judge(pathOf("lost_corner"));
        QVERIFY(stage.sentence().contains("loses visible lines"));
        auto* findings = stage.table("findings");
        QVERIFY(findings);
        const auto& verdict = *stage.window->verdict();
        QCOMPARE(std::size_t(findings->model()->rowCount()), verdict.findings.size());
        const auto& microscope = stage.test.window->session().microscope;
        const auto row = findings->model()->index(2, 0);
        const QPoint at = findings->visualRect(row).center();
        QTest::mouseClick(findings->viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(findings->viewport(), Qt::LeftButton, {}, at);
        QVERIFY(microscope.isOpen());
        QCOMPARE(microscope.tracedLine().line, verdict.findings[2].question.line);
        QCOMPARE(microscope.tracedLine().window, verdict.findings[2].question.window);
        QCOMPARE(microscope.tracedLine().variant, app::exactVariant());
        findings->selectRow(1);
        stage.click("Open line in microscope");
        QCOMPARE(microscope.tracedLine().line, verdict.findings[1].question.line);
    }

    void anUnloadableLibrarySaysWhy()
    {
        Stage stage;
        stage.judge(pathOf("not_a_plug_in"));
        QVERIFY(stage.sentence().contains("no function clearcut_clip"));
        QVERIFY(!stage.table("categories"));
        QVERIFY(stage.button("Judge again")->isEnabled());
    }

    void aLibraryRunsOnlyWithPermission()
    {
        Stage stage;
        stage.answers->trusts = false;
        stage.judge(pathOf("example"));
        QCOMPARE(stage.answers->trustAsked, 1);
        QVERIFY(!stage.window->verdict());
        stage.answers->trusts = true;
        stage.judge(pathOf("not_a_plug_in"));
        stage.judge(pathOf("not_a_plug_in"));
        QCOMPARE(stage.answers->trustAsked, 2);
        stage.answers->open.clear(); // cancelled
        stage.click("Choose library…");
        QCOMPARE(stage.answers->trustAsked, 2);
    }

    void judgingCanBeCancelled()
    {
        Stage stage;
        stage.answers->open = pathOf("endless_loop");
        stage.click("Choose library…");
        QVERIFY(stage.window->judging());
        QVERIFY(stage.button("Cancel")->isVisible());
        QTest::keyClick(stage.window, Qt::Key_Escape);
        QVERIFY(!stage.window->judging() && stage.window->isVisible());
        QVERIFY(!stage.window->verdict());
        stage.click("Judge again");
        QVERIFY(stage.window->judging());
        QTest::keyClick(stage.window, Qt::Key_Escape);
        QTest::keyClick(stage.window, Qt::Key_Escape);
        QVERIFY(!stage.window->isVisible());
    }

    /// The way students work: compile, look, compile again.
    void aRebuiltLibraryIsJudgedAgain()
    {
        Stage stage;
        const QString library = stage.test.path("mine.so");
        QVERIFY(QFile::copy(pathOf("not_a_plug_in"), library));
        stage.judge(library);
        QVERIFY(stage.sentence().contains("no function"));
        QVERIFY(QFile::remove(library) && QFile::copy(pathOf("lost_corner"), library));
        QFile file(library);
        QVERIFY(file.open(QIODevice::ReadWrite));
        QVERIFY(file.setFileTime(QDateTime::currentDateTime().addSecs(1),
                                 QFileDevice::FileModificationTime));
        file.close();
        QTRY_VERIFY_WITH_TIMEOUT(stage.sentence().contains("loses visible lines"), 60'000);
    }

    void theExampleIsSaved()
    {
        Stage stage;
        stage.answers->folder = stage.test.folder.path();
        stage.click("Save header and examples…");
        QVERIFY(QFile::exists(stage.test.path("example.c")));
        QVERIFY(stage.window->findChild<MessageStrip*>()->sentence().contains("example.c"));
        QFile::remove(stage.test.path("example.c"));
        stage.click("Save header and examples…"); // the header is there: no overwriting
        QCOMPARE(stage.answers->existing.size(), 3);
        QVERIFY(!QFile::exists(stage.test.path("example.c")));
    }

    void thereIsAtMostOneWindow()
    {
        Stage stage;
        stage.test.action("judge")->trigger();
        QCOMPARE(stage.test.window->findChildren<JudgeWindow*>().size(), 1);
    }
};

} // namespace judge_judge_window_test

TEST_CLASS(judge_judge_window_test::JudgeWindowTest, Widgets)
#include "tests/ui/judge/judge_window_test.moc"
