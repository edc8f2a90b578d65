// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut_images.h"

#include "app/scene/kept_box.h"

namespace app {

void cutImages(Cut& cut, const Document& document, const CutOptions& options)
{
    const Containers& before = document.containers();
    if (options.leaveImages)
        return;
    for (const ContainerId id : before.underlaid()) {
        if ((options.leaveLocked && before.locked(id))
            || (options.leaveHidden && !before.shown(id)))
            continue;
        Container layer = before[id];
        const SharedUnderlay left = keptOf(layer.underlay, options.region);
        if (left && !isCutExactly(*left, options.region))
            ++(keptBox(options.region) ? cut.counts.imagesUncut : cut.counts.imagesWhole);
        if (left == layer.underlay)
            continue;
        ++(left ? cut.counts.imagesCut : cut.counts.imagesGone);
        layer.underlay = left;
        cut.edit.containers = cut.edit.containers.value_or(before).with(layer);
    }
}

} // namespace app
