#!/usr/bin/python3
"""End factors c_L of creeping swirl, computed independently of Searle: bilinear elements on blocks
of graded quadrilaterals, a power law by Newton's method on its energy, Richardson's extrapolation
of three grids. Needs numpy and scipy. Lengths in bob radii (rotor outside radii of a double gap).

    python3 bench/independent_end_factors.py
"""
import numpy as np
import scipy.sparse as sparse
from scipy.sparse.linalg import spsolve


def graded(start, stop, cells, at_start, at_stop):
    """Points from start to stop, dense (cubically) at the ends named."""
    x = np.linspace(0.0, 1.0, cells + 1)
    if at_start and at_stop:
        x = np.where(x < 0.5, 4.0 * x**3, 1.0 - 4.0 * (1.0 - x)**3)
    elif at_start:
        x = x**3
    elif at_stop:
        x = 1.0 - (1.0 - x)**3
    return start + (stop - start) * x


class Mesh:
    def __init__(self):
        self.points, self.index, self.cells = [], {}, []
        self.rotor, self.cup = set(), set()

    def node(self, r, z):
        key = (round(r * 1e11), round(z * 1e11))
        if key not in self.index:
            self.index[key] = len(self.points)
            self.points.append((r, z))
        return self.index[key]

    def block(self, r, shares, low, high, **walls):
        """Rows at low(r) + share (high(r) - low(r)); walls: side = "rotor" or "cup"."""
        n = [[self.node(x, low(x) + s * (high(x) - low(x))) for x in r] for s in shares]
        for j in range(len(shares) - 1):
            for i in range(len(r) - 1):
                self.cells.append((n[j][i], n[j][i + 1], n[j + 1][i + 1], n[j + 1][i]))
        sides = {"bottom": n[0], "top": n[-1], "left": [q[0] for q in n], "right": [q[-1] for q in n]}
        for side, wall in walls.items():
            getattr(self, wall).update(sides[side])


def torque(mesh, power):
    """M / (2 pi K omega^n R^3): (n + 1) times the least energy."""
    points, cells = np.array(mesh.points), np.array(mesh.cells)
    g = 1.0 / np.sqrt(3.0)
    grad, weight = [], []
    x, y = points[cells, 0], points[cells, 1]
    for a, b in [(-g, -g), (g, -g), (g, g), (-g, g)]:
        shape = 0.25 * np.array([(1 - a) * (1 - b), (1 + a) * (1 - b), (1 + a) * (1 + b), (1 - a) * (1 + b)])
        da = 0.25 * np.array([-(1 - b), 1 - b, 1 + b, -(1 + b)])
        db = 0.25 * np.array([-(1 - a), -(1 + a), 1 + a, 1 - a])
        xa, xb, ya, yb = x @ da, x @ db, y @ da, y @ db
        det = xa * yb - xb * ya
        assert (det > 0).all()
        r = x @ shape
        grad.append(np.stack([(np.outer(yb, da) - np.outer(ya, db)) / det[:, None] * r[:, None],
                              (np.outer(xa, db) - np.outer(xb, da)) / det[:, None] * r[:, None]], 1))
        weight.append(det * r)
    rotor = np.array(sorted(mesh.rotor))
    fixed = np.array(sorted(mesh.rotor | mesh.cup))
    free = np.setdiff1d(np.arange(len(points)), fixed)
    w = np.zeros(len(points))
    w[rotor] = 1.0
    rows = np.repeat(cells, 4, axis=1).ravel()
    cols = np.tile(cells, (1, 4)).ravel()

    def energy(values, rounding):
        total = 0.0
        for gq, wq in zip(grad, weight):
            square = (np.einsum("ekl,el->ek", gq, values[cells])**2).sum(1) + rounding**2
            total += (wq * square**((power + 1) / 2)).sum()
        return total / (power + 1)

    # Picard's steps from the Newtonian field, then Newton's with a rounding that falls.
    for rounding in ([0.0] if power == 1.0 else [10.0, 1.0, 1e-1, 1e-2, 1e-3, 1e-5]):
        for iteration in range(60):
            newton = power == 1.0 or rounding < 10.0
            data, force = 0.0, np.zeros(len(points))
            for gq, wq in zip(grad, weight):
                v = np.einsum("ekl,el->ek", gq, w[cells])
                square = (v**2).sum(1) + rounding**2
                first = rounding in (0.0, 10.0) and iteration == 0
                if power == 1.0 or first:
                    square = np.ones_like(square)
                secant = wq * square**((power - 1) / 2)
                bend = (power - 1) * secant / square if newton else 0.0 * secant
                along = np.einsum("ekl,ek->el", gq, v)
                data = data + secant[:, None, None] * np.einsum("eki,ekj->eij", gq, gq) \
                    + bend[:, None, None] * along[:, :, None] * along[:, None, :]
                np.add.at(force, cells, secant[:, None] * along)
            matrix = sparse.csr_matrix((data.ravel(), (rows, cols)), shape=(len(points),) * 2)
            step = np.zeros(len(points))
            step[free] = -spsolve(matrix[free][:, free].tocsc(), force[free])
            length, start = 1.0, energy(w, rounding)
            while not first and energy(w + length * step, rounding) > start and length > 1e-6:
                length *= 0.5
            w = w + length * step
            if np.abs(step).max() < 1e-10:
                break
    return (power + 1) * energy(w, 0.0)


def bob(cells, cup, length, bottom, top, shaft, cone):
    """A bob with a conical tip of height `cone` (0: flat), covered by `top` of fluid."""
    mesh = Mesh()
    under, gap = graded(0, 1, cells, False, True), graded(1, cup, cells, True, False)
    below, side = graded(0, 1, cells, False, True), graded(0, 1, 2 * cells, True, True)
    floor, ceiling = (lambda r: -bottom), (lambda r: -cone * (1 - r) if r < 1 else 0.0)
    mesh.block(under, below, floor, ceiling, bottom="cup", top="rotor")
    mesh.block(gap, below, floor, ceiling, bottom="cup", right="cup")
    mesh.block(gap, side, lambda r: 0.0, lambda r: length, left="rotor", right="cup")
    if top > 0:
        above = graded(0, 1, cells, True, False)
        mesh.block(gap, above, lambda r: length, lambda r: length + top, right="cup")
        mesh.block(graded(shaft, 1, cells, True, True), above, lambda r: length,
                   lambda r: length + top, bottom="rotor", left="rotor")
    return mesh


def double_gap(cells, post, inside, cup, length, bottom):
    """A rotor between `inside` and 1, `bottom` above the floor, filled to its height."""
    mesh = Mesh()
    inner, outer = graded(post, inside, cells, False, True), graded(1, cup, cells, True, False)
    rotor, below = graded(inside, 1, cells, True, True), graded(0, 1, cells, False, True)
    side = graded(0, 1, 2 * cells, True, False)
    floor, edge, brim = (lambda r: -bottom), (lambda r: 0.0), (lambda r: length)
    mesh.block(inner, below, floor, edge, bottom="cup", left="cup")
    mesh.block(rotor, below, floor, edge, bottom="cup", top="rotor")
    mesh.block(outer, below, floor, edge, bottom="cup", right="cup")
    mesh.block(inner, side, edge, brim, left="cup", right="rotor")
    mesh.block(outer, side, edge, brim, left="rotor", right="cup")
    return mesh


def annulus(inner, outer, power):
    """Torque of unit length of an endless gap over 2 pi K omega^n."""
    m = 2.0 / power
    # omega = tau_i^(1/n) (R_i^m) (R_i^-m - R_o^-m) / m with tau_i R_i^2 constant
    flux = (m / (inner**-m - outer**-m))**power
    return flux


def extrapolated(values):
    a, b, c = values
    order = np.log2((a - b) / (b - c))
    return c + (c - b) / (2.0**min(order, 2.5) - 1.0), order


if __name__ == "__main__":
    cone = 1.0 / np.tan(np.radians(60.0))
    scenes = {
        "ISO bob": (lambda n: bob(n, 1.0847, 3.0, 1.0, 1.0, 0.3, cone),
                    lambda p: 3.0 * annulus(1.0, 1.0847, p)),
        "single gap, flat bottom 0.2 R above the floor, not covered":
            (lambda n: bob(n, 15.0 / 14.0, 3.0, 0.2, 0.0, 0.0, 0.0),
             lambda p: 3.0 * annulus(1.0, 15.0 / 14.0, p)),
        "double gap 20/20.38/21.96/22.38, 55 mm, 3 mm above the floor":
            (lambda n: double_gap(n, 20.0 / 21.96, 20.38 / 21.96, 22.38 / 21.96, 55.0 / 21.96, 3.0 / 21.96),
             lambda p: 55.0 / 21.96 * (annulus(20.0 / 21.96, 20.38 / 21.96, p)
                                       + annulus(1.0, 22.38 / 21.96, p))),
    }
    for name, (make, endless) in scenes.items():
        for power in (1.0, 0.5):
            found = [torque(make(n), power) / endless(power) for n in (16, 32, 64)]
            value, order = extrapolated(found)
            print(f"{name}, n = {power}: c_L = {value:.6f}   (grids {found[0]:.6f} {found[1]:.6f} "
                  f"{found[2]:.6f}, order {order:.2f})", flush=True)
