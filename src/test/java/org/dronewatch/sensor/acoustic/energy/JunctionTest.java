package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.edge.NearEdges;
import org.dronewatch.sensor.acoustic.edge.NearEdges.NearEdge;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;

/** Where surfaces meet in a valley, there is no edge: sound cannot pass on its other side. */
class JunctionTest {
    private static final long SEED = 20261202;
    private static final double LONGEST = 5.0;
    private static final SurfaceMaterial OPAQUE = SurfaceMaterial.uniform("opaque", 1, 0);
    private static final TriangleMesh GROUND = Sites.square(60, 0);

    /** A wall and a house whose base is exactly on the ground, but shares no corner with it. */
    @Test
    void theBaseOfAWallOnTheGroundIsNoEdge() {
        check(World.merge(List.of(GROUND, Sites.wall(1, 8, 0, 7, -30, 30))), 8);
        check(World.merge(List.of(GROUND, Sites.box(-30, 8, 0, 30, 16, 7))), 8);
    }

    /** The walls, floor and ceiling of a room share their corners. */
    @Test
    void theInsideOfARoomHasNoEdge() {
        check(Sites.box(-9, 2, 0, 9, 8, 3), 8);
    }

    private static void check(TriangleMesh mesh, double wall) {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i < 200; i++) {
            UnaryOperator<Position> by = i % 4 == 0 ? position -> position : Sites.attitude(random);
            NearEdges near = new NearEdges(Sites.world(Sites.turned(mesh, by), OPAQUE));
            Position one = low(random, wall, -5);
            Position other = low(random, wall, 5);
            assertThat(edges(near, by.apply(one), by.apply(other)))
                    .as("pair %d of seed %d: %s and %s", i, SEED, one, other)
                    .isEmpty();
        }
    }

    /** Near the base of a wall that faces lower y, 1 mm to 1 m from it and from the ground. */
    private static Position low(SplittableRandom random, double wall, double x) {
        double off = Math.pow(10, random.nextDouble(-3, 0));
        return new Position(x, wall - off, Math.pow(10, random.nextDouble(-3, 0)));
    }

    /** Edges at which an outline bends by more than a tenth of a degree: less counts as flat. */
    private static List<NearEdge> edges(NearEdges near, Position one, Position other) {
        List<NearEdge> edges = new ArrayList<>(near.find(one, other, LONGEST));
        edges.removeIf(edge -> edge.bend() < Math.toRadians(0.1));
        return edges;
    }

    /** A wall of several pieces that share no corners is flat. */
    @Test
    void theSeamOfPiecesOfAWallIsNoEdge() {
        TriangleMesh pieces = World.merge(List.of(
                Sites.wall(1, 8, -100, 100, -90, -1.7),
                Sites.wall(1, 8, -100, 2.3, -1.7, 90),
                Sites.wall(1, 8, 2.3, 100, -1.7, 90)));
        check(pieces, 8);
    }

    /** Higher up, sound can pass below the wall; and above it, beyond its top. */
    @Test
    void theFreeBordersOfAWallAreEdges() {
        TriangleMesh wall = World.merge(List.of(GROUND, Sites.wall(1, 8, 1, 3, -30, 30)));
        NearEdges near = new NearEdges(Sites.world(wall, OPAQUE));
        for (double z : new double[] {0.9, 3.1}) {
            assertThat(edges(near, new Position(-5, 6, z), new Position(5, 9, z)))
                    .as("at %s m", z)
                    .hasSize(1)
                    .allSatisfy(edge -> assertThat(edge.bend()).isCloseTo(Math.PI, within(1e-6)));
        }
    }

    /** Above the corner of a roof, the wall below is part of the obstacle: the roof bends by a right angle. */
    @Test
    void theEaveOfAHouseOnTheGroundBendsByARightAngle() {
        NearEdges near =
                new NearEdges(Sites.world(World.merge(List.of(GROUND, Sites.box(-30, 8, 0, 30, 16, 7))), OPAQUE));
        assertThat(edges(near, new Position(0, 2, 7.1), new Position(0, 12, 7.3)))
                .singleElement()
                .satisfies(edge -> assertThat(edge.bend()).isCloseTo(Math.PI / 2, within(1e-6)));
    }

    /** A house on the ground and one that reaches into it sound the same. */
    @Test
    void howFarAHouseReachesIntoTheGroundIsNotHeard() {
        SurfaceMaterial asphalt = SurfaceMaterial.uniform("asphalt", 0.02, 0);
        SurfaceMaterial brick = SurfaceMaterial.uniform("brick", 0.03, 0);
        World on = Sites.world(List.of(GROUND, Sites.box(-30, 8, 0, 30, 16, 7)), List.of(asphalt, brick));
        World into = Sites.world(List.of(GROUND, Sites.box(-30, 8, -1, 30, 16, 7)), List.of(asphalt, brick));
        for (Position drone :
                List.of(new Position(-5, 7.95, 0), new Position(-50, 7.7, 0.1), new Position(-50, 5, 2))) {
            for (double height : new double[] {0.0, 0.02, 0.1, 1.5}) {
                Position microphone = new Position(5, 7.9, height);
                assertThat(level(on, drone, microphone))
                        .as("%s and %s", drone, microphone)
                        .isCloseTo(level(into, drone, microphone), within(1e-6));
            }
        }
    }

    private static double level(World world, Position drone, Position microphone) {
        return Sites.read(EnergyModel.DEFAULT, world, Sites.broadband(drone), microphone, SEED)
                .totalLevel();
    }
}
