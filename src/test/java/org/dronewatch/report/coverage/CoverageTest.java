package org.dronewatch.report.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.Color;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.dronewatch.analysis.Coverage;
import org.dronewatch.analysis.CoverageGrid;
import org.dronewatch.geometry.Position;
import org.dronewatch.parallel.Workers;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.report.coverage.table.CoverageTable;
import org.dronewatch.report.sheet.CoveragePicture;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.Stage;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A plain with one wall: areas known by geometry, and the picture shows them. */
class CoverageTest {
    private static final CoverageGrid GRID = new CoverageGrid(0, 0, 400, 100, 2);

    @TempDir
    private static Path directory;

    private static SceneSettings settings;
    private static Stage stage;

    /** Of the plain, which no test changes. */
    private static Coverage coverage;

    /** A radar that sees up to 150 m all round, one that looks 90 degrees wide to the east, a microphone for 60 m. */
    @BeforeAll
    static void plain() throws IOException {
        Files.writeString(
                directory.resolve("plain.obj"),
                // y is up: the ground, and a wall of 20 m by 30 m height, 50 m to the north.
                "v -500 0 -500\nv 500 0 -500\nv 500 0 500\nv -500 0 500\nf 1 4 3\nf 1 3 2\n"
                        + "v -10 0 -50\nv 10 0 -50\nv 10 30 -50\nv -10 30 -50\nf 5 6 7\nf 5 7 8\n");
        Path file = directory.resolve("site.yaml");
        Files.writeString(
                file,
                """
                world: {models: [plain.obj], backgroundNoise: 20}
                drones:
                  one:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [0, 300, 2]}
                    soundLevel: 38
                sensors:
                  round: {kind: radar, position: [0, 0, 2], minRange: 1, maxRange: 150, elevationWidth: 90 deg, budget: {range: 5000, crossSection: 0.01}}
                  east: {kind: radar, position: [0, 0, 2], minRange: 1, maxRange: 150, elevationWidth: 90 deg, azimuthWidth: 90 deg, aim: {azimuth: 90 deg}, budget: {range: 5000, crossSection: 0.01}}
                  ear: {kind: acoustic, position: [0, 0, 2], propagation: {kind: level-model, initialRays: 1, reflectionsPerHit: 1, maxOrder: 0}}
                """);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        settings = runner.settings();
        stage = runner.stage(settings);
        coverage = coverage(settings, 2);
    }

    private static Coverage coverage(SceneSettings of, int threads) {
        try (Workers workers = new Workers(threads)) {
            return workers.call(() -> Coverage.of(of, stage, "one", GRID, points -> {}));
        }
    }

    @Test
    void areasAreThoseOfGeometry() {
        double disc = Math.PI * 150 * 150;
        // Behind the wall a ring sector of atan(10 / 50) to both sides is dark, from 50 m north on.
        double half = Math.atan2(10, 50);
        double shadow = half * 150 * 150 - 10 * 50;

        assertThat(coverage.area("round")).isCloseTo(disc - shadow, within(0.01 * disc));
        assertThat(coverage.area("east")).isCloseTo(0.25 * disc, within(0.01 * disc));
        assertThat(coverage.area("ear")).isCloseTo(Math.PI * 60 * 60 - half * 60 * 60 + 500, within(0.02 * disc));
        assertThat(coverage.areaOfKind("radar")).isEqualTo(coverage.area("round"));
        assertThat(coverage.isReached("round", 50, 20)).as("behind the wall").isFalse();
        assertThat(coverage.isReached("round", 50, 80))
                .as("as far on the other side")
                .isTrue();
    }

    /**
     * The same geometry, by what is missing: a ring sector behind the wall, the rest of the square, three quarters of a
     * disc.
     */
    @Test
    void whatIsMissingHasTheCauseOfItsGeometry() {
        double disc = Math.PI * 150 * 150;
        double half = Math.atan2(10, 50);
        Map<Cause, Integer> round = coverage.causes("round");
        Map<Cause, Integer> east = coverage.causes("east");
        Map<Cause, Integer> ear = coverage.causes("ear");

        assertThat(area(round, Cause.HIDDEN_BY_BUILDING)).isCloseTo(half * 150 * 150 - 500, within(0.01 * disc));
        assertThat(area(round, Cause.OUT_OF_RANGE)).isCloseTo(400 * 400 - disc, within(0.01 * disc));
        assertThat(round).containsOnlyKeys(Cause.HIDDEN_BY_BUILDING, Cause.OUT_OF_RANGE);
        assertThat(area(east, Cause.OUT_OF_VIEW)).isCloseTo(0.75 * disc, within(0.01 * disc));
        assertThat(east).containsOnlyKeys(Cause.OUT_OF_VIEW, Cause.OUT_OF_RANGE);
        assertThat(area(ear, Cause.HIDDEN_BY_BUILDING)).isCloseTo(half * 60 * 60 - 500, within(0.01 * disc));
        assertThat(ear).containsOnlyKeys(Cause.HIDDEN_BY_BUILDING, Cause.TOO_WEAK);
        assertThat(coverage.area("ear") + area(ear, Cause.TOO_WEAK) + area(ear, Cause.HIDDEN_BY_BUILDING))
                .isEqualTo(400 * 400);
    }

    /** The areas of geometry once more, as people read them: in per cent of the square, which is all ground. */
    @Test
    void theTableHasAColumnForEachCauseAndEachLineIsAHundredPerCent() {
        List<String> lines = CoverageTable.causes(coverage, coverage.causes());
        double disc = Math.PI * 150 * 150 / (400 * 400) * 100;
        double shadow = (Math.atan2(10, 50) * 150 * 150 - 500) / (400 * 400) * 100;

        assertThat(lines.get(0)).isEqualTo("in % of the 10,000 cells with ground below them:");
        assertThat(lines.get(1).split(" {2,}"))
                .containsExactly(
                        "sensor",
                        "kind",
                        "detected",
                        "out of range",
                        "out of view",
                        "hidden by a building",
                        "signal too weak");
        assertThat(lines).hasSize(5);
        double[] round = percents(lines.get(2), "round", "radar");
        assertThat(round[0]).isCloseTo(disc - shadow, within(1.0));
        assertThat(round[1]).isCloseTo(100 - disc, within(1.0));
        assertThat(round[2]).isZero();
        assertThat(round[3]).isCloseTo(shadow, within(1.0));
        assertThat(round[4]).isZero();
        assertThat(percents(lines.get(3), "east", "radar")[2]).isCloseTo(0.75 * disc, within(1.0));
        for (String line : lines.subList(2, 5)) {
            assertThat(Arrays.stream(percents(line, "\\w+", "\\w+")).sum())
                    .as(line)
                    .isCloseTo(100.0, within(0.3));
        }
        assertThat(lines.subList(1, 5))
                .extracting(String::length)
                .containsOnly(lines.get(1).length());
    }

    private static double[] percents(String line, String sensor, String kind) {
        assertThat(line).matches(sensor + " +" + kind + " .*");
        return Arrays.stream(line.split(" +"))
                .skip(2)
                .mapToDouble(text -> text.equals("-") ? 0.0 : text.equals("<0.1") ? 0.05 : Double.parseDouble(text))
                .toArray();
    }

    /** One of ten thousand cells is more than nothing. */
    @Test
    void aFractionThatRoundsToNothingIsNotShownAsNothing() {
        Map<String, Map<Cause, Integer>> causes = new HashMap<>(coverage.causes());
        causes.put("east", Map.of(Cause.TOO_FAST, 1));
        List<String> lines = CoverageTable.causes(coverage, causes);
        assertThat(lines.get(1)).contains("  too fast  ");
        assertThat(lines.get(3)).contains("      <0.1 ");
        assertThat(lines.get(2)).doesNotContain("0.0");
    }

    private static double area(Map<Cause, Integer> causes, Cause cause) {
        return causes.get(cause) * GRID.cellArea();
    }

    @Test
    void aCellIsReachedWhereItIsAssessedAsDetected() {
        for (String sensor : settings.sensors().keySet()) {
            for (int cell = 0; cell < GRID.cells() * GRID.cells(); cell += 7) {
                Assessment one = coverage.assess(sensor, cell % GRID.cells(), cell / GRID.cells())
                        .orElseThrow();
                boolean reached = coverage.isReached(sensor, cell % GRID.cells(), cell / GRID.cells());
                assertThat(one.cause() == Cause.DETECTED).isEqualTo(reached);
                assertThat(one.probability()).isEqualTo(reached ? 1.0 : 0.0);
            }
        }
    }

    /**
     * A mount that turns all round makes of a camera's wedge a disc of the range that its narrowest field of view
     * gives.
     */
    @Test
    void aCameraOnAPositionerReachesAllRound() {
        PositionerSettings mount = PositionerSettings.DEFAULT.withCues("round");
        CameraSettings fixed = CameraSettings.at(new Position(0, 0, 2)).withResolution(1600, 1200);
        double near = Math.sqrt(0.0528 / 12) * fixed.focalLength();
        SceneSettings with = settings.withSensor("fixed", fixed).withSensor("turning", fixed.withPositioner(mount));
        Coverage turned = coverage(with, 2);
        double wedge = 2 * Math.atan(800 / fixed.focalLength()) / (2 * Math.PI);

        assertThat(turned.area("turning")).isBetween(0.7 * Math.PI * near * near, 1.6 * Math.PI * near * near);
        assertThat(turned.area("fixed") / turned.area("turning")).isBetween(0.7 * wedge, 1.3 * wedge);
    }

    /**
     * Reports drones in the east alone, after something that is none: of those in the west it has no observation at
     * all.
     */
    private record Eastward(Position position, Map<String, Double> figures) implements SensorSettings<Sensor> {
        @Override
        public Eastward withPosition(Position other) {
            return new Eastward(other, figures);
        }

        @Override
        public double rate() {
            return 1.0;
        }

        @Override
        public String kind() {
            return "eastward";
        }

        @Override
        public Sensor create() {
            Reading enough = new Reading(2.0, 1.0, "");
            return (world, drones, look) -> Stream.concat(
                            Stream.of(Observation.ofNothing(look.id(kind()), enough, Optional.empty())),
                            drones.stream()
                                    .filter(drone -> drone.position().x > position.x())
                                    .map(drone -> new Observation(
                                                    look.id(kind()), drone.id(), drone.distance(position), enough)
                                            .withFigures(figures)))
                    .toList();
        }
    }

    @Test
    void aSensorMayReportNothingOfADroneAndSomethingThatIsNone() {
        Coverage half = coverage(settings.withSensor("half", new Eastward(new Position(0, 0, 2), Map.of())), 2);
        assertThat(half.area("half")).isEqualTo(200.0 * 400.0);
        assertThat(half.causes("half")).containsExactly(Map.entry(Cause.TOO_WEAK, 5000));

        Assessment west = half.assess("half", 10, 10).orElseThrow();
        assertThat(west.cause()).isEqualTo(Cause.TOO_WEAK);
        assertThat(west.probability()).isZero();
        Assessment east = half.assess("half", 90, 10).orElseThrow();
        assertThat(east.cause()).isEqualTo(Cause.DETECTED);
        assertThat(east.quantity()).isEqualTo(2.0);
    }

    /** Each of its looks happens to detect the drone: what counts is the probability of that. */
    @Test
    void aProbabilityThatASensorStatesDecides() {
        for (double probability : new double[] {0.25, 0.75}) {
            Eastward sensor = new Eastward(new Position(0, 0, 2), Map.of(Observation.PROBABILITY, probability));
            Coverage half = coverage(settings.withSensor("half", sensor), 2);
            boolean isLikely = probability >= 0.5;

            assertThat(half.area("half")).isEqualTo(isLikely ? 200.0 * 400.0 : 0.0);
            assertThat(half.assess("half", 90, 10).orElseThrow().cause())
                    .isEqualTo(isLikely ? Cause.DETECTED : Cause.TOO_WEAK);
        }
    }

    @Test
    void anyNumberOfThreadsGivesTheSame() {
        Coverage one = coverage(settings, 1);
        for (String sensor : settings.sensors().keySet()) {
            for (int cell = 0; cell < GRID.cells() * GRID.cells(); cell++) {
                int column = cell % GRID.cells();
                int row = cell / GRID.cells();
                assertThat(coverage.isReached(sensor, column, row)).isEqualTo(one.isReached(sensor, column, row));
            }
        }
        Map<String, Map<Cause, Integer>> causes;
        try (Workers workers = new Workers(2)) {
            causes = workers.call(coverage::causes);
        }
        assertThat(causes).isEqualTo(one.causes());
        assertThat(causes).allSatisfy((sensor, its) -> assertThat(its).isEqualTo(one.causes(sensor)));
    }

    @Test
    void thePictureShowsWhatIsReached() {
        CoveragePicture picture = CoveragePicture.of("plain", coverage, stage.world(), "drone 'one'", List.of());

        Color far = picture.colour(60, 60);
        Color radarOnly = picture.colour(500 + 250, 500 + 40);
        Color shadow = picture.colour(500, 500 - 250);
        assertThat(far.getGreen() - far.getRed()).as("bare ground is no green").isLessThan(10);
        assertThat(radarOnly.getGreen() - radarOnly.getRed())
                .as("a radar's cell is green")
                .isGreaterThan(30);
        assertThat(shadow).as("behind the wall").isEqualTo(far);
        assertThat(picture.colour(500, 500 + 100).getRed())
                .as("a cell that the microphone reaches, too, is redder")
                .isGreaterThan(radarOnly.getRed());
        assertThat(picture.colour(1200, 900)).isEqualTo(Color.WHITE);
    }

    /** The microphone is named in the line of its kind; only the two radars have lines of their own. */
    @Test
    void noFigureOfTheLegendIsGivenTwice() {
        CoveragePicture picture = CoveragePicture.of("plain", coverage, stage.world(), "drone 'one'", List.of());
        int x = 1000 + 24 + 11;
        int kinds = 40 + 6 * 26;
        for (int line = 1; line <= 6; line++) {
            boolean isEmpty = line == 3 || line == 6;
            assertThat(picture.colour(x, kinds + line * 26 - 5).equals(Color.WHITE))
                    .as("line %d", line)
                    .isEqualTo(isEmpty);
        }
    }

    /** At the bottom of the panel, in as many lines as it takes; without credits, nothing is there. */
    @Test
    void thePictureShowsTheCreditsOfItsData() {
        assertThat(inkAtTheBottom(List.of())).isZero();
        int one = inkAtTheBottom(List.of("© OpenStreetMap contributors"));
        assertThat(one).isGreaterThan(100);
        assertThat(inkAtTheBottom(List.of("© OpenStreetMap contributors", "heights of the survey ".repeat(9))))
                .isGreaterThan(3 * one);
    }

    /** Titles and names of any length stay in the panel, and credits may leave no room for sensors. */
    @Test
    void longTextsStayInThePicture() {
        List<String> credits = Collections.nCopies(60, "heights of the survey");
        String words = "a scene with a very long name ".repeat(4);
        CoveragePicture picture = CoveragePicture.of(words, coverage, stage.world(), "drone '" + words + "'", credits);
        for (int y = 0; y < 1000; y++) {
            assertThat(picture.colour(1379, y)).as("row %d", y).isEqualTo(Color.WHITE);
        }
    }

    private static int inkAtTheBottom(List<String> credits) {
        CoveragePicture picture = CoveragePicture.of("plain", coverage, stage.world(), "drone 'one'", credits);
        int ink = 0;
        for (int x = 1000; x < 1380; x++) {
            for (int y = 900; y < 1000; y++) {
                ink += picture.colour(x, y).getRed() < 0x80 ? 1 : 0;
            }
        }
        return ink;
    }

    /**
     * Sound is estimated with random rays: the second cell's are those of a run's second look, so field and run agree
     * to the last bit. The drone hovers where the cell puts it; at the first look its sound has not arrived yet.
     */
    @Test
    void theEstimateOfACellIsThatOfALookOfARunThere() throws IOException {
        Path file = directory.resolve("ear.yaml");
        Files.writeString(
                file,
                """
                world: {models: [plain.obj], backgroundNoise: 20}
                drones:
                  one:
                    model: packaged:quadrotor.obj
                    flight: {kind: hover, position: [30, 65, 2]}
                    soundLevel: 60
                sensors:
                  ear: {kind: acoustic, position: [3, -5, 2], rate: 1 Hz, propagation: {kind: energy-model}}
                run: {duration: 1 s, seed: 5}
                """);
        CoverageGrid grid = new CoverageGrid(0, 35, 120, 2, 2);
        assertThat(new double[] {grid.x(1), grid.y(0)}).containsExactly(30, 65);
        SceneRunner runner = new SceneRunner(new SceneFile(file));
        SceneSettings settings = runner.settings();
        Coverage field = Coverage.of(settings, runner.stage(settings), "one", grid, points -> {});
        Assessment assessed = field.assess("ear", 1, 0).orElseThrow();
        List<Observation> looks;
        try (RunSession session = new RunSession(settings, 5, new ModelCache(directory, note -> {}))) {
            assertThat(session.advance().observations()).isEmpty();
            looks = session.advance().observations();
        }
        Observation look = looks.get(0);

        assertThat(look.look().index()).isEqualTo(1);
        assertThat(assessed.standardError()).as("it is an estimate").isPositive();
        assertThat(look.value()).isEqualTo(assessed.quantity());
        assertThat(look.threshold()).isEqualTo(assessed.threshold());
        assertThat(look.isDetected()).isEqualTo(assessed.cause() == Cause.DETECTED);
        SceneSettings otherSeed = new SceneRunner(new SceneFile(file)).seed(6).settings();
        assertThat(Coverage.of(otherSeed, runner.stage(otherSeed), "one", grid, points -> {})
                        .assess("ear", 1, 0)
                        .orElseThrow()
                        .quantity())
                .as("other rays, another estimate")
                .isNotEqualTo(assessed.quantity());
    }
}
