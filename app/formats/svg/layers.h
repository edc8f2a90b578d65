// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/sheet.h"

#include <optional>

namespace app::svg {

/// Puts shapes into layers in the order in which they are painted. A file may nest layers and
/// paint loose shapes between them; a sheet has a plain list, in which shapes never go back to a
/// lower layer. So what comes above another layer begins a further layer of nearly the same name.
class Layers {
public:
    explicit Layers(Sheet& sheet);

    void open(const Layer& layer); ///< kept even if nothing is drawn in it
    void close();
    void add(Shape shape); ///< on top of all others
    void finish();         ///< a sheet has at least one layer

    bool merged() const { return merged_; } ///< there were too many layers

private:
    struct Open {
        Layer layer;
        std::optional<std::size_t> index; ///< of its last part in the sheet
        int parts = 0;
    };
    void begin(Open& open);

    Sheet& sheet_;
    std::vector<Open> open_; ///< the first one is for loose shapes
    bool merged_ = false;
};

} // namespace app::svg
