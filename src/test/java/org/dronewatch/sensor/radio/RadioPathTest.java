package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Losses at the edges of blocks and walls, against ITU-R P.526 computed by hand. */
class RadioPathTest {
    private static final double FREQUENCY = 2.4e9;
    private static final double WAVELENGTH = 299_792_458.0 / FREQUENCY;
    private static final Position RECEIVER = new Position(0, 0, 20);

    /** A box without a floor. */
    static TriangleMesh box(double west, double east, double south, double north, double bottom, double top) {
        float[] corners = new float[24];
        for (int i = 0; i < 8; i++) {
            corners[3 * i] = (float) ((i & 1) == 0 ? west : east);
            corners[3 * i + 1] = (float) ((i & 2) == 0 ? south : north);
            corners[3 * i + 2] = (float) ((i & 4) == 0 ? bottom : top);
        }
        int[] quads = {4, 5, 7, 6, 0, 1, 5, 4, 2, 6, 7, 3, 0, 4, 6, 2, 1, 3, 7, 5};
        int[] triangles = new int[30];
        for (int quad = 0; quad < 5; quad++) {
            int[] order = {0, 1, 2, 0, 2, 3};
            for (int k = 0; k < 6; k++) {
                triangles[6 * quad + k] = quads[4 * quad + order[k]];
            }
        }
        return TriangleMesh.of(corners, triangles);
    }

    private static TriangleMesh sheet(double north, double top) {
        float y = (float) north;
        float z = (float) top;
        return TriangleMesh.of(
                new float[] {-900, y, 0, 900, y, 0, 900, y, z, -900, y, z}, new int[] {0, 1, 2, 0, 2, 3});
    }

    private static TriangleMesh ground() {
        return TriangleMesh.of(
                new float[] {-3000, -3000, 0, 3000, -3000, 0, 3000, 3000, 0, -3000, 3000, 0},
                new int[] {0, 1, 2, 0, 2, 3});
    }

    private static double loss(Position drone, TriangleMesh... meshes) {
        List<TriangleMesh> all = new ArrayList<>(List.of(meshes));
        all.add(ground());
        return new RadioPath(World.of(World.merge(all))).obstacleLoss(drone, RECEIVER, FREQUENCY);
    }

    @ParameterizedTest
    @CsvSource({"0, 6.03", "1, 13.93", "2, 19.04", "-0.78, 0"})
    void aKnifeEdgeTakesWhatTheRecommendationSays(double v, double decibels) {
        assertThat(KnifeEdge.loss(v)).isCloseTo(decibels, within(0.02));
    }

    /** A wall of 60 m at 501 m, a sheet or 0.2 m thick. */
    @Test
    void aThinWallIsOneEdge() {
        Position drone = new Position(0, 1000, 10);
        assertThat(loss(drone, sheet(501, 60))).isCloseTo(34.0, within(0.05));
        assertThat(loss(drone, box(-900, 900, 500.9, 501.1, 0, 60))).isCloseTo(34.0, within(0.05));
        assertThat(loss(drone)).isZero();
    }

    /** A line that just touches the top of a wall loses half the field, like one a hair above or below it. */
    @ParameterizedTest
    @ValueSource(doubles = {-1e-3, 0, 1e-3})
    void anEdgeOnTheLineTakesHalfTheField(double above) {
        assertThat(loss(new Position(0, 1000, 20 + 2 * above), sheet(500, 20))).isCloseTo(6.03, within(0.02));
    }

    /** A block of 60 m from 400 to 600 m: by Deygout without correction. */
    @ParameterizedTest
    @CsvSource({"10, 60.5", "50, 44.9", "58, 37.0"})
    void aBlockHasTwoEdges(double height, double decibels) {
        assertThat(loss(new Position(0, 1000, height), box(-900, 900, 400, 600, 0, 60)))
                .isCloseTo(decibels, within(0.1));
    }

    /** Three walls, the middle one higher: that over the whole line, each other one over half of it. */
    @Test
    void wallsInARowAddUp() {
        double middle = KnifeEdge.loss(60 * Math.sqrt(2 * 1000 / (WAVELENGTH * 500 * 500)));
        double other = KnifeEdge.loss(10 * Math.sqrt(2 * 500 / (WAVELENGTH * 250 * 250)));
        assertThat(loss(new Position(0, 1000, 20), sheet(250, 60), sheet(500, 80), sheet(750, 60)))
                .isCloseTo(middle + 2 * other, within(0.25));
    }

    /** A tower of 20 m width and 300 m height: the wave passes on both sides, 10 m off the line. */
    @Test
    void aTowerIsPassedAtItsSides() {
        double side = KnifeEdge.loss(10 * Math.sqrt(2 * 1000 / (WAVELENGTH * 500 * 500)));
        assertThat(loss(new Position(0, 1000, 20), box(-10, 10, 499.9, 500.1, 0, 300)))
                .isCloseTo(side - 10 * Math.log10(2), within(0.1));
    }

    /** What spans the line above it, like a bridge, is no edge; a closed room is not left. */
    @Test
    void aBridgeHidesNothingAndARoomEverything() {
        Position drone = new Position(0, 1000, 20);
        assertThat(loss(drone, box(-900, 900, 490, 510, 40, 45))).isZero();
        assertThat(loss(drone, box(-50, 50, -50, 50, 0, 60))).isInfinite();
    }

    /** Ground with heights along the path to the north, 10 km wide. */
    private static World ground(double[] norths, double[] heights) {
        float[] corners = new float[6 * norths.length];
        int[] triangles = new int[6 * (norths.length - 1)];
        for (int i = 0; i < norths.length; i++) {
            for (int side = 0; side < 2; side++) {
                corners[6 * i + 3 * side] = side == 0 ? -5000 : 5000;
                corners[6 * i + 3 * side + 1] = (float) norths[i];
                corners[6 * i + 3 * side + 2] = (float) heights[i];
            }
            for (int k = 0; k < 6 && i > 0; k++) {
                triangles[6 * (i - 1) + k] = 2 * (i - 1) + new int[] {0, 1, 3, 0, 3, 2}[k];
            }
        }
        return World.of(TriangleMesh.of(corners, triangles));
    }

    /** A ridge of the ground 20 m over the line, and a mountain behind the drone that belongs to the same ground. */
    @Test
    void aMountainBehindTheDroneHidesNothing() {
        World world =
                ground(new double[] {-500, 450, 500, 550, 1010, 1800, 4000}, new double[] {0, 0, 40, 0, 0, 900, 900});
        double ridge = KnifeEdge.loss(20 * Math.sqrt(2 * 1000 / (WAVELENGTH * 500 * 500)));
        assertThat(new RadioPath(world).obstacleLoss(new Position(0, 1000, 20), RECEIVER, FREQUENCY))
                .isCloseTo(ridge, within(0.01));
    }

    /**
     * A receiver on the floor of a gorge: the wave comes over the edge in front of it. The cliff behind it rises above
     * the perpendicular to the line, which leans back; it belongs to the same ground, and is in nobody's way.
     */
    @ParameterizedTest
    @CsvSource({"80, 60", "200, 60", "200, 900", "200, 40.1"})
    void aGorgeIsEnteredOverItsEdge(double height, double cliff) {
        World world = ground(new double[] {-4000, -5, -4.9, 19.9, 20, 4000}, new double[] {cliff, cliff, 0, 0, 40, 40});
        Position receiver = new Position(0, 0, 1.5);
        Position drone = new Position(0, 200, height);
        double edge = edge(drone, receiver, new Position(0, 20, 40));
        RadioPath path = new RadioPath(world);
        assertThat(path.obstacleLoss(drone, receiver, FREQUENCY)).isCloseTo(edge, within(0.01));
        assertThat(path.obstacleLoss(receiver, drone, FREQUENCY)).isCloseTo(edge, within(0.01));
    }

    /** The loss at one edge above the line. */
    private static double edge(Position from, Position to, Position top) {
        double length = from.distance(to);
        Position ahead = to.minus(from).times(1 / length);
        double near = top.minus(from).dot(ahead);
        double over = Math.sqrt(Math.pow(top.distance(from), 2) - near * near);
        return KnifeEdge.loss(over * Math.sqrt(2 * length / (WAVELENGTH * near * (length - near))));
    }

    /** Whatever lies below the ground is enclosed by it, however high the sky above. */
    @Test
    void underTheGroundNothingIsReceived() {
        World world = ground(new double[] {-500, 400, 450, 4000}, new double[] {0, 0, 60, 60});
        assertThat(new RadioPath(world).obstacleLoss(new Position(0, 1000, 30), RECEIVER, FREQUENCY))
                .isInfinite();
    }

    /** A yard between walls without a floor or a roof, 10 m across: over its wall, and past nothing else. */
    @Test
    void aYardIsEnteredFromAbove() {
        TriangleMesh yard = yard(5, 30);
        Position receiver = new Position(0, 0, 20);
        Position level = new Position(0, 1000, 20);
        assertThat(new RadioPath(World.of(yard)).obstacleLoss(level, receiver, FREQUENCY))
                .isCloseTo(edge(level, receiver, new Position(0, 5, 30)), within(0.01));
        // From high above, the wall behind the receiver rises above the perpendicular to the line.
        Position high = new Position(0, 1000, 1000);
        assertThat(loss(high, yard)).isCloseTo(edge(high, receiver, new Position(0, 5, 30)), within(0.01));
    }

    /** Four walls round the origin, from the ground up. */
    private static TriangleMesh yard(float half, float top) {
        float[] corners = new float[24];
        for (int i = 0; i < 4; i++) {
            for (int k = 0; k < 2; k++) {
                corners[6 * i + 3 * k] = i == 0 || i == 3 ? -half : half;
                corners[6 * i + 3 * k + 1] = i < 2 ? -half : half;
                corners[6 * i + 3 * k + 2] = k == 0 ? 0 : top;
            }
        }
        int[] triangles = new int[24];
        for (int i = 0; i < 4; i++) {
            int a = 2 * i;
            int b = 2 * ((i + 1) % 4);
            int[] both = {a, b, b + 1, a, b + 1, a + 1};
            System.arraycopy(both, 0, triangles, 6 * i, 6);
        }
        return TriangleMesh.of(corners, triangles);
    }

    /** Whatever the direction of the path: the wall has no rows of samples to fall between. */
    @Test
    void alongAnApproachTheLossChangesWithoutSteps() {
        World world = World.of(World.merge(List.of(ground(), box(-900, 900, 500.9, 501.1, 0, 60))));
        RadioPath path = new RadioPath(world);
        double before = Double.NaN;
        for (double north = 1500; north > 600; north -= 0.5) {
            double here = path.obstacleLoss(new Position(0.1 * north, north, 10), RECEIVER, FREQUENCY);
            assertThat(here).isBetween(32.0, 40.0);
            if (!Double.isNaN(before)) {
                assertThat(here).as("at %f", north).isCloseTo(before, within(0.05));
            }
            before = here;
        }
    }

    /** One of these paths touches the edge of the block. */
    @Test
    void aPathIsTheSameFromBothEnds() {
        RadioPath path = new RadioPath(World.of(World.merge(List.of(ground(), box(-30, 60, 300, 450, 0, 40)))));
        for (int i = 0; i < 40; i++) {
            Position drone = new Position(20 * i - 400, 900, 5 + i);
            assertThat(path.obstacleLoss(drone, RECEIVER, FREQUENCY))
                    .isCloseTo(path.obstacleLoss(RECEIVER, drone, FREQUENCY), within(1e-4));
        }
    }

    /**
     * In towns of boxes at random, some of which touch, over hills: the search that goes ever farther gives the loss of
     * the search in the whole site, to the last bit.
     */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void aSearchThatBeginsNearTheLineFindsTheSame(long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        World town = town(random);
        RadioPath path = new RadioPath(town);
        int blocked = 0;
        int hidden = 0;
        for (int i = 0; i < LongForm.count(150, 20_000); i++) {
            Position from = new Position(random.nextDouble(-400, 400), random.nextDouble(-400, 400), 0)
                    .plus(new Position(0, 0, random.nextDouble(1, 60)));
            Position to = new Position(random.nextDouble(-400, 400), random.nextDouble(-400, 400), 0)
                    .plus(new Position(0, 0, random.nextDouble(1, 150)));
            double frequency = random.nextBoolean() ? FREQUENCY : 1.5e8;
            double near = path.obstacleLoss(from, to, frequency);
            double whole = path.obstacleLoss(from, to, frequency, Double.POSITIVE_INFINITY);

            assertThat(near).as("seed %d, pair %d", seed, i).isEqualTo(whole);
            blocked += whole > 6.1 && whole < Double.POSITIVE_INFINITY ? 1 : 0;
            hidden += whole == Double.POSITIVE_INFINITY ? 1 : 0;
        }
        assertThat(blocked).isGreaterThan(30);
        assertThat(hidden).isPositive();
    }

    /** Boxes at multiples of 10 m, so that many have walls in common, on uneven ground. */
    static World town(SplittableRandom random) {
        List<TriangleMesh> all = new ArrayList<>();
        for (int box = 0; box < 150; box++) {
            double west = 10.0 * random.nextInt(-40, 40);
            double south = 10.0 * random.nextInt(-40, 40);
            double east = west + 10.0 * random.nextInt(1, 6);
            double north = south + 10.0 * random.nextInt(1, 6);
            all.add(box(west, east, south, north, 0, random.nextDouble(3, 60)));
        }
        int posts = 21;
        float[] corners = new float[3 * posts * posts];
        for (int post = 0; post < posts * posts; post++) {
            corners[3 * post] = 50.0f * (post % posts) - 500.0f;
            corners[3 * post + 1] = 50.0f * (post / posts) - 500.0f;
            corners[3 * post + 2] = (float) random.nextDouble(-20, 15);
        }
        int[] triangles = new int[6 * (posts - 1) * (posts - 1)];
        for (int i = 0; i < triangles.length; i++) {
            int square = i / 6;
            int first = square / (posts - 1) * posts + square % (posts - 1);
            triangles[i] = first + new int[] {0, 1, posts + 1, 0, posts + 1, posts}[i % 6];
        }
        all.add(TriangleMesh.of(corners, triangles));
        return World.of(World.merge(all));
    }
}
