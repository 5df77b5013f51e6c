package org.dronewatch.analysis.cell;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Chance;
import org.dronewatch.sensor.ProbabilityResolution;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The probability of a detection within some time, from that of single looks. */
class FieldTermsTest {
    /** A radar that looks twice a second, and a camera at 5 Hz with an observer. */
    private static final String SENSORS =
            """
              west: {kind: radar, position: [-120, 40, 6], minRange: 1, maxRange: 400, elevationWidth: 90 deg, rate: 2,
                budget: {range: 120, crossSection: 0.01}, minSpeed: 0 m/s, detection: {kind: chance, pulses: 8}}
              eye: {kind: camera, position: [0, 0, 4], fov: 40 deg, width: 800, height: 600, rate: 5,
                detection: {kind: target-task, byChance: true}}
            """;

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static SensorSettings<?> radar;
    private static SensorSettings<?> observed;

    @BeforeAll
    static void read() throws IOException {
        site = FieldSite.in(directory, SENSORS);
        radar = site.settings().enabledSensors().get("west");
        observed = site.settings().enabledSensors().get("eye");
        assertThat(radar.chance()).isEqualTo(Chance.PER_LOOK);
        assertThat(observed.chance()).isEqualTo(Chance.PER_ENCOUNTER);
    }

    private static FieldTerms terms(double seconds) {
        return FieldTerms.ONE_LOOK.withWithin(seconds);
    }

    /** Just above the boundary, the probability on these terms is rounded to the step, and just below it, it is not. */
    @Test
    void theSideOfAStepIsThatOfTheBoundaryOfALook() {
        for (FieldTerms terms : List.of(FieldTerms.ONE_LOOK, terms(0.5), terms(3.0), terms(600))) {
            for (double covered : new double[] {0.008, 0.1, 0.5, 0.9, 0.996}) {
                int step = ProbabilityStep.toCover(covered);
                ProbabilityResolution side = terms.sideOf(step, radar);
                assertThat(side.isSideOnly()).isTrue();
                double above = terms.probability(side.high(), radar);
                double below = terms.probability(side.high() * (1.0 - 1e-5), radar);
                assertThat(ProbabilityStep.of(above))
                        .as("%s, %s", terms, covered)
                        .isEqualTo(step);
                assertThat(ProbabilityStep.of(below))
                        .as("%s, %s", terms, covered)
                        .isEqualTo(step - 1);
            }
        }
    }

    /** Without looks, with an observer, and where only certainty is enough, all probabilities matter. */
    @Test
    void whereNoBoundaryOfALookIsKnownAllProbabilitiesMatter() {
        int half = ProbabilityStep.toCover(0.5);
        assertThat(terms(0.3).sideOf(half, radar)).isEqualTo(terms(0.3).resolution(radar));
        assertThat(terms(3.0).sideOf(half, observed)).isEqualTo(ProbabilityResolution.upTo(1.0));
        assertThat(FieldTerms.ONE_LOOK.sideOf(ProbabilityStep.CERTAIN, radar))
                .isEqualTo(FieldTerms.ONE_LOOK.resolution(radar));
        assertThatIllegalArgumentException().isThrownBy(() -> ProbabilityResolution.sideOf(0.0));
        assertThatIllegalArgumentException().isThrownBy(() -> ProbabilityResolution.upTo(1.01));
    }

    /** One minus the chance that each of the looks misses, multiplied look by look. */
    @Test
    void eachLookIsAnotherChance() {
        for (double look : new double[] {1e-9, 1e-6, 0.004, 0.3, 0.5, 0.996, 1 - 1e-12}) {
            double missed = 1.0;
            for (int looks = 1; looks <= 40; looks++) {
                missed *= 1.0 - look;
                double detected = terms(looks / 2.0 + 0.49).probability(look, radar);
                assertThat(detected).as("%s, %d looks", look, looks).isCloseTo(1.0 - missed, within(1e-12));
                assertThat(detected).as("not certain").isStrictlyBetween(0.0, 1.0);
            }
        }
        assertThat(FieldTerms.ONE_LOOK.probability(0.3, radar)).isEqualTo(0.3);
    }

    /** The mean over observers of one minus exp(-hazard t): 100,000 draws at even distances. */
    @Test
    void anObserverIsDrawnOnceAndThenSearches() {
        int draws = 100_000;
        for (double look : new double[] {0.01, 0.4, 0.9, 1.0}) {
            for (double time : new double[] {0.2, 1.0, 5.0, 60.0}) {
                double sum = 0.0;
                for (int i = 0; i < draws; i++) {
                    double hazard = Chance.PER_ENCOUNTER.hazard(look, 5.0, (i + 0.5) / draws);
                    sum += 1.0 - Math.exp(-hazard * time);
                }
                assertThat(terms(time).probability(look, observed))
                        .as("%s in %s s", look, time)
                        .isCloseTo(sum / draws, within(1.0 / draws));
            }
        }
        assertThat(terms(5.0).probability(0.9, observed))
                .as("the page of cameras")
                .isCloseTo(0.660, within(0.0005));
    }

    @Test
    void zeroAndOneAreExact() {
        assertThat(terms(10.0).probability(0.0, radar)).isZero();
        assertThat(terms(10.0).probability(1.0, radar)).isEqualTo(1.0);
        assertThat(terms(10.0).probability(0.0, observed)).isZero();
        assertThat(terms(86_400.0).probability(Double.MIN_VALUE, radar)).isPositive();
        assertThat(terms(0.49).probability(1.0, radar))
                .as("before the first look")
                .isZero();
        assertThat(terms(0.5).probability(1.0, radar)).isEqualTo(1.0);
    }

    /** 0.3 s at 10 Hz are three looks, though 0.3 times 10 is not 3 in every representation. */
    @Test
    void aWholeNumberOfLooksIsNotRoundedDown() {
        SensorSettings<?> atTheRateOfTheCamera = ((RadarSettings) radar).withRate(observed.rate());
        for (int looks = 1; looks < 2000; looks++) {
            double expected = 1.0 - Math.pow(0.999, looks);
            assertThat(terms(looks * 0.2).probability(0.001, atTheRateOfTheCamera))
                    .isCloseTo(expected, within(1e-12));
        }
    }

    @Test
    void eachOfTheTermsCanBeChangedAlone() {
        FieldTerms searching = terms(3.0).withPointing(FieldTerms.Turning.SEARCH);

        assertThat(searching).isEqualTo(new FieldTerms(FieldTerms.Turning.SEARCH, Optional.of(3.0)));
        assertThat(searching.withWithin(4.0)).isEqualTo(new FieldTerms(FieldTerms.Turning.SEARCH, Optional.of(4.0)));
    }

    @Test
    void theTimeHasLimits() {
        for (double wrong : List.of(0.0, -1.0, 86_401.0, Double.NaN, Double.POSITIVE_INFINITY)) {
            assertThatIllegalArgumentException().isThrownBy(() -> terms(wrong)).withMessageContaining("within");
        }
    }

    /**
     * In every cell the field holds the step nearest to what follows from the assessment there, not from its own step:
     * a tiny probability of a look may not be rounded up first.
     */
    @Test
    void theFieldHoldsWhatFollowsFromTheExactProbability() {
        FieldGrid grid = new FieldGrid(0.7, 0.3, 380, 20, List.of(12.0));
        DetectionField field = site.field(grid, terms(7.3), 2);
        DetectionField once = site.field(grid, 2);
        int uncertain = 0;
        int roundedUp = 0;
        for (int cell = 0; cell < grid.cells(); cell++) {
            int column = cell % grid.columns();
            int row = cell / grid.columns();
            for (int sensor = 0; sensor < 2; sensor++) {
                Optional<Assessment> assessed = field.assess(sensor, 0, column, row, 0);
                if (assessed.isEmpty() || assessed.get().cause() == Cause.UNKNOWN) {
                    continue;
                }
                double look = assessed.get().probability();
                double missed = Math.pow(1.0 - look, 14);
                double expected = sensor == 0 ? 1.0 - missed : look * (1.0 - Math.exp(-look * 7.2 / 3.4));
                assertThat(field.probability(sensor, 0, column, row, 0))
                        .as("%s at %d, %d", field.sensors().get(sensor), column, row)
                        .isCloseTo(expected, within(look > 0.0 && look < 1.0 ? 1.0 / 250 + 1e-9 : 0.0));
                assertThat(field.cause(sensor, 0, column, row, 0)).isEqualTo(once.cause(sensor, 0, column, row, 0));
                uncertain += expected > 0.01 && expected < 0.99 ? 1 : 0;
                double ofStep = 1.0 - Math.pow(1.0 - once.probability(sensor, 0, column, row, 0), 14);
                roundedUp += sensor == 0 && ofStep > expected + 0.02 ? 1 : 0;
            }
        }
        assertThat(uncertain).isGreaterThan(50);
        assertThat(roundedUp)
                .as("cells in which the step of a look would be too much")
                .isPositive();
    }
}
