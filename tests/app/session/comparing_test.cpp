// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/variants.h"
#include "app/session/comparing.h"

#include <QTest>

#include "tests/test_class.h"

namespace session_comparing_test {

using namespace app;

namespace {

void show(Session& session, const Variant& variant)
{
    session.changeDisplay([&variant](app::Display& display) { display.variant = variant; });
}

} // namespace

class ComparingTest : public QObject {
    Q_OBJECT

    const Variant published_ = *findVariant("kwc:published");

private slots:
    void whatIsOnlyComparedDoesNotCut()
    {
        Session session;
        setComparing(session, true);
        show(session, published_);
        setComparing(session, true); // again
        QCOMPARE(session.variant(), published_);
        QCOMPARE(session.cuts(), exactVariant());
        const auto* exact =
            clipping::functionsOf(clipping::exactAlgorithm(), clipping::Form::Corrected);
        QVERIFY(session.uses().clipAll == exact->clipAll);
        QCOMPARE(onlyComparedText(session), "exact cuts; KWC as published is only compared");
        setComparing(session, false);
        QCOMPARE(session.variant(), exactVariant());
        QCOMPARE(session.cuts(), exactVariant());
        QCOMPARE(onlyComparedText(session), QString());
    }
    void whatIsUsedCuts()
    {
        Session session;
        setComparing(session, true);
        useVariant(session, published_);
        QCOMPARE(session.cuts(), published_);
        QCOMPARE(onlyComparedText(session), QString());
        setComparing(session, false);
        QCOMPARE(session.variant(), published_);
        useVariant(session, exactVariant());
        QCOMPARE(session.cuts(), exactVariant());
    }
    void whatIsShownCutsIfNothingIsCompared()
    {
        Session session;
        show(session, published_);
        QCOMPARE(session.cuts(), published_);
    }
};

} // namespace session_comparing_test

TEST_CLASS(session_comparing_test::ComparingTest, Core)
#include "tests/app/session/comparing_test.moc"
