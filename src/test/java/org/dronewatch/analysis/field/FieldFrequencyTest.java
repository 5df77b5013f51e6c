package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.dronewatch.LongForm;
import org.dronewatch.Wilson;
import org.dronewatch.drone.Drone;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Sensor;
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

    /** Cells among which those are looked for that are not certain. */
    private static final int MOST_TRIES = 200_000;

    /** The quantile of the normal distribution for 99 %. */
    private static final double Z = 2.575829;

    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(12.0, 40.0));

    /** Two radars whose echoes fluctuate, one with a notch for clutter. */
    private static final String SENSORS =
            """
              west: {kind: radar, position: [-120, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 2,
                budget: {range: 120, crossSection: 0.01}, minSpeed: 3 m/s, detection: {kind: chance, pulses: 8}}
              east: {kind: radar, position: [120, -40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 2,
                budget: {range: 140, crossSection: 0.01}, notch: {kind: high-pass, halfPowerSpeed: 4 m/s},
                detection: {kind: chance, pulses: 8}}
            """;

    @TempDir
    private static Path directory;

    private static FieldSite site;

    @BeforeAll
    static void read() throws IOException {
        site = FieldSite.in(directory, SENSORS);
    }

    /** Whether the interval around a frequency contains a probability. */
    private static boolean isWithin(double probability, int hits, int of) {
        double[] ends = Wilson.interval(hits, of, Z);
        return probability >= ends[0] && probability <= ends[1];
    }

    /**
     * Compares the field with looks.
     *
     * @param looks each time, the drone is detected if one of so many detects it
     */
    private static void assertFrequencies(FieldTerms terms, int looks, int cells) {
        DetectionField field = site.field(GRID, terms, 2);
        Drone sample = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
        // The short form has a fixed seed: by chance, one cell in a hundred lies outside.
        long seed = LongForm.IS_ON ? System.nanoTime() : 27;
        System.out.println("FieldFrequencyTest: seed " + seed);
        Random random = new Random(seed);
        int compared = 0;
        int outside = 0;
        while (compared < cells) {
            int sensor = random.nextInt(2);
            int height = random.nextInt(GRID.heights().size());
            int column = random.nextInt(GRID.columns());
            int row = random.nextInt(GRID.columns());
            int course = random.nextInt(field.courses().size());
            double expected = field.probability(sensor, height, column, row, course);
            if (!field.isOpen(height, column, row) || expected == 0.0 || expected == 1.0) {
                continue;
            }
            Drone there = sample.at(field.courses()
                    .get(course)
                    .at(field.middle(height, column, row), sample.settings().speed()));
            int hits = hits(field.sensors().get(sensor), there, looks, random.nextLong());
            compared++;
            outside += isWithin(expected, hits, SEEDS) ? 0 : 1;
        }
        assertThat(outside).as("of %d cells, seed %d", cells, seed).isLessThanOrEqualTo(cells / 50);
    }

    private static int hits(String id, Drone there, int looks, long seed) {
        Sensor sensor = site.settings().enabledSensors().get(id).create();
        int hits = 0;
        for (int run = 0; run < SEEDS; run++) {
            boolean isDetected = false;
            for (int look = 0; look < looks && !isDetected; look++) {
                isDetected =
                        sensor
                                .observe(
                                        site.stage().world(), List.of(there), Look.of(seed + run, id, look, 0.5 * look))
                                .stream()
                                .anyMatch(seen -> seen.isDetected());
            }
            hits += isDetected ? 1 : 0;
        }
        return hits;
    }

    /**
     * The sensors of packaged scenes that are not certain: radars, and an observer, who has two seconds, since he needs
     * time; radars have one look.
     */
    @ParameterizedTest
    @CsvSource({
        "scenes/meadow.yaml, intruder, 3000, 100, camera, 2, 15",
        "scenes/meadow.yaml, intruder, 3000, 100, radar, 0, 40",
        "scenes/birds.yaml, intruder, 900, 30, radar, 0, 0",
        "scenes/false-alarms.yaml, intruder, 2400, 80, radar, 0, 0",
    })
    void realScenesDetectAsOftenAsTheFieldSays(
            String scene, String drone, double side, double cell, String sensor, double seconds, int inTheBuild) {
        int cells = LongForm.count(inTheBuild, 500);
        assumeTrue(cells > 0);
        FieldTerms terms = seconds == 0.0 ? FieldTerms.ONE_LOOK : FieldTerms.ONE_LOOK.withWithin(seconds);
        PackagedSite real = PackagedSite.of(scene, drone, side, cell, null, terms, sensor, null);
        long seed = LongForm.IS_ON ? System.nanoTime() : 27;
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
        assertFrequencies(FieldTerms.ONE_LOOK, 1, LongForm.count(100, 2000));
    }

    /** Four looks in two seconds. */
    @Test
    void looksWithinATimeDetectAsOftenAsTheFieldSays() {
        assertFrequencies(FieldTerms.ONE_LOOK.withWithin(2.2), 4, LongForm.count(50, 1000));
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
