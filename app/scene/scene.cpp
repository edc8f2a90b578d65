// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene.h"

#include "app/document/flatten.h"

namespace app {

Scene::Scene(const EditedDocument& document, QObject* parent) : QObject(parent), document_(document)
{
    connect(&document, &EditedDocument::changed, this, [this](const DocumentChange& change) {
        if (change.drawing())
            update();
        emit outdated();
    });
    update();
}

void Scene::update()
{
    const Document& now = document_.now();
    blocks_.update(now.objects(), now.containers().hiddenRanges(), usualTolerance(now.page()));
}

} // namespace app
