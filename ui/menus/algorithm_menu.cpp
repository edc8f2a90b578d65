// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/menus/algorithm_menu.h"

#include "app/base/text.h"
#include "app/session/comparing.h"
#include "ui/docks/difference_panel.h"
#include "ui/look/text.h"
#include "ui/window/main_window.h"

#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>

namespace ui {
namespace {

using app::Variant;
using clipping::Form;

void use(MainWindow& window, const Variant& variant) { app::useVariant(window.session(), variant); }

/// Opens the panel Differences with the variant as A or as B; the other one stays.
void compareAs(MainWindow& window, const Variant& variant, bool asA)
{
    window.raisePanel(QStringLiteral("difference"));
    const auto& asked = window.session().differences.asked();
    const Variant a = asked ? asked->a : app::exactVariant();
    const Variant b = asked ? asked->b : app::exactVariant();
    // Both being the same, they change places.
    asA ? window.differencePanel().compare(variant, variant == b ? a : b)
        : window.differencePanel().compare(variant == a ? b : a, variant);
}

/// The pane after the active one gets the variant; a second pane is opened if there is only one.
void showInPane(MainWindow& window, const Variant& variant)
{
    app::Panes panes = window.canvas().panes();
    const std::size_t active = panes.active();
    panes.show(std::max<std::size_t>(2, panes.size()));
    panes.activate((active + 1) % panes.size());
    panes.choose(variant);
    panes.activate(active);
    window.canvas().setPanes(panes);
}

void addUses(MainWindow& window, const clipping::Algorithm& algorithm, QMenu& menu)
{
    const Variant now = window.session().variant(), cuts = window.session().cuts();
    const auto add = [&](const QString& text, Form form) {
        if (const Variant variant{&algorithm, form}; variant != now || variant != cuts)
            menu.addAction(text, &window, [&window, variant] { use(window, variant); })
                ->setObjectName(form == Form::Corrected ? "use-corrected" : "use-published");
    };
    add(algorithm.published ? Text::tr("Use &corrected form") : Text::tr("&Use"), Form::Corrected);
    if (algorithm.published)
        add(Text::tr("Use &published form"), Form::Published);
    menu.addSeparator();
}

void addComparisons(MainWindow& window, const Variant& variant, QMenu& menu)
{
    for (const bool asA : {true, false})
        menu.addAction(asA ? Text::tr("Compare as &A") : Text::tr("Compare as &B"), &window,
                       [&window, variant, asA] { compareAs(window, variant, asA); })
            ->setObjectName(asA ? "compare-as-a" : "compare-as-b");
    const auto choices = window.canvas().panes().choices();
    if (std::ranges::find(choices, variant) == choices.end())
        menu.addAction(Text::tr("&Show in another pane"), &window,
                       [&window, variant] { showInPane(window, variant); })
            ->setObjectName("show-in-pane");
    menu.addSeparator();
}

} // namespace

QMenu* algorithmMenu(MainWindow& window, const clipping::Algorithm& algorithm)
{
    auto* menu = new QMenu(&window);
    menu->setObjectName(QStringLiteral("algorithm-menu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const QString name = app::latin(algorithm.name);
    const Variant now = window.session().variant();
    addUses(window, algorithm, *menu);
    addComparisons(window, app::usable({&algorithm, now.form}), *menu);
    menu->addAction(Text::tr("&About %1").arg(name), &window,
                    [&window, &algorithm] { emit window.explanationWanted(algorithm); })
        ->setObjectName("about-algorithm");
    menu->addAction(Text::tr("Copy &name"), &window,
                    [name] { QGuiApplication::clipboard()->setText(name); })
        ->setObjectName("copy-name");
    return menu;
}

} // namespace ui
