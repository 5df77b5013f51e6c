package org.dronewatch.examples;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Random;
import org.dronewatch.drone.Drone;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.FlightPathSettings.Orbit;
import org.dronewatch.geometry.Position;
import org.dronewatch.report.RunReport;
import org.dronewatch.run.Frame;
import org.dronewatch.run.Stage;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Assessor;
import org.dronewatch.sensor.Cause;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SentryTest {
    private static final Position EYES = new Position(0, 0, 160);

    @TempDir
    private Path directory;

    private int seen;
    private int unseen;

    /** A sentry on a mast, who looks north; one drone circles the mast, another hovers behind it. */
    static class SentryOnAMast extends GateWatch {
        @Override
        protected void build() {
            super.build();
            disable("roof");
            add("sentry", SentrySettings.at(EYES));
            add(
                    "circling",
                    DroneSettings.of(loadPackaged("quadrotor.obj"), Orbit.about(new Position(0, 0, 170), 60))
                            .withSpeed(15.0));
            add("behind", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(20, -60, 170))));
        }
    }

    private void look(Frame frame) {
        Drone circling = frame.drones().get(1);
        boolean isSeen =
                frame.observations().stream().anyMatch(one -> one.drone().equals("circling") && one.isDetected());
        assertThat(isSeen)
                .as("at %s", circling.origin())
                .isEqualTo(circling.origin().y() >= 0.0);
        assertThat(frame.observations()).noneMatch(one -> one.drone().equals("behind"));
        seen += isSeen ? 1 : 0;
        unseen += isSeen ? 0 : 1;
    }

    /** The drone circles for one and a half times, and the sentry looks 21 times. */
    @Test
    void theSentrySeesTheDroneInFrontAlone() {
        new SceneRunner(new SentryOnAMast()).onFrame(this::look).run();
        assertThat(seen).isGreaterThan(5);
        assertThat(unseen).isGreaterThan(5);
        assertThat(seen + unseen).isEqualTo(21);
    }

    /** The drone hovers 50 m behind the sentry, over a plain. */
    @Test
    void theReportGivesTheCause() throws IOException {
        Files.writeString(directory.resolve("plain.obj"), "v -90 0 -90\nv 90 0 -90\nv 90 0 90\nf 1 3 2\n");
        Scene scene = new Scene() {
            @Override
            public Path directory() {
                return directory;
            }

            @Override
            protected void build() {
                loadWorld(load("plain.obj"));
                add("sentry", SentrySettings.at(new Position(0, 0, 2)));
                add("behind", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(0, -50, 20))));
                setRun(RunSettings.DEFAULT.withDuration(4.0));
            }
        };
        try (RunReport report = new RunReport(scene, directory.resolve("sentry"), false)) {
            report.finish(new SceneRunner(scene).listener(report).run());
        }
        assertThat(Files.readString(directory.resolve("sentry/report.html")))
                .contains("always out of its field of view");
    }

    @Test
    void aDroneIsAssessedByTheFieldOfView() {
        SceneRunner runner = new SceneRunner(new SentryOnAMast());
        Stage stage = runner.stage(runner.settings());
        SentrySettings north = SentrySettings.at(EYES);
        SentrySettings south = north.withAim(new Aim.Direction(Math.PI, 0.0));
        assertThat(cause(north, stage)).isEqualTo(Cause.OUT_OF_VIEW);
        assertThat(cause(south, stage)).isEqualTo(Cause.DETECTED);
        assertThat(cause(south.withPosition(new Position(0, 0, 250)), stage))
                .as("at 52 degrees below the horizon")
                .isEqualTo(Cause.OUT_OF_VIEW);
    }

    /** Why the drone behind the mast is detected or missed. */
    private static Cause cause(SensorSettings<?> sentry, Stage stage) {
        return new Assessor("sentry", sentry, stage.world())
                .assess(stage.dronesAt(0.0).get(2), Optional.empty(), new Random(1))
                .cause();
    }
}
