package org.dronewatch.report.map;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalDouble;
import org.dronewatch.buildings.BuildingOutline;
import org.dronewatch.geo.GeoPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;

/** Buildings as features of a map. */
final class BuildingFeatures {
    private static final Color KNOWN = new Color(0x7f7768);

    /** A darker version of the colour that buildings with assumed heights have in pictures. */
    private static final Color ASSUMED = new Color(0xb5783a);

    private final Geodesy geodesy;
    private final double level;

    BuildingFeatures(Geodesy geodesy, Origin origin) {
        this.geodesy = geodesy;
        this.level = origin.height().orElse(0.0);
    }

    StyledFeature feature(BuildingOutline building) {
        List<List<GeoPoint>> rings = new ArrayList<>();
        rings.add(ring(building.outer()));
        building.courts().forEach(court -> rings.add(ring(court)));
        Properties properties = new Properties()
                .put("id", building.id())
                .put("part", building.isPart())
                .put("height_above_ground_m", building.top())
                .put("bottom_above_ground_m", building.bottom())
                .put("assumed", building.isAssumed());
        return new StyledFeature(
                Role.BUILDING,
                building.name().orElse(building.isPart() ? "part of a building" : "building"),
                new Shape.Area(rings, OptionalDouble.of(building.top())),
                building.isAssumed() ? ASSUMED : KNOWN,
                properties);
    }

    /** An area up to a height above the ground, whose corners may run in either direction. */
    Shape area(double[] corners, double height) {
        List<GeoPoint> ring = ring(corners);
        double twice = 0.0;
        for (int i = 0; i < corners.length; i += 2) {
            int next = (i + 2) % corners.length;
            twice += (corners[i] - corners[0]) * (corners[next + 1] - corners[1])
                    - (corners[next] - corners[0]) * (corners[i + 1] - corners[1]);
        }
        if (twice < 0.0) {
            Collections.reverse(ring);
        }
        return new Shape.Area(List.of(ring), OptionalDouble.of(height));
    }

    private List<GeoPoint> ring(double[] corners) {
        List<GeoPoint> ring = new ArrayList<>();
        for (int i = 0; i < corners.length; i += 2) {
            ring.add(onLevel(corners[i], corners[i + 1]));
        }
        ring.add(ring.get(0));
        return ring;
    }

    /**
     * A point at the level of the origin. This level is curved: far away, it is below the plane z = 0 of the world
     * frame, from which it is reached along the vertical.
     */
    private GeoPoint onLevel(double x, double y) {
        double z = 0.0;
        GeoPoint corner = geodesy.at(new Position(x, y, z));
        for (int i = 0; i < 2; i++) {
            z += level - geodesy.onEarth(new Position(x, y, z)).height();
            corner = geodesy.at(new Position(x, y, z));
        }
        return corner;
    }
}
