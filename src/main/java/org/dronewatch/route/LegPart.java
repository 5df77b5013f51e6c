package org.dronewatch.route;

import org.dronewatch.geometry.Position;

/** The part of a straight leg from one fraction of it to another. */
record LegPart(Position from, Position to, double begin, double end) {
    double length() {
        return end - begin;
    }

    double x(double share) {
        return from.x() + along(share) * (to.x() - from.x());
    }

    double y(double share) {
        return from.y() + along(share) * (to.y() - from.y());
    }

    double z(double share) {
        return from.z() + along(share) * (to.z() - from.z());
    }

    private double along(double share) {
        return begin + share * (end - begin);
    }
}
