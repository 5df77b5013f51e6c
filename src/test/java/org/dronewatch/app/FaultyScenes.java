package org.dronewatch.app;

import java.util.function.Supplier;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.FlightPathSettings.Hover;
import org.dronewatch.flight.Steered;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.scene.Pilot;
import org.dronewatch.scene.PilotedRun;
import org.dronewatch.scene.Scene;
import org.dronewatch.sensor.ActingSettings;
import org.dronewatch.sensor.camera.CameraSettings;

/** Scenes of users that fail with errors of Java. */
public final class FaultyScenes {
    private FaultyScenes() {}

    /** A scene with a sensor that fails at its third look. */
    private abstract static class WithSensor extends Scene {
        private static final long serialVersionUID = 1L;
        private final transient Supplier<Error> failure;

        WithSensor(Supplier<Error> failure) {
            this.failure = failure;
        }

        @Override
        protected void build() {
            loadWorld(loadPackaged("house.obj"));
            add("drone", DroneSettings.of(loadPackaged("quadrotor.obj"), Hover.at(new Position(0, 30, 20))));
            add("bad", new ActingSettings(new Position(0, 0, 20), 1.0, look -> {
                if (look.index() == 2) {
                    throw failure.get();
                }
            }));
            setRun(RunSettings.DEFAULT.withDuration(5.0));
        }
    }

    /** An assertion of the user's does not hold. */
    public static final class Asserting extends WithSensor {
        private static final long serialVersionUID = 1L;

        public Asserting() {
            super(() -> new AssertionError("range < 0\u001b[2J"));
        }
    }

    /** A class is missing. */
    public static final class Unlinked extends WithSensor {
        private static final long serialVersionUID = 1L;

        public Unlinked() {
            super(() -> new NoClassDefFoundError("org/example/Missing"));
        }
    }

    /** Something is asked for that no memory can hold. */
    public static final class Greedy extends WithSensor {
        private static final long serialVersionUID = 1L;

        public Greedy() {
            super(() -> new OutOfMemoryError("Java heap space"));
        }
    }

    /** Calls itself without end while it is described. */
    public static final class Endless extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            build();
        }
    }

    /** Fails when it is made. */
    public static final class Stillborn extends Scene {
        private static final long serialVersionUID = 1L;

        public Stillborn() {
            throw new ExceptionInInitializerError("no table");
        }

        @Override
        protected void build() {}
    }

    /** Fails by a mistake in the program. */
    public static final class Mistaken extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            throw new UnsupportedOperationException("x".repeat(5000));
        }
    }

    /** A scene with a steered drone. */
    private abstract static class WithPilot extends Scene {
        private static final long serialVersionUID = 1L;

        @Override
        protected void build() {
            loadWorld(loadPackaged("house.obj"));
            add("drone", DroneSettings.of(loadPackaged("quadrotor.obj"), Steered.from(new Position(0, 30, 20))));
            add("camera", CameraSettings.at(new Position(0, 0, 20)).withRate(1.0));
            setRun(RunSettings.DEFAULT.withDuration(5.0));
        }
    }

    /** A scene whose pilot fails after three seconds and a bit. */
    public static final class FailingPilot extends WithPilot {
        private static final long serialVersionUID = 1L;

        @Override
        protected Pilot pilot() {
            return new Lost();
        }
    }

    private static final class Lost implements Pilot {
        @Override
        public void begin(PilotedRun run) {
            run.after(3.03, () -> {
                throw new IllegalStateException("lost its way");
            });
        }
    }

    /** A scene whose pilot asks where its drone will be. */
    public static final class WrongPilot extends WithPilot {
        private static final long serialVersionUID = 1L;

        @Override
        protected Pilot pilot() {
            return run -> {
                run.after(2.0, () -> run.drone("drone").state(9.0));
                run.after(25.0, () -> run.drone("drone").fly(new Position(0, 0, 1)));
            };
        }
    }
}
