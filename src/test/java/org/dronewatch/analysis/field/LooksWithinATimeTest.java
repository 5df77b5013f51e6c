package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.layer.LookWindow;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a sensor that searches detects within a time, look by look. */
class LooksWithinATimeTest {
    private static final String SENSORS =
            """
              eye: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600, rate: 5}
              observed: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600, rate: 5,
                detection: {kind: target-task, byChance: true}}
            """;

    /** Phases of a period; the looks at 5 Hz do not meet them in turn. */
    private static final int PHASES = 48;

    private static final double PERIOD = 7.31;

    @TempDir
    private static Path directory;

    private static SensorSettings<?> eye;
    private static SensorSettings<?> observed;

    @BeforeAll
    static void read() throws IOException {
        FieldSite site = FieldSite.in(directory, SENSORS);
        eye = site.settings().enabledSensors().get("eye");
        observed = site.settings().enabledSensors().get("observed");
        assertThat(eye.chance()).isEqualTo(Chance.PER_LOOK);
        assertThat(observed.chance()).isEqualTo(Chance.PER_ENCOUNTER);
    }

    private static LookWindow window(double seconds, SensorSettings<?> sensor) {
        return LookWindow.of(FieldTerms.ONE_LOOK.withWithin(seconds), sensor, PERIOD, PHASES)
                .orElseThrow();
    }

    private static double[] of(double[] all, List<Integer> at) {
        return at.stream().mapToDouble(i -> all[i]).toArray();
    }

    /** The probability of a look that begins so many looks after a phase. */
    private static double look(double[] all, int phase, int look) {
        return all[Math.floorMod(Math.round(phase + look * PHASES / (5.0 * PERIOD)), PHASES)];
    }

    /** One minus the chance that each look misses, for each phase at which they begin; for 1 to 100 looks. */
    @Test
    void theMeanOverAllPhasesOfTheLooksFromThereOn() {
        long seed = System.nanoTime();
        System.out.println("LooksWithinATimeTest: seed " + seed);
        Random random = new Random(seed);
        for (int looks = 1; looks <= 100; looks++) {
            double[] all = new double[PHASES];
            for (int i = 10; i < 10 + random.nextInt(1, 30); i++) {
                all[i] = random.nextInt(4) == 0 ? random.nextInt(2) : random.nextDouble();
            }
            List<Integer> at = IntStream.range(8, 42).boxed().toList();
            double expected = 0.0;
            for (int phase = 0; phase < PHASES; phase++) {
                double missed = 1.0;
                for (int look = 0; look < looks; look++) {
                    missed *= 1.0 - look(all, phase, look);
                }
                expected += (1.0 - missed) / PHASES;
            }
            assertThat(window(looks / 5.0, eye).probability(of(all, at), at))
                    .as("%d looks, seed %d", looks, seed)
                    .isCloseTo(expected, within(1e-12));
        }
    }

    /** Observers who are drawn once and then search through all looks: 2,000 of them, at even distances. */
    @Test
    void anObserverIsDrawnOnceForAllLooks() {
        double[] all = new double[PHASES];
        double[] some = {0.2, 0.5, 0.7, 0.7, 0.7004, 0.9, 1.0, 0.3, 0.0, 0.1};
        System.arraycopy(some, 0, all, 20, some.length);
        List<Integer> at = IntStream.range(20, 30).boxed().toList();
        for (int looks : new int[] {1, 10, 36, 60, 150}) {
            double expected = 0.0;
            for (int draw = 0; draw < 2000; draw++) {
                double needed = (draw + 0.5) / 2000;
                for (int phase = 0; phase < PHASES; phase++) {
                    double time = 0.0;
                    for (int look = 0; look < looks; look++) {
                        double p = look(all, phase, look);
                        time += p >= needed ? 0.2 * p / 3.4 : 0.0;
                    }
                    expected += (1.0 - Math.exp(-time)) / PHASES / 2000;
                }
            }
            assertThat(window(looks / 5.0, observed).probability(of(all, at), at))
                    .as("%d looks", looks)
                    .isCloseTo(expected, within(5e-4));
        }
    }

    @Test
    void zeroAndOneAreExact() {
        List<Integer> one = List.of(7);
        LookWindow whole = window(60.0, eye);
        assertThat(whole.probability(new double[] {1.0}, one)).isEqualTo(1.0);
        assertThat(whole.probability(new double[] {0.999999}, one)).isStrictlyBetween(0.99, 1.0);
        assertThat(whole.probability(new double[] {Double.MIN_VALUE}, one)).isPositive();
        assertThat(whole.probability(new double[] {0.0}, one)).isZero();
        assertThat(whole.probability(new double[0], List.of())).isZero();
        assertThat(window(0.2, eye).probability(new double[] {1.0}, one)).isEqualTo(1.0 / PHASES);
        assertThat(LookWindow.of(FieldTerms.ONE_LOOK.withWithin(0.19), eye, PERIOD, PHASES))
                .as("before the first look")
                .isEmpty();
        assertThat(LookWindow.of(FieldTerms.ONE_LOOK, eye, PERIOD, PHASES)).isEmpty();
    }
}
