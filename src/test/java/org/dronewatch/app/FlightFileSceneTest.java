package org.dronewatch.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;

/** Flights from files of other programs, as a user flies them. */
class FlightFileSceneTest extends CommandLines {
    private static final Path EXAMPLES = Path.of("src/examples/terrain");
    private static final String FLIGHT = "flight: {plan: approach.plan}";

    @BeforeEach
    void copyExamples() throws IOException {
        for (String name : new String[] {"approach.yaml", "approach.plan", "approach.gpx"}) {
            Files.copy(EXAMPLES.resolve(name), directory.resolve(name));
        }
    }

    private void write(String flight) throws IOException {
        String text = Files.readString(EXAMPLES.resolve("approach.yaml"));
        assertThat(text).contains(FLIGHT);
        Files.writeString(directory.resolve("scene.yaml"), text.replace(FLIGHT, flight));
    }

    @Test
    void aMissionIsRunAndItsFileIsPartOfTheRun() throws IOException {
        Program.Outcome outcome = commandIn("run DIR/approach.yaml --out DIR/out --set run.duration=1");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .contains("read approach.plan: a mission of 7 items")
                .contains(
                        "warning: drone 'visitor': flight: approach.plan: mission.items.4: DO_SET_ROI (201) does not move");
        assertThat(Files.readString(directory.resolve("out/provenance.json"))).contains("approach.plan");
        Path saved = directory.resolve("saved.yaml");
        assertThat(commandIn("save DIR/approach.yaml --out DIR/saved.yaml").code())
                .isZero();
        assertThat(Files.readString(saved)).contains("approach.plan");
        assertThat(commandIn("check DIR/saved.yaml").code()).isZero();
    }

    /** Its plan climbs and descends by more than 100 m: at a metre a second, if that is what the drone can do. */
    @Test
    void aMissionKeepsToThePerformanceOfItsDrone() throws IOException {
        String slow = "performance: {climb: 1 m/s, sink: 0.5 m/s}, ";
        write(slow + FLIGHT);
        assertThat(commandIn("check DIR/scene.yaml --set run.duration=400").err())
                .doesNotContain("climbs at")
                .doesNotContain("descends at");
        write(slow + FLIGHT.replace("approach.plan", "approach.plan, climbRate: 3, descentRate: 1.5"));
        assertThat(commandIn("check DIR/scene.yaml --set run.duration=400").err())
                .contains("climbs at 3 m/s")
                .contains("descends at 1.5 m/s");
    }

    @Test
    void aTrackIsFlown() throws IOException {
        write("flight: {log: approach.gpx}");
        Program.Outcome outcome = commandIn("check DIR/scene.yaml --set run.duration=235");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .contains("read approach.gpx: 24 points in 230.0 s")
                .contains(
                        "its recorded flight ends at 230.0 s, the run at 235.0 s: for the rest of the run the drone hovers");
    }

    /**
     * The track was logged during the mission, each ten seconds, rounded to a decimetre: then both are at the same
     * places.
     */
    @Test
    void theTrackIsThatOfTheMission() throws IOException {
        FlightPath mission = flight("approach.yaml");
        write("flight: {log: approach.gpx}");
        FlightPath track = flight("scene.yaml");
        for (int time = 0; time <= 230; time += 10) {
            assertThat(track.at(time).position().distance(mission.at(time).position()))
                    .as("%s s", time)
                    .isLessThan(0.5);
        }
    }

    private FlightPath flight(String scene) {
        SceneRunner runner = new SceneRunner(new SceneFile(directory.resolve(scene)));
        return runner.stage(runner.settings()).flight("visitor");
    }

    @Test
    void swarmsFlyBesideALeader() throws IOException {
        write("swarm: {count: 3}, " + FLIGHT);
        Program.Outcome outcome = commandIn("check DIR/scene.yaml");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.out()).contains("3 drones");
    }

    @Test
    void whatIsWrongIsRefusedWithItsPlace() throws IOException {
        write("flight: {plan: other.plan}");
        assertRefused(
                "check DIR/scene.yaml",
                "scene.yaml:7:",
                "drones.visitor.flight.plan: file 'other.plan' does not exist");
        Files.writeString(directory.resolve("other.plan"), "{\"fileType\": \"Parameters\"}");
        Program.Outcome outcome = commandIn("run DIR/scene.yaml --out DIR/out");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().lines().reduce((a, b) -> b).orElseThrow())
                .contains(
                        "scene.yaml:7:",
                        "drones.visitor.flight.plan: other.plan: fileType is 'Parameters' but must be 'Plan'");
        assertThat(directory.resolve("out")).doesNotExist();
        write("flight: {log: approach.gpx, heights: moon}");
        assertRefused("check DIR/scene.yaml", "drones.visitor.flight.heights", "sea, start, surface");
        write("flight: {log: approach.gpx, verticalOffset: 20 km}");
        assertRefused("check DIR/scene.yaml", "drones.visitor.flight.verticalOffset");
    }

    @Test
    void aPlaceOffTheSiteIsRefused() throws IOException {
        write("flight: {log: approach.gpx, heights: surface, verticalOffset: -300 m}");
        Files.writeString(
                directory.resolve("approach.gpx"),
                Files.readString(EXAMPLES.resolve("approach.gpx")).replaceFirst("lat=\"43.7[0-9]*\"", "lat=\"43.80\""));
        Program.Outcome outcome = commandIn("check DIR/scene.yaml");
        assertThat(outcome.code()).isEqualTo(2);
        assertThat(outcome.err().lines().reduce((a, b) -> b).orElseThrow())
                .contains(
                        "drone 'visitor': flight: approach.gpx:4: no surface at latitude 43.800000 deg, longitude 7.4");
    }

    /** A saved flight is a mission that can be flown: as a plan, and under another name. */
    @Test
    void aFlightIsSavedAsAMission() throws IOException {
        Program.Outcome outcome = commandIn("save DIR/approach.yaml --flight visitor --out DIR/saved.plan");
        assertThat(outcome.code()).as(outcome.err()).isZero();
        assertThat(outcome.err())
                .containsPattern(
                        "mission of \\d+ items in .*saved.plan: the flight deviates from the straight legs of the"
                                + " mission by at most 0.5 m");
        write("flight: {plan: saved.plan}");
        assertThat(commandIn("check DIR/scene.yaml").code()).isZero();
        assertThat(commandIn("save DIR/approach.yaml --flight visitor --out DIR/saved.plan")
                        .code())
                .isZero();
        assertRefusedAtLast("save DIR/approach.yaml --flight visitor --out DIR/approach.plan", "already exists");
        assertRefusedAtLast("save DIR/approach.yaml --flight visitor --out DIR/other.yaml", "must end in .plan");
        assertRefusedAtLast("save DIR/approach.yaml --flight visitro --out DIR/other.plan", "closest match: visitor");
        assertRefusedAtLast("save camera-range --flight quadrotor --out DIR/other.plan", "needs a world.origin");
        write("flight: {kind: steered, start: [0, 0, 200]}");
        assertRefusedAtLast("save DIR/scene.yaml --flight visitor --out DIR/other.plan", "is steered during the run");
        assertThat(directory.resolve("other.plan")).doesNotExist();
    }

    private void assertRefusedAtLast(String command, String message) {
        Program.Outcome outcome = commandIn(command);
        assertThat(outcome.code()).as(outcome.err()).isEqualTo(2);
        assertThat(outcome.err().lines().reduce((a, b) -> b).orElseThrow()).contains(message);
    }
}
