"""What simplices measure: for the scripts of the room `formats`."""
import numpy as np


def measures_of(corners):
    """Lengths, areas or volumes, of one row of points for each simplex."""
    a = corners[:, 1:] - corners[:, :1]
    if a.shape[1] == 1:
        return np.linalg.norm(a[:, 0], axis=1)
    normals = np.cross(a[:, 0], a[:, 1])
    if a.shape[1] == 2:
        return np.linalg.norm(normals, axis=1) / 2
    return np.abs(np.einsum("ij,ij->i", normals, a[:, 2])) / 6
