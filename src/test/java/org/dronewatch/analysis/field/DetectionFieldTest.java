package org.dronewatch.analysis.field;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeSet;
import org.dronewatch.analysis.cell.Course;
import org.dronewatch.analysis.cell.FieldGrid;
import org.dronewatch.analysis.cell.ProbabilityStep;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.run.RunSession;
import org.dronewatch.run.model.ModelCache;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.sensor.Assessment;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Mounted;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The detection field against looks, against geometry computed here, and against fields of smaller scenes. */
class DetectionFieldTest {
    /** Cells of 20 m, whose middles are on no face of a box. */
    private static final FieldGrid GRID = new FieldGrid(0.7, 0.3, 380, 20, List.of(2.0, 60.0));

    /** A part of it. */
    private static final FieldGrid SMALL = new FieldGrid(0.7, 0.3, 140, 20, GRID.heights());

    @TempDir
    private static Path directory;

    private static FieldSite site;
    private static DetectionField field;

    @BeforeAll
    static void assess() throws IOException {
        site = FieldSite.in(directory, FieldSite.ALL);
        field = site.field(GRID, 2);
    }

    /** A cell and a course in which a drone can be, at random. */
    private record Case(int height, int column, int row, int course) {
        static Case random(Random random, DetectionField of) {
            while (true) {
                Case one = new Case(
                        random.nextInt(GRID.heights().size()),
                        random.nextInt(GRID.columns()),
                        random.nextInt(GRID.columns()),
                        random.nextInt(of.courses().size()));
                if (of.isOpen(one.height, one.column, one.row)) {
                    return one;
                }
            }
        }

        Position middle() {
            return field.middle(height, column, row);
        }

        Drone drone() {
            Drone one = DetectionField.droneOf(site.stage(), FieldSite.DRONE);
            return one.at(
                    field.courses().get(course).at(middle(), one.settings().speed()));
        }
    }

    private static Random seeded() {
        long seed = System.nanoTime();
        System.out.println("DetectionFieldTest: seed " + seed);
        return new Random(seed);
    }

    @Test
    void theCoursesAreThoseOfTheCompassAcrossTheRadarsAndHovering() {
        assertThat(field.courses()).hasSize(8 + 2 * 2 + 1);
        assertThat(field.courses().stream().map(Course::kind).distinct())
                .containsExactly(Course.Kind.COMPASS, Course.Kind.CROSSING, Course.Kind.HOVER);
        Position at = new Position(30, 40, 9);
        Course across = field.courses().get(8);
        assertThat(across.sensor()).contains("round");
        assertThat(across.at(at, 12).velocity().dot(at)).isCloseTo(0.0, within(1e-12));
        assertThat(across.at(at, 12).velocity().length()).isCloseTo(12.0, within(1e-12));
        Course in = Course.inbound(new Position(0, 0, 50));
        assertThat(in.heading(at)).isCloseTo(Math.PI + Math.atan2(30, 40) - 2 * Math.PI, within(1e-12));
        assertThat(in.at(at, 12).velocity().z()).as("level").isZero();
    }

    /** Each sensor takes a look as in a run; where chance decides, it has its probability. */
    @Test
    void aLookHasTheProbabilityOfItsCell() {
        Random random = seeded();
        int certain = 0;
        for (int i = 0; i < 60; i++) {
            Case one = Case.random(random, field);
            for (int sensor = 0; sensor < field.sensors().size(); sensor++) {
                String id = field.sensors().get(sensor);
                if (id.equals("ear")
                        && field.cause(sensor, one.height, one.column, one.row, one.course) != Cause.DETECTED) {
                    continue; // A look of the level model behind an obstacle draws its rays.
                }
                SensorSettings<?> settings = site.settings().enabledSensors().get(id);
                Drone drone = one.drone();
                Look look = Look.of(7, id, 0, 0.0).withPointing(Mounted.turnedTo(settings, drone.origin()));
                Observation seen = settings.create()
                        .observe(site.stage().world(), List.of(drone), look)
                        .get(0);
                double stored = field.probability(sensor, one.height, one.column, one.row, one.course);
                assertThat(stored)
                        .as("%s %s", id, one)
                        .isEqualTo(ProbabilityStep.stated(ProbabilityStep.of(seen.probability())));
                if (stored == 0.0 || stored == 1.0) {
                    certain++;
                    assertThat(seen.isDetected()).as("%s %s", id, one).isEqualTo(stored == 1.0);
                }
            }
        }
        assertThat(certain).isGreaterThan(100);
    }

    /** A run of the scene in which the drone hovers in the cell, and cameras on positioners point at it. */
    @Test
    void aRunGivesTheAnswerOfTheFieldWhereItIsCertain() {
        Random random = seeded();
        int hovering = field.courses().size() - 1;
        for (int i = 0; i < 3; i++) {
            Case one = Case.random(random, field);
            SceneSettings there = at(one.middle());
            List<Observation> looks;
            try (RunSession session = new RunSession(there, 7, new ModelCache(directory, note -> {}))) {
                looks = session.advance().observations();
            }
            for (Observation seen : looks) {
                int sensor = field.sensors().indexOf(seen.look().sensor());
                double p = field.probability(sensor, one.height, one.column, one.row, hovering);
                if ((p == 0.0 || p == 1.0) && !seen.look().sensor().equals("ear")) {
                    assertThat(seen.isDetected()).as("%s %s", seen, one).isEqualTo(p == 1.0);
                }
            }
            assertThat(looks).hasSizeGreaterThan(4);
        }
    }

    private static SceneSettings at(Position middle) {
        SceneSettings there = site.settings();
        for (Map.Entry<String, SensorSettings<?>> sensor :
                site.settings().enabledSensors().entrySet()) {
            there = there.withSensor(
                    sensor.getKey(), Mounted.pointed(sensor.getValue(), Mounted.turnedTo(sensor.getValue(), middle)));
        }
        DroneSettings drone = there.drones().get(FieldSite.DRONE);
        return there.withDrone(FieldSite.DRONE, drone.withFlight(new FlightPathSettings.Hover(middle, 0.0)));
    }

    /** The cause of the radar without chance, from the boxes alone. */
    @Test
    void theCauseIsThatOfTheGeometry() {
        Random random = seeded();
        Position radar = new Position(0, 0, 4);
        Set<Cause> met = EnumSet.noneOf(Cause.class);
        for (int i = 0; i < 10_000; i++) {
            Case one = Case.random(random, field);
            Position middle = one.middle();
            Optional<Cause> expected = expected(radar, middle, one.drone());
            if (expected.isPresent()) {
                Cause cause = field.cause(0, one.height, one.column, one.row, one.course);
                assertThat(cause).as("%s at %s", one, middle).isEqualTo(expected.get());
                assertThat(field.step(0, one.height, one.column, one.row, one.course))
                        .isEqualTo(cause == Cause.DETECTED ? ProbabilityStep.CERTAIN : 0);
                met.add(cause);
            }
        }
        assertThat(met)
                .containsExactlyInAnyOrder(
                        Cause.OUT_OF_RANGE,
                        Cause.OUT_OF_VIEW,
                        Cause.TOO_SLOW,
                        Cause.HIDDEN_BY_BUILDING,
                        Cause.HIDDEN_BY_TERRAIN,
                        Cause.HIDDEN_BY_VEGETATION,
                        Cause.HIDDEN_BY_OTHER,
                        Cause.DETECTED);
    }

    /** Empty within half a metre of a border, where the size of the drone matters. */
    private static Optional<Cause> expected(Position radar, Position middle, Drone drone) {
        Position line = middle.minus(radar);
        double range = line.length();
        double elevation = Math.toDegrees(Math.asin(line.z() / range));
        double radial = Math.abs(line.dot(Position.of(drone.velocity()))) / range;
        if (Math.abs(range - 150) < 0.01 || Math.abs(Math.abs(elevation) - 45) < 0.01 || Math.abs(radial - 3) < 1e-6) {
            return Optional.empty();
        }
        if (range > 150) {
            return Optional.of(Cause.OUT_OF_RANGE);
        }
        if (Math.abs(elevation) > 45) {
            return Optional.of(Cause.OUT_OF_VIEW);
        }
        if (radial < 3) {
            return Optional.of(Cause.TOO_SLOW);
        }
        Set<Optional<Cause>> around = new HashSet<>();
        for (int corner = 0; corner < 8; corner++) {
            Position offset = new Position(
                    (corner & 1) == 0 ? -0.5 : 0.5, (corner & 2) == 0 ? -0.5 : 0.5, (corner & 4) == 0 ? -0.5 : 0.5);
            around.add(FieldSite.hidden(radar, middle.plus(offset)));
        }
        return around.size() > 1
                ? Optional.empty()
                : Optional.of(around.iterator().next().orElse(Cause.DETECTED));
    }

    /** Cells in the boxes are no cells in which a drone can be, but those over the hill are. */
    @Test
    void whatIsInsideSomethingSolidIsSetApart() {
        for (int height = 0; height < GRID.heights().size(); height++) {
            for (int cell = 0; cell < GRID.cells(); cell++) {
                int column = cell % GRID.columns();
                int row = cell / GRID.columns();
                double x = GRID.x(column);
                double y = GRID.y(row);
                double above = GRID.heights().get(height);
                boolean inside = FieldSite.BOXES.entrySet().stream()
                        .filter(box -> !box.getKey().equals("terrain"))
                        .anyMatch(box -> box.getValue().contains(x, y)
                                && above < box.getValue().height());
                boolean onHill = FieldSite.BOXES.get("terrain").contains(x, y);
                assertThat(field.isInside(height, column, row)).isEqualTo(inside);
                assertThat(field.middle(height, column, row).z()).isCloseTo(above + (onHill ? 15 : 0), within(1e-5));
            }
        }
    }

    /** Where a sensor says that the heading does not matter, all courses have the same assessment. */
    @Test
    void whatIsSaidToBeTheSameAtAllHeadingsIs() {
        Random random = seeded();
        Set<String> same = new TreeSet<>();
        for (Map.Entry<String, SensorSettings<?>> sensor :
                site.settings().enabledSensors().entrySet()) {
            Assessor assessor = new Assessor(
                    sensor.getKey(), sensor.getValue(), site.stage().world());
            for (int i = 0; i < 60; i++) {
                Case one = Case.random(random, field);
                Optional<Pointing> pointing = Mounted.turnedTo(sensor.getValue(), one.middle());
                if (assessor.isSameAtAllHeadings(one.drone(), pointing)) {
                    same.add(sensor.getKey());
                    Assessment first = assessor.assess(one.drone(), pointing, new SplittableRandom(1));
                    for (int course = 0; course < field.courses().size(); course++) {
                        Drone other = new Case(one.height, one.column, one.row, course).drone();
                        assertThat(assessor.assess(other, pointing, new SplittableRandom(1)))
                                .as("%s %s", sensor.getKey(), one)
                                .isEqualTo(first);
                    }
                }
            }
        }
        assertThat(same).contains("round", "notched", "radio", "eye", "heat", "ear");
    }

    @Test
    void anyNumberOfThreadsGivesTheSame() {
        assertSame(site.field(SMALL, 8), site.field(SMALL, 1));
    }

    /** The field of a scene without a sensor is computed anew, with the courses of that scene. */
    @Test
    void theFieldWithoutASensorIsThatOfASceneWithoutIt() throws IOException {
        String rest = FieldSite.ALL.substring(FieldSite.ROUND.length()).replace("cues: [round]", "cues: [notched]");
        Path other = Files.createDirectory(directory.resolve("rest"));
        FieldSite smaller = FieldSite.in(other, rest);
        DetectionField fresh = smaller.field(SMALL, 2);
        DetectionField left = site.field(SMALL, 2).without("round");

        assertThat(left.sensors()).isEqualTo(fresh.sensors()).doesNotContain("round");
        assertThat(left.courses()).isEqualTo(fresh.courses());
        assertSame(left, fresh);
        assertThatIllegalArgumentException()
                .isThrownBy(() -> left.without("round"))
                .withMessageContaining("'round'");
    }

    private static void assertSame(DetectionField one, DetectionField other) {
        for (int sensor = 0; sensor < other.sensors().size(); sensor++) {
            for (int height = 0; height < SMALL.heights().size(); height++) {
                for (int cell = 0; cell < SMALL.cells(); cell++) {
                    for (int course = 0; course < other.courses().size(); course++) {
                        int column = cell % SMALL.columns();
                        int row = cell / SMALL.columns();
                        if (one.step(sensor, height, column, row, course)
                                        != other.step(sensor, height, column, row, course)
                                || one.cause(sensor, height, column, row, course)
                                        != other.cause(sensor, height, column, row, course)
                                || !one.margin(sensor, height, column, row, course)
                                        .equals(other.margin(sensor, height, column, row, course))) {
                            throw new AssertionError(other.sensors().get(sensor) + " differs at height " + height
                                    + ", column " + column + ", row " + row + ", course " + course);
                        }
                    }
                }
            }
        }
    }

    /** The evidence behind a cell names what hides the drone. */
    @Test
    void theEvidenceNamesTheModel() {
        Case behind = new Case(0, cell(0.7), row(100), 0);
        Assessment one = field.assess(0, behind.height, behind.column, behind.row, behind.course)
                .orElseThrow();
        assertThat(one.cause()).isEqualTo(Cause.HIDDEN_BY_BUILDING);
        assertThat(one.obstacle().orElseThrow().model().file()).endsWith("building.obj");
        assertThat(field.assess(0, 0, cell(0.7), row(65), 0)).as("inside").isEmpty();
    }

    private static int cell(double x) {
        return (int) Math.floor((x - GRID.x(0)) / GRID.cell() + 0.5);
    }

    private static int row(double y) {
        return (int) Math.floor((GRID.y(0) - y) / GRID.cell() + 0.5);
    }
}
