package org.dronewatch.analysis.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.dronewatch.LongForm;
import org.dronewatch.Thorough;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldColumns;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.FieldTerms;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.analysis.field.DetectionField;
import org.dronewatch.analysis.field.FieldSite;
import org.dronewatch.geometry.Position;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.parallel.Workers;
import org.dronewatch.run.store.SiteStore;
import org.dronewatch.run.store.StoreKey;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.InterpolableSensor;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.RaySensor;
import org.dronewatch.sensor.Signal;
import org.dronewatch.world.World;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Interpolated levels against traced ones. */
class ExcessSurveyTest {
    private static final String EAR =
            """
              ear: {kind: acoustic, position: [0, 0, 4], propagation: {kind: energy-model, rays: 100}}
            """;

    /** Cells whose middles are on no face of a box. */
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 400, 10, List.of(3.0, 20.0, 60.0));

    private static final int PLACES = 400;

    /** Of a look whose rays have a standard error of half a decibel. */
    private static final Signal SIGNAL = new Signal(1.0, 50.0, "dB", 40.0, 0.5, 0.0);

    @TempDir
    private static Path directory;

    private static FieldProbe each;
    private static FieldColumns columns;
    private static List<Integer> reported;
    private static SurveyProgress progress;
    private static ExcessMap map;
    private static SensorLayer layer;

    @BeforeAll
    static void interpolate() throws IOException {
        FieldSite site = FieldSite.in(directory, EAR);
        each = ear(site, List.of(new Course(Course.Kind.HOVER, 0.0, new Position(0, 0, 0), Optional.empty())));
        columns = FieldColumns.of(each.world(), GRID);
        reported = Collections.synchronizedList(new ArrayList<>());
        progress = SurveyProgress.of(each, columns, reported::add);
        map = survey(2, progress);
        layer = layer(map, 2);
    }

    private static FieldProbe ear(FieldSite site, List<Course> courses) {
        return new FieldProbe(
                site.stage().world(),
                DetectionField.droneOf(site.stage(), FieldSite.DRONE),
                "ear",
                site.settings().enabledSensors().get("ear"),
                7,
                courses,
                FieldTerms.ONE_LOOK);
    }

    private static ExcessMap survey(int threads, SurveyProgress progress) {
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> ExcessSurvey.of(each, columns, PLACES, progress))
                    .orElseThrow();
        }
    }

    private static SensorLayer layer(ExcessMap excess, int threads) {
        FieldProbe probe = each.with(Optional.of(excess));
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> SensorLayer.of(probe, columns, cells -> {}));
        }
    }

    /** None of some 100 cells that are certain; of the others as many are detected as their probabilities add up to. */
    @Test
    void whereAProbabilityIsCertainATracedLookAgrees() {
        long seed = System.nanoTime();
        System.out.println("ExcessSurveyTest: seed " + seed);
        Random random = new Random(seed);
        Assessor assessor = each.newAssessor();
        int certain = 0;
        int undecided = 0;
        double difference = 0.0;
        double variance = 0.0;
        for (int i = 0; i < 120; i++) {
            int height = random.nextInt(columns.levels());
            int column = random.nextInt(columns.columns());
            int row = random.nextInt(columns.rows());
            if (!columns.isOpen(height, column, row)) {
                continue;
            }
            Position at = columns.middle(height, column, row);
            Assessment traced = each.assess(assessor, each.drone(at, 0), each.pointing(at));
            int step = layer.step(height, column, row, 0);
            double p = ProbabilityStep.probability(step);
            if (step == 0 || step == ProbabilityStep.CERTAIN) {
                certain++;
                assertThat(traced.probability()).as("seed %d at %s", seed, at).isEqualTo(p);
                assertThat(layer.cause(height, column, row, 0)).isEqualTo(traced.cause());
            } else {
                undecided++;
                difference += traced.probability() - p;
                variance += p * (1.0 - p);
            }
        }
        assertThat(certain).isGreaterThan(50);
        assertThat(undecided).isPositive();
        assertThat(Math.abs(difference)).as("seed %d", seed).isLessThan(4.5 * Math.sqrt(variance) + 1.0);
    }

    /**
     * The probability of an interpolated level stands for what is not known of a cell: looks in one cell hardly differ,
     * but over many cells, looks of runs with other seeds detect the drone as often as the probabilities add up to. Few
     * large errors determine the deviation of all, so probabilities may be closer to 0.5 than the frequencies, but are
     * not farther from it. Of frequencies with the right means, none varies more than if each were 0 or 1.
     */
    @Thorough
    @Test
    void looksOfOtherRunsDetectAsOftenAsTheProbabilitiesAddUpTo() {
        long seed = LongForm.seed(27);
        System.out.println("ExcessSurveyTest: seed " + seed);
        Random random = new Random(seed);
        int perCell = LongForm.count(20, 100);
        RaySensor ear = (RaySensor) each.settings().create();
        int[] cells = new int[2];
        double[] difference = new double[2];
        double[] variance = new double[2];
        for (int[] cell : undecided(random).subList(0, LongForm.count(30, 60))) {
            Position at = columns.middle(cell[0], cell[1], cell[2]);
            double p = ProbabilityStep.probability(layer.step(cell[0], cell[1], cell[2], 0));
            int hits = 0;
            for (int run = 0; run < perCell; run++) {
                Look look = Look.of(random.nextLong(), "ear", 0, 0.0);
                hits += ear.detects(each.world(), each.drone(at, 0), look) ? 1 : 0;
            }
            int half = p < 0.5 ? 0 : 1;
            cells[half]++;
            difference[half] += (double) hits / perCell - p;
            variance[half] += p * (1.0 - p);
        }
        System.out.printf(
                "    %d cells below 0.5: %.2f, variance %.2f; %d above: %.2f, variance %.2f%n",
                cells[0], difference[0], variance[0], cells[1], difference[1], variance[1]);
        assertThat(Math.min(cells[0], cells[1])).isGreaterThan(5);
        double rounding = 0.002;
        assertThat(Math.abs(difference[0] + difference[1]))
                .as("seed %d", seed)
                .isLessThan(3.0 * Math.sqrt(variance[0] + variance[1]) + rounding * (cells[0] + cells[1]));
        assertThat(difference[0]).as("seed %d", seed).isLessThan(3.0 * Math.sqrt(variance[0]) + rounding * cells[0]);
        assertThat(difference[1])
                .as("seed %d", seed)
                .isGreaterThan(-3.0 * Math.sqrt(variance[1]) - rounding * cells[1]);
        for (int half = 0; half < 2; half++) {
            assertThat(Math.abs(difference[half])).as("seed %d", seed).isLessThan(0.3 * cells[half]);
        }
    }

    /** Level, column and row of the cells whose probability is neither close to 0 nor to 1, in random order. */
    private static List<int[]> undecided(Random random) {
        List<int[]> cells = new ArrayList<>();
        for (int level = 0; level < columns.levels(); level++) {
            for (int column = 0; column < columns.columns(); column++) {
                for (int row = 0; row < columns.rows(); row++) {
                    double p = ProbabilityStep.probability(layer.step(level, column, row, 0));
                    if (columns.isOpen(level, column, row) && p > 0.02 && p < 0.98) {
                        cells.add(new int[] {level, column, row});
                    }
                }
            }
        }
        Collections.shuffle(cells, random);
        return cells;
    }

    /**
     * Just inside the shadow boundary of a box the drone is in sight, but its reflection from the ground is not, and
     * the edge weakens its sound: 33.5 dB, where all neighbours in sight suggest 38. Such cells are not certain by
     * them.
     */
    @Test
    void besideShadowBoundariesATracedLookAgrees() {
        Assessor assessor = each.newAssessor();
        InterpolableSensor sensor = assessor.interpolable().orElseThrow();
        int certain = 0;
        for (int height = 0; height < columns.levels(); height++) {
            for (int column = 1; column < columns.columns(); column++) {
                for (int row = 0; row < columns.rows(); row++) {
                    int step = layer.step(height, column, row, 0);
                    boolean isCertain = step == 0 || step == ProbabilityStep.CERTAIN;
                    if (!isCertain
                            || !columns.isOpen(height, column, row)
                            || !columns.isOpen(height, column - 1, row)) {
                        continue;
                    }
                    Position at = columns.middle(height, column, row);
                    Position beside = columns.middle(height, column - 1, row);
                    boolean isInSight = sensor.isInSight(each.world(), each.drone(at, 0));
                    if (isInSight != sensor.isInSight(each.world(), each.drone(beside, 0))) {
                        certain++;
                        Assessment traced = each.assess(assessor, each.drone(at, 0), each.pointing(at));
                        assertThat(traced.probability()).as("at %s", at).isEqualTo(ProbabilityStep.probability(step));
                    }
                }
            }
        }
        assertThat(certain).isGreaterThan(100);
    }

    /** Over a roof there are no positions between heights: all are soon taken, and the survey makes do with them. */
    @Test
    void aSurveyOverARoofEnds() {
        FieldGrid roof = new FieldGrid(0.0, 65.0, 8.0, 0.5, List.of(10.0, 20.0, 31.0));
        FieldColumns few = FieldColumns.of(each.world(), roof);
        assertThat(few.openCount()).isEqualTo(256);
        SurveyProgress progress = SurveyProgress.of(each, few, cells -> {});
        try (Workers workers = new Workers(2)) {
            ExcessMap over = workers.call(() -> ExcessSurvey.of(each, few, 250, progress))
                    .orElseThrow();
            assertThat(over.places().size() + over.heldOut().size()).isBetween(200, 250);
        }
    }

    /** Cells of traced positions have their signals. */
    @Test
    void tracedCellsAreExact() {
        int exact = 0;
        Assessor assessor = each.newAssessor();
        for (int height = 0; height < columns.levels(); height++) {
            for (int row = 0; row < columns.rows(); row++) {
                for (int column = 0; column < columns.columns(); column++) {
                    Position at = columns.middle(height, column, row);
                    if (map.traced(at).isPresent() && exact < 10) {
                        exact++;
                        double p = each.assess(assessor, each.drone(at, 0), each.pointing(at))
                                .probability();
                        assertThat(map.traced(at).get().probability()).isEqualTo(p);
                        assertThat(layer.step(height, column, row, 0)).isEqualTo(ProbabilityStep.of(p));
                    }
                }
            }
        }
        assertThat(exact).isEqualTo(10);
    }

    @Thorough
    @Test
    void theSameForAnyNumberOfThreads() {
        ExcessMap alone = survey(1, SurveyProgress.of(each, columns, cells -> {}));
        assertThat(alone.error()).isEqualTo(map.error());
        SensorLayer other = layer(alone, 3);
        for (int height = 0; height < columns.levels(); height++) {
            for (int row = 0; row < columns.rows(); row++) {
                for (int column = 0; column < columns.columns(); column++) {
                    assertThat(other.step(height, column, row, 0)).isEqualTo(layer.step(height, column, row, 0));
                }
            }
        }
    }

    /**
     * The loudest tone of a drone depends on its heading: beside a radar, which adds courses across its line of sight,
     * a microphone is interpolated in the same way as without it.
     */
    @Test
    void anotherSensorDoesNotChangeTheMap(@TempDir Path place) throws IOException {
        String narrow = EAR.replace("rays: 100", "rays: 100, criterion: narrow-band");
        List<ExcessMap> maps = new ArrayList<>();
        List<Integer> courses = new ArrayList<>();
        for (String sensors : List.of(narrow, narrow + FieldSite.ROUND)) {
            FieldSite.in(place, sensors);
            Path scene = place.resolve("site.yaml");
            String tones = "tones: {rotorSpeed: 6150 rpm, blades: 2, shares: [0.5, 0.3, 0.3]}\n    soundLevel:";
            Files.writeString(scene, Files.readString(scene).replace("soundLevel:", tones));
            SceneRunner runner = new SceneRunner(new SceneFile(scene));
            FieldSite site = new FieldSite(runner.settings(), runner.stage(runner.settings()));
            FieldProbe ear = ear(
                    site,
                    Course.all(
                            site.settings().enabledSensors(), DetectionField.droneOf(site.stage(), FieldSite.DRONE)));
            courses.add(ear.courses().size());
            maps.add(ExcessSurvey.of(ear, columns, 100, SurveyProgress.of(ear, columns, cells -> {}))
                    .orElseThrow());
        }
        assertThat(courses).containsExactly(9, 11);
        assertThat(maps.get(1).heldOut()).hasSize(10).isEqualTo(maps.get(0).heldOut());
        assertThat(maps.get(1).places()).isEqualTo(maps.get(0).places());
        assertThat(maps.get(1).error()).isEqualTo(maps.get(0).error());
    }

    /** What was kept interpolates the same, and a damaged file is not used. */
    @Test
    void aKeptMapIsTheSame(@TempDir Path place) throws IOException {
        SiteStore kept = new SiteStore(Optional.of(place), 1 << 28, 0.0, note -> {});
        StoreKey key = StoreKey.of("excess", List.of(), "one");
        kept.keep(() -> key, ExcessForm.FORM, map, 1.0);
        ExcessMap found = kept.find(key, ExcessForm.FORM).orElseThrow();
        assertThat(found.error()).isEqualTo(map.error());
        assertThat(found.places()).isEqualTo(map.places());
        assertThat(found.heldOut()).isEqualTo(map.heldOut());
        Position at = columns.middle(1, 3, 5);
        assertThat(found.at(at, true)).isEqualTo(map.at(at, true));
        try (Stream<Path> files = Files.list(place)) {
            Path file = files.findFirst().orElseThrow();
            byte[] bytes = Files.readAllBytes(file);
            bytes[bytes.length / 2] ^= 1;
            Files.write(file, bytes);
        }
        assertThat(kept.find(key, ExcessForm.FORM)).isEmpty();
    }

    /** Behind a box the level is that of its shadow, even at its border; where no sound arrives, there is none. */
    @Test
    void noLevelIsInterpolatedAcrossTheBorderOfAShadow() {
        List<TracedPlace> places = new ArrayList<>();
        Random random = new Random(1);
        for (int i = 0; i < 600; i++) {
            Position at = new Position(100 * random.nextDouble(), 100 * random.nextDouble(), 10);
            boolean isInSight = at.x() < 50;
            boolean isShut = at.x() > 75;
            places.add(
                    isShut
                            ? new TracedPlace(at, false, SIGNAL, -60.0, -60.0, 20.0 - at.x())
                            : new TracedPlace(
                                    at, isInSight, SIGNAL, isInSight ? 3.0 : -9.0, isInSight ? 0.0 : -12.0, 40.0));
        }
        ExcessMap step = new ExcessMap(places.subList(0, 500), places.subList(500, 600));
        Position lit = new Position(49.999, 50, 10);
        Position dark = new Position(50.001, 50, 10);
        assertThat(step.at(lit, true).orElseThrow().greatest()).isEqualTo(3.0);
        ExcessMap.Estimate hidden = step.at(dark, false, -12.0).orElseThrow();
        assertThat(hidden.greatest()).isEqualTo(-9.0);
        assertThat(hidden.rest()).isCloseTo(40.0, within(1e-12));
        assertThat(hidden.spread(50.0, -12.0)).isZero();
        assertThat(hidden.over(50.0, -12.0))
                .isCloseTo(10.0 * Math.log10(Math.pow(10, -1.2) + Math.pow(10, -1.0)), within(1e-12));
        ExcessMap.Estimate shut =
                step.at(new Position(75.001, 50, 10), false, -60.0).orElseThrow();
        assertThat(shut.over(50.0, -60.0)).isEqualTo(-60.0);
        assertThat(shut.spread(50.0, -60.0)).isZero();
        assertThat(step.at(new Position(150, 50, 10), true)).as("outside").isEmpty();
    }

    /** The error is that of the worst of 95 in a hundred positions; what is certain accounts for the worst of all. */
    @Test
    void theErrorIsMeasuredWhereNothingWasTraced() {
        List<TracedPlace> places = new ArrayList<>();
        List<TracedPlace> heldOut = new ArrayList<>();
        for (int i = 0; i < 400; i++) {
            // Twice the sound in the open: as much again on other paths.
            places.add(traced(new Position(i % 20, i / 20, 0), 10.0 * Math.log10(2.0)));
        }
        for (int i = 0; i < 100; i++) {
            Position at = new Position(4.5 + 0.1 * i, 7.3, 0);
            heldOut.add(traced(at, 10.0 * Math.log10(2.0) + 0.01 * (i + 1)));
        }
        InterpolationError error = new ExcessMap(places, heldOut).error();
        assertThat(error.places()).isEqualTo(400);
        assertThat(error.heldOut()).isEqualTo(100);
        assertThat(error.percentile95()).isCloseTo(0.95, within(1e-9));
        assertThat(error.ofLooks()).isCloseTo(0.5, within(1e-9));
        assertThat(error.percentile95OfLooks()).isCloseTo(0.98, within(1e-9));
        assertThat(error.deviation(0.0, true)).isCloseTo(Math.sqrt(101 * 201 / 6.0) / 100.0, within(1e-9));
        assertThat(error.greatest(0.0, true)).isBetween(1.0, 1.3);
        assertThat(error.bounds(true).beyond()).isBetween(0.99, 1.3);
        assertThat(error.bounds(false)).as("too few are hidden").isEqualTo(error.bounds(true));
    }

    /** A position in sight whose exact paths bring as much as in the open, which is 50 dB. */
    private static TracedPlace traced(Position at, double overOpen) {
        double rest = 50.0 + 10.0 * Math.log10(Math.pow(10.0, 0.1 * overOpen) - 1.0);
        return new TracedPlace(at, true, SIGNAL, overOpen, 0.0, rest);
    }

    @Test
    void fewCellsAreAllTracedAndTheLevelModelIsNotInterpolated() throws IOException {
        assertThat(ExcessSurvey.of(each, columns, columns.openCount(), SurveyProgress.of(each, columns, cells -> {})))
                .isEmpty();
        Map<String, InterpolationError> none = FieldSite.in(directory, FieldSite.ALL)
                .field(new FieldGrid(0.7, 0.3, 60, 20, List.of(60.0)), 1)
                .interpolated();
        assertThat(none).isEmpty();
    }

    /** All of them together count as much as the cells do; most are reported while they are traced. */
    @Test
    void tracedPositionsAreReportedAsTheyAreTraced() {
        int all = GRID.cells() * GRID.heights().size();
        int traced = reported.stream().mapToInt(Integer::intValue).sum();
        assertThat(reported).hasSizeBetween(PLACES - 10, PLACES).allMatch(cells -> cells <= 2 * all / PLACES);
        assertThat(traced).isBetween(9 * all / 10, all);
        progress.finish();
        progress.finish();
        assertThat(reported.stream().mapToInt(Integer::intValue).sum()).isEqualTo(all);
    }

    @Test
    void indoorsIsWhereNearlyNoSkyIsSeen() {
        World site = each.world();
        assertThat(ExcessSurvey.isIndoors(site, new Position(0, 0, 4))).isFalse();
        assertThat(ExcessSurvey.isIndoors(site, new Position(0, 65, 4)))
                .as("in the building")
                .isTrue();
        TriangleMesh roof =
                TriangleMesh.of(new float[] {-9, -9, 5, 9, -9, 5, 9, 9, 5, -9, 9, 5}, new int[] {0, 1, 2, 0, 2, 3});
        assertThat(ExcessSurvey.isIndoors(World.of(roof), new Position(0, 0, 0)))
                .as("a shelter")
                .isFalse();
    }
}
