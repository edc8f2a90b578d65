// SPDX-License-Identifier: GPL-3.0-or-later
// The wheel scrolls what is under the pointer, and at its end what is around it. It changes no
// field, list or tab that it only passes.
#include "ui/experiment/tables_page.h"
#include "ui/widgets/magnifier_view.h"
#include "ui/widgets/table_view.h"

#include <QAbstractSpinBox>
#include <QComboBox>
#include <QScrollBar>
#include <QTabBar>
#include <QWheelEvent>

#include "tests/test_class.h"
#include "tests/ui/fresh/made.h"
#include "tests/ui/fresh/shown_by.h"

namespace wheel_test {

using namespace ui;

namespace {

void turn(QWidget& under, const QPoint& angle)
{
    const QPointF at = under.rect().center();
    QWheelEvent event(at, under.mapToGlobal(at), {}, angle, Qt::NoButton, Qt::NoModifier,
                      Qt::NoScrollPhase, false);
    QSpontaneKeyEvent::setSpontaneous(&event); // made events do not go on to the parent
    qApp->notify(&under, &event);
}

constexpr QPoint down(0, -120), up(0, 120), right(-120, 0);

QString valueOf(const QWidget& widget)
{
    if (const auto* field = qobject_cast<const QAbstractSpinBox*>(&widget))
        return field->text();
    if (const auto* list = qobject_cast<const QComboBox*>(&widget))
        return QString::number(list->currentIndex());
    if (const auto* tabs = qobject_cast<const QTabBar*>(&widget))
        return QString::number(tabs->currentIndex());
    return {};
}

app::Table wideTable(int rows)
{
    app::Table table;
    table.key = table.title = "wide";
    for (int column = 0; column < 8; ++column)
        table.names << QStringLiteral("a wide column of number %1").arg(column);
    for (int row = 0; row < rows; ++row)
        table.rows.push_back(QStringList(table.names.size(), QString::number(row)));
    return table;
}

} // namespace

class WheelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
    }

    void fieldsAndListsDoNotTurn_data() { addEveryMaker(); }
    void fieldsAndListsDoNotTurn()
    {
        QFETCH(int, number);
        const Made made(number);
        QWidget& window = *made.window;
        const auto parts = window.findChildren<QWidget*>();
        for (QWidget* part : QList<QWidget*>{&window} + parts) {
            if (!part->isVisible() || !part->isEnabled() || valueOf(*part).isEmpty())
                continue;
            part->clearFocus();
            const QString before = valueOf(*part), name = classOf(*part) + part->accessibleName();
            for (const QPoint& angle : {down, up, up, down, right}) {
                turn(*part, angle);
                QVERIFY2(valueOf(*part) == before, qPrintable(name));
                QVERIFY2(!part->hasFocus(), qPrintable(name));
            }
        }
    }

    void aPageOfFieldsScrollsUnderThem()
    {
        QScrollArea page;
        auto* inner = new QWidget;
        inner->setFixedSize(200, 900);
        page.setWidget(inner);
        auto* field = new LengthField(QStringLiteral("Width"), LengthField::Range::Any,
                                      LengthField::Suffix::None, inner);
        auto* list = new QComboBox(inner);
        list->addItems({"one", "two", "three"});
        list->move(0, 60);
        auto* count = new QSpinBox(inner);
        count->move(0, 120);
        applyTheme(*qApp, Theme::Light);
        page.resize(220, 200);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        page.setFocus();
        for (QWidget* part : {static_cast<QWidget*>(field), static_cast<QWidget*>(list),
                              static_cast<QWidget*>(count)}) {
            page.verticalScrollBar()->setValue(0);
            turn(*part, down);
            QVERIFY2(page.verticalScrollBar()->value() > 0, qPrintable(classOf(*part)));
        }
        count->setFocus(); // whoever has the keyboard takes the wheel, too
        turn(*count, up);
        QCOMPARE(count->value(), 1);
    }

    void aTableLeavesTheWheelToItsPageButScrollsSideways()
    {
        TablesPage page;
        page.show({{wideTable(60), TableView::Rows::Sortable}});
        page.resize(400, 300);
        static_cast<QWidget&>(page).show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        auto* table = page.findChild<TableView*>();
        QScrollBar *down_ = page.verticalScrollBar(), *across = table->horizontalScrollBar();
        QVERIFY(down_->maximum() > 0 && across->maximum() > 0);
        turn(*table->viewport(), down);
        QVERIFY(down_->value() > 0);
        QCOMPARE(across->value(), 0);
        const int before = down_->value();
        turn(*table->viewport(), right);
        QVERIFY(across->value() > 0);
        QCOMPARE(down_->value(), before);
    }

    void atItsEndAListGivesTheWheelToItsPage()
    {
        QScrollArea page;
        auto* inner = new QWidget;
        inner->setFixedSize(200, 900);
        page.setWidget(inner);
        auto* list = new QListWidget(inner);
        list->setGeometry(0, 0, 180, 100);
        for (int i = 0; i < 20; ++i)
            list->addItem(QString::number(i));
        page.resize(220, 200);
        page.show();
        QVERIFY(QTest::qWaitForWindowExposed(&page));
        turn(*list->viewport(), down);
        QVERIFY(list->verticalScrollBar()->value() > 0);
        QCOMPARE(page.verticalScrollBar()->value(), 0);
        list->scrollToBottom();
        turn(*list->viewport(), down);
        QVERIFY(page.verticalScrollBar()->value() > 0);
    }

    /// What zooms or steps under the wheel does so both ways, and nothing else moves.
    void viewsTakeTheWheel_data()
    {
        QTest::addColumn<QString>("maker");
        QTest::addColumn<QString>("part");
        QTest::newRow("canvas") << "canvas"
                                << "ui::(anonymous namespace)::RasterSurface";
        QTest::newRow("microscope") << "microscope"
                                    << "ui::MicroscopeView";
        QTest::newRow("timeline") << "microscope"
                                  << "ui::Timeline";
        QTest::newRow("sheets") << "tiles"
                                << "ui::TilesView";
    }
    void viewsTakeTheWheel()
    {
        QFETCH(QString, maker);
        QFETCH(QString, part);
        Desk desk(3);
        desk_changes::openFull(desk);
        desk.session.microscope.goTo(3);
        const auto all = makers();
        const Maker& row = *std::ranges::find(all, maker, &Maker::name);
        const std::unique_ptr<QWidget> window(row.make(desk));
        window->resize(row.size);
        ui::open(row, *window, desk);
        settle();
        const auto parts = window->findChildren<QWidget*>();
        const auto found =
            std::ranges::find(parts, part, [](const QWidget* one) { return classOf(*one); });
        QVERIFY(found != parts.end());
        QWidget& view = **found;
        const QImage before = view.grab().toImage();
        turn(view, down);
        settle();
        const QImage after = view.grab().toImage();
        QVERIFY(after != before);
        turn(view, up);
        settle();
        QVERIFY(view.grab().toImage() != after);
    }

    void theOverviewOfSheetsLeavesTheWheelToItsColumn()
    {
        Desk desk(3);
        desk_changes::openFull(desk);
        TilesPage page(desk.session, desk.sheets);
        page.resize(800, 400);
        page.show();
        settle();
        const auto views = page.findChildren<TilesView*>();
        auto* column = page.findChild<QScrollArea*>();
        QVERIFY(column->verticalScrollBar()->maximum() > 0);
        for (TilesView* view : views)
            if (column->isAncestorOf(view))
                turn(*view, down);
        QVERIFY(column->verticalScrollBar()->value() > 0);
    }
};

} // namespace wheel_test

TEST_CLASS(wheel_test::WheelTest, Widgets)
#include "tests/ui/wheel_test.moc"
