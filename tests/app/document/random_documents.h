// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document_builder.h"

#include "tests/app/document/random_sheets.h"
#include "tests/app/document/test_image.h"

/// Documents with layers in layers and groups in groups, and edits of them.
class RandomDocuments : public RandomSheets {
public:
    using RandomSheets::RandomSheets;

    app::Object object()
    {
        const app::Shape made = shape(0);
        return {app::Path(made.paths),
                made.style,
                {.id = made.id, .title = note("title"), .description = note("desc")},
                made.hidden};
    }

    app::ClipWindows windows()
    {
        app::ClipWindows windows;
        for (auto n = below(4); n > 0; --n) {
            windows.list.push_back(
                {text(), windowShape(), app::WindowOperation(below(4)), below(2) == 0});
            if (n % 2 == 0) // draws nothing: the page of each seed, and so its scale, stays
                windows.list.back().colour = app::Colour{1, 2, std::uint8_t(n)};
        }
        windows.keep = app::Keep(below(2));
        return windows;
    }

    app::Document document(std::size_t objects)
    {
        app::DocumentBuilder builder;
        const auto mostOpen = int(1 + below(5));
        while (builder.size() < objects) {
            const auto act = below(10);
            if (builder.depth() == 0 || (act == 0 && builder.depth() < mostOpen)) {
                open(builder);
            } else if (act == 1) {
                builder.close();
                inGroup_.pop_back();
            } else {
                builder.add(object());
            }
        }
        for (; builder.depth() > 0; inGroup_.pop_back())
            builder.close();
        return builder.take(page(), {text(), {}, {}, {}, {}}, windows());
    }

    /// One that exchanges objects in some places, and changes containers, windows and the page.
    app::Edit edit(const app::Document& document)
    {
        app::Edit edit;
        app::Containers tree = document.containers();
        if (below(16) == 0)
            removeContainer(edit, tree);
        else if (below(4) > 0)
            exchangeObjects(edit, tree);
        while (below(3) == 0)
            tree = changed(tree);
        if (edit.splices.empty() || below(8) > 0 || tree.objects() != document.objects().size())
            edit.containers = tree;
        if (below(4) == 0)
            edit.windows = windows();
        if (below(4) == 0)
            edit.page = page();
        return edit;
    }

    /// With another name or visibility, a group more, or a container dissolved.
    app::Containers changed(const app::Containers& tree)
    {
        const auto all = tree.inOrder();
        const app::ContainerId id = all[below(all.size())];
        const auto act = below(3);
        if (act == 0)
            return grouped(tree, id);
        if (act == 1 && tree.parentOf(id) != 0)
            return tree.dissolved(id);
        app::Container other = container(false);
        other.id = id;
        other.kind = tree[id].kind;
        if (other.kind == app::Container::Kind::Group)
            other.underlay = {};
        return tree.with(other);
    }

private:
    app::WindowShape windowShape()
    {
        if (below(2) == 0)
            return app::RectangleShape{{point(), point()}, number()};
        return app::PathShape{object().path, app::FillRule(below(2))};
    }

    // XML; of few.
    QString note(const QString& element)
    {
        static const QStringList contents{"A &amp; B", "<b>B</b>", "two\nlines", "図層 😀"};
        if (below(8) > 0)
            return {};
        const QString& content = contents[qsizetype(below(std::size_t(contents.size())))];
        return QStringLiteral("<%1>%2</%1>").arg(element, content);
    }

    void open(app::DocumentBuilder& builder)
    {
        const bool around = !inGroup_.empty() && inGroup_.back();
        inGroup_.push_back(around || (builder.depth() > 0 && below(2) == 0));
        builder.open(container(inGroup_.back()));
    }

    app::Container container(bool group)
    {
        using Kind = app::Container::Kind;
        app::Container made{.kind = group ? Kind::Group : Kind::Layer,
                            .name = group && below(2) ? QString() : text(),
                            .svgId = below(2) ? text() : QString(),
                            .title = note("title"),
                            .description = note("desc"),
                            .visible = below(4) > 0,
                            .locked = below(4) == 0};
        if (made.locked)
            made.newStyle = made.name;
        // Without a draw, so that the rest of each seed stays.
        if (made.kind == Kind::Layer && made.name.size() % 4 == 1)
            made.underlay = testUnderlay({double(made.name.size()), 0.1}, made.visible ? 0.3 : 2);
        return made;
    }

    // A new object now and then comes to a place where none goes; then there is only that one.
    void exchangeObjects(app::Edit& edit, app::Containers& tree)
    {
        const auto count = std::uint32_t(tree.objects());
        std::uint32_t at = 0, added = 0;
        app::ContainerId into = 0;
        if (count == 0 || below(4) == 0) {
            const auto first = std::uint32_t(below(count + 1));
            into = count == 0 ? tree.childrenOf(0).front()
                              : tree.containerOf(first < count ? first : count - 1);
            edit.splices = {{first, 0, std::uint32_t(1 + below(5))}};
            added = edit.splices[0].added;
        } else {
            for (auto n = 1 + below(6); n > 0 && at < count; --n) {
                const auto first = std::uint32_t(at + below(count - at));
                const auto removed = std::uint32_t(1 + below(std::min(count - first, 6U)));
                edit.splices.push_back({first, removed, std::uint32_t(below(6))});
                added += edit.splices.back().added;
                at = first + removed;
            }
        }
        for (; added > 0; --added)
            edit.objects.append(object());
        tree = tree.spliced(edit.splices, into);
    }

    // With all that is in it.
    void removeContainer(app::Edit& edit, app::Containers& tree)
    {
        const auto all = tree.inOrder();
        const app::ContainerId id = all[below(all.size())];
        if (tree.parentOf(id) == 0 && tree.childrenOf(0).size() == 1)
            return;
        const auto range = tree.rangeOf(id);
        if (!range.empty())
            edit.splices = {{std::uint32_t(range.first), std::uint32_t(range.size()), 0}};
        tree = tree.removed(id);
    }

    // With a group around some of the container's own objects that follow each other.
    app::Containers grouped(const app::Containers& tree, app::ContainerId parent)
    {
        std::size_t first = tree.rangeOf(parent).first, at = 0;
        const auto children = tree.childrenOf(parent);
        for (; at < children.size() && below(2) == 0; ++at)
            first = tree.rangeOf(children[at]).end;
        const std::size_t end =
            at < children.size() ? tree.rangeOf(children[at]).first : tree.rangeOf(parent).end;
        if (first == end)
            return tree;
        first += below(end - first);
        const std::size_t last = first + 1 + below(end - first);
        return tree.inserted(container(true), parent, at, {first, last}).value_or(tree);
    }

    std::vector<bool> inGroup_; // of each container that is open
};
