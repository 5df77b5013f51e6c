package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static org.dronewatch.sensor.acoustic.energy.Sites.LW;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.function.UnaryOperator;
import java.util.stream.IntStream;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.edge.EdgePath;
import org.dronewatch.sensor.acoustic.edge.NearEdges;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.Barrier;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Sound round edges, against the lengths of taut strings and the formulas of the standards. */
class DiffractionTest {
    private static final EnergyModel FEW = EnergyModel.DEFAULT.withRays(1);
    private static final SurfaceMaterial OPAQUE = SurfaceMaterial.uniform("opaque", 1, 0);
    private static final int BAND_250 = 2;
    private static final int BAND_1000 = OctaveBands.ONE_KILOHERTZ;
    private static final double FAR = 3000;
    private static final float FAR_BELOW = 100;

    /** A wall of 10 m, the source level with the microphone: over its top however close the microphone is. */
    @ParameterizedTest
    @ValueSource(doubles = {0.001, 0.01, 0.1, 0.5, 0.72, 0.8, 2, 20})
    void closeBehindAWallSoundComesOverItsTop(double behind) {
        World wall = world(Sites.wall(1, 0, -FAR, 10, -FAR, FAR));
        Position source = new Position(0, -50, 1.5);
        Position sensor = new Position(0, behind, 1.5);
        double straight = 50 + behind;
        double over = Math.hypot(50, 8.5) + Math.hypot(behind, 8.5);
        for (Diffraction method : List.of(Diffraction.MAEKAWA, Diffraction.CNOSSOS)) {
            double loss = Math.min(25, 10 * Math.log10(3 + 40 * (over - straight) / wavelength(BAND_250)));
            double level = level(method, wall, source, sensor, BAND_250);
            assertThat(level)
                    .isCloseTo(inTheOpen(straight, BAND_250) - air(over - straight, BAND_250) - loss, within(0.01));
        }
        double iso = Math.min(20, 10 * Math.log10(3 + 20 * (over - straight) / wavelength(BAND_250)));
        assertThat(level(Diffraction.ISO9613, wall, source, sensor, BAND_250))
                .isCloseTo(inTheOpen(straight, BAND_250) - air(over - straight, BAND_250) - iso, within(0.01));
    }

    /** A sheet of 4 x 4 m, 1.5 m over the microphone: sound comes round its nearest border, whatever its direction. */
    @ParameterizedTest
    @CsvSource({"0, 0, 40", "20, 0, 40", "5, 3, 60", "-7, 12, 40", "0.3, -0.2, 3.5"})
    void underACanopySoundComesRoundItsBorder(double x, double y, double z) {
        World canopy = world(Sites.square(2, 1.5));
        Position source = new Position(x, y, z);
        Position sensor = new Position(0, 0, 0);
        double shortest = Double.POSITIVE_INFINITY;
        for (int side = 0; side < 4; side++) {
            for (int i = -20_000; i <= 20_000; i++) {
                double along = i * 1e-4;
                double across = (side & 1) == 0 ? 2 : -2;
                Position edge = side < 2 ? new Position(across, along, 1.5) : new Position(along, across, 1.5);
                shortest = Math.min(shortest, source.distance(edge) + edge.distance(sensor));
            }
        }
        EdgePath path = new EdgePath(canopy);

        assertThat(path.find(source, sensor)).isTrue();
        assertThat(path.pathDifference()).isCloseTo(shortest - source.distance(sensor), within(1e-4));
        assertThat(path.edges().count()).isEqualTo(1);
        assertThat(path.edges().bend()).isCloseTo(Math.PI, within(1e-9));
        assertThat(level(Diffraction.MAEKAWA, canopy, source, sensor, BAND_250)).isGreaterThan(0);
    }

    /** The canopy stands out behind a wall: the only way to the microphone under it comes back from the other side. */
    @Test
    void underACanopyBehindAWallSoundTurnsBack() {
        World awning =
                world(World.merge(List.of(Sites.wall(1, 0, -FAR, 6, -FAR, FAR), Sites.wall(2, 2.5, -FAR, FAR, 0, 3))));
        Position source = new Position(0, -30, 1);
        Position sensor = new Position(0, 1, 1);
        double over = Math.hypot(30, 5) + Math.hypot(3, 3.5) + Math.hypot(2, 1.5);
        EdgePath path = new EdgePath(awning);

        assertThat(path.find(source, sensor)).isTrue();
        assertThat(path.pathDifference()).isCloseTo(over - 31, within(1e-6));
        assertThat(path.edges().count()).isEqualTo(2);
        assertThat(span(path)).isCloseTo(Math.hypot(3, 3.5), within(1e-6));
    }

    /**
     * Test case TC08 of ISO/TR 17534-4: a wall of 6 m from (175, 50) to (190, 10). In still air, with its 340 m/s and
     * nominal midbands, CNOSSOS-EU over the top gives the row below.
     */
    @Test
    void theWallOfTestCase8() {
        float[] corners = {175, 50, 6, 190, 10, 6, 175, 50, -FAR_BELOW, 190, 10, -FAR_BELOW};
        World wall = world(TriangleMesh.of(corners, new int[] {0, 1, 3, 0, 3, 2}));
        EdgePath path = new EdgePath(wall);
        int[] midbands = {63, 125, 250, 500, 1000, 2000, 4000, 8000};
        double[] expected = {6.02, 6.97, 8.42, 10.38, 12.75, 15.39, 18.21, 21.12};

        assertThat(path.find(new Position(10, 10, 1), new Position(200, 50, 4))).isTrue();
        assertThat(path.edges().count()).isEqualTo(1);
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(Barrier.cnossos(path.pathDifference(), 0, 340.0 / midbands[band]))
                    .isCloseTo(expected[band], within(0.005));
        }
    }

    /**
     * A block of 40 x 10 m: over both edges of its roof, or round both corners of its side, with C3 for several edges.
     */
    @ParameterizedTest
    @CsvSource({"8, 2, false", "60, 2, true"})
    void overABlockOrRoundItsSide(double height, double z, boolean round) {
        World block = world(Sites.box(-20, -5, -FAR, 12, 5, height));
        Position source = new Position(0, -40, z);
        Position sensor = new Position(0, 25, z);
        double aside = round ? 12 : height - z;
        double detour = Math.hypot(35, aside) + 10 + Math.hypot(20, aside) - 65;
        EdgePath path = new EdgePath(block);

        assertThat(path.find(source, sensor)).isTrue();
        assertThat(path.pathDifference()).isCloseTo(detour, within(1e-6));
        assertThat(path.edges().count()).isEqualTo(2);
        assertThat(span(path)).isCloseTo(10, within(1e-6));
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            double ratio = 25 * wavelength(band) * wavelength(band) / 100;
            double several = (1 + ratio) / (1.0 / 3 + ratio);
            double iso = Math.min(25, 10 * Math.log10(3 + 20 * several * detour / wavelength(band)));
            double cnossos = Math.min(25, 10 * Math.log10(3 + 40 * several * detour / wavelength(band)));
            double open = inTheOpen(65, band) - air(detour, band);
            assertThat(level(Diffraction.ISO9613, block, source, sensor, band)).isCloseTo(open - iso, within(0.01));
            assertThat(level(Diffraction.CNOSSOS, block, source, sensor, band)).isCloseTo(open - cnossos, within(0.01));
        }
    }

    /**
     * A house with eaves at 6 m and a ridge at 9 m: three edges for a low source, the ridge alone for a distant one.
     */
    @Test
    void overEavesAndRidge() {
        float w = 3000;
        float[] corners = {
            -w, -5, -w, w, -5, -w, -w, -5, 6, w, -5, 6, -w, 0, 9, w, 0, 9, -w, 5, 6, w, 5, 6, -w, 5, -w, w, 5, -w
        };
        int[] triangles = {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4, 4, 5, 7, 4, 7, 6, 6, 7, 9, 6, 9, 8};
        World house = world(TriangleMesh.of(corners, triangles));
        EdgePath path = new EdgePath(house);
        Position low = new Position(0, -8, 1);
        Position sensor = new Position(0, 7, 1.5);
        double roof = Math.hypot(5, 3);

        assertThat(path.find(low, sensor)).isTrue();
        assertThat(path.edges().count()).isEqualTo(3);
        assertThat(span(path)).isCloseTo(2 * roof, within(1e-6));
        assertThat(path.pathDifference())
                .isCloseTo(Math.hypot(3, 5) + 2 * roof + Math.hypot(2, 4.5) - low.distance(sensor), within(1e-6));
        assertThat(path.edges().turnUpTo(2)).isCloseTo(Math.atan2(5, 3) + Math.atan2(4.5, 2), within(1e-6));
        assertThat(path.edges().turnFrom(2)).isCloseTo(Math.atan2(4.5, 2) - Math.atan2(3, 5), within(1e-6));
        Position far = new Position(0, -100, 2);
        assertThat(path.find(far, new Position(0, 100, 2))).isTrue();
        assertThat(path.edges().count()).isEqualTo(1);
        assertThat(path.pathDifference()).isCloseTo(2 * Math.hypot(100, 7) - 200, within(1e-6));
    }

    /** Six walls of a closed box, and a box within a box: no way leads out. */
    @Test
    void outOfAClosedBoxNothingLeads() {
        World box = world(World.merge(List.of(Sites.box(0, 0, 0, 10, 8, 4), Sites.box(-3, -3, -3, 14, 12, 9))));
        EdgePath path = new EdgePath(box);
        Position inside = new Position(5, 4, 1.5);
        for (Position other : List.of(
                new Position(-2, 4, 1), new Position(40, 4, 2), new Position(6, 4, 4.3), new Position(-80, 90, 60))) {
            assertThat(path.find(inside, other)).isFalse();
            assertThat(path.find(other, inside)).isFalse();
        }
    }

    /** Through the shadow's border in steps of 1 mm: 4.77 dB there, and no step in any band. */
    @Thorough
    @ParameterizedTest
    @EnumSource(names = "OFF", mode = EnumSource.Mode.EXCLUDE)
    void nothingJumpsAtTheShadowsBorder(Diffraction method) {
        List<World> sites = List.of(
                world(Sites.wall(1, 0, -FAR, 10, -FAR, FAR)),
                world(Sites.box(-FAR, 0, -FAR, FAR, 8, 10)),
                world(Sites.wall(1, 0, -FAR, FAR, -FAR, 0)));
        for (World site : sites) {
            int[] bands = {0, BAND_1000, 7};
            double[] before = null;
            boolean[] hidden = new boolean[bands.length];
            boolean[] free = new boolean[bands.length];
            // Past the top or the side; the roof of the block is level with the microphone, so that both its edges are
            // reached together.
            boolean isPastTheSide = site == sites.get(2);
            Position sensor = new Position(isPastTheSide ? 0 : 0.3, 12, isPastTheSide ? 3 : 10);
            EnergyTracer tracer = tracer(method, site, sensor);
            for (int i = -400; i <= 400; i++) {
                Position source =
                        new Position(isPastTheSide ? 0.001 * i : 0.3, -12, isPastTheSide ? 3 : 10 + 0.001 * i);
                double[] levels = overTheOpen(tracer, source, sensor, bands);
                for (int b = 0; b < bands.length; b++) {
                    assertThat(Math.abs(levels[b] - (before == null ? levels : before)[b]))
                            .as("site %d, band %d, step %d", sites.indexOf(site), bands[b], i)
                            .isLessThan(0.1);
                    hidden[b] |= levels[b] < -4.78;
                    free[b] |= levels[b] > -0.001;
                    if (i == 0) {
                        assertThat(levels[b]).isCloseTo(-10 * Math.log10(3), within(0.02));
                    }
                }
                before = levels;
            }
            double reach = method == Diffraction.ISO9613 ? 0.1 : 0.05;
            double detour = 2 * Math.hypot(12, 0.2) - 24;
            for (int b = 0; b < bands.length; b++) {
                assertThat(hidden[b]).isTrue();
                assertThat(free[b]).isEqualTo(site != sites.get(1) && detour > reach * wavelength(bands[b]));
            }
        }
    }

    /** Levels relative to those in the open, dB. */
    private static double[] overTheOpen(EnergyTracer tracer, Position source, Position sensor, int... bands) {
        EnergyReading reading = read(tracer, source);
        return Arrays.stream(bands)
                .mapToDouble(band -> directOrRound(reading, band) - inTheOpen(source.distance(sensor), band))
                .toArray();
    }

    /** The path just begins to touch the second edge of a block, and then bends at both. */
    @ParameterizedTest
    @EnumSource(names = "OFF", mode = EnumSource.Mode.EXCLUDE)
    void nothingJumpsWhereASecondEdgeIsTouched(Diffraction method) {
        World block = world(Sites.box(-FAR, 0, -FAR, FAR, 8, 10));
        Position sensor = new Position(0, -12, 7);
        EnergyTracer tracer = tracer(method, block, sensor);
        double[] before = null;
        double[] start = null;
        for (int i = 300; i >= -300; i--) {
            double[] here = levels(tracer, new Position(0, 20, 10 + 0.001 * i));
            for (int band : new int[] {0, BAND_250, BAND_1000, 7}) {
                assertThat(Math.abs(here[band] - (before == null ? here : before)[band]))
                        .as("band %d, step %d", band, i)
                        .isLessThan(0.1);
            }
            start = start == null ? here : start;
            before = here;
        }
        // One edge and two, by the formulas.
        double one = Math.hypot(12, 3) + Math.hypot(20, 0.3) - Math.hypot(32, 3.3);
        double two = Math.hypot(12, 3) + 8 + Math.hypot(12, 0.3) - Math.hypot(32, 2.7);
        for (int band : new int[] {0, BAND_250, BAND_1000, 7}) {
            double open = inTheOpen(Math.hypot(32, 3), band);
            assertThat(start[band])
                    .isCloseTo(open - air(one, band) - method.attenuation(one, 0, wavelength(band)), within(0.06));
            assertThat(before[band])
                    .isCloseTo(open - air(two, band) - method.attenuation(two, 8, wavelength(band)), within(0.06));
        }
    }

    /**
     * A screen on a block grows until the shortest path, over the one edge of its top, becomes that round the block's
     * two corners, for which ISO 9613-2 and CNOSSOS-EU have C3 and C'' of nearly 3, and the former 5 dB more at most.
     */
    @ParameterizedTest
    @EnumSource(names = "OFF", mode = EnumSource.Mode.EXCLUDE)
    void nothingJumpsWhereAnotherPathBecomesTheShortest(Diffraction method) {
        Position source = new Position(0, -40, 2);
        Position sensor = new Position(0, 25, 2);
        TriangleMesh block = Sites.box(-20, -5, -FAR, 12, 5, 8);
        double[] before = null;
        double[] first = null;
        for (double top = 12; top < 18; top += 0.05) {
            World site = world(World.merge(List.of(block, Sites.wall(1, 0, 8, top, -20, 12))));
            double[] here = levels(tracer(method, site, sensor), source);
            for (int band = 0; band < here.length; band++) {
                double step = Math.abs(here[band] - (before == null ? here : before)[band]);
                assertThat(step).as("band %d, top %.2f m", band, top).isLessThan(0.4);
            }
            first = first == null ? here : first;
            before = here;
        }
        double over = Math.hypot(40, 10) + Math.hypot(25, 10) - 65;
        double round = Math.hypot(35, 12) + 10 + Math.hypot(20, 12) - 65;
        for (int band : new int[] {0, BAND_1000, 7}) {
            double open = inTheOpen(65, band);
            assertThat(first[band])
                    .isCloseTo(open - air(over, band) - method.attenuation(over, 0, wavelength(band)), within(0.02));
            assertThat(before[band])
                    .isCloseTo(open - air(round, band) - method.attenuation(round, 10, wavelength(band)), within(0.02));
        }
    }

    /** Above the wall's top by N = -0.05: Maekawa leaves 10 lg(3 - 1) = 3.01 dB. */
    @Test
    void justAboveAnEdgeTheDirectSoundIsWeaker() {
        World wall = world(Sites.wall(1, 0, -FAR, 10, -FAR, FAR));
        int band = BAND_250;
        double above = Math.sqrt(Math.pow(25 + 0.5 * 0.025 * wavelength(band), 2) - 625);
        Position source = new Position(0, -25, 10 + above);
        Position sensor = new Position(0, 25, 10 + above);
        assertThat(level(Diffraction.MAEKAWA, wall, source, sensor, band))
                .isCloseTo(inTheOpen(50, band) - 10 * Math.log10(2), within(0.01));
    }

    /**
     * Flat ground has no edges, however it is tiled and turned; a microphone and a drone that lie on it hear as above
     * it.
     */
    @Test
    void flatGroundIsNoEdge() {
        SplittableRandom random = new SplittableRandom(4);
        for (int run = 0; run < 10; run++) {
            UnaryOperator<Position> turn = run == 0 ? at -> at : Sites.attitude(random);
            World ground = world(Sites.turned(tiles(60, 5), turn));
            NearEdges near = new NearEdges(ground);
            for (double[] heights : new double[][] {{1.5, 1.5}, {1e-4, 1.5}, {1e-4, 1e-4}, {0.02, 30}}) {
                Position source = turn.apply(new Position(-37.3, 1.7, heights[0]));
                Position sensor = turn.apply(new Position(28.1, -6.2, heights[1]));
                for (NearEdges.NearEdge edge : near.find(source, sensor, 0.54)) {
                    assertThat(Math.toDegrees(edge.bend())).isLessThan(0.01);
                }
                // Opaque in this test: no mirrored sound.
                assertThat(level(Diffraction.ISO9613, ground, source, sensor, 0))
                        .isCloseTo(inTheOpen(source.distance(sensor), 0), within(1e-6));
            }
        }
    }

    /** Beside a ridge of 10 degrees the line is attenuated; the same ridge turned into a valley is no edge. */
    @Test
    void ridgesAreEdgesAndValleysAreNone() {
        double drop = 30 * Math.tan(Math.toRadians(5));
        for (double sign : new double[] {1, -1}) {
            float z = (float) (-sign * drop);
            float[] corners = {-500, -30, z, 500, -30, z, -500, 0, 0, 500, 0, 0, -500, 30, z, 500, 30, z};
            World roof = world(TriangleMesh.of(corners, new int[] {0, 1, 3, 0, 3, 2, 2, 3, 5, 2, 5, 4}));
            Position source = new Position(0, -20, sign > 0 ? 0.1 : 3);
            Position sensor = new Position(0, 20, sign > 0 ? 0.1 : 3);
            double expected =
                    sign > 0 ? 10 * Math.log10(3 - 40 * (2 * Math.hypot(20, 0.1) - 40) / wavelength(BAND_250)) : 0;
            assertThat(level(Diffraction.MAEKAWA, roof, source, sensor, BAND_250))
                    .isCloseTo(inTheOpen(40, BAND_250) - expected, within(0.01));
        }
    }

    /** A random attitude of the whole scene changes nothing. */
    @Test
    void attitudesChangeNothing() {
        SplittableRandom random = new SplittableRandom(11);
        TriangleMesh site = World.merge(List.of(
                Sites.box(-6, -4, 0, 6, 4, 7), Sites.wall(1, 12, 0, 3, -20, 9), Sites.wall(2, 2.5, -3, 3, 4, 6)));
        World upright = world(site);
        for (int run = 0; run < 60; run++) {
            Position source = new Position(
                    40 * random.nextDouble() - 20, -10 - 10 * random.nextDouble(), 1 + 5 * random.nextDouble());
            Position sensor = new Position(
                    10 * random.nextDouble() - 5, 4.5 + random.nextDouble(), 0.5 + 1.9 * random.nextDouble());
            UnaryOperator<Position> turn = Sites.attitude(random);
            double before = level(Diffraction.MAEKAWA, upright, source, sensor, BAND_1000);
            double after = level(
                    Diffraction.MAEKAWA,
                    world(Sites.turned(site, turn)),
                    turn.apply(source),
                    turn.apply(sensor),
                    BAND_1000);
            assertThat(before).isGreaterThan(0);
            assertThat(after).as("run %d: %s to %s", run, source, sensor).isCloseTo(before, within(0.02));
        }
    }

    /** Source and microphone exchanged, drones that lie on roofs and microphones on walls among them. */
    @Test
    void exchangedPlacesGiveTheSame() {
        long seed = 20261123;
        SplittableRandom random = new SplittableRandom(seed);
        World site = world(World.merge(List.of(
                Sites.box(-6, -4, 0, 6, 4, 7), Sites.wall(1, 12, 0, 3, -20, 9), Sites.wall(2, 2.5, -3, 3, 4, 6))));
        int hidden = 0;
        for (int run = 0; run < 100; run++) {
            Position one = new Position(
                    50 * random.nextDouble() - 25, -30 + 25 * random.nextDouble(), 0.1 + 9 * random.nextDouble());
            Position other =
                    switch (run % 4) {
                        case 0 -> new Position(10 * random.nextDouble() - 5, 4, 0.5 + 6 * random.nextDouble());
                        case 1 -> new Position(10 * random.nextDouble() - 5, 8 * random.nextDouble() - 4, 7);
                        default ->
                            new Position(
                                    50 * random.nextDouble() - 25,
                                    5 + 20 * random.nextDouble(),
                                    0.1 + 9 * random.nextDouble());
                    };
            for (Diffraction method : List.of(Diffraction.MAEKAWA, Diffraction.ISO9613)) {
                double there = level(method, site, one, other, BAND_1000);
                double back = level(method, site, other, one, BAND_1000);
                assertThat(there).isGreaterThan(-50);
                assertThat(back)
                        .as("seed %d, run %d: %s and %s", seed, run, one, other)
                        .isCloseTo(there, within(1e-9));
                hidden += there < inTheOpen(one.distance(other), BAND_1000) - 4.77 ? 1 : 0;
            }
        }
        assertThat(hidden).isGreaterThan(80);
    }

    /**
     * What a wall lets through and what goes round it: never more than in the open, and all of it through no wall at
     * all.
     */
    @Test
    void whatGoesThroughDoesNotGoRound() {
        for (double loss : new double[] {0.001, 3, 30, 90}) {
            double through = Levels.toRatio(-loss);
            SurfaceMaterial sheet =
                    SurfaceMaterial.uniform("sheet", 1, 0).withTransmissionLoss(loss, SurfaceMaterial.Wall.SHEET);
            World wall = Sites.world(Sites.wall(1, 0, -FAR, 10, -FAR, FAR), sheet);
            Position source = new Position(0, -20, 9.5);
            Position sensor = new Position(0, 20, 9.5);
            double detour = 2 * Math.hypot(20, 0.5) - 40;
            double round = Levels.toRatio(-Barrier.maekawa(detour, wavelength(0)) - air(detour, 0));
            double expected = inTheOpen(40, 0) + Levels.ofRatio(through + (1 - through) * round);
            assertThat(level(Diffraction.MAEKAWA, wall, source, sensor, 0)).isCloseTo(expected, within(0.01));
        }
    }

    private static double span(EdgePath path) {
        return path.edges().along(path.edges().count() - 1) - path.edges().along(0);
    }

    private static double level(Diffraction method, World world, Position source, Position sensor, int band) {
        EnergyReading reading = Sites.read(FEW.withDiffraction(method), world, Sites.sound(source, band), sensor, 1);
        return directOrRound(reading, band);
    }

    /** The levels of a sound that is as loud in all bands. */
    private static double[] levels(EnergyTracer tracer, Position source) {
        EnergyReading reading = read(tracer, source);
        return IntStream.range(0, OctaveBands.COUNT)
                .mapToDouble(band -> directOrRound(reading, band))
                .toArray();
    }

    /** A tracer finds what does not depend on the source only once. */
    private static EnergyTracer tracer(Diffraction method, World world, Position sensor) {
        return new EnergyTracer(FEW.withDiffraction(method), sensor, 0.4, world);
    }

    private static EnergyReading read(EnergyTracer tracer, Position source) {
        return tracer.trace(Sites.broadband(source), new SplittableRandom(1), RayRecorder.NONE);
    }

    private static double directOrRound(EnergyReading reading, int band) {
        return Levels.ofRatio(reading.direct().get(band) + reading.diffracted().get(band));
    }

    private static World world(TriangleMesh mesh) {
        return Sites.world(mesh, OPAQUE);
    }

    private static double wavelength(int band) {
        return Atmosphere.STANDARD.speedOfSound() / OctaveBands.midband(band);
    }

    private static double inTheOpen(double distance, int band) {
        return LW - Levels.sphericalSpreading(distance) - air(distance, band);
    }

    private static double air(double distance, int band) {
        return distance * Atmosphere.STANDARD.attenuations()[band];
    }

    /** Level ground of squares. */
    private static TriangleMesh tiles(double half, double size) {
        int n = (int) Math.round(2 * half / size);
        float[] vertices = new float[3 * (n + 1) * (n + 1)];
        int[] corners = new int[6 * n * n];
        for (int i = 0; i <= n; i++) {
            for (int j = 0; j <= n; j++) {
                vertices[3 * (i * (n + 1) + j)] = (float) (i * size - half);
                vertices[3 * (i * (n + 1) + j) + 1] = (float) (j * size - half);
            }
        }
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                int at = i * (n + 1) + j;
                int[] square = {at, at + n + 1, at + n + 2, at, at + n + 2, at + 1};
                System.arraycopy(square, 0, corners, 6 * (i * n + j), 6);
            }
        }
        return TriangleMesh.of(vertices, corners);
    }
}
