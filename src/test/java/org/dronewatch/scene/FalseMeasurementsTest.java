package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.Direction;
import org.dronewatch.positioner.Pointing;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.positioner.Sighting;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.DetectionEvent;
import org.dronewatch.run.Frame;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.DirectionFinding;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A sensor that reports none, several and false measurements: nothing downstream counts on one for each drone. */
class FalseMeasurementsTest {
    private static final Position PLACE = new Position(0, 0, 30);
    private static final Direction NOWHERE = new Direction(Math.PI / 2, 0.3);

    @TempDir
    private Path directory;

    /**
     * At look 0 nothing at all, then one false alarm a look, from look 3 on the drone twice, once below the threshold.
     */
    private record Nervous(Position position) implements SensorSettings<Sensor>, DirectionFinding {
        @Override
        public Nervous withPosition(Position other) {
            return new Nervous(other);
        }

        @Override
        public String kind() {
            return "nervous";
        }

        @Override
        public double rate() {
            return 1.0;
        }

        @Override
        public Sensor create() {
            return this::look;
        }

        private List<Observation> look(World world, List<Drone> drones, Look look) {
            List<Observation> all = new ArrayList<>();
            if (look.index() >= 3) {
                drones.forEach(drone -> all.add(of(drone, look, 1.0)));
                drones.forEach(drone -> all.add(of(drone, look, 9.0)));
            }
            if (look.index() >= 1) {
                all.add(Observation.ofNothing(
                        look.id(kind()),
                        new Reading(7.0, 5.0, "dB"),
                        Optional.of(new Sighting(position, NOWHERE, OptionalDouble.empty()))));
            }
            return all;
        }

        private Observation of(Drone drone, Look look, double value) {
            return new Observation(
                    look.id(kind()), drone.id(), drone.distance(position), new Reading(value, 5.0, "dB"));
        }
    }

    private static final class Site extends FloorScene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            loadFloor();
            add(
                    "drone",
                    DroneSettings.of(
                            loadPackaged("quadrotor.obj"), FlightPathSettings.Hover.at(new Position(0, 300, 60))));
            add("nervous", new Nervous(PLACE));
            add(
                    "camera",
                    CameraSettings.at(PLACE)
                            .withLookAt(new Position(0, 300, 60))
                            .withRate(2.0)
                            .withPositioner(PositionerSettings.DEFAULT.withCues("nervous")));
            setAlert(AlertSettings.DEFAULT);
            setRun(RunSettings.DEFAULT.withDuration(6.0));
        }
    }

    @Test
    void theDroneIsDetectedOnceAndFalseMeasurementsAreNobodysDetection() {
        List<DetectionEvent> events = new ArrayList<>();
        List<Pointing> pointings = new ArrayList<>();
        Site scene = new Site();
        Path target = directory.resolve("results");
        SceneResult result;
        List<Frame> frames = new ArrayList<>();
        try (RunReport report = new RunReport(scene, target, true)) {
            SceneRunner runner = new SceneRunner(scene).listener(report).onFrame(frame -> {
                frames.add(frame);
                pointings.addAll(frame.pointings().values());
            });
            result = runner.run();
            report.finish(result);
        }
        events.addAll(result.runs().get(0).events());
        assertThat(events).hasSize(1);
        assertThat(events.get(0).observation().value()).isEqualTo(9.0);
        assertThat(events.get(0).observation().time()).isEqualTo(3.0);
        assertThat(result.alert("drone").time()).hasValue(3.0);
        assertThat(frames.stream()
                        .mapToLong(frame ->
                                frame.observations().size() - frame.ofDrones().size())
                        .sum())
                .isEqualTo(6);
        // The mount turned to the first false alarm, as a real one would.
        assertThat(pointings.get(pointings.size() - 1).direction().azimuth()).isEqualTo(NOWHERE.azimuth());
    }

    @Test
    void tablesAndReportTakeWhatIsNoDrone() throws Exception {
        theDroneIsDetectedOnceAndFalseMeasurementsAreNobodysDetection();
        List<String> rows = Files.readAllLines(directory.resolve("results/observations.csv"));
        assertThat(rows.stream().filter(row -> row.startsWith("0,1,1,nervous,nervous,,,7,5,dB,true")))
                .hasSize(1);
        // The letters may also be among those of a picture.
        String words = Files.readString(directory.resolve("results/report.html"))
                .replaceAll("data:image/[a-z]+;base64,[^\"]*", "");
        assertThat(words).hasSizeGreaterThan(1000).doesNotContain("NaN").doesNotContain("base64");
    }
}
