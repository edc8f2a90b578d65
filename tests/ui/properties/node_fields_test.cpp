// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/node_fields.h"
#include "ui/properties/selection_panel.h"
#include "ui/widgets/length_field.h"

#include <QAbstractButton>
#include <QLineEdit>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace properties_node_fields_test {

using namespace ui;

// Numbers of the selected nodes in the panel Selection, with mouse and keys.
class NodeFieldsTest : public QObject {
    Q_OBJECT

    /// The nodes of an object are shown.
    struct Panel : Hand {
        explicit Panel(app::Subpath path = wave()) : Hand({shape({path})})
        {
            t.window->raisePanel("properties");
            doubleClick(path.start);
            waitForFinalSize(panel());
        }
        static void settle() { QTest::qWait(20); } // the panel follows after the events
        SelectionPanel& panel() const { return *t.window->findChild<SelectionPanel*>(); }
        LengthField* field(const QString& name) const
        {
            for (LengthField* field : panel().findChildren<LengthField*>())
                if (field->accessibleName() == name)
                    return field;
            return nullptr;
        }
        double value(const QString& name) const { return field(name)->value(); }
        void type(const QString& name, const QString& text) const
        {
            field(name)->setFocus();
            field(name)->selectAll();
            QTest::keyClicks(field(name), text);
            QTest::keyClick(field(name), Qt::Key_Return);
            settle();
        }
    };
    static bool near(double a, double b) { return std::abs(a - b) < 1e-9; }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aSelectedNodeIsShownAtTheSameHeight()
    {
        Panel t;
        const int height = t.panel().height();
        QVERIFY(t.field("Width")->isVisible() && !t.field("Node X")->isVisible());
        t.click({80, 50});
        Panel::settle();
        QVERIFY(!t.field("Width")->isVisible() && t.field("Node X")->isVisible());
        QCOMPARE(t.panel().height(), height);
        QCOMPARE(t.value("Node X"), 80.0);
        QCOMPARE(t.value("Node Y"), 50.0);
        QVERIFY(near(t.value("Length of handle In"), std::hypot(20, 30)));
        Hand::key(Qt::Key_Escape);
        Panel::settle();
        QVERIFY(t.field("Width")->isVisible());
        QCOMPARE(t.panel().height(), height);
    }
    void thePanelFitsTheNarrowestColumn()
    {
        Panel t;
        const int width = t.panel().minimumSizeHint().width();
        QVERIFY2(width <= 272, qPrintable(QString::number(width))); // of Arrangement
    }
    void eachTypedNumberIsOneStep()
    {
        Panel t;
        t.click({80, 50});
        Panel::settle();
        t.type("Node X", "70+5");
        QCOMPARE(t.path().segments[0].to, app::Point(75, 50));
        QVERIFY(t.surface().hasFocus());
        t.type("Node Y", "1cm*3");
        QCOMPARE(t.path().segments[0].to, app::Point(75, 30));
        t.type("Angle of handle Out", "-90");
        t.type("Length of handle Out", "12");
        QVERIFY(glm::distance(t.path().segments[1].control1, app::Point(75, 42)) < 1e-9);
        QVERIFY(glm::distance(t.path().segments[0].control2, app::Point(75, 18)) < 1e-9);
        QCOMPARE(t.session.history.count(), 4);
        for (int i = 0; i < 4; ++i)
            Hand::key(Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(t.path() == wave());
    }
    void differentNodesAreMixedAndGetTheSameNumber()
    {
        Panel t;
        Hand::key(Qt::Key_A, Qt::ControlModifier);
        Panel::settle();
        QCOMPARE(t.field("Node X")->findChild<QLineEdit*>()->placeholderText(), QString("mixed"));
        QVERIFY(t.field("Node X")->text().isEmpty());
        QCOMPARE(t.value("Node Y"), 50.0);
        t.type("Node X", "33");
        for (const app::Node& node : t.session.nodes.path()[0].nodes)
            QCOMPARE(node.at.x, 33.0);
        QCOMPARE(t.session.history.count(), 1);
    }
    void withoutAHandleItsFieldsSayWhy()
    {
        Panel t(corner());
        t.click({100, 20});
        Panel::settle();
        QVERIFY(!t.field("Length of handle In")->isEnabled());
        QVERIFY(t.field("Length of handle In")->text().isEmpty());
        QVERIFY(t.field("Length of handle In")->toolTip().endsWith(u'.'));
    }
    void aHandleOfNoLengthIsRefused()
    {
        Panel t;
        t.click({80, 50});
        Panel::settle();
        const double before = t.value("Length of handle In");
        t.type("Length of handle In", "0");
        QVERIFY(t.t.window->message().endsWith(u'.'));
        QCOMPARE(t.value("Length of handle In"), before);
        QCOMPARE(t.session.history.count(), 0);
    }
};

} // namespace properties_node_fields_test

TEST_CLASS(properties_node_fields_test::NodeFieldsTest, Widgets)
#include "tests/ui/properties/node_fields_test.moc"
