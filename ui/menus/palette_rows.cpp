// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/palette_rows.h"

#include "app/session/named_things.h"
#include "app/session/window_values.h"
#include "app/session/window_words.h"
#include "app/teaching/manual.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/menus/menu_rows.h"
#include "ui/menus/other_windows.h"
#include "ui/window/keyboard.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPointer>
#include <QSettings>

#include <algorithm>
#include <tuple>

namespace ui {
namespace {

constexpr qsizetype mostRemembered = 10;
constexpr std::size_t mostOfDrawing = 50;
constexpr std::chrono::milliseconds searchTime{4};

QString plain(QString text)
{
    const QString both = QStringLiteral("&&"), kept(QChar::Null);
    return text.replace(both, kept).remove(u'&').replace(kept, QStringLiteral("&"));
}

PaletteRow rowOf(MainWindow& window, QAction* action, const QString& menu)
{
    PaletteRow row{.key = action->objectName(),
                   .icon = action->icon(),
                   .name = plain(action->text()),
                   .what = menu,
                   .enabled = action->isEnabled()};
    row.note =
        row.enabled ? action->shortcut().toString(QKeySequence::NativeText) : action->statusTip();
    row.run = [action = QPointer(action)] {
        if (action)
            action->trigger();
    };
    // "Dark" of the submenu "Theme", a layer of "Move to layer".
    const QStringList path = menu.split(QStringLiteral(" › "));
    if (path.size() > 1 && row.icon.isNull() && (action->isCheckable() || row.key.isEmpty()))
        row.before = path.last();
    // The name of a panel brings it to the front; its entry in the menu would close it.
    if (const auto* panel = qobject_cast<QDockWidget*>(action->parent())) {
        row.key = QStringLiteral("panel ") + panel->objectName();
        row.run = [&window, key = panel->objectName()] { window.raisePanel(key); };
    }
    return row;
}

void addCommands(MainWindow& window, const QWidget& menu, const QString& path,
                 std::vector<PaletteRow>& rows)
{
    for (QAction* action : menu.actions()) {
        if (QMenu* submenu = action->menu()) {
            emit submenu->aboutToShow(); // some are filled then: recent files, layers
            addCommands(window, *submenu,
                        path.isEmpty() ? plain(action->text())
                                       : path + QStringLiteral(" › ") + plain(action->text()),
                        rows);
        } else if (!action->isSeparator() && !action->text().isEmpty()) {
            rows.push_back(rowOf(window, action, path));
        }
    }
}

QStringList rememberedKeys() { return QSettings().value("palette/recent").toStringList(); }

PaletteRow pageRow(OtherWindows& others, const QString& topic)
{
    const auto page = app::manualPage(topic);
    return {.part = PaletteRow::Part::Help,
            .key = QStringLiteral("page ") + topic,
            .icon = icon("book"),
            .name = page ? page->title : topic,
            .what = Text::tr("page of the manual"),
            .run = [&others, topic] { others.showManual(topic); }};
}

/// The rows that fit: what can be run first, of this the best, of these what was run lately. Last
/// come those that are found only with their menu ("clip crop").
std::vector<PaletteRow> fitting(const std::vector<PaletteRow>& rows, const QString& typed)
{
    std::vector<PaletteRow> found;
    for (const PaletteRow& row : rows) {
        auto match = app::matchName(typed, row.name);
        const auto whole = match ? std::nullopt : app::matchName(typed, row.what + u' ' + row.name);
        if (whole && whole->score > 1)
            match.emplace(); // below all others
        if (!match)
            continue;
        found.push_back(row);
        found.back().match = std::move(*match);
    }
    const QStringList keys = rememberedKeys();
    const auto rank = [&keys](const PaletteRow& row) {
        return std::tuple(row.match.score > 0, row.enabled, row.match.score,
                          !row.key.isEmpty() && keys.contains(row.key));
    };
    std::ranges::stable_sort(found, std::greater(), rank);
    return found;
}

QIcon iconOfThing(const app::Session& session, const app::NamedThing& thing)
{
    if (thing.kind == app::NamedThing::Kind::Window)
        return icon(app::iconOf(session.windows().list[thing.number].shape));
    return icon(thing.kind == app::NamedThing::Kind::Object ? "select" : "list");
}

PaletteRow rowOf(MainWindow& window, const app::NamedThing& thing)
{
    return {.part = PaletteRow::Part::Drawing,
            .icon = iconOfThing(window.session(), thing),
            .name = thing.name,
            .what = thing.what,
            .note = thing.remark,
            .enabled = thing.remark.isEmpty(),
            .match = thing.match,
            .run = [&window, thing] {
                const app::Session& session = window.session();
                if (!app::chooseThing(window.session(), thing))
                    return;
                if (thing.kind == app::NamedThing::Kind::Window)
                    showIfUnseen(window.canvas(), session.clipWindow(), &Canvas::fitWindow);
                else
                    showIfUnseen(window.canvas(), session.selectionBounds(), &Canvas::fitSelection);
            }};
}

/// "120 mm": the width of the chosen clip window.
std::vector<PaletteRow> widthRow(MainWindow& window, const QString& typed)
{
    constexpr double most = 1e9; // as in fields
    app::Session& session = window.session();
    const double size = session.now().page().realMillimetresPerUnit();
    const app::Unit unit = session.display().unit;
    const auto length = app::typedLength(typed, {unit, size});
    const auto number = session.windowNumber();
    if (!length || !(*length.value >= 0 && *length.value <= most) || !number)
        return {};
    const double width = app::fromUnit(*length.value, unit, size);
    return {{.icon = icon("window"),
             .name = Text::tr("Set width of %1").arg(app::nameOf(session.windows().list[*number])),
             .what = app::lengthText(width, unit, size),
             .run = [&session, number, width] {
                 if (session.windowNumber() == number)
                     app::setWindowValue(session, app::WindowValue::Width, width, false,
                                         app::Merging::Never);
             }}};
}

} // namespace

PaletteRows::PaletteRows(MainWindow& window, OtherWindows& others) : window_(window)
{
    addCommands(window, *window.menuBar(), {}, commands_);
    addCommands(window, furtherCommands(window), {}, commands_);
    for (const QString& topic : app::manualTopics())
        pages_.push_back(pageRow(others, topic));
}

std::vector<PaletteRow> PaletteRows::recent() const
{
    std::vector<PaletteRow> found;
    for (const QString& key : rememberedKeys())
        for (const auto* rows : {&commands_, &pages_}) {
            const auto row = std::ranges::find(*rows, key, &PaletteRow::key);
            if (row == rows->end() || key.isEmpty() || qsizetype(found.size()) == mostRemembered)
                continue;
            found.push_back(*row);
            found.back().isRecent = true;
        }
    std::ranges::stable_sort(found, std::greater(), &PaletteRow::enabled);
    return found;
}

std::vector<PaletteRow> PaletteRows::ofDrawing(const QString& typed) const
{
    std::vector<PaletteRow> rows;
    const auto things = app::thingsNamed(window_.session(), typed, mostOfDrawing, searchTime);
    for (const app::NamedThing& thing : things.list)
        rows.push_back(rowOf(window_, thing));
    std::ranges::stable_sort(rows, std::greater(), &PaletteRow::enabled);
    if (!things.isAll)
        rows.push_back({.part = PaletteRow::Part::Drawing,
                        .name = Text::tr("Not all objects were looked at"),
                        .note = Text::tr("Edit › Find… finds all"),
                        .enabled = false});
    return rows;
}

std::vector<PaletteRow> PaletteRows::matching(const QString& typed,
                                              std::optional<PaletteRow::Part> only) const
{
    if (typed.trimmed().isEmpty() && !only)
        if (std::vector<PaletteRow> last = recent(); !last.empty())
            return last;
    std::vector<PaletteRow> all;
    const auto append = [&](PaletteRow::Part part, auto rows) {
        if (only.value_or(part) == part)
            all.insert(all.end(), std::make_move_iterator(rows.begin()),
                       std::make_move_iterator(rows.end()));
    };
    append(PaletteRow::Part::Commands, widthRow(window_, typed));
    append(PaletteRow::Part::Commands, fitting(commands_, typed));
    append(PaletteRow::Part::Drawing, ofDrawing(typed));
    append(PaletteRow::Part::Help, fitting(pages_, typed));
    return all;
}

void PaletteRows::remember(const PaletteRow& row) const
{
    if (row.key.isEmpty())
        return;
    QStringList keys = rememberedKeys();
    keys.removeAll(row.key);
    keys.prepend(row.key);
    QSettings().setValue("palette/recent", QStringList(keys.mid(0, mostRemembered)));
}

} // namespace ui
