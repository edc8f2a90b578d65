// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/step_variables.h"

#include <QTest>

#include <algorithm>

#include "tests/test_class.h"

namespace teaching_step_variables_test {

using namespace app;

namespace {

TracedLine crossingLine(std::string_view key)
{
    return {.variant = {clipping::findAlgorithm(key)},
            .line = {{41.2, 117.5}, {63.8, 104.1}},
            .window = {{48.5, 73.5}, {248.5, 223.5}}};
}

QStringList namesAt(const TracedLine& traced, const QString& code)
{
    const Narration narration = narrationOf(traced);
    QStringList names;
    for (std::size_t i = 0; i < narration.steps.size(); ++i)
        if (narration.code.value(narration.steps[i].line - 1).trimmed() == code) {
            for (const Variable& variable : stepVariables(traced, narration, i))
                names << variable.name + (variable.changed() ? u'*' : u' ');
            return names;
        }
    return {QStringLiteral("no such step")};
}

} // namespace

class StepVariablesTest : public QObject {
    Q_OBJECT

private slots:
    void whatAStepReadsAndWrites()
    {
        const TracedLine traced = crossingLine("cohen-sutherland");
        QCOMPARE(namesAt(traced, "rise = (y2-y1) * (xmin-xi) / (x2-x1)"),
                 (QStringList{"rise*", "y2 ", "y1 ", "xmin ", "xi ", "x2 "}));
        QCOMPARE(namesAt(traced, "if code[1] & code[2] != 0000"),
                 (QStringList{"code[1] ", "code[2] "}));
    }
    void everyStepOfEveryAlgorithm()
    {
        for (const auto& algorithm : clipping::algorithms()) {
            const TracedLine traced = crossingLine(algorithm.key);
            const Narration narration = narrationOf(traced);
            for (std::size_t i = 0; i < narration.steps.size(); ++i) {
                const auto shown = stepVariables(traced, narration, i);
                const auto& all = narration.steps[i].variables;
                QVERIFY(shown.size() <= 6);
                QVERIFY(std::ranges::is_partitioned(shown, &Variable::changed));
                QCOMPARE(std::size_t(std::ranges::count_if(shown, &Variable::changed)),
                         std::min<std::size_t>(
                             6, std::size_t(std::ranges::count_if(all, &Variable::changed))));
                const auto every = allVariables(traced, narration, i);
                for (const Variable& one : shown) {
                    QCOMPARE(std::ranges::count(shown, one.name, &Variable::name), 1);
                    QCOMPARE(std::ranges::count(every, one.name, &Variable::name), 1);
                }
                for (const char* given : {"x1", "y2", "xmin", "ymax"})
                    QCOMPARE(std::ranges::count(every, QString(given), &Variable::name), 1);
            }
            QVERIFY(stepVariables(traced, narration, narration.steps.size()).empty());
        }
    }
};

} // namespace teaching_step_variables_test

TEST_CLASS(teaching_step_variables_test::StepVariablesTest, Core)
#include "tests/app/teaching/step_variables_test.moc"
