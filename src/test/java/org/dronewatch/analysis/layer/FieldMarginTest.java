package org.dronewatch.analysis.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Comparator;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.Random;
import java.util.stream.IntStream;
import org.dronewatch.analysis.cell.CellCode;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.Margin;
import org.dronewatch.analysis.cell.MarginCode;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldCoverage;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.analysis.survey.CellExaminer;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** What a field keeps of margins, against assessments made anew; and which sensor decides, by the rule in words. */
class FieldMarginTest {
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0, 60.0));

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static DetectionField field;
    private static FieldCoverage coverage;

    @BeforeAll
    static void assess() throws IOException {
        site = FieldSite.in(directory, FieldSite.ALL);
        field = site.field(GRID, 2);
        coverage = new FieldCoverage(field, FieldCoverage.Choice.WORST, 0.5);
    }

    private static Random seeded() {
        long seed = System.nanoTime();
        System.out.println("FieldMarginTest: seed " + seed);
        return new Random(seed);
    }

    /** A value to 0.1 dB, or a bound that holds; the sign always agrees with the cause. */
    @Test
    void marginsHoldForAssessmentsMadeAnew() {
        Random random = seeded();
        Map<Margin.Known, Integer> met = new EnumMap<>(Margin.Known.class);
        for (int i = 0; i < 600; i++) {
            int height = random.nextInt(GRID.heights().size());
            int column = random.nextInt(GRID.columns());
            int row = random.nextInt(GRID.columns());
            int course = random.nextInt(field.courses().size());
            for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
                Margin margin = field.margin(sensor, height, column, row, course);
                if (!field.isOpen(height, column, row)) {
                    assertThat(margin.kind()).isEqualTo(Margin.Known.NOTHING);
                    continue;
                }
                Assessment anew =
                        field.assess(sensor, height, column, row, course).orElseThrow();
                if (anew.probabilityError() > 0.0) {
                    continue; // Other random rays.
                }
                String as = field.sensors().get(sensor) + " on course " + course + " in " + column + ", " + row + ", "
                        + height + ": " + margin;
                met.merge(margin.kind(), 1, Integer::sum);
                double exact = anew.marginDb();
                switch (margin.kind()) {
                    case VALUE -> assertThat(exact).as(as).isCloseTo(margin.db(), within(0.1));
                    case AT_LEAST -> assertThat(exact).as(as).isGreaterThanOrEqualTo(margin.db());
                    case AT_MOST -> assertThat(exact).as(as).isLessThanOrEqualTo(margin.db());
                    case NO_SIGNAL -> assertThat(exact).as(as).isEqualTo(Double.NEGATIVE_INFINITY);
                    default -> assertThat(anew.cause()).as(as).isEqualTo(Cause.UNKNOWN);
                }
                assertThat(exact).as(as).isBetween(margin.least(), margin.greatest());
            }
        }
        assertThat(met)
                .containsKeys(Margin.Known.VALUE, Margin.Known.AT_LEAST, Margin.Known.AT_MOST, Margin.Known.NO_SIGNAL);
        System.out.println("FieldMarginTest: " + met);
    }

    /**
     * Among all sensors by their probabilities, then causes, then margins, then order; where the field does not know
     * who decides, sensors are equal but for their margins.
     */
    @Test
    void theSensorThatDecidesIsTheFirstByProbabilityCauseAndMargin() {
        Random random = seeded();
        CellExaminer examiner = new CellExaminer(coverage, site.stage());
        int known = 0;
        for (int i = 0; i < 150; i++) {
            int height = random.nextInt(GRID.heights().size());
            int column = random.nextInt(GRID.columns());
            int row = random.nextInt(GRID.columns());
            if (!field.isOpen(height, column, row)) {
                continue;
            }
            int course = coverage.courseAt(height, column, row);
            CellExaminer.CellEvidence evidence =
                    examiner.examine(height, column, row).orElseThrow();
            int expected = IntStream.range(0, field.sensors().size())
                    .boxed()
                    .sorted(Comparator.comparing((Integer sensor) -> -field.step(sensor, height, column, row, course))
                            .thenComparing(sensor -> -field.cause(sensor, height, column, row, course)
                                    .ordinal())
                            .thenComparing(sensor ->
                                    -evidence.sensors().get(sensor).assessment().marginDb()))
                    .findFirst()
                    .orElseThrow();
            assertThat(evidence.deciding()).isEqualTo(expected);
            assertThat(field.cause(expected, height, column, row, course))
                    .isEqualTo(coverage.cause(height, column, row));
            OptionalInt asKept = coverage.deciding(height, column, row);
            if (asKept.isPresent()) {
                known++;
                assertThat(asKept.getAsInt()).isEqualTo(expected);
            }
        }
        assertThat(known).isGreaterThan(50);
    }

    @Test
    void marginsThatDoNotSufficeDoNotDecide() {
        Margin three = MarginCode.margin(MarginCode.of(3.0));
        Margin five = MarginCode.margin(MarginCode.of(5.0));
        Margin atLeastFour = MarginCode.margin(MarginCode.atLeast(4.3));
        Margin atMostFive = MarginCode.margin(MarginCode.atMost(4.3));
        Margin none = MarginCode.margin(MarginCode.NO_SIGNAL);
        Margin unknown = MarginCode.margin(MarginCode.NOTHING);
        assertThat(certain(three, five)).hasValue(1);
        assertThat(certain(three, atLeastFour)).hasValue(1);
        assertThat(certain(five, atLeastFour)).isEmpty();
        assertThat(certain(atLeastFour, three, none)).hasValue(0);
        assertThat(certain(none, atMostFive)).isEmpty();
        assertThat(certain(none, none)).as("the first").hasValue(0);
        assertThat(certain(three, three)).as("within a step").isEmpty();
        assertThat(certain(three, unknown)).isEmpty();
        assertThat(Dominance.certain(2, sensor -> sensor, sensor -> unknown))
                .as("by probability")
                .hasValue(1);
    }

    private static OptionalInt certain(Margin... margins) {
        return Dominance.certain(margins.length, sensor -> 7, sensor -> margins[sensor]);
    }

    @Test
    void marginsAreKeptInTwelveBits() {
        for (int tenths = -511; tenths <= 511; tenths++) {
            int code = MarginCode.of(0.1 * tenths);
            assertThat(code).isBetween(2, (1 << MarginCode.BITS) - 1).matches(MarginCode::isPossible);
            assertThat(MarginCode.margin(code)).isEqualTo(new Margin(Margin.Known.VALUE, tenths / 10.0));
        }
        assertThat(MarginCode.margin(MarginCode.of(-0.001)).db()).as("a miss").isEqualTo(-0.1);
        assertThat(MarginCode.margin(MarginCode.of(0.0)).db()).isZero();
        assertThat(MarginCode.margin(MarginCode.of(80.0))).isEqualTo(new Margin(Margin.Known.AT_LEAST, 51.1));
        assertThat(MarginCode.margin(MarginCode.of(-80.0))).isEqualTo(new Margin(Margin.Known.AT_MOST, -51.1));
        assertThat(MarginCode.margin(MarginCode.atLeast(-2.5))).isEqualTo(new Margin(Margin.Known.AT_LEAST, -3.0));
        assertThat(MarginCode.margin(MarginCode.atMost(-2.5))).isEqualTo(new Margin(Margin.Known.AT_MOST, -2.0));
        assertThat(MarginCode.atMost(Double.NEGATIVE_INFINITY)).isEqualTo(MarginCode.NO_SIGNAL);
        assertThat(MarginCode.atLeast(Double.NEGATIVE_INFINITY)).isEqualTo(MarginCode.NOTHING);
        assertThat(MarginCode.of(Double.NaN)).isEqualTo(MarginCode.NOTHING);
    }

    @Test
    void codesOfCoursesAreWhatWasWritten() {
        Random random = seeded();
        for (int i = 0; i < 300; i++) {
            // More than 256 different codes do not fit in the first byte.
            int courses = 1 + random.nextInt(i % 10 == 0 ? 700 : 70);
            int different = 1 + random.nextInt(courses);
            int margin = MarginCode.of(0.1 * i);
            int[] codes = IntStream.range(0, courses)
                    .map(course -> {
                        int code = random.nextInt(different);
                        return CellCode.of(code % 256, Cause.values()[code / 256], margin);
                    })
                    .toArray();
            byte[] pool = new byte[5 + CourseCodes.most(courses)];
            int end = CourseCodes.put(pool, 5, codes);
            byte[] whole = Arrays.copyOf(pool, end);
            assertThat(CourseCodes.isPossible(whole, 5, courses)).isTrue();
            assertThat(CourseCodes.isPossible(Arrays.copyOf(pool, end - 1), 5, courses))
                    .isFalse();
            for (int course = 0; course < courses; course++) {
                assertThat(CourseCodes.at(whole, 5, course)).isEqualTo(codes[course]);
            }
        }
    }
}
