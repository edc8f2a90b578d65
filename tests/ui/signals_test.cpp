// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever a person can operate does something, and whatever a part of the program tells is heard.
#include <QAbstractButton>
#include <QButtonGroup>
#include <QMetaMethod>

#include "tests/test_class.h"
#include "tests/ui/fresh/made.h"
#include "tests/ui/fresh/shown_by.h"

namespace signals_test {

using namespace ui;

namespace {

/// Ends the connections of a signal; false: there was none.
bool silence(const QObject& object, const QMetaMethod& signal)
{
    return QObject::disconnect(&object, signal, nullptr, QMetaMethod());
}

template <class... Signals>
bool anyHeard(const QObject& object, Signals... signal)
{
    return (silence(object, QMetaMethod::fromSignal(signal)) | ...);
}

/// Whether something happens when a person operates it.
bool acts(const QWidget& control)
{
    if (const auto* button = qobject_cast<const QAbstractButton*>(&control)) {
        const auto* tool = qobject_cast<const QToolButton*>(button);
        if (tool && (tool->menu() || tool->defaultAction()))
            return true;
        if (button->group() && anyHeard(*button->group(), &QButtonGroup::idClicked))
            return true;
        return anyHeard(*button, &QAbstractButton::clicked, &QAbstractButton::toggled,
                        &QAbstractButton::pressed);
    }
    if (qobject_cast<const QComboBox*>(&control))
        return anyHeard(control, &QComboBox::activated, &QComboBox::currentIndexChanged,
                        &QComboBox::currentTextChanged);
    if (qobject_cast<const LengthField*>(&control))
        return anyHeard(control, &LengthField::edited);
    if (qobject_cast<const QSpinBox*>(&control))
        return anyHeard(control, &QSpinBox::valueChanged);
    if (qobject_cast<const QDoubleSpinBox*>(&control))
        return anyHeard(control, &QDoubleSpinBox::valueChanged);
    if (const auto* field = qobject_cast<const QLineEdit*>(&control))
        return field->isReadOnly() || qobject_cast<const QAbstractSpinBox*>(field->parentWidget())
               || anyHeard(control, &QLineEdit::textChanged, &QLineEdit::textEdited,
                           &QLineEdit::returnPressed, &QLineEdit::editingFinished);
    return true;
}

/// Something else asks for its state.
bool isReadLater(const QWidget& control)
{
    const auto* button = qobject_cast<const QAbstractButton*>(&control);
    return control.objectName() == u"find" // by the button Select
           || (button && button->text() == u"Judge again after each re&build");
}

bool isIn(const QObject& object, const char* around)
{
    for (const QObject* one = &object; one; one = one->parent())
        if (one->inherits(around))
            return true;
    return false;
}

/// What one part of the program needs and another has no use for.
bool mayBeUnheard(const QObject& object, const QByteArray& signal)
{
    const auto* widget = qobject_cast<const QWidget*>(&object);
    const QString name = widget ? widget->accessibleName() : QString();
    return signal == "foldWanted"           // only the panel Algorithm can be folded
           || signal == "indexSet"          // the journal hears it, which this window is without
           || signal == "eyedropperStarted" // closes the popups that take all events
           || signal == "eyedropperWanted"  // hidden where there is no canvas
           || (signal == "entered" && isIn(object, "ui::StylePopup")) // which keeps the keyboard
           || (signal == "frameShown" && name == u"Overview of the sheets")
           || isIn(object, "ui::DrawingTabs") // of several windows: editor/desk_test.cpp
           || signal == "notOpened"           // likewise
           // Typing withdraws the sentence.
           || (signal == "taken" && (isIn(object, "ui::TilesPage") || isIn(object, "ui::TextBox")));
}

QString nameOf(const QObject& object)
{
    const auto* widget = qobject_cast<const QWidget*>(&object);
    if (!widget)
        return QString::fromLatin1(object.metaObject()->className());
    const auto* button = qobject_cast<const QAbstractButton*>(widget);
    return classOf(*widget) + " “"
           + (!widget->accessibleName().isEmpty() ? widget->accessibleName()
              : button                            ? button->text()
                                                  : widget->objectName())
           + "”";
}

} // namespace

class SignalsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase()
    {
        Timers::watch();
        dropRemarksOfThePlatform();
    }

    void everyControlActs_data() { addEveryMaker(); }
    void everyControlActs()
    {
        QFETCH(int, number);
        Desk desk(3);
        desk_changes::openFull(desk);
        const Maker maker = makers()[std::size_t(number)];
        const std::unique_ptr<QWidget> window(maker.make(desk));
        window->setAttribute(Qt::WA_DontShowOnScreen);
        ui::open(maker, *window, desk);
        settle();
        QStringList dead;
        for (const QWidget* part : window->findChildren<QWidget*>())
            if (!acts(*part) && !isReadLater(*part))
                dead << nameOf(*part);
        QVERIFY2(dead.isEmpty(), qPrintable(dead.join('\n')));
    }

    void everySignalIsHeard()
    {
        TestWindow test;
        MainWindow& window = *test.window;
        test.show();
        Desk desk(3, window);
        desk_changes::openFull(desk);
        window.showLessons();
        for (const char* command :
             {"judge", "hard-cases", "reproduce-paper", "about-algorithm", "settings"})
            if (QAction* action = test.action(command))
                action->trigger();
            else
                qWarning("no command %s", command);
        settle();
        app::Session& session = window.session();
        QList<QObject*> all = window.findChildren<QObject*>();
        all << &session << &session.document << &session.history << &session.scene
            << &session.differences << &session.exactness << &session.microscope << &session.course
            << &session.nodes << &session.entered << &window.drawnLine() << &window.sheets()
            << &window.files();
        QStringList unheard;
        for (const QObject* object : all) {
            const QMetaObject* meta = object->metaObject();
            const QByteArray name = meta->className();
            if (!name.startsWith("ui::") && !name.startsWith("app::"))
                continue;
            for (int i = meta->methodOffset(); i < meta->methodCount(); ++i)
                if (const QMetaMethod method = meta->method(i);
                    method.methodType() == QMetaMethod::Signal
                    && !mayBeUnheard(*object, method.name()) && !silence(*object, method))
                    unheard << nameOf(*object) + " " + method.name();
        }
        unheard.removeDuplicates();
        QVERIFY2(unheard.isEmpty(), qPrintable(unheard.join('\n')));
    }
};

} // namespace signals_test

TEST_CLASS(signals_test::SignalsTest, Widgets)
#include "tests/ui/signals_test.moc"
