// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/course.h"
#include "ui/microscope/code_view.h"
#include "ui/microscope/microscope_page.h"
#include "ui/microscope/microscope_view.h"
#include "ui/microscope/operations_view.h"
#include "ui/microscope/timeline.h"
#include "ui/microscope/variable_table.h"

#include <QRegularExpression>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace lessons_covered_test {

namespace {

/// The microscope's page on the screen, with a course beside it.
struct Stage {
    Stage()
    {
        session.course.setSeed(0); // as the files have it
        page.resize(1300, 800);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
    }
    template <class Widget>
    const Widget* part() const
    {
        return page.findChild<Widget*>();
    }

    /// Every text on the page, for users and screen readers.
    QStringList texts() const
    {
        QStringList all;
        for (const auto* widget : page.findChildren<QWidget*>()) {
            if (!widget->isVisible())
                continue;
            all << widget->accessibleName() << widget->accessibleDescription() << widget->toolTip();
            if (const auto* label = qobject_cast<const QLabel*>(widget))
                all << label->text();
        }
        const QAbstractItemModel* model = part<ui::VariableTable>()->model();
        for (int row = 0; row < model->rowCount(); ++row)
            for (int column = 0; column < model->columnCount(); ++column)
                all << model->index(row, column).data().toString();
        return all;
    }
    /// The part of the page that must not depend on the steps: all but the line itself.
    std::vector<QImage> pictures()
    {
        return {page.steps().grab().toImage(), page.variables().grab().toImage(),
                page.code().grab().toImage(),
                page.findChild<ui::OperationsView*>()->grab().toImage()};
    }

    app::Session session;
    app::DrawnLine drawn{session};
    ui::MicroscopePage page{session, drawn};
};

app::TracedLine tracedLine(const clipping::Segment& line)
{
    return {{clipping::findAlgorithm("cohen-sutherland")},
            line,
            {{-100, -75}, {100, 75}},
            app::YAxis::Up,
            QStringLiteral("Outcodes")};
}

const clipping::Segment whole{{-60, -40}, {70, 50}}, cut{{-160, -30}, {70, 130}},
    passing{{-170, 40}, {-20, 150}};

/// "of 20", how many steps there are; not "of 2019".
QRegularExpression countOf(const app::Narration& narration)
{
    return QRegularExpression(QStringLiteral("of %1\\b").arg(narration.steps.size()));
}

} // namespace

/// While a question is open, nothing on the screen gives the answer away.
class CoveredTest : public QObject {
    Q_OBJECT

private slots:
    void noTextGivesTheAnswerAway()
    {
        Stage stage;
        app::Course& course = stage.session.course;
        int asked = 0;
        for (std::size_t i = 0; i < app::lessons().size(); ++i)
            for (course.begin(i);; course.next()) {
                if (const auto question = course.question()) {
                    ++asked;
                    const app::Narration all =
                        app::narrationOf(stage.session.microscope.tracedLine());
                    const QStringList texts = stage.texts();
                    const QString where = course.lesson()->key + QString::number(course.page() + 1);
                    const std::size_t shown = stage.session.microscope.narration().steps.size();
                    for (std::size_t k = shown; k < all.steps.size(); ++k)
                        QVERIFY2(!texts.contains(all.steps[k].sentence), qPrintable(where));
                    const QString right = question->choices[question->right];
                    for (const QString& text : texts) {
                        QVERIFY2(!text.contains(right), qPrintable(where + ": " + text));
                        QVERIFY2(!text.contains(countOf(all)), qPrintable(where + ": " + text));
                    }
                    course.showAnswer();
                    QVERIFY(stage.texts().contains(
                        stage.session.microscope.narrated()->sentence)); // the test can see it
                }
                if (course.atLastPage())
                    break;
            }
        QVERIFY(asked > 15);
    }
    void thePictureIsTheSameWhateverTheAnswer()
    {
        Stage stage;
        app::Microscope& microscope = stage.session.microscope;
        microscope.openCovered(tracedLine(cut), 0);
        const auto first = stage.pictures();
        for (const auto& line : {whole, passing}) {
            microscope.openCovered(tracedLine(line), 0);
            const auto pictures = stage.pictures();
            for (std::size_t i = 0; i < pictures.size(); ++i)
                QVERIFY2(pictures[i] == first[i], qPrintable(QString::number(i)));
        }
        microscope.open(tracedLine(cut));
        const auto open = stage.pictures();
        for (std::size_t i = 0; i < open.size(); ++i)
            QVERIFY2(open[i] != first[i], qPrintable(QString::number(i)));
    }
    /// The given line, without any mark of its result.
    void theFigureShowsTheGivenLine()
    {
        Stage stage;
        app::Microscope& microscope = stage.session.microscope;
        app::TracedLine other = tracedLine(cut);
        other.variant = {clipping::findAlgorithm("liang-barsky")};
        microscope.openCovered(tracedLine(cut), 0);
        const QImage one = stage.page.view().grab().toImage();
        microscope.openCovered(other, 0);
        QCOMPARE(stage.page.view().grab().toImage(), one);
        microscope.open(tracedLine(cut), 1000);
        QVERIFY(stage.page.view().grab().toImage() != one);
    }
    void keysAndPlayingStopAtTheCoveredSteps()
    {
        Stage stage;
        app::Microscope& microscope = stage.session.microscope;
        microscope.openCovered(tracedLine(cut), 1);
        for (const Qt::Key key : {Qt::Key_End, Qt::Key_Right, Qt::Key_Space, Qt::Key_Right}) {
            QTest::keyClick(&stage.page.view(), key);
            QCOMPARE(microscope.step(), 0U);
        }
        QVERIFY(!stage.texts().join(u' ').contains(QStringLiteral("of 16")));
    }
};

} // namespace lessons_covered_test

TEST_CLASS(lessons_covered_test::CoveredTest, Widgets)
#include "tests/ui/lessons/covered_test.moc"
