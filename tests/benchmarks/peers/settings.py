# SPDX-License-Identifier: GPL-3.0-or-later
"""What each program is run with: the list to change where a better setting is found. From coarse to fine."""
import functools

import abut_peer
import calculix
import getfem_peer
from gmsh_mesh import MeshSettings

ERROR_LEVELS = {"hertz": (0.03, 0.01, 0.003), "cattaneo": (0.05, 0.02, 0.01)}

# draft, standard and fine aim at 0.05, 0.01 and 0.002
HERTZ_ABUT = [abut_peer.Settings(accuracy) for accuracy in ("0.05", "0.03", "0.02", "0.01", "0.006", "0.003")]

# The size grows by 0.5 to 0.8 per distance: smaller growth costs unknowns and gains nothing. 50 E/a leaves an error of about
# half a per cent on any mesh, hence the stiffer penalty on the finer ones.
HERTZ_CALCULIX = [
    calculix.Settings(MeshSettings(3, growth=0.8)),
    calculix.Settings(MeshSettings(6, growth=0.8)),
    calculix.Settings(MeshSettings(12, growth=0.8)),
    calculix.Settings(MeshSettings(24, growth=0.5), penalty=200),
    calculix.Settings(MeshSettings(48, growth=0.5), penalty=200),
]

HERTZ_GETFEM = [
    getfem_peer.Settings(MeshSettings(6, growth=0.8), augmentation=10),
    getfem_peer.Settings(MeshSettings(12, growth=0.8), augmentation=10),
    getfem_peer.Settings(MeshSettings(24, growth=0.5), augmentation=10),
    getfem_peer.Settings(MeshSettings(48, growth=0.5), augmentation=10),
    getfem_peer.Settings(MeshSettings(80, growth=0.5), augmentation=10),
]

CATTANEO_ABUT = [abut_peer.Settings(accuracy) for accuracy in ("0.05", "0.02", "0.01", "0.006", "0.003")]

sheared = functools.partial(calculix.Settings, source="contact stress")

# Twice the stiffness on a/24 and four times on a/48, as for the pressure; eight-node elements cost less on coarse meshes.
CATTANEO_CALCULIX = [
    sheared(MeshSettings(6, growth=0.8, quads=True)),
    sheared(MeshSettings(6, growth=0.8)),
    sheared(MeshSettings(12, growth=0.8, quads=True)),
    sheared(MeshSettings(24, growth=0.5), penalty=100),
    sheared(MeshSettings(48, growth=0.5), penalty=200),
]

# 30 E/a does not converge on the coarsest mesh.
CATTANEO_GETFEM = [
    getfem_peer.Settings(MeshSettings(6, growth=0.8), augmentation=10),
    getfem_peer.Settings(MeshSettings(12, growth=0.8), augmentation=30),
    getfem_peer.Settings(MeshSettings(24, growth=0.8), augmentation=30),
    getfem_peer.Settings(MeshSettings(48, growth=0.5), augmentation=30),
    getfem_peer.Settings(MeshSettings(48, growth=0.35), augmentation=30),
    getfem_peer.Settings(MeshSettings(80, growth=0.35), augmentation=30),
]

PROGRAMS = {"abut": abut_peer, "CalculiX": calculix, "GetFEM": getfem_peer}
SETTINGS = {
    "hertz": {"abut": HERTZ_ABUT, "CalculiX": HERTZ_CALCULIX, "GetFEM": HERTZ_GETFEM},
    "cattaneo": {"abut": CATTANEO_ABUT, "CalculiX": CATTANEO_CALCULIX, "GetFEM": CATTANEO_GETFEM},
}
EXPECTED = {"CalculiX": 50, "GetFEM": 20}  # times faster, at equal error
