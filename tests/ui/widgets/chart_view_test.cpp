// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/charts/chart_layout.h"
#include "ui/look/look.h"
#include "ui/widgets/chart_view.h"

#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QToolTip>

#include "tests/app/charts/sample_charts.h"
#include "tests/test_class.h"

namespace widgets_chart_view_test {

using namespace ui;

namespace {

app::Chart sampleChart()
{
    return chartOf(sample::seven(), app::measures().front(), app::paperTables().front());
}

} // namespace

class ChartViewTest : public QObject {
    Q_OBJECT

    std::unique_ptr<ChartView> view_;

    QPoint middleOfRow(std::size_t row) const
    {
        const auto layout =
            layoutOf(view_->chart(), view_->rect().adjusted(8, 8, -8, -8), chartLookOf(*view_));
        return layout.rows[row].center().toPoint();
    }

private slots:
    void init()
    {
        applyTheme(*qApp, Theme::Light);
        view_ = std::make_unique<ChartView>();
        view_->setChart(sampleChart());
        view_->resize(view_->sizeHint());
        view_->show();
        QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    }
    void theRowUnderThePointerIsHighlighted()
    {
        QVERIFY(!view_->currentRow());
        const QImage before = view_->grab().toImage();
        QTest::mouseMove(view_.get(), middleOfRow(2));
        QCOMPARE(view_->currentRow(), std::optional<std::size_t>(2));
        QVERIFY(view_->grab().toImage() != before);
    }
    void theTooltipGivesTheDetailsOfARow()
    {
        QHelpEvent help(QEvent::ToolTip, middleOfRow(1), view_->mapToGlobal(middleOfRow(1)));
        QApplication::sendEvent(view_.get(), &help);
        QCOMPARE(QToolTip::text(), view_->chart().rows[1].detail);
        QVERIFY(QToolTip::text().contains("Cohen-Sutherland"));
    }
    void keysMoveThroughTheRows()
    {
        view_->activateWindow();
        view_->setFocus();
        QTest::keyClick(view_.get(), Qt::Key_Down);
        QCOMPARE(view_->currentRow(), std::optional<std::size_t>(0));
        for (int i = 0; i < 20; ++i)
            QTest::keyClick(view_.get(), Qt::Key_Down);
        QCOMPARE(view_->currentRow(), std::optional<std::size_t>(6));
        QCOMPARE(view_->accessibleDescription(), view_->chart().rows[6].detail);
        QTest::keyClick(view_.get(), Qt::Key_Up);
        QCOMPARE(view_->currentRow(), std::optional<std::size_t>(5));
    }
    void screenReadersGetTitleAndContent()
    {
        QCOMPARE(view_->accessibleName(), view_->chart().title);
        QVERIFY(view_->accessibleDescription().contains("Liang-Barsky"));
    }
    void theChartFollowsTheTheme()
    {
        const QColor light = view_->grab().toImage().pixelColor(2, 2);
        applyTheme(*qApp, Theme::Dark);
        const QColor dark = view_->grab().toImage().pixelColor(2, 2);
        QVERIFY(light.lightness() > 200 && dark.lightness() < 80);
    }
    void aNarrowChartIsHigher()
    {
        QVERIFY(view_->heightForWidth(220) >= view_->heightForWidth(700));
        QVERIFY(view_->minimumSizeHint().height() < view_->sizeHint().height());
    }
    void theMenuExportsTheChart()
    {
        QSignalSpy spy(view_.get(), &ChartView::exportWanted);
        QTimer::singleShot(0, [] {
            auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(menu);
            menu->actions().front()->trigger();
            menu->close();
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, view_->mapToGlobal(QPoint(5, 5)));
        QApplication::sendEvent(view_.get(), &event);
        QCOMPARE(spy.count(), 1);
    }
};

} // namespace widgets_chart_view_test

TEST_CLASS(widgets_chart_view_test::ChartViewTest, Widgets)
#include "tests/ui/widgets/chart_view_test.moc"
