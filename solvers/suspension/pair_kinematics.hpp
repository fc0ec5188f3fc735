#pragma once

// The algebra of one near pair, in numbers or in registers of eight: how its two bodies move
// against each other, and what a push across their gap does to them. n: unit vector from the first
// to the second.

namespace searle::solvers::suspension {

template <class Number>
struct Vector {
    Number x, y, z;
};

template <class Number>
Vector<Number> cross(const Vector<Number>& a, const Vector<Number>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

template <class Number>
Number dot(const Vector<Number>& a, const Vector<Number>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class Number>
Vector<Number> combined(const Number& p, const Vector<Number>& a, const Number& q,
                        const Vector<Number>& b) {
    return {p * a.x + q * b.x, p * a.y + q * b.y, p * a.z + q * b.z};
}

/// How the second moves against the first.
template <class Number>
struct PairMotion {
    Number along;         ///< apart, along n
    Vector<Number> shear; ///< of the surfaces, across n
    Vector<Number> roll;  ///< turning against each other, as a velocity across n
};

/// @param apart    velocity of the second's centre less the first's
/// @param turning  lever_1 w_1 + lever_2 w_2
/// @param apart_turning  w_2 - w_1
template <class Number>
PairMotion<Number> pair_motion(const Vector<Number>& n, const Vector<Number>& apart,
                               const Vector<Number>& turning, const Vector<Number>& apart_turning) {
    const Number along = dot(apart, n);
    const Vector<Number> turned = cross(turning, n);
    return {along,
            {apart.x - along * n.x - turned.x, apart.y - along * n.y - turned.y,
             apart.z - along * n.z - turned.z},
            cross(apart_turning, n)};
}

/// What acts on the first and, opposite, on the second.
template <class Number>
struct PairPush {
    Vector<Number> force;
    Vector<Number> arm;    ///< n x across: each body's couple of the force is its lever times this
    Vector<Number> couple; ///< on the first; the second has its opposite
};

/// @param normal  force along n
/// @param across  force across n, in the middle of the gap
/// @param rolling  what turns the first against the second: n x rolling is the couple
template <class Number>
PairPush<Number> pair_push(const Vector<Number>& n, const Number& normal,
                           const Vector<Number>& across, const Vector<Number>& rolling) {
    return {{normal * n.x + across.x, normal * n.y + across.y, normal * n.z + across.z},
            cross(n, across),
            cross(n, rolling)};
}

} // namespace searle::solvers::suspension
