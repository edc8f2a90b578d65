// SPDX-License-Identifier: GPL-3.0-or-later
// Every hard case against exact arithmetic, and every algorithm on every hard case.
#include "app/comparison/variants.h"
#include "app/hard_cases/case_answer.h"

#include <QFile>
#include <QSet>
#include <QTest>
#include <QUrl>

#include <algorithm>
#include <cmath>

#include "tests/clipping/contract.h"
#include "tests/test_class.h"

namespace hard_cases_hard_cases_test {

using namespace app;
using clipping::Form;
using clipping::Segment;

namespace {

Input inputOf(const HardCase& hard) { return {hard.line, hard.window}; }

bool isProper(const HardCase& hard)
{
    const auto& [s, w] = inputOf(hard);
    for (const auto& p : {s.a, s.b, w.min, w.max})
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
            return false;
    return w.min.x <= w.max.x && w.min.y <= w.max.y;
}

/// By the oracle, which knows of proper input only; of all else nothing is visible.
Truth<2> truthOf(const HardCase& hard)
{
    return isProper(hard) ? ::truthOf(inputOf(hard)) : std::nullopt;
}

/// What a published form or a known misprint does wrong, worked out from the oracle's truth alone.
Ruling ruling(const HardCase& hard, const Variant& variant)
{
    const auto truth = truthOf(hard);
    const auto piece = clipped(variant, hard.line, hard.window);
    const auto& uses = clipping::functionsOf(*variant.algorithm, variant.form);
    if (!piece && !variant.misprint
        && uses->trace(hard.line, hard.window).outcome == clipping::Outcome::DidNotEnd)
        return Ruling::DidNotEnd;
    if (!piece)
        return truth ? Ruling::Lost : Ruling::Right;
    for (const double v : {piece->a.x, piece->a.y, piece->b.x, piece->b.y})
        if (!std::isfinite(v))
            return Ruling::NotANumber;
    if (!truth)
        return Ruling::Shown;
    const auto& w = hard.window;
    for (const auto& p : {piece->a, piece->b})
        if (p.x < w.min.x || p.x > w.max.x || p.y < w.min.y || p.y > w.max.y)
            return Ruling::Outside;
    const double off =
        std::min(ulpsOff(piece, inputOf(hard), truth),
                 ulpsOff(std::optional(Segment{piece->b, piece->a}), inputOf(hard), truth));
    return off > variant.algorithm->ulps ? Ruling::Moved : Ruling::Right;
}

/// Whether hard_cases.json says of this variant what it does wrong. Not of the form of a new row:
/// that is judged in the gallery like all others, and its faults are written down when it is to
/// stay.
bool isListed(const Variant& variant)
{
    return std::ranges::any_of(hardCases(), [&](const HardCase& hard) {
        return std::ranges::any_of(
            hard.faults, [&](const auto& fault) { return fault.first == keyOf(variant); });
    });
}

Ruling listed(const HardCase& hard, const Variant& variant)
{
    for (const auto& [key, fault] : hard.faults)
        if (key == keyOf(variant))
            return fault;
    return Ruling::Right;
}

} // namespace

class HardCasesTest : public QObject {
    Q_OBJECT

private slots:
    void isReadWhole()
    {
        QVERIFY(hardCases().size() >= 40);
        QSet<QString> keys, titles;
        for (const HardCase& hard : hardCases()) {
            keys << hard.key;
            titles << hard.title;
            QCOMPARE(findHardCase(hard.key), &hard);
            QVERIFY2(hard.isOurs() == (hard.origin == QStringLiteral("ours")),
                     qPrintable(hard.key));
            QVERIFY2(hard.isOurs() || QUrl(hard.link).scheme() == QStringLiteral("https"),
                     qPrintable(hard.key));
        }
        QCOMPARE(std::size_t(keys.size()), hardCases().size());
        QCOMPARE(std::size_t(titles.size()), hardCases().size());
        QVERIFY(!findHardCase(QStringLiteral("no such case")));
    }

    void everyCaseAgreesWithTheOracle_data() { eachCase(); }
    void everyCaseAgreesWithTheOracle()
    {
        QFETCH(int, index);
        const HardCase& hard = hardCases()[std::size_t(index)];
        const auto truth = truthOf(hard);
        QCOMPARE(hard.visible.has_value(), truth.has_value());
        if (truth) {
            const auto& [a, b] = truth->line;
            QVERIFY((*hard.visible == Segment{{a.x, a.y}, {b.x, b.y}}));
        }
        // Exact is nothing but exact, all corrected forms keep the contract.
        for (const auto& algorithm : clipping::algorithms()) {
            const auto piece = algorithm.corrected.clip(hard.line, hard.window);
            const CaseAnswer answer = answerOf(hard, {&algorithm, Form::Corrected});
            if (&algorithm == &clipping::exactAlgorithm())
                QVERIFY(piece == hard.visible && answer.ruling == Ruling::Right);
            const std::string wrong = isProper(hard)
                                          ? fault(piece, inputOf(hard), truth, algorithm.ulps)
                                      : piece ? "seen where nothing can be"
                                              : "";
            QVERIFY2(wrong.empty(), (std::string(algorithm.key) + ": " + wrong).c_str());
            QCOMPARE(
                keyOf(answer.ruling),
                keyOf(piece.has_value() == truth.has_value() ? Ruling::Right : Ruling::Allowed));
        }
    }

    // So that a fault of a published form is noticed when it goes, and a new one when it comes.
    void everyPublishedFault_data() { eachCase(); }
    void everyPublishedFault()
    {
        QFETCH(int, index);
        const HardCase& hard = hardCases()[std::size_t(index)];
        std::size_t faults = 0;
        QStringList wrong;
        for (const Variant& variant : variants()) {
            if (variant.form == Form::Corrected)
                continue;
            const CaseAnswer answer = answerOf(hard, variant);
            const QByteArray name = keyOf(variant).toUtf8();
            QVERIFY2(keyOf(answer.ruling) == keyOf(ruling(hard, variant)), name);
            if (!isListed(variant))
                continue;
            if (answer.ruling != listed(hard, variant))
                wrong << QStringLiteral("\"%1\": \"%2\"").arg(name, keyOf(answer.ruling));
            faults += answer.good() ? 0 : 1;
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(QStringLiteral("faults of hard_cases.json: ")
                                             + wrong.join(QStringLiteral(", "))));
        QCOMPARE(faults, hard.faults.size()); // and no fault of what does not exist
    }

    // the gallery is worth a visit: all of these fail somewhere, in every way that there is.
    void everyPublishedFormWithAFaultFailsInSomeCase()
    {
        QSet<QString> failing, ways;
        for (const HardCase& hard : hardCases())
            for (const auto& [key, fault] : hard.faults) {
                failing << key;
                ways << keyOf(fault);
            }
        for (const char* key :
             {"cohen-sutherland:published", "cyrus-beck:published",
              "kodituwakku-wijeweera-chamikara:published", "liang-barsky:published",
              "matthes-drakopoulos:published", "md-step-2", "md-step-2-in-place",
              "midpoint-subdivision:published", "nicholl-lee-nicholl:published", "skala:published",
              "slater-barsky:published", "sobkow-pospisil-yang:published"})
            QVERIFY2(failing.contains(QLatin1StringView(key)), key);
        for (const QString& key : failing) {
            const auto variant = findVariant(key);
            QVERIFY2(variant && variant->form == Form::Published, qPrintable(key));
        }
        QCOMPARE(ways.size(), 6);
    }

    void refusesWhatIsWrong_data()
    {
        QTest::addColumn<QByteArray>("json");
        QTest::addColumn<QString>("says");
        const QByteArray head = R"([{"key": "k", "title": "t", "origin": "ours", "why": "w", )";
        QTest::newRow("no list") << QByteArray("{}") << QStringLiteral("cannot be read");
        QTest::newRow("cut short") << QByteArray("[{") << QStringLiteral("byte");
        QTest::newRow("no title") << QByteArray(R"([{"key": "k"}])") << QStringLiteral("title");
        QTest::newRow("three numbers")
            << head + R"("line": "1 2 3", "window": "0 0 1 1", "visible": null}])"
            << QStringLiteral("line");
        QTest::newRow("no number")
            << head + R"("line": "1 2 3 x", "window": "0 0 1 1", "visible": null}])"
            << QStringLiteral("line");
        QTest::newRow("unknown algorithm")
            << head + R"("line": "1 2 3 4", "window": "0 0 1 1", "visible": null,
                       "faults": {"nobody": "lost"}}])"
            << QStringLiteral("nobody");
        QTest::newRow("unknown fault")
            << head + R"("line": "1 2 3 4", "window": "0 0 1 1", "visible": null,
                       "faults": {"skala:published": "tired"}}])"
            << QStringLiteral("skala:published");
    }
    void refusesWhatIsWrong()
    {
        QFETCH(QByteArray, json);
        QFETCH(QString, says);
        const auto read = readHardCases(json);
        QVERIFY(!read);
        QVERIFY2(read.error.contains(says), qPrintable(read.error));
    }

    void wordsDescribeEachRuling()
    {
        const HardCase& md = *findHardCase(QStringLiteral("far-outside"));
        const CaseAnswer far = answerOf(md, *findVariant(QStringLiteral("MD:published")));
        QCOMPARE(answerText(far), QStringLiteral("shown but not visible"));
        QCOMPARE(far.beyond, 466.0);
        const HardCase& lb = *findHardCase(QStringLiteral("paper-outside"));
        const CaseAnswer out = answerOf(lb, *findVariant(QStringLiteral("LB:published")));
        QVERIFY(answerText(out) == QStringLiteral("outside the window by 1.1e−13"));
        QCOMPARE(pieceText(hardCases().front().visible),
                 QStringLiteral("(1, 1) to (1e−09, 1e−09)"));
        QCOMPARE(pieceText({}), QStringLiteral("nothing"));
    }

private:
    static void eachCase()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < hardCases().size(); ++i)
            QTest::newRow(qPrintable(hardCases()[i].key)) << int(i);
    }
};

} // namespace hard_cases_hard_cases_test

TEST_CLASS(hard_cases_hard_cases_test::HardCasesTest, None)
#include "tests/app/hard_cases/hard_cases_test.moc"
