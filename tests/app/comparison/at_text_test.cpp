// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/differences_at.h"
#include "app/session/session.h"

#include <QTest>

#include "tests/app/document/first_window.h"
#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"

namespace comparison_at_text_test {

using clipping::Window;

class AtTextTest : public QObject {
    Q_OBJECT

private slots:
    void clipWindowNeedsNoCaption()
    {
        QVERIFY(app::atText(app::ComparedWindow{{}, false}).isEmpty());
        QCOMPARE(app::atText(app::ComparedWindow{{}, true}),
                 "At the page: no clip window along the axes.");
    }
    /// What is computed follows, too.
    void hiddenWindowCountsAsNoWindow()
    {
        app::Session session;
        ::load(session.document, sheetAt({{10, 10}, {50, 50}}));
        QVERIFY(app::atText(session.compared()).isEmpty());
        session.differences.ask(app::Comparison{*app::findVariant("kwc:published")});
        setVisible(session, false);
        QVERIFY(!app::atText(session.compared()).isEmpty());
        session.differences.finish();
        QCOMPARE(session.differences.found().window, session.now().page().rectangle());
        app::Page page = session.now().page();
        page.size *= 2;
        ::setPage(session.document, page);
        session.differences.finish();
        QCOMPARE(session.differences.found().window, page.rectangle());
        session.setPreview({.windows = withWindow(session.now().windows(),
                                                  Window{{1, 1}, {2, 2}})}); // one is being drawn
        QVERIFY(app::atText(session.compared()).isEmpty());
        session.setPreview({});
        QVERIFY(!app::atText(session.compared()).isEmpty());
        setVisible(session, true);
        QVERIFY(app::atText(session.compared()).isEmpty());
    }
};

} // namespace comparison_at_text_test

TEST_CLASS(comparison_at_text_test::AtTextTest, Core)
#include "tests/app/comparison/at_text_test.moc"
