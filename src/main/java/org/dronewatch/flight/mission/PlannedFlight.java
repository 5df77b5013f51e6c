package org.dronewatch.flight.mission;

import java.util.Locale;
import java.util.function.Consumer;
import org.dronewatch.flight.FlightPath;
import org.dronewatch.flight.file.DroneSpeeds;
import org.dronewatch.flight.file.FlightSource;
import org.dronewatch.setting.Counted;
import org.dronewatch.setting.input.FileHash;
import org.dronewatch.world.Places;

/** A mission as it was read. */
record PlannedFlight(Mission settings, PlanFile plan) implements FlightSource {
    @Override
    public FileHash hash() {
        return plan.hash();
    }

    @Override
    public String description() {
        return String.format(Locale.ROOT, "%s: a mission of %s", settings.plan(), Counted.of(plan.items(), "item"));
    }

    @Override
    public FlightPath path(Places places, DroneSpeeds drone, Consumer<String> warnings) {
        plan.warnings().forEach(line -> warnings.accept(settings.plan() + ": " + line));
        return new MissionRoute(settings, plan, places, drone, warnings).path();
    }
}
