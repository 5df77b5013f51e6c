package org.dronewatch.sensor.acoustic.energy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.ThreadLocalRandom;
import org.dronewatch.Thorough;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.kdtree.KDTree;
import org.dronewatch.sensor.RayRecorder;
import org.dronewatch.sensor.acoustic.edge.EdgePath;
import org.dronewatch.sensor.acoustic.energy.EnergyModel.Ground;
import org.dronewatch.sensor.acoustic.propagation.Diffraction;
import org.dronewatch.sensor.acoustic.propagation.PathCurvature;
import org.dronewatch.sound.Atmosphere;
import org.dronewatch.sound.BackgroundNoise;
import org.dronewatch.sound.Barrier;
import org.dronewatch.sound.Levels;
import org.dronewatch.sound.OctaveBands;
import org.dronewatch.sound.Wind;
import org.dronewatch.sound.surface.SurfaceMaterial;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Wind and temperature bend sound: up into a shadow, or down over walls. */
class RefractionTest {
    private static final double SPEED = Atmosphere.STANDARD.speedOfSound();
    private static final double HEIGHT = 1.5;
    private static final SurfaceMaterial HARD = SurfaceMaterial.uniform("perfect_mirror", 0, 0);

    /** Rough, so that rays scatter. */
    private static final SurfaceMaterial ROUGH = SurfaceMaterial.uniform("any", 0.3, 0.4);

    private static final EnergyModel MODEL = EnergyModel.DEFAULT.withRays(1);

    /** The curvature at -0.1 /s. */
    private static final double UP = 0.1 / SPEED;

    /** Air in which the speed of sound grows by some m/s in each metre. */
    static Atmosphere withGradient(double perSecond) {
        Atmosphere air = Atmosphere.STANDARD;
        return air.withTemperatureGradient(2 * air.temperature() * perSecond / SPEED);
    }

    static World flat(SurfaceMaterial surface, Atmosphere air) {
        return new World(KDTree.of(Sites.square(4000, 0)), BackgroundNoise.of(20), List.of(surface), air);
    }

    static EnergyReading read(EnergyModel model, World world, Position source, Position sensor) {
        return new EnergyTracer(model, sensor, 0.4, world)
                .trace(Sites.broadband(source), new SplittableRandom(1), RayRecorder.NONE);
    }

    /** Levels over the free field. */
    static double[] gains(EnergyModel model, World world, Position source, Position sensor) {
        EnergyReading heard = read(model, world, source, sensor);
        EnergyReading open = new EnergyTracer(model, sensor, 0.4, world).inTheOpen(Sites.broadband(source));
        double[] gains = new double[OctaveBands.COUNT];
        for (int band = 0; band < gains.length; band++) {
            gains[band] = heard.level(band) - open.level(band);
        }
        return gains;
    }

    private static Position at(double distance, double height) {
        return new Position(distance, 0, height);
    }

    /**
     * Over flat ground the shadow begins where an arc that grazes the ground meets both ends: at sqrt(2 R hs) + sqrt(2
     * R hr) with R = c / 0.1, 363, 555 and 930 m for the parabola and 363, 554 and 924 m for the circle.
     */
    @ParameterizedTest
    @CsvSource({"10, 363, 363", "30, 555, 554", "100, 930, 924"})
    void upwindTheShadowBeginsWhereAnArcGrazesTheGround(double height, double parabola, double circle) {
        World world = flat(HARD, withGradient(-0.1));
        double lit = 100;
        double dark = 2000;
        while (dark - lit > 0.1) {
            double middle = 0.5 * (lit + dark);
            boolean isLit = read(MODEL, world, at(middle, height), at(0, HEIGHT))
                            .direct()
                            .get(3)
                    > 0;
            lit = isLit ? middle : lit;
            dark = isLit ? dark : middle;
        }

        double formula = Math.sqrt(2 * SPEED / 0.1) * (Math.sqrt(height) + Math.sqrt(HEIGHT));
        assertThat(formula).isCloseTo(parabola, within(0.5));
        // Pieces touch the arc from below: what is 2 cm over the ground counts as hidden.
        assertThat(lit).isBetween(circle * 0.99, parabola * 1.001);
    }

    /** No step at the border, never louder behind it, and 20 to 25 dB in the end, over hard ground and over grass. */
    @Thorough
    @ParameterizedTest
    @EnumSource(Ground.class)
    void theLevelFallsFromTheBorderWithoutAStep(Ground ground) {
        for (SurfaceMaterial surface : List.of(HARD, SurfaceMaterial.uniform("grass_50mm", 0.5, 0))) {
            World world = flat(surface, withGradient(-0.1));
            EnergyModel model = MODEL.withGround(ground);
            double[] before = gains(model, world, at(358, 10), at(0, HEIGHT));
            double[] atBorder = gains(model, world, at(364, 10), at(0, HEIGHT));
            for (double distance = 358.5; distance < 2000; distance += distance < 370 ? 0.5 : 3) {
                double[] here = gains(model, world, at(distance, 10), at(0, HEIGHT));
                for (int band = 0; band < here.length; band++) {
                    double step = distance < 370 ? 1.0 : 2.0;
                    assertThat(here[band])
                            .as("%s %s, %.1f m, band %d", ground, surface.name(), distance, band)
                            .isBetween(before[band] - step, before[band] + 0.2);
                    // The way over the bulge is up to 15 m longer, in air that takes 77 dB/km at 8 kHz.
                    assertThat(here[band]).isGreaterThan(band < 6 ? -25.5 : -27.0);
                }
                before = here;
            }
            for (int band = 0; band < before.length; band++) {
                // The shadow takes 20 to 25 dB of what the border has, of the free field where grass has cancelled it
                // there; the detour over the bulge, up to 25 m, takes more in the air.
                double reference = Math.max(0.0, atBorder[band]);
                double air = 25 * Atmosphere.STANDARD.attenuation(OctaveBands.midband(band));
                double most = (ground == Ground.COHERENT ? 29.0 : 25.05) + air;
                assertThat(reference - before[band])
                        .as("%s %s, 2 km, band %d", ground, surface.name(), band)
                        .isBetween(20.0, most);
            }
        }
    }

    /**
     * The way over a bulge touches it from one grazing point to the other. In the frame in which arcs are straight, the
     * length over the straight line is half the integral of the squared slope less that of the line.
     */
    @ParameterizedTest
    @CsvSource({"400, 10", "600, 10", "1000, 10", "1500, 30"})
    void theDetourOverTheBulgeIsTheIntegralOfItsSlope(double distance, double height) {
        World world = flat(HARD, withGradient(-0.1));
        EdgePath path = new EdgePath(world);
        double sourceSide = Math.sqrt(2 * height / UP);
        double sensorSide = Math.sqrt(2 * HEIGHT / UP);
        double first = UP * (distance / 2 - sourceSide);
        double last = -UP * (distance / 2 - sensorSide);
        double line = (HEIGHT - height) / distance;
        double squares = sourceSide * first * first
                + sensorSide * last * last
                + (first * first * first - last * last * last) / (3 * UP);
        double detour = 0.5 * (squares - distance * line * line);

        assertThat(path.find(at(distance, height), at(0, HEIGHT), UP)).isTrue();
        // The outline is a chain of chords of the bulge, 2 cm off it at most; slopes of 0.15 are not quite small.
        assertThat(path.pathDifference()).isCloseTo(detour, within(0.03 * detour + 2e-3));
    }

    /**
     * Test case TC08 of ISO/TR 17534-4 in favourable conditions: CNOSSOS-EU's arcs of the radius max(1000 m, 8 d), d
     * the level distance of source and receiver, 340 m/s and nominal midbands.
     */
    @Test
    void theWallOfTestCase8InFavourableConditions() {
        float below = -3000;
        float[] corners = {175, 50, 6, 190, 10, 6, 175, 50, below, 190, 10, below};
        World wall = World.of(TriangleMesh.of(corners, new int[] {0, 1, 3, 0, 3, 2}));
        Position source = new Position(10, 10, 1);
        Position receiver = new Position(200, 50, 4);
        double curvature = -1 / Math.max(1000, 8 * Math.hypot(190, 40));
        double[] expected = {5.68, 6.41, 7.60, 9.30, 11.47, 13.99, 16.73, 19.60};
        int[] midbands = {63, 125, 250, 500, 1000, 2000, 4000, 8000};
        EdgePath path = new EdgePath(wall);

        assertThat(path.find(source, receiver, curvature)).isTrue();
        assertThat(path.edges().count()).isEqualTo(1);
        assertThat(Diffraction.CNOSSOS.measuresArcs()).isTrue();
        for (int band = 0; band < OctaveBands.COUNT; band++) {
            assertThat(Barrier.cnossos(path.arcDifference(), 0, 340.0 / midbands[band]))
                    .isCloseTo(expected[band], within(0.005));
        }
        // In time, sound over the wall loses less on the direct sound than in length.
        assertThat(path.pathDifference()).isBetween(0.0, path.arcDifference());
    }

    /**
     * The same by the model, for the product's own speed of sound: more is heard behind a wall downwind than upwind.
     */
    @ParameterizedTest
    @EnumSource(value = Diffraction.class, names = "OFF", mode = EnumSource.Mode.EXCLUDE)
    void downwindAWallHidesLessThanUpwind(Diffraction diffraction) {
        TriangleMesh site = World.merge(List.of(Sites.square(3000, 0), Sites.wall(0, 100, -500, 500, 0, 8)));
        EnergyModel model = MODEL.withDiffraction(diffraction);
        Position source = at(400, 4);
        Position sensor = at(0, HEIGHT);
        double[] levels = new double[3];
        for (int i = 0; i < 3; i++) {
            Atmosphere air = withGradient(0.05 * (i - 1));
            World world = new World(
                    KDTree.of(site), BackgroundNoise.of(20), List.of(SurfaceMaterial.uniform("any", 1, 0)), air);
            levels[i] = gains(model, world, source, sensor)[3];
        }

        assertThat(levels[1]).isGreaterThan(levels[0] + 0.5);
        assertThat(levels[2]).isGreaterThan(levels[1] + 0.5);
    }

    /** As it gets windier the sound behind a wall changes without a step, until arcs pass over it. */
    @Test
    void behindAWallNoStepAsAirBendsMore() {
        TriangleMesh site = World.merge(List.of(Sites.square(3000, 0), Sites.wall(0, 200, -500, 500, 0, 8)));
        double before = Double.NaN;
        double first = Double.NaN;
        for (double gradient = 0.0; gradient < 0.15; gradient += 0.0005) {
            World world = new World(
                    KDTree.of(site),
                    BackgroundNoise.of(20),
                    List.of(SurfaceMaterial.uniform("any", 1, 0)),
                    withGradient(gradient));
            double here = gains(MODEL, world, at(400, 4), at(0, HEIGHT))[5];
            first = Double.isNaN(first) ? here : first;
            if (!Double.isNaN(before)) {
                assertThat(here).as("gradient %s", gradient).isBetween(before - 0.1, before + 1.0);
            }
            before = here;
        }
        assertThat(first).isLessThan(-10);
        assertThat(before).isCloseTo(0, within(0.1));
    }

    /** Rough ground scatters a part of what it reflects on both sides of the border. */
    @ParameterizedTest
    @EnumSource(Ground.class)
    void overRoughGroundThereIsNoStepAtTheBorderEither(Ground ground) {
        World world = flat(ROUGH, withGradient(-0.1));
        EnergyTracer tracer = new EnergyTracer(EnergyModel.DEFAULT.withGround(ground), at(0, HEIGHT), 0.4, world);
        EnergyReading before = tracer.onExactPaths(Sites.broadband(at(358, 10)));
        for (double distance = 358.25; distance < 370; distance += 0.25) {
            EnergyReading here = tracer.onExactPaths(Sites.broadband(at(distance, 10)));
            for (int band = 0; band < OctaveBands.COUNT; band++) {
                assertThat(here.level(band))
                        .as("%s m, band %d", distance, band)
                        .isBetween(before.level(band) - 0.3, before.level(band) + 0.1);
            }
            before = here;
        }
    }

    /** Also over rough ground: it scatters as much of the sound as in still air, whichever way the paths are found. */
    @ParameterizedTest
    @EnumSource(Ground.class)
    void theSlightestGradientChangesNothing(Ground ground) {
        EnergyModel model = EnergyModel.DEFAULT.withGround(ground);
        for (SurfaceMaterial surface : List.of(HARD, ROUGH, SurfaceMaterial.uniform("all", 0, 1))) {
            for (double distance : new double[] {20, 100, 300}) {
                SoundSource sound = Sites.broadband(at(distance, 10));
                EnergyReading still = new EnergyTracer(model, at(0, HEIGHT), 0.4, flat(surface, Atmosphere.STANDARD))
                        .onExactPaths(sound);
                for (double gradient : new double[] {-1e-7, 1e-7}) {
                    EnergyReading bent = new EnergyTracer(
                                    model, at(0, HEIGHT), 0.4, flat(surface, withGradient(gradient)))
                            .onExactPaths(sound);
                    for (int band = 0; band < OctaveBands.COUNT; band++) {
                        assertThat(bent.level(band))
                                .as("%s, %s m, gradient %s, band %d", surface.name(), distance, gradient, band)
                                .isCloseTo(still.level(band), within(0.01));
                    }
                }
            }
        }
    }

    /** The wind turned and both ends exchanged leave the sound as it is; a turned site with its wind, too. */
    @ParameterizedTest
    @ValueSource(doubles = {0, 180, 35})
    void exchangedAgainstTheWindAndTurnedWithIt(double bearing) {
        long seed = ThreadLocalRandom.current().nextLong();
        SplittableRandom random = new SplittableRandom(seed);
        for (int i = 0; i < 5; i++) {
            Position source = new Position(random.nextDouble(100, 700), random.nextDouble(-200, 200), 20);
            Position sensor = new Position(0, 0, HEIGHT);
            double from = Math.toRadians(bearing);
            Wind wind = new Wind(8, from, 0.03);
            World world = flat(HARD, Atmosphere.STANDARD.withWind(wind));
            World reverse = flat(HARD, Atmosphere.STANDARD.withWind(wind.withFrom(from + Math.PI)));
            double[] there = gains(MODEL, world, source, sensor);
            double[] back = gains(MODEL, reverse, sensor, source);
            double angle = random.nextDouble(2 * Math.PI);
            Position turned = new Position(
                    source.x() * Math.cos(angle) + source.y() * Math.sin(angle),
                    source.y() * Math.cos(angle) - source.x() * Math.sin(angle),
                    source.z());
            double[] round =
                    gains(MODEL, flat(HARD, Atmosphere.STANDARD.withWind(wind.withFrom(from + angle))), turned, sensor);
            for (int band = 0; band < there.length; band++) {
                assertThat(back[band]).as("seed %d, pair %d", seed, i).isCloseTo(there[band], within(0.02));
                assertThat(round[band]).as("seed %d, pair %d", seed, i).isCloseTo(there[band], within(0.02));
            }
        }
    }

    /**
     * A wind that hardly bends leaves paths over several walls as they are, far from the origin and at oblique walls,
     * too.
     */
    @Test
    void aBreezeDoesNotHideReflections() {
        double angle = 0.3;
        TriangleMesh street = World.merge(List.of(
                Sites.turned(Sites.wall(0, 2000, -500, 500, 0, 20), at -> turned(at, angle)),
                Sites.turned(Sites.wall(0, 2060, -500, 500, 0, 20), at -> turned(at, angle))));
        EnergyModel model = EnergyModel.DEFAULT;
        double[] mirrored = new double[2];
        for (int i = 0; i < 2; i++) {
            Atmosphere air =
                    i == 0 ? Atmosphere.STANDARD : Atmosphere.STANDARD.withWind(new Wind(2, Math.toRadians(250), 0.03));
            World world = new World(KDTree.of(street), BackgroundNoise.of(20), List.of(HARD), air);
            EnergyReading reading = read(
                    model, world, turned(new Position(2021, 90, 8), angle), turned(new Position(2045, -40, 6), angle));
            mirrored[i] = reading.mirrored().get(3);
        }

        assertThat(mirrored[0]).isGreaterThan(0);
        assertThat(Levels.ofRatio(mirrored[1] / mirrored[0])).isCloseTo(0, within(0.01));
    }

    private static Position turned(Position at, double angle) {
        return new Position(
                at.x() * Math.cos(angle) - at.y() * Math.sin(angle),
                at.x() * Math.sin(angle) + at.y() * Math.cos(angle),
                at.z());
    }

    /** Scattered sound does not get into the shadow straight, either: all of it together stays as faint. */
    @Test
    void inTheShadowScatteredSoundIsFaint() {
        Position source = at(700, 10);
        Position sensor = at(0, HEIGHT);
        EnergyReading still = read(EnergyModel.DEFAULT, flat(ROUGH, Atmosphere.STANDARD), source, sensor);
        EnergyReading upwind = read(EnergyModel.DEFAULT, flat(ROUGH, withGradient(-0.1)), source, sensor);
        int band = 4;

        assertThat(still.reverberant().get(band)).isGreaterThan(0);
        assertThat(upwind.level(band)).isLessThan(still.level(band) - 10);
        assertThat(upwind.standardError()).isLessThan(0.3);
    }

    /**
     * Sources: curvature is that of c / (g cos gamma), none along the vertical, and no arc is sharper than its length.
     */
    @Test
    void curvature() {
        Wind west = new Wind(10, Math.toRadians(270), 0.03);
        PathCurvature curvature = PathCurvature.of(Atmosphere.STANDARD.withWind(west), 30, HEIGHT);
        double shear = (west.speedAt(30) - west.speedAt(HEIGHT)) / (30 - HEIGHT);

        assertThat(curvature.along(100, 0, 0)).isCloseTo(-shear / SPEED, within(1e-9));
        assertThat(curvature.along(-100, 0, 0)).isCloseTo(shear / SPEED, within(1e-9));
        assertThat(curvature.along(0, 100, 0)).isCloseTo(0, within(1e-9));
        assertThat(curvature.along(100, 0, 100)).isCloseTo(-shear / SPEED * Math.sqrt(0.5), within(1e-9));
        assertThat(curvature.along(0, 0, 100)).isZero();
        assertThat(new PathCurvature(1, 0, 0).along(200, 0, 0)).isEqualTo(1.0 / 200);
        PathCurvature inversion = PathCurvature.of(withGradient(0.1), 30, HEIGHT);
        assertThat(inversion.along(100, 50, 10)).isCloseTo(-0.1 / SPEED, within(1e-9));
        assertThat(PathCurvature.of(Atmosphere.STANDARD, 30, HEIGHT)).isEqualTo(PathCurvature.NONE);
        assertThat(Levels.ofRatio(1)).isZero();
    }
}
