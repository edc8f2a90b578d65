// SPDX-License-Identifier: GPL-3.0-or-later
// Every widget that takes keys gets the focus by Tab, in the order in which one reads, and shows
// that it has it.
#include "app/commands/add_and_remove.h"

#include <QAbstractButton>
#include <QAccessible>
#include <QButtonGroup>
#include <QDirIterator>
#include <QRegularExpression>

#include "tests/test_class.h"
#include "tests/ui/fresh/lived.h"
#include "tests/ui/fresh/made.h"
#include "tests/ui/fresh/shown_by.h"

namespace focus_test {

using namespace ui;

namespace {

/// The classes that the sources give a function for keys.
QSet<QString> takersOfKeys()
{
    static const QRegularExpression classHead(
        QStringLiteral("^class (\\w+)(?: final)?(?: : public [\\w:]+)? *\\{?$"));
    QSet<QString> found;
    QDirIterator files(QStringLiteral(SOURCE_DIR "/ui"), {"*.h", "*.cpp"}, QDir::Files,
                       QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        [[maybe_unused]] const bool open = file.open(QIODevice::ReadOnly);
        QString inside;
        for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n')) {
            if (const auto head = classHead.match(line); head.hasMatch())
                inside = head.captured(1);
            if (line.contains("void keyPressEvent(QKeyEvent* event) override"))
                found << "ui::" + inside;
        }
    }
    return found;
}

QString nameOf(const QWidget* widget)
{
    if (!widget)
        return "nothing";
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return classOf(*widget) + " “"
           + (!widget->accessibleName().isEmpty() ? widget->accessibleName()
              : button                            ? button->text()
                                                  : widget->objectName())
           + "”";
}

/// The buttons of a choice are one stop.
const void* stopOf(const QWidget& widget)
{
    if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
        if (button->group() && button->group()->exclusive())
            return button->group();
        if (button->autoExclusive())
            return button->parentWidget();
    }
    return &widget;
}

/// Whether one reads `later` before `sooner`: of the parts of the window that hold them, above or
/// at the left.
bool goesBack(const QWidget& sooner, const QWidget& later)
{
    const QWidget* around = sooner.parentWidget();
    while (!around->isAncestorOf(&later))
        around = around->parentWidget();
    const auto placeOf = [around](const QWidget* part) {
        while (part->parentWidget() != around)
            part = part->parentWidget();
        return part->geometry();
    };
    const QRect from = placeOf(&sooner), to = placeOf(&later);
    constexpr int slack = 2; // pixels
    const bool above = to.bottom() <= from.top() + slack, lower = to.top() > from.top() + slack,
               left = to.right() <= from.left() + slack, right = to.left() >= from.right() - slack;
    return (above && !right) || (left && !lower); // columns are read downwards
}

/// The drawing and its sheets: keys go there unless something else has a mark.
bool isDrawing(const QWidget& widget)
{
    const QString name = widget.accessibleName();
    return name == u"Drawing" || name == u"Sheets";
}

} // namespace

class FocusTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
        QApplication::setCursorFlashTime(0); // it is always seen
    }
    void every_data() { addEveryMaker(); }
    void every()
    {
        QFETCH(int, number);
        const Made made(number);
        QWidget& window = *made.window;
        window.activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window));
        walk(window);
    }

private:
    /// The widgets that get the focus by this key, until they are the first ones again.
    static QList<QWidget*> wayBy(Qt::Key key, QWidget& window)
    {
        constexpr int most = 300;
        QList<QWidget*> way;
        for (int i = 0; i < most; ++i) {
            QWidget* now = QApplication::focusWidget();
            if (way.size() > 1 && now == way.front())
                return way;
            if (now && (way.isEmpty() || way.back() != now)) // a view may have several places
                way << now;
            QTest::keyClick(now ? now : &window, key);
        }
        return way;
    }

    void walk(QWidget& window)
    {
        static const QSet<QString> takers = takersOfKeys();
        QVERIFY(takers.size() > 20);
        QHash<const void*, const QWidget*> wanted;
        for (const QWidget* part : window.findChildren<QWidget*>())
            if (part->isVisible() && part->isEnabled() && part->window() == &window
                && !part->focusProxy()
                && (part->focusPolicy() & Qt::TabFocus || takers.contains(classOf(*part)))
                && part->accessibleName() != u"Overview of the sheets") // takes none
                wanted[stopOf(*part)] = part;
        if (wanted.isEmpty())
            return;
        const QList<QWidget*> way = wayBy(Qt::Key_Tab, window);
        for (const QWidget* one : way)
            wanted.remove(stopOf(*one));
        QStringList missed;
        for (const QWidget* one : wanted)
            missed << nameOf(one);
        QVERIFY2(missed.isEmpty(), qPrintable(missed.join(u'\n')));
        checkOrder(way);
        checkMarks(way);
        checkWords(way);
        QList<QWidget*> back = wayBy(Qt::Key_Backtab, window);
        std::ranges::reverse(back);
        std::ranges::rotate(back, std::ranges::find(back, way.front()));
        QCOMPARE(back, way);
    }

    static bool isShownAsPainted(QWidget& window)
    {
        settle();
        return onScreen(window) == painted(window);
    }

    /// A screen reader says what each of them is, and what it is for.
    static void checkWords(const QList<QWidget*>& way)
    {
        QStringList silent;
        for (QWidget* one : way) {
            QAccessibleInterface* said = QAccessible::queryAccessibleInterface(one);
            const bool hasRole =
                said && said->role() != QAccessible::Client && said->role() != QAccessible::NoRole;
            const auto* button = qobject_cast<QAbstractButton*>(one);
            if (button && button->text().isEmpty() && button->icon().isNull())
                continue; // the menus give it its action
            if (!hasRole || said->text(QAccessible::Name).isEmpty())
                silent << (hasRole ? "no name: " : "no role: ") + nameOf(one);
        }
        QVERIFY2(silent.isEmpty(), qPrintable(silent.join(u'\n')));
    }

    /// Only at the end it goes back, to the first one.
    static void checkOrder(const QList<QWidget*>& way)
    {
        QStringList jumps;
        for (qsizetype i = 0; i < way.size(); ++i) {
            const QWidget *one = way[i], *next = way[(i + 1) % way.size()];
            if (one != next && goesBack(*one, *next))
                jumps << nameOf(one) + " to " + nameOf(next);
        }
        QVERIFY2(jumps.size() <= 1, qPrintable(jumps.join(u'\n')));
    }

    /// One sees which widget has the focus, and at once.
    static void checkMarks(const QList<QWidget*>& way)
    {
        QStringList unmarked;
        for (QWidget* one : way) {
            one->setFocus(Qt::TabFocusReason);
            const QImage with = one->grab().toImage();
            if (!isShownAsPainted(*one->window()))
                unmarked << "not at once: " + nameOf(one);
            one->clearFocus();
            if (!isShownAsPainted(*one->window()))
                unmarked << "still: " + nameOf(one);
            if (one->grab().toImage() == with && !isDrawing(*one))
                unmarked << nameOf(one);
        }
        way.front()->setFocus(Qt::TabFocusReason);
        QVERIFY2(unmarked.isEmpty(), qPrintable(unmarked.join(u'\n')));
    }
};

} // namespace focus_test

TEST_CLASS(focus_test::FocusTest, Widgets)
#include "tests/ui/focus_test.moc"
