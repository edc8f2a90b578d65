// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene.h"

#include "app/document/flatten.h"

#include <utility>

namespace app {

static bool update(SceneBlockCache& blocks, const Document& document)
{
    return blocks.update(document.objects(), document.containers().hiddenRanges(),
                         usualTolerance(document.page()));
}

SceneBlockCache blocksFor(const Document& document)
{
    SceneBlockCache blocks;
    update(blocks, document);
    return blocks;
}

Scene::Scene(const EditedDocument& document, QObject* parent) : QObject(parent), document_(document)
{
    connect(&document, &EditedDocument::changed, this, [this](const DocumentChange& change) {
        if (change.drawing())
            update();
        emit outdated();
    });
    update();
}

void Scene::expect(SceneBlockCache blocks)
{
    blocks_ = std::move(blocks);
    expects_ = true;
}

void Scene::update()
{
    SceneBlockCache next = blocks_; // if memory runs out, nothing has changed
    const bool changed = app::update(next, document_.now());
    if (changed || expects_)
        lines_ = SceneLines(next.blocks());
    blocks_ = std::move(next);
    expects_ = false;
}

} // namespace app

#include "moc_scene.cpp"
