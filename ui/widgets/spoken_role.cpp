// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/spoken_role.h"

#include <QAbstractItemView>
#include <QAccessibleWidget>
#include <QApplication>
#include <QPointer>

namespace ui {
namespace {

constexpr const char* roleProperty = "spokenRole";

QAccessibleInterface* interfaceOf(const QString&, QObject* object)
{
    auto* widget = qobject_cast<QWidget*>(object);
    const QVariant role = widget ? widget->property(roleProperty) : QVariant();
    return role.isValid() ? new QAccessibleWidget(widget, QAccessible::Role(role.toInt()))
                          : nullptr;
}

} // namespace

void setSpokenRole(QWidget& widget, QAccessible::Role role)
{
    static const bool installed = (QAccessible::installFactory(interfaceOf), true);
    Q_UNUSED(installed)
    widget.setProperty(roleProperty, int(role));
}

// Queued, because Qt tells of the list only after this signal.
void speakRowsInFocus()
{
    const auto speak = [](QWidget* widget) {
        const auto* view = qobject_cast<QAbstractItemView*>(widget);
        if (!view || !view->hasFocus() || !view->currentIndex().isValid())
            return;
        QAccessibleInterface* list = QAccessible::queryAccessibleInterface(widget);
        QAccessibleTableInterface* cells = list ? list->tableInterface() : nullptr;
        const QModelIndex at = view->currentIndex();
        QAccessibleInterface* row = cells ? cells->cellAt(at.row(), at.column()) : nullptr;
        if (!row)
            return;
        QAccessibleEvent focus(widget, QAccessible::Focus);
        focus.setChild(list->indexOfChild(row));
        QAccessible::updateAccessibility(&focus);
    };
    QObject::connect(qApp, &QApplication::focusChanged, qApp, [speak](QWidget*, QWidget* now) {
        if (QAccessible::isActive())
            QMetaObject::invokeMethod(
                qApp, [speak, now = QPointer(now)] { speak(now); }, Qt::QueuedConnection);
    });
}

} // namespace ui
