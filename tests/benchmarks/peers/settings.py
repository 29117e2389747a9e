# SPDX-License-Identifier: GPL-3.0-or-later
"""What each program is run with: the list to change where a better setting is found. From coarse to fine."""
import abut_peer
import calculix
import getfem_peer
from gmsh_mesh import MeshSettings

ERROR_LEVELS = (0.03, 0.01, 0.003)

# draft, standard and fine aim at 0.05, 0.01 and 0.002
ABUT = [abut_peer.Settings(accuracy) for accuracy in ("0.05", "0.03", "0.02", "0.01", "0.006", "0.003")]

# The size grows by 0.5 to 0.8 per distance: smaller growth costs unknowns and gains nothing. 50 E/a leaves an error of about
# half a per cent on any mesh, hence the stiffer penalty on the finer ones.
CALCULIX = [
    calculix.Settings(MeshSettings(3, growth=0.8)),
    calculix.Settings(MeshSettings(6, growth=0.8)),
    calculix.Settings(MeshSettings(12, growth=0.8)),
    calculix.Settings(MeshSettings(24, growth=0.5), penalty=200),
    calculix.Settings(MeshSettings(48, growth=0.5), penalty=200),
]

GETFEM = [
    getfem_peer.Settings(MeshSettings(6, growth=0.8), augmentation=10),
    getfem_peer.Settings(MeshSettings(12, growth=0.8), augmentation=10),
    getfem_peer.Settings(MeshSettings(24, growth=0.5), augmentation=10),
    getfem_peer.Settings(MeshSettings(48, growth=0.5), augmentation=10),
    getfem_peer.Settings(MeshSettings(80, growth=0.5), augmentation=10),
]

PROGRAMS = {"abut": (abut_peer, ABUT), "CalculiX": (calculix, CALCULIX), "GetFEM": (getfem_peer, GETFEM)}
EXPECTED = {"CalculiX": 50, "GetFEM": 20}  # times faster, at equal error
