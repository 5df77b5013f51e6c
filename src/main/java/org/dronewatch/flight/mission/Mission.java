package org.dronewatch.flight.mission;

import java.nio.file.Path;
import java.util.Optional;
import org.dronewatch.flight.file.FlightFromFile;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.FileName;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.input.BoundedFile;

/**
 * A mission planned with QGroundControl: take-off, waypoints, changes of speed, landing. The drone stops wherever its
 * path bends, as with {@code waypoints}. The speeds are those of the plan; where the plan states none, the drone's
 * speed applies. The drone climbs and descends as its {@code performance} allows, unless {@code climbRate} and
 * {@code descentRate} are given.
 *
 * @param plan path of the {@code .plan} file
 * @param climbRate maximum rate of climb, 0.1 to 100 m/s; the drone's {@code performance.climb} unless set
 * @param descentRate maximum rate of descent, 0.1 to 100 m/s; the drone's {@code performance.sink} unless set
 */
public record Mission(
        @FileName String plan,
        @In(value = Quantity.SPEED, from = 0.1, to = 100) Optional<Double> climbRate,
        @In(value = Quantity.SPEED, from = 0.1, to = 100) Optional<Double> descentRate)
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

    /** A mission flown with the vertical speeds of the drone. */
    @Defaults("plan")
    public static Mission of(String plan) {
        return new Mission(plan, Optional.empty(), Optional.empty());
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
