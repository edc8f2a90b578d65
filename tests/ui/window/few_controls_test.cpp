// SPDX-License-Identifier: GPL-3.0-or-later
// What an empty drawing asks of a newcomer: how much there is to press and to fill in.
#include "ui/widgets/segments.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QTabBar>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace window_few_controls_test {

using namespace ui;

namespace {

constexpr int mostControls = 45;

/// A row of joined buttons, a list and a row of tabs are one control each.
bool isControl(const QWidget& widget)
{
    if (!widget.isVisible() || widget.testAttribute(Qt::WA_TransparentForMouseEvents))
        return false;
    const QWidget* parent = widget.parentWidget();
    if (qobject_cast<const Segments*>(&widget) || qobject_cast<const QTabBar*>(&widget))
        return true;
    for (const QWidget* around = parent; around; around = around->parentWidget())
        if (qobject_cast<const Segments*>(around) || qobject_cast<const QTabBar*>(around)
            || qobject_cast<const QAbstractSpinBox*>(around)
            || qobject_cast<const QComboBox*>(around)
            || qobject_cast<const QAbstractItemView*>(around)
            || qobject_cast<const QLineEdit*>(around))
            return false;
    return widget.inherits("QAbstractButton") || widget.inherits("QAbstractSpinBox")
           || widget.inherits("QComboBox") || widget.inherits("QLineEdit")
           || widget.inherits("QAbstractItemView");
}

} // namespace

class FewControlsTest : public QObject {
    Q_OBJECT

private slots:
    void anEmptyDrawingAsksForLittle()
    {
        TestWindow t;
        t.window->resize(1440, 900);
        t.show();
        t.run("new");
        t.run("workspace-draw");
        QTest::qWait(50); // panels get their sizes
        QStringList found;
        for (const auto* widget : t.window->findChildren<QWidget*>())
            if (isControl(*widget))
                found << QStringLiteral("%1 %2 “%3”%4")
                             .arg(widget->metaObject()->className(), widget->objectName(),
                                  widget->accessibleName().isEmpty() ? widget->toolTip()
                                                                     : widget->accessibleName(),
                                  widget->isEnabled() ? "" : " disabled");
        qInfo().noquote() << found.size() << "controls";
        QVERIFY2(found.size() <= mostControls, qPrintable(found.join(u'\n')));
        QVERIFY(found.size() > 30);
    }
};

} // namespace window_few_controls_test

TEST_CLASS(window_few_controls_test::FewControlsTest, Widgets)
#include "tests/ui/window/few_controls_test.moc"
