package org.dronewatch.examples;

import java.util.List;
import org.dronewatch.drone.Drone;
import org.dronewatch.geometry.Position;
import org.dronewatch.sensor.Aim;
import org.dronewatch.sensor.Aimed;
import org.dronewatch.sensor.Look;
import org.dronewatch.sensor.Observation;
import org.dronewatch.sensor.Outline;
import org.dronewatch.sensor.Outlined;
import org.dronewatch.sensor.Reading;
import org.dronewatch.sensor.Sensor;
import org.dronewatch.sensor.SensorDescription;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.Defaults;
import org.dronewatch.setting.In;
import org.dronewatch.setting.Limits;
import org.dronewatch.setting.Quantity;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.world.World;

/**
 * A sentry who watches half of the horizon without binoculars, and notices a drone there, within line of sight, once it
 * appears large enough.
 *
 * @param position the sentry's eyes, m
 * @param aim the middle of the watched half of the horizon; its elevation has no effect
 * @param rate how often the sentry looks, Hz
 * @param acuity the smallest angular size at which the sentry notices something in the sky, rad
 */
public record SentrySettings(
        Position position,
        Aim aim,
        @In(value = Quantity.FREQUENCY, above = 0.0, to = 10.0) double rate,
        @In(value = Quantity.ANGLE, from = 0.0003, to = 0.1) double acuity)
        implements SensorSettings<Sensor>, Aimed, Outlined {

    /** Checks the limits above. */
    public SentrySettings {
        Limits.check(SentrySettings.class, position, aim, rate, acuity);
    }

    @Override
    public SentrySettings withAim(Aim other) {
        return SettingsForm.with(this, "aim", other);
    }

    /** Half of the horizon, from 45 degrees below to 45 degrees above, out to 2 km. */
    @Override
    public Outline outline() {
        Position ahead = aim.from(position);
        double azimuth = Math.atan2(ahead.x(), ahead.y());
        return new Outline.Sector(azimuth, 0.0, Math.PI, Math.PI / 2, 0.0, 2000.0);
    }

    private List<Observation> look(World world, List<Drone> drones, Look look) {
        Outline outline = outline();
        return drones.stream()
                .filter(drone -> outline.contains(drone.origin().minus(position)))
                .map(drone -> look(world, drone, look))
                .toList();
    }

    private Observation look(World world, Drone drone, Look look) {
        double distance = drone.distance(position);
        boolean visible = !world.isOccluded(position.toPoint3d(), drone.position());
        double size = visible ? 2.0 * Math.atan(drone.radius() / distance) : 0.0;
        return new Observation(look.id(kind()), drone.id(), distance, new Reading(size, acuity, "rad"));
    }

    /** Watches the north every two seconds, and notices what appears larger than four minutes of arc. */
    @Defaults("position")
    public static SentrySettings at(Position position) {
        return new SentrySettings(position, Aim.Direction.DEFAULT, 0.5, 0.0012);
    }

    @Override
    public String kind() {
        return "sentry";
    }

    @Override
    public SentrySettings withPosition(Position other) {
        return SettingsForm.with(this, "position", other);
    }

    @Override
    public SensorDescription description() {
        return SensorDescription.measuring("apparent size");
    }

    @Override
    public Sensor create() {
        return this::look;
    }
}
