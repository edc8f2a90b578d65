// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/setting.h"

#include "app/base/text.h"
#include "app/session/open_drawings.h"
#include "ui/editing/editing.h"
#include "ui/look/text.h"
#include "ui/widgets/unit_box.h"
#include "ui/window/main_window.h"

#include <algorithm>
#include <array>

namespace ui {

namespace {

Setting theme()
{
    return {
        .key = QStringLiteral("theme"),
        .text = Text::tr("Theme"),
        .tip = Text::tr("The colours of panels and bars. The paper stays white."),
        .choices = {{{}, Text::tr("As the desktop")},
                    {{}, Text::tr("Light")},
                    {{}, Text::tr("Dark")}},
        .value = [](const MainWindow& w) { return int(w.theme()); },
        .set = [](MainWindow& w, int value) { w.setTheme(Theme(value)); },
        .standard = [](const MainWindow&) { return int(Theme::System); },
        .isOnlyHere = false,
    };
}

Setting darkPaper()
{
    return {
        .key = QStringLiteral("dark-paper"),
        .text = Text::tr("Dark paper in the dark theme"),
        .value = [](const MainWindow& w) { return int(w.session().display().darkPaper); },
        .set =
            [](MainWindow& w, int value) {
                w.session().changeDisplay(
                    [value](app::Display& display) { display.darkPaper = value; });
            },
        .standard = [](const MainWindow&) { return 0; },
        .isOnlyHere = false,
    };
}

Setting capsule()
{
    Setting setting{
        .key = QStringLiteral("capsule"),
        .text = Text::tr("Capsule"),
        .tip = Text::tr("The controls of a chosen clip window or of selected objects"),
        .value = [](const MainWindow& w) { return int(w.canvas().capsuleHome()); },
        .set =
            [](MainWindow& w, int value) {
                w.canvas().setCapsuleHome(app::capsuleHomes()[std::size_t(value)].home);
            },
        .standard = [](const MainWindow&) { return int(app::CapsuleHome::AtObject); },
    };
    for (const app::CapsuleHomeInfo& each : app::capsuleHomes())
        setting.choices.push_back({QStringLiteral("capsule-") + app::latin(each.key), each.name});
    return setting;
}

int numberOf(app::Unit unit)
{
    const auto units = shownUnits();
    const auto found = std::ranges::find(units, unit);
    return found == units.end() ? -1 : int(found - units.begin());
}

/// A drawing that is opened brings its own.
Setting unit()
{
    Setting setting{
        .key = QStringLiteral("unit"),
        .text = Text::tr("Unit"),
        .tip = Text::tr("The unit of rulers and fields for the open drawing"),
        .value = [](const MainWindow& w) { return numberOf(w.session().display().unit); },
        .set =
            [](MainWindow& w, int value) {
                w.session().changeDisplay([value](app::Display& display) {
                    display.unit = shownUnits()[std::size_t(value)];
                });
            },
        .standard =
            [](const MainWindow& w) { return numberOf(w.session().now().page().usualUnit()); },
        .reset =
            [](MainWindow& w) {
                w.session().changeDisplay([&w](app::Display& display) {
                    display.unit = w.session().now().page().usualUnit();
                });
            },
    };
    for (const app::Unit each : shownUnits()) {
        const QString suffix = app::latin(app::infoOf(each).suffix);
        setting.choices.push_back({QStringLiteral("unit-") + suffix, suffix});
    }
    return setting;
}

Setting snapping()
{
    return {
        .key = QStringLiteral("snap"),
        .text = Text::tr("Snap to places of the drawing"),
        .tip = Text::tr("Hold Ctrl to suspend it"),
        .value = [](const MainWindow& w) { return int(w.canvas().snaps()); },
        .set = [](MainWindow& w, int value) { w.canvas().switchSnapping(value); },
        .standard = [](const MainWindow&) { return 1; },
        .isOnlyHere = false,
    };
}

Setting snapKind(const app::SnapKind& kind)
{
    return {
        .key = QStringLiteral("snap-to-") + app::latin(kind.key),
        .text = kind.name,
        .command = Text::tr("Snap to: %1").arg(kind.name),
        .value = [&kind](const MainWindow& w) { return int(w.canvas().snapping().has(kind)); },
        .set =
            [&kind](MainWindow& w, int value) {
                const app::SnapTo now = w.canvas().snapping();
                w.canvas().setSnapping(value ? now.with(kind.key) : now.without(kind.key));
            },
        .standard = [&kind](const MainWindow&) { return int(app::SnapTo::usual().has(kind)); },
        .counts = [](const MainWindow& w) { return w.canvas().snaps(); },
    };
}

constexpr std::array undoMemories{250, 1000, 4000, 16'000}; // megabytes

/// When the steps to undo need more, the oldest ones go.
Setting undoMemory()
{
    return {
        .key = QStringLiteral("undo-memory"),
        .text = Text::tr("Memory for undo"),
        .tip = Text::tr("If the steps to undo need more, the oldest ones are forgotten"),
        .choices = {{QStringLiteral("undo-memory-250"), Text::tr("250 MB")},
                    {QStringLiteral("undo-memory-1000"), Text::tr("1 GB")},
                    {QStringLiteral("undo-memory-4000"), Text::tr("4 GB")},
                    {QStringLiteral("undo-memory-16000"), Text::tr("16 GB")}},
        .value =
            [](const MainWindow&) {
                const auto found = std::ranges::find(undoMemories, undoMegabytes());
                return found == undoMemories.end() ? -1 : int(found - undoMemories.begin());
            },
        .set =
            [](MainWindow& w, int value) {
                const int megabytes = undoMemories[std::size_t(value)];
                setUndoMegabytes(megabytes);
                w.session().history.setLimit(bytesOf(megabytes));
            },
        .standard = [](const MainWindow&) { return 1; },
    };
}

Setting reopenDrawings()
{
    return {
        .key = QStringLiteral("reopen-drawings"),
        .text = Text::tr("Open the same drawings again"),
        .tip = Text::tr("Each drawing is read when its tab is first shown"),
        .value = [](const MainWindow&) { return int(app::reopensDrawings(QSettings())); },
        .set =
            [](MainWindow&, int value) {
                QSettings settings;
                app::setReopensDrawings(settings, value);
            },
        .standard = [](const MainWindow&) { return 1; },
    };
}

std::vector<Setting> snappings()
{
    std::vector<Setting> all{snapping()};
    for (const app::SnapKind& kind : app::snapKinds())
        all.push_back(snapKind(kind));
    return all;
}

} // namespace

// THE CATALOGUE. To add a setting: add its function above, and its row.
const std::vector<SettingsGroup>& settingsGroups()
{
    static const std::vector<SettingsGroup> all{
        {Text::tr("Appearance"), {theme(), darkPaper(), capsule()}},
        {Text::tr("Lengths of this drawing"), {unit()}},
        {Text::tr("Start"), {reopenDrawings()}},
        {Text::tr("Undo"), {undoMemory()}},
        {Text::tr("Snapping"), snappings()},
    };
    return all;
}

void change(const Setting& setting, MainWindow& window, int value)
{
    if (value < 0)
        return;
    setting.set(window, value);
    window.refreshActions();
}

void reset(const Setting& setting, MainWindow& window)
{
    if (!setting.reset)
        return change(setting, window, setting.standard(window));
    setting.reset(window);
    window.refreshActions();
}

} // namespace ui
