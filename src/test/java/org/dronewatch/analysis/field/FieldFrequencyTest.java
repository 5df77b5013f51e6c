package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.Wilson;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Encounters;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Where a field holds a probability between 0 and 1, that is how often looks detect the drone: over 1,000 seeds, the
 * 99 % interval of Wilson (1927) around the frequency contains it in at least 98 % of the cells.
 */
class FieldFrequencyTest {
    private static final int SEEDS = 1000;

    /**
     * Cells in the long form. Each lies outside with a chance of 1 %, or 1.2 % where the field's own estimate has an
     * error. By the binomial distribution, more than 2 % of 2,000 then do so with a chance below 0.1 %, and more than
     * 2 % of 500 with one of 1.3 to 4 %.
     */
    private static final int MANY = 2000;

    /** Cells in the long form where looks take long. */
    private static final int FEWER = 500;

    /** Cells among which those are looked for that are not certain. */
    private static final int MOST_TRIES = LongForm.count(20_000, 200_000);

    /** The quantile of the normal distribution for 99 %. */
    private static final double Z = 2.575829;

    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(12.0, 40.0));

    /** The same in larger cells, except in the long form. */
    private static final FieldGrid COARSE = new FieldGrid(0.7, 0.3, 380, LongForm.count(38, 20), GRID.heights());

    /** Two radars whose echoes fluctuate, one with a notch for clutter. */
    private static final String SENSORS =
            """
              west: {kind: radar, position: [-120, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 2,
                budget: {range: 120, crossSection: 0.01}, minSpeed: 3 m/s, detection: {kind: chance, pulses: 8}}
              east: {kind: radar, position: [120, -40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 2,
                budget: {range: 140, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
            """;

    /**
     * Two thermal cameras by chance: a program that finds spots in frames, and an observer. The program's picture is so
     * noisy that a small drone is lost within the grid.
     */
    private static final String THERMAL =
            """
              program: {kind: thermal, position: [-150, -150, 6], aim: {azimuth: 45 deg, elevation: 5 deg}, fov: 70 deg,
                width: 320, height: 240, netd: 0.3, rate: 2, byChance: true, pointTargets: {}}
              watched: {kind: thermal, position: [150, -150, 6], aim: {azimuth: 315 deg, elevation: 5 deg}, fov: 40 deg,
                width: 640, height: 480, rate: 1, byChance: true}
            """;

    /** A microphone that hears what the boxes hide by some of its random rays alone. */
    private static final String EAR =
            """
              ear: {kind: acoustic, position: [0, 0, 4], rate: 2,
                propagation: {kind: level-model, initialRays: 3, reflectionsPerHit: 4, maxOrder: 2, attenuation: 0.01}}
            """;

    /** The first look: a program has then examined some frames. */
    private static final int FIRST_LOOK = 10;

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static FieldSite thermal;
    private static FieldSite ear;

    @BeforeAll
    static void read() throws IOException {
        site = FieldSite.in(Files.createDirectory(directory.resolve("radars")), SENSORS);
        ear = FieldSite.in(Files.createDirectory(directory.resolve("ear")), EAR);
        thermal = FieldSite.in(Files.createDirectory(directory.resolve("thermal")), THERMAL);
    }

    /** Whether the interval around a frequency contains a probability. */
    private static boolean isWithin(double probability, int hits, int of) {
        double[] ends = Wilson.interval(hits, of, Z);
        return probability >= ends[0] && probability <= ends[1];
    }

    /**
     * Compares the field with looks.
     *
     * @param sensors numbers of those that are compared
     * @param seconds in which the drone has to be detected; 0 for a single look
     */
    private static void assertFrequencies(FieldSite of, int[] sensors, double seconds, int cells) {
        assertFrequencies(of, GRID, sensors, seconds, cells);
    }

    private static void assertFrequencies(FieldSite of, FieldGrid grid, int[] sensors, double seconds, int cells) {
        FieldTerms terms = seconds == 0.0 ? FieldTerms.ONE_LOOK : FieldTerms.ONE_LOOK.withWithin(seconds);
        DetectionField field = of.field(grid, terms, 2);
        Drone sample = DetectionField.droneOf(of.stage(), FieldSite.DRONE);
        // The short form has a fixed seed: by chance, one cell in a hundred lies outside.
        long seed = LongForm.seed(27);
        System.out.println("FieldFrequencyTest: seed " + seed);
        Random random = new Random(seed);
        int compared = 0;
        List<String> outside = new ArrayList<>();
        for (int i = 0; i < MOST_TRIES && compared < cells; i++) {
            int sensor = sensors[random.nextInt(sensors.length)];
            int height = random.nextInt(grid.heights().size());
            int column = random.nextInt(grid.columns());
            int row = random.nextInt(grid.columns());
            int course = random.nextInt(field.courses().size());
            double expected = field.probability(sensor, height, column, row, course);
            if (!field.isOpen(height, column, row) || expected == 0.0 || expected == 1.0) {
                continue;
            }
            Drone there = sample.at(field.courses()
                    .get(course)
                    .at(field.middle(height, column, row), sample.settings().speed()));
            int hits = hits(of, field.sensors().get(sensor), there, seconds, random.nextLong());
            compared++;
            if (!isWithin(expected, hits, SEEDS)) {
                outside.add("%s but %d in [%d, %d, %d, %d]".formatted(expected, hits, height, column, row, course));
            }
        }
        System.out.println(compared + " cells, outside: " + outside);
        assertThat(compared).as("cells, seed %d", seed).isEqualTo(cells);
        assertThat(outside).as("of %d cells, seed %d", cells, seed).hasSizeLessThanOrEqualTo(cells / 50);
    }

    private static int hits(FieldSite of, String id, Drone there, double seconds, long seed) {
        SensorSettings<?> settings = of.settings().enabledSensors().get(id);
        Sensor sensor = settings.create();
        int looks = seconds == 0.0 ? 1 : (int) Math.floor(seconds * settings.rate() + 1e-9);
        int hits = 0;
        for (int run = 0; run < SEEDS; run++) {
            if (sensor instanceof RaySensor rays) {
                Look look = Look.of(seed + run, id, FIRST_LOOK, FIRST_LOOK / settings.rate());
                hits += rays.detects(of.stage().world(), there, look) ? 1 : 0;
                continue;
            }
            boolean isDetected = false;
            Encounters encounters = Encounters.NONE;
            for (int number = FIRST_LOOK; number < FIRST_LOOK + looks && !isDetected; number++) {
                Look look = Look.of(seed + run, id, number, number / settings.rate())
                        .withEncounters(encounters);
                List<Observation> seen = sensor.observe(of.stage().world(), List.of(there), look);
                isDetected = seen.stream().anyMatch(one -> one.isDetected());
                encounters = Encounters.after(look, settings.rate(), seen);
            }
            hits += isDetected ? 1 : 0;
        }
        return hits;
    }

    /**
     * The sensors of packaged scenes that are not certain: radars, and an observer, who has two seconds, since he needs
     * time; radars have one look.
     */
    @Thorough
    @ParameterizedTest
    @CsvSource({
        "scenes/meadow.yaml, intruder, 3000, 100,, camera, 2, 15",
        "scenes/meadow.yaml, intruder, 3000, 100,, radar, 0, 40",
        "scenes/birds.yaml, intruder, 900, 30,, radar, 0, 0",
        "scenes/false-alarms.yaml, intruder, 2400, 80,, radar, 0, 0",
        "multi-sensor, quadrotor, 200, 2, 6 8 10 12, microphone, 0, 0",
    })
    void realScenesDetectAsOftenAsTheFieldSays(
            String scene,
            String drone,
            double side,
            double cell,
            String heights,
            String sensor,
            double seconds,
            int inTheBuild) {
        int cells = LongForm.count(inTheBuild, MANY);
        assumeTrue(cells > 0);
        FieldTerms terms = seconds == 0.0 ? FieldTerms.ONE_LOOK : FieldTerms.ONE_LOOK.withWithin(seconds);
        PackagedSite real =
                PackagedSite.of(scene, drone, side, LongForm.IS_ON ? cell : 2.0 * cell, heights, terms, sensor, null);
        long seed = LongForm.seed(27);
        System.out.println("FieldFrequencyTest: seed " + seed);
        Random random = new Random(seed);
        double rate = real.sensor(sensor).rate();
        int looks = seconds == 0.0 ? 1 : (int) Math.floor(seconds * rate + 1e-9);
        int compared = 0;
        List<String> outside = new ArrayList<>();
        for (PackagedSite.Cell one : real.cells(MOST_TRIES, random)) {
            double expected = real.field().probability(0, one.height(), one.column(), one.row(), one.course());
            if (compared < cells && expected > 0.0 && expected < 1.0) {
                int hits = 0;
                long first = random.nextLong();
                for (int run = 0; run < SEEDS; run++) {
                    hits += real.isDetected(sensor, real.at(one), first + run, looks) ? 1 : 0;
                }
                compared++;
                if (!isWithin(expected, hits, SEEDS)) {
                    outside.add(expected + " but " + hits + " of " + SEEDS + " in " + one);
                }
            }
        }
        System.out.println(scene + ": " + sensor + " in " + compared + " cells, outside: " + outside);
        assertThat(compared).isPositive();
        assertThat(outside).as("of %d cells, seed %d", compared, seed).hasSizeLessThanOrEqualTo(compared / 50);
    }

    @Test
    void singleLooksDetectAsOftenAsTheFieldSays() {
        assertFrequencies(site, new int[] {0, 1}, 0.0, LongForm.count(100, MANY));
    }

    /** Four looks in two seconds. */
    @Test
    void looksWithinATimeDetectAsOftenAsTheFieldSays() {
        assertFrequencies(site, new int[] {0, 1}, 2.2, LongForm.count(50, MANY));
    }

    /** Random rays decide. */
    @Test
    void aMicrophoneBehindAnObstacleDetectsAsOftenAsTheFieldSays() {
        FieldGrid grid = new FieldGrid(0.7, 0.3, 380, LongForm.IS_ON ? 10 : 38, GRID.heights());
        assertFrequencies(ear, grid, new int[] {0}, 0.0, LongForm.count(20, MANY));
    }

    /** The noise of frames decides. */
    @Thorough
    @Test
    void aProgramThatFindsSpotsDetectsAsOftenAsTheFieldSays() {
        assertFrequencies(thermal, COARSE, new int[] {0}, 0.0, LongForm.count(5, FEWER));
    }

    /** Chance decides once whether the observer of a thermal picture is able to, and then when. */
    @Thorough
    @Test
    void theObserverOfAThermalCameraDetectsAsOftenAsTheFieldSays() {
        assertFrequencies(thermal, COARSE, new int[] {1}, 3.0, LongForm.count(3, FEWER));
    }

    /** Its ends are where a normal test of a probability just rejects the frequency (score test). */
    @Test
    void theIntervalIsWilsons() {
        for (double probability = 1e-5; probability < 0.05; probability += 1e-5) {
            double deviation = Math.sqrt(probability * (1.0 - probability) / 1000);
            boolean isAccepted = Math.abs(0.003 - probability) <= 2.575829 * deviation;
            assertThat(isWithin(probability, 3, 1000)).as("%s", probability).isEqualTo(isAccepted);
        }
        assertThat(isWithin(0.004, 0, 1000)).as("the least step of a field").isTrue();
    }
}
