// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractItemView>
#include <QAction>
#include <QComboBox>
#include <QImage>
#include <QMenu>
#include <QMetaProperty>
#include <QToolBar>
#include <QToolButton>
#include <QWidget>

#include <algorithm>
#include <array>
#include <cxxabi.h>
#include <map>
#include <memory>
#include <tuple>
#include <typeinfo>
#include <vector>

// What a widget and everything in it shows, as plain data that can be compared.

namespace ui {

/// "ui::WindowPanel"; unlike the name in the meta object, also of a class without Q_OBJECT.
inline QString classOf(const QWidget& widget)
{
    int status = 0;
    const std::unique_ptr<char, void (*)(void*)> name(
        abi::__cxa_demangle(typeid(widget).name(), nullptr, nullptr, &status), std::free);
    return QString::fromLatin1(name.get());
}

/// One property of a widget, or one role of an item, and where it is.
struct Fact {
    QString place, name;
    QVariant value;
};

struct Shown {
    std::vector<Fact> facts;
    QImage picture;
};

namespace shown_by {

/// Where a widget stands on the screen, and what a person is doing with it, is not what it shows.
inline bool isCircumstance(const char* property)
{
    static constexpr std::array names{"acceptableInput",
                                      "baseSize",
                                      "childrenRect",
                                      "childrenRegion",
                                      "cursorPosition",
                                      "frameGeometry",
                                      "frameSize",
                                      "focus",
                                      "focusPolicy",
                                      "fullScreen",
                                      "geometry",
                                      "hasSelectedText",
                                      "isActiveWindow",
                                      "layoutDirection",
                                      "maximized",
                                      "minimized",
                                      "modal",
                                      "mouseTracking",
                                      "normalGeometry",
                                      "palette",
                                      "pos",
                                      "rect",
                                      "redoAvailable",
                                      "selectedText",
                                      "selectionStart",
                                      "sizeIncrement",
                                      "tabletTracking",
                                      "undoAvailable",
                                      "updatesEnabled",
                                      "windowFilePath",
                                      "windowOpacity",
                                      "windowFlags",
                                      "windowModality",
                                      "x",
                                      "y",
                                      "html",
                                      "down",
                                      "inputMethodHints",
                                      "styleSheet",
                                      "locale",
                                      "sizeHint",
                                      "minimumSizeHint",
                                      "minimumSize",
                                      "minimumWidth",
                                      "minimumHeight",
                                      "maximumSize",
                                      "maximumWidth",
                                      "maximumHeight"};
    return std::ranges::find(names, QLatin1StringView(property),
                             [](const char* name) { return QLatin1StringView(name); })
           != names.end();
}

inline bool isComparable(const QMetaType& type)
{
    switch (type.id()) {
    case QMetaType::Bool:
    case QMetaType::Int:
    case QMetaType::UInt:
    case QMetaType::Double:
    case QMetaType::QString:
    case QMetaType::QStringList:
    case QMetaType::QSize:
    case QMetaType::QColor:
    case QMetaType::QFont:
    case QMetaType::QUrl:
    case QMetaType::QLocale:
    case QMetaType::QKeySequence:
        return true;
    default:
        return type.flags() & QMetaType::IsEnumeration;
    }
}

/// The properties of a class that tell what it shows; looked up once.
inline const std::vector<QMetaProperty>& propertiesOf(const QMetaObject& meta)
{
    static std::map<const QMetaObject*, std::vector<QMetaProperty>> known;
    const auto [at, isNew] = known.try_emplace(&meta);
    for (int i = 0; isNew && i < meta.propertyCount(); ++i)
        if (const QMetaProperty property = meta.property(i); property.isReadable()
                                                             && !isCircumstance(property.name())
                                                             && isComparable(property.metaType()))
            at->second.push_back(property);
    return at->second;
}

inline void addModel(std::vector<Fact>& facts, const QString& place,
                     const QAbstractItemModel& model)
{
    static constexpr std::array roles{
        int(Qt::DisplayRole),        int(Qt::EditRole),          int(Qt::ToolTipRole),
        int(Qt::AccessibleTextRole), int(Qt::TextAlignmentRole), int(Qt::CheckStateRole),
        int(Qt::ForegroundRole),     int(Qt::UserRole),          int(Qt::UserRole) + 1,
        int(Qt::UserRole) + 2,       int(Qt::UserRole) + 3,      int(Qt::UserRole) + 4};
    constexpr int most = 40; // rows
    facts.push_back({place, "rows", model.rowCount()});
    facts.push_back({place, "columns", model.columnCount()});
    for (int column = 0; column < model.columnCount(); ++column)
        facts.push_back({place, QStringLiteral("heading %1").arg(column),
                         model.headerData(column, Qt::Horizontal)});
    for (int row = 0; row < std::min(model.rowCount(), most); ++row)
        for (int column = 0; column < model.columnCount(); ++column) {
            const QModelIndex index = model.index(row, column);
            const QString cell = QStringLiteral("%1,%2 ").arg(row).arg(column);
            facts.push_back({place, cell + "flags", int(model.flags(index))});
            for (const int role : roles)
                if (const QVariant value = index.data(role);
                    value.isValid() && isComparable(value.metaType()))
                    facts.push_back({place, cell + QString::number(role), value});
        }
}

inline void addActions(std::vector<Fact>& facts, const QString& place,
                       const QList<QAction*>& actions)
{
    for (const QAction* action : actions) {
        const QString name = place + '/' + action->text();
        facts.push_back({name, "enabled", action->isEnabled()});
        facts.push_back({name, "checked", action->isChecked()});
        facts.push_back({name, "visible", action->isVisible()});
        facts.push_back({name, "tip", action->toolTip()});
    }
}

/// What is visible in a widget, from top to bottom.
inline QList<const QWidget*> partsOf(const QWidget& widget)
{
    QList<const QWidget*> parts;
    for (const QWidget* part : widget.findChildren<QWidget*>(Qt::FindDirectChildrenOnly))
        if (!part->isWindow() && part->isVisibleTo(&widget))
            parts << part;
    std::ranges::stable_sort(parts, {}, [](const QWidget* part) {
        return std::tuple(part->y(), part->x(), classOf(*part), part->objectName());
    });
    return parts;
}

inline void addWidget(std::vector<Fact>& facts, const QString& place, const QWidget& widget,
                      bool isWhole)
{
    const QString self = place + '/' + classOf(widget)
                         + (widget.objectName().isEmpty() ? QString() : '#' + widget.objectName());
    for (const QMetaProperty& property : propertiesOf(*widget.metaObject()))
        facts.push_back({self, QLatin1StringView(property.name()), property.read(&widget)});
    if (!isWhole)
        facts.push_back({self, "geometry", widget.geometry()});
    if (const auto* view = qobject_cast<const QAbstractItemView*>(&widget); view && view->model()) {
        addModel(facts, self, *view->model());
        facts.push_back({self, "current row", view->currentIndex().row()});
        facts.push_back(
            {self, "selected", view->selectionModel()->isRowSelected(view->currentIndex().row())});
    }
    if (const auto* box = qobject_cast<const QComboBox*>(&widget))
        addModel(facts, self, *box->model());
    if (qobject_cast<const QToolBar*>(&widget))
        addActions(facts, self, widget.actions());
    if (const auto* button = qobject_cast<const QToolButton*>(&widget); button && button->menu())
        addActions(facts, self + "/menu", button->menu()->actions());
    for (const QWidget* part : partsOf(widget))
        addWidget(facts, self, *part, false);
}

} // namespace shown_by

/// `picture` is what is on the screen.
inline Shown shownBy(const QWidget& widget, QImage picture)
{
    Shown shown;
    shown.picture = std::move(picture);
    shown_by::addWidget(shown.facts, {}, widget, true);
    return shown;
}

inline QString textOf(const Fact& fact)
{
    QString value;
    QDebug(&value).nospace() << fact.value;
    return fact.place + ": " + fact.name + " = " + value;
}

/// Where the colours of two pictures differ by more than `most` of 255, in words; empty: nowhere.
inline QString differenceBetween(const QImage& one, const QImage& other, int most = 0)
{
    if (one.size() != other.size())
        return QStringLiteral("%1 × %2 instead of %3 × %4 pixels")
            .arg(one.width())
            .arg(one.height())
            .arg(other.width())
            .arg(other.height());
    const auto differ = [most](QRgb a, QRgb b) {
        return a != b
               && std::max({std::abs(qRed(a) - qRed(b)), std::abs(qGreen(a) - qGreen(b)),
                            std::abs(qBlue(a) - qBlue(b))})
                      > most;
    };
    QRect where;
    for (int y = 0; y < one.height(); ++y)
        for (int x = 0; x < one.width(); ++x)
            if (differ(one.pixel(x, y), other.pixel(x, y)))
                where |= QRect(x, y, 1, 1);
    return where.isNull() ? QString()
                          : QStringLiteral("different pixels in %1 × %2 at %3, %4")
                                .arg(where.width())
                                .arg(where.height())
                                .arg(where.x())
                                .arg(where.y());
}

/// The first difference in words; empty: they show the same.
inline QString differenceBetween(const Shown& one, const Shown& other)
{
    const auto same = [](const Fact& a, const Fact& b) {
        return a.place == b.place && a.name == b.name && a.value == b.value;
    };
    const auto [a, b] = std::ranges::mismatch(one.facts, other.facts, same);
    if (a != one.facts.end() || b != other.facts.end())
        return (a == one.facts.end() ? QStringLiteral("nothing") : textOf(*a))
               + "\n      instead of "
               + (b == other.facts.end() ? QStringLiteral("nothing") : textOf(*b));
    return differenceBetween(one.picture, other.picture);
}

} // namespace ui
