package org.dronewatch.buildings;

import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geometry.Position;

/**
 * Where a building stands, and which way is up there. Far from the origin the vertical leans: by a metre in a hundred
 * at 64 km, so walls lean in the world frame as they do on the round earth. Within a building, all verticals are taken
 * to be parallel: in a building 200 m across and 100 m high, this neglects 3 mm.
 */
final class Upright {
    private static final double FAR = 100.0;

    private final Position foot;
    private final Position up;

    /**
     * The vertical at a place.
     *
     * @param geodesy geodesy of the world frame
     * @param place longitude and latitude, degrees, and the height from which heights count, m
     */
    Upright(Geodesy geodesy, GeoPoint place) {
        double latitude = Math.toRadians(place.latitude());
        double longitude = Math.toRadians(place.longitude());
        foot = geodesy.inWorld(latitude, longitude, place.height());
        Position above = geodesy.inWorld(latitude, longitude, place.height() + FAR);
        up = new Position((above.x() - foot.x()) / FAR, (above.y() - foot.y()) / FAR, (above.z() - foot.z()) / FAR);
    }

    /** The foot, from which the coordinates of the building are measured. */
    Position foot() {
        return foot;
    }

    /**
     * A point of the building in the world frame.
     *
     * @param x east of the foot along the level through it, m
     * @param y north of the foot likewise, m
     * @param height above that level, m
     */
    Position position(double x, double y, double height) {
        double level = -(up.x() * x + up.y() * y) / up.z();
        return new Position(
                foot.x() + x + up.x() * height, foot.y() + y + up.y() * height, foot.z() + level + up.z() * height);
    }
}
