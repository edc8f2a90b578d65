// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_steps.h"
#include "ui/bars/node_row.h"
#include "ui/bars/option_bar.h"

#include <QHelpEvent>
#include <QToolButton>
#include <QToolTip>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace bars_node_row_test {

using namespace ui;

// The commands for nodes in the bar across the top.
class NodeRowTest : public QObject {
    Q_OBJECT

    struct Bar : Hand {
        Bar() : Hand({shape({wave()})}) {}
        NodeRow& row() const { return *t.window->findChild<NodeRow*>(); }
        QToolButton* button(const char* key) const
        {
            for (auto* button : row().findChildren<QToolButton*>())
                if (button->defaultAction()->objectName() == key)
                    return button;
            return nullptr;
        }
        static QString tip(QToolButton& button)
        {
            const QPoint middle = button.rect().center();
            QHelpEvent event(QEvent::ToolTip, middle, button.mapToGlobal(middle));
            QApplication::sendEvent(&button, &event);
            return QToolTip::text();
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void itIsThereWithTheToolNodesOnly()
    {
        Bar t;
        QVERIFY(!t.row().isVisible());
        const QToolBar& bar = t.t.window->optionBar();
        Hand::key(Qt::Key_N);
        QTRY_VERIFY(t.row().isVisible());
        QCOMPARE(t.row().findChildren<QToolButton*>().size(), qsizetype(app::nodeSteps().size()));
        QVERIFY(bar.sizeHint().width() <= 1280 && bar.width() >= bar.sizeHint().width());
        for (const auto* button : t.row().findChildren<QToolButton*>())
            QVERIFY(!button->icon().isNull() && button->isVisible());
        Hand::key(Qt::Key_V);
        QTRY_VERIFY(!t.row().isVisible());
    }
    void buttonsChangeTheSelectedNodes()
    {
        Bar t;
        t.doubleClick({20, 50});
        t.click({80, 50});
        QVERIFY(t.button("symmetric-nodes")->isChecked());
        QTest::mouseClick(t.button("corner-nodes"), Qt::LeftButton);
        QCOMPARE(t.session.nodes.path()[0].nodes[1].type, app::NodeType::Corner);
        QVERIFY(t.button("corner-nodes")->isChecked());
        QTest::mouseClick(t.button("delete-nodes"), Qt::LeftButton);
        QCOMPARE(t.path().segments.size(), std::size_t(1));
        QTest::mouseClick(t.button("reverse-path"), Qt::LeftButton);
        QCOMPARE(t.path().start, app::Point(140, 50));
        QVERIFY(t.surface().hasFocus());
    }
    void tooltipsNameTheKeyOrSayWhyNot()
    {
        Bar t;
        t.doubleClick({20, 50}); // no node is selected yet
        QVERIFY(!t.button("smooth-nodes")->isEnabled());
        QVERIFY(Bar::tip(*t.button("smooth-nodes")).endsWith(u'.'));
        t.click({80, 50});
        QVERIFY(t.button("smooth-nodes")->isEnabled());
        QVERIFY(Bar::tip(*t.button("smooth-nodes")).contains("Shift+S"));
    }
};

} // namespace bars_node_row_test

TEST_CLASS(bars_node_row_test::NodeRowTest, Widgets)
#include "tests/ui/bars/node_row_test.moc"
