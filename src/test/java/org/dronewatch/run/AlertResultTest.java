package org.dronewatch.run;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.fusion.AlertSettings;
import org.dronewatch.fusion.ProtectedZone;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A drone that flies straight from 1 km at a zone of 200 m about a radar that looks 500 m far. */
class AlertResultTest {
    private static final Position RADAR = new Position(0, 0, 30);

    @TempDir
    private Path directory;

    @BeforeEach
    void aFloorWithAWallAcross() throws IOException {
        Files.writeString(
                directory.resolve("wall.obj"),
                "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\nf 4 3 2 1\n"
                        + "v -9 29 -20\nv 9 29 -20\nv 9 30.5 -20\nv -9 30.5 -20\nf 5 6 7 8\n");
    }

    private final class Straight extends Scene {
        private static final long serialVersionUID = 1L;

        private final transient AlertSettings alert;
        private final transient Position to;

        Straight(AlertSettings alert, Position to) {
            this.alert = alert;
            this.to = to;
        }

        @Override
        public Path directory() {
            return directory;
        }

        @Override
        protected void build() {
            loadWorld(load("wall.obj"));
            Position from = new Position(0, 1000, to.z());
            add(
                    "drone",
                    DroneSettings.of(loadPackaged("quadrotor.obj"), new FlightPathSettings.Approach(from, to))
                            .withSpeed(20));
            add(
                    "radar",
                    RadarSettings.at(RADAR, LinkBudget.DataSheet.of(5000, 0.01))
                            .withFieldOfView(2 * Math.PI, Math.PI)
                            .withRanges(1, 500));
            setAlert(alert);
            setRun(RunSettings.DEFAULT.withDuration(60));
        }
    }

    private AlertResult run(double response, Position to) {
        ProtectedZone zone = new ProtectedZone(RADAR, 200);
        AlertSettings alert = AlertSettings.DEFAULT.withProtectedZone(zone, response);
        return new SceneRunner(new Straight(alert, to)).threads(1).run().alert("drone");
    }

    @Test
    void warningIsWhatTheWayToTheZoneTakes() {
        AlertResult over = run(10, new Position(0, 0, 60));
        // Over the wall's top the radar has a free line from (0, 20, 45) on: it sees 500 m far at once, level 30 m
        // above.
        double level = Math.sqrt(500.0 * 500.0 - 30.0 * 30.0);
        double inRange = Math.ceil((1000.0 - level) / 20.0);
        assertThat(over.firstSight()).hasValue(inRange);
        assertThat(over.time()).hasValue(inRange);
        assertThat(over.timeToAlert()).hasValue(0.0);
        assertThat(over.sensors()).containsExactly("radar");
        double distance = Math.hypot(1000.0 - 20.0 * inRange, 30.0) - 200.0;
        assertThat(over.zoneDistance().orElseThrow()).isCloseTo(distance, within(1e-9));
        assertThat(over.warning().orElseThrow()).isCloseTo(distance / 20.0, within(1e-9));
        double reached = (1000.0 - Math.sqrt(200.0 * 200.0 - 30.0 * 30.0)) / 20.0;
        assertThat(over.entered().orElseThrow()).isCloseTo(reached, within(1e-6));
        assertThat(over.inTime()).contains(true);
        assertThat(run(16, new Position(0, 0, 60)).inTime()).contains(false);
        assertThat(run(0, new Position(0, 0, 60)).inTime()).isEmpty();
    }

    /**
     * The radar sees it only once it has flown over the zone: from 20 m beyond the wall on, when it is 300 m behind.
     */
    @Test
    void anAlertAfterTheDroneHasBeenThereIsTooLate() {
        ProtectedZone zone = new ProtectedZone(new Position(0, 700, 100), 3);
        Scene scene = new Straight(AlertSettings.DEFAULT.withProtectedZone(zone, 0.001), new Position(0, 0, 100));
        AlertResult late = new SceneRunner(scene).threads(1).run().alert("drone");

        assertThat(late.entered().orElseThrow()).isCloseTo((1000.0 - 703.0) / 20.0, within(1e-9));
        assertThat(late.time().orElseThrow()).isGreaterThan(late.entered().orElseThrow());
        assertThat(late.warning()).hasValue(0.0);
        assertThat(late.inTime()).contains(false);
    }

    @Test
    void behindAWallThereIsNoSightAndNoAlert() {
        AlertResult hidden = run(10, new Position(0, 30, 30.2));

        assertThat(hidden.firstSight()).isEmpty();
        assertThat(hidden.time()).isEmpty();
        assertThat(hidden.warning()).isEmpty();
        assertThat(hidden.inTime()).contains(false);
        assertThat(hidden.entered()).isPresent();
    }
}
