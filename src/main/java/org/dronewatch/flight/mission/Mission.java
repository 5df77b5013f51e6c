package org.dronewatch.flight.mission;

import java.nio.file.Path;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.file.BoundedFile;

/**
 * A mission planned with QGroundControl: take-off, waypoints, changes of speed, landing. It stops wherever its path
 * bends, as with {@code waypoints}. The speeds are those of the plan; where it states none, the drone's speed applies.
 *
 * @param plan path of the {@code .plan} file
 * @param climbRate largest vertical speed upwards, 0.1 to 100 m/s; 3 m/s by default, as in PX4 (MPC_Z_VEL_MAX_UP)
 * @param descentRate largest vertical speed downwards, 0.1 to 100 m/s; 1.5 m/s by default, as in PX4 (MPC_Z_VEL_MAX_DN)
 */
public record Mission(
        @FileName String plan,
        @In(value = Quantity.SPEED, from = 0.1, to = 100) double climbRate,
        @In(value = Quantity.SPEED, from = 0.1, to = 100) double descentRate)
        implements FlightFromFile {
    /** The largest file that is read, bytes. */
    static final int LARGEST = 16 << 20;

    /** Checks the limits. */
    public Mission {
        Limits.check(Mission.class, plan, climbRate, descentRate);
        if (plan.isBlank()) {
            throw new IllegalArgumentException("plan is empty: it must name a .plan file");
        }
    }

    /** A mission flown with the vertical speeds of PX4. */
    @Defaults("plan")
    public static Mission of(String plan) {
        return new Mission(plan, 3.0, 1.5);
    }

    @Override
    public String file() {
        return plan;
    }

    @Override
    public String fileSetting() {
        return "plan";
    }

    @Override
    public FlightSource read(Path path, String shown) {
        return new PlannedFlight(this, PlanFile.read(shown, BoundedFile.read(path, LARGEST)));
    }
}
