package org.dronewatch.world;

import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Supplier;
import org.dronewatch.geo.EarthPlace;
import org.dronewatch.geo.EarthPoint;
import org.dronewatch.geo.Geodesy;
import org.dronewatch.geo.LocalPlace;
import org.dronewatch.geo.Origin;
import org.dronewatch.geometry.Position;
import org.dronewatch.setting.In;

/**
 * Converts places on a map, or above the surface of a site, to positions in its world frame. The site is only queried
 * for heights above its surface. For use by one thread.
 */
public final class Places {
    /** How exactly the surface below a place is found, m. */
    private static final double EXACT = 1e-6;

    /**
     * The frame's vertical and that of a place 100 km away differ by one degree, so each step makes the error at least
     * ten times smaller on any ground less steep than 80 degrees; on a wall, it stays at one of the two heights.
     */
    private static final int MOST_STEPS = 20;

    private final Optional<Origin> origin;
    private final boolean heightsAreKnown;
    private final Supplier<Ground> site;
    private Ground ground;

    /**
     * Converts places of a site.
     *
     * @param world settings of the site
     * @param ground supplies the heights of the site's highest surfaces; called when they are first needed
     */
    public Places(WorldSettings world, Supplier<Ground> ground) {
        this.origin = world.origin();
        this.heightsAreKnown =
                world.terrain().isPresent() || origin.flatMap(Origin::height).isPresent();
        this.site = ground;
    }

    /**
     * The position of a place by latitude and longitude. A height above the surface is measured along the vertical at
     * that place.
     *
     * @throws IllegalArgumentException when the scene has no origin, a place given by its height above the surface has
     *     no surface below it, a height above sea level has no meaning in the scene, or the place is more than 100 km
     *     from the origin
     */
    public Position at(EarthPlace place) {
        Geodesy geodesy = geodesy();
        if (place.height().isPresent()) {
            if (!heightsAreKnown) {
                throw new IllegalArgumentException(
                        "height " + place.height().get()
                                + " m above sea level has no meaning without world.origin.height: give that, or 'above' instead");
            }
            return near(
                    geodesy.inWorld(
                            place.latitude(), place.longitude(), place.height().get()),
                    place.latitude(),
                    place.longitude());
        }
        double surface = surface(place.latitude(), place.longitude())
                .orElseThrow(() -> new IllegalArgumentException(hole(geodesy, place.latitude(), place.longitude())));
        return near(
                geodesy.inWorld(
                        place.latitude(),
                        place.longitude(),
                        surface + place.above().orElse(0.0)),
                place.latitude(),
                place.longitude());
    }

    /**
     * The position of a place above the surface.
     *
     * @throws IllegalArgumentException when there is no surface below it
     */
    public Position at(LocalPlace place) {
        OptionalDouble below = ground().height(place.east(), place.north());
        if (below.isEmpty()) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "no surface at east %s m, north %s m: the site has a hole or ends there, so give a position with its height",
                    place.east(),
                    place.north()));
        }
        return new Position(place.east(), place.north(), below.getAsDouble() + place.above());
    }

    /**
     * A point in plan view by latitude and longitude, at the level of the origin.
     *
     * @throws IllegalArgumentException when the scene has no origin, or the point is more than 100 km from it
     */
    public GroundPoint at(EarthPoint point) {
        double level = origin.flatMap(Origin::height).orElse(0.0);
        Position position = near(
                geodesy().inWorld(point.latitude(), point.longitude(), level), point.latitude(), point.longitude());
        return new GroundPoint(position.x(), position.y());
    }

    private Geodesy geodesy() {
        return new Geodesy(
                origin.orElseThrow(
                        () -> new IllegalArgumentException(
                                "needs a world.origin, the latitude and longitude of x = y = 0: a place on a map has no position without it")));
    }

    /** The highest surfaces of the site. */
    public Ground ground() {
        if (ground == null) {
            ground = site.get();
        }
        return ground;
    }

    /**
     * Whether heights above sea level have a meaning: the height of the origin is stated, or there is terrain, whose
     * heights are above sea level.
     */
    public boolean heightsAreKnown() {
        return heightsAreKnown;
    }

    /**
     * The position of a place at a height above the datum of the origin's height; above the origin if that height is
     * not known.
     *
     * @param latitude latitude (WGS 84), rad
     * @param longitude longitude (WGS 84), rad
     * @param height height, m
     * @throws IllegalArgumentException when the scene has no origin, or the point is more than 100 km from it
     */
    public Position atHeight(double latitude, double longitude, double height) {
        return near(geodesy().inWorld(latitude, longitude, height), latitude, longitude);
    }

    /**
     * The height of the highest surface on the vertical at a place, m, above the datum of the origin's height; above
     * the origin if that height is not known. Empty where the terrain has a hole, and outside the site.
     *
     * @param latitude latitude (WGS 84), rad
     * @param longitude longitude (WGS 84), rad
     * @throws IllegalArgumentException when the scene has no origin, or the point is more than 100 km from it
     */
    public OptionalDouble surface(double latitude, double longitude) {
        Geodesy geodesy = geodesy();
        double height = origin.flatMap(Origin::height).orElse(0.0);
        Position there = near(geodesy.inWorld(latitude, longitude, height), latitude, longitude);
        for (int step = 0; step < MOST_STEPS; step++) {
            OptionalDouble z = ground().height(there.x(), there.y());
            if (z.isEmpty()) {
                return OptionalDouble.empty();
            }
            double found = geodesy.onEarth(new Position(there.x(), there.y(), z.getAsDouble()))
                    .height();
            double change = found - height;
            height = found;
            if (Math.abs(change) <= EXACT) {
                break;
            }
            there = geodesy.inWorld(latitude, longitude, height);
        }
        return OptionalDouble.of(height);
    }

    private String hole(Geodesy geodesy, double latitude, double longitude) {
        Position there = geodesy.inWorld(
                latitude, longitude, origin.flatMap(Origin::height).orElse(0.0));
        return String.format(
                Locale.ROOT,
                "no surface at %s (x %.1f m, y %.1f m): the site has a hole or ends there, so give 'height' instead",
                inWords(latitude, longitude),
                there.x(),
                there.y());
    }

    private static Position near(Position position, double latitude, double longitude) {
        double far = Math.max(Math.abs(position.x()), Math.max(Math.abs(position.y()), Math.abs(position.z())));
        if (far > In.FARTHEST) {
            throw new IllegalArgumentException(String.format(
                    Locale.ROOT,
                    "%s lies %.1f km from world.origin, but must lie within %.0f km of it along each axis",
                    inWords(latitude, longitude),
                    far / 1000.0,
                    In.FARTHEST / 1000.0));
        }
        return position;
    }

    /** Text of a latitude and longitude, in rad, for messages. */
    public static String inWords(double latitude, double longitude) {
        return String.format(
                Locale.ROOT,
                "latitude %.6f deg, longitude %.6f deg",
                Math.toDegrees(latitude),
                Math.toDegrees(longitude));
    }
}
