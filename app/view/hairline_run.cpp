// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/hairline_run.h"

namespace app {

void HairlineRun::add(const Hairline& line, const Colour& colour)
{
    if (colour != colour_)
        flush();
    colour_ = colour;
    if (inTiles_)
        return tiles_->add(line, colour);
    lines_.push_back(line);
    if (lines_.size() <= few)
        return;
    if (!tiles_)
        tiles_.emplace(image_.width(), Band{0, image_.height()});
    for (const Hairline& each : lines_)
        tiles_->add(each, colour);
    lines_.clear();
    inTiles_ = true;
}

void HairlineRun::flush()
{
    if (inTiles_)
        tiles_->paintOn(image_);
    inTiles_ = false;
    for (const Hairline& line : lines_)
        paintHairline(image_, 0, line, colour_);
    lines_.clear();
}

} // namespace app
