// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/category.h"
#include "app/judge/judgement.h"
#include "clipping/algorithm.h"

#include <QTest>

#include <limits>
#include <set>

#include "tests/clipping/oracle.h"
#include "tests/test_class.h"

namespace judge_judgement_test {

using namespace app::plug_in;
using clipping::Segment;

namespace {

Answer answer(const std::optional<Segment>& piece)
{
    if (!piece)
        return {{}, 0, 0};
    return {{piece->a.x, piece->a.y, piece->b.x, piece->b.y}, 1, 0};
}

constexpr Question across{{{-10, 0}, {10, 0}}, {{-1, -1}, {1, 1}}};

Judgement ofAcross(const Segment& piece, const Contract& contract = {})
{
    return judged(across, answer(piece), contract, 64);
}

} // namespace

class JudgementTest : public QObject {
    Q_OBJECT

private slots:
    /// Every row keeps a stricter contract than any library is held to.
    void everyRowPasses()
    {
        for (const Strictness strictness : {Strictness::Textbook, Strictness::Clearcuts})
            for (const Category& category : categories())
                for (const Question& q : category.questions({7, strictness}))
                    for (const auto& row : clipping::algorithms()) {
                        const auto found = judged(q, answer(row.corrected.clip(q.line, q.window)),
                                                  {64, strictness}, category.visibilityUlps);
                        if (found.fault)
                            QFAIL(qPrintable(QStringLiteral("%1, %2: %3 (%4,%5)-(%6,%7)")
                                                 .arg(QLatin1StringView(row.key), category.key,
                                                      infoOf(*found.fault).key)
                                                 .arg(q.line.a.x, 0, 'g', 17)
                                                 .arg(q.line.a.y, 0, 'g', 17)
                                                 .arg(q.line.b.x, 0, 'g', 17)
                                                 .arg(q.line.b.y, 0, 'g', 17)));
                    }
    }

    /// Whatever the seed; the oracle shares no code with `exact`.
    void categoriesHoldWhatTheySay()
    {
        for (const Category& category : categories()) {
            std::size_t visible = 0;
            const auto all = category.questions({.seed = 3});
            for (const Question& q : all)
                visible += expected(q).has_value();
            QVERIFY2(all.size() >= 80, qPrintable(category.key));
            if (category.key == u"nonsense")
                QCOMPARE(visible, 0u);
            else
                QVERIFY2(visible > 10 && (visible < all.size() || category.key == u"corners"),
                         qPrintable(category.key));
            if (category.visibilityUlps == 0)
                for (const Question& q : all) {
                    const oracle::Line line{{q.line.a.x, q.line.a.y}, {q.line.b.x, q.line.b.y}};
                    const oracle::Box box{{q.window.min.x, q.window.min.y},
                                          {q.window.max.x, q.window.max.y}};
                    QCOMPARE(expected(q).has_value(), oracle::inside(line, box).has_value());
                }
        }
    }

    void allRegionPairsAreThere()
    {
        std::set<std::array<bool, 8>> pairs;
        for (const Question& q : categories().front().questions({})) {
            const auto& [l, w] = q;
            pairs.insert({l.a.x<w.min.x, l.a.x> w.max.x, l.a.y<w.min.y, l.a.y> w.max.y,
                          l.b.x<w.min.x, l.b.x> w.max.x, l.b.y<w.min.y, l.b.y> w.max.y});
        }
        QCOMPARE(pairs.size(), 81u);
    }

    void everyFaultIsNamed()
    {
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        QVERIFY(!ofAcross({{-1, 0}, {1, 0}}).fault);
        QCOMPARE(judged(across, answer({}), {}, 64).fault, Fault::Lost);
        QCOMPARE(ofAcross({{1, 0}, {-1, 0}}).fault, Fault::Turned);
        QCOMPARE(ofAcross({{-1, 0}, {2, 0}}).fault, Fault::Outside);
        QCOMPARE(ofAcross({{-1, 0}, {0.5, 0}}).fault, Fault::Off);
        QCOMPARE(ofAcross({{-1, 0}, {nan, 0}}).fault, Fault::NotANumber);
        QCOMPARE(judged(across, {{-1, 0, 1, 0}, 1, 1}, {}, 64).fault, Fault::WroteBeyond);
        const Question away{{{-10, 5}, {10, 5}}, across.window};
        QCOMPARE(judged(away, answer(Segment{{-1, 1}, {1, 1}}), {}, 64).fault, Fault::Invented);
        const Question none{{{-10, nan}, {10, 0}}, across.window};
        QCOMPARE(judged(none, answer(Segment{{-1, 0}, {1, 0}}), {}, 64).fault, Fault::Nonsense);
        const Question insideOut{across.line, {across.window.max, across.window.min}};
        QCOMPARE(judged(insideOut, answer(Segment{{0, 0}, {0, 0}}), {}, 64).fault, Fault::Nonsense);
        for (const FaultInfo& info : faults())
            QCOMPARE(infoOf(info.fault).key, info.key);
    }

    /// An ulp here is that of 10: 2^-49.
    void someUlpsAreRounding()
    {
        constexpr double ulp = 0x1p-49;
        const Segment outside{{-1, 0}, {1 + 2 * ulp, 0}};
        QVERIFY(!ofAcross(outside).fault);
        QCOMPARE(ofAcross(outside).outside, 2.0);
        QCOMPARE(ofAcross(outside).off, 2.0);
        QCOMPARE(ofAcross(outside, {64, Strictness::Clearcuts}).fault, Fault::Outside);
        QVERIFY(!ofAcross({{-1, 0}, {1 - 64 * ulp, 0}}).fault);
        QCOMPARE(ofAcross({{-1, 0}, {1 - 65 * ulp, 0}}).fault, Fault::Off);
        const Question within{{{-0.5, 0}, {10, 0}}, across.window};
        const auto moved = answer(Segment{{-0.5 + ulp, 0}, {1, 0}});
        QVERIFY(!judged(within, moved, {}, 64).fault);
        QCOMPARE(judged(within, moved, {64, Strictness::Clearcuts}, 64).fault, Fault::Off);
    }

    void visibilityMayBeWrongOnlyNearAnEdge()
    {
        const Question touching{{{-10, 1}, {10, 1}}, across.window};
        QVERIFY(!judged(touching, answer({}), {}, 64).fault);
        QCOMPARE(judged(touching, answer({}), {}, 0).fault, Fault::Lost);
        const Question over{{{-10, 1 + 0x1p-48}, {10, 1 + 0x1p-48}}, across.window};
        QVERIFY(!judged(over, answer(Segment{{-1, 1}, {1, 1}}), {}, 64).fault);
        QCOMPARE(judged(over, answer(Segment{{-1, 1}, {1, 1}}), {}, 0).fault, Fault::Invented);
    }
};

} // namespace judge_judgement_test

TEST_CLASS(judge_judgement_test::JudgementTest, Gui)
#include "tests/app/judge/judgement_test.moc"
