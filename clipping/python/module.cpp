// SPDX-License-Identifier: MIT
#include "clipping/python/module.h"

PYBIND11_MODULE(_clearcut, module)
{
    module.doc() = "The clipping library of Clearcut. Use clearcut.";
    clipping::python::defineArguments(module);
    clipping::python::defineClip(module);
    clipping::python::definePolylines(module);
    clipping::python::defineWkb(module);
    clipping::python::defineChunks(module);
    clipping::python::defineCatalogue(module);
}
