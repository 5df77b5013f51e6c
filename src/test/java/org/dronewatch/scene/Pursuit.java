package org.dronewatch.scene;

import nl.tudelft.simulation.dsol.simulators.DevsSimulatorInterface;
import org.dronewatch.drone.DroneSettings;
import org.dronewatch.flight.Attitude;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.flight.FlightPathSettings.Orbit;
import org.dronewatch.flight.FlightState;
import org.dronewatch.flight.Steered;
import org.dronewatch.geometry.Position;
import org.dronewatch.scenario.RunSettings;
import org.dronewatch.sensor.acoustic.AcousticSettings;
import org.dronewatch.sensor.acoustic.energy.EnergyModel;
import org.dronewatch.sensor.camera.CameraSettings;
import org.dronewatch.sensor.radar.LinkBudget;
import org.dronewatch.sensor.radar.RadarSettings;

/** One drone pursues another, which circles: every tenth of a second it steers at where the other is. */
class Pursuit extends Scene {
    private static final long serialVersionUID = 1L;

    static final double DURATION = 6.0;
    static final double SPEED = 25.0;
    static final Position START = new Position(-120, 60, 170);
    static final Position EAR = new Position(40, 0, 150);

    private final transient FlightPathSettings hunter;

    Pursuit(FlightPathSettings hunter) {
        this.hunter = hunter;
    }

    /** Steered. */
    Pursuit() {
        this(Steered.from(START));
    }

    Pursuit(DevsSimulatorInterface<Double> simulator) {
        super(simulator);
        this.hunter = Steered.from(START);
    }

    @Override
    protected void build() {
        loadWorld(loadPackaged("hill.obj"));
        setBackgroundNoise(5.0);
        add(
                "prey",
                DroneSettings.of(loadPackaged("quadrotor.obj"), Orbit.about(new Position(0, 0, 175), 40))
                        .withSpeed(15));
        add("hunter", DroneSettings.of(loadPackaged("quadrotor.obj"), hunter).withSpeed(SPEED));
        add(
                "camera",
                CameraSettings.at(new Position(-40, -40, 160))
                        .withLookAt(new Position(-60, 40, 172))
                        .withRate(7.0));
        add("ear", AcousticSettings.at(EAR).withRate(2.0).withPropagation(EnergyModel.DEFAULT.withRays(100)));
        add(
                "far-ear",
                AcousticSettings.at(new Position(-300, 200, 160))
                        .withRate(1.5)
                        .withPropagation(EnergyModel.DEFAULT.withRays(100)));
        add("radar", RadarSettings.at(new Position(100, 100, 165), new LinkBudget.Hardware(4, 33, 0.02, 10e6, 0, 0)));
        setRun(RunSettings.DEFAULT.withDuration(DURATION));
    }

    @Override
    protected Pilot pilot() {
        return new Hunter();
    }

    /** Steers; a new one for each run. */
    static final class Hunter implements Pilot {
        private PilotedRun run;

        @Override
        public void begin(PilotedRun piloted) {
            run = piloted;
            steer();
        }

        private void steer() {
            DroneInFlight own = run.drone("hunter");
            Position way =
                    run.drone("prey").state().position().minus(own.state().position());
            Position velocity = way.unit().times(SPEED);
            if (run.settings().drones().get("hunter").lean()) {
                own.fly(velocity);
            } else {
                own.fly(velocity, attitude(way, own.state()));
            }
            run.after(0.1, this::steer);
        }

        /** Its nose where it is going, rolled as it turns. */
        private static Attitude attitude(Position way, FlightState state) {
            double yaw = Math.atan2(way.x(), way.y());
            return new Attitude(yaw, Math.asin(way.unit().z()), 3.0 * Math.sin(yaw - state.heading()));
        }
    }
}
