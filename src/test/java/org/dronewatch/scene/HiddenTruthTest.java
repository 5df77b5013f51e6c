package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Approach;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.geometry.Position;
import org.dronewatch.positioner.PositionerSettings;
import org.dronewatch.run.Frame;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.GroundTruth;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Everything but scoring is the same whatever the truth beside the measurements says, as long as it still says which of
 * them belong together: a radar cues two cameras on positioners, and alerts are raised.
 */
class HiddenTruthTest {
    private static final Position MAST = new Position(0, 0, 30);

    @TempDir
    private Path directory;

    @BeforeEach
    void aFloor() throws Exception {
        Files.writeString(directory.resolve("floor.obj"), "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\nf 4 3 2 1\n");
    }

    /** What becomes of the truth of a sensor's observations after each look. */
    @FunctionalInterface
    private interface Scrambling {
        GroundTruth of(GroundTruth truth);
    }

    /** A sensor that is like another, but for the truth beside its measurements. */
    private record Scrambled(SensorSettings<?> real, Scrambling scrambling) implements SensorSettings<Sensor> {
        @Override
        public Position position() {
            return real.position();
        }

        @Override
        public Scrambled withPosition(Position other) {
            return new Scrambled(real.withPosition(other), scrambling);
        }

        @Override
        public double rate() {
            return real.rate();
        }

        @Override
        public String kind() {
            return real.kind();
        }

        @Override
        public <C> Optional<C> as(Class<C> capability) {
            return real.as(capability);
        }

        @Override
        public Sensor create() {
            Sensor sensor = real.create();
            return (world, drones, look) -> sensor.observe(world, drones, look).stream()
                    .map(seen -> new Observation(
                            seen.look(), scrambling.of(seen.truth()), seen.reading(), seen.figures(), seen.sighting()))
                    .toList();
        }
    }

    private final class Site extends Scene {
        private static final long serialVersionUID = 1L;

        private final transient Scrambling scrambling;

        Site(Scrambling scrambling) {
            this.scrambling = scrambling;
        }

        @Override
        public Path directory() {
            return directory;
        }

        @Override
        protected void build() {
            loadWorld(load("floor.obj"));
            fly("near", new Position(-40, 90, 50), new Position(-10, 20, 40));
            fly("far", new Position(60, 160, 60), new Position(20, 40, 45));
            RadarSettings radar = RadarSettings.at(MAST, LinkBudget.DataSheet.of(150, 0.01))
                    .withFieldOfView(2.5, 1.5)
                    .withSpeeds(0, 100)
                    .withRate(2.0);
            PositionerSettings cued = PositionerSettings.DEFAULT.withCues("radar");
            CameraSettings camera =
                    CameraSettings.at(MAST).withResolution(640, 360).withRate(5.0);
            put("radar", radar);
            put("first", camera.withPositioner(cued));
            put("second", camera.withHorizontalFov(0.1).withPositioner(cued));
            setAlert(AlertSettings.DEFAULT);
            setRun(RunSettings.DEFAULT.withDuration(8.0).withSeed(11));
        }

        private void fly(String name, Position from, Position to) {
            add(
                    name,
                    DroneSettings.of(loadPackaged("quadrotor.obj"), new Approach(from, to))
                            .withSpeed(8.0));
        }

        private void put(String name, SensorSettings<?> sensor) {
            add(name, new Scrambled(sensor, scrambling));
        }
    }

    /** All that is measured and pointed, and the alerts by their drone. */
    private record Outputs(List<String> measured, List<String> pointed, Map<String, String> alerts) {}

    private Outputs outputs(Scrambling scrambling) {
        List<String> measured = new ArrayList<>();
        List<String> pointed = new ArrayList<>();
        SceneResult result = new SceneRunner(new Site(scrambling))
                .onFrame((Frame frame) -> {
                    frame.observations().forEach(seen -> measured.add(seen.measurements() + " " + seen.figures()));
                    pointed.add(frame.time() + " " + frame.pointings());
                })
                .run();
        return new Outputs(
                measured,
                pointed,
                Map.of(
                        "near", result.alert("near").alert().toString(),
                        "far", result.alert("far").alert().toString()));
    }

    @Test
    void aTruthThatSaysSomethingElseChangesNothingButTheScores() {
        Outputs told = outputs(truth -> truth);
        assertThat(told.pointed()).as("positioners turn").hasSizeGreaterThan(30).doesNotHaveDuplicates();
        assertThat(told.alerts().values()).doesNotHaveDuplicates().noneMatch(alert -> alert.contains("empty"));

        Outputs lost = outputs(truth -> new GroundTruth(truth.drone(), Double.NaN, Double.NaN));
        assertThat(lost).as("neither range nor time").isEqualTo(told);

        Outputs renamed = outputs(truth ->
                new GroundTruth(truth.drone().equals("near") ? "far" : "near", -1e9 * truth.range(), -truth.time()));
        assertThat(renamed.measured()).isEqualTo(told.measured());
        assertThat(renamed.pointed()).isEqualTo(told.pointed());
        assertThat(renamed.alerts().get("far")).isEqualTo(told.alerts().get("near"));
        assertThat(renamed.alerts().get("near")).isEqualTo(told.alerts().get("far"));
    }
}
