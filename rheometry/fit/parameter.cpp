#include "rheometry/fit/parameter.hpp"

#include <cmath>

namespace searle::rheometry::fit {

double to_search(Transform transform, double value) {
    switch (transform) {
    case Transform::logarithm:
        return std::log(value);
    case Transform::square_root:
        return std::sqrt(value);
    case Transform::identity:
        break;
    }
    return value;
}

double from_search(Transform transform, double coordinate) {
    switch (transform) {
    case Transform::logarithm:
        return std::exp(coordinate);
    case Transform::square_root:
        return coordinate * coordinate;
    case Transform::identity:
        break;
    }
    return coordinate;
}

double search_slope(Transform transform, double coordinate) {
    switch (transform) {
    case Transform::logarithm:
        return std::exp(coordinate);
    case Transform::square_root:
        return 2.0 * coordinate;
    case Transform::identity:
        break;
    }
    return 1.0;
}

} // namespace searle::rheometry::fit
