package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Where a path is reflected, and which part of the ground counts. */
class TwoRaysPlaceTest {
    private static final ReflectingGround SURFACE = new ReflectingGround(15, 0.001, 0.02);
    private static final Position FROM = new Position(0, 0, 10);
    private static final Position TO = new Position(0, 500, 30);

    /** A site turned about the vertical and moved. */
    private record Place(double angle, double east, double north) {
        Position of(Position p) {
            return turned(p).plus(new Position(east, north, 0));
        }

        Position turned(Position p) {
            double cos = Math.cos(angle);
            double sin = Math.sin(angle);
            return new Position(p.x() * cos - p.y() * sin, p.x() * sin + p.y() * cos, p.z());
        }
    }

    /** Strips of ground to the north, with heights at their borders, and a wall across them at 60 m. */
    private static World strips(Place place, double[] norths, double[] heights, boolean isWalled) {
        List<Position> corners = new ArrayList<>();
        for (int i = 1; i < norths.length; i++) {
            addQuad(corners, norths[i - 1], heights[i - 1], norths[i], heights[i]);
        }
        if (isWalled) {
            addQuad(corners, 60, -2, 60, 7);
        }
        float[] xyz = new float[3 * corners.size()];
        int[] triangles = new int[corners.size()];
        for (int i = 0; i < corners.size(); i++) {
            Position p = place.of(corners.get(i));
            xyz[3 * i] = (float) p.x();
            xyz[3 * i + 1] = (float) p.y();
            xyz[3 * i + 2] = (float) p.z();
            triangles[i] = i;
        }
        return World.of(TriangleMesh.of(xyz, triangles));
    }

    private static void addQuad(List<Position> corners, double south, double low, double north, double high) {
        Position a = new Position(-2000, south, low);
        Position b = new Position(2000, south, low);
        Position c = new Position(2000, north, high);
        Position d = new Position(-2000, north, high);
        corners.addAll(List.of(a, b, c, a, c, d));
    }

    private static double factor(Place place, double[] norths, double[] heights, boolean isWalled) {
        TwoRays rays = new TwoRays(strips(place, norths, heights, isWalled), SURFACE);
        // An antenna that receives less from the west of the path, and from below.
        return rays.weighted(place.of(FROM), place.of(TO), 1e9, true, way -> {
            Position there = new Place(-place.angle(), 0, 0).turned(way);
            return 0.9 + 0.001 * there.x() + 0.5 * there.z() / there.length();
        });
    }

    private static final Place HERE = new Place(0, 0, 0);

    @ParameterizedTest
    @CsvSource({"90, 0, 0", "0, 300, -200", "217, 50, 700", "-30, -400, 100"})
    void aSiteTurnedAndMovedReflectsTheSame(double degrees, double east, double north) {
        Place place = new Place(Math.toRadians(degrees), east, north);
        double[] norths = {-900, 110, 150, 900};
        for (double[] heights : new double[][] {{0, 0, 0, 0}, {-20, 2, 3, 18}, {3, 0, 0.1, -2}}) {
            for (boolean isWalled : new boolean[] {false, true}) {
                double here = factor(HERE, norths, heights, isWalled);
                assertThat(here).isNotZero();
                assertThat(factor(place, norths, heights, isWalled)).isCloseTo(here, within(2e-3));
            }
        }
    }

    /** The antenna is asked for the direction of the mirror image, by a vector as long as the direct path. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 0.3, -0.2})
    void theAntennaIsAskedForTheDirectionOfTheImage(double rise) {
        Place place = new Place(0.7, 40, -90);
        World world = strips(place, new double[] {-900, 900}, new double[] {-900 * rise, 900 * rise}, false);
        TwoRays rays = new TwoRays(world, SURFACE);
        Position to = TO.plus(new Position(0, 0, 500 * rise));
        Position normal = new Position(0, -rise, 1).times(1 / Math.hypot(rise, 1));
        Position image = to.minus(normal.times(2 * to.dot(normal))).minus(FROM);
        Position expected = place.turned(image.times(FROM.distance(to) / image.length()));
        List<Position> asked = new ArrayList<>();
        rays.weighted(place.of(FROM), place.of(to), 1e9, true, way -> {
            asked.add(way);
            return 0;
        });
        assertThat(asked).hasSize(1);
        assertThat(asked.get(0).distance(expected)).isLessThan(1e-3);
    }

    /**
     * At 1 GHz the first Fresnel zone reaches 66 m before and behind the reflection at 125 m: sqrt(0.3 500 300) / 40 m
     * = 5.3 m across the leg, over the sine of the angle, 0.08. What lies farther away does not count; a pit nearer
     * does.
     */
    @Test
    void onlyTheFirstFresnelZoneCounts() {
        double flat = factor(HERE, new double[] {-900, 900}, new double[] {0, 0}, false);
        assertThat(pits(52, 199)).isCloseTo(flat, within(1e-3));
        assertThat(Math.abs(pits(66, 199) - flat)).isGreaterThan(0.05);
        assertThat(Math.abs(pits(52, 184) - flat)).isGreaterThan(0.05);
    }

    /** Level ground between two places, and 0.3 m less on both sides of it. */
    private static double pits(double first, double last) {
        return factor(
                HERE,
                new double[] {-900, first - 0.1, first, last, last + 0.1, 900},
                new double[] {-0.3, -0.3, 0, 0, -0.3, -0.3},
                false);
    }

    /** An antenna below the surface that the ground continues has no reflection, be it the first or the other one. */
    @Test
    void fromBelowTheSurfaceNothingIsReflected() {
        TwoRays rays = new TwoRays(strips(HERE, new double[] {-900, 900}, new double[] {0, 0}, false), SURFACE);
        Position below = new Position(0, 0, -1);
        Position on = new Position(0, 0, 0);
        for (Position low : List.of(below, on)) {
            assertThat(rays.factor(low, TO, 1e9, false, way -> true)).isZero();
            assertThat(rays.factor(TO, low, 1e9, false, way -> true)).isZero();
        }
    }
}
