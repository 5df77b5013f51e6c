package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.withinPercentage;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.sound.surface.SurfaceMaterial.Wall;
import org.dronewatch.world.World;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Solids that touch face to face: each takes its loss once for each passage, in either direction, and what is opaque
 * stays so. These walls reflect nothing, so that all that arrives has passed straight through them: it is what would
 * arrive without them, less their losses.
 */
class TouchingSolidsTest {
    private static final long SEED = 20261127;
    private static final int ATTITUDES = LongForm.count(1, 4);
    private static final SurfaceMaterial STONE = black("stone", 7);
    private static final SurfaceMaterial CLAY = black("clay", 5);
    private static final SurfaceMaterial OPAQUE = SurfaceMaterial.uniform("opaque", 1, 0);
    private static final SurfaceMaterial SCREEN = SurfaceMaterial.uniform("screen", 0.1, 1);
    private static final EnergyModel MODEL = EnergyModel.DEFAULT
            .withDiffraction(Diffraction.OFF)
            .withAccuracy(0.0)
            .withRays(LongForm.count(30_000, 100_000))
            .withRoulette(1e-6);
    private static final int BAND = OctaveBands.ONE_KILOHERTZ;
    private static final double SCREEN_AT = 3;
    private static final double HALF = 4;
    private static final int CELLS = 400;
    private static final double CELL = 2 * HALF / CELLS;

    /** About four standard errors of what arrives in the open. */
    private static final double PER_CENT = LongForm.IS_ON ? 5 : 8;

    private static final Position BEFORE = new Position(-5, 0.3, 2);
    private static final Position BESIDE = new Position(-4, 2.1, 1.2);
    private static final Position BEHIND = new Position(1.9, -1.1, 1.5);

    /** What stands between. */
    private enum Between {
        NOTHING(0, List.of(), List.of()),
        TWO_MATERIALS(12, List.of(slab(0, 0.2), slab(0.2, 0.31)), List.of(STONE, CLAY)),
        IN_REVERSE_ORDER(12, List.of(slab(0.2, 0.31), slab(0, 0.2)), List.of(CLAY, STONE)),
        ONE_MATERIAL(14, List.of(slab(0, 0.2), slab(0.2, 0.31)), List.of(STONE, STONE)),
        THREE(19, List.of(slab(0, 0.2), slab(0.2, 0.31), slab(0.31, 0.5)), List.of(STONE, CLAY, STONE)),
        A_FACE_ON_A_LARGER_ONE(12, List.of(slab(0, 0.2), Sites.box(0.2, -31, -33, 0.31, 29, 37)), List.of(STONE, CLAY)),
        ONE_THAT_IS_THERE_TWICE(7, List.of(slab(0, 0.2), slab(0, 0.2)), List.of(STONE, STONE)),
        A_SHEET_ON_A_SOLID(
                12, List.of(slab(0, 0.2), Sites.wall(0, 0.2, -40, 40, -40, 40)), List.of(STONE, sheet(CLAY))),
        A_SHEET_BEFORE_A_SOLID(
                12, List.of(slab(0, 0.2), Sites.wall(0, 0, -40, 40, -40, 40)), List.of(STONE, sheet(CLAY))),
        AN_OPAQUE_ONE(Double.POSITIVE_INFINITY, List.of(slab(0, 0.2), slab(0.2, 0.31)), List.of(STONE, OPAQUE)),
        AN_OPAQUE_ONE_FIRST(Double.POSITIVE_INFINITY, List.of(slab(0.2, 0.31), slab(0, 0.2)), List.of(OPAQUE, STONE));

        private final double loss;
        private final List<TriangleMesh> meshes;
        private final List<SurfaceMaterial> surfaces;

        Between(double loss, List<TriangleMesh> meshes, List<SurfaceMaterial> surfaces) {
            this.loss = loss;
            this.meshes = meshes;
            this.surfaces = surfaces;
        }

        /** With a screen behind that scatters all that it reflects. */
        World world(UnaryOperator<Position> by) {
            Map<SurfaceMaterial, List<TriangleMesh>> bySurface = new LinkedHashMap<>();
            for (int i = 0; i < meshes.size(); i++) {
                bySurface
                        .computeIfAbsent(surfaces.get(i), surface -> new ArrayList<>())
                        .add(Sites.turned(meshes.get(i), by));
            }
            bySurface.put(SCREEN, List.of(Sites.turned(Sites.wall(0, SCREEN_AT, -HALF, HALF, -HALF, HALF), by)));
            return Sites.world(bySurface.values().stream().map(World::merge).toList(), List.copyOf(bySurface.keySet()));
        }
    }

    @Thorough
    @ParameterizedTest
    @EnumSource
    void eachTakesItsLossOncePerPassage(Between between) {
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i <= ATTITUDES; i++) {
            UnaryOperator<Position> by = i == 0 ? at -> at : Sites.attitude(random);
            String attitude = "attitude %d of seed %d".formatted(i, SEED);
            World world = between.world(by);
            checkDirect(world, by, between.loss, attitude);
            check(world, by, BEFORE, BEHIND, between.loss, attitude + ", through");
            check(world, by, BEHIND, BEFORE, between.loss, attitude + ", back");
            check(world, by, BEFORE, BESIDE, 2 * between.loss, attitude + ", there and back");
            check(world, by, BESIDE, BEFORE, 2 * between.loss, attitude + ", there and back, exchanged");
        }
    }

    /** A shed of stone that stands against a sealed opaque house, whichever was added first. */
    @ParameterizedTest
    @ValueSource(booleans = {true, false})
    void nothingIsHeardWithinAnOpaqueHouseBehind(boolean isHouseFirst) {
        TriangleMesh house = Sites.box(0, -4, 0, 8, 4, 5);
        TriangleMesh shed = Sites.box(-2, -1.5, 0, 0, 1.5, 2.2);
        SurfaceMaterial wall = SurfaceMaterial.uniform("wall", 0.1, 0.3);
        SurfaceMaterial board = SurfaceMaterial.uniform("board", 0.5, 0.2).withTransmissionLoss(5, Wall.SOLID);
        Position outside = new Position(-6, 0.2, 1);
        Position inside = new Position(5, 1, 1.5);
        SplittableRandom random = new SplittableRandom(SEED);
        for (int i = 0; i <= ATTITUDES; i++) {
            UnaryOperator<Position> by = i == 0 ? at -> at : Sites.attitude(random);
            List<TriangleMesh> meshes =
                    Stream.of(house, shed).map(mesh -> Sites.turned(mesh, by)).toList();
            World site = isHouseFirst
                    ? Sites.world(meshes, List.of(wall, board))
                    : Sites.world(List.of(meshes.get(1), meshes.get(0)), List.of(board, wall));
            for (List<Position> ends : List.of(List.of(outside, inside), List.of(inside, outside))) {
                assertThat(Sites.read(
                                        MODEL.withRays(3000),
                                        site,
                                        Sites.broadband(by.apply(ends.get(0))),
                                        by.apply(ends.get(1)),
                                        1)
                                .totalLevel())
                        .as("attitude %d of seed %d, from %s", i, SEED, ends.get(0))
                        .isEqualTo(Double.NEGATIVE_INFINITY);
            }
        }
    }

    private static void checkDirect(World world, UnaryOperator<Position> by, double loss, String description) {
        for (List<Position> ends : List.of(List.of(BEFORE, BEHIND), List.of(BEHIND, BEFORE))) {
            SoundSource source = Sites.broadband(by.apply(ends.get(0)));
            Position sensor = by.apply(ends.get(1));
            EnergyModel model = MODEL.withRays(1);
            double alone =
                    Sites.read(model, Sites.open(), source, sensor, 1).direct().get(BAND);
            double heard = Sites.read(model, world, source, sensor, 1).direct().get(BAND);
            assertThat(heard / alone)
                    .as("%s, direct from %s", description, ends.get(0))
                    .isCloseTo(Levels.toRatio(-loss), withinPercentage(1e-6));
        }
    }

    private static void check(
            World world, UnaryOperator<Position> by, Position source, Position sensor, double loss, String what) {
        SoundSource sound = Sites.broadband(by.apply(source));
        double scattered = Sites.read(MODEL, world, sound, by.apply(sensor), 1)
                .reverberant()
                .get(BAND);
        double expected = sound.emitted() * sound.fraction(BAND) * ofScreen(source, sensor) * Levels.toRatio(-loss);
        assertThat(scattered).as(what).isCloseTo(expected, withinPercentage(PER_CENT));
    }

    /** What the screen scatters by Lambert's law: its integral, as intensity over power, 1/m2. */
    private static double ofScreen(Position source, Position sensor) {
        Air air = new Air(Atmosphere.STANDARD);
        double sum = 0;
        for (int i = 0; i < CELLS; i++) {
            for (int j = 0; j < CELLS; j++) {
                Position at = new Position(SCREEN_AT, (2 * i + 1 - CELLS) * CELL / 2, (2 * j + 1 - CELLS) * CELL / 2);
                double there = at.distance(source);
                double back = at.distance(sensor);
                double arriving = (SCREEN_AT - source.x()) / there / (4 * Math.PI * there * there);
                double leaving = (SCREEN_AT - sensor.x()) / back / (Math.PI * back * back);
                sum += 0.9 * arriving * leaving * CELL * CELL * air.left(BAND, there + back);
            }
        }
        return sum;
    }

    private static SurfaceMaterial black(String name, double loss) {
        return SurfaceMaterial.uniform(name, 1, 0).withTransmissionLoss(loss, Wall.SOLID);
    }

    private static SurfaceMaterial sheet(SurfaceMaterial material) {
        return SurfaceMaterial.uniform(material.name() + " sheet", 1, 0).withTransmissionLoss(5, Wall.SHEET);
    }

    private static TriangleMesh slab(double from, double to) {
        return Sites.box(from, -40, -40, to, 40, 40);
    }
}
