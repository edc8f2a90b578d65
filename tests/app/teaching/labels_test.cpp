// SPDX-License-Identifier: GPL-3.0-or-later
// The labels by which sentences and steps name the lines of a pseudo-code.
#include "app/base/text.h"
#include "app/teaching/teaching.h"
#include "clipping/pseudo_code.h"

#include <QFile>
#include <QRegularExpression>
#include <QSet>

#include <array>

#include "tests/clipping/inputs.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"

namespace teaching_labels_test {

using clipping::Form;

namespace {

QSet<QString> labelsOf(std::string_view code)
{
    QSet<QString> labels;
    for (const clipping::CodeLine& line : clipping::linesOf(code))
        for (const QString& label : app::latin(line.labels).split(u' ', Qt::SkipEmptyParts))
            labels << label;
    return labels;
}

/// The labels that a source file of sentences asks for.
QSet<QString> askedIn(const QString& path)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    const QString text = QString::fromUtf8(file.readAll());
    static const QRegularExpression call(QStringLiteral("\\bat\\(([^()]*)\\)|Test\\{(\"\\w+\")"));
    static const QRegularExpression label(QStringLiteral("\"(\\w+)\""));
    QSet<QString> labels;
    for (auto at = call.globalMatch(text); at.hasNext();) {
        const auto match = at.next();
        for (auto one = label.globalMatch(match.captured(1) + match.captured(2)); one.hasNext();)
            labels << one.next().captured(1);
    }
    return labels;
}

/// All lines between the points of a small grid that reaches beyond the window, 4 wide, on all
/// sides.
std::vector<Input> onGrid()
{
    constexpr std::array at{-3.0, -2.0, 0.5, 2.0, 3.0};
    std::vector<Input> all;
    for (const double x1 : at)
        for (const double y1 : at)
            for (const double x2 : at)
                for (const double y2 : at)
                    all.push_back({{{x1, y1}, {x2, y2}}, {{-2, -2}, {2, 2}}});
    return all;
}

/// The labels that the steps of a form name, on this grid and on the first lines of every family.
QSet<QString> namedBy(const clipping::Algorithm& algorithm, Form form)
{
    constexpr std::size_t most = 60; // of a family
    std::vector<Input> inputs = onGrid();
    for (const Family& family : families())
        inputs.insert(inputs.end(), family.inputs().begin(),
                      family.inputs().begin() + std::min(most, family.inputs().size()));
    QSet<QString> labels;
    for (const auto& [segment, window] : inputs)
        for (const auto& step :
             clipping::functionsOf(algorithm, form)->trace(segment, window).steps)
            labels << app::latin(step.label);
    return labels;
}

QByteArray sorted(const QSet<QString>& labels)
{
    QStringList all(labels.begin(), labels.end());
    all.sort();
    return all.join(u' ').toUtf8();
}

} // namespace

class LabelsTest : public QObject {
    Q_OBJECT

private slots:
    void linesAndLabels()
    {
        constexpr std::string_view code = "if a  #one two\n  b,  c\n\nd  #three\n";
        const auto lines = clipping::linesOf(code);
        QCOMPARE(lines.size(), 4U);
        QCOMPARE(lines[0].text, std::string_view("if a"));
        QCOMPARE(lines[1].text, std::string_view("  b,  c"));
        QVERIFY(lines[2].text.empty() && lines[1].labels.empty());
        QCOMPARE(clipping::lineOf(lines, "one"), 1);
        QCOMPARE(clipping::lineOf(lines, "two"), 1);
        QCOMPARE(clipping::lineOf(lines, "three"), 4);
        for (const auto* none : {"", "on", "one two", "four", "wo"})
            QCOMPARE(clipping::lineOf(lines, none), 0);
        QVERIFY(clipping::linesOf("").empty());
    }

    /// A sentence that asks for a label which no line has would never be said.
    void sentencesAskForLabelsThatExist()
    {
        int asked = 0;
        for (const app::Teaching& teaching : notEmpty(app::teachings())) {
            const auto& row = *clipping::findAlgorithm(teaching.key);
            const auto known = labelsOf(row.correctedCode) + labelsOf(row.publishedCode);
            const QString file = app::latin(row.key).replace(u'-', u'_');
            const auto labels =
                askedIn(QStringLiteral(SOURCE_DIR "/app/teaching/sentences/%1.cpp").arg(file));
            asked += int(labels.size());
            QVERIFY2(known.contains(labels), sorted(labels - known).prepend(teaching.key.data()));
        }
        QVERIFY(asked > 100);
    }

    void sharedSentencesAskForLabelsThatExist()
    {
        QSet<QString> known;
        for (const char* key : {"liang-barsky", "cyrus-beck"}) {
            const auto& row = *clipping::findAlgorithm(key);
            known += labelsOf(row.correctedCode) + labelsOf(row.publishedCode);
        }
        const auto labels = askedIn(QStringLiteral(SOURCE_DIR "/app/teaching/sentences/part.cpp"));
        QVERIFY(labels.size() > 10);
        QVERIFY2(known.contains(labels), sorted(labels - known));
    }

    /// No label is left over: a step names each. Two lines are reached by rounding alone, with
    /// numbers that their algorithms' own tests choose.
    void stepsNameEveryLabel()
    {
        for (const clipping::Algorithm& row : clipping::algorithms())
            for (const Form form : {Form::Published, Form::Corrected}) {
                if (!clipping::functionsOf(row, form))
                    continue;
                const auto known = labelsOf(clipping::codeOf(row, form));
                auto missed = known - namedBy(row, form);
                missed -= {QStringLiteral("giveUp"), QStringLiteral("rejectNear")};
                QVERIFY2(missed.isEmpty(), sorted(missed).prepend(row.key.data()));
            }
    }
};

} // namespace teaching_labels_test

TEST_CLASS(teaching_labels_test::LabelsTest, None)
#include "tests/app/teaching/labels_test.moc"
