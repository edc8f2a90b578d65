// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/variants.h"
#include "app/practice/plan.h"
#include "app/practice/record.h"
#include "app/practice/stage.h"
#include "ui/lessons/lesson_panel.h"
#include "ui/lessons/move_input.h"
#include "ui/lessons/practice_page.h"
#include "ui/microscope/answer_discs.h"
#include "ui/microscope/code_view.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/microscope/place_mark.h"

#include <QApplication>
#include <QLabel>
#include <QSet>
#include <QSettings>
#include <QTemporaryDir>

#include "tests/test_class.h"

namespace lessons_practice_page_test {

using namespace ui;
using app::Move, app::MoveKind;

namespace {

/// The microscope's page with the lessons beside it, and an attempt at a variant.
struct Workbench {
    explicit Workbench(const QString& variant = QStringLiteral("cs:published"))
    {
        stage.setSide(new LessonPanel(session.course, session.practice));
        stage.resize(1280, 760);
        stage.show();
        stage.activateWindow();
        if (!QTest::qWaitForWindowActive(&stage))
            QFAIL("the page does not become active");
        practice.setSeed(5);
        practice.begin(*app::findVariant(variant));
        page().focusNext();
        QCoreApplication::processEvents();
    }
    PracticePage& page() const { return *stage.findChild<PracticePage*>(); }
    void press(int key) const { QTest::keyClick(QApplication::focusWidget(), Qt::Key(key)); }
    void type(const QString& text) const { QTest::keyClicks(QApplication::focusWidget(), text); }
    QSet<QString> texts() const
    {
        QSet<QString> all;
        for (const auto* widget : stage.findChildren<QWidget*>()) {
            if (!widget->isVisible())
                continue;
            all << widget->accessibleName() << widget->accessibleDescription() << widget->toolTip();
            if (const auto* label = qobject_cast<const QLabel*>(widget))
                all << label->text();
        }
        return all;
    }
    /// Answers the current move with keys alone.
    void answerByKeys(double answer) const
    {
        const Move& move = *practice.move();
        switch (move.kind) {
        case MoveKind::Bits:
            for (int k = 0; k < move.bits.size(); ++k)
                if (unsigned(answer) >> (move.bits.size() - 1 - k) & 1U)
                    press(Qt::Key_1 + k);
            return press(Qt::Key_Return);
        case MoveKind::Edge:
            return press(Qt::Key_0 + int(answer));
        case MoveKind::Decide:
            return press(Qt::Key_1 + int(answer));
        case MoveKind::Place:
            while (*practice.draft() > answer + move.within / 2)
                press(Qt::Key_Left);
            while (*practice.draft() < answer - move.within / 2)
                press(Qt::Key_Right);
            return press(Qt::Key_Return);
        case MoveKind::Line:
        case MoveKind::Value:
            type(QString::number(answer, 'g', 12));
            return press(Qt::Key_Return);
        }
    }

    app::Session session;
    app::DrawnLine drawn{session};
    MicroscopePage stage{session, drawn};
    app::Practice& practice = session.practice;
    app::Microscope& microscope = session.microscope;
};

} // namespace

class PracticePageTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
        QCoreApplication::setOrganizationName(QStringLiteral("Clearcut"));
    }
    void everyVariantIsPlayedByKeys()
    {
        for (const app::Variant& variant : app::practiceVariants()) {
            Workbench bench(app::keyOf(variant));
            for (int k = 0; k < 60 && !bench.practice.atEnd(); ++k) {
                const std::size_t index = bench.practice.index();
                const QByteArray what = bench.practice.move()->prompt.toUtf8();
                bench.answerByKeys(bench.practice.move()->right);
                QVERIFY2(!bench.practice.isOpen(), what);
                QVERIFY2(bench.practice.answerTo(index).rightAtOnce(), what);
                bench.press(Qt::Key_Return); // goes on
                QVERIFY2(bench.practice.index() == index + 1, what);
            }
            QVERIFY(bench.practice.isPassed());
            QCOMPARE(app::recordOf(QSettings(), variant), (app::PracticeRecord{100, true}));
        }
    }
    /// While a move is open, no text in the window, for users or screen readers, is of a later
    /// step.
    void noTextSaysWhatComes()
    {
        for (const char* variant : {"cs:published", "lb", "nln", "skala:published", "md"}) {
            Workbench bench{QString::fromLatin1(variant)};
            const app::Narration all =
                app::narrationOf(bench.practice.tracedLine(), app::Sentences::Plain);
            for (; !bench.practice.atEnd(); bench.practice.next()) {
                const std::size_t open = bench.practice.move()->step;
                QSet<QString> shown;
                for (std::size_t k = 0; k < open; ++k)
                    shown << all.steps[k].sentence;
                const QSet<QString> texts = bench.texts();
                QVERIFY(open == 0 || texts.contains(all.steps[open - 1].sentence));
                for (std::size_t k = open; k < all.steps.size(); ++k)
                    QVERIFY2(shown.contains(all.steps[k].sentence)
                                 || !texts.contains(all.steps[k].sentence),
                             qPrintable(all.steps[k].sentence));
                bench.practice.answer(bench.practice.move()->right);
            }
        }
    }
    void aWrongAnswerGetsItsHintAndASecondTry()
    {
        Workbench bench;
        const Move& move = *bench.practice.move();
        QCOMPARE(move.kind, MoveKind::Bits);
        const app::Mistake& mistake = move.mistakes.front();
        bench.answerByKeys(mistake.answer);
        QVERIFY(bench.practice.isOpen());
        QVERIFY(bench.practice.verdict().contains(mistake.hint));
        QVERIFY(bench.microscope.isCovered());
        bench.practice.answer(move.right);
        QVERIFY(!bench.practice.isOpen() && bench.practice.rightAtOnce() == 0);
    }
    void theFigureAnswers()
    {
        Workbench bench;
        bool picked = false, placed = false;
        while (!bench.practice.atEnd()) {
            const Move& move = *bench.practice.move();
            if (move.kind == MoveKind::Edge) {
                const auto& answers = bench.stage.findChild<AnswerDiscs*>()->answers();
                QCOMPARE(answers.size(), 4U);
                QTest::mouseClick(&bench.stage.view(), Qt::LeftButton, {},
                                  answers[std::size_t(move.right) - 1].disc.toPoint());
                picked = bench.practice.answerTo(bench.practice.index()).rightAtOnce();
                QVERIFY(picked);
            } else if (move.kind == MoveKind::Place) {
                const auto& [a, b] = bench.practice.tracedLine().line;
                const QPointF at = bench.stage.view().frame().at(a + move.right * (b - a));
                QTest::mouseClick(&bench.stage.view(), Qt::LeftButton, {}, at.toPoint());
                QVERIFY(app::isRight(move, *bench.practice.draft()));
                QVERIFY(bench.stage.findChild<PlaceMark*>()->isVisible());
                bench.practice.check();
                placed = bench.practice.answerTo(bench.practice.index()).rightAtOnce();
                QVERIFY(placed);
            } else {
                bench.practice.answer(move.right);
            }
            bench.practice.next();
        }
        QVERIFY(picked && placed);
    }
    /// The lines between the moves are lit, the line that is asked for is not.
    void theCodeShowsWhatIsRunNow()
    {
        Workbench bench(QStringLiteral("lb:published"));
        while (bench.practice.move()->kind != MoveKind::Line) {
            bench.practice.answer(bench.practice.move()->right);
            bench.practice.next();
        }
        const Move& move = *bench.practice.move();
        QCOMPARE(bench.stage.code().currentLine(), move.line);
        bench.practice.answer(5000);
        QVERIFY(bench.practice.isOpen() && !bench.practice.verdict().isEmpty());
        QVERIFY(bench.practice.answerTo(bench.practice.index()).tries.empty());
    }
    void dragsAndOtherLinesDoNotUncover()
    {
        Workbench bench;
        app::TracedLine other = bench.practice.tracedLine();
        other.line.a.x += 1;
        bench.microscope.open(other, 100);
        QVERIFY(bench.microscope.isCovered());
        QCOMPARE(bench.microscope.tracedLine(), bench.practice.tracedLine());
        bench.microscope.open(bench.practice.tracedLine(), 100);
        QVERIFY(bench.microscope.isCovered());
    }
    void theListKeepsTheAttempt()
    {
        Workbench bench;
        emit bench.page().listWanted();
        QVERIFY(bench.practice.isPaused() && bench.microscope.isCovered());
        bench.practice.goOn();
        QVERIFY(bench.practice.asks());
        bench.session.course.begin(0);
        QVERIFY(!bench.practice.isOn() && bench.session.course.lesson());
        bench.practice.begin(*app::findVariant(QStringLiteral("md")));
        QVERIFY(!bench.session.course.lesson() && bench.practice.asks());
        bench.practice.end(); // what would show the answer is closed
        QVERIFY(!bench.practice.isOn() && !bench.microscope.isOpen());
    }
    void theEndSaysWhereItWentWrong()
    {
        Workbench bench;
        bench.practice.answer(bench.practice.move()->mistakes.front().answer);
        while (!bench.practice.atEnd()) {
            bench.practice.answer(bench.practice.move()->right);
            bench.practice.next();
        }
        QCOMPARE(bench.practice.wrongMoves(), std::vector<std::size_t>{0});
        const QString correction = bench.practice.correction(0);
        const auto labels = bench.page().findChildren<QLabel*>();
        QVERIFY(std::ranges::any_of(labels, [&](const QLabel* label) {
            return label->isVisible() && label->text() == correction;
        }));
        QVERIFY(!bench.microscope.isCovered());
        const auto buttons = bench.page().findChildren<QPushButton*>();
        auto* look = *std::ranges::find(buttons, QStringLiteral("Show this step in the microscope"),
                                        &QPushButton::toolTip);
        look->setFocus();
        bench.press(Qt::Key_Return);
        QCOMPARE(bench.microscope.step(), bench.practice.moves()[0].step);
        QVERIFY(look->hasFocus()); // the next one is one Tab away
    }

private:
    QTemporaryDir folder_;
};

} // namespace lessons_practice_page_test

TEST_CLASS(lessons_practice_page_test::PracticePageTest, Widgets)
#include "tests/ui/lessons/practice_page_test.moc"
