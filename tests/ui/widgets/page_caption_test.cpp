// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/compare_panel.h"
#include "ui/docks/cost_map_panel.h"
#include "ui/docks/difference_panel.h"
#include "ui/docks/exactness_panel.h"
#include "ui/look/look.h"
#include "ui/widgets/heading.h"

#include <QTest>

#include "tests/app/document/first_window.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/app/session/concave_window.h"
#include "tests/test_class.h"

namespace widgets_page_caption_test {

using namespace ui;

namespace {

using Maker = std::function<QWidget*(app::Session&)>;

template <class Panel>
QWidget* made(app::Session& session)
{
    return new Panel(session);
}

} // namespace

class PageCaptionTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(*qApp, Theme::Light); }

    void theCaptionIsShownWithoutAClipWindow()
    {
        app::Session session;
        ::load(session.document, sheetAt({{10, 10}, {50, 50}}));
        PageCaption caption(session);
        QVERIFY(caption.isHidden());
        setVisible(session, false);
        QVERIFY(!caption.isHidden());
        QCOMPARE(caption.text(), "At the page: no clip window along the axes.");
        setVisible(session, true);
        QVERIFY(caption.isHidden());
    }

    void theCaptionSaysThatNothingIsCompared()
    {
        app::Session session;
        ::load(session.document, sheetAt({{10, 10}, {50, 50}}));
        PageCaption caption(session);
        PageCaption map(session, PageCaption::Elsewhere::AtThePage);
        setWindows(session, {concaveWindow("Star", {{10, 10}, {50, 50}})});
        QVERIFY(caption.text().startsWith("Nothing is compared"));
        QCOMPARE(map.text(), "At the page: no clip window along the axes.");
    }

    void everyComparingPanelHasACaption_data()
    {
        QTest::addColumn<Maker>("make");
        QTest::addRow("algorithm") << Maker(made<AlgorithmPanel>);
        QTest::addRow("compare") << Maker(made<ComparePanel>);
        QTest::addRow("cost map") << Maker(made<CostMapPanel>);
        QTest::addRow("differences") << Maker(made<DifferencePanel>);
        QTest::addRow("exactness") << Maker(made<ExactnessPanel>);
    }
    void everyComparingPanelHasACaption()
    {
        QFETCH(Maker, make);
        app::Session session;
        ::load(session.document, sheetAt({{10, 10}, {50, 50}}));
        const std::unique_ptr<QWidget> panel(make(session));
        panel->resize(600, 600);
        panel->show();
        const auto* caption = panel->findChild<PageCaption*>();
        QVERIFY(caption && !caption->isVisible());
        setVisible(session, false);
        QVERIFY(caption->isVisible());
    }
};

} // namespace widgets_page_caption_test

TEST_CLASS(widgets_page_caption_test::PageCaptionTest, Widgets)
#include "tests/ui/widgets/page_caption_test.moc"
