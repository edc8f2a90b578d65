// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/paper.h"
#include "app/formats/format.h"
#include "ui/tools/tool.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QPointer>
#include <QRegularExpression>

#include <glm/geometric.hpp>

#include <cstring>
#include <functional>
#include <vector>

#include "tests/deep.h"
#include "tests/ui/test_window.h"

// Plays a task as a person would: with the keyboard and the mouse in the editor's window. Nothing
// here changes a drawing in another way; the session is only read, at the end.

namespace tasks {

/// What is drawn: all points of each path in order, also control points. A table may leave out the
/// style.
struct Drawn {
    std::vector<app::Point> points;
    bool closed = false;
    std::optional<app::Style> style = {};
};
using Table = std::vector<Drawn>;

class Player {
    static constexpr int longestWait = 5000; // milliseconds

public:
    Player()
    {
        window_.answers->save = printed(); // where a person prints to
        window_.show();
        auto& canvas = window_.window->canvas();
        canvas.settle();
        key(QStringLiteral("Ctrl+Alt+1")); // the workspace Draw, where digits are numbers
    }

    /// Waits, as a person does, until a file that the key writes is written.
    void key(const QString& sequence)
    {
        const QKeyCombination pressed = QKeySequence(sequence)[0];
        QTest::keyClick(receiver(), pressed.key(), pressed.keyboardModifiers());
        // A name being edited in a list is finished by a queued call.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::MetaCall);
        window_.window->files().wait();
        if (QWidget* dialog = QApplication::activeModalWidget()) {
            dialog->activateWindow(); // as window managers do; otherwise fields are never left
            (void)QTest::qWaitFor([dialog] { return dialog->isActiveWindow(); }, longestWait);
        }
    }
    void type(const char* text)
    {
        for (const char* c = text; *c; ++c) {
            const QPointer menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QTest::keyClick(receiver(), *c);
            const auto opensSubmenu = [&menu] { // some time after its key
                const QAction* found = menu ? menu->activeAction() : nullptr;
                return found && found->menu() && QApplication::activePopupWidget() == menu;
            };
            (void)QTest::qWaitFor([&] { return !opensSubmenu(); }, longestWait);
        }
    }
    void move(const app::Point& p, Qt::MouseButtons buttons = {}, Qt::KeyboardModifiers with = {})
    {
        const QPointF at = screen(p);
        QMouseEvent event(QEvent::MouseMove, at, area().mapToGlobal(at), Qt::NoButton, buttons,
                          with);
        QApplication::sendEvent(&area(), &event);
    }
    void click(const app::Point& p, Qt::KeyboardModifiers with = {})
    {
        move(p, {}, with);
        QTest::mouseClick(&area(), Qt::LeftButton, with, screen(p).toPoint());
    }
    void doubleClick(const app::Point& p)
    {
        click(p);
        QTest::mouseDClick(&area(), Qt::LeftButton, {}, screen(p).toPoint());
    }
    void drag(const app::Point& from, const app::Point& to, Qt::KeyboardModifiers with = {})
    {
        move(from, {}, with);
        QTest::mousePress(&area(), Qt::LeftButton, with, screen(from).toPoint());
        for (const double part : {0.3, 0.7, 1.0})
            move(from + (to - from) * part, Qt::LeftButton, with);
        QTest::mouseRelease(&area(), Qt::LeftButton, with, screen(to).toPoint());
    }

    /// From a ruler to a place in the drawing; `axis` 0: from the ruler at the left.
    void dragGuide(int axis, const app::Point& to)
    {
        auto* ruler = window_.window->findChild<QWidget*>(axis == 0 ? "leftRuler" : "topRuler");
        const QPoint on = ruler->rect().center();
        QTest::mousePress(ruler, Qt::LeftButton, {}, on);
        const QPoint at = ruler->mapFromGlobal(area().mapToGlobal(screen(to).toPoint()));
        QMouseEvent event(QEvent::MouseMove, at, ruler->mapToGlobal(at), Qt::NoButton,
                          Qt::LeftButton, {});
        QApplication::sendEvent(ruler, &event);
        QTest::mouseRelease(ruler, Qt::LeftButton, {}, at);
    }
    /// Clicks the button with this tooltip, or with this text.
    void press(const QString& toolTip)
    {
        showAll();
        for (auto* button : window_.window->findChildren<QAbstractButton*>())
            if (button->isVisible()
                && (button->toolTip() == toolTip || button->text() == toolTip)) {
                QTest::mouseClick(button, Qt::LeftButton);
                window_.window->files().wait();
                return showAll();
            }
    }
    /// Opens the list of this name.
    void clickList(const QString& name)
    {
        showAll();
        for (auto* list : window_.window->findChildren<QComboBox*>())
            if (list->isVisible() && list->accessibleName() == name)
                QTest::mouseClick(list, Qt::LeftButton);
        showAll();
    }
    /// Clicks the field of this name.
    void clickField(const QString& name)
    {
        showAll();
        for (auto* field : window_.window->findChildren<QAbstractSpinBox*>())
            if (field->isVisible() && field->isEnabled() && field->accessibleName() == name) {
                auto* edit = field->findChild<QLineEdit*>();
                return QTest::mouseClick(edit, Qt::LeftButton, {}, edit->rect().center());
            }
    }
    /// Clicks a row of a list, `fromRight` pixels from its right end or, if 0, in the middle.
    void clickRow(const QString& list, const QString& row, int fromRight = 0)
    {
        const auto [area, at] = placeOf(list, row);
        const QPoint place = fromRight ? QPoint(area->rect().right() - fromRight, at.y()) : at;
        QTest::mouseClick(area, Qt::LeftButton, {}, place);
    }
    void dragRow(const QString& list, const QString& row, const QString& onto)
    {
        const auto [area, from] = placeOf(list, row);
        const QPoint to = placeOf(list, onto).second;
        QTest::mousePress(area, Qt::LeftButton, {}, from);
        for (const QPoint& at : {(from + to) / 2, to}) {
            QMouseEvent event(QEvent::MouseMove, at, area->mapToGlobal(at), Qt::NoButton,
                              Qt::LeftButton, {});
            QApplication::sendEvent(area, &event);
        }
        QTest::mouseRelease(area, Qt::LeftButton, {}, to);
    }
    void stroke(const std::vector<app::Point>& points)
    {
        move(points.front());
        QTest::mousePress(&area(), Qt::LeftButton, {}, screen(points.front()).toPoint());
        for (const app::Point& p : points)
            move(p, Qt::LeftButton);
        QTest::mouseRelease(&area(), Qt::LeftButton, {}, screen(points.back()).toPoint());
    }

    /// What is drawn, then what the exported file holds.
    Table drawn() const
    {
        Table table;
        append(table, window_.window->session().now().objects());
        if (!exported().isEmpty())
            if (const auto file = app::readFile(exported()))
                append(table, file.value->document.objects());
        return table;
    }

    /// The page as a path: its corners in the drawing, and its size on paper.
    Drawn page() const
    {
        const app::Page& page = window_.window->session().now().page();
        return {{page.min, page.rectangle().max, app::millimetresOf(page)}};
    }
    /// The file of the last export; empty: there is none.
    QString exported() const
    {
        const auto last = window_.window->files().lastExport();
        return last ? last->file : QString();
    }

    /// The file of the last print.
    QString printed() const { return window_.path("printed.pdf"); }

private:
    static void append(Table& table, const app::Objects& all)
    {
        all.forEach(0, all.size(), [&](std::size_t, const app::ObjectView& object) {
            for (const app::Subpath& path : object.path().subpaths()) {
                table.push_back(drawn(path));
                table.back().style = object.style();
            }
        });
    }
    /// A person sees a panel before clicking there, and what opens: both come after the event.
    static void showAll() { QCoreApplication::processEvents(); }
    QWidget* receiver() const
    {
        if (QWidget* popup = QApplication::activePopupWidget())
            return popup->focusWidget() ? popup->focusWidget() : popup;
        if (QWidget* modal = QApplication::activeModalWidget())
            return modal->focusWidget() ? modal->focusWidget() : modal;
        QWidget* focused = window_.window->focusWidget();
        return focused ? focused : window_.drawingArea();
    }
    /// The area of a list, and the middle of a row; without such a row, a place below all rows.
    std::pair<QWidget*, QPoint> placeOf(const QString& list, const QString& row) const
    {
        for (auto* view : window_.window->findChildren<QAbstractItemView*>())
            if (view->accessibleName() == list) {
                const auto found = view->model()->match(view->model()->index(0, 0), Qt::DisplayRole,
                                                        row, 1, Qt::MatchExactly);
                if (!found.isEmpty())
                    view->scrollTo(found.front());
                return {view->viewport(), found.isEmpty()
                                              ? view->viewport()->rect().bottomLeft()
                                              : view->visualRect(found.front()).center()};
            }
        return {window_.drawingArea(), {}};
    }
    QWidget& area() const { return *window_.drawingArea(); }
    QPointF screen(const app::Point& p) const
    {
        const app::Point s = window_.window->canvas().view().toScreen(p);
        return QPointF(std::round(s.x), std::round(s.y));
    }
    static Drawn drawn(const app::Subpath& path)
    {
        Drawn drawn{{path.start}, path.closed};
        for (const app::PathSegment& s : path.segments) {
            if (s.curved)
                drawn.points.insert(drawn.points.end(), {s.control1, s.control2});
            drawn.points.push_back(s.to);
        }
        return drawn;
    }

    ui::TestWindow window_;
};

/// One thing that a person does.
struct Step {
    QString what;
    std::function<void(Player&)> play;
    int actions = 1; ///< as README.md counts them
};
using Steps = std::vector<Step>;

inline int actionsOf(const Steps& steps)
{
    int actions = 0;
    for (const Step& step : steps)
        actions += step.actions;
    return actions;
}

inline void add(Steps& steps, const Steps& more)
{
    steps.insert(steps.end(), more.begin(), more.end());
}

inline Step key(const QString& sequence)
{
    return {sequence, [sequence](Player& player) { player.key(sequence); }};
}
inline Step type(const char* text)
{
    return {QString::fromUtf8(text), [text](Player& player) { player.type(text); },
            int(std::strlen(text))};
}
inline Step enter() { return key("Return"); }
inline Step tab() { return key("Tab"); }
inline Step move(const app::Point& p, Qt::KeyboardModifiers with = {})
{
    return {"move", [p, with](Player& player) { player.move(p, {}, with); },
            with == Qt::NoModifier ? 0 : 1};
}
/// A drag through all of these points.
inline Step stroke(const std::vector<app::Point>& points)
{
    return {"stroke", [points](Player& player) { player.stroke(points); }};
}
inline Step click(const app::Point& p, Qt::KeyboardModifiers with = {})
{
    return {"click", [p, with](Player& player) { player.click(p, with); }};
}
inline Step doubleClick(const app::Point& p)
{
    return {"double click", [p](Player& player) { player.doubleClick(p); }, 2};
}
inline Step drag(const app::Point& from, const app::Point& to, Qt::KeyboardModifiers with = {})
{
    return {"drag", [from, to, with](Player& player) { player.drag(from, to, with); }};
}

inline Step dragGuide(int axis, const app::Point& to)
{
    return {"guide", [axis, to](Player& player) { player.dragGuide(axis, to); }};
}
inline Step press(const QString& toolTip)
{
    return {toolTip, [toolTip](Player& player) { player.press(toolTip); }};
}
inline Step clickField(const QString& name)
{
    return {"field " + name, [name](Player& player) { player.clickField(name); }};
}
inline Step clickList(const QString& name)
{
    return {"list " + name, [name](Player& player) { player.clickList(name); }};
}
inline Step clickRow(const QString& list, const QString& row, int fromRight = 0)
{
    return {"click " + row,
            [list, row, fromRight](Player& player) { player.clickRow(list, row, fromRight); }};
}
inline Step dragRow(const QString& list, const QString& row, const QString& onto)
{
    return {"drag " + row, [list, row, onto](Player& player) { player.dragRow(list, row, onto); }};
}

inline bool same(const Drawn& a, const Drawn& b)
{
    constexpr double most = 1e-9;
    const auto near = [](const app::Point& p, const app::Point& q) {
        return glm::distance(p, q) <= most;
    };
    const bool sameStyle = !a.style || !b.style || a.style == b.style;
    return a.closed == b.closed && sameStyle && std::ranges::equal(a.points, b.points, near);
}
inline bool same(const Table& a, const Table& b)
{
    return std::ranges::equal(a, b, [](const Drawn& p, const Drawn& q) { return same(p, q); });
}

inline QString text(const Drawn& path)
{
    QString text;
    for (const app::Point& p : path.points)
        text += QString("(%1, %2) ").arg(p.x, 0, 'g', 12).arg(p.y, 0, 'g', 12);
    text += path.closed ? "closed" : "";
    if (const auto& style = path.style)
        text += QString(" width %1, %2 dashes, colour %3 %4 %5")
                    .arg(style->width)
                    .arg(style->dashes.size())
                    .arg(style->stroke.value_or(app::Colour{}).red)
                    .arg(style->stroke.value_or(app::Colour{}).green)
                    .arg(style->stroke.value_or(app::Colour{}).blue);
    return text;
}
/// Four Bézier curves from the right, clockwise on screen.
inline Drawn circle(const app::Point& centre, double radius)
{
    const double r = radius, k = 4.0 / 3 * std::tan(std::numbers::pi / 8) * r;
    Drawn drawn{{}, true};
    for (const app::Point& p : std::initializer_list<app::Point>{{r, 0},
                                                                 {r, k},
                                                                 {k, r},
                                                                 {0, r},
                                                                 {-k, r},
                                                                 {-r, k},
                                                                 {-r, 0},
                                                                 {-r, -k},
                                                                 {-k, -r},
                                                                 {0, -r},
                                                                 {k, -r},
                                                                 {r, -k},
                                                                 {r, 0}})
        drawn.points.push_back(centre + p);
    return drawn;
}
/// The first path that is not as expected.
inline QString difference(const Table& drawn, const Table& expected)
{
    if (drawn.size() != expected.size())
        return QString("%1 paths instead of %2").arg(drawn.size()).arg(expected.size());
    for (std::size_t i = 0; i < drawn.size(); ++i)
        if (!same(drawn[i], expected[i]))
            return QString("path %1: %2\ninstead of %3")
                .arg(i + 1)
                .arg(text(drawn[i]), text(expected[i]));
    return {};
}

/// What `fault` says of a player who took all steps but one.
using Fault = std::function<QString(const Player&)>;
inline QString faultOf(const Steps& steps, const Fault& fault,
                       std::optional<std::size_t> without = {})
{
    Player player;
    for (std::size_t i = 0; i < steps.size(); ++i)
        if (i != without)
            steps[i].play(player);
    return fault(player);
}

/// The actions of a task according to the table of README.md; empty: it is not in the table.
inline std::optional<int> listedActions(QString task)
{
    static const QRegularExpression capital(QStringLiteral("([A-Z])"));
    task = task.replace(capital, QStringLiteral("_\\1")).toLower();
    QFile file(QStringLiteral(SOURCE_DIR "/tests/ui/tasks/README.md"));
    if (!file.open(QIODevice::ReadOnly))
        return -1;
    const QRegularExpression row(QStringLiteral("\n\\| `%1` \\| (\\d+) \\|").arg(task));
    const auto found = row.match(QString::fromUtf8(file.readAll()));
    return found.hasMatch() ? std::optional(found.captured(1).toInt()) : std::nullopt;
}

/// Plays the task, and plays it again without each of its steps (each tenth). `fault` says what is
/// wrong, nothing only after all steps.
inline void checkPlayer(const Steps& steps, const Fault& fault)
{
    if (const auto listed = listedActions(QTest::currentTestFunction()))
        QCOMPARE(actionsOf(steps), *listed);
    const QString wrong = faultOf(steps, fault);
    QVERIFY2(wrong.isEmpty(), qPrintable(wrong));
    for (std::size_t i = 0; i < steps.size(); i += tests::caseStep())
        QVERIFY2(!faultOf(steps, fault, i).isEmpty(),
                 qPrintable(QString("step %1 (%2) is not needed").arg(i + 1).arg(steps[i].what)));
}
/// The same for what is drawn.
inline void checkBy(const Steps& steps, const std::function<QString(const Table&)>& fault)
{
    checkPlayer(steps, [&](const Player& player) { return fault(player.drawn()); });
}
inline void check(const Steps& steps, const Table& expected)
{
    checkBy(steps, [&](const Table& drawn) { return difference(drawn, expected); });
}
/// The last path of the table is the page (Player::page).
inline void checkWithPage(const Steps& steps, const Table& expected)
{
    checkPlayer(steps, [&](const Player& player) {
        Table drawn = player.drawn();
        drawn.push_back(player.page());
        return difference(drawn, expected);
    });
}

} // namespace tasks
