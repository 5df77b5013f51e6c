package org.dronewatch.sensor.radio;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import org.dronewatch.LongForm;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.world.Obstacle;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** How far a path is searched for, and which obstacle is named. */
class RadioPathSearchTest {
    private static final double FREQUENCY = 2.4e9;

    /** The first detour makes no difference, be it a small part of a wavelength. */
    @ParameterizedTest
    @ValueSource(doubles = {1e7, 3e7, 1.5e8, FREQUENCY})
    void theLossDoesNotDependOnWhereTheSearchBegins(double frequency) {
        long seed = LongForm.seed(11);
        SplittableRandom random = new SplittableRandom(seed);
        RadioPath path = new RadioPath(RadioPathTest.town(random));
        for (int i = 0; i < LongForm.count(150, 20_000); i++) {
            Position from = new Position(random.nextDouble(-400, 400), random.nextDouble(-400, 400), 0)
                    .plus(new Position(0, 0, random.nextDouble(5, 60)));
            Position to = from.plus(new Position(random.nextDouble(-90, 90), random.nextDouble(-90, 90), 0))
                    .plus(new Position(0, 0, random.nextDouble(-4, 90)));
            double first = Math.pow(10, random.nextDouble(-3, 1));
            assertThat(path.obstacleLoss(from, to, frequency, first))
                    .as("seed %d, pair %d, first %f", seed, i, first)
                    .isEqualTo(path.obstacleLoss(from, to, frequency, Double.POSITIVE_INFINITY));
        }
    }

    private static World site(TriangleMesh... meshes) {
        return World.of(World.merge(List.of(meshes)));
    }

    private static TriangleMesh named(String material, double west, double east, double south, double top) {
        TriangleMesh box = RadioPathTest.box(west, east, south, south + 0.1, -9, top);
        int[] zeros = new int[box.triangleCount()];
        return new TriangleMesh(box.vertices(), box.corners(), zeros, zeros, List.of(material));
    }

    private static String material(World world, Position from, Position to) {
        return new RadioPath(world)
                .obstacle(from, to, FREQUENCY)
                .map(Obstacle::material)
                .orElse("none");
    }

    /** Of walls in the way the highest, past a tower its nearer side; in free space the edge that takes most. */
    @Test
    void theObstacleWithTheGreatestLossIsNamed() {
        Position from = new Position(0, 0, 20);
        Position to = new Position(0, 400, 20);
        World walls = site(named("low", -900, 900, 100, 30), named("high", -900, 900, 200, 60));
        assertThat(material(walls, from, to)).isEqualTo("high");
        assertThat(material(walls, from.plus(new Position(0, 0, 80)), to.plus(new Position(0, 0, 80))))
                .isEqualTo("none");
        assertThat(material(walls, from, from)).isEqualTo("none");
        // A tower that reaches 3 m to the west of the line, and 30 m to the east, behind a low wall.
        World tower = site(named("wall", -900, 900, 100, 20.2), named("tower", -3, 30, 200, 500));
        assertThat(material(tower, from, to)).isEqualTo("tower");
        // The line is free: a wall 1 m below it, a post to the east 0.3 m beside it.
        World free = site(named("wall", -900, 900, 100, 19), named("east", 0.3, 9, 200, 500));
        assertThat(material(free, from, to)).isEqualTo("east");
        World mirrored = site(named("wall", -900, 900, 100, 19), named("west", -9, -0.3, 200, 500));
        assertThat(material(mirrored, from, to)).isEqualTo("west");
        World below = site(named("wall", -900, 900, 100, 19.9), named("east", 1, 9, 200, 500));
        assertThat(material(below, from, to)).isEqualTo("wall");
    }

    /** A site of one triangle, the first of all. */
    @Test
    void theFirstTriangleIsNamed() {
        World sail = World.of(new TriangleMesh(
                new float[] {-900, 200, -9, 900, 200, -9, 5, 200, 60},
                new int[] {0, 1, 2},
                new int[1],
                new int[1],
                List.of("sail")));
        assertThat(material(sail, new Position(0, 0, 20), new Position(0, 400, 20)))
                .isEqualTo("sail");
    }

    /** ITU-R P.525 in its other form: 32.4 + 20 lg f + 20 lg d in MHz and km. */
    @Test
    void freeSpaceLossIsThatOfTheRecommendation() {
        assertThat(RadioPath.freeSpaceLoss(1000, 1e6)).isCloseTo(32.45, within(0.01));
        assertThat(RadioPath.freeSpaceLoss(5000, 2.4e9)).isCloseTo(32.45 + 67.60 + 13.98, within(0.02));
    }

    /** Behind an edge with less than 40 dB, a faint wave is as strong as any; behind one with more, there is none. */
    @Test
    void aFaintWaveIsTheSameUntilItIsLost() {
        Position from = new Position(0, 0, 20);
        Position to = new Position(0, 400, 20);
        for (double top : new double[] {19.9, 21, 25, 40}) {
            RadioPath path = new RadioPath(site(named("wall", -900, 900, 200, top)));
            assertThat(path.faintLoss(from, to, FREQUENCY)).isEqualTo(path.obstacleLoss(from, to, FREQUENCY));
        }
        RadioPath high = new RadioPath(site(named("wall", -900, 900, 200, 150)));
        assertThat(high.faintLoss(from, to, FREQUENCY)).isInfinite();
        assertThat(high.faintLoss(from, from, FREQUENCY)).isZero();
        assertThat(high.obstacleLoss(from, from, FREQUENCY)).isZero();
    }

    /** The recommendation's formula holds above -0.78 only, and gives 0.004 dB there. */
    @Test
    void anEdgeThatIsJustClearTakesNothing() {
        assertThat(KnifeEdge.loss(-0.78)).isZero();
        assertThat(KnifeEdge.loss(Math.nextUp(-0.78))).isBetween(0.0, 0.005);
    }

    /** Between antennas 100 m apart, a screen of 120 m is passed at its sides, by a detour longer than the path. */
    @Test
    void aShortPathIsFoundPastAWideScreen() {
        RadioPath path = new RadioPath(site(named("screen", -60, 60, 49.95, 1500)));
        double side = KnifeEdge.loss(60 * Math.sqrt(2 * 100 / (299_792_458.0 / FREQUENCY * 50 * 50)));
        assertThat(path.obstacleLoss(new Position(0, 0, 20), new Position(0, 100, 20), FREQUENCY))
                .isCloseTo(side - 10 * Math.log10(2), within(0.1));
    }

    /** Heights count from nowhere: a path over a high wall is found far below sea level, too. */
    @ParameterizedTest
    @ValueSource(doubles = {0, -500, 500})
    void aPathOverAHighWallIsFoundAtAnyLevel(double level) {
        TriangleMesh wall = RadioPathTest.box(-900, 900, 25, 25.01, level - 9, level + 80);
        double top = KnifeEdge.loss(60 * Math.sqrt(2 * 50 / (299_792_458.0 / FREQUENCY * 25 * 25)));
        assertThat(new RadioPath(site(wall))
                        .obstacleLoss(new Position(0, 0, level + 20), new Position(0, 50, level + 20), FREQUENCY))
                .isCloseTo(top, within(0.1));
    }

    @Test
    void aPathBelongsToItsSite() {
        World world = site(named("wall", -900, 900, 200, 30));
        assertThat(new RadioPath(world).world()).isSameAs(world);
        assertThat(new TwoRays(world, ReflectingGround.DEFAULT).world()).isSameAs(world);
    }
}
