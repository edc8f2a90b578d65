// SPDX-License-Identifier: GPL-3.0-or-later
// The pseudo-code of a form is what runs: at every step of 10,000 lines the formulas of the lit
// line, evaluated with the variables shown, give the numbers shown, and the step costs the
// operations that they show. So it is with the known misprints. Every formula is altered in every
// way that `alterationsOf` knows, and each of these faults is found.
#include "app/comparison/misprints/misprint.h"
#include "clipping/algorithm.h"
#include "clipping/frame.h"

#include <QTest>

#include "tests/app/teaching/formulas/alterations.h"
#include "tests/app/teaching/formulas/checker.h"
#include "tests/app/teaching/formulas/exceptions.h"
#include "tests/app/teaching/formulas/lines.h"
#include "tests/test_class.h"

namespace teaching_formulas_test {

using namespace clipping;
namespace formulas = app::formulas;
using formulas::comparesLess, formulas::notEvaluated, formulas::notObservable;

namespace {

constexpr int mostLines = 61;                 ///< of a code
constexpr std::size_t fewestAlterations = 10; ///< of a code, so that there are 20 from one row on

/// A form that has pseudo-code.
struct Told {
    const Algorithm* algorithm;
    Form form;
};
std::string nameOf(const Told& told)
{
    for (const app::Misprint& misprint : app::misprints())
        if (told.algorithm == &misprint.row)
            return misprint.key.toStdString();
    return std::string(told.algorithm->key)
           + (told.form == Form::Published ? ":published" : ":corrected");
}
std::vector<Told> allTold()
{
    std::vector<Told> all;
    for (const Algorithm& algorithm : algorithms())
        for (const Form form : {Form::Published, Form::Corrected})
            if (functionsOf(algorithm, form) && !codeOf(algorithm, form).empty())
                all.push_back({&algorithm, form});
    for (const app::Misprint& misprint : app::misprints())
        all.push_back({&misprint.row, Form::Published});
    return all;
}

const std::vector<formulas::Input>& inputs()
{
    static const auto all = formulas::inputs();
    return all;
}

/// The first fault on all lines.
std::optional<std::string> faultOf(const Told& told, formulas::Checker& checker)
{
    const auto* uses = functionsOf(*told.algorithm, told.form);
    for (const auto& [segment, window] : inputs()) {
        const Trace trace = uses->trace(segment, window);
        const auto cost = uses->count({&segment, 1}, window);
        if (const auto fault = checker.check(segment, window, trace, cost))
            return nameOf(told) + ", " + text(*fault);
    }
    return std::nullopt;
}

std::string_view withoutIndentation(std::string_view line)
{
    return line.substr(std::min(line.find_first_not_of(' '), line.size()));
}

bool isExcepted(const Told& told, const std::string& line)
{
    return std::ranges::any_of(notEvaluated, [&](const formulas::NotEvaluated& e) {
        return e.key == told.algorithm->key && e.form == told.form
               && e.line == withoutIndentation(line);
    });
}

/// Reads the pseudo-code of a form, or an altered one. A line that may show more comparisons than a
/// run needs is marked.
formulas::Code codeRead(const Told& told, std::string_view text)
{
    formulas::Code code = formulas::read(text);
    const formulas::Code original = formulas::read(codeOf(*told.algorithm, told.form));
    code.labels = original.labels;
    for (std::size_t k = 0; k < code.lines.size(); ++k)
        code.lines[k].comparesLess = std::ranges::any_of(comparesLess, [&](const auto& e) {
            return e.key == told.algorithm->key && e.form == told.form
                   && e.line == withoutIndentation(original.lines[k].text);
        });
    return code;
}

bool isExcepted(const Told& told, const formulas::Altered& altered)
{
    return std::ranges::any_of(notObservable, [&](const formulas::NotObservable& e) {
        return e.key == told.algorithm->key && e.form == told.form && e.line == altered.line
               && e.change == altered.change;
    });
}

} // namespace

class FormulasTest : public QObject {
    Q_OBJECT

private slots:
    void everyFormHasPseudoCode()
    {
        for (const Algorithm& algorithm : algorithms())
            for (const Form form : {Form::Published, Form::Corrected})
                QVERIFY2(!functionsOf(algorithm, form) || !codeOf(algorithm, form).empty(),
                         qPrintable(QStringLiteral("%1 has no pseudo-code in one of its forms")
                                        .arg(algorithm.key.data())));
    }

    void ordinaryLines()
    {
        QCOMPARE(inputs().size(), 10'000U);
        for (const auto& [segment, window] : inputs())
            QVERIFY(legal(segment) && legal(window) && ordinary(segment) && ordinary(window));
    }

    void layout_data() { everyCode(); }
    void layout()
    {
        const std::string code = formulas::withoutLabels(codeOf(*algorithm(), form()));
        QVERIFY(
            std::ranges::all_of(code, [](char c) { return c == '\n' || (c >= 32 && c < 127); }));
        const auto lines = QString::fromStdString(code).split('\n');
        const auto exception =
            std::ranges::find(formulas::longer, algorithm()->key, &formulas::Long::key);
        const int most = exception == formulas::longer.end() ? mostLines : exception->lines;
        QVERIFY(lines.size() <= most + 1); // it ends with a line feed
        for (const QString& line : lines)
            QVERIFY2(line.size() <= 72 && !line.endsWith(' '), qPrintable(line));
    }

    void formulasGiveTheValuesInTheTrace_data() { everyCode(); }
    void formulasGiveTheValuesInTheTrace()
    {
        const Told told{algorithm(), form()};
        std::optional<formulas::Code> code;
        try {
            code = codeRead(told, codeOf(*told.algorithm, told.form));
        } catch (const formulas::Unreadable& e) {
            QFAIL(e.what());
        }
        formulas::Checker checker(*code);
        if (const auto fault = faultOf(told, checker))
            QFAIL(fault->c_str());
        std::set<std::string> missed;
        for (const formulas::Place& place : checker.notEvaluated())
            missed.insert(code->lines[place.line - 1].text);
        for (const std::string& line : missed)
            QVERIFY2(isExcepted(told, line), ("never evaluated: " + line).c_str());
        for (const formulas::NotEvaluated& e : notEvaluated)
            if (e.key == told.algorithm->key && e.form == told.form)
                QVERIFY2(
                    std::ranges::any_of(
                        missed, [&](auto& line) { return withoutIndentation(line) == e.line; }),
                    ("an exception that is not needed: " + std::string(e.line)).c_str());
        for (std::size_t k = 0; k < code->lines.size(); ++k)
            QVERIFY2(!code->lines[k].comparesLess || checker.comparedLess(k),
                     ("an exception that is not needed: " + code->lines[k].text).c_str());
    }

    /// The rows of the paper show their students what they count.
    void noRowOfThePaperComparesLessThanItShows()
    {
        for (const formulas::ComparesLess& e : comparesLess) {
            const Algorithm* row = findAlgorithm(e.key);
            QVERIFY(row && !codeOf(*row, e.form).empty());
            for (const char* key : {"CS", "LB", "CB", "NLN", "Skala", "KWC", "MD"})
                QVERIFY(row != findAlgorithm(key));
        }
    }

    void alteredFormulasAreReported_data() { everyCode(); }
    void alteredFormulasAreReported()
    {
        const Told told{algorithm(), form()};
        const auto alterations =
            formulas::alterationsOf(formulas::withoutLabels(codeOf(*told.algorithm, told.form)));
        QVERIFY(alterations.size() >= fewestAlterations);
        QStringList wrong;
        long excepted = 0;
        for (const formulas::Altered& altered : alterations) {
            excepted += isExcepted(told, altered);
            const formulas::Code code = codeRead(told, altered.code);
            formulas::Checker checker(code);
            const bool isFound = faultOf(told, checker).has_value();
            if (isFound == isExcepted(told, altered))
                wrong += QString(isFound ? "found, so not to be excepted: \"%1\", %2"
                                         : "not found: \"%1\", %2")
                             .arg(altered.line.c_str(), altered.change.c_str());
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(QString("of %1 alterations\n").arg(alterations.size())
                                             + wrong.join('\n')));
        QCOMPARE(excepted, std::ranges::count_if(notObservable, [&](const auto& e) {
                     return e.key == told.algorithm->key && e.form == told.form;
                 }));
    }

private:
    static void everyCode()
    {
        QTest::addColumn<const Algorithm*>("algorithm");
        QTest::addColumn<int>("form");
        for (const Told& told : allTold())
            QTest::newRow(nameOf(told).c_str()) << told.algorithm << int(told.form);
    }
    static const Algorithm* algorithm()
    {
        return *static_cast<const Algorithm**>(
            QTest::qData("algorithm", qMetaTypeId<const Algorithm*>()));
    }
    static Form form() { return Form(*static_cast<int*>(QTest::qData("form", QMetaType::Int))); }
};

} // namespace teaching_formulas_test

TEST_CLASS(teaching_formulas_test::FormulasTest, Core)
#include "tests/app/teaching/formulas_test.moc"
